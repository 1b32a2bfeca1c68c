"""Contacts at rest with adhesion: balls and rollers on elastic half-spaces, and rollers on thin layers.

Loads may be negative, down to the pull-off load. For a load that two states balance, the functions return the state
with the larger contact, which is stable at a given load.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .._support.arguments import as_float_array, as_positive
from .._support.errors import InvalidInput, Range
from ._inputs import Floats, float_if_scalar, poisson

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "AdhesiveContact",
    "finite_loads",
    "jkr",
    "jkr_line",
    "maugis",
    "require_contact",
    "thin_adhesive_layer_line",
]

#: Function that returns the loads of contacts of given half-widths.
_LoadOf: TypeAlias = Callable[["NDArray[np.float64]"], "NDArray[np.float64]"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class AdhesiveContact:
    """Contact at rest with adhesion.

    Attributes
    ----------
    half_width : float or ndarray
        Half-width of the contact, or radius of that of a ball [m].
    approach : float or ndarray or None
        Approach d of the bodies [m], negative if they are pulled apart; None on a half-plane, where it is unbounded.
    zone : float or ndarray
        Width of the cohesive zone around the contact, in which the surfaces attract each other across a gap [m]; 0 if
        the attraction has no range.
    pull_off : float
        Smallest load that keeps the bodies in contact, negative [N], or per unit length [N/m].
    """

    half_width: Floats
    approach: Floats | None
    zone: Floats
    pull_off: float


def jkr(*, load: ArrayLike, radius: float, shear_modulus: float, poisson_ratio: float, work: float) -> AdhesiveContact:
    """Return the contact of a ball and an elastic half-space with an attraction of short range (JKR).

    With E* = 2G/(1-ν), the radius a of the contact is that of Hertz for the load
    P + 3πwR + √(6πwRP + (3πwR)²), the approach is d = a²/R - √(2πaw/E*), and the pull-off load is -3πwR/2. Valid for
    a ≪ R and a Maugis parameter λ > 3, see `maugis`.

    Parameters
    ----------
    load : array_like
        Load P [N], at least the pull-off load.
    radius : float
        Relative radius R [m], > 0.
    shear_modulus : float
        Shear modulus G [Pa], > 0.
    poisson_ratio : float
        Poisson's ratio ν [-], in (-1, 0.5].
    work : float
        Work of adhesion w [J/m²], > 0.

    Returns
    -------
    AdhesiveContact
        Contact with a zone of width 0.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301-313.

    Examples
    --------
    >>> contact = jkr(load=0.0, radius=21e-3, shear_modulus=3e6, poisson_ratio=0.5, work=0.05)
    >>> f"{contact.half_width * 1e6:.1f} µm, {contact.pull_off * 1e3:.2f} mN"
    '296.2 µm, -4.95 mN'
    """
    forces, modulus = finite_loads(load), _contact_modulus(shear_modulus, poisson_ratio)
    size, energy = as_positive("radius", radius, "m"), as_positive("work", work, "J/m²")
    unit = 3.0 * np.pi * energy * size
    require_contact(forces, -0.5 * unit, "N")
    hertz_load = forces + unit + np.sqrt(np.maximum(unit * (2.0 * forces + unit), 0.0))
    a = np.cbrt(0.75 * size * hertz_load / modulus)
    return AdhesiveContact(
        half_width=float_if_scalar(a),
        approach=float_if_scalar(a**2 / size - np.sqrt(2.0 * np.pi * a * energy / modulus)),
        zone=float_if_scalar(np.zeros_like(a)),
        pull_off=-0.5 * unit,
    )


def jkr_line(
    *, load: ArrayLike, radius: float, shear_modulus: float, poisson_ratio: float, work: float
) -> AdhesiveContact:
    """Return the contact of a roller and an elastic half-plane with an attraction of short range.

    P = πE*a²/(4R) - √(2πE*aw) with E* = 2G/(1-ν). The pull-off load is that of the half-width a³ = 2wR²/(πE*).

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], at least the pull-off load.
    radius, shear_modulus, poisson_ratio, work : float
        Relative radius R [m], shear modulus G [Pa], Poisson's ratio ν [-] and work of adhesion w [J/m²], as in `jkr`.

    Returns
    -------
    AdhesiveContact
        Contact with a zone of width 0; its approach is None.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    M. K. Chaudhury, T. Weaver, C. Y. Hui, E. J. Kramer, J. Appl. Phys. 80 (1996) 30-37.

    Examples
    --------
    >>> contact = jkr_line(load=0.0, radius=10e-3, shear_modulus=1e6, poisson_ratio=0.5, work=0.05)
    >>> f"{contact.half_width * 1e3:.4f} mm"
    '0.2335 mm'
    """
    forces, modulus = finite_loads(load), _contact_modulus(shear_modulus, poisson_ratio)
    size, energy = as_positive("radius", radius, "m"), as_positive("work", work, "J/m²")

    def load_of(a: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(0.25 * np.pi * modulus * a**2 / size - np.sqrt(2.0 * np.pi * modulus * a * energy))

    least = np.cbrt(2.0 * energy * size**2 / (np.pi * modulus))
    a, pull_off = _stable_half_width(load_of, forces, least, "N/m")
    return AdhesiveContact(
        half_width=float_if_scalar(a), approach=None, zone=float_if_scalar(np.zeros_like(a)), pull_off=pull_off
    )


def thin_adhesive_layer_line(
    *, load: ArrayLike, radius: float, thickness: float, shear_modulus: float, poisson_ratio: float, work: float
) -> AdhesiveContact:
    """Return the contact of a roller and a thin compressible bonded layer with an attraction of short range.

    The layer is a bed of springs of the confined modulus M = 2G (1-ν)/(1-2ν), and its edge is stretched by
    e = √(2wh/M): d = a²/(2R) - e and P = (M/h)(2a³/(3R) - 2ae), with the pull-off load at d = 0. Valid for a ≫ h and
    (1-2ν) a² ≫ h², with errors of the order h/a.

    Parameters
    ----------
    load : array_like
        Load P per unit length [N/m], at least the pull-off load.
    radius : float
        Relative radius R [m], > 0.
    thickness : float
        Thickness h of the layer [m], > 0.
    shear_modulus, poisson_ratio, work : float
        Shear modulus G [Pa], Poisson's ratio ν [-], in (-1, 0.5), and work of adhesion w [J/m²], as in `jkr`.

    Returns
    -------
    AdhesiveContact
        Contact with a zone of width 0.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    Minimum of the energy of the springs minus 2 a w: docs/theory/adhesion.md.

    Examples
    --------
    >>> layer = {"thickness": 0.1e-3, "shear_modulus": 1e6, "poisson_ratio": 0.3}
    >>> contact = thin_adhesive_layer_line(load=0.0, radius=10e-3, work=0.05, **layer)
    >>> f"{contact.half_width * 1e3:.4f} mm, {contact.approach * 1e6:.3f} µm"
    '0.2252 mm, 0.845 µm'
    """
    forces, nu = finite_loads(load), poisson(poisson_ratio, compressible=True)
    size, energy = as_positive("radius", radius, "m"), as_positive("work", work, "J/m²")
    depth = as_positive("thickness", thickness, "m")
    confined = as_positive("shear_modulus", shear_modulus, "Pa") * 2.0 * (1.0 - nu) / (1.0 - 2.0 * nu)
    stretch = np.sqrt(2.0 * energy * depth / confined)

    def load_of(a: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.asarray(confined / depth * (2.0 * a**3 / (3.0 * size) - 2.0 * a * stretch))

    a, pull_off = _stable_half_width(load_of, forces, np.sqrt(2.0 * size * stretch), "N/m")
    return AdhesiveContact(
        half_width=float_if_scalar(a),
        approach=float_if_scalar(a**2 / (2.0 * size) - stretch),
        zone=float_if_scalar(np.zeros_like(a)),
        pull_off=pull_off,
    )


def maugis(
    *, load: ArrayLike, radius: float, shear_modulus: float, poisson_ratio: float, work: float, strength: float
) -> AdhesiveContact:
    """Return the contact of a ball and an elastic half-space with an attraction of finite range (Maugis-Dugdale).

    The surfaces attract each other by the constant traction σ₀ up to the gap w/σ₀. In units of (πwR²/K)^(1/3) for the
    radii a and m a of the contact and of the attracted region, πwR for P, and (π²w²R/K²)^(1/3) for d, with
    K = (4/3) E* and the Maugis parameter λ = 2σ₀ (R/(πwK²))^(1/3),

        1 = ½λa² (√(m²-1) + (m²-2) arcsec m) + (4/3) λ²a (√(m²-1) arcsec m - m + 1),
        P = a³ - λa² (√(m²-1) + m² arcsec m),   d = a² - (4/3) λa √(m²-1).

    Parameters
    ----------
    load : array_like
        Load P [N], at least the pull-off load of bodies in contact.
    radius, shear_modulus, poisson_ratio, work : float
        Relative radius R [m], shear modulus G [Pa], Poisson's ratio ν [-] and work of adhesion w [J/m²], as in `jkr`.
    strength : float
        Attraction σ₀ [Pa], > 0.

    Returns
    -------
    AdhesiveContact
        Contact and its cohesive zone, of width (m - 1) a.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid; the message names the argument, its value, unit and allowed range.

    References
    ----------
    D. Maugis, J. Colloid Interface Sci. 150 (1992) 243-269, equations (6.16) to (6.18).

    Examples
    --------
    >>> ball = {"radius": 21e-3, "shear_modulus": 3e6, "poisson_ratio": 0.5}
    >>> contact = maugis(load=0.0, work=0.05, strength=5e4, **ball)
    >>> f"{contact.half_width * 1e6:.1f} µm, zone {contact.zone * 1e6:.2f} µm, {contact.pull_off * 1e3:.2f} mN"
    '260.6 µm, zone 77.27 µm, -5.39 mN'
    """
    forces, modulus = finite_loads(load), _contact_modulus(shear_modulus, poisson_ratio) * 4.0 / 3.0
    size, energy = as_positive("radius", radius, "m"), as_positive("work", work, "J/m²")
    range_parameter = 2.0 * as_positive("strength", strength, "Pa") * np.cbrt(size / (np.pi * energy * modulus**2))
    length = np.cbrt(np.pi * energy * size**2 / modulus)
    unit = np.pi * energy * size
    edge = _MaugisEdge(float(range_parameter))

    def load_of(a: NDArray[np.float64]) -> NDArray[np.float64]:
        return unit * edge.load(a / length)

    a, pull_off = _stable_half_width(load_of, forces, length * edge.pull_off_radius(), "N")
    theta = edge.angle(a / length)
    approach = (a / length) ** 2 - 4.0 / 3.0 * edge.parameter * (a / length) * np.tan(theta)
    return AdhesiveContact(
        half_width=float_if_scalar(a),
        approach=float_if_scalar(approach * length**2 / size),
        zone=float_if_scalar(a * (1.0 / np.cos(theta) - 1.0)),
        pull_off=pull_off,
    )


@dataclass(frozen=True, slots=True)
class _MaugisEdge:
    """Normalized equations of `maugis`, with the angle θ = arcsec m."""

    parameter: float

    def angle(self, a: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return θ for normalized radii a; the work of separation increases with θ."""
        low, high = np.zeros_like(a), np.full_like(a, 0.5 * np.pi)
        for _ in range(_BISECTIONS):
            theta = 0.5 * (low + high)
            tangent, secant = np.tan(theta), 1.0 / np.cos(theta)
            work = 0.5 * self.parameter * a**2 * (tangent + (secant**2 - 2.0) * theta)
            work = work + 4.0 / 3.0 * self.parameter**2 * a * (tangent * theta - secant + 1.0)
            low, high = np.where(work < 1.0, theta, low), np.where(work < 1.0, high, theta)
        return np.asarray(0.5 * (low + high))

    def load(self, a: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return normalized loads."""
        theta = self.angle(a)
        return np.asarray(a**3 - self.parameter * a**2 * (np.tan(theta) + theta / np.cos(theta) ** 2))

    def pull_off_radius(self) -> float:
        """Return the normalized radius with the smallest load, by repeated refinement of a grid."""
        # The radius is of order 1 for large parameters, and tends to 0 for small ones.
        low, high = 1e-4, 3.0
        for _ in range(12):
            radii = np.geomspace(low, high, 41)
            least = int(np.argmin(self.load(radii)))
            low, high = radii[max(least - 1, 0)], radii[min(least + 1, radii.size - 1)]
        return float(np.sqrt(low * high))


#: Number of bisections that exhausts the digits of a number.
_BISECTIONS = 60


def finite_loads(load: ArrayLike) -> NDArray[np.float64]:
    """Convert loads of either sign to an array; raise a ValueError unless all are finite."""
    forces = as_float_array("load", load)
    if not np.isfinite(forces).all():
        raise InvalidInput("load", "must be finite", f"{forces[~np.isfinite(forces)][0]:g}")
    return forces


def require_contact(forces: NDArray[np.float64], pull_off: float, unit: str) -> None:
    """Raise a ValueError if a load is below the pull-off load."""
    below = forces[forces < pull_off]
    if below.size:
        raise Range(pull_off, unit=unit).error("load", f"{below[0]:g}", ", the pull-off load")


def _contact_modulus(shear_modulus: float, poisson_ratio: float) -> float:
    """Return E* = 2G/(1-ν) [Pa]."""
    return 2.0 * as_positive("shear_modulus", shear_modulus, "Pa") / (1.0 - poisson(poisson_ratio))


def _stable_half_width(
    load_of: _LoadOf, forces: NDArray[np.float64], least: float, unit: str
) -> tuple[NDArray[np.float64], float]:
    """Return the half-widths above that of the pull-off load, `least`, and the pull-off load."""
    pull_off = float(load_of(np.asarray(least)))
    require_contact(forces, pull_off, unit)
    low, high = np.full_like(forces, least), np.full_like(forces, 2.0 * least)
    while np.any(short := load_of(high) < forces):
        high = np.where(short, 2.0 * high, high)
    for _ in range(_BISECTIONS):
        middle = 0.5 * (low + high)
        short = load_of(middle) < forces
        low, high = np.where(short, middle, low), np.where(short, high, middle)
    return np.asarray(0.5 * (low + high)), pull_off
