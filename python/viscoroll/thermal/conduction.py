"""Heat conduction in layers, mode by mode along the surface.

The temperature is T = Σ T_j(r) Y_j. Each mode separately satisfies -(k A T_j')' + k A λ_j T_j = A q_j, with the measure
A of the surface at r and -∇²Y_j = λ_j Y_j along it (`heat_modes`). Each layer is one spectral element with Lobatto
points, or several. The weak form conserves heat to round-off.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial import legendre

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .heat_modes import HeatModes

__all__ = ["Conduction"]

_POINTS = 17  # per element: exact to degree 31
_LONGEST = 16.0  # largest number of e-folds of the highest mode in an element


def _lobatto(count: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return points on [-1, 1], weights, and the matrix that differentiates at the points."""
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
    """Heat conduction in a stack of layers.

    Parameters
    ----------
    places : sequence of float
        Boundaries of the layers from the inside outwards [m]: radii, or heights in a slab.
    conductivities : sequence of float
        Conductivity of each layer [W/(m K)].
    modes : HeatModes
        Modes of the temperature along the surface.
    film : float or ndarray, shape (modes, modes)
        Coefficient of convection at the outer surface [W/(m² K)], or its matrix if it varies along the surface.
    inner : ndarray or None, shape (modes,)
        Coefficient at the inner surface for each mode [W/(m² K)]; 0 if insulated, None if its temperature is given.
    """

    def __init__(
        self,
        places: Sequence[float],
        conductivities: Sequence[float],
        modes: HeatModes,
        *,
        film: float | NDArray[np.float64],
        inner: NDArray[np.float64] | None,
    ) -> None:
        self.modes = modes
        self._inner = inner
        self._outermost = places[-1]
        self._points, self._weights, self._derivative = _lobatto(_POINTS)
        self._elements = _elements(places, conductivities, modes)
        self.place, self.layer = self._nodes()
        self._film = film * np.eye(modes.count) if np.ndim(film) == 0 else np.asarray(film)

    def _nodes(self) -> tuple[NDArray[np.float64], NDArray[np.int_]]:
        """Return places and layers of all points; the ends of elements occur twice."""
        place = [e.inner + 0.5 * (e.outer - e.inner) * (1.0 + self._points) for e in self._elements]
        return np.concatenate(place), np.repeat([e.layer for e in self._elements], _POINTS)

    @property
    def has_even_film(self) -> bool:
        """Whether the coefficient at the outer surface is the same everywhere, so that the modes are independent."""
        return bool(np.array_equal(self._film, self._film[0, 0] * np.eye(self.modes.count)))

    def solve(self, source: NDArray[np.float64], inner_rise: float = 0.0) -> NDArray[np.float64]:
        """Return T_j at every point, one row per mode [K].

        Parameters
        ----------
        source : ndarray, shape (modes, points)
            Source q_j at the points of `place` [W/m³].
        inner_rise : float
            Rise of an inner surface at a given temperature over the surroundings [K].
        """
        matrices, loads = self._assemble(source)
        surface = matrices.shape[1] - 1
        film = self._film
        area = float(self.modes.measure(np.array(self._outermost)))
        fixed = self._inner is None
        held = self.modes.unity * inner_rise
        if fixed:
            loads = loads - matrices[:, :, 0] * held[:, None]
            matrices, loads, surface = matrices[:, 1:, 1:], loads[:, 1:], surface - 1
        mean = film[0, 0]
        diagonal = matrices.copy()
        diagonal[:, surface, surface] += area * mean
        unit = np.zeros(matrices.shape[1])
        unit[surface] = 1.0
        answers = np.linalg.solve(diagonal, np.stack([loads, np.broadcast_to(unit, loads.shape)], axis=-1))
        free, response = answers[..., 0], answers[..., 1]
        rest = film - mean * np.eye(self.modes.count)
        rises = free
        if np.abs(rest).max() > 1e-14 * max(mean, 1e-300):
            system = np.eye(self.modes.count) + area * response[:, surface, None] * rest
            at_surface = np.linalg.solve(system, free[:, surface])
            rises = free - response * (area * rest @ at_surface)[:, None]
        if fixed:
            rises = np.concatenate([held[:, None], rises], axis=1)
        return np.asarray(rises[:, self._scatter()], dtype=np.float64)

    def approach(
        self, steady: NDArray[np.float64], start: NDArray[np.float64], times: NDArray[np.float64], capacity: float
    ) -> NDArray[np.float64]:
        """Return the approach to the steady state over time, by the eigenmodes of ρc A T' + conduction = source.

        Parameters
        ----------
        steady, start : ndarray, shape (modes, points)
            T_j of the steady state and of the initial state [K].
        times : ndarray
            Times [s], ≥ 0.
        capacity : float
            Heat capacity per volume ρc [J/(m³ K)].

        Returns
        -------
        ndarray, shape (times, modes, points)
            T_j at these times [K].

        Raises
        ------
        ValueError
            If the film varies along the surface, which couples the modes.
        """
        matrices, root = self._in_time(capacity, self.modes.count)
        free = slice(1 if self._inner is None else 0, None)
        keep = np.unique(self._scatter(), return_index=True)[1]
        rates, vectors = np.linalg.eigh(matrices)
        left = (start - steady)[:, keep][:, free] * root
        amplitudes = np.einsum("jpa,jp->ja", vectors, left)
        faded = np.exp(-rates[None] * times[:, None, None]) * amplitudes
        rises = np.zeros((times.size, self.modes.count, keep.size))
        rises[:, :, free] = np.einsum("jpa,tja->tjp", vectors, faded) / root
        return np.asarray(steady + rises[:, :, self._scatter()])

    def slowest(self, capacity: float, count: int) -> NDArray[np.float64]:
        """Return the longest time constants of the approach to the steady state [s], the longest first.

        λ_j and the inner coefficient increase with j, so that each rate of a mode is at least the same rate of the
        mode before it. The `count` longest times are therefore among those of the first `count` modes. Arguments and
        errors are the same as in `approach`.
        """
        matrices, _ = self._in_time(capacity, min(count, self.modes.count))
        return np.sort(1.0 / np.linalg.eigvalsh(matrices).ravel())[::-1][:count]

    def _in_time(self, capacity: float, count: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the symmetric matrix of the rates for each of the first modes, and the scaling of the unknowns."""
        if not self.has_even_film:
            raise ValueError("convection must be a number for temperatures over time, got a function of theta")
        matrices = self._assemble(np.zeros((self.modes.count, self.place.size)))[0][:count]
        matrices[:, -1, -1] += float(self.modes.measure(np.array(self._outermost))) * self._film[0, 0]
        mass = np.zeros(matrices.shape[1])
        np.add.at(mass, self._scatter(), capacity * self.volume_weights())
        free = slice(1 if self._inner is None else 0, None)
        root = np.sqrt(mass[free])
        return matrices[:, free, free] / (root[:, None] * root), root

    def finely(self, values: NDArray[np.float64], parts: int = 128) -> NDArray[np.float64]:
        """Interpolate values at all points (first axis) to a finer grid, with the polynomial of each element."""
        to = np.linspace(-1.0, 1.0, parts + 1)
        basis = legendre.legvander(to, _POINTS - 1) @ np.linalg.inv(legendre.legvander(self._points, _POINTS - 1))
        elements = values.reshape(len(self._elements), _POINTS, -1)
        return np.asarray(np.concatenate([basis @ element for element in elements]))

    def volume_weights(self) -> NDArray[np.float64]:
        """Return the volume weight A dr at every point."""
        half = np.repeat([0.5 * (e.outer - e.inner) for e in self._elements], _POINTS)
        weights: NDArray[np.float64] = half * np.tile(self._weights, len(self._elements))
        return weights * self.modes.measure(self.place)

    def heat_inwards(self, source: NDArray[np.float64], rises: NDArray[np.float64]) -> float:
        """Return the heat that leaves through the inner surface [W]."""
        if self._inner is not None:
            area = float(self.modes.measure(np.array(self.place[0])))
            return float(self.modes.area @ (area * self._inner * rises[:, 0]))
        matrices, loads = self._assemble(source)
        keep = np.unique(self._scatter(), return_index=True)[1]
        reaction = np.einsum("jp,jp->j", matrices[:, 0], rises[:, keep]) - loads[:, 0]
        return float(-self.modes.area @ reaction)

    def heat_outwards(self, rises: NDArray[np.float64]) -> float:
        """Return the heat that leaves through the outer surface [W]."""
        area = float(self.modes.measure(np.array(self._outermost)))
        return float(self.modes.area @ (area * self._film @ rises[:, -1]))

    def heat_sideways(self, rises: NDArray[np.float64]) -> float:
        """Return the heat that leaves through the side faces [W]."""
        conductivity = np.repeat([e.conductivity for e in self._elements], _POINTS)
        taken = (self.modes.rate(self.place) * rises) @ (conductivity * self.volume_weights())
        return float(self.modes.area @ taken)

    def heat_of(self, source: NDArray[np.float64]) -> float:
        """Return the total heat of a source [W]."""
        return float(self.modes.area @ self._assemble(source)[1].sum(axis=1))

    def _scatter(self) -> NDArray[np.intp]:
        """Return the index of the unknown of each point; neighboring elements share the point between them."""
        inside = _POINTS - 1
        return np.concatenate([np.arange(e * inside, e * inside + _POINTS) for e in range(len(self._elements))])

    def _assemble(self, source: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        unknowns = len(self._elements) * (_POINTS - 1) + 1
        matrices = np.zeros((self.modes.count, unknowns, unknowns))
        loads = np.zeros((self.modes.count, unknowns))
        for number, element in enumerate(self._elements):
            half = 0.5 * (element.outer - element.inner)
            place = element.inner + half * (1.0 + self._points)
            weight = half * self._weights * self.modes.measure(place)
            slope = self._derivative / half
            stiffness = element.conductivity * slope.T @ (weight[:, None] * slope)
            first = number * (_POINTS - 1)
            part = slice(first, first + _POINTS)
            matrices[:, part, part] += stiffness
            inside = np.arange(first, first + _POINTS)
            matrices[:, inside, inside] += element.conductivity * weight * self.modes.rate(place)
            loads[:, part] += weight * source[:, number * _POINTS : (number + 1) * _POINTS]
        if self._inner is not None:
            matrices[:, 0, 0] += float(self.modes.measure(np.array(self.place[0]))) * self._inner
        return matrices, loads


def _elements(places: Sequence[float], conductivities: Sequence[float], modes: HeatModes) -> list[_Element]:
    """Divide layers into elements, each with at most as many e-folds of the highest mode as it resolves."""
    elements = []
    for layer, conductivity in enumerate(conductivities):
        inner, outer = places[layer], places[layer + 1]
        count = max(1, int(np.ceil(modes.folds(inner, outer) / _LONGEST)))
        cuts = np.linspace(inner, outer, count + 1)
        elements += [_Element(float(a), float(b), conductivity, layer) for a, b in pairwise(cuts)]
    return elements
