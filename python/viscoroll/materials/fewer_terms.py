"""Prony series with a limited number of terms, fitted to any modulus over a range of frequencies."""

from __future__ import annotations

import numpy as np

from .._support.arguments import Floats, as_floats
from .._support.errors import InvalidInput
from .._support.text import shown
from .moduli import MasterCurve, Prony, ShearModulus
from .modulus_like import relaxation_of
from .series import fit_series, fit_sparse, time_grid

__all__ = ["fewer_terms"]

#: Frequencies per decade at which a modulus is evaluated for a fit, and terms per decade of the first fit.
_PER_DECADE, _TERMS_PER_DECADE = 20, 3.0

#: Smallest modulus [-], relative to the modulus itself, at which the relative error of storage or loss is taken. A
#: loss of less has no effect on the complex modulus.
_SMALLEST = 1e-4


def fewer_terms(
    modulus: ShearModulus, *, terms: int, tolerance: float, frequencies: tuple[float, float] | None
) -> tuple[Prony, str]:
    """Return a series of at most `terms` terms and a sentence that states its error.

    Raises
    ------
    ValueError
        If the largest relative error of the complex modulus in the range exceeds `tolerance`, or no range is given for
        a modulus that has none.
    """
    low, high = _range(modulus, frequencies)
    omega = np.geomspace(low, high, max(10, round(_PER_DECADE * np.log10(high / low)) + 1))
    exact = modulus.complex_modulus(omega)
    least = _SMALLEST * np.abs(exact)
    storage, loss = np.maximum(exact.real, least), np.maximum(exact.imag, least)
    floor = 1e-6 * float(storage.min())
    dense = fit_series(omega, storage, loss, time_grid(omega, _TERMS_PER_DECADE), floor=floor)
    fit = fit_sparse(dense, omega, storage, loss, terms=terms, floor=floor)
    kept = fit.terms > 0.0
    found = Prony.from_moduli(relaxed_modulus=fit.relaxed, moduli=fit.terms[kept], relaxation_times=fit.times[kept])
    error = _largest_error(found, omega, exact)
    if error > tolerance:
        rule = f"must be >= {error:.2g} with {terms} terms from {low:.3g} to {high:.3g} rad/s; or give more terms"
        raise InvalidInput("tolerance", rule, f"{tolerance:g}")
    sentence = (
        f"Fit of {len(found.weights)} terms: largest relative error of the complex shear modulus {error:.2g}, from "
        f"{low:.4g} to {high:.4g} rad/s."
    )
    return found, sentence


def _largest_error(series: Prony, omega: Floats, exact: np.ndarray) -> float:
    return float(np.max(np.abs(series.complex_modulus(omega) - exact) / np.abs(exact)))


def _range(modulus: ShearModulus, frequencies: tuple[float, float] | None) -> tuple[float, float]:
    if frequencies is not None:
        ends = as_floats("frequencies", frequencies)
        if len(ends) != 2 or not 0.0 < ends[0] < ends[1] < np.inf:
            raise InvalidInput(
                "frequencies", "must be two angular frequencies > 0 rad/s in increasing order", shown(ends)
            )
        return ends[0], ends[1]
    if isinstance(modulus, MasterCurve):
        positive = [w for w in modulus.frequency if w > 0.0]
        return positive[0], positive[-1]
    relaxation = relaxation_of(modulus)
    if relaxation is None or relaxation.times.size < 2:
        raise InvalidInput("frequencies", "must be given for this modulus: the range of the fit [rad/s]")
    times = relaxation.times[:-1]
    return 0.1 / float(times.max()), 10.0 / float(times.min())
