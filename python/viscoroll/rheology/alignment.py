"""Shifts of isotherms, first between neighbors and then of all together against one Prony series.

The second step is a separable least-squares problem (Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413): for given
shifts the best series is a linear problem with nonnegative unknowns, so only the shifts are iterated. The Jacobian is
that of Kaufman (BIT 15 (1975) 49): the derivative of the residuals at a fixed series, minus its projection on the terms
in use.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from .._support.arguments import Floats
from .._support.celsius import kelvin_range
from .._support.extras import extra
from ..materials.series import SeriesFit, basis, fit_series, time_grid
from .reading import Isotherm

__all__ = ["FREQUENCY_RATIO", "Alignment", "align", "curve_shift", "shift_pairs", "undetermined_pairs"]

_LN10 = float(np.log(10.0))
_TERMS_PER_DECADE = 2.0

#: Ratio of frequencies in a difference quotient.
FREQUENCY_RATIO = 1.001

#: Trial shifts of an isotherm relative to its neighbor [decades].
_TRIALS = np.linspace(-6.0, 6.0, 241)

#: Width of the range of equally good shifts from which on a shift counts as undetermined [decades].
_OPEN = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class Alignment:
    """Shifts of all isotherms relative to a reference isotherm, with their covariance and the fitted series.

    Attributes
    ----------
    horizontal : ndarray
        log₁₀ a_T of each isotherm [decades].
    vertical : ndarray
        log₁₀ of the factor by which the moduli of each isotherm are divided [decades]; zeros without vertical shifts.
    covariance : ndarray
        Covariance of the horizontal shifts, without that of the reference.
    series : SeriesFit
        Series that fits all shifted isotherms best.
    """

    horizontal: Floats
    vertical: Floats
    covariance: Floats
    series: SeriesFit


def shift_pairs(isotherms: Sequence[Isotherm]) -> Floats:
    """Return log₁₀ a_T of each isotherm relative to the first, from the shifts between neighbors."""
    steps = [_shift_on(cold, hot) for cold, hot in pairwise(isotherms)]
    return np.concatenate([[0.0], np.cumsum(steps)])


def undetermined_pairs(isotherms: Sequence[Isotherm]) -> tuple[str, ...]:
    """Describe the steps between neighbors whose shift is undetermined.

    A shift is undetermined if values over half a decade or more fit about as well: their distance from the neighbor is
    at most twice that of the best shift, or below 0.3 %.
    """
    named = []
    for cold, hot in pairwise(isotherms):
        costs = _distances(cold, hot)
        likely = _TRIALS[costs <= 4.0 * costs.min() + 3e-3**2 / _LN10**2]
        if not np.isfinite(costs.min()):
            named.append(f"{kelvin_range(cold.temperature, hot.temperature)}: the sweeps do not overlap")
        elif likely.max() - likely.min() >= _OPEN:
            named.append(
                f"{kelvin_range(cold.temperature, hot.temperature)}: all shifts from {likely.min():.2g} to "
                f"{likely.max():.2g} decades fit about equally well (the sweeps are flat, or do not match)"
            )
    return tuple(named)


def _distances(cold: Isotherm, hot: Isotherm) -> Floats:
    """Return the distance of two isotherms for every trial shift of the hotter one."""
    x_cold, x_hot = np.log10(cold.frequency), np.log10(hot.frequency)
    y_cold = np.log10([cold.storage, cold.loss])
    y_hot = np.log10([hot.storage, hot.loss])
    return np.array([_distance(x_cold, y_cold, x_hot + shift, y_hot) for shift in _TRIALS])


def _shift_on(cold: Isotherm, hot: Isotherm) -> float:
    """Return the shift by which the hotter isotherm fits the colder one best [decades]."""
    return _best(_distances(cold, hot))


def curve_shift(cold: Sequence[tuple[Floats, Floats]], hot: Sequence[tuple[Floats, Floats]]) -> float:
    """Return the shift by which curves at the hotter temperature fit those at the colder one best [decades].

    Each curve is a pair of log₁₀ of frequency, increasing, and log₁₀ of modulus.
    """
    costs = np.full((len(cold) * len(hot), _TRIALS.size), np.inf)
    pairs = ((one, other) for one in cold for other in hot)
    for row, ((x, y), (x_hot, y_hot)) in enumerate(pairs):
        costs[row] = [_distance(x, y[None], x_hot + shift, y_hot[None]) for shift in _TRIALS]
    known = np.isfinite(costs)
    mean = np.where(known, costs, 0.0).sum(axis=0) / np.maximum(known.sum(axis=0), 1)
    return _best(np.where(known.any(axis=0), mean, np.inf))


def _best(costs: Floats) -> float:
    """Return the trial shift with the smallest cost, refined by a parabola [decades]."""
    best = int(np.argmin(costs))
    if 0 < best < len(costs) - 1 and np.isfinite(costs[best - 1 : best + 2]).all():
        # Vertex of the parabola through the best trial and its neighbors.
        left, middle, right = costs[best - 1 : best + 2]
        bend = left - 2.0 * middle + right
        if bend > 0.0:
            return float(_TRIALS[best] + 0.5 * (left - right) / bend * (_TRIALS[1] - _TRIALS[0]))
    return float(_TRIALS[best]) if np.isfinite(costs[best]) else 0.0


def _distance(x: Floats, y: Floats, x_shifted: Floats, y_shifted: Floats) -> float:
    """Return the mean squared distance of two curves in their overlap, in both directions and for all moduli."""
    total, count = 0.0, 0
    for a, b, other_a, other_b in ((x, y, x_shifted, y_shifted), (x_shifted, y_shifted, x, y)):
        inside = (other_a >= a[0]) & (other_a <= a[-1])
        for row, other in zip(b, other_b, strict=True):
            total += float(((np.interp(other_a[inside], a, row) - other[inside]) ** 2).sum())
        count += len(y) * int(inside.sum())
    if count < 4 * len(y):  # at least two points in each direction, for each modulus
        return np.inf
    return total / count + 1e-6 / count  # prefers the larger overlap if distances are equal


def align(isotherms: Sequence[Isotherm], start: Floats, *, reference: int, vertical: bool) -> Alignment:
    """Move all isotherms except the reference until a single nonnegative series fits them best."""
    with extra("studies"):
        from scipy.optimize import least_squares

    problem = _Separable(isotherms, start, reference, vertical=vertical)
    found = least_squares(
        problem.residual, problem.initial, jac=problem.jacobian, x_scale=0.1, xtol=1e-6, ftol=1e-8, max_nfev=60
    )
    horizontal, lifted = problem.unpacked(found.x)
    series = problem.fit(found.x)
    gram = found.jac.T @ found.jac
    covariance = np.linalg.pinv(gram, rcond=1e-14, hermitian=True) * series.scatter**2
    count = len(isotherms) - 1
    return Alignment(horizontal, lifted, covariance[:count, :count], series)


class _Separable:
    """Residual of the best series as a function of the shifts alone."""

    def __init__(self, isotherms: Sequence[Isotherm], start: Floats, reference: int, *, vertical: bool) -> None:
        self._reference, self._is_vertical = reference, vertical
        self._owner = np.concatenate([np.full(s.frequency.size, i) for i, s in enumerate(isotherms)])
        self._frequency = np.concatenate([s.frequency for s in isotherms])
        self._storage = np.concatenate([s.storage for s in isotherms])
        self._loss = np.concatenate([s.loss for s in isotherms])
        self._others = np.delete(np.arange(len(isotherms)), reference)
        self._count = len(isotherms)
        start = start - start[reference]
        self.initial = np.concatenate([start[self._others], np.zeros(self._others.size if vertical else 0)])
        reduced = self._frequency * 10.0 ** start[self._owner]
        self._times = time_grid(reduced, _TERMS_PER_DECADE, margin=1.0)  # margin for changes of the shifts
        self._last: tuple[Floats, SeriesFit] | None = None

    def unpacked(self, x: Floats) -> tuple[Floats, Floats]:
        horizontal, vertical = np.zeros(self._count), np.zeros(self._count)
        horizontal[self._others] = x[: self._others.size]
        if self._is_vertical:
            vertical[self._others] = x[self._others.size :]
        return horizontal, vertical

    def _reduced(self, x: Floats) -> tuple[Floats, Floats, Floats]:
        horizontal, vertical = self.unpacked(x)
        lift = 10.0 ** -vertical[self._owner]
        return self._frequency * 10.0 ** horizontal[self._owner], self._storage * lift, self._loss * lift

    def fit(self, x: Floats) -> SeriesFit:
        if self._last is None or not np.array_equal(self._last[0], x):  # residual and Jacobian share an x
            frequency, storage, loss = self._reduced(x)
            self._last = (x.copy(), fit_series(frequency, storage, loss, self._times, floor=0.0))
        return self._last[1]

    def residual(self, x: Floats) -> Floats:
        return self.fit(x).residual

    def jacobian(self, x: Floats) -> Floats:
        frequency, storage, loss = self._reduced(x)
        measured = np.concatenate([storage, loss])
        series = self.fit(x)
        used = np.concatenate([[series.relaxed > 0.0], series.terms > 0.0])
        matrix = basis(frequency, self._times)[:, used] / measured[:, None]
        q, _ = np.linalg.qr(matrix)
        x_tau = frequency[:, None] * self._times
        # d/d ln ω of x²/(1+x²) and x/(1+x²)
        slope = np.concatenate(
            [2.0 * x_tau**2 / (1.0 + x_tau**2) ** 2, x_tau * (1.0 - x_tau**2) / (1.0 + x_tau**2) ** 2]
        )
        along = _LN10 * (slope @ series.terms) / measured
        columns = [along]
        if self._is_vertical:
            columns.append(_LN10 * (series.residual + 1.0))  # derivative of the ratio series / moduli
        owner = np.concatenate([self._owner, self._owner])
        blocks = [np.where(owner[:, None] == self._others, column[:, None], 0.0) for column in columns]
        derivative = np.hstack(blocks)
        return np.asarray(derivative - q @ (q.T @ derivative))
