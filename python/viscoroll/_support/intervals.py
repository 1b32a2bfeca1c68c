"""How far a number may lie from what was found, by draws of it."""

from __future__ import annotations

import numpy as np

from .arguments import Floats, as_float
from .extras import extra

__all__ = ["as_confidence", "half_width", "student"]


def as_confidence(confidence: object) -> float:
    """Return a probability, or raise a TypeError or ValueError."""
    number = as_float("confidence", confidence)
    if not 0.0 < number < 1.0:
        raise ValueError(f"confidence must be in (0, 1), got {number!r}")
    return number


def half_width(draws: Floats, confidence: float) -> Floats:
    """Return half the width of intervals, by the scatter of draws along the first axis.

    By Student's quantile, whose error is that of the standard deviation: 7 % of a width of 100 draws. Quantiles of so
    few draws scatter twice as much, and cover less than they claim.
    """
    return np.asarray(student(confidence, len(draws) - 1) * np.std(draws, axis=0, ddof=1))


def student(confidence: float, degrees_of_freedom: int) -> float:
    """Return the two-sided quantile of Student's distribution."""
    with extra("studies"):
        from scipy.stats import t

    return float(t.ppf(0.5 + 0.5 * confidence, degrees_of_freedom))
