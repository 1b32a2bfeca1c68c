"""Rolling at low speed, where the torque is proportional to speed: T = P Ω R t, with a time t of the material."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_not_negative, as_positive
from .._support.errors import InvalidInput
from ._inputs import Floats, complex_modulus, float_if_scalar, poisson, positives

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..materials.modulus_like import ShearModulusLike

__all__ = ["brilliantov_poschel_time", "loss_time", "low_speed_torque", "sphere_loss_time"]

#: Frequencies [rad/s] at which a modulus has its low-frequency limit: far below those of any material in use.
_AT_REST = np.array([1e-12, 1e-9])


def low_speed_torque(*, load: ArrayLike, angular_speed: ArrayLike, radius: float, loss_time: float) -> Floats:
    """Return the resisting torque of slow rolling, T = P Ω R t.

    The formula holds for any load, thickness and number of layers, as long as the surface compliance at small ω is a
    real function times one factor 1 - iωt. The dissipated power is then Ω² t ∫ p (-∂²u/∂φ²) dA. The surface follows the
    plane wherever p is not 0, so -∂²u/∂φ² = R, and the integral is P R for any shape of the contact.

    Valid without friction and inertia, for Ω R t ≪ a with the contact radius a, and with the radial compliance. (With
    the vertical compliance the relative difference is of the order of the strain.) The limit is approached slowly: for
    a solid sphere of a standard linear solid whose relaxed modulus is half of its instantaneous modulus, the torque is
    10 % lower at Ω R t = 0.05 a.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    angular_speed : array_like
        Angular speed Ω [rad/s], > 0.
    radius : float
        Outer radius R [m], > 0.
    loss_time : float
        Time t [s], ≥ 0. For a coating: the `loss_time` that all layers share, each with a real Poisson's ratio. For a
        solid sphere whose bulk and shear have different loss factors: `sphere_loss_time`.

    Returns
    -------
    float or ndarray
        Resisting torque T [N m].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    docs/theory/normal-contact.md; for spheres N. V. Brilliantov and T. Pöschel, Europhys. Lett. 42 (1998) 511-516.

    Examples
    --------
    >>> low_speed_torque(load=100.0, angular_speed=[1e-3, 2e-3], radius=21e-3, loss_time=0.125)
    array([0.0002625, 0.000525 ])
    """
    force, speed = positives("load", load, "N"), positives("angular_speed", angular_speed, "rad/s")
    return float_if_scalar(
        force * speed * as_positive("radius", radius, "m") * as_not_negative("loss_time", loss_time, "s")
    )


def loss_time(shear_modulus: ShearModulusLike) -> float:
    """Return the loss time t of a material at rest, the limit of G″(ω) / (ω G′(ω)) for ω → 0.

    The loss time is Σ g_k τ_k / g_∞ for a Prony series, η/G for a Kelvin-Voigt solid, and 0 without loss.

    Parameters
    ----------
    shear_modulus : ShearModulus or callable
        Shear modulus μ*(ω) [Pa], as in `Layer`.

    Returns
    -------
    float
        Loss time t [s], ≥ 0.

    Raises
    ------
    TypeError
        If `shear_modulus` is not a modulus.
    ValueError
        If the limit does not exist, as for a fractional solid of an order below 1, or for a master curve that does not
        extend to ω = 0.

    References
    ----------
    docs/theory/normal-contact.md.

    Examples
    --------
    >>> from viscoroll import Prony
    >>> series = Prony(instantaneous_modulus=6e6, weights=[0.3, 0.2], relaxation_times=[0.1, 1.0])
    >>> f"{loss_time(series):.3f} s"
    '0.460 s'
    """
    modulus = complex_modulus(shear_modulus, _AT_REST)
    slowest, slow = (modulus.imag / modulus.real / _AT_REST).tolist()
    if abs(slowest - slow) > 1e-6 * slow:
        raise InvalidInput(
            "shear_modulus",
            "must have a loss modulus proportional to frequency near 0 rad/s",
            f"G''/(ω G') = {slowest:g} s at {_AT_REST[0]:g} rad/s and {slow:g} s at {_AT_REST[1]:g} rad/s",
        )
    return float(slow)


def sphere_loss_time(
    *, shear_modulus: float, poisson_ratio: float, shear_viscosity: float, bulk_viscosity: float = 0.0
) -> float:
    """Return the loss time t of a solid Kelvin-Voigt sphere with losses in shear and in bulk.

    t = (1+ν)/(Y (1-ν)) · [(4/3) (1-ν+ν²) η_s + (1-2ν)² η_b] with Young's modulus Y = 2G (1+ν).

    This is -d/dω of the phase of the half-space compliance (1-ν*)/G* = (3K*+4G*) / (2G* (3K*+G*)) at ω = 0, with
    G* = G + iωη_s and K* = K + iωη_b. It equals η_s/G at ν = 1/2, and if both viscosities have the same time,
    η_s/G = η_b/K. Valid if the contact radius is well below the radius of the sphere, or the thickness of a coating.

    Parameters
    ----------
    shear_modulus : float
        Shear modulus G at rest [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν at rest [-], in (-1, 0.5].
    shear_viscosity : float
        Shear viscosity η_s [Pa s], ≥ 0; for any material, `loss_time` times G.
    bulk_viscosity : float, default 0
        Bulk viscosity η_b [Pa s], ≥ 0.

    Returns
    -------
    float
        Loss time t [s], for `low_speed_torque`.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    See Also
    --------
    brilliantov_poschel_time : the coefficient of 1998, of which this is the correction.

    References
    ----------
    D. S. Goldobin, E. A. Susloparov, A. V. Pimenova and N. V. Brilliantov, Eur. Phys. J. E 38 (2015) 55, for the force
    between colliding spheres, which has the same coefficient.

    Examples
    --------
    >>> sphere_loss_time(shear_modulus=1e6, poisson_ratio=0.5, shear_viscosity=1e3)
    0.001
    """
    modulus, nu = as_positive("shear_modulus", shear_modulus, "Pa"), poisson(poisson_ratio)
    shear = 4.0 / 3.0 * (1.0 - nu + nu**2) * as_not_negative("shear_viscosity", shear_viscosity, "Pa s")
    bulk = (1.0 - 2.0 * nu) ** 2 * as_not_negative("bulk_viscosity", bulk_viscosity, "Pa s")
    return (shear + bulk) / (2.0 * modulus * (1.0 - nu))


def brilliantov_poschel_time(
    *, shear_modulus: float, poisson_ratio: float, shear_viscosity: float, bulk_viscosity: float = 0.0
) -> float:
    """Return the coefficient of Brilliantov and Pöschel (1998) as printed; `sphere_loss_time` corrects it.

    t = (1/3) (3η₂-η₁)²/(3η₂+2η₁) · (1-ν²)(1-2ν)/(Y ν²) with η₁ = 2η_s and η₂ = η_b.

    Zheng et al. (2011) found an error in a change of coordinates in its derivation. The coefficient is correct if both
    viscosities have the same time, η_s/G = η_b/K. Otherwise it vanishes at ν = 1/2 for any shear viscosity and at
    η₁ = 3η₂, and it is unbounded for ν → 0. With η_b = 0 it is 18, 0.69 and 0.15 times the correct one at ν = 0.1, 0.3
    and 0.4.

    Parameters
    ----------
    shear_modulus : float
        Shear modulus G at rest [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν at rest [-], in (-1, 0.5], not 0.
    shear_viscosity : float
        Shear viscosity η_s [Pa s], > 0.
    bulk_viscosity : float, default 0
        Bulk viscosity η_b [Pa s], ≥ 0.

    Returns
    -------
    float
        Coefficient t [s], for `low_speed_torque`.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    N. V. Brilliantov and T. Pöschel, Europhys. Lett. 42 (1998) 511-516; its error: Zheng et al. (2011), as reported in
    the introduction of G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings".

    Examples
    --------
    >>> brilliantov_poschel_time(shear_modulus=1e6, poisson_ratio=0.5, shear_viscosity=1e3)
    0.0
    """
    modulus, nu = as_positive("shear_modulus", shear_modulus, "Pa"), poisson(poisson_ratio)
    if nu == 0.0:
        raise InvalidInput("poisson_ratio", "must be in (-1, 0.5] and not 0, where the coefficient is infinite", "0")
    eta1 = 2.0 * as_positive("shear_viscosity", shear_viscosity, "Pa s")
    eta2 = as_not_negative("bulk_viscosity", bulk_viscosity, "Pa s")
    viscosity = (3.0 * eta2 - eta1) ** 2 / (3.0 * eta2 + 2.0 * eta1)
    return viscosity * (1.0 - nu) * (1.0 - 2.0 * nu) / (6.0 * modulus * nu**2)
