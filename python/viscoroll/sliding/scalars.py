"""Scalar results of sliding, as described by the table of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import _core
from .._support.scalars import scalar_fields

__all__ = ["SLIDING_RESULTS", "SLIDING_SCALARS", "SlidingScalars"]

#: Unit and label of each scalar result, by name.
SLIDING_SCALARS = {scalar.name: (scalar.unit, scalar.label) for scalar in _core.sliding_scalars()}

#: The same with the mean pressure and Persson's estimates.
SLIDING_RESULTS = (
    {"mean_pressure": ("Pa", "mean pressure")}
    | SLIDING_SCALARS
    | {
        "persson_friction": ("1", "friction coefficient by Persson's estimate"),
        "persson_contact_share": ("1", "real contact area per nominal area by Persson's estimate"),
    }
)

if TYPE_CHECKING:
    from .._core import SlidingScalars
else:
    #: Dataclass with one field per scalar result.
    SlidingScalars = scalar_fields("SlidingScalars", {scalar.name: scalar.type for scalar in _core.sliding_scalars()})
