"""Shear moduli of linear viscoelastic materials as functions of angular frequency.

The time factor is exp(+iωt): the storage modulus is the real part of μ*(ω), and the loss modulus its imaginary part.
The loss modulus of a passive material is not negative at ω ≥ 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from .. import _core
from .._support.arguments import as_floats, as_not_negative
from .._support.errors import InvalidInput
from .._support.text import snake_case
from .shear_modulus import KnownTimes, Relaxation, ShearModulus

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "MODULI",
    "CreepCompliance",
    "Elastic",
    "FractionalZener",
    "HavriliakNegami",
    "KelvinVoigt",
    "LossFactor",
    "MasterCurve",
    "Prony",
    "Relaxation",
    "ShearModulus",
    "StandardLinearSolid",
]


@dataclass(frozen=True, slots=True, kw_only=True)
class Elastic(ShearModulus):
    """Elastic material, μ* = G, without dissipation.

    Parameters
    ----------
    modulus : float
        Shear modulus G [Pa], > 0.

    Examples
    --------
    >>> Elastic(modulus=3e6).complex_modulus([0.0, 10.0])
    array([3000000.+0.j, 3000000.+0.j])
    """

    modulus: float
    _units: ClassVar = {"modulus": (1, 0)}

    def _relaxation(self) -> Relaxation:
        return Relaxation(np.array([self.modulus]), np.array([np.inf]))


@dataclass(frozen=True, slots=True, kw_only=True)
class Prony(ShearModulus):
    """Prony series, μ* = G₀ (g_∞ + Σ g_k iωτ_k / (1 + iωτ_k)) with g_∞ = 1 - Σ g_k.

    Parameters
    ----------
    instantaneous_modulus : float
        Shear modulus G₀ at infinite frequency [Pa], > 0.
    weights : array_like
        Weights g_k [-], each in [0, 1], with a sum of at most 1 apart from round-off. Terms of weight 0 are dropped.
    relaxation_times : array_like
        Relaxation times τ_k [s], > 0, as many as `weights`.

    References
    ----------
    Equation (65) of Zéhil and Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings".

    Examples
    --------
    >>> series = Prony(instantaneous_modulus=6e6, weights=[0.3, 0.2], relaxation_times=[0.1, 1.0])
    >>> series.complex_modulus(0.0)
    array(3000000.+0.j)
    """

    instantaneous_modulus: float
    weights: Sequence[float] | NDArray[np.float64]
    relaxation_times: Sequence[float] | NDArray[np.float64]
    _units: ClassVar = {"instantaneous_modulus": (1, 0), "relaxation_times": (0, 1)}

    def __post_init__(self) -> None:
        """Convert and check the parameters, and drop terms of weight 0."""
        ShearModulus.__post_init__(self)
        terms = [term for term in zip(self.weights, self.relaxation_times, strict=True) if term[0] > 0.0]
        for name, column in zip(
            ("weights", "relaxation_times"), zip(*terms, strict=True) if terms else ((), ()), strict=True
        ):
            object.__setattr__(self, name, column)

    @classmethod
    def from_moduli(
        cls,
        *,
        relaxed_modulus: float,
        moduli: Sequence[float] | NDArray[np.float64],
        relaxation_times: Sequence[float] | NDArray[np.float64],
    ) -> Prony:
        """Return the series of a generalized Maxwell model, G(t) = G_∞ + Σ G_k exp(-t/τ_k).

        Parameters
        ----------
        relaxed_modulus : float
            Shear modulus G_∞ at zero frequency [Pa], ≥ 0.
        moduli : array_like
            Shear moduli G_k of the terms [Pa], ≥ 0.
        relaxation_times : array_like
            Relaxation times τ_k [s], > 0, as many as `moduli`. The moduli of terms with infinite times are added to the
            relaxed modulus.

        Raises
        ------
        ValueError
            If a value is out of range, or the moduli add up to 0.

        Examples
        --------
        >>> Prony.from_moduli(relaxed_modulus=3e6, moduli=[1e6, 2e6], relaxation_times=[0.1, 1.0]).weights
        (0.16666666666666666, 0.3333333333333333)
        """
        relaxed = as_not_negative("relaxed_modulus", relaxed_modulus, "Pa")
        terms, times = as_floats("moduli", moduli), as_floats("relaxation_times", relaxation_times)
        if len(terms) != len(times):
            raise InvalidInput("relaxation_times", f"must be as many as moduli ({len(terms)})", len(times))
        for index, modulus in enumerate(terms):
            as_not_negative(f"moduli[{index}]", modulus, "Pa")
        total = relaxed + sum(terms)
        if not total > 0.0:
            raise InvalidInput("moduli", "must add up to more than 0 Pa with relaxed_modulus", f"{total:g}")
        kept = [(modulus / total, time) for modulus, time in zip(terms, times, strict=True) if time != float("inf")]
        return cls(
            instantaneous_modulus=total,
            weights=[weight for weight, _ in kept],
            relaxation_times=[time for _, time in kept],
        )

    def _relaxation(self) -> Relaxation:
        fractions = np.append(self.weights, 1.0 - np.sum(self.weights))
        return Relaxation(self.instantaneous_modulus * fractions, np.append(self.relaxation_times, np.inf))


class _EqualsProny(ShearModulus):
    """Base class of moduli that the core converts to a Prony series."""

    __slots__ = ()

    def prony(self) -> Prony:
        """Return the Prony series that equals this modulus."""
        return Prony(**self._to_core().parameters())

    def _relaxation(self) -> Relaxation:
        return self.prony()._relaxation()


@dataclass(frozen=True, slots=True, kw_only=True)
class StandardLinearSolid(ShearModulus):
    """Standard linear solid: a Prony series with one term, given by its two limiting moduli.

    Parameters
    ----------
    instantaneous_modulus : float
        Shear modulus at infinite frequency [Pa], > 0.
    relaxed_modulus : float
        Shear modulus at zero frequency [Pa], in [1e-12, 1] times `instantaneous_modulus`.
    relaxation_time : float
        Relaxation time τ of the stress at constant strain [s], > 0.

    Examples
    --------
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> rubber.complex_modulus(8.0)
    array(4500000.+1500000.j)
    """

    instantaneous_modulus: float
    relaxed_modulus: float
    relaxation_time: float
    _units: ClassVar = {"instantaneous_modulus": (1, 0), "relaxed_modulus": (1, 0), "relaxation_time": (0, 1)}

    def _relaxation(self) -> Relaxation:
        moduli = np.array([self.instantaneous_modulus - self.relaxed_modulus, self.relaxed_modulus])
        return Relaxation(moduli, np.array([self.relaxation_time, np.inf]))

    def _standard_linear_solid(self) -> StandardLinearSolid:
        return self


@dataclass(frozen=True, slots=True, kw_only=True)
class CreepCompliance(_EqualsProny):
    """Material whose creep compliance is a Prony series, J(t) = J₀ + Σ J_k (1 - exp(-t/τ_k)), as creep tests give it.

    Parameters
    ----------
    instantaneous_compliance : float
        Shear compliance J₀ at infinite frequency [1/Pa], > 0.
    compliances : array_like
        Compliances J_k of the terms [1/Pa], ≥ 0.
    retardation_times : array_like
        Retardation times τ_k of the strain at constant stress [s], > 0, as many as `compliances`.

    Notes
    -----
    The modulus is 1/J* with J*(ω) = J₀ + Σ J_k / (1 + iωτ_k). It equals a Prony series of as many terms as there are
    different retardation times. The relaxation times follow from the zeros of J*, one below each retardation time.

    Examples
    --------
    >>> solid = CreepCompliance(instantaneous_compliance=1e-6, compliances=[1e-6], retardation_times=[0.2])
    >>> solid.prony().relaxation_times
    (0.1,)
    """

    instantaneous_compliance: float
    compliances: Sequence[float] | NDArray[np.float64]
    retardation_times: Sequence[float] | NDArray[np.float64]
    _units: ClassVar = {"instantaneous_compliance": (-1, 0), "compliances": (-1, 0), "retardation_times": (0, 1)}


@dataclass(frozen=True, slots=True, kw_only=True)
class LossFactor(_EqualsProny):
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
    compression_set : float, optional
        Compression set of ISO 815, the strain that remains after a compression divided by this compression [-], in
        (0, 1). A data sheet states it in percent.
    compression_time : float, optional
        Duration of the compression [s], > 0. Required with `compression_set`.
    recovery_time : float, optional
        Time from the release of the compression to the measurement [s], > 0; by default 1800, as in ISO 815.
    creep_ratio : float, optional
        Strain at `creep_time` divided by the strain at `creep_start` under constant stress [-], > 1. Excludes
        `compression_set`.
    creep_time : float, optional
        Time of the last strain of a creep test [s], > `creep_start`. Required with `creep_ratio`.
    creep_start : float, optional
        Time of the first strain of a creep test [s], > 0. Required with `creep_ratio`.

    Notes
    -----
    A loss factor contains no information about times beyond 10^(`decades`) / ω₀. A compression set or a creep test
    extends the material to the end of the test: the relaxation continues as G(t) = G₁ (t/t₁)^-β from t₁ =
    10^(`decades` + 1) / ω₀, where the law of the loss factor ends. The exponent β in [0, 1] is the one for which the
    material, compressed for `compression_time` and released, keeps the set at `recovery_time`, or creeps by
    `creep_ratio`. For slow relaxation this means G(t_c + t_r) = (1 - set) G(t_r) with t_c = `compression_time` and
    t_r = `recovery_time`. Beyond the test the material is elastic.

    One number cannot determine the relaxation at each time: the power law, a constant relative decrease per decade, is
    an assumption. The material has one temperature, so use the set at the temperature of use. A set of a hotter test
    includes faster relaxation and chemical changes, and overestimates flat spots.

    References
    ----------
    E. Kjartansson, "Constant Q-wave propagation and attenuation", J. Geophys. Res. 84 (1979) 4737-4748.

    ISO 815-1, "Rubber, vulcanized or thermoplastic: Determination of compression set, Part 1".

    Examples
    --------
    >>> pad = LossFactor(modulus=1e6, loss_factor=0.1, reference_frequency=100.0)
    >>> pad.complex_modulus([1.0, 100.0, 10000.0]).round(-3)
    array([ 747000. +75000.j, 1000000.+100000.j, 1339000.+134000.j])

    The same pad with a set of 20 % after one day, defined for rests of up to one day:

    >>> pad = LossFactor(
    ...     modulus=1e6, loss_factor=0.1, reference_frequency=100.0, compression_set=0.2, compression_time=86400.0
    ... )
    >>> round(float(pad.complex_modulus(0.0).real), -3)
    342000.0
    """

    modulus: float
    loss_factor: float
    reference_frequency: float
    decades: float = 3.0
    compression_set: float | None = None
    compression_time: float | None = None
    recovery_time: float | None = None
    creep_ratio: float | None = None
    creep_time: float | None = None
    creep_start: float | None = None
    _units: ClassVar = {
        "modulus": (1, 0),
        "reference_frequency": (0, -1),
        "compression_time": (0, 1),
        "recovery_time": (0, 1),
        "creep_time": (0, 1),
        "creep_start": (0, 1),
    }

    def _known_times(self) -> KnownTimes:
        rest = (float(self.complex_modulus(0.0).real), self.modulus)
        if self.compression_time is not None:
            return KnownTimes(self.compression_time, "the compression set is measured", rest)
        if self.creep_time is not None:
            return KnownTimes(self.creep_time, "creep is measured", rest)
        return KnownTimes(10.0**self.decades / self.reference_frequency, "the loss factor is defined", rest)


@dataclass(frozen=True, slots=True, kw_only=True)
class KelvinVoigt(ShearModulus):
    """Kelvin-Voigt solid: a spring and a dashpot in parallel, μ* = G + iωη.

    Parameters
    ----------
    modulus : float
        Relaxed shear modulus G [Pa], > 0.
    viscosity : float
        Shear viscosity η [Pa s], ≥ 0.

    Examples
    --------
    >>> KelvinVoigt(modulus=1e6, viscosity=1e3).complex_modulus(10.0)
    array(1000000.+10000.j)
    """

    modulus: float
    viscosity: float
    _units: ClassVar = {"modulus": (1, 0), "viscosity": (1, 1)}

    def _relaxation(self) -> Relaxation:
        return Relaxation(np.array([self.modulus]), np.array([np.inf]), self.viscosity)


@dataclass(frozen=True, slots=True, kw_only=True)
class FractionalZener(ShearModulus):
    """Fractional Zener solid, a standard linear solid with a springpot: μ* = (G_∞ + G₀ (iωτ)^α) / (1 + (iωτ)^α).

    Parameters
    ----------
    instantaneous_modulus : float
        Shear modulus G₀ at infinite frequency [Pa], at least `relaxed_modulus`.
    relaxed_modulus : float
        Shear modulus G_∞ at zero frequency [Pa], > 0.
    relaxation_time : float
        Relaxation time τ [s], > 0.
    order : float
        Order α of the derivatives [-], in (0, 1]; 1 gives the standard linear solid.

    References
    ----------
    R. L. Bagley and P. J. Torvik, AIAA Journal 21 (1983) 741-748, with the same order for both derivatives.

    Examples
    --------
    >>> solid = FractionalZener(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=1.0)
    >>> solid.complex_modulus([8.0]).round()
    array([4500000.+1500000.j])
    """

    instantaneous_modulus: float
    relaxed_modulus: float
    relaxation_time: float
    order: float
    _units: ClassVar = {"instantaneous_modulus": (1, 0), "relaxed_modulus": (1, 0), "relaxation_time": (0, 1)}


@dataclass(frozen=True, slots=True, kw_only=True)
class HavriliakNegami(ShearModulus):
    """Havriliak-Negami solid, for asymmetric transitions: μ* = G₀ - (G₀ - G_∞) / (1 + (iωτ)^α)^β.

    The loss modulus increases as ω^α below its peak and decreases as ω^(-αβ) above it.

    Parameters
    ----------
    instantaneous_modulus : float
        Shear modulus G₀ at infinite frequency [Pa], at least `relaxed_modulus`.
    relaxed_modulus : float
        Shear modulus G_∞ at zero frequency [Pa], > 0.
    relaxation_time : float
        Relaxation time τ [s], > 0.
    order : float
        Exponent α [-], in (0, 1].
    asymmetry : float
        Exponent β [-], in (0, 1]; 1 gives the fractional Zener solid, which is the Cole-Cole model; with α = 1, the
        solid is the Cole-Davidson model.

    References
    ----------
    S. Havriliak and S. Negami, Polymer 8 (1967) 161-210, with the modulus in place of the permittivity.

    Examples
    --------
    >>> solid = HavriliakNegami(
    ...     instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=1.0, asymmetry=1.0
    ... )
    >>> solid.complex_modulus([8.0]).round()
    array([4500000.+1500000.j])
    """

    instantaneous_modulus: float
    relaxed_modulus: float
    relaxation_time: float
    order: float
    asymmetry: float
    _units: ClassVar = {"instantaneous_modulus": (1, 0), "relaxed_modulus": (1, 0), "relaxation_time": (0, 1)}


@dataclass(frozen=True, slots=True)
class MasterCurve(ShearModulus):
    """Tabulated modulus, interpolated linearly over the logarithm of the frequency.

    For a sphere that rolls at the angular speed Ω, the solver evaluates the modulus at the frequencies 0, Ω, 2Ω, ... of
    the harmonics. On a mesh with a truncation order N_t, the highest frequency is N_t Ω. On a mesh with N nodes per
    revolution and without a truncation order, it is 2 N Ω; at higher harmonics the modulus is that at 2 N Ω.

    A first entry at frequency 0 is the static modulus. It is used at zero frequency only, for order m = 0. Without this
    entry, zero frequency is outside the table.

    Parameters
    ----------
    frequency : array_like
        Angular frequencies [rad/s], ≥ 0, strictly increasing, at least two of them above 0.
    storage : array_like
        Storage moduli [Pa], > 0, as many as `frequency`.
    loss : array_like
        Loss moduli [Pa], ≥ 0, as many as `frequency`.
    extrapolation : Extrapolation or str, default Extrapolation.ERROR
        Treatment of frequencies outside the table: raise an error, or hold the end values.

    Examples
    --------
    >>> curve = MasterCurve([0.0, 1.0, 100.0], [1e6, 1e6, 3e6], [0.0, 1e5, 2e5])
    >>> curve.complex_modulus(10.0)
    array(2000000.+150000.j)
    """

    frequency: Sequence[float] | NDArray[np.float64]
    storage: Sequence[float] | NDArray[np.float64]
    loss: Sequence[float] | NDArray[np.float64]
    extrapolation: _core.Extrapolation = _core.Extrapolation.ERROR
    _units: ClassVar = {"frequency": (0, -1), "storage": (1, 0), "loss": (1, 0)}

    def _known_times(self) -> KnownTimes:
        return KnownTimes(1.0 / min(w for w in self.frequency if w > 0.0), "the table is measured")


#: Moduli of the C++ core, by the names of their types in case files.
MODULI = {
    snake_case(name): kind
    for name, kind in vars().copy().items()
    if name in __all__ and isinstance(kind, type) and issubclass(kind, ShearModulus) and kind is not ShearModulus
}
