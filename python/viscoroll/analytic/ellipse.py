"""Hertz's contact of bodies with different curvatures along and across the path, such as crowned wheels."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_positive
from ._inputs import Floats, float_if_scalar, poisson, positives

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["EllipticContact", "axis_ratio", "hertz_ellipse"]

#: Bisections of ln(b/a), to double precision.
_BISECTIONS = 64


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class EllipticContact:
    """Contact on an ellipse, with the pressure p₀ √(1 - x²/a² - z²/b²).

    Attributes
    ----------
    semi_axis_x, semi_axis_z : float or ndarray
        Semi-axes a along the path and b across it [m].
    approach : float or ndarray
        Approach d of wheel and plane [m].
    max_pressure : float or ndarray
        Pressure p₀ at the center [Pa].
    """

    semi_axis_x: Floats
    semi_axis_z: Floats
    approach: Floats
    max_pressure: Floats

    @property
    def reach(self) -> Floats:
        """Semi-axis along the path [m]."""
        return self.semi_axis_x

    def pressure(self, x: ArrayLike, z: ArrayLike) -> Floats:
        """Return the pressure at a point [Pa], 0 outside the contact.

        Parameters
        ----------
        x, z : array_like
            Coordinates along the path and across it, from the center [m].

        Returns
        -------
        float or ndarray
            p(x, z) [Pa].
        """
        along, across = (
            np.asarray(coordinate, dtype=np.float64) / axis
            for coordinate, axis in ((x, self.semi_axis_x), (z, self.semi_axis_z))
        )
        return float_if_scalar(self.max_pressure * np.sqrt(np.clip(1.0 - along**2 - across**2, 0.0, None)))


def hertz_ellipse(
    *, load: ArrayLike, radius: float, crown_radius: float, shear_modulus: float, poisson_ratio: float
) -> EllipticContact:
    """Return the contact of a rigid plane with a solid elastic body that has two radii of curvature.

    Valid without friction if the semi-axes are well below both radii, and for a tread also well below its thickness and
    the distance to its faces. For equal radii the result is that of `hertz`. For R_c ≫ R the center tends to
    `hertz_line` under the local load per unit length.

    Parameters
    ----------
    load : array_like
        Load P [N], > 0.
    radius : float
        Radius R along the path [m], > 0.
    crown_radius : float
        Radius R_c across the path [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5].

    Returns
    -------
    EllipticContact
        Contact with p₀ = 3P / (2πab).

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, equations (4.25) to (4.32).

    Examples
    --------
    >>> contact = hertz_ellipse(load=16.0, radius=50e-3, crown_radius=300e-3, shear_modulus=3e6, poisson_ratio=0.5)
    >>> f"{contact.semi_axis_x * 1e3:.3f} and {contact.semi_axis_z * 1e3:.3f} mm"
    '2.643 and 8.592 mm'
    """
    force, stiffness = positives("load", load, "N"), as_positive("shear_modulus", shear_modulus, "Pa")
    radii = as_positive("radius", radius, "m"), as_positive("crown_radius", crown_radius, "m")
    wide = max(radii)
    modulus = 2.0 * stiffness / (1.0 - poisson(poisson_ratio))  # E* of one elastic body
    ratio = axis_ratio(min(radii) / wide)
    k, d = _integrals(ratio)
    long = np.cbrt(3.0 * force * wide * d / (math.pi * modulus))
    short = ratio * long
    pressure = 1.5 * force / (math.pi * long * short)
    along, across = (short, long) if radius <= crown_radius else (long, short)
    return EllipticContact(
        semi_axis_x=float_if_scalar(along),
        semi_axis_z=float_if_scalar(across),
        approach=float_if_scalar(pressure * short * k / modulus),
        max_pressure=float_if_scalar(pressure),
    )


@cache
def axis_ratio(radius_ratio: float) -> float:
    """Return the aspect ratio b/a of Hertz's ellipse, short over long axis.

    `radius_ratio` is the ratio of the smaller to the larger radius of curvature.
    """
    low, high = math.log(1e-12), 0.0
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        ratio = math.exp(middle)
        k, d = _integrals(ratio)
        # The curvatures along the long and the short axis are proportional to d and (k - d) / ratio².
        low, high = (middle, high) if d * ratio**2 < radius_ratio * (k - d) else (low, middle)
    return math.exp(0.5 * (low + high))


def _integrals(ratio: float) -> tuple[float, float]:
    """Return the complete elliptic integrals K and D = (K - E)/m with m = 1 - ratio², by arithmetic-geometric means."""
    m = 1.0 - ratio**2
    a, b, d_over_k, weight = 1.0, ratio, 0.5, 0.5
    c = 1.0
    while c > 1e-9 * a:  # quadratic convergence: the next c is of the order of the square
        c = 0.5 * (a - b)
        a, b, weight = 0.5 * (a + b), math.sqrt(a * b), 2.0 * weight
        d_over_k += weight * c**2 / m if m > 0.0 else 0.0
    k = 0.5 * math.pi / a
    return k, k * d_over_k
