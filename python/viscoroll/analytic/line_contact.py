"""Line contacts of rollers at rest in plane strain, thick and thin limits, and Carter's creep curve.

Loads are per unit length of the roller. If both bodies are curved, ``radius`` is the effective radius,
1/R = 1/R₁ + 1/R₂.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float_array, as_positive
from .._support.errors import InvalidInput
from ._at_rest import PressureBell, load_and_sizes
from ._inputs import Floats, float_if_scalar, poisson, positives

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "LineContact",
    "carter_force",
    "hertz_line",
    "thin_compressible_layer_line",
    "thin_incompressible_layer_line",
]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LineContact(PressureBell):
    """Contact on a strip, with the pressure p₀ (1 - x²/a²)ᵏ.

    Attributes
    ----------
    half_width : float or ndarray
        Half-width a [m].
    approach : float or ndarray or None
        Approach d of roller and plane [m]; None on a half-plane, where it is unbounded: ∫ dk/k diverges.
    max_pressure : float or ndarray
        Pressure p₀ in the middle [Pa].
    exponent : float
        k [-]: 1/2 for Hertz, 1 for a thin compressible layer, 2 for a thin incompressible layer.
    """

    half_width: Floats
    approach: Floats | None
    max_pressure: Floats
    exponent: float

    @property
    def reach(self) -> Floats:
        """Half-width [m]."""
        return self.half_width


def hertz_line(*, load: ArrayLike, radius: float, shear_modulus: float, poisson_ratio: float) -> LineContact:
    """Return the contact of a rigid cylinder and an elastic half-plane, or the reverse: a² = 2 (1-ν) P R / (π G).

    Valid without friction for a ≪ R. For two elastic bodies, add their compliances (1-ν)/G.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], > 0.
    radius : float
        Radius R [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5].

    Returns
    -------
    LineContact
        Contact with the exponent 1/2 and p₀ = 2P / (πa); its approach is None.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, equations (4.43) and (4.45).

    Examples
    --------
    >>> contact = hertz_line(load=5e3, radius=50e-3, shear_modulus=3e6, poisson_ratio=0.5)
    >>> f"{contact.half_width * 1e3:.3f} mm"
    '5.150 mm'
    """
    load_values, radius_value = positives("load", load, "N/m"), as_positive("radius", radius, "m")
    stiffness = as_positive("shear_modulus", shear_modulus, "Pa")
    a = np.sqrt(2.0 * (1.0 - poisson(poisson_ratio)) * load_values * radius_value / (np.pi * stiffness))
    return LineContact(
        half_width=float_if_scalar(a),
        approach=None,
        max_pressure=float_if_scalar(2.0 * load_values / (np.pi * a)),
        exponent=0.5,
    )


def thin_compressible_layer_line(
    *, load: ArrayLike, radius: float, thickness: float, shear_modulus: float, poisson_ratio: float
) -> LineContact:
    """Return the contact on a thin compressible coating, a bed of springs: P = 2 M a³ / (3 R h), d = a²/(2R).

    M = λ + 2μ = 2 G (1-ν)/(1-2ν). Valid for a ≫ h and (1-2ν) a² ≫ h², with errors of the order h/a.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], > 0.
    radius : float
        Radius R [m], > 0.
    thickness : float
        Thickness h of the coating [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5).

    Returns
    -------
    LineContact
        Contact with the exponent 1 and p₀ = M a² / (2 R h).

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    Johnson, Contact Mechanics, section 5.8.

    Examples
    --------
    >>> contact = thin_compressible_layer_line(
    ...     load=5e3, radius=50e-3, thickness=0.5e-3, shear_modulus=3e6, poisson_ratio=0.3
    ... )
    >>> f"{contact.half_width * 1e3:.3f} mm"
    '2.614 mm'
    """
    load_values, radius_value, h = load_and_sizes(load, "N/m", radius, thickness)
    nu = poisson(poisson_ratio, compressible=True)
    confined_modulus = as_positive("shear_modulus", shear_modulus, "Pa") * 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu)
    a = np.cbrt(1.5 * load_values * radius_value * h / confined_modulus)
    return LineContact(
        half_width=float_if_scalar(a),
        approach=float_if_scalar(a**2 / (2.0 * radius_value)),
        max_pressure=float_if_scalar(0.75 * load_values / a),
        exponent=1.0,
    )


def thin_incompressible_layer_line(
    *, load: ArrayLike, radius: float, thickness: float, shear_modulus: float
) -> LineContact:
    """Return the contact on a thin incompressible bonded coating without friction: P = 2 G a⁵ / (15 R h³), d = a²/(6R).

    The coating is squeezed out sideways: (h³/3G) p'' = -(d - x²/2R), with p = 0 and no flow at the edge. Valid for
    a ≫ h, but convergence is slow: errors are of the order h/a.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], > 0.
    radius : float
        Radius R [m], > 0.
    thickness : float
        Thickness h of the coating [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.

    Returns
    -------
    LineContact
        Contact with the exponent 2 and p₀ = G a⁴ / (8 R h³).

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    Johnson, Contact Mechanics, section 5.8.

    Examples
    --------
    >>> contact = thin_incompressible_layer_line(load=5e3, radius=50e-3, thickness=0.5e-3, shear_modulus=3e6)
    >>> f"{contact.half_width * 1e3:.3f} mm"
    '2.391 mm'
    """
    load_values, radius_value, h = load_and_sizes(load, "N/m", radius, thickness)
    stiffness = as_positive("shear_modulus", shear_modulus, "Pa")
    a = (7.5 * load_values * radius_value * h**3 / stiffness) ** 0.2
    return LineContact(
        half_width=float_if_scalar(a),
        approach=float_if_scalar(a**2 / (6.0 * radius_value)),
        max_pressure=float_if_scalar(stiffness * a**4 / (8.0 * radius_value * h**3)),
        exponent=2.0,
    )


def carter_force(
    *,
    creepage: ArrayLike,
    load: ArrayLike,
    radius: float,
    friction: float,
    shear_modulus: float,
    poisson_ratio: float,
) -> Floats:
    """Return the traction of a creeping roller, F = μ P (1 - (1 - |c| R / (μ a))²), or μ P for |c| ≥ μ a / R.

    Carter's curve applies to elastic rollers on which the pressure causes no slip: an incompressible body on a rigid
    one, or two identical bodies. a is Hertz's half-width. A zone behind the leading edge sticks.

    Parameters
    ----------
    creepage : array_like
        Creepage c [-], of either sign.
    load : array_like
        Load P per unit length [N/m], > 0, of a shape that broadcasts with that of the creepage.
    radius : float
        Radius R [m], > 0.
    friction : float
        Coefficient of friction μ [-], > 0.
    shear_modulus, poisson_ratio : float
        Shear modulus G [Pa], > 0, and Poisson's ratio ν [-], in (-1, 0.5], the same as in `hertz_line`.

    Returns
    -------
    float or ndarray
        Traction F per unit length [N/m], with the sign of the creepage.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    F. W. Carter, Proc. R. Soc. Lond. A 112 (1926) 151-157; Johnson, Contact Mechanics, equation (8.20).

    Examples
    --------
    >>> steel = {"load": 1e5, "radius": 0.5, "friction": 0.3, "shear_modulus": 8e10, "poisson_ratio": 0.5}
    >>> f"{carter_force(creepage=1e-4, **steel):.0f} N/m"
    '18231 N/m'
    """
    coefficient = as_positive("friction", friction, "")
    contact = hertz_line(load=load, radius=radius, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio)
    creep = as_float_array("creepage", creepage)
    if not np.isfinite(creep).all():
        raise InvalidInput("creepage", "must be finite", f"{creep[~np.isfinite(creep)][0]:g}")
    sliding = np.minimum(np.abs(creep) * radius / (coefficient * np.asarray(contact.half_width)), 1.0)
    force = coefficient * positives("load", load, "N/m") * (1.0 - (1.0 - sliding) ** 2)
    return float_if_scalar(np.copysign(force, creep))
