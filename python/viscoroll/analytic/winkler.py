"""Rolling torque of bodies with a thin compressible coating, treated as a bed of viscoelastic springs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_positive, require_type
from .._support.errors import InvalidInput
from .._support.text import shown
from ..materials.moduli import Relaxation, ShearModulus
from ..materials.modulus_like import relaxation_of
from ._inputs import Floats, float_if_scalar, poisson, positives, require_one_volumetric_constant

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["winkler_torque", "winkler_torque_line"]

#: Strips across half of the contact, by Gauss's rule in the angle ψ; bisections for the length of a strip; and
#: iterations for the size of the contact, each of which divides the error by at least four.
_STRIPS, _BISECTIONS, _STEPS = 16, 50, 26


def winkler_torque(
    *,
    load: ArrayLike,
    angular_speed: ArrayLike,
    radius: float,
    thickness: float,
    shear_modulus: ShearModulus,
    poisson_ratio: float | None = None,
    bulk_modulus: float | None = None,
) -> Floats:
    """Return the torque of a ball whose coating is a bed of viscoelastic springs, p = (1/h) ∫ M(t - t') dδ(t').

    M* = 2 μ* (1-ν)/(1-2ν), or K + 4μ*/3, is the modulus of a layer that cannot expand sideways. As a function of time
    it is M(t) = M_∞ + Σ M_k exp(-t/τ_k), for a Kelvin-Voigt solid with an additional dashpot η. Material at the lateral
    distance z meets the plane unstrained at x = a, a² = a₀² - z². After the distance u it is compressed by
    δ = (a u - u²/2) / R. With l_k = Ω R τ_k and Φ_n = ∫ Φ_(n-1) du from Φ₀ = exp(-u/l), which is uⁿ/n! for l = ∞,
    integration by parts gives

        R h p = Σ M_k (a Φ₁ - Φ₂)(u; l_k) + η Ω R (a - u).

    A strip ends at u = L, where p is 0 again. Load and torque are the integrals over z of q = ∫ p du and
    m = ∫ (a - u) p du = (a - L) q + ∫ q du, in which Φ_(n+1) and Φ_(n+2) replace Φ_n.

    Valid for a thin coating under the conditions of `thin_compressible_layer`, with errors of the order h/a, without
    friction and inertia, and for coatings that relax within a revolution, Ω τ_k ≪ 2π. At given load the torque is more
    accurate than the contact size. Compared with the solver (standard linear solid, V τ from 0.1 to 1 a), the error is
    within 0.5 % for a ≥ 3 h at ν = 0.3. At ν = 0.45 and a ≥ 10 h it is within 1.2 % if the moduli differ by a factor of
    two, and 2.5 % if they differ by a factor of ten.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    angular_speed : array_like
        Angular speed Ω [rad/s], > 0, of a shape that broadcasts with that of the load.
    radius : float
        Outer radius R [m], > 0.
    thickness : float
        Thickness h of the coating [m], > 0.
    shear_modulus : Elastic, KelvinVoigt, StandardLinearSolid or Prony
        Shear modulus μ*(ω) whose relaxation function is a sum of exponentials.
    poisson_ratio, bulk_modulus : float
        Poisson's ratio ν [-], in (-1, 0.5), or bulk modulus K [Pa], > 0: exactly one of them, as in `Layer`.

    Returns
    -------
    float or ndarray
        Torque T [N m].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    The derivation above; the same for cylinders in K. L. Johnson, Contact Mechanics, section 9.4.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> foam = StandardLinearSolid(instantaneous_modulus=6e5, relaxed_modulus=3e5, relaxation_time=0.01)
    >>> torque = winkler_torque(
    ...     load=10.0, angular_speed=2.0, radius=50e-3, thickness=0.5e-3, shear_modulus=foam, poisson_ratio=0.2
    ... )
    >>> f"{torque * 1e3:.2f} mN m"
    '5.07 mN m'
    """
    size, h = as_positive("radius", radius, "m"), as_positive("thickness", thickness, "m")
    springs = _springs(shear_modulus, poisson_ratio, bulk_modulus)
    forces, speeds = positives("load", load, "N"), positives("angular_speed", angular_speed, "rad/s")

    def torque(force: float, speed: float) -> float:
        # The load grows between a₀³ (dashpots) and a₀⁴ (springs).
        a0 = (4.0 * force * size * h / (np.pi * springs.relaxation.moduli.sum())) ** 0.25
        for _ in range(_STEPS):
            found, moment = springs.load_and_moment(a0, speed * size)
            a0 *= (force * size * h / found) ** 0.25
        return float(moment * force / found)

    return float_if_scalar(np.vectorize(torque, otypes=[np.float64])(forces, speeds))


def winkler_torque_line(
    *,
    load: ArrayLike,
    angular_speed: ArrayLike,
    radius: float,
    thickness: float,
    shear_modulus: ShearModulus,
    poisson_ratio: float | None = None,
    bulk_modulus: float | None = None,
) -> Floats:
    """Return the torque per unit length of a roller whose coating is a bed of springs: one strip of `winkler_torque`.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], > 0.
    angular_speed, radius, thickness, shear_modulus, poisson_ratio, bulk_modulus
        The same as in `winkler_torque`.

    Returns
    -------
    float or ndarray
        Torque T per unit length [N m/m].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    K. L. Johnson, Contact Mechanics, section 9.4.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> foam = StandardLinearSolid(instantaneous_modulus=6e5, relaxed_modulus=3e5, relaxation_time=0.01)
    >>> torque = winkler_torque_line(
    ...     load=1e3, angular_speed=2.0, radius=50e-3, thickness=0.5e-3, shear_modulus=foam, poisson_ratio=0.2
    ... )
    >>> f"{torque:.3f} N m/m"
    '0.466 N m/m'
    """
    size, h = as_positive("radius", radius, "m"), as_positive("thickness", thickness, "m")
    springs = _springs(shear_modulus, poisson_ratio, bulk_modulus)
    forces, speeds = positives("load", load, "N/m"), positives("angular_speed", angular_speed, "rad/s")

    def torque(force: float, speed: float) -> float:
        # The load grows between a² (dashpots) and a³ (springs).
        a = float(np.cbrt(1.5 * force * size * h / springs.relaxation.moduli.sum()))
        for _ in range(_STEPS):
            found, moment = (float(value[0]) for value in springs.strips(np.array([a]), speed * size))
            a *= float(np.cbrt(force * size * h / found))
        return moment * force / found

    return float_if_scalar(np.vectorize(torque, otypes=[np.float64])(forces, speeds))


@dataclass(frozen=True, slots=True)
class _Springs:
    """Bed of springs and dashpots that represents a coating, with its relaxation function M(t)."""

    relaxation: Relaxation

    def load_and_moment(self, a0: float, velocity: float) -> tuple[float, float]:
        """Return load and torque of a contact that begins at the radius a₀ [m], times R h."""
        nodes, weights = np.polynomial.legendre.leggauss(_STRIPS)
        psi = 0.25 * np.pi * (1.0 + nodes)  # z = a₀ sin ψ; both sides are identical
        a = a0 * np.cos(psi)
        load, moment = self.strips(a, velocity)
        widths = 0.5 * np.pi * weights * a
        return float(widths @ load), float(widths @ moment)

    def strips(self, a: NDArray[np.float64], velocity: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return loads and torques per unit width of strips that begin at x = a [m], times R h."""
        length = self._length(a, velocity)
        q, sum_of_q = (self._pressure(a, length, velocity, integrals=count) for count in (1, 2))
        return q, (a - length) * q + sum_of_q

    def _length(self, a: NDArray[np.float64], velocity: float) -> NDArray[np.float64]:
        """Return the length L of each strip [m], in [a, 2a].

        The compression grows until u = a and is 0 again at u = 2a, where springs with relaxation no longer exert
        pressure.
        """
        low, high = a, 2.0 * a
        for _ in range(_BISECTIONS):
            middle = 0.5 * (low + high)
            presses = self._pressure(a, middle, velocity) > 0.0
            low, high = np.where(presses, middle, low), np.where(presses, high, middle)
        return 0.5 * (low + high)

    def _pressure(
        self, a: NDArray[np.float64], u: NDArray[np.float64], velocity: float, *, integrals: int = 0
    ) -> NDArray[np.float64]:
        """Return R h p after the distance u, or its first or second integral over u."""
        moduli, times = self.relaxation.moduli, self.relaxation.times
        rate = 1.0 / (velocity * times[:, None])
        phi = _repeated_integrals(u, rate)
        n = 1 + integrals
        free = _repeated_integrals(u, np.zeros((1, 1)))
        dashpot = self.relaxation.viscosity * velocity * (a * free[n - 1][0] - free[n][0])
        return np.asarray(moduli @ (a * phi[n] - phi[n + 1]) + dashpot)


def _repeated_integrals(u: NDArray[np.float64], rate: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """Return exp(-u/l) and its first four integrals from 0, Φ_n = uⁿ (1/n! - y/(n+1)! + y²/(n+2)! - ...) at y = u/l."""
    y = u * rate
    small = np.minimum(y, 1.0)
    series = np.zeros_like(y)
    for k in range(20, -1, -1):  # φ₄ by Horner's rule
        series = (1.0 - small * series) / (k + 4.0)
    phi = [np.asarray(series / 6.0)]
    for factorial in (6.0, 2.0, 1.0, 1.0):
        phi.insert(0, 1.0 / factorial - small * phi[0])
    exact = [np.exp(-y)]
    divisor = np.maximum(y, 1.0)
    for factorial in (1.0, 1.0, 2.0, 6.0):
        exact.append((1.0 / factorial - exact[-1]) / divisor)
    return [u**n * np.where(y < 1.0, phi[n], exact[n]) for n in range(5)]


def _springs(shear_modulus: ShearModulus, poisson_ratio: float | None, bulk_modulus: float | None) -> _Springs:
    """Return M(t) = 2 (1-ν)/(1-2ν) G(t), or K + 4/3 G(t)."""
    require_one_volumetric_constant(poisson_ratio, bulk_modulus)
    shear = _relaxation(shear_modulus)
    factor, bulk = 4.0 / 3.0, 0.0
    if poisson_ratio is not None:
        nu = poisson(poisson_ratio, compressible=True)
        factor = 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu)
    else:
        bulk = as_positive("bulk_modulus", bulk_modulus, "Pa")
    moduli = factor * shear.moduli
    moduli[-1] += bulk
    return _Springs(Relaxation(moduli, shear.times, factor * shear.viscosity))


def _relaxation(modulus: ShearModulus) -> Relaxation:
    require_type("shear_modulus", modulus, ShearModulus)
    relaxation = relaxation_of(modulus)
    if relaxation is None:
        raise InvalidInput(
            "shear_modulus", "must be a modulus whose relaxation function is a sum of exponentials", shown(modulus)
        )
    return relaxation
