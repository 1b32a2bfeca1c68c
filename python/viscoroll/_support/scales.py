"""Units of the axes of pictures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .units import suitable_unit

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["Scale"]


@dataclass(frozen=True, slots=True)
class Scale:
    """Unit in which an axis displays values, and the SI value of this unit."""

    factor: float
    unit: str

    @classmethod
    def of(cls, values: ArrayLike, unit: str) -> Scale:
        """Return the scale that suits the largest absolute value, given the SI unit."""
        numbers = np.abs(np.asarray(values, dtype=float))
        name, factor = suitable_unit(float(np.max(numbers, initial=0.0, where=np.isfinite(numbers))), unit)
        return cls(factor, name)

    def text(self, name: str) -> str:
        """Return the label of an axis: a name with the unit."""
        return f"{name} [{self.unit}]" if self.unit else name
