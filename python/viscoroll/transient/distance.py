"""Conversion of motions given by the distance rolled along the track to the angle turned."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float, as_float_array
from .._support.errors import InvalidInput

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..bodies import RollingBody

__all__ = ["as_angle", "as_angles"]


def as_angle(body: RollingBody, angle: float | None, distance: float | None) -> float:
    """Return the angle turned [rad], given either the angle or the distance rolled along the track [m]."""
    _require_one(angle, distance)
    return as_float("angle", angle) if distance is None else as_float("distance", distance) / body.outer_radius


def as_angles(body: RollingBody, angle: ArrayLike | None, distance: ArrayLike | None) -> NDArray[np.float64]:
    """Return the angles turned [rad], given either the angles or the distances rolled along the track [m]."""
    _require_one(angle, distance)
    if distance is None:
        assert angle is not None
        return as_float_array("angle", angle)
    distances = as_float_array("distance", distance)
    if not np.isfinite(distances).all():
        raise InvalidInput("distance", "must be finite", f"{distances[~np.isfinite(distances)].flat[0]:g}")
    return distances / body.outer_radius


def _require_one(angle: object, distance: object) -> None:
    if (angle is None) == (distance is None):
        raise ValueError(f"exactly one of angle and distance must be given, got {'none' if angle is None else 'both'}")
