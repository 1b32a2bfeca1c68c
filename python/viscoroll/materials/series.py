"""Nonnegative Prony series on a fixed grid of times, fitted to the relative errors of storage and loss.

The rows of a matrix are all storage moduli, then all loss moduli, each divided by the measured value. The first column
is the relaxed modulus; the others are the terms.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import ConvergenceError
from .._support.arguments import Floats
from .._support.extras import extra

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SeriesFit", "basis", "fit_series", "fit_sparse", "nonnegative", "time_grid"]

#: Decades by which the times extend beyond the data, at either end.
MARGIN = 0.5

#: Smallest relaxed modulus, relative to the lowest measured modulus other than a loss modulus.
FLOOR = 1e-2


def time_grid(frequency: Floats, terms_per_decade: float, *, margin: float = MARGIN) -> Floats:
    """Return times with equal ratios that extend `margin` decades beyond the frequencies [s]."""
    low, high = -math.log10(frequency.max()) - margin, -math.log10(frequency.min()) + margin
    count = max(2, math.ceil((high - low) * terms_per_decade) + 1)
    return np.logspace(low, high, count)


def basis(frequency: Floats, times: Floats) -> Floats:
    """Return storage and loss modulus of the relaxed modulus and of unit terms, shape (2 n, 1 + terms) [-]."""
    x = frequency[:, None] * times
    storage = x**2 / (1.0 + x**2)
    loss = x / (1.0 + x**2)
    relaxed = np.concatenate([np.ones(frequency.size), np.zeros(frequency.size)])
    return np.column_stack([relaxed, np.concatenate([storage, loss])])


def nonnegative(matrix: Floats, right: Floats) -> Floats:
    """Solve a least-squares problem with unknowns ≥ 0, for one right side or for several (columns of `right`).

    The matrix is reduced once by QR, so the cost of each right side depends on the number of unknowns only.
    """
    with extra("studies"):
        from scipy.optimize import nnls

    q, r = np.linalg.qr(matrix)
    columns = np.atleast_2d((q.T @ right).T)
    try:
        found = [nnls(r, column, maxiter=50 * r.shape[1])[0] for column in columns]
    except RuntimeError as error:
        raise ConvergenceError(f"the fit of a series did not converge: {error}") from None
    return np.asarray(found[0]) if right.ndim == 1 else np.stack(found, axis=1)


@dataclass(frozen=True, slots=True, eq=False)
class SeriesFit:
    """Fitted series: relaxed modulus and terms [Pa], times [s], and relative errors of storage, then loss."""

    times: Floats
    terms: Floats
    relaxed: float
    residual: Floats

    @property
    def scatter(self) -> float:
        """Root mean square of the relative errors per degree of freedom [-]."""
        used = int((self.terms > 0.0).sum()) + 1
        return float(np.sqrt((self.residual**2).sum() / max(1, self.residual.size - used)))

    def modulus(self, frequency: Floats) -> NDArray[np.complex128]:
        """Return μ*(ω) [Pa]."""
        values = basis(frequency, self.times) @ np.concatenate([[self.relaxed], self.terms])
        return np.asarray(values[: frequency.size] + 1j * values[frequency.size :])


def fit_series(frequency: Floats, storage: Floats, loss: Floats, times: Floats, *, floor: float) -> SeriesFit:
    """Fit terms ≥ 0 and a relaxed modulus ≥ `floor` [Pa] to the relative errors of both moduli."""
    measured = np.concatenate([storage, loss])
    matrix = basis(frequency, times) / measured[:, None]
    right = 1.0 - floor * matrix[:, 0]
    # Normalized columns keep the reduced problem well conditioned over a dozen decades of modulus.
    size = np.linalg.norm(matrix, axis=0)
    found = nonnegative(matrix / size, right) / size
    residual = matrix @ found - right
    return SeriesFit(times, found[1:], float(found[0] + floor), residual)


def fit_sparse(
    dense: SeriesFit, frequency: Floats, storage: Floats, loss: Floats, *, terms: int, floor: float
) -> SeriesFit:
    """Fit at most `terms` terms and their times, starting from a dense fit whose closest terms are merged."""
    with extra("studies"):
        from scipy.optimize import least_squares

    used = dense.terms > 0.0
    x, weights = np.log(dense.times[used]), dense.terms[used]
    while x.size > terms:
        gap = np.diff(x) * np.sqrt(weights[:-1] * weights[1:] / (weights[:-1] + weights[1:]) ** 2)
        i = int(np.argmin(gap))
        total = weights[i] + weights[i + 1]
        joined = (weights[i] * x[i] + weights[i + 1] * x[i + 1]) / total
        x = np.concatenate([x[:i], [joined], x[i + 2 :]])
        weights = np.concatenate([weights[:i], [total], weights[i + 2 :]])

    def at(logarithms: Floats) -> SeriesFit:
        return fit_series(frequency, storage, loss, np.exp(logarithms), floor=floor)

    found = least_squares(lambda logarithms: at(logarithms).residual, x, xtol=1e-6, max_nfev=30)
    return at(found.x)
