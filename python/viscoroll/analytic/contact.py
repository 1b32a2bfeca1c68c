"""Point contacts at rest between a rigid plane and an elastic or coated ball: thick and thin limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_positive
from ._at_rest import PressureBell, load_and_sizes
from ._inputs import Floats, float_if_scalar, poisson, positives

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["PointContact", "hertz", "thin_compressible_layer", "thin_incompressible_layer"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class PointContact(PressureBell):
    """Contact on a disk, with the pressure p₀ (1 - r²/a²)ᵏ.

    Attributes
    ----------
    radius : float or ndarray
        Contact radius a [m].
    approach : float or ndarray
        Approach d of ball and plane [m], the `penetration` of a result.
    max_pressure : float or ndarray
        Pressure p₀ at the center [Pa].
    exponent : float
        k [-]: 1/2 for Hertz, 1 for a thin compressible layer, 2 for a thin incompressible layer.
    """

    radius: Floats
    approach: Floats
    max_pressure: Floats
    exponent: float

    @property
    def reach(self) -> Floats:
        """Contact radius [m]."""
        return self.radius


def hertz(*, load: ArrayLike, radius: float, shear_modulus: float, poisson_ratio: float) -> PointContact:
    """Return the contact of a rigid plane with a solid elastic sphere: a³ = 3 (1-ν) P R / (8 G), d = a²/R.

    Valid without friction for a ≪ R, and on a coating for a ≪ h. The approach of an incompressible sphere is smaller
    than a²/R by a fraction proportional to a/R. By Lamb's solution for the exact sphere, the approach of a single plane
    relative to the mean displacement of the sphere is 6 % smaller at a/R = 0.1 and 3 % at 0.05. That of two opposite
    planes to the center is 2.9 and 1.4 % smaller. With `Curvature.PAPER`, the first two numbers are 4 and 2 %.

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

    Returns
    -------
    PointContact
        Contact with the exponent 1/2 and p₀ = 3P / (2πa²).

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, equations (4.22) to (4.24).

    Examples
    --------
    >>> contact = hertz(load=100.0, radius=20e-3, shear_modulus=3e6, poisson_ratio=0.5)
    >>> f"{contact.radius * 1e3:.3f} mm"
    '5.000 mm'
    """
    load_values, radius_value = positives("load", load, "N"), as_positive("radius", radius, "m")
    stiffness = as_positive("shear_modulus", shear_modulus, "Pa")
    a = np.cbrt(3.0 * (1.0 - poisson(poisson_ratio)) * load_values * radius_value / (8.0 * stiffness))
    return _on_disk(load_values, a, approach=a**2 / radius_value, exponent=0.5)


def thin_compressible_layer(
    *, load: ArrayLike, radius: float, thickness: float, shear_modulus: float, poisson_ratio: float
) -> PointContact:
    """Return the contact on a thin compressible coating, a bed of springs: P = π M a⁴ / (4 R h), d = a²/(2R).

    M = λ + 2μ = 2 G (1-ν)/(1-2ν) is the modulus of a layer that cannot expand sideways. Valid for a ≫ h, and only if
    the layer deforms mainly by its change of volume, (1-2ν) a² ≫ h². The formula is the leading term in h/a. The exact
    load at given a is larger by the fraction s h/a, so the radius at given load is smaller by the fraction s h/(4a),
    with s from the exact layer:

    == ==== ==== ==== ==== ===== ==== ==== =====
    ν  0    0.1  0.2  0.3  0.4   0.45 0.48 0.49
    s  0.73 0.76 0.72 0.49 -0.45 -2.2 -6.1 -10.8
    == ==== ==== ==== ==== ===== ==== ==== =====

    Nearly incompressible layers must be very thin: an accuracy of 5 % in the radius requires a = 10 h at ν = 0.45, and
    50 h at 0.49.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    radius : float
        Outer radius R [m], > 0.
    thickness : float
        Thickness h of the coating [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5).

    Returns
    -------
    PointContact
        Contact with the exponent 1 and p₀ = M a² / (2 R h).

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    Johnson, Contact Mechanics, section 5.8 (plane strain); M. J. Jaffar, Int. J. Mech. Sci. 31 (1989) 229-235.

    Examples
    --------
    >>> contact = thin_compressible_layer(
    ...     load=100.0, radius=20e-3, thickness=0.1e-3, shear_modulus=3e6, poisson_ratio=0.3
    ... )
    >>> f"{contact.radius / 0.1e-3:.1f} thicknesses"
    '22.2 thicknesses'
    """
    load_values, radius_value, h = load_and_sizes(load, "N", radius, thickness)
    nu = poisson(poisson_ratio, compressible=True)
    confined_modulus = as_positive("shear_modulus", shear_modulus, "Pa") * 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu)
    a = (4.0 * load_values * radius_value * h / (np.pi * confined_modulus)) ** 0.25
    return _on_disk(load_values, a, approach=a**2 / (2.0 * radius_value), exponent=1.0)


def thin_incompressible_layer(
    *, load: ArrayLike, radius: float, thickness: float, shear_modulus: float
) -> PointContact:
    """Return the contact on a thin incompressible bonded coating without friction: P = π G a⁶ / (32 R h³), d = a²/(4R).

    The coating is squeezed out sideways, like a film that sticks to the core and slips on the plane: (h³/3G)
    ∇²p = -(d - r²/2R), with p = 0 and no flow at the edge. Valid for a ≫ h, but convergence is slow: at given a, the
    exact load is 2.2 times as large at a = 10 h, and larger by the fraction 8.8 h/a in the limit. The load at given d,
    2π G R² d³/h³, is much more accurate: 13 % below the exact one at a = 10 h, 4 % at 20 h.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    radius : float
        Outer radius R [m], > 0.
    thickness : float
        Thickness h of the coating [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.

    Returns
    -------
    PointContact
        Contact with the exponent 2 and p₀ = 3 G a⁴ / (32 R h³).

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    Johnson, Contact Mechanics, section 5.8 (plane strain); M. J. Jaffar, Int. J. Mech. Sci. 31 (1989) 229-235;
    J. R. Barber, Int. J. Mech. Sci. 32 (1990) 129-132.

    Examples
    --------
    >>> contact = thin_incompressible_layer(load=100.0, radius=20e-3, thickness=0.1e-3, shear_modulus=3e6)
    >>> f"{contact.radius / 0.1e-3:.1f} thicknesses"
    '13.8 thicknesses'
    """
    load_values, radius_value, h = load_and_sizes(load, "N", radius, thickness)
    stiffness = as_positive("shear_modulus", shear_modulus, "Pa")
    a = (32.0 * load_values * radius_value * h**3 / (np.pi * stiffness)) ** (1.0 / 6.0)
    return _on_disk(load_values, a, approach=a**2 / (4.0 * radius_value), exponent=2.0)


def _on_disk(
    load: NDArray[np.float64], a: NDArray[np.float64], *, approach: NDArray[np.float64], exponent: float
) -> PointContact:
    """Return a contact whose pressure p₀ (1 - r²/a²)ᵏ, with the integral π a² p₀ / (k+1), balances the load."""
    return PointContact(
        radius=float_if_scalar(a),
        approach=float_if_scalar(approach),
        max_pressure=float_if_scalar((exponent + 1.0) * load / (np.pi * a**2)),
        exponent=exponent,
    )
