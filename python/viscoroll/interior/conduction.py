"""Steady conduction in the layers, degree by degree of Legendre's polynomials.

T = Σ T_l(r) P_l(cos θ), and for every degree by itself -(k r² T_l')' + k l(l+1) T_l = r² q_l. One spectral element for
each layer or part of one, with Gauss, Lobatto and Legendre's points; the weak form conserves heat to round-off.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import legendre

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

__all__ = ["Conduction", "legendre_values"]

_POINTS = 17  # of an element: exact to degree 31
_LONGEST = 16.0  # e-folds of the highest degree through an element


def legendre_values(degrees: int, cosine: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return P_l(cosine) for l = 0 … degrees - 1, a row for each."""
    return np.asarray(legendre.legvander(cosine, degrees - 1).T, dtype=np.float64)


def _lobatto(count: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Points on [-1, 1], weights, and the matrix that differentiates at the points."""
    basis = legendre.Legendre.basis(count - 1)
    points = np.concatenate([[-1.0], np.sort(basis.deriv().roots().real), [1.0]])
    heights = basis(points)
    weights = 2.0 / (count * (count - 1) * heights**2)
    gaps = points[:, None] - points[None, :] + np.eye(count)
    derivative = heights[:, None] / heights[None, :] / gaps
    np.fill_diagonal(derivative, 0.0)
    derivative[np.diag_indices(count)] = -derivative.sum(axis=1)
    return points, weights, derivative


@dataclass(frozen=True, slots=True)
class _Element:
    inner: float
    outer: float
    conductivity: float
    layer: int


class Conduction:
    """Layers that conduct heat.

    Parameters
    ----------
    radii : sequence of float
        Boundaries of the layers, from the center outwards [m].
    conductivities : sequence of float
        Of each layer [W/(m K)].
    convection : float or callable
        Coefficient h_c [W/(m² K)], maybe as a function of the angles θ [rad].
    degrees : int
        How many degrees l = 0, 1, … are summed.
    core_conductivity : float or None
        Of a sphere within the layers [W/(m K)], 0 for an insulated one, None for one at a given temperature.
    """

    def __init__(
        self,
        radii: list[float],
        conductivities: list[float],
        convection: float | Callable[[NDArray[np.float64]], NDArray[np.float64]],
        *,
        degrees: int,
        core_conductivity: float | None,
    ) -> None:
        self.radii = radii
        self.core_conductivity = core_conductivity
        self.degrees = degrees
        self._points, self._weights, self._derivative = _lobatto(_POINTS)
        self._elements = _elements(radii, conductivities, degrees)
        self.radius, self.layer = self._nodes()
        self._film = _film(convection, degrees)

    def _nodes(self) -> tuple[NDArray[np.float64], NDArray[np.int_]]:
        """Radii and layers of all points; the ends of elements come twice."""
        radius = [e.inner + 0.5 * (e.outer - e.inner) * (1.0 + self._points) for e in self._elements]
        return np.concatenate(radius), np.repeat([e.layer for e in self._elements], _POINTS)

    def solve(self, source: NDArray[np.float64], core_rise: float = 0.0) -> NDArray[np.float64]:
        """Return T_l at every point, a row for each degree [K].

        Parameters
        ----------
        source : ndarray, shape (degrees, points)
            q_l at the points of `radius` [W/m³].
        core_rise : float
            Of a core at a given temperature, over that of the surroundings [K].
        """
        matrices, loads = self._assemble(source)
        surface = matrices.shape[1] - 1
        film = self._film
        radius2 = self.radii[-1] ** 2
        fixed = self.core_conductivity is None
        if fixed:
            loads = loads.copy()
            loads[0] -= matrices[0, :, 0] * core_rise
            matrices, loads, surface = matrices[:, 1:, 1:], loads[:, 1:], surface - 1
        mean = film[0, 0]
        diagonal = matrices.copy()
        diagonal[:, surface, surface] += radius2 * mean
        unit = np.zeros(matrices.shape[1])
        unit[surface] = 1.0
        answers = np.linalg.solve(diagonal, np.stack([loads, np.broadcast_to(unit, loads.shape)], axis=-1))
        free, response = answers[..., 0], answers[..., 1]
        rest = film - mean * np.eye(self.degrees)
        rises = free
        if np.abs(rest).max() > 1e-14 * max(mean, 1e-300):
            system = np.eye(self.degrees) + radius2 * response[:, surface, None] * rest
            at_surface = np.linalg.solve(system, free[:, surface])
            rises = free - response * (radius2 * rest @ at_surface)[:, None]
        if fixed:
            first = np.zeros((self.degrees, 1))
            first[0] = core_rise
            rises = np.concatenate([first, rises], axis=1)
        return np.asarray(rises[:, self._scatter()], dtype=np.float64)

    def volume_weights(self) -> NDArray[np.float64]:
        """Return r² dr at every point [m³]."""
        half = np.repeat([0.5 * (e.outer - e.inner) for e in self._elements], _POINTS)
        weights: NDArray[np.float64] = half * np.tile(self._weights, len(self._elements)) * self.radius**2
        return weights

    def heat_to_core(self, source: NDArray[np.float64], rises: NDArray[np.float64]) -> float:
        """Return the heat that flows into a core at a given temperature [W]."""
        if self.core_conductivity is not None:
            return 0.0
        matrices, loads = self._assemble(source)
        keep = np.unique(self._scatter(), return_index=True)[1]
        reaction = matrices[0, 0] @ rises[0, keep] - loads[0, 0]
        return float(-4.0 * np.pi * reaction)

    def heat_to_surroundings(self, rises: NDArray[np.float64]) -> float:
        """Return the heat that leaves by the surface [W]."""
        return float(4.0 * np.pi * self.radii[-1] ** 2 * (self._film[0] @ rises[:, -1]))

    def heat_of(self, source: NDArray[np.float64]) -> float:
        """Return the heat of a source [W]."""
        return float(4.0 * np.pi * self._assemble(source)[1][0].sum())

    def _scatter(self) -> NDArray[np.intp]:
        """Unknown of each point: ends of elements are shared."""
        inside = _POINTS - 1
        return np.concatenate([np.arange(e * inside, e * inside + _POINTS) for e in range(len(self._elements))])

    def _assemble(self, source: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        unknowns = len(self._elements) * (_POINTS - 1) + 1
        matrices = np.zeros((self.degrees, unknowns, unknowns))
        loads = np.zeros((self.degrees, unknowns))
        degree = np.arange(self.degrees)
        for number, element in enumerate(self._elements):
            half = 0.5 * (element.outer - element.inner)
            radius = element.inner + half * (1.0 + self._points)
            weight = half * self._weights
            slope = self._derivative / half
            stiffness = element.conductivity * slope.T @ ((weight * radius**2)[:, None] * slope)
            mass = element.conductivity * np.diag(weight)
            first = number * (_POINTS - 1)
            part = slice(first, first + _POINTS)
            matrices[:, part, part] += stiffness + (degree * (degree + 1.0))[:, None, None] * mass
            loads[:, part] += weight * radius**2 * source[:, number * _POINTS : (number + 1) * _POINTS]
        if self.core_conductivity:
            matrices[:, 0, 0] += self.core_conductivity * self.radii[0] * degree
        return matrices, loads


def _film(
    convection: float | Callable[[NDArray[np.float64]], NDArray[np.float64]], degrees: int
) -> NDArray[np.float64]:
    """Matrix of convection: h_c T has the components H T with H = (l + ½) ∫ h_c P_l P_l' d cos θ."""
    if not callable(convection):
        return convection * np.eye(degrees)
    cosine, weights = legendre.leggauss(2 * degrees + 2)
    values = legendre_values(degrees, cosine)
    coefficient = np.broadcast_to(np.asarray(convection(np.arccos(cosine)), dtype=float), cosine.shape)
    if not (np.isfinite(coefficient).all() and coefficient.min() >= 0.0):
        raise ValueError("convection must be a function that returns finite coefficients >= 0 W/(m^2 K)")
    film: NDArray[np.float64] = (np.arange(degrees)[:, None] + 0.5) * ((values * (coefficient * weights)) @ values.T)
    return film


def _elements(radii: list[float], conductivities: list[float], degrees: int) -> list[_Element]:
    """Cut layers so that no element holds more e-folds of the highest degree than it resolves."""
    elements = []
    for layer, conductivity in enumerate(conductivities):
        inner, outer = radii[layer], radii[layer + 1]
        folds = degrees * np.log(outer / max(inner, 1e-2 * outer))
        count = max(1, int(np.ceil(folds / _LONGEST)))
        cuts = np.linspace(inner, outer, count + 1)
        elements += [_Element(float(a), float(b), conductivity, layer) for a, b in pairwise(cuts)]
    return elements
