"""Conversion of motions given by the displacement along the track to the angle turned."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float, as_float_array

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..bodies import RollingBody

__all__ = ["as_angle", "as_angles"]


def as_angle(ball: RollingBody, angle: float | None, way: float | None) -> float:
    """Return the angle turned [rad], given either the angle or the displacement along the track [m]."""
    _require_one(angle, way)
    return as_float("angle", angle) if way is None else as_float("way", way) / ball.outer_radius


def as_angles(ball: RollingBody, angle: ArrayLike | None, way: ArrayLike | None) -> NDArray[np.float64]:
    """Return the angles turned [rad], given either the angles or the displacements along the track [m]."""
    _require_one(angle, way)
    if way is None:
        assert angle is not None
        return as_float_array("angle", angle)
    ways = as_float_array("way", way)
    if not np.isfinite(ways).all():
        raise ValueError(f"way must be finite, got {ways[~np.isfinite(ways)].flat[0]:g}")
    return ways / ball.outer_radius


def _require_one(angle: object, way: object) -> None:
    if (angle is None) == (way is None):
        raise ValueError(f"exactly one of angle and way must be given, got {'none' if angle is None else 'both'}")
