"""Creep compliance of a relaxation spectrum, and its derivative with respect to the spectrum.

With G̃(s) = g₀ + Σ g_k s τ_k / (1 + s τ_k), which is s times the Laplace transform of the relaxation modulus, the
compliance is J̃ = 1/G̃ = J_g + Σ j_i / (1 + s λ_i). The retardation times λ_i are the zeros of G̃; one lies between
each two relaxation times, and the last one above all of them (R. M. Christensen, Theory of Viscoelasticity, 2nd
edition, 1982, section 4.2).
"""

from __future__ import annotations

import numpy as np

from .._support.arguments import Floats

__all__ = ["creep_rows"]

#: Bisections of the logarithm of a retardation time, to the last digit of a float.
_BISECTIONS = 60

#: Terms below this fraction of the sum have no effect on the compliance.
_NEGLIGIBLE = 1e-12

#: Smallest relative difference of two times in a divided difference. The error of the difference is its square.
_APART = 1e-3


def creep_rows(time: Floats, times: Floats, relaxed: float, terms: Floats) -> tuple[Floats, Floats]:
    """Return 1/J(t) of a relaxation spectrum, and its derivative with respect to each modulus.

    Parameters
    ----------
    time : ndarray, shape (points,)
        Times t of a creep test [s], > 0.
    times : ndarray, shape (terms,)
        Relaxation times τ_k [s], increasing.
    relaxed : float
        Relaxed modulus g₀ [Pa], > 0.
    terms : ndarray, shape (terms,)
        Moduli g_k [Pa], ≥ 0.

    Returns
    -------
    modulus : ndarray, shape (points,)
        1/J(t) [Pa].
    derivative : ndarray, shape (points, 1 + terms)
        Derivatives with respect to the relaxed modulus and to each term [-]. As 1/J is proportional to the moduli, the
        sum of moduli times derivatives is 1/J.
    """
    glassy, slow, strengths = _retardation(times, relaxed, terms)
    fading = np.exp(-time[:, None] / slow)
    compliance = glassy + (strengths * (1.0 - fading)).sum(axis=1)
    # J̃²/s is the response that the relaxed modulus multiplies; a term multiplies the same response minus its own
    # low-pass filter 1/(1 + s τ). Partial fractions are divided differences of λ exp(-t/λ) and λ² exp(-t/λ), whose
    # double sums over the retardation times reduce to single ones.
    left, right = slow * (1.0 - 0.5 * _APART), slow * (1.0 + 0.5 * _APART)
    gap = left[:, None] - right
    weights = np.outer(strengths, strengths) / gap
    from_left, from_right = weights.sum(axis=1) * left, weights.sum(axis=0) * right
    total = float(strengths.sum()) ** 2
    whole = glassy**2 + 2.0 * glassy * (strengths * (1.0 - fading)).sum(axis=1) + total
    whole -= np.exp(-time[:, None] / left) @ from_left - np.exp(-time[:, None] / right) @ from_right
    one = _divided(time, left[:, None], _apart(left, times))  # points, slow, terms
    other = _divided(time, right[:, None], _apart(right, times))
    filtered = glassy**2 * (1.0 - np.exp(-time[:, None] / times)) + total
    filtered += 2.0 * glassy * np.einsum("i,tik->tk", strengths, 1.0 - 0.5 * (one + other))
    filtered -= np.einsum("i,tik->tk", from_left, one) - np.einsum("i,tik->tk", from_right, other)
    rows = np.column_stack([whole, whole[:, None] - filtered]) / compliance[:, None] ** 2
    return 1.0 / compliance, rows


def _retardation(times: Floats, relaxed: float, terms: Floats) -> tuple[float, Floats, Floats]:
    """Return the glassy compliance [1/Pa], the retardation times [s] and the strengths [1/Pa] of a spectrum."""
    used = terms > _NEGLIGIBLE * (relaxed + terms.sum())
    tau, g = times[used], terms[used]
    glassy = 1.0 / (relaxed + float(g.sum()))
    if not tau.size:
        return glassy, np.array([1.0]), np.array([0.0])
    low = np.log(tau)
    high = np.append(low[1:], np.log(tau[-1] + float((g * tau).sum()) / relaxed))
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        with np.errstate(divide="ignore", invalid="ignore"):
            value = relaxed - (g * tau / (np.exp(middle)[:, None] - tau)).sum(axis=1)
        is_below = ~(value > 0.0)
        low, high = np.where(is_below, middle, low), np.where(is_below, high, middle)
    slow = np.exp(0.5 * (low + high))
    with np.errstate(divide="ignore"):
        slope = (g * tau / (1.0 - tau / slow[:, None]) ** 2).sum(axis=1)
    return glassy, slow, slow / slope


def _apart(slow: Floats, times: Floats) -> Floats:
    """Return the times against each retardation time, moved away from those that nearly agree."""
    nearly = np.abs(slow[:, None] / times - 1.0) < 0.1 * _APART
    return np.where(nearly, slow[:, None] * (1.0 + 0.1 * _APART), times)


def _divided(time: Floats, first: Floats, second: Floats) -> Floats:
    """Return the divided difference of λ exp(-t/λ) between two arrays of times, with the points as the first axis."""
    t = time[:, None, None]
    return np.asarray((first * np.exp(-t / first) - second * np.exp(-t / second)) / (first - second))
