"""Time-temperature shift: moduli at a temperature other than that of the measurement, μ*(ω, T) = μ*(a_T(T) ω).

All temperatures are in kelvin.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from .._support.arguments import as_float, as_kelvin, store_positive
from .._support.errors import InvalidInput, InvalidType, Range
from .._support.text import shown
from .moduli import ShearModulus
from .modulus_like import ShearModulusLike, as_modulus
from .softening import SofteningModulus

__all__ = ["Arrhenius", "Shift", "WilliamsLandelFerry", "scaled", "shift_factor", "shifted"]

_GAS_CONSTANT = 8.314462618  # [J/(mol K)], CODATA 2018


@dataclass(frozen=True, slots=True, kw_only=True)
class WilliamsLandelFerry:
    """Williams-Landel-Ferry law of the shift factor, log₁₀ a_T = -C₁ (T - T_r) / (C₂ + T - T_r).

    Parameters
    ----------
    c1 : float
        C₁ [-], > 0.
    c2 : float
        C₂, a difference of temperatures [K], > 0.
    reference_temperature : float
        Temperature T_r at which the moduli were measured [K], > 0.

    References
    ----------
    M. L. Williams, R. F. Landel and J. D. Ferry, J. Am. Chem. Soc. 77 (1955) 3701-3707.

    Examples
    --------
    >>> rubber = WilliamsLandelFerry(c1=8.86, c2=101.6, reference_temperature=293.15)
    >>> print(f"{rubber(303.15):.3f}")
    0.161
    """

    c1: float
    c2: float
    reference_temperature: float

    def __post_init__(self) -> None:
        """Store numbers as floats and check them."""
        store_positive(self, {"c1": "", "c2": "K", "reference_temperature": "K"})
        as_kelvin("reference_temperature", self.reference_temperature)

    def __call__(self, temperature: float) -> float:
        """Return a_T at a temperature above T_r - C₂ [K]."""
        above = as_kelvin("temperature", temperature) - self.reference_temperature
        if not above > -self.c2:
            lowest = self.reference_temperature - self.c2
            allowed = Range(lowest, unit="K", excludes_minimum=True)
            raise allowed.error("temperature", f"{temperature:g} K", " for this shift")
        return float(10.0 ** (-self.c1 * above / (self.c2 + above)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Arrhenius:
    """Arrhenius law of the shift factor, ln a_T = (E / R) (1/T - 1/T_r), with the gas constant R.

    Parameters
    ----------
    activation_energy : float
        Activation energy E [J/mol], > 0.
    reference_temperature : float
        Temperature T_r at which the moduli were measured [K], > 0.

    Examples
    --------
    >>> print(f"{Arrhenius(activation_energy=50e3, reference_temperature=293.15)(303.15):.3f}")
    0.508
    """

    activation_energy: float
    reference_temperature: float

    def __post_init__(self) -> None:
        """Store numbers as floats and check them."""
        store_positive(self, {"activation_energy": "J/mol", "reference_temperature": "K"})
        as_kelvin("reference_temperature", self.reference_temperature)

    def __call__(self, temperature: float) -> float:
        """Return a_T at a temperature [K]."""
        inverse = 1.0 / as_kelvin("temperature", temperature) - 1.0 / self.reference_temperature
        return float(np.exp(self.activation_energy / _GAS_CONSTANT * inverse))


#: Shift factor a_T as a function of temperature [K]: 1 at the temperature of the measured moduli, decreasing with
#: temperature.
Shift: TypeAlias = WilliamsLandelFerry | Arrhenius | Callable[[float], float]


def shift_factor(shift: Shift, temperature: float, name: str = "shift") -> float:
    """Return the horizontal or vertical shift factor, a_T or b_T, at a temperature [K].

    `name` is the name of the argument in error messages.

    Raises
    ------
    TypeError
        If `shift` is not callable or does not return a number.
    ValueError
        If the returned number is not finite and positive.
    """
    if not callable(shift):
        raise InvalidType(name, "must be a function of temperature [K]", shown(shift))
    if callable(getattr(shift, "shift", None)):
        raise InvalidType(name, "must be a function of temperature [K]: use shift() of a fitted law", shown(shift))
    factor = as_float(f"{name}(temperature)", shift(temperature))
    if not (np.isfinite(factor) and factor > 0.0):
        raise InvalidInput(f"{name}(temperature)", "must be > 0", f"{factor!r} at {temperature:g} K")
    return factor


def shifted(modulus: ShearModulusLike, factor: float) -> ShearModulusLike:
    """Return the modulus whose value at ω is that of `modulus` at a_T ω.

    Parameters
    ----------
    modulus : ShearModulus or callable
        Any modulus of a layer.
    factor : float
        Shift factor a_T [-], > 0. Relaxation times are multiplied by it.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> shifted(rubber, 0.5).relaxation_time
    0.0625
    """
    return _rescaled(modulus, 1.0, factor)


def scaled(modulus: ShearModulusLike, factor: float) -> ShearModulusLike:
    """Return the modulus that is b_T times `modulus` at every frequency.

    Parameters
    ----------
    modulus : ShearModulus or callable
        Any modulus of a layer.
    factor : float
        Vertical shift factor b_T [-], > 0.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> scaled(Elastic(modulus=3e6), 0.5)
    Elastic(modulus=1500000.0)
    """
    return _rescaled(modulus, factor, 1.0)


def _rescaled(modulus: ShearModulusLike, stress: float, time: float) -> ShearModulusLike:
    """Return the modulus whose value at ω is `stress` times that of `modulus` at `time` ω."""
    known = as_modulus(modulus)
    if isinstance(known, SofteningModulus):  # the network does not depend on rate, so a_T does not apply to it
        return replace(known, matrix=_rescaled(known.matrix, stress, time))
    if isinstance(known, ShearModulus) and known._units:
        factors = {name: stress**first * time**second for name, (first, second) in known._units.items()}
        given = {name: value for name in factors if (value := getattr(known, name)) is not None}
        return replace(known, **{name: _product(factors[name], value) for name, value in given.items()})  # type: ignore[type-var]
    evaluate = known.complex_modulus if isinstance(known, ShearModulus) else known
    return lambda omega: stress * evaluate(time * omega)


def _product(factor: float, value: float | Sequence[float]) -> float | list[float]:
    return [factor * one for one in value] if isinstance(value, Sequence) else factor * value
