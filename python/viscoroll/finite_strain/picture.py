"""Picture of a rolling roller at finite strain."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np

from .._support.pictures import Picture, draw_picture
from .._support.quantities import quantity_text

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

    from .._support.arguments import Floats
    from ..bodies import CoatedCylinder
    from .laws import Law

__all__ = ["plot_rolling"]

_MM, _MPA = 1e3, 1e-6


class _Drawn(Protocol):
    """Results that the picture contains, same as in `FiniteStrainResult`."""

    @property
    def load(self) -> float:
        """Load [N/m]."""

    @property
    def driving_torque(self) -> float:
        """Torque [N m/m]."""

    @property
    def strain(self) -> float:
        """Strain [-]."""

    @property
    def overspeed(self) -> float:
        """Overspeed [-]."""

    @property
    def law(self) -> Law:
        """Law of the viscous stress."""

    @property
    def roller(self) -> CoatedCylinder:
        """Roller."""

    @property
    def penetration(self) -> float:
        """Penetration [m]."""

    @property
    def position(self) -> Floats:
        """Positions of the nodes in contact [m]."""

    @property
    def pressure(self) -> Floats:
        """Pressures there [Pa]."""

    def fields(self) -> xarray.Dataset:
        """Return the fields."""


def plot_rolling(result: _Drawn, ax: Axes | None = None) -> Picture | Axes:
    """Draw the deformed cover with its viscous power beside the contact pressure, or the pressure into `ax`."""

    def compose(picture: Picture) -> None:
        cover, pressure = picture.subplots(1, 2, width_ratios=[1.2, 1.0])
        _draw_cover(cover, picture, result)
        _draw_pressure(pressure, result)
        picture.suptitle(
            f"P = {quantity_text(result.load, 'N/m')},  T = {quantity_text(result.driving_torque, 'N m/m')},  "
            f"strain {result.strain:.3g},  overspeed {result.overspeed:.3g},  law {result.law.value}",
            fontsize="medium",
        )

    return draw_picture(lambda axes: _draw_pressure(axes, result), ax, figsize=(11.0, 4.6), compose=compose)


def _draw_pressure(axes: Axes, result: _Drawn) -> None:
    # In pictures, the roller rolls to the right: the surface moves to the left.
    axes.plot(-result.position * _MM, result.pressure * _MPA, color="tab:blue", marker=".", markersize=3)
    axes.axvline(0.0, color="0.6", linewidth=0.8)
    axes.set(xlabel="x [mm], rolling to the right", ylabel="contact pressure [MPa]", ylim=(0.0, None))


def _draw_cover(axes: Axes, picture: Picture, result: _Drawn) -> None:
    fields = result.fields()
    x, y = -fields["x"].to_numpy() * _MM, fields["y"].to_numpy() * _MM
    power = fields["viscous_power"].to_numpy() * 1e-6
    limit = float(np.abs(power).max()) or 1.0
    image = axes.pcolormesh(x, y, power, shading="gouraud", cmap="RdBu_r", vmin=-limit, vmax=limit)
    picture.colorbar(image, ax=axes, label="power of the viscous stress [MW/m³]")
    half = max(1.6 * float(np.abs(result.position).max()) * _MM, 1.2 * result.roller.thickness * _MM)
    bottom = -(result.roller.outer_radius - result.penetration) * _MM
    axes.set(
        xlim=(-half, half),
        ylim=(bottom - 0.15 * half, bottom + 1.3 * result.roller.thickness * _MM),
        aspect="equal",
        xlabel="x [mm], rolling to the right",
        ylabel="height above the axis [mm]",
    )
