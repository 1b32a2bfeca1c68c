"""Data as another day might have given them: the wild bootstrap.

Each point keeps the size of its own error, so that storage may be measured better than loss and one end better than the
other; only its sign is drawn. What a fit leaves of an error is 1 - h of it, h the point's leverage, so it is divided by
that, as in the estimate HC3 of J. G. MacKinnon and H. White, J. Econometrics 29 (1985) 305; signs after R. Davidson and
E. Flachaire, J. Econometrics 146 (2008) 162. (`scipy.stats.bootstrap` draws whole observations, as of a random sample;
here each has a frequency of its own, and one drawn twice would leave another unmeasured.)
"""

from __future__ import annotations

import zlib
from collections.abc import Iterator

import numpy as np

from .._support.arguments import Floats, as_int

__all__ = ["wild_copies"]

#: Least share of an error that a fit is taken to leave, and least share that noise leaves of a modulus.
_LEAST = 0.1


#: Largest number of copies: each is fitted anew, in some milliseconds, and 1000 give the ends of an interval to 5 %.
_MOST_COPIES = 100_000


def wild_copies(data: Floats, expected: Floats, columns: Floats, *, count: int, seed: int) -> Iterator[Floats]:
    """Yield copies of data about what was fitted to them.

    Parameters
    ----------
    data, expected : ndarray, shape (points,)
        What was measured, and fitted; errors are relative to the latter.
    columns : ndarray, shape (points, unknowns)
        Relative changes of what was fitted by each unknown.
    count : int
        Number of copies.
    seed : int
        Of the signs, with the data: other data with the same seed have others.

    Yields
    ------
    ndarray, shape (points,)
        > 0 as the data.

    Raises
    ------
    ValueError
        For a negative seed, and a count out of range.
    """
    if not 2 <= as_int("count", count) <= _MOST_COPIES:
        raise ValueError(f"count must be in [2, {_MOST_COPIES}], got {count}")
    if as_int("seed", seed) < 0:
        raise ValueError(f"seed must be >= 0, got {seed}")
    q, _ = np.linalg.qr(columns)
    left = np.maximum(1.0 - (q**2).sum(axis=1), _LEAST)
    error = (data / expected - 1.0) / left
    generator = np.random.default_rng([seed, zlib.crc32(data.tobytes())])
    for _ in range(count):
        yield expected * np.maximum(1.0 + error * generator.choice([-1.0, 1.0], error.size), _LEAST)
