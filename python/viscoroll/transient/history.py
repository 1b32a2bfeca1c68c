"""Results of transient rolling."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._core import Compliance, Curvature, Start
from .._support.arguments import as_count, as_positive
from .._support.extras import extra
from .._support.files import ending_in, save, write_csv, write_netcdf
from .._support.plotting import plots
from .._support.quantities import quantity_text, quantity_texts
from .._support.scalars import with_scalars
from .._support.tables import html_table, number_text, unit_text
from .._support.units import unit_in_contact
from ..bodies import Counterbody, Drive, Mesh, RollingBody
from ..ground import Axle, Profile
from .rolling_history import RollingState
from .series import HISTORY_SCALARS, SeriesFields, series_units

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

__all__ = ["ANIMATIONS", "FORMATS", "ContactInstant", "History"]

#: Suffixes of animations.
ANIMATIONS = (".gif", ".mp4")


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ContactInstant:
    """Pressure around the contact on one of the phase-shifted meshes; arrays of shape (nodes in φ, nodes in θ).

    Attributes
    ----------
    time : float
        Time of the record [s].
    x, z : ndarray
        Coordinates of the undeformed nodes [m]: x forward, z sideways.
    pressure : ndarray
        Contact pressure, positive [Pa].
    """

    time: float
    x: NDArray[np.float64]
    z: NDArray[np.float64]
    pressure: NDArray[np.float64]

    @classmethod
    def _from_core(cls, field: _core.ContactField) -> ContactInstant:
        return cls(time=field.time, x=field.x, z=field.z, pressure=field.pressure)


@with_scalars(_core.history_scalars(), kind="ndarray")
@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class History(SeriesFields):
    """Time series of transient rolling at every step, averaged over the phase-shifted meshes.

    Attributes
    ----------
    body, on, mesh, compliance, curvature, friction, drive, mass, ground, tread, axle, averaged_meshes
        Input, with the mesh that was used. For a roller, forces, torques and energies are per length.
    start : Start or None
        Initial state; None if the history continued from a saved state.
    spectrum_error : float
        Largest relative error of the compliance due to discrete retardation times [-].
    %(scalars)s
    contacts : tuple of ContactInstant
        Pressure at the requested instants.
    state : RollingState
        State at the end, from which another history can continue.
    """

    body: RollingBody
    on: Counterbody | None
    mesh: Mesh
    start: Start | None
    compliance: Compliance
    curvature: Curvature
    friction: float
    drive: Drive
    mass: float
    ground: Profile | None
    tread: Profile | None
    axle: Axle | None
    averaged_meshes: int
    spectrum_error: float
    contacts: tuple[ContactInstant, ...]
    state: RollingState

    def __post_init__(self) -> None:
        """Make the arrays read-only."""
        for values in self._series().values():
            values.flags.writeable = False

    def _series(self) -> dict[str, NDArray[np.float64]]:
        """Return the time series by name."""
        return {name: getattr(self, name) for name in HISTORY_SCALARS}

    @property
    def distance(self) -> NDArray[np.float64]:
        """Distance rolled along the track, r_o ψ [m]: the displacement of the contact without slip."""
        return self.body.outer_radius * self.angle

    @property
    def ground_height(self) -> NDArray[np.float64]:
        """Height of the ground below the axle [m]; 0 if the ground is smooth."""
        return np.zeros_like(self.angle) if self.ground is None else self.ground.height_at(self.distance)

    @property
    def units(self) -> dict[str, str]:
        """Unit of every time series."""
        return series_units(line_contact=self.body.line_contact)

    @property
    def energy_balance_error(self) -> NDArray[np.float64]:
        """Energy imbalance divided by the energy that the whole history dissipates [-]; 0 without dissipation."""
        dissipated = float(self.dissipated_energy[-1] - self.dissipated_energy[0])
        imbalance = self.energy_balance_residual - self.energy_balance_residual[0]
        return np.abs(imbalance) / dissipated if dissipated > 0.0 else np.zeros_like(imbalance)

    @property
    def creepage(self) -> NDArray[np.float64]:
        """Displacement of the center over the last step divided by r_o Δψ, minus 1 [-]; nan at rest or frictionless."""
        turn = np.diff(self.angle, prepend=np.nan)
        displacement = np.diff(self.center_displacement, prepend=np.nan)
        rolls = np.abs(turn) > 0.0 if self.friction > 0.0 else np.zeros_like(turn, dtype=bool)
        return np.divide(displacement, self.body.outer_radius * turn, out=np.full_like(turn, np.nan), where=rolls) - 1.0

    def __repr__(self) -> str:
        """Return a summary that fits on one screen."""
        torque = self.resisting_torque
        highest, lowest = int(np.argmax(torque)), int(np.argmin(torque))
        unit = self.units
        torques, torque_unit = quantity_texts([torque[highest], torque[lowest]], unit["resisting_torque"], [None, None])
        dissipated = self.dissipated_energy[-1] - self.dissipated_energy[0]
        rows = [
            ("time", f"{self.time[0]:g} to {self.time[-1]:g} s in {len(self.time) - 1} steps"),
            ("angle", f"{self.angle.min():.4g} to {self.angle.max():.4g} rad, last {self.angle[-1]:.4g}"),
            ("load", self._range_text("load")),
            ("largest torque T_r", f"{torques[0]} {torque_unit} at {self.time[highest]:.4g} s"),
            ("smallest torque T_r", f"{torques[1]} {torque_unit} at {self.time[lowest]:.4g} s"),
            ("penetration", self._range_text("penetration")),
            (
                "energy dissipated, part of slip",
                f"{quantity_text(dissipated, unit['work'])}, {quantity_text(self.slip_energy[-1], unit['work'])}",
            ),
            ("error of the energy balance", f"{self.energy_balance_error[-1]:.1e}"),
            ("mesh", str(self.mesh)),
            ("shifted meshes averaged", str(self.averaged_meshes)),
        ]
        width = max(len(label) for label, _ in rows)
        start = "a saved state" if self.start is None else f"{self.start.name} start"
        return "\n".join([f"History from {start}", *(f"  {label:<{width}}  {value}" for label, value in rows)])

    def _range_text(self, name: str) -> str:
        """Return the smallest and the largest value of a time series; "undetermined" if it is."""
        values = getattr(self, name)
        if np.isnan(values).any():
            return "undetermined"
        texts, unit = quantity_texts([float(values.min()), float(values.max())], self.units[name], [None, None])
        return f"{' to '.join(texts)} {unit}"

    def _repr_html_(self) -> str:
        """Return the range of every time series with units, as a table for notebooks."""
        series = [(text, getattr(self, name), self.units[name]) for name, (_, text) in HISTORY_SCALARS.items()]
        rows = [
            (label, *(number_text(float(value)) for value in (values.min(), values.max(), values[-1])), unit_text(unit))
            for label, values, unit in series
            if not np.isnan(values).any()
        ]
        head = ("", "smallest", "largest", "last", "unit")
        return html_table(repr(self).partition("\n")[0], rows, head=head)

    def scalars(self) -> dict[str, float | int | str | None]:
        """Return the scalars that summarize the history, by name, in SI units."""
        highest = int(np.argmax(self.resisting_torque))
        return {
            "duration": float(self.time[-1] - self.time[0]),
            "steps": len(self.time) - 1,
            "largest_resisting_torque": float(self.resisting_torque[highest]),
            "time_of_largest_resisting_torque": float(self.time[highest]),
            "smallest_resisting_torque": float(self.resisting_torque.min()),
            "largest_resisting_force": float(self.resisting_force.max()),
            "smallest_resisting_force": float(self.resisting_force.min()),
            "largest_load": float(self.load.max()),
            "smallest_load": float(self.load.min()),
            "largest_pressure": float(self.max_pressure.max()),
            "largest_penetration": float(self.penetration.max()),
            "smallest_penetration": float(self.penetration.min()),
            "dissipated_energy": float(self.dissipated_energy[-1] - self.dissipated_energy[0]),
            "energy_balance_error": float(self.energy_balance_error[-1]),
            "slip_energy": float(self.slip_energy[-1] - self.slip_energy[0]),
            "friction": self.friction,
            "mass": self.mass,
            "spectrum_error": self.spectrum_error,
            "nodes_per_revolution": self.mesh.nodes_per_revolution,
            "averaged_meshes": self.averaged_meshes,
            "start": "STATE" if self.start is None else self.start.name,
            "compliance": self.compliance.name,
            "curvature": self.curvature.name,
        }

    def scalar_units(self) -> dict[str, str]:
        """Return the units of the numbers in `scalars`, by name."""
        units = self.units | {"pressure": "Pa", "duration": "s", "time_of_largest_resisting_torque": "s"}
        units["mass"] = unit_in_contact("kg", line_contact=self.body.line_contact)
        stems = {name: name.removeprefix("largest_").removeprefix("smallest_") for name in self.scalars()}
        numbers = [name for name, value in self.scalars().items() if isinstance(value, int | float)]
        return {name: units.get(stems[name], "1") for name in numbers}

    def to_xarray(self) -> xarray.Dataset:
        """Return the time series as a dataset over `time` [s], with units.

        Raises
        ------
        ImportError
            If the extra `viscoroll[files]` is missing.
        """
        with extra("files"):
            import xarray

        variables = {
            name: ("time", getattr(self, name), {"units": self.units[name], "long_name": text})
            for name, (_, text) in HISTORY_SCALARS.items()
        }
        return xarray.Dataset(variables, attrs=self.scalars())

    def save(self, path: str | Path) -> None:
        """Write the time series to a file, in the format of its suffix.

        Parameters
        ----------
        path : path-like
            ``.csv`` (a row for each instant) or ``.nc`` (netCDF).

        Raises
        ------
        ValueError
            If the suffix is another one.
        ImportError
            If the extra `viscoroll[files]` is missing, for ``.nc``.
        """
        save(self, path, FORMATS)

    @plots("only ground and path of the axle")
    def plot_ground(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw ground and path of the axle, load, push force and contact length over the distance."""
        from .picture import plot_ground

        return plot_ground(self._series(), self.units, self.distance, self.ground_height, ax)

    def animate(self, path: str | Path, *, seconds: float = 6.0, frames_per_second: int = 20) -> None:
        """Write an animation of the body on its ground, with load and push force, to a file.

        Parameters
        ----------
        path : path-like
            ``.gif``, or ``.mp4``, which needs the program ffmpeg.
        seconds : float, default 6
            Duration of the animation [s], positive; the motion is played slower or faster.
        frames_per_second : int, default 20
            Number of pictures per second, at least 1. Formats round it: GIF to hundredths of a second per picture.

        Raises
        ------
        ValueError
            If the suffix is another one, ffmpeg is missing for ``.mp4``, or a number is out of range.
        ImportError
            If the extra `viscoroll[plot]` is missing.
        """
        from .animation import Animated, write_animation

        frames = max(
            2, round(as_positive("seconds", seconds, "s") * as_count("frames_per_second", frames_per_second, 1))
        )
        shown = Animated(
            body=self.body,
            ground=self.ground,
            tread=self.tread,
            distance=self.distance,
            series=self._series(),
            units=self.units,
        )
        write_animation(shown, ending_in(ANIMATIONS, path), frames=frames, frames_per_second=frames_per_second)

    @plots("only the torque over time")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw torque, penetration and energies over time, and the loop of torque over angle with its energy."""
        from .picture import plot_history

        return plot_history(self._series(), self.units, ax)


def _write_table(history: History, path: Path) -> None:
    units = history.units
    write_csv({f"{name} [{units[name]}]": values.tolist() for name, values in history._series().items()}, path)


#: Functions that write the time series of a history, by suffix; see `History.save`.
FORMATS = {
    ".csv": _write_table,
    ".nc": lambda history, path: write_netcdf(history.to_xarray(), path),
}
