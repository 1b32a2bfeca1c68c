"""Modes of the temperature along the surface of a ball, a roller, a wheel or a slab: T = Σ T_j(r) Y_j."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.errors import InvalidInput

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "HeatModes",
    "film_matrix_of_ball",
    "film_matrix_of_wheel",
    "legendre_values",
    "modes_of_ball",
    "modes_of_roller",
    "modes_of_slab",
    "modes_of_track",
    "modes_of_wheel",
]

#: Radius divided by the outer radius of a ball without a core below which all modes except the mean have decayed.
_SMALLEST_RADIUS = 1e-2


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class HeatModes:
    """Orthogonal functions Y_j along a surface.

    Attributes
    ----------
    measure : callable
        Dependence of the surface area on r: r² [m²], r [m] or 1. `area` and `square` contain the other factors.
    rate : callable
        Function of r that returns the eigenvalues λ_j of -∇²Y_j = λ_j Y_j [1/m²], one row per mode.
    values : callable
        Y_j at places along the surface, one row per mode; a place is cos θ on a ball, and z [m] on other bodies.
    unity : ndarray
        Coefficients of the constant function 1.
    area, square : ndarray
        Integrals of Y_j and of Y_j² over the surface, divided by `measure`.
    folds : callable
        Number of e-folds of the highest mode between two radii or heights.
    """

    measure: Callable[[NDArray[np.float64]], NDArray[np.float64]]
    rate: Callable[[NDArray[np.float64]], NDArray[np.float64]]
    values: Callable[[NDArray[np.float64]], NDArray[np.float64]]
    unity: NDArray[np.float64]
    area: NDArray[np.float64]
    square: NDArray[np.float64]
    folds: Callable[[float, float], float]

    @property
    def count(self) -> int:
        """Number of modes."""
        return self.unity.size


def legendre_values(degrees: int, cosine: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return P_l(cosine) for l = 0 … degrees - 1, one row per degree."""
    return np.asarray(np.polynomial.legendre.legvander(cosine, degrees - 1).T, dtype=np.float64)


def modes_of_ball(degrees: int) -> HeatModes:
    """Return the modes of a ball: Legendre polynomials P_l(cos θ), l = 0 … degrees - 1."""
    degree = np.arange(degrees, dtype=np.float64)
    first = np.zeros(degrees)
    first[0] = 1.0
    return HeatModes(
        measure=np.square,
        rate=lambda r: (degree * (degree + 1.0))[:, None] / r**2,
        values=lambda cosine: legendre_values(degrees, cosine),
        unity=first,
        area=4.0 * np.pi * first,
        square=2.0 * np.pi / (degree + 0.5),
        folds=lambda inner, outer: degrees * float(np.log(outer / max(inner, _SMALLEST_RADIUS * outer))),
    )


def modes_of_roller(width: float | None, side: float, count: int = 1) -> HeatModes:
    """Return the modes of a roller: cos(β_j z) with β_j tan(β_j L/2) = h_s/k; without cooled faces only the constant 1.

    Parameters
    ----------
    width : float or None
        Width L between the side faces [m]; without it, all quantities are per length.
    side : float
        Coefficient of convection at the side faces divided by the conductivity, h_s/k [1/m].
    count : int
        Number of modes.
    """
    if width is None or side == 0.0:
        return _between_faces(1.0 if width is None else width, np.zeros(1), np.zeros(1, np.int_))
    halves = np.arange(0, 2 * count, 2)
    return _between_faces(width, _side_roots(0.5 * side * width, halves), halves)


def modes_of_wheel(width: float, side: float, count: int) -> HeatModes:
    """Return the modes of a wheel, cos(β_j z - jπ/2): even ones as for a roller, and odd ones between them.

    Parameters
    ----------
    width : float
        Width L between the side faces [m].
    side : float
        Coefficient of convection at the side faces divided by the conductivity, h_s/k [1/m].
    count : int
        Number of modes.
    """
    halves = np.arange(count)
    return _between_faces(width, _side_roots(0.5 * side * width, halves), halves)


def _between_faces(length: float, root: NDArray[np.float64], halves: NDArray[np.int_]) -> HeatModes:
    """Return cos(2 x_j z/L - jπ/2), with the roots x_j and the numbers j of half waves between the faces."""
    beta = 2.0 * root / length
    odd = halves % 2
    area = np.where(odd, 0.0, length * np.sinc(root / np.pi))
    square = 0.5 * length * (1.0 + np.where(odd, -1.0, 1.0) * np.sinc(2.0 * root / np.pi))
    return HeatModes(
        measure=lambda r: np.asarray(r, dtype=np.float64),
        rate=lambda r: np.repeat(beta[:, None] ** 2, np.size(r), axis=1),
        values=lambda z: np.where(odd[:, None], np.sin(beta[:, None] * z), np.cos(beta[:, None] * z)),
        unity=area / square,
        area=2.0 * np.pi * area,
        square=2.0 * np.pi * square,
        folds=lambda inner, outer: float(beta[-1]) * (outer - inner),
    )


def modes_of_slab(period: float | None, count: int = 1) -> HeatModes:
    """Return the modes of a slab: cos(2π j z/L), j = 0, 1, …; without a period the constant 1, for heat per area.

    Parameters
    ----------
    period : float or None
        Distance L between neighboring parallel tracks [m].
    count : int
        Number of modes.
    """
    length = 1.0 if period is None else period
    k = 2.0 * np.pi / length * np.arange(count if period is not None else 1)
    first = (k == 0.0).astype(np.float64)
    return HeatModes(
        measure=np.ones_like,
        rate=lambda y: np.repeat(k[:, None] ** 2, np.size(y), axis=1),
        values=lambda z: np.cos(k[:, None] * z),
        unity=first,
        area=length * first,
        square=0.5 * length * (1.0 + first),
        folds=lambda inner, outer: float(k[-1]) * (outer - inner),
    )


def modes_of_track(period: float, waves: int) -> HeatModes:
    """Return the modes of a slab without symmetry: 1, cos(2π j z/L) and sin(2π j z/L), j = 1, 2, ….

    Parameters
    ----------
    period : float
        Period L across the path [m].
    waves : int
        Number of waves, at least 1.
    """
    number = np.arange(2 * waves + 1)
    k = 2.0 * np.pi / period * ((number + 1) // 2)
    sine = (number % 2 == 0) & (number > 0)
    first = (number == 0).astype(np.float64)
    return HeatModes(
        measure=np.ones_like,
        rate=lambda y: np.repeat(k[:, None] ** 2, np.size(y), axis=1),
        values=lambda z: np.where(sine[:, None], np.sin(k[:, None] * z), np.cos(k[:, None] * z)),
        unity=first,
        area=period * first,
        square=0.5 * period * (1.0 + first),
        folds=lambda inner, outer: float(k[-1]) * (outer - inner),
    )


def film_matrix_of_ball(
    convection: Callable[[NDArray[np.float64]], NDArray[np.float64]], degrees: int
) -> NDArray[np.float64]:
    """Return the matrix H of convection on a ball: h_c T has the components H T, H = (l + ½) ∫ h_c P_l P_l' d cos θ.

    Raises
    ------
    ValueError
        If a coefficient is negative or not finite.
    """
    cosine, weights = np.polynomial.legendre.leggauss(2 * degrees + 2)
    values = legendre_values(degrees, cosine)
    coefficient = _coefficients(convection, np.arccos(cosine))
    film: NDArray[np.float64] = (np.arange(degrees)[:, None] + 0.5) * ((values * (coefficient * weights)) @ values.T)
    return film


def film_matrix_of_wheel(
    convection: Callable[[NDArray[np.float64]], NDArray[np.float64]], modes: HeatModes, width: float, radius: float
) -> NDArray[np.float64]:
    """Return the matrix of convection h_c(θ) on a wheel, θ = π/2 - z/r_o: H = ∫ h_c Y_j Y_l dz / ∫ Y_j² dz.

    Raises
    ------
    ValueError
        If a coefficient is negative or not finite.
    """
    points, weights = np.polynomial.legendre.leggauss(2 * modes.count + 2)
    z = 0.5 * width * points
    values = modes.values(z)
    coefficient = _coefficients(convection, 0.5 * np.pi - z / radius)
    # `square` contains the factor 2π of the circumference.
    norm = modes.square[:, None] / (np.pi * width)
    return np.asarray(((values * (coefficient * weights)) @ values.T) / norm)


def _coefficients(
    convection: Callable[[NDArray[np.float64]], NDArray[np.float64]], theta: NDArray[np.float64]
) -> NDArray[np.float64]:
    given = np.asarray(convection(theta), dtype=float)
    if given.shape not in ((), theta.shape):
        raise InvalidInput(
            "convection", "must return one number, or one for each of the given angles", f"shape {given.shape}"
        )
    coefficient = np.broadcast_to(given, theta.shape)
    if not (np.isfinite(coefficient).all() and coefficient.min() >= 0.0):
        raise InvalidInput("convection", "must return finite coefficients >= 0 W/(m^2 K)")
    return coefficient


def _side_roots(biot: float, halves: NDArray[np.int_]) -> NDArray[np.float64]:
    """Return roots of x tan(x - jπ/2) = Bi, each in [jπ/2, jπ/2 + π/2), by Newton's method on the arctangent form."""
    low = np.asarray(0.5 * np.pi * halves, dtype=np.float64)
    if biot == 0.0:
        return low
    x = low + np.arctan(biot / np.maximum(low, np.sqrt(biot) if biot < 1.0 else 1.0))
    for _ in range(60):
        value = (x - low) - np.arctan2(biot, x)
        x = x - value / (1.0 + biot / (biot**2 + x**2))
    return np.asarray(x)
