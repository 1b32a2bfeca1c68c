"""Motions by the angle turned, or by the way along the track."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float, as_float_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..bodies import RollingBody

__all__ = ["as_angle", "as_angles"]


def as_angle(ball: RollingBody, angle: float | None, way: float | None) -> float:
    """Return the angle turned [rad], whichever of the two is given."""
    _require_one(angle, way)
    return as_float("angle", angle) if way is None else as_float("way", way) / ball.outer_radius


def as_angles(ball: RollingBody, angle: ArrayLike | None, way: ArrayLike | None) -> NDArray[np.float64]:
    """Return the angles turned [rad], likewise."""
    _require_one(angle, way)
    if way is None:
        assert angle is not None
        return as_float_array("angle", angle)
    ways = as_float_array("way", way)
    if not np.isfinite(ways).all():
        raise ValueError("way must be finite")
    return ways / ball.outer_radius


def _require_one(angle: object, way: object) -> None:
    if (angle is None) == (way is None):
        raise ValueError(f"one of angle and way must be given, got {'none' if angle is None else 'both'}")
