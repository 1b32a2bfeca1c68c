"""Table of measured moduli for the solver."""

from __future__ import annotations

import numpy as np

from .._core import Extrapolation
from .._support.arguments import Floats
from ..materials import MasterCurve

__all__ = ["ENTRIES_PER_DECADE", "tabulated"]

#: Entries of a table per decade. Neighboring points of several isotherms are averaged.
ENTRIES_PER_DECADE = 10


def tabulated(frequency: Floats, storage: Floats, loss: Floats, *, relaxed: float | None = None) -> MasterCurve:
    """Return a table with at most ten entries per decade, geometric means of the points around them.

    If a relaxed modulus [Pa] is given, the table begins with an entry at frequency 0.
    """
    cells = np.floor(np.log10(frequency) * ENTRIES_PER_DECADE).astype(np.int64)
    _, cells = np.unique(cells, return_inverse=True)
    count = np.bincount(cells)
    means = [np.exp(np.bincount(cells, np.log(values)) / count) for values in (frequency, storage, loss)]
    rest = [] if relaxed is None else [(0.0, relaxed, 0.0)]
    omega, real, imaginary = np.vstack([*rest, np.column_stack(means)]).T
    return MasterCurve(omega, real, imaginary, extrapolation=Extrapolation.HOLD)
