"""Heat conduction in layers, with the temperature expanded in modes along the surface.

The temperature is T = Σ T_j(r) Y_j. The modes Y_j satisfy -∇²Y_j = λ_j Y_j along the surface (`heat_modes`). With the
surface area A at r (`HeatModes.measure`), each T_j satisfies -(k A T_j')' + k A λ_j T_j = A q_j. Every layer is divided
into one or more spectral elements with Gauss-Lobatto points. The weak form conserves heat to round-off.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .._support.errors import InvalidInput

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from .heat_modes import HeatModes

__all__ = ["Conduction"]

_POINTS = 17  # Gauss-Lobatto points per element; the quadrature is exact to degree 31
_MAX_FOLDS = 16.0  # largest number of e-folds of the highest mode across an element


def _lobatto(count: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the Gauss-Lobatto points on [-1, 1], their quadrature weights and the differentiation matrix."""
    basis = np.polynomial.legendre.Legendre.basis(count - 1)
    points = np.concatenate([[-1.0], np.sort(basis.deriv().roots().real), [1.0]])
    values = basis(points)
    weights = 2.0 / (count * (count - 1) * values**2)
    gaps = points[:, None] - points[None, :] + np.eye(count)
    derivative = values[:, None] / values[None, :] / gaps
    np.fill_diagonal(derivative, 0.0)
    derivative[np.diag_indices(count)] = -derivative.sum(axis=1)
    return points, weights, derivative


@dataclass(frozen=True, slots=True)
class _Element:
    """Spectral element between two radii or heights [m] in a layer with a conductivity [W/(m K)]."""

    inner: float
    outer: float
    conductivity: float
    layer: int


class Conduction:
    """Heat conduction in a stack of layers.

    Parameters
    ----------
    boundaries : sequence of float
        Boundaries of the layers from the inside outwards [m]: radii, or heights in a slab.
    conductivities : sequence of float
        Conductivity of each layer [W/(m K)].
    modes : HeatModes
        Modes of the temperature along the surface.
    film : float or ndarray, shape (modes, modes)
        Heat transfer coefficient of convection at the outer surface [W/(m² K)]. If it varies along the surface, the
        matrix that multiplies the mode amplitudes (`film_matrix_of_ball`, `film_matrix_of_wheel`).
    inner : ndarray or None, shape (modes,)
        Heat transfer coefficient at the inner surface for each mode [W/(m² K)], 0 for an insulated surface. None if
        the temperature of the inner surface is given.

    Attributes
    ----------
    coordinate : ndarray, shape (points,)
        Radius or height of every point of the elements [m].
    layer : ndarray, shape (points,)
        Number of the layer of every point.
    """

    def __init__(
        self,
        boundaries: Sequence[float],
        conductivities: Sequence[float],
        modes: HeatModes,
        *,
        film: float | NDArray[np.float64],
        inner: NDArray[np.float64] | None,
    ) -> None:
        self.modes = modes
        self._inner = inner
        self._outermost = boundaries[-1]
        self._points, self._weights, self._derivative = _lobatto(_POINTS)
        self._elements = _elements(boundaries, conductivities, modes)
        self.coordinate, self.layer = self._nodes()
        self._film = film * np.eye(modes.count) if np.ndim(film) == 0 else np.asarray(film)

    def _nodes(self) -> tuple[NDArray[np.float64], NDArray[np.int_]]:
        """Return coordinate and layer of every point; the point between two elements occurs twice."""
        coordinates = [e.inner + 0.5 * (e.outer - e.inner) * (1.0 + self._points) for e in self._elements]
        return np.concatenate(coordinates), np.repeat([e.layer for e in self._elements], _POINTS)

    @property
    def has_uniform_film(self) -> bool:
        """Whether convection is uniform over the outer surface, so that the modes are independent."""
        return bool(np.array_equal(self._film, self._film[0, 0] * np.eye(self.modes.count)))

    def solve(self, source: NDArray[np.float64], inner_rise: float = 0.0) -> NDArray[np.float64]:
        """Return T_j at every point, one row per mode [K].

        Parameters
        ----------
        source : ndarray, shape (modes, points)
            Heat source q_j at every point [W/m³].
        inner_rise : float
            Temperature of the inner surface minus that of the surroundings [K]; used only if `inner` is None.
        """
        matrices, loads = self._assemble(source)
        surface = matrices.shape[1] - 1
        film = self._film
        area = float(self.modes.measure(np.array(self._outermost)))
        fixed = self._inner is None
        prescribed = self.modes.unity * inner_rise
        if fixed:
            loads = loads - matrices[:, :, 0] * prescribed[:, None]
            matrices, loads, surface = matrices[:, 1:, 1:], loads[:, 1:], surface - 1
        mean = film[0, 0]
        diagonal = matrices.copy()
        diagonal[:, surface, surface] += area * mean
        unit = np.zeros(matrices.shape[1])
        unit[surface] = 1.0
        solutions = np.linalg.solve(diagonal, np.stack([loads, np.broadcast_to(unit, loads.shape)], axis=-1))
        uncoupled, response = solutions[..., 0], solutions[..., 1]
        variation = film - mean * np.eye(self.modes.count)  # couples the modes at the surface only
        rises = uncoupled
        if np.abs(variation).max() > 1e-14 * max(mean, 1e-300):
            system = np.eye(self.modes.count) + area * response[:, surface, None] * variation
            at_surface = np.linalg.solve(system, uncoupled[:, surface])
            rises = uncoupled - response * (area * variation @ at_surface)[:, None]
        if fixed:
            rises = np.concatenate([prescribed[:, None], rises], axis=1)
        return np.asarray(rises[:, self._scatter()], dtype=np.float64)

    def transient(
        self, steady: NDArray[np.float64], start: NDArray[np.float64], times: NDArray[np.float64], capacity: float
    ) -> NDArray[np.float64]:
        """Return T_j over time, from the eigenvectors of ρc A ∂T/∂t + conduction = source.

        Parameters
        ----------
        steady, start : ndarray, shape (modes, points)
            T_j of the steady state and of the initial state at every point [K].
        times : ndarray
            Times [s], ≥ 0.
        capacity : float
            Heat capacity per volume ρc [J/(m³ K)].

        Returns
        -------
        ndarray, shape (times, modes, points)
            T_j at the given times [K].

        Raises
        ------
        ValueError
            If convection varies along the surface, which couples the modes.
        """
        matrices, root = self._rate_matrices(capacity, self.modes.count)
        free = slice(1 if self._inner is None else 0, None)
        keep = np.unique(self._scatter(), return_index=True)[1]
        rates, vectors = np.linalg.eigh(matrices)
        deviation = (start - steady)[:, keep][:, free] * root
        amplitudes = np.einsum("jpa,jp->ja", vectors, deviation)
        decayed = np.exp(-rates[None] * times[:, None, None]) * amplitudes
        rises = np.zeros((times.size, self.modes.count, keep.size))
        rises[:, :, free] = np.einsum("jpa,tja->tjp", vectors, decayed) / root
        return np.asarray(steady + rises[:, :, self._scatter()])

    def time_constants(self, capacity: float, count: int) -> NDArray[np.float64]:
        """Return the longest time constants of the decay to the steady state [s], the longest first.

        λ_j and the inner heat transfer coefficient increase with j. The i-th lowest decay rate of a mode is therefore
        at least that of the previous mode, and the `count` longest times are among those of the first `count` modes.
        Arguments and errors are the same as in `transient`.
        """
        matrices, _ = self._rate_matrices(capacity, min(count, self.modes.count))
        return np.sort(1.0 / np.linalg.eigvalsh(matrices).ravel())[::-1][:count]

    def _rate_matrices(self, capacity: float, count: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the symmetric matrices of the decay rates of the first modes, and the root of the heat capacities."""
        if not self.has_uniform_film:
            raise InvalidInput("convection", "must be a number for temperatures over time", "a function of theta")
        matrices = self._assemble(np.zeros((self.modes.count, self.coordinate.size)))[0][:count]
        matrices[:, -1, -1] += float(self.modes.measure(np.array(self._outermost))) * self._film[0, 0]
        mass = np.zeros(matrices.shape[1])
        np.add.at(mass, self._scatter(), capacity * self.volume_weights())
        free = slice(1 if self._inner is None else 0, None)
        root = np.sqrt(mass[free])
        return matrices[:, free, free] / (root[:, None] * root), root

    def refined(self, values: NDArray[np.float64], parts: int = 128) -> NDArray[np.float64]:
        """Interpolate values at all points (first axis) to the ends of `parts` equal intervals in each element."""
        targets = np.linspace(-1.0, 1.0, parts + 1)
        basis = np.polynomial.legendre.legvander(targets, _POINTS - 1) @ np.linalg.inv(
            np.polynomial.legendre.legvander(self._points, _POINTS - 1)
        )
        elements = values.reshape(len(self._elements), _POINTS, -1)
        return np.asarray(np.concatenate([basis @ element for element in elements]))

    def volume_weights(self) -> NDArray[np.float64]:
        """Return the quadrature weight A dr of the volume at every point."""
        half = np.repeat([0.5 * (e.outer - e.inner) for e in self._elements], _POINTS)
        weights: NDArray[np.float64] = half * np.tile(self._weights, len(self._elements))
        return weights * self.modes.measure(self.coordinate)

    def heat_inwards(self, source: NDArray[np.float64], rises: NDArray[np.float64]) -> float:
        """Return the heat that leaves through the inner surface [W]."""
        if self._inner is not None:
            area = float(self.modes.measure(np.array(self.coordinate[0])))
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
        by_mode = (self.modes.rate(self.coordinate) * rises) @ (conductivity * self.volume_weights())
        return float(self.modes.area @ by_mode)

    def total_heat(self, source: NDArray[np.float64]) -> float:
        """Return the heat that a source generates in all layers [W]."""
        return float(self.modes.area @ self._assemble(source)[1].sum(axis=1))

    def _scatter(self) -> NDArray[np.intp]:
        """Return the index of the unknown of each point; the two points between elements share one unknown."""
        step = _POINTS - 1
        return np.concatenate([np.arange(e * step, e * step + _POINTS) for e in range(len(self._elements))])

    def _assemble(self, source: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the conduction matrix and the source vector of each mode, without convection at the outer surface."""
        unknowns = len(self._elements) * (_POINTS - 1) + 1
        matrices = np.zeros((self.modes.count, unknowns, unknowns))
        loads = np.zeros((self.modes.count, unknowns))
        for number, element in enumerate(self._elements):
            half = 0.5 * (element.outer - element.inner)
            coordinate = element.inner + half * (1.0 + self._points)
            weight = half * self._weights * self.modes.measure(coordinate)
            slope = self._derivative / half
            stiffness = element.conductivity * slope.T @ (weight[:, None] * slope)
            first = number * (_POINTS - 1)
            part = slice(first, first + _POINTS)
            matrices[:, part, part] += stiffness
            unknown = np.arange(first, first + _POINTS)
            matrices[:, unknown, unknown] += element.conductivity * weight * self.modes.rate(coordinate)
            loads[:, part] += weight * source[:, number * _POINTS : (number + 1) * _POINTS]
        if self._inner is not None:
            matrices[:, 0, 0] += float(self.modes.measure(np.array(self.coordinate[0]))) * self._inner
        return matrices, loads


def _elements(boundaries: Sequence[float], conductivities: Sequence[float], modes: HeatModes) -> list[_Element]:
    """Divide the layers into elements across which the highest mode has at most `_MAX_FOLDS` e-folds."""
    elements = []
    for layer, conductivity in enumerate(conductivities):
        inner, outer = boundaries[layer], boundaries[layer + 1]
        count = max(1, int(np.ceil(modes.folds(inner, outer) / _MAX_FOLDS)))
        cuts = np.linspace(inner, outer, count + 1)
        elements += [_Element(float(a), float(b), conductivity, layer) for a, b in pairwise(cuts)]
    return elements
