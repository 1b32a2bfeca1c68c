"""Result of steady sliding: a solution, with the methods that evaluate it."""

from __future__ import annotations

from dataclasses import dataclass

from . import interior as interior_fields
from . import loss as losses
from . import temperature as temperatures
from .solution import SlidingSolution

__all__ = ["SlidingResult"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class SlidingResult(SlidingSolution):  # noqa: D101  (described as the solution that it is)
    __doc__ = SlidingSolution.__doc__

    interior = interior_fields.interior
    bonds = interior_fields.bonds
    loss = losses.loss
    temperature = temperatures.temperature
