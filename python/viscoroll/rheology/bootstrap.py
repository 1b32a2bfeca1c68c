"""Wild bootstrap: synthetic copies of measured data with errors of random sign.

Each point keeps the size of its own error, so storage may be more accurate than loss, and one end of the data more
accurate than the other. Only the sign is random. A fit leaves the fraction 1 - h of an error, with the leverage h of
the point, so the residual is divided by 1 - h, as in the estimate HC3 of J. G. MacKinnon and H. White, J. Econometrics
29 (1985) 305. Random signs follow R. Davidson and E. Flachaire, J. Econometrics 146 (2008) 162.
(`scipy.stats.bootstrap` draws whole observations with replacement, which suits a random sample. Here each point has its
own frequency, and drawing one twice would omit another.)
"""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats, as_count, as_float_array
from .._support.intervals import as_confidence, interval_half_width
from ..materials import Prony

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["modulus_band", "wild_copies"]

#: Smallest fraction of an error that a fit is assumed to leave, and smallest factor of a modulus after adding noise.
_LEAST = 0.1


#: Largest number of copies. Each is fitted, which takes some milliseconds; 1000 give the ends of an interval to 5 %.
_MAX_COPIES = 100_000


def wild_copies(data: Floats, expected: Floats, columns: Floats, *, count: int, seed: int) -> Iterator[Floats]:
    """Yield copies of measured data with errors of random sign relative to the fit.

    Parameters
    ----------
    data, expected : ndarray, shape (points,)
        Measured and fitted values, > 0; errors are relative to the fitted values.
    columns : ndarray, shape (points, unknowns)
        Relative derivatives of the fitted values with respect to each unknown.
    count : int
        Number of copies, in [2, 100000].
    seed : int
        Seed of the random signs, ≥ 0. The data are part of the seed, so different data have different signs.

    Yields
    ------
    ndarray, shape (points,)
        Copy of the data, > 0.

    Raises
    ------
    ValueError
        If `seed` is negative or `count` is out of range.
    """
    as_count("count", count, 2, _MAX_COPIES)
    as_count("seed", seed, 0)
    q, _ = np.linalg.qr(columns)
    left = np.maximum(1.0 - (q**2).sum(axis=1), _LEAST)
    error = (data / expected - 1.0) / left
    generator = np.random.default_rng([seed, zlib.crc32(data.tobytes())])
    for _ in range(count):
        yield expected * np.maximum(1.0 + error * generator.choice([-1.0, 1.0], error.size), _LEAST)


def modulus_band(
    series: Prony, draws: Iterable[Prony], angular_frequency: ArrayLike, confidence: float
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Return pointwise confidence bounds of the modulus of a series [Pa], from the scatter of its draws."""
    omega = np.atleast_1d(as_float_array("angular_frequency", angular_frequency))
    level = as_confidence(confidence)
    drawn = np.array([one.complex_modulus(omega) for one in draws])
    half = interval_half_width(drawn.real, level) + 1j * interval_half_width(drawn.imag, level)
    middle = series.complex_modulus(omega)
    return middle - half, middle + half
