"""Modulus with a nearly constant loss factor, for materials whose data sheet gives no frequency dependence."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .. import _core
from .._support.errors import InvalidInput
from .moduli import Prony, ShearModulus
from .shear_modulus import KnownTimes

__all__ = ["LossFactor"]

#: Relaxation times per decade. With only two, the sum over them would differ from the integral by a ripple of 3e-4.
_TERMS_PER_DECADE = 3

#: Decades by which the terms extend beyond the range in which the loss factor is nearly constant, at either end.
_MARGIN = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class LossFactor(ShearModulus):
    """Causal modulus whose loss factor is nearly independent of frequency.

    The modulus follows the law of Kjartansson, μ* = G √(1 + η²) (iω/ω₀)^α with α = (2/π) atan η, whose loss factor is η
    at every frequency. The storage modulus is G at ω₀ and increases slightly with frequency: a constant one would not
    be causal. The law holds over `decades` above and below ω₀. Beyond that range the material is elastic, so it
    supports a static load. Within the range the relative error of the loss factor is at most 0.5 % for η up to 1, and
    3 % for η up to 2.

    Parameters
    ----------
    modulus : float
        Storage shear modulus at `reference_frequency` [Pa], > 0.
    loss_factor : float
        Loss factor η = tan δ [-], in [1e-6, 2].
    reference_frequency : float
        ω₀ [rad/s], > 0. Choose Ω R/a, with the angular speed Ω, the radius R and the half-width a of the contact.
    decades : float, default 3
        Decades above and below ω₀ over which the law holds [-], in [0.5, 8].

    References
    ----------
    E. Kjartansson, "Constant Q-wave propagation and attenuation", J. Geophys. Res. 84 (1979) 4737-4748.

    Examples
    --------
    >>> pad = LossFactor(modulus=1e6, loss_factor=0.1, reference_frequency=100.0)
    >>> pad.complex_modulus([1.0, 100.0, 10000.0]).round(-3)
    array([ 747000. +75000.j, 1000000.+100000.j, 1339000.+134000.j])
    """

    modulus: float
    loss_factor: float
    reference_frequency: float
    decades: float = 3.0
    _units: ClassVar = {"modulus": (1, 0), "reference_frequency": (0, -1)}

    def prony(self) -> Prony:
        """Return the Prony series that approximates the law.

        Raises
        ------
        ValueError
            If a parameter is out of range.
        """
        for name, low, high, unit in (
            ("modulus", 0.0, math.inf, " Pa"),
            ("reference_frequency", 0.0, math.inf, " rad/s"),
        ):
            if not low < getattr(self, name) < high:
                raise InvalidInput(name, f"must be > 0{unit}", repr(getattr(self, name)))
        if not 1e-6 <= self.loss_factor <= 2.0:
            raise InvalidInput("loss_factor", "must be in [1e-6, 2]", repr(self.loss_factor))
        if not 0.5 <= self.decades <= 8.0:
            raise InvalidInput("decades", "must be in [0.5, 8]", repr(self.decades))
        weights, times, relaxed = _spectrum(2.0 / math.pi * math.atan(self.loss_factor), self.decades + _MARGIN)
        x = times
        storage = relaxed + float((weights * x**2 / (1.0 + x**2)).sum())
        instantaneous = self.modulus * (relaxed + float(weights.sum())) / storage
        return Prony(
            instantaneous_modulus=instantaneous,
            weights=tuple(weights / (relaxed + weights.sum())),
            relaxation_times=tuple(times / self.reference_frequency),
        )

    def _known_times(self) -> KnownTimes:
        longest = 10.0**self.decades / self.reference_frequency
        rest = float(self.complex_modulus(0.0).real)
        return KnownTimes(longest, "the loss factor is defined", (rest, self.modulus))

    def _to_core(self) -> _core.ShearModulus:
        return self.prony()._to_core()


def _spectrum(alpha: float, reach: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Return weights, times and relaxed modulus of a series for (iω)^α, for `reach` decades above and below ω = 1.

    The spectrum is (iω)^α = sin(απ)/π ∫ τ^{-α} iωτ/(1 + iωτ) d ln τ. Terms with times longer than the grid contribute
    their full modulus at its frequencies: they form the relaxed modulus. Their loss Σ w/(ωτ) is represented by one term
    beyond the end of the grid. Terms with shorter times contribute the loss Σ w ωτ, represented by one term before its
    start.
    """
    step = math.log(10.0) / _TERMS_PER_DECADE
    count = round(2.0 * reach * _TERMS_PER_DECADE)
    times = np.exp(step * (np.arange(count + 1) - 0.5 * count))
    density = math.sin(alpha * math.pi) / math.pi
    weights = density * step * times**-alpha
    longest, shortest = times[-1] * math.exp(0.5 * step), times[0] * math.exp(-0.5 * step)
    beyond, before = longest * math.exp(0.5 * step), shortest * math.exp(-0.5 * step)
    tail = density * longest ** (-alpha - 1.0) / (alpha + 1.0) * beyond
    head = density * shortest ** (1.0 - alpha) / (1.0 - alpha) / before
    relaxed = max(density * longest**-alpha / alpha - tail, 0.0)
    return np.concatenate([[head], weights, [tail]]), np.concatenate([[before], times, [beyond]]), relaxed
