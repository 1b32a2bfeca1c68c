"""Rolling of a rigid cylinder on a viscoelastic half-plane with adhesion of short range."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_positive, require_type
from .._support.extras import extra
from ..materials import StandardLinearSolid
from ._inputs import Floats, float_if_scalar, poisson, positives
from .adhesion import finite_loads, require_contact

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["AdhesiveRollingContact", "adhesive_hunter"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class AdhesiveRollingContact:
    """Rolling contact on a strip with adhesion.

    Attributes
    ----------
    half_width : float or ndarray
        Half-width a of the contact [m].
    center : float or ndarray
        Distance of the middle of the contact ahead of the lowest point [m].
    moment : float or ndarray
        Moment M = Σ x p per unit length [N m/m], the rolling resistance times R.
    pull_off : float or ndarray
        Smallest load that keeps the bodies in contact while they roll, negative [N/m].
    """

    half_width: Floats
    center: Floats
    moment: Floats
    pull_off: Floats


def adhesive_hunter(
    *,
    load: ArrayLike,
    speed: ArrayLike,
    radius: float,
    shear_modulus: StandardLinearSolid,
    poisson_ratio: float,
    work: float,
) -> AdhesiveRollingContact:
    """Solve rolling of a rigid cylinder on a half-plane of a standard linear solid with adhesion, or the reverse.

    This is Hunter's problem, see `hunter`, with the stress intensity √(2w E₀*) at both edges, E₀* = 2G₀/(1-ν): material
    passes an edge of vanishing length faster than it relaxes. With ξ = -x, t = (ξ - ξ₀)/a, l = V τ, κ = a/l,
    β = a/(f l), f = G₀/G_∞, J_∞ = (1-ν)/(2G_∞), J₀ = J_∞/f, Îₙ = exp(-κ) Iₙ(κ), and one unknown Y,

        p √(1-t²) = Σ bₙ Tₙ(t),  b₀ = P/(π a),
        bₙ = -(ξ₀ + (f-1) l)/(2J_∞R) δₙ₁ - a/(4J_∞R) δₙ₂ + (-1)ⁿ (Y/J₀) (n/κ) Îₙ  for n ≥ 1,
        Σ bₙ = Σ (-1)ⁿ bₙ = -√(2w/(π a J₀)),
        2β (J_∞-J₀) Σ (-1)ⁿ bₙ ∫ exp(β - β cosh u - n u) du = Y - ((f-1)/f) (ξ₀ - a - l)/R,

    with sums over n ≥ 0 and the integral over u > 0. The equations are linear in P, ξ₀ and Y for a given a. The moment
    is M = -ξ₀P - π a² b₁/2. Without adhesion, this is Hunter's solution; in slow rolling, M → R w (f - 1/f) + the
    moment without adhesion.

    Valid without friction and inertia, for a ≪ R, and where the attraction has a shorter range than `V` τ.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], at least the pull-off load.
    speed : array_like
        Speed V at which the material passes the contact [m/s], > 0, of a shape that broadcasts with that of the load.
    radius : float
        Radius R [m], > 0.
    shear_modulus : StandardLinearSolid
        Material with G₀, G_∞ and τ.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5].
    work : float
        Work of adhesion w [J/m²], > 0.

    Returns
    -------
    AdhesiveRollingContact
        Half-width, position, moment and pull-off load. If two states balance a load, those of the larger contact.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.
    ImportError
        If SciPy is missing (the extra `viscoroll[studies]`).

    References
    ----------
    docs/theory/adhesion.md.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> roller = {"radius": 50e-3, "shear_modulus": rubber, "poisson_ratio": 0.5}
    >>> contact = adhesive_hunter(load=5e3, speed=0.05, work=1.0, **roller)
    >>> f"{contact.moment:.3f} N m/m, {contact.half_width * 1e3:.3f} mm"
    '4.295 N m/m, 4.077 mm'
    """
    force, velocity = np.broadcast_arrays(finite_loads(load), positives("speed", speed, "m/s"))
    size, nu = as_positive("radius", radius, "m"), poisson(poisson_ratio)
    energy = as_positive("work", work, "J/m²")
    require_type("shear_modulus", shear_modulus, StandardLinearSolid)
    values = np.empty((4, *force.shape))
    for index in np.ndindex(force.shape):
        strip = _Strip(
            radius=size,
            compliance=0.5 * (1.0 - nu) / shear_modulus.relaxed_modulus,
            ratio=shear_modulus.instantaneous_modulus / shear_modulus.relaxed_modulus,
            length=float(velocity[index]) * shear_modulus.relaxation_time,
            work=energy,
        )
        values[(slice(None), *index)] = strip.at_load(float(force[index]))
    return AdhesiveRollingContact(
        half_width=float_if_scalar(values[0]),
        center=float_if_scalar(values[1]),
        moment=float_if_scalar(values[2]),
        pull_off=float_if_scalar(values[3]),
    )


@dataclass(frozen=True, slots=True)
class _Strip:
    """Half-plane of relaxed compliance J_∞ [1/Pa], and the conditions of rolling."""

    radius: float
    compliance: float
    ratio: float
    length: float
    work: float

    def at_load(self, load: float) -> tuple[float, float, float, float]:
        """Return half-width, center ahead of the lowest point, moment and pull-off load."""
        with extra("studies"):
            from scipy.optimize import brentq, minimize_scalar

        # Scales of the half-width at pull-off: those of elastic contacts with G₀ and w, and with G_∞ and f w.
        elastic = np.cbrt(2.0 * self.work * self.radius**2 * self.compliance / np.pi)
        bounds = np.log([0.2 * elastic / np.cbrt(self.ratio), 5.0 * elastic * np.cbrt(self.ratio)])
        least = minimize_scalar(
            lambda log: self.at(np.exp(log))[0], bounds=bounds, method="bounded", options={"xatol": 1e-9}
        )
        low, pull_off = float(np.exp(least.x)), float(least.fun)
        require_contact(np.asarray(load), pull_off, "N/m")
        high = 2.0 * low
        while self.at(high)[0] < load:
            high *= 2.0
        a = low if load <= pull_off else brentq(lambda a: self.at(a)[0] - load, low, high, rtol=1e-14)
        _, center, moment = self.at(a)
        return a, center, moment, pull_off

    def at(self, a: float) -> tuple[float, float, float]:
        """Return load, center ahead of the lowest point, and moment of a contact of half-width a."""
        with extra("studies"):
            from scipy.special import ive

        relaxed, instantaneous = self.compliance, self.compliance / self.ratio
        per_length, delayed = a / self.length, (self.ratio - 1.0) * self.length
        orders = np.arange(int(np.sqrt(80.0 * per_length)) + 60)
        bessel = ive(orders, per_length)
        edge = -np.sqrt(2.0 * self.work / (np.pi * a * instantaneous))
        # The coefficients are constant + Y linear. The two conditions at the edges, with the sums
        # Σ n Iₙ/κ = (I₀ + I₁)/2 and Σ (-1)ⁿ n Iₙ/κ = (I₁ - I₀)/2 over n ≥ 1, determine P, and ξ₀ = -delayed - f R Y Î₀.
        constant = np.zeros(orders.size)
        constant[0] = a / (4.0 * relaxed * self.radius) + edge
        constant[2] = -a / (4.0 * relaxed * self.radius)
        linear = (-1.0) ** orders * orders * bessel / (per_length * instantaneous)
        linear[0] = -bessel[1] / (2.0 * instantaneous)
        linear[1] += bessel[0] / (2.0 * instantaneous)
        past = 2.0 * (relaxed - instantaneous) * _memory(orders, a / (self.ratio * self.length))
        lost = (self.ratio - 1.0) / self.ratio / self.radius
        shift = -self.ratio * self.radius * bessel[0]
        unknown = -(past @ constant - lost * (delayed + a + self.length)) / (past @ linear - 1.0 + lost * shift)
        coefficients = constant + unknown * linear
        position = shift * unknown - delayed
        load = np.pi * a * coefficients[0]
        return float(load), float(-position), float(-position * load - 0.5 * np.pi * a**2 * coefficients[1])


def _memory(orders: NDArray[np.int_], beta: float) -> NDArray[np.float64]:
    """Return β (-1)ⁿ ∫ exp(β - β cosh u - n u) du over u > 0, for all orders n."""
    # The double exponential rule resolves integrands of every width. The largest u is that at which exp underflows.
    nodes, spacing = np.linspace(-4.5, 6.0, 421, retstep=True)
    u = np.exp(nodes - np.exp(-nodes))
    weights = spacing * u * (1.0 + np.exp(-nodes)) * np.exp(-2.0 * beta * np.sinh(np.minimum(0.5 * u, 300.0)) ** 2)
    return np.asarray(beta * (-1.0) ** orders * (np.exp(-np.multiply.outer(orders, u)) @ weights))
