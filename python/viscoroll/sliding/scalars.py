"""Scalar results of sliding, as described by the table of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import _core
from .._support.scalars import scalar_fields

__all__ = ["SLIDING_SCALARS", "SlidingScalars"]

#: Unit and label of each scalar result, by name.
SLIDING_SCALARS = {scalar.name: (scalar.unit, scalar.label) for scalar in _core.sliding_scalars()}

if TYPE_CHECKING:
    from .._core import SlidingScalars
else:
    #: Dataclass with one field per scalar result.
    SlidingScalars = scalar_fields("SlidingScalars", {scalar.name: scalar.type for scalar in _core.sliding_scalars()})
