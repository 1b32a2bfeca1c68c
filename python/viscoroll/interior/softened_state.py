"""What a contact, solved with moduli of given strain, does in the layers that soften: the strain they have."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ..materials import SoftenedModulus, SofteningModulus
from ..solution.inside import Inside, Of
from .network_loss import turning_ratio
from .strain_path import StrainPath, half_range, harmonic_squares

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from .._support.arguments import Floats
    from ..rolling import Result

__all__ = ["LayerState", "Setting", "SofteningLayer", "State", "look"]

#: Of the network whose loss is followed, c to 4e-4, and the share of it that is: the rest turns as that does.
_ELEMENTS, _MOST = (12, 4), 0.999

#: Steps to the scale of the loss that belongs to given strain, and when they end.
_SCALE_STEPS, _SCALE_TOLERANCE = 20, 1e-6


@dataclass(frozen=True, slots=True)
class SofteningLayer:
    """A layer that softens: of which body, its number there (the base of a plane is 0), and its modulus."""

    of: Of
    number: int
    modulus: SofteningModulus


@dataclass(frozen=True, slots=True, kw_only=True)
class Setting:
    """What the modulus of a layer is taken at: amplitude [-], scale of the loss [-], frequency ω₀ [rad/s]."""

    amplitude: float
    scale: float
    frequency: float


@dataclass(frozen=True, kw_only=True, eq=False)
class LayerState:
    """What a pass found in one layer; losses are worked out when they are asked for.

    Attributes
    ----------
    layer : SofteningLayer
        Of which layer.
    solved : Setting
        That its modulus had.
    found : Setting
        That follows from this contact, with ḡ, mean of the amplitudes, weighted by what the network loses.
    turn : float
        Angular speed at which its material passes [rad/s].
    path : StrainPath
        Of its points.
    amplitudes : ndarray, shape (points,)
        g of each [-].
    """

    layer: SofteningLayer
    solved: Setting
    found: Setting
    turn: float
    path: StrainPath
    amplitudes: Floats

    @cached_property
    def scale(self) -> float:
        """Scale with which the harmonics of these paths lose what the network does [-]."""
        loops = _loops(self.layer, self.amplitudes) * self.path.volumes
        most = _most(loops)
        strain = self.layer.modulus.network.yield_strain
        turning = turning_ratio(self.path.p[most], self.amplitudes[most], strain, elements=_ELEMENTS)
        lost = float(loops.sum() * np.average(turning, weights=loops[most])) if loops.any() else 0.0
        return _matched(lost, lambda c: self._network_loss(replace(self.found, scale=c)), self.solved.scale)

    @cached_property
    def harmonic_loss(self) -> float:
        """What the network's modulus that was solved with loses, summed over harmonics [J/rad], under a line per m."""
        return self._network_loss(self.solved)

    @cached_property
    def shear_loss(self) -> float:
        """The same of matrix and network."""
        return self._summed(self._modulus(self.solved).complex_modulus)

    def _modulus(self, setting: Setting) -> SoftenedModulus:
        return self.layer.modulus.at(setting.amplitude, reference_frequency=setting.frequency, loss_scale=setting.scale)

    def _network_loss(self, setting: Setting) -> float:
        return self._summed(self._modulus(setting).network_modulus)

    @cached_property
    def _harmonics(self) -> tuple[Floats, Floats]:
        orders, squares = harmonic_squares(self.path)
        return self.turn * orders, self.path.volumes @ squares

    def _summed(self, modulus: Callable[[Floats], NDArray[np.complex128]]) -> float:
        frequency, squares = self._harmonics
        return float(squares @ modulus(frequency).imag)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class State:
    """A contact solved with moduli of given amplitudes and scales of the loss, a value of each for every layer."""

    amplitudes: Floats
    scales: Floats
    result: Result
    layers: tuple[LayerState, ...]

    @property
    def next_amplitudes(self) -> Floats:
        """Return the amplitudes that the contact has."""
        return np.array([layer.found.amplitude for layer in self.layers])

    @property
    def next_scales(self) -> Floats:
        """Return the scales with which the harmonics lose what the network does."""
        return np.array([layer.scale for layer in self.layers])


def look(inside: Inside, path: StrainPath, layer: SofteningLayer, solved: Setting, frequency: float) -> LayerState:
    """Return what a solved contact does in a layer, along the paths of its points."""
    g = half_range(path.p)
    loop = _loops(layer, g)
    weights = (loop if loop.any() else g**2) * path.volumes  # a network without loss has a mean amplitude, too
    return LayerState(
        layer=layer,
        solved=solved,
        found=replace(solved, amplitude=float((weights * g).sum() / weights.sum()), frequency=frequency),
        # The material of both bodies is solved as passing at Ω r_o.
        turn=inside.result.angular_speed * inside.result.ball.outer_radius / inside.radius,
        path=path,
        amplitudes=g,
    )


def _most(losses: Floats) -> NDArray[np.intp]:
    """Return the points that hold most of the loss."""
    largest = np.argsort(losses)[::-1]
    held = np.cumsum(losses[largest])
    return largest[: 1 + int(np.searchsorted(held, _MOST * held[-1]))]


def _loops(layer: SofteningLayer, amplitudes: Floats) -> Floats:
    """Return what the network loses to and fro at amplitudes, π g² N'' [J/m³]."""
    loops: Floats = math.pi * amplitudes**2 * layer.modulus.network.at(amplitudes)[1]
    return loops


def _matched(lost: float, harmonic: Callable[[float], float], scale: float) -> float:
    """Return the scale with which the harmonics lose as much; they are all but proportional to it."""
    for _ in range(_SCALE_STEPS):
        summed = harmonic(scale)
        if summed <= 0.0 or lost <= 0.0:
            return 1.0
        scale *= lost / summed
        if abs(lost - summed) < _SCALE_TOLERANCE * lost:
            break
    return scale
