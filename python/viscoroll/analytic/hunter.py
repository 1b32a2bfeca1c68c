"""Hunter's solution for a rigid cylinder that rolls on a viscoelastic half-plane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float_array, as_positive, require_type
from .._support.extras import extra
from ..materials import StandardLinearSolid
from ._inputs import Floats, float_if_scalar, poisson, positives

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["HunterContact", "hunter"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class HunterContact:
    """Rolling contact on a strip.

    Attributes
    ----------
    half_width : float or ndarray
        Half-width a of the contact [m].
    center : float or ndarray
        Distance of the middle of the contact ahead of the lowest point [m].
    moment : float or ndarray
        Moment M = Σ x p per unit length [N m/m], the rolling resistance times R.
    load : float or ndarray
        Load P per unit length [N/m].
    relaxation_length : float or ndarray
        Distance l = V τ that the material travels in its relaxation time [m].
    chebyshev : tuple of float or ndarray
        Coefficients c₀, c₁ and c₂ of g √(1-t²) = c₀ + c₁ t + c₂ (2t²-1) [Pa], with g = p + l p', and t = -1 at the
        leading and 1 at the trailing edge.
    """

    half_width: Floats
    center: Floats
    moment: Floats
    load: Floats
    relaxation_length: Floats
    chebyshev: tuple[Floats, Floats, Floats]

    def pressure(self, x: ArrayLike) -> Floats:
        """Return the pressure p = ∫ g exp(-(ξ-s)/l) ds/l, integrated from the leading edge to the point ξ.

        Parameters
        ----------
        x : array_like
            Distance ahead of the lowest point [m], of a shape that broadcasts with that of the half-width.

        Returns
        -------
        float or ndarray
            p [Pa], 0 outside the contact.
        """
        per_length = np.asarray(self.half_width) / np.asarray(self.relaxation_length)
        t = (np.asarray(self.center) - as_float_array("x", x)) / np.asarray(self.half_width)
        inside = np.clip(t, -1.0, 1.0)
        # The substitution t = -cos θ removes the square-root singularities at both edges. Contributions from more than
        # 40 l ahead are below round-off.
        last, first = np.arccos(-inside), np.arccos(-np.maximum(inside - _RELAXATION_LENGTHS / per_length, -1.0))
        points, weights = np.polynomial.legendre.leggauss(_POINTS)
        angles = np.multiply.outer(0.5 * (points + 1.0), last - first) + first
        earlier = -np.cos(angles)
        c0, c1, c2 = (np.asarray(c) for c in self.chebyshev)
        traction = c0 + c1 * earlier + c2 * np.cos(2.0 * angles)
        integrand = traction * np.exp(per_length * (earlier - inside))
        return float_if_scalar(
            0.5 * per_length * (last - first) * np.tensordot(weights, integrand, axes=1) * (abs(t) < 1.0)
        )


#: Length of the integral in relaxation lengths, and number of Gauss points that integrate the exponential over it to
#: 1e-12.
_RELAXATION_LENGTHS, _POINTS = 40.0, 64


def hunter(
    *,
    load: ArrayLike,
    speed: ArrayLike,
    radius: float,
    shear_modulus: StandardLinearSolid,
    poisson_ratio: float,
) -> HunterContact:
    """Solve rolling of a rigid cylinder on a half-plane of a standard linear solid, or the reverse.

    Let ξ = -x be the coordinate along the motion of the material, l = V τ, f = G₀/G_∞, and w' the slope of the surface.
    The material law turns the integral equation of the half-plane into one for g = p + l p',

        w' + f l w'' = -(1-ν)/(π G_∞) ∫ g(s)/(ξ - s) ds,

    with w' = -ξ/R in the contact, |ξ - ξ₀| < a. So g is a sum of Chebyshev polynomials,
    g √(1-t²) = P/(π a) - G_∞ (c₁ t + a (2t² - 1)/2) / ((1-ν) R), with t = (ξ - ξ₀)/a and c₁ = ξ₀ + f l. Ahead of the
    contact, the slope follows by integration of the same equation with p = 0. Two conditions remain: the pressure is
    continuous at the trailing edge, and the slope at the leading edge. They contain the modified Bessel functions at
    a/l and a/(f l):

        P̂ I₀ - c₁ I₁ - (a/2) I₂ = 0,  P̂ K₀ + c₁ K₁ - (a/2) K₂ = 0,  P̂ = (1-ν) R P / (π a G_∞).

    Both are linear in P̂ and c₁ for a given a. The moment follows from ∫ ξ g = ∫ ξ p - l P.

    Valid without friction and inertia, for a ≪ R.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], > 0.
    speed : array_like
        Speed V at which the material passes the contact [m/s], > 0, of a shape that broadcasts with that of the load.
    radius : float
        Radius R [m], > 0.
    shear_modulus : StandardLinearSolid
        Material with G₀, G_∞ and τ.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5].

    Returns
    -------
    HunterContact
        Half-width, position, moment and pressure.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.
    ImportError
        If SciPy is missing (the extra `viscoroll[studies]`).

    References
    ----------
    S. C. Hunter, "The rolling contact of a rigid cylinder with a viscoelastic half space", J. Appl. Mech. 28 (1961)
    611-617; the derivation above.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> contact = hunter(load=5e3, speed=0.05, radius=50e-3, shear_modulus=rubber, poisson_ratio=0.5)
    >>> f"{contact.moment:.3f} N m/m, {contact.half_width * 1e3:.3f} mm"
    '4.267 N m/m, 3.791 mm'
    >>> f"{contact.pressure(0.0) / 1e6:.4f} MPa"
    '0.7982 MPa'
    """
    force, velocity = np.broadcast_arrays(positives("load", load, "N/m"), positives("speed", speed, "m/s"))
    size, nu = as_positive("radius", radius, "m"), poisson(poisson_ratio)
    require_type("shear_modulus", shear_modulus, StandardLinearSolid)
    solid = _Solid(
        stiffness=np.pi * shear_modulus.relaxed_modulus / ((1.0 - nu) * size),
        ratio=shear_modulus.instantaneous_modulus / shear_modulus.relaxed_modulus,
    )
    length = velocity * shear_modulus.relaxation_time
    a = solid.half_width(force, length)
    shift = solid.shift(a, length)
    # ξ₀, and moments of p and g: -M = (l + ξ₀) P - (stiffness / 2) a² c₁.
    center = shift - solid.ratio * length
    moment = 0.5 * solid.stiffness * a**2 * shift - (length + center) * force
    pressures = (force / (np.pi * a), -solid.stiffness / np.pi * shift, -0.5 * solid.stiffness / np.pi * a)
    return HunterContact(
        half_width=float_if_scalar(a),
        center=float_if_scalar(-center),
        moment=float_if_scalar(moment),
        load=float_if_scalar(force),
        relaxation_length=float_if_scalar(length),
        chebyshev=(float_if_scalar(pressures[0]), float_if_scalar(pressures[1]), float_if_scalar(pressures[2])),
    )


@dataclass(frozen=True, slots=True)
class _Solid:
    """Stiffness π G_∞ / ((1-ν) R) [Pa/m] and ratio G₀/G_∞ of the half-plane."""

    stiffness: float
    ratio: float

    def shift(self, a: NDArray[np.float64], length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return c₁ [m] for contacts of half-width a [m]."""
        i0, i1, i2, k0, k1, k2 = self._bessel(a, length)
        return np.asarray(0.5 * a * (k2 * i0 - k0 * i2) / (k1 * i0 + k0 * i1))

    def load(self, a: NDArray[np.float64], length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the load P [N/m] for contacts of half-width a [m]."""
        i0, i1, i2, *_ = self._bessel(a, length)
        return np.asarray(self.stiffness * a * (self.shift(a, length) * i1 + 0.5 * a * i2) / i0)

    def half_width(self, force: NDArray[np.float64], length: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the half-width [m], by bisection between those of elastic contacts with G₀ and G_∞."""
        high = np.sqrt(2.0 * force / self.stiffness)
        low = high / np.sqrt(self.ratio)
        for _ in range(60):
            middle = 0.5 * (low + high)
            short = self.load(middle, length) < force
            low, high = np.where(short, middle, low), np.where(short, high, middle)
        return np.asarray(0.5 * (low + high))

    def _bessel(self, a: NDArray[np.float64], length: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        """Return I₀, I₁, I₂ at a/l and K₀, K₁, K₂ at a/(f l), without their exponential factors, which cancel."""
        with extra("studies"):
            from scipy.special import ive, kve

        return [ive(n, a / length) for n in range(3)] + [kve(n, a / (self.ratio * length)) for n in range(3)]
