"""Radii of the balls of a result or study: a ball on a plane, or two balls in contact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from .._support.errors import InvalidInput
from ..bodies import Counterbody, RollingBody
from ..studies.rolling_resistance import radius_of

if TYPE_CHECKING:
    import xarray

__all__ = ["Balls", "balls_of", "balls_of_study"]

_RULE = "source must be for a ball on a plane or on another ball"


@dataclass(frozen=True, slots=True, kw_only=True)
class Balls:
    """Radii of a ball on a plane, or of two balls in contact.

    Attributes
    ----------
    radii : tuple of float
        Undeformed outer radius r_o of the ball, or of both balls [m].
    alike : bool
        Whether both balls are identical.
    """

    radii: tuple[float, ...]
    alike: bool = False

    @property
    def are_two(self) -> bool:
        """Whether two balls roll on each other."""
        return len(self.radii) == 2

    @property
    def radius(self) -> float:
        """Effective radius R, with 1/R = Σ 1/r_o [m]."""
        first, *rest = self.radii
        return first * rest[0] / (first + rest[0]) if rest else first


def balls_of(ball: RollingBody, on: Counterbody | None) -> Balls:
    """Return the radii of a rolling body and its counterbody.

    Raises
    ------
    ValueError
        If the body is not a ball, or the counterbody is neither a plane nor a ball.
    """
    if ball.curved_directions == 2:
        if on is None or on.curvatures == (0.0, 0.0):
            return Balls(radii=(ball.outer_radius,))
        if on.curved_directions == 2:
            return Balls(radii=(ball.outer_radius, on.surface), alike=ball == on)
    raise ValueError(f"{_RULE}, got a {ball.noun} on a {'plane' if on is None else on.noun}")


def balls_of_study(study: xarray.Dataset) -> Balls:
    """Return the radii of the balls of a study over load, angular speed, or both.

    Raises
    ------
    ValueError
        If the study is not of one ball on one plane or ball, or varies anything but load and angular speed.
    """
    *_, kind = str(study.attrs.get("title", "sphere")).split()
    if kind != "sphere":
        raise ValueError(f"{_RULE}, got a study of a coated {kind}")
    power = study["dissipated_power"]
    if more := [str(d) for d in power.dims if d not in ("load", "angular_speed") and power.sizes[d] > 1]:
        raise InvalidInput(
            "study",
            "must vary only load and angular_speed",
            f"also {', '.join(more)}: select one value, as in study.isel({more[0]}=0)",
        )
    if "on" in study.coords:
        raise ValueError(f"{_RULE}, the same at all points, got a study that varies on=")
    radius = radius_of(study)
    kind = study.attrs.get("on", "None").partition("(")[0]
    if kind in ("None", "CoatedPlane"):
        return Balls(radii=(radius,))
    if kind == "CoatedSphere" and "other_radius" in study.attrs:
        attributes = study.attrs
        return Balls(
            radii=(radius, float(attributes["other_radius"])), alike=attributes["body"] == attributes["other_ball"]
        )
    raise ValueError(f"{_RULE}, got a ball on a {kind}")
