"""Rolling torque of a ball or crowned wheel whose contact is small enough to treat it as a half-space."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_not_negative, as_positive
from ._inputs import (
    Floats,
    complex_modulus,
    float_if_scalar,
    fraction,
    poisson,
    positives,
    require_one_volumetric_constant,
)
from .ellipse import hertz_ellipse

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    from ..materials.modulus_like import ShearModulusLike

__all__ = ["greenwood_tabor_torque", "persson_torque"]


def greenwood_tabor_torque(
    *,
    load: ArrayLike,
    radius: float,
    shear_modulus: float,
    poisson_ratio: float,
    loss_fraction: float = 1.0,
    crown_radius: float | None = None,
) -> Floats:
    """Return the torque of Greenwood and Tabor, T = α (3⁴ (1-ν) R P⁴ / (2¹⁵ G))^(1/3) = (3/16) α P a.

    The front half of Hertz's contact at rest resists with the moment 3Pa/16, of which the rear half returns the
    fraction 1 - α. The paper's equation (64) has α = 1. The formula does not contain the speed: determine α from a test
    of the material. Valid for a ≪ R, and on a coating for a ≪ h.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    radius : float
        Radius R [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5].
    loss_fraction : float, default 1
        Fraction α of the work that is dissipated [-], in [0, 1].
    crown_radius : float, optional
        Radius R_c across the path [m], > 0, of a crowned wheel; by default R. The length a is the semi-axis along the
        path of `hertz_ellipse`.

    Returns
    -------
    float or ndarray
        T [N m].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    J. A. Greenwood and D. Tabor, Proc. Phys. Soc. 71 (1958) 989-1001; equation (64) of Zéhil and Gavin, "Rolling
    resistance of a rigid sphere with viscoelastic coatings".

    Examples
    --------
    >>> torque = greenwood_tabor_torque(load=100.0, radius=20e-3, shear_modulus=3e6, poisson_ratio=0.5)
    >>> f"{torque * 1e3:.2f} mN m"
    '93.75 mN m'
    """
    alpha = fraction("loss_fraction", loss_fraction)
    contact = hertz_ellipse(
        load=load,
        radius=radius,
        crown_radius=radius if crown_radius is None else crown_radius,
        shear_modulus=shear_modulus,
        poisson_ratio=poisson_ratio,
    )
    return float_if_scalar(3.0 / 16.0 * alpha * np.asarray(load, dtype=np.float64) * contact.semi_axis_x)


def persson_torque(
    *,
    load: ArrayLike,
    angular_speed: ArrayLike,
    radius: float,
    shear_modulus: ShearModulusLike,
    poisson_ratio: float | None = None,
    bulk_modulus: float | None = None,
    frequency_factor: float = 1.0,
    crown_radius: float | None = None,
) -> Floats:
    """Return the torque of a solid sphere from the spectrum of Hertz's pressure, at any speed and for any material.

    T = R ∫ d²q/(2π)² (1-ν) (q_x/|q|) |p̂(q)|² G″(q_x V) / |G(q_x V)|² over all q, with V = ΩR and
    p̂(q) = 3P (sin qa - qa cos qa) / (qa)³. A pressure wave p̂ that moves at the speed V displaces the surface of a
    half-space by (1-ν) p̂ / (|q| G). The displacement lags behind the pressure, which dissipates the power
    q_x V (1-ν) G″ |p̂|² / (|q| |G|²). The sum over all waves is TΩ. The limit at low speed is `low_speed_torque`. Valid
    for a ≪ R, and on a coating for a ≪ h.

    The pressure is that of Hertz on a disk, with the radius for |G| at the frequency V/a, so the torque is exact to
    first order in the loss. The pressure of a real contact is larger at the front. The table lists the ratio of the
    solver's torque to this one on a nearly solid ball (core R/1000, ν = 1/2, a = R/20 at rest, standard linear solid
    with the relaxation time τ) for V τ/a from 0.01 to 30, with a at rest:

    ========= ====== =========== ====== ==============
    G(∞)/G(0) least  at V τ/a    most   at V τ/a
    ========= ====== =========== ====== ==============
    1.02      0.99   mesh error  1.01   mesh error
    2         0.98   30          1.13   0.3
    10        0.96   1 and more  1.40   0.1
    100       0.93   2 and more  1.53   0.01
    ========= ====== =========== ====== ==============

    The deficit at high speed grows with the contact, since the slowest waves of a ball are not those of a half-space:
    at a = R/10 the last row has 0.89.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    angular_speed : array_like
        Angular speed Ω [rad/s], > 0, of a shape that broadcasts with that of the load.
    radius : float
        Radius R [m], > 0.
    shear_modulus : ShearModulus or callable
        Shear modulus μ*(ω) [Pa], as in `Layer`. It is evaluated at 1e-12 to 1e5 times V/a, so a master curve must use
        ``extrapolation="hold"``.
    poisson_ratio, bulk_modulus : float
        Poisson's ratio ν [-], in (-1, 0.5], or bulk modulus K [Pa], > 0: exactly one of them, as in `Layer`.
    frequency_factor : float, default 1
        Factor c [-], ≥ 0: the contact radius is that for the modulus at the frequency c V/a, and for c = 0 that for the
        relaxed modulus.
    crown_radius : float, optional
        Radius R_c across the path [m], > 0, of a crowned wheel; by default R. The contact is then the ellipse of
        `hertz_ellipse`, a is its semi-axis along the path, and qa is replaced by √((q_x a)² + (q_z b)²).

    Returns
    -------
    float or ndarray
        Torque T [N m], with a relative numerical error below 1e-5, or below 1e-4 for V τ/a above 1e3.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    B. N. J. Persson, Eur. Phys. J. E 33 (2010) 327-333, whose E_eff = E/(1-ν²) is 2G/(1-ν).

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> torque = persson_torque(load=10.0, angular_speed=1.0, radius=20e-3, shear_modulus=rubber, poisson_ratio=0.5)
    >>> f"{torque * 1e3:.2f} mN m"
    '2.86 mN m'
    """
    size, factor = as_positive("radius", radius, "m"), as_not_negative("frequency_factor", frequency_factor)
    across = size if crown_radius is None else as_positive("crown_radius", crown_radius, "m")
    compliance = _half_space_compliance(shear_modulus, poisson_ratio, bulk_modulus)
    # Reference contact for a unit load and 1/E* = 1. All other contacts have the same aspect ratio.
    unit = hertz_ellipse(load=1.0, radius=size, crown_radius=across, shear_modulus=1.0, poisson_ratio=0.5)
    slender = float(unit.semi_axis_x / unit.semi_axis_z)
    frequencies, weights = _spectrum(slender)

    def torque(force: float, speed: float) -> float:
        a = _semi_axis(compliance, force, speed, size, factor, float(unit.semi_axis_x) ** 3)
        loss = -compliance(speed * size / a * frequencies).imag
        return float(size * slender * (force / (np.pi * a)) ** 2 * (weights @ loss))

    forces, speeds = positives("load", load, "N"), positives("angular_speed", angular_speed, "rad/s")
    return float_if_scalar(np.vectorize(torque, otypes=[np.float64])(forces, speeds))


def _half_space_compliance(
    shear_modulus: ShearModulusLike, poisson_ratio: float | None, bulk_modulus: float | None
) -> Callable[[ArrayLike], NDArray[np.complex128]]:
    """Return (1-ν*)/G* [1/Pa] as a function of ω. A pressure wave p causes the displacement (1-ν*)/G* p/|q|."""
    require_one_volumetric_constant(poisson_ratio, bulk_modulus)
    if bulk_modulus is None:
        nu = poisson(poisson_ratio)
        return lambda omega: (1.0 - nu) / complex_modulus(shear_modulus, omega)
    bulk = as_positive("bulk_modulus", bulk_modulus, "Pa")

    def compliance(omega: ArrayLike) -> NDArray[np.complex128]:
        g = complex_modulus(shear_modulus, omega)
        return (3.0 * bulk + 4.0 * g) / (2.0 * g * (3.0 * bulk + g))

    return compliance


def _semi_axis(
    compliance: Callable[[ArrayLike], NDArray[np.complex128]],
    load: float,
    speed: float,
    radius: float,
    factor: float,
    unit_cube: float,
) -> float:
    """Solve a³ = a₁³ P |S(c V/a)|/S₁ for a, with a₁ for a unit load and S₁ = 1/2. For a ball, a₁³ = 3R/16.

    The modulus of a material that relaxes grows at most in proportion to ω, so each step divides the relative error by
    at least three.
    """
    a = radius
    for _ in range(40):
        a = float(np.cbrt(2.0 * unit_cube * load * np.abs(compliance(factor * speed * radius / a))))
    return a


@cache
def _spectrum(slender: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return nodes and weights of ∫∫ f(x) x c(φ) L(x cosφ) dφ dx ≈ Σ w_j L(s_j), with f = |p̂|²/P² at x = qa.

    The integral extends over a quarter plane. c is q_x/|q| = cosφ/√(cos²φ + (a/b)² sin²φ), with φ in the plane in which
    the ellipse is a circle. With cosφ = sech t the trapezoidal rule in t converges exponentially. Beyond x = 20π, f is
    replaced by its mean over an oscillation.
    """
    edges = [*np.geomspace(1e-5, np.pi, 15), *np.pi * np.arange(2, 20), *np.geomspace(20 * np.pi, 1e5, 9)]
    x, dx = _gauss_panels(edges)
    exact = 9.0 * ((np.sin(x) - x * np.cos(x)) / x**3) ** 2
    f = np.where(x < 20 * np.pi, exact, 4.5 * (x**-4 + x**-6))
    step = 0.5 / max(1.0, slender)  # c has its poles at sinh t = ±i b/a
    t = np.arange(0.0, 12.5, step)
    cosine = 1.0 / np.cosh(t)
    dphi_cosine = step * cosine**2 / np.hypot(cosine, slender * np.tanh(t))
    dphi_cosine[0] *= 0.5
    return np.outer(x, cosine).ravel(), np.outer(f * x * dx, dphi_cosine).ravel()


def _gauss_panels(edges: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return nodes and weights of Gauss's rule with eight points on each panel."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    ends = np.asarray(edges, dtype=np.float64)
    half = 0.5 * np.diff(ends)[:, None]
    return (ends[:-1, None] + half * (1.0 + nodes)).ravel(), (half * weights).ravel()
