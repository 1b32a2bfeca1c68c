"""Strain amplitudes and losses of the softening layers in a contact solved with given moduli."""

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

__all__ = ["LayerState", "Setting", "SofteningLayer", "State", "layer_state"]

#: Numbers of elements for the loss of the network (the relative error of the scale c is 4e-4), and fraction of the loss
#: that is contained in the points at which χ is computed.
_ELEMENTS, _LOSS_FRACTION = (12, 4), 0.999

#: Largest number of iterations for the loss scale at given strain, and their relative tolerance.
_SCALE_STEPS, _SCALE_TOLERANCE = 20, 1e-6


@dataclass(frozen=True, slots=True)
class SofteningLayer:
    """Layer that softens: its body, its number in the body (0 is the base of a plane), and its modulus."""

    of: Of
    number: int
    modulus: SofteningModulus


@dataclass(frozen=True, slots=True, kw_only=True)
class Setting:
    """Arguments of a layer's modulus: amplitude [-], scale of the loss [-], reference frequency ω₀ [rad/s]."""

    amplitude: float
    scale: float
    frequency: float


@dataclass(frozen=True, kw_only=True, eq=False)
class LayerState:
    """State of one layer in a pass; its losses are computed when they are first read.

    Attributes
    ----------
    layer : SofteningLayer
        Layer that softens.
    solved : Setting
        Setting of its modulus in the solved contact.
    found : Setting
        Setting that follows from this contact. Its amplitude ḡ is the mean weighted by the loss of the network.
    passing_speed : float
        Angular speed at which its material passes the contact [rad/s].
    path : StrainPath
        Strain paths of its points.
    amplitudes : ndarray, shape (points,)
        Amplitude g of each point [-].
    """

    layer: SofteningLayer
    solved: Setting
    found: Setting
    passing_speed: float
    path: StrainPath
    amplitudes: Floats

    @cached_property
    def scale(self) -> float:
        """Factor on N'' with which the harmonics of these paths dissipate as much as the network [-]."""
        losses = _straight_losses(self.layer, self.amplitudes) * self.path.volumes
        most = _largest_losses(losses)
        strain = self.layer.modulus.network.yield_strain
        turning = turning_ratio(self.path.p[most], self.amplitudes[most], strain, elements=_ELEMENTS)
        lost = float(losses.sum() * np.average(turning, weights=losses[most])) if losses.any() else 0.0
        return _matching_scale(lost, lambda c: self._network_loss(replace(self.found, scale=c)), self.solved.scale)

    @cached_property
    def harmonic_loss(self) -> float:
        """Loss of the network's modulus in the solve, summed over harmonics [J/rad], in line contact per m."""
        return self._network_loss(self.solved)

    @cached_property
    def shear_loss(self) -> float:
        """Loss of matrix and network in the solve, summed over harmonics [J/rad], in line contact per m."""
        return self._summed(self._modulus(self.solved).complex_modulus)

    def _modulus(self, setting: Setting) -> SoftenedModulus:
        return self.layer.modulus.at(setting.amplitude, reference_frequency=setting.frequency, loss_scale=setting.scale)

    def _network_loss(self, setting: Setting) -> float:
        return self._summed(self._modulus(setting).network_modulus)

    @cached_property
    def _harmonics(self) -> tuple[Floats, Floats]:
        orders, squares = harmonic_squares(self.path)
        return self.passing_speed * orders, self.path.volumes @ squares

    def _summed(self, modulus: Callable[[Floats], NDArray[np.complex128]]) -> float:
        frequency, squares = self._harmonics
        return float(squares @ modulus(frequency).imag)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class State:
    """Contact solved with given amplitudes and loss scales, one of each for every softening layer."""

    amplitudes: Floats
    scales: Floats
    result: Result
    layers: tuple[LayerState, ...]

    @property
    def next_amplitudes(self) -> Floats:
        """Amplitudes that follow from the contact."""
        return np.array([layer.found.amplitude for layer in self.layers])

    @property
    def next_scales(self) -> Floats:
        """Factors on N'' with which the harmonics dissipate as much as the network."""
        return np.array([layer.scale for layer in self.layers])


def layer_state(
    inside: Inside, path: StrainPath, layer: SofteningLayer, solved: Setting, frequency: float
) -> LayerState:
    """Return the state of a layer in a solved contact, from the strain paths of its points."""
    g = half_range(path.p)
    losses = _straight_losses(layer, g)
    weights = (losses if losses.any() else g**2) * path.volumes  # g² also weights a network without loss
    return LayerState(
        layer=layer,
        solved=solved,
        found=replace(solved, amplitude=float((weights * g).sum() / weights.sum()), frequency=frequency),
        # In the solve, the material of both bodies passes the contact at Ω r_o.
        passing_speed=inside.result.angular_speed * inside.result.body.outer_radius / inside.radius,
        path=path,
        amplitudes=g,
    )


def _largest_losses(losses: Floats) -> NDArray[np.intp]:
    """Return the points with the largest losses, which together contain most of the loss."""
    largest = np.argsort(losses)[::-1]
    cumulative = np.cumsum(losses[largest])
    return largest[: 1 + int(np.searchsorted(cumulative, _LOSS_FRACTION * cumulative[-1]))]


def _straight_losses(layer: SofteningLayer, amplitudes: Floats) -> Floats:
    """Return the loss of the network in straight cycles of given amplitudes, π g² N'' [J/m³]."""
    losses: Floats = math.pi * amplitudes**2 * layer.modulus.network.at(amplitudes)[1]
    return losses


def _matching_scale(lost: float, harmonic: Callable[[float], float], scale: float) -> float:
    """Return the scale with which the harmonics dissipate the given energy, which is almost proportional to it."""
    for _ in range(_SCALE_STEPS):
        summed = harmonic(scale)
        if summed <= 0.0 or lost <= 0.0:
            return 1.0
        scale *= lost / summed
        if abs(lost - summed) < _SCALE_TOLERANCE * lost:
            break
    return scale
