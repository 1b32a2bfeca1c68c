"""Points of sweeps, relaxation and creep tests, and their moduli as functions of one relaxation spectrum."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._core import ConvergenceError
from .._support.arguments import Floats
from ..materials.series import basis, nonnegative
from .reading import Isotherm
from .retardation import creep_rows
from .time_tests import TimeTest

__all__ = ["Points", "Spectrum", "fit_points", "points_of", "predicted"]

#: Iterations of the linearized creep compliance, their relative change of the sum of squares at which they end, and
#: halvings of one step.
_MAX_ITERATIONS, _SETTLED, _MAX_HALVINGS = 50, 1e-6, 12


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """Measured moduli of all tests, one entry per modulus.

    Attributes
    ----------
    frequency : ndarray
        Angular frequency of storage and loss moduli; for points over time 1/t [rad/s].
    modulus : ndarray
        Storage or loss modulus, G(t) or 1/J(t) [Pa].
    quantity : ndarray of str
        "storage", "loss", "relaxation" or "creep".
    temperature : ndarray of int
        Index of the temperature of each entry.
    """

    frequency: Floats
    modulus: Floats
    quantity: np.ndarray
    temperature: np.ndarray

    def shifted(self, log10_factor: Floats) -> Floats:
        """Return the reduced frequencies ω a_T and a_T/t [rad/s]."""
        return np.asarray(self.frequency * 10.0 ** log10_factor[self.temperature])


@dataclass(frozen=True, slots=True, eq=False)
class Spectrum:
    """Relaxation spectrum [s], [Pa], with the relative errors of all points and its derivatives there."""

    times: Floats
    relaxed: float
    terms: Floats
    residual: Floats
    derivative: Floats

    @property
    def used(self) -> np.ndarray:
        """Which columns of the derivative belong to moduli that are not at their bound."""
        return np.concatenate([[True], self.terms > 0.0])

    @property
    def cost(self) -> float:
        """Sum of the squares of the relative errors [-]."""
        return float((self.residual**2).sum())

    @property
    def scatter(self) -> float:
        """Root mean square of the relative errors per degree of freedom [-]."""
        free = max(1, self.residual.size - int(self.used.sum()))
        return math.sqrt(self.cost / free)


def points_of(tests: Sequence[Isotherm | TimeTest], indices: Sequence[int]) -> Points:
    """Return the points of tests; `indices` are those of their temperatures."""
    parts: list[tuple[Floats, Floats, str, int]] = []
    for test, index in zip(tests, indices, strict=True):
        if isinstance(test, Isotherm):
            parts += [(test.frequency, test.storage, "storage", index), (test.frequency, test.loss, "loss", index)]
        else:
            parts.append((1.0 / test.time, test.modulus, test.kind, index))
    return Points(
        frequency=np.concatenate([part[0] for part in parts]),
        modulus=np.concatenate([part[1] for part in parts]),
        quantity=np.concatenate([np.full(part[0].size, part[2]) for part in parts]),
        temperature=np.concatenate([np.full(part[0].size, part[3]) for part in parts]),
    )


def predicted(points: Points, frequency: Floats, times: Floats, relaxed: float, terms: Floats) -> tuple[Floats, Floats]:
    """Return the moduli of all points at reduced frequencies [Pa], and their derivatives by those of a spectrum."""
    moduli = np.concatenate([[relaxed], terms])
    rows = np.empty((frequency.size, moduli.size))
    expected = np.empty(frequency.size)
    for quantity in np.unique(points.quantity):
        at = np.flatnonzero(points.quantity == quantity)
        if quantity == "creep":
            expected[at], rows[at] = creep_rows(1.0 / frequency[at], times, relaxed, terms)
            continue
        rows[at] = _rows(quantity, frequency[at], times)
        expected[at] = rows[at] @ moduli
    return expected, rows


def _rows(quantity: str, frequency: Floats, times: Floats) -> Floats:
    if quantity == "relaxation":
        return np.column_stack([np.ones(frequency.size), np.exp(-1.0 / (frequency[:, None] * times))])
    storage, loss = np.split(basis(frequency, times), 2)
    return storage if quantity == "storage" else loss


def fit_points(
    points: Points, frequency: Floats, times: Floats, *, floor: float, start: tuple[float, Floats] | None = None
) -> Spectrum:
    """Fit terms ≥ 0 and a relaxed modulus ≥ `floor` [Pa] to the relative errors of all points.

    Creep is linearized about the spectrum of the last iteration, in 1/J(t), which is nearly linear in the spectrum. The
    first spectrum is `start`, or the fit in which 1/J(t) stands for G(t).

    Raises
    ------
    ConvergenceError
        If the iteration does not converge.
    """
    if start is None:
        simple = Points(
            points.frequency,
            points.modulus,
            np.where(points.quantity == "creep", "relaxation", points.quantity),
            points.temperature,
        )
        _, rows = predicted(simple, frequency, times, floor, np.zeros(times.size))
        relaxed, terms = _solved(rows, points.modulus, floor)
    else:
        relaxed, terms = start
    found = _spectrum(points, frequency, times, relaxed, terms)
    if not (points.quantity == "creep").any():
        return found
    for _ in range(_MAX_ITERATIONS):
        # The derivatives times the moduli are the moduli of all points, so the linearization has no constant part.
        rows = found.derivative * (points.modulus * (1.0 + found.residual))[:, None]
        relaxed, terms = _solved(rows, points.modulus, floor)
        better = _line_search(points, frequency, found, relaxed, terms)
        if better is None or better.cost > found.cost * (1.0 - _SETTLED):
            return better or found
        found = better
    raise ConvergenceError(f"the fit of a spectrum to creep did not converge in {_MAX_ITERATIONS} iterations")


def _spectrum(points: Points, frequency: Floats, times: Floats, relaxed: float, terms: Floats) -> Spectrum:
    expected, rows = predicted(points, frequency, times, relaxed, terms)
    return Spectrum(times, relaxed, terms, expected / points.modulus - 1.0, rows / expected[:, None])


def _line_search(points: Points, frequency: Floats, start: Spectrum, relaxed: float, terms: Floats) -> Spectrum | None:
    """Return a better spectrum between one and the solution of its linearization, or None if there is none.

    Fast terms before the first point over time are hardly determined, and full steps in them may be too large.
    """
    for halving in range(_MAX_HALVINGS):
        part = 0.5**halving
        found = _spectrum(
            points,
            frequency,
            start.times,
            (1.0 - part) * start.relaxed + part * relaxed,
            (1.0 - part) * start.terms + part * terms,
        )
        if found.cost < start.cost:
            return found
    return None


def _solved(rows: Floats, modulus: Floats, floor: float) -> tuple[float, Floats]:
    matrix = rows / modulus[:, None]
    right = 1.0 - floor * matrix[:, 0]
    size = np.linalg.norm(matrix, axis=0)
    size[size == 0.0] = 1.0
    found = nonnegative(matrix / size, right) / size
    return float(found[0] + floor), found[1:]
