"""Which balls of a result or study discrete-element codes know: one on a plane, or two on each other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..bodies import CoatedPlane, CoatedSphere, Counterpart, RollingBody
from ..studies.rolling_resistance import radius_of

if TYPE_CHECKING:
    import xarray

__all__ = ["Balls", "balls_of", "balls_of_study"]

_WANTED = "source must be of a ball on a plane or on another ball"


@dataclass(frozen=True, slots=True, kw_only=True)
class Balls:
    """A ball on a plane, or two on each other.

    Attributes
    ----------
    radii : tuple of float
        r_o of the ball, or of both, undeformed [m].
    alike : bool
        Whether both are the same.
    """

    radii: tuple[float, ...]
    alike: bool = False

    @property
    def are_two(self) -> bool:
        """Whether they roll on each other."""
        return len(self.radii) == 2

    @property
    def radius(self) -> float:
        """R of 1/R = Σ 1/r_o [m]."""
        first, *rest = self.radii
        return first * rest[0] / (first + rest[0]) if rest else first


def balls_of(ball: RollingBody, on: Counterpart | None) -> Balls:
    """Return the balls of what rolls and what it rolls on.

    Raises
    ------
    ValueError
        For rollers, and balls on something else.
    """
    if not isinstance(ball, CoatedSphere):
        raise ValueError(f"{_WANTED}, got a {type(ball).__name__}")
    if on is None or isinstance(on, CoatedPlane):
        return Balls(radii=(ball.outer_radius,))
    if isinstance(on, CoatedSphere):
        return Balls(radii=(ball.outer_radius, on.outer_radius), alike=ball == on)
    raise ValueError(f"{_WANTED}, got one on a {type(on).__name__}")


def balls_of_study(study: xarray.Dataset) -> Balls:
    """Return the balls of a study over load, speed, or both.

    Raises
    ------
    ValueError
        For rollers, balls on something else or on several things, several balls, and other dimensions.
    """
    *_, kind = str(study.attrs.get("title", "sphere")).split()
    if kind != "sphere":
        raise ValueError(f"{_WANTED}, got a study of a coated {kind}")
    power = study["dissipated_power"]
    if more := [str(d) for d in power.dims if d not in ("load", "angular_speed") and power.sizes[d] > 1]:
        raise ValueError(
            f"study must vary load and angular_speed alone, got {', '.join(more)} too: choose, as in "
            f"study.isel({more[0]}=0)"
        )
    if "on" in study.coords:
        raise ValueError(f"{_WANTED}, the same at all points, got a study that varies on")
    radius = radius_of(study)
    kind = study.attrs.get("on", "None").partition("(")[0]
    if kind in ("None", "CoatedPlane"):
        return Balls(radii=(radius,))
    if kind == "CoatedSphere" and "other_radius" in study.attrs:
        attributes = study.attrs
        return Balls(
            radii=(radius, float(attributes["other_radius"])), alike=attributes["ball"] == attributes["other_ball"]
        )
    raise ValueError(f"{_WANTED}, got one on a {kind}")
