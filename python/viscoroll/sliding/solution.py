"""Solution of steady sliding: its scalars, and its fields at the nodes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._core import Status
from .._support.plotting import plots
from .._support.scalars import with_scalars
from .._support.tables import html_table, number_text, unit_text
from ..bodies import CoatedPlane
from .rough_surface import RoughSurface
from .scalars import SLIDING_RESULTS, SLIDING_SCALARS, SlidingScalars

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

__all__ = ["Persson", "SlidingSolution", "rms_slope_at"]


def rms_slope_at(surface: RoughSurface, nodes: NDArray[np.bool_]) -> float:
    """Return the root mean square of the slope of a surface at some nodes, at least one [-]."""
    slopes: Sequence[NDArray[np.float64]]
    if surface.periodic:
        slopes = surface.slopes()
    else:
        axes = [axis for axis, count in enumerate(surface.heights.shape) if count > 1]
        slopes = [np.gradient(surface.heights, surface.spacing[axis], axis=axis) for axis in axes]
    return float(np.sqrt(sum(np.square(slope[nodes]).mean() for slope in slopes)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Persson:
    """Estimate by Persson's theory, for comparison with a solution.

    Attributes
    ----------
    friction_coefficient : float
        Friction coefficient due to losses in the layers [-].
    contact_share : float
        Real contact area per nominal area [-].
    """

    friction_coefficient: float
    contact_share: float


@with_scalars(_core.sliding_scalars())
@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class SlidingSolution(SlidingScalars):
    """Steady contact of a rigid rough surface that slides on viscoelastic layers.

    Arrays have the shape of `RoughSurface.heights`.

    Attributes
    ----------
    surface : RoughSurface
        Rough surface.
    on : CoatedPlane
        Plane on which it slides.
    mean_pressure : float
        Mean pressure [Pa].
    speed : float
        Sliding speed [m/s].
    friction : float
        Coulomb's coefficient of friction at the interface [-].
    %(scalars)s
    pressure : ndarray
        Pressure at every node [Pa], 0 outside the contact.
    gap : ndarray
        Distance of the surfaces at every node [m].
    converged : bool
        Whether all contact conditions are satisfied.
    persson : Persson
        Estimate by Persson's theory with the parameter γ = 1/2; NaN if the surface is not periodic.
    warnings : dict
        Texts of the warnings, by kind.
    """

    surface: RoughSurface
    on: CoatedPlane
    mean_pressure: float
    speed: float
    friction: float
    pressure: NDArray[np.float64]
    gap: NDArray[np.float64]
    converged: bool
    persson: Persson
    warnings: Mapping[str, str]

    @property
    def contact(self) -> NDArray[np.bool_]:
        """Whether each node is in contact."""
        touching: NDArray[np.bool_] = self.pressure > 0.0
        return touching

    @property
    def contact_slope(self) -> float:
        """Root mean square of the slope of the surface at the nodes in contact [-].

        The rubber follows the surface there, so that this is about the amplitude of its shear strain.
        """
        return rms_slope_at(self.surface, self.contact)

    @property
    def units(self) -> dict[str, str]:
        """Unit of every number of `scalars`; "1" for pure numbers."""
        return {"speed": "m/s"} | {name: unit for name, (unit, _) in SLIDING_RESULTS.items()}

    def scalars(self) -> dict[str, float | int | str]:
        """Return speed, pressure, scalar results, Persson's estimates by name, in SI units, and status and warnings."""
        own: dict[str, float | int | str] = {name: getattr(self, name) for name in SLIDING_SCALARS}
        return {
            "speed": self.speed,
            "mean_pressure": self.mean_pressure,
            **own,
            "persson_friction": self.persson.friction_coefficient,
            "persson_contact_share": self.persson.contact_share,
            "status": (Status.CONVERGED if self.converged else Status.MAX_ITERATIONS).name,
            "warnings": ", ".join(kind.upper() for kind in self.warnings),
        }

    def __repr__(self) -> str:
        """Return a summary that fits on one screen."""
        rows = self._rows()
        width = max(len(label) for label, _ in rows)
        return "\n".join([self._title(), *(f"  {label:<{width}}  {value}" for label, value in rows)])

    def _repr_html_(self) -> str:
        """Return the summary as a table for notebooks."""
        return html_table(self._title(), self._rows())

    @plots("the pressure")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the pressure: a map in colors, or that of a profile as a line."""
        from .picture import draw_field

        outside = 0.0 if self.surface.is_profile else np.nan
        pressure = np.where(self.contact, self.pressure * 1e-6, outside)
        return draw_field(pressure, self.surface.sides, "pressure [MPa]", colors="magma_r", ax=ax)

    def _title(self) -> str:
        return f"Sliding at {self.speed:g} m/s under a mean pressure of {self.mean_pressure:g} Pa"

    def _rows(self) -> list[tuple[str, str]]:
        scalars = [
            (label.partition(",")[0], f"{number_text(getattr(self, name))} {unit_text(unit)}".rstrip())
            for name, (unit, label) in SLIDING_SCALARS.items()
        ]
        persson = self.persson
        return [
            *scalars,
            ("Persson's estimates: friction coefficient", f"{persson.friction_coefficient:.6g}"),
            ("Persson's estimates: contact share", f"{persson.contact_share:.6g}"),
            *(("warning", message) for message in self.warnings.values()),
        ]
