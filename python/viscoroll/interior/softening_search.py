"""The search for the strain that layers soften to: contact, strain and modulus found together.

A pass solves the contact with one modulus for each layer, follows the strain inside and takes from it the layer's
amplitude ḡ, weighted by what its network loses. A contact grows where its layers soften, so that their strain falls
with the modulus by less than the modulus itself: plain repetition converges, to the one state that there is (theory.md
section 17).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import ConvergenceError
from .._support.cautions import kept_in_results
from ..bodies import Counterpart, RollingBody
from ..bodies.layered import materials_of, with_materials
from ..materials import Network, SoftenedModulus, SofteningModulus
from ..rolling import solve
from ..solution.inside import Inside, Of, inside_of
from .network_loss import turning_ratio
from .strain_path import StrainPath, half_range, harmonic_squares, strain_paths

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .._support.arguments import Floats
    from .._support.progress import Report
    from ..rolling import Result

__all__ = ["LayerState", "SofteningLayer", "SofteningSearch", "State", "softening_layers", "softens"]

#: Passes after which the frequency at which the network is taken stays: the contact's length steps with the nodes.
_FREQUENCY_PASSES = 3

#: Passes after which the mesh stays: the contact of the unstrained layers, the first, is smaller than all others.
_MESH_PASSES = 2

_MOST_PASSES = 40

#: Steps to the scale of the loss that belongs to given strain, and when they end.
_SCALE_STEPS, _SCALE_TOLERANCE = 20, 1e-6

#: Speed by radius per half-width of the first contact, before it is known.
_FIRST_FREQUENCY = 10.0


@dataclass(frozen=True, slots=True)
class SofteningLayer:
    """A layer that softens: of which body, its number there (the base of a plane is 0), and its modulus."""

    of: Of
    number: int
    modulus: SofteningModulus


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class LayerState:
    """What a pass found in one layer.

    Attributes
    ----------
    amplitude : float
        ḡ, mean of the amplitudes, weighted by what the network loses [-].
    path : StrainPath
        Of its points.
    amplitudes : ndarray, shape (points,)
        g of each [-].
    scale : float
        With which the harmonics of these paths lose what the network does [-].
    harmonic_loss : float
        What the modulus of the network that was solved with loses, summed over harmonics [J/rad], under a line per
        length.
    shear_loss : float
        The same of matrix and network.
    """

    amplitude: float
    path: StrainPath
    amplitudes: Floats
    scale: float
    harmonic_loss: float
    shear_loss: float


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
        return np.array([layer.amplitude for layer in self.layers])

    @property
    def next_scales(self) -> Floats:
        """Return the scales with which the harmonics lose what the network does."""
        return np.array([layer.scale for layer in self.layers])


@dataclass(slots=True, kw_only=True, eq=False)
class SofteningSearch:
    """Contacts solved one after the other, on one mesh once it is found."""

    ball: RollingBody
    on: Counterpart | None
    layers: tuple[SofteningLayer, ...]
    load: float
    angular_speed: float
    options: dict[str, Any]
    depths: int
    report: Report | None
    frequencies: dict[Of, float] = field(default_factory=dict)
    passes: int = 0
    contacts: int = 0

    def converged(self, start: State | None, *, matched: bool, tolerance: float) -> tuple[State, tuple[Floats, ...]]:
        """Return the state whose moduli are those of its own strain, and the amplitudes of all passes on the way.

        Parameters
        ----------
        start : State, optional
            Where to go on; without it the layers are unstrained.
        matched : bool
            Whether the loss of harmonics is matched to that of the network; else scales are 1.
        tolerance : float
            By which share amplitudes and scales may still change.

        Raises
        ------
        ConvergenceError
            Where they do not come to rest.
        """
        count = len(self.layers)
        state = self.at(np.zeros(count), np.ones(count)) if start is None else start
        history = [state.next_amplitudes]
        while True:
            amplitudes, scales = state.next_amplitudes, state.next_scales if matched else np.ones(count)
            change = max(_change(state.amplitudes, amplitudes), _change(state.scales, scales))
            if change <= tolerance:
                return state, tuple(history)
            if self.passes >= _MOST_PASSES:
                raise ConvergenceError(
                    f"strain softening did not come to rest in {_MOST_PASSES} passes: the last changed amplitudes or "
                    f"losses by {change:.2g} of themselves"
                )
            state = self.at(amplitudes, scales)
            history.append(state.next_amplitudes)

    def at(self, amplitudes: Floats, scales: Floats) -> State:
        """Solve the contact at amplitudes and scales, and look at the strain that it makes."""
        result = self.solved(amplitudes, scales)
        self.passes += 1
        if self.report is not None:
            self.report("passes", self.passes / _MOST_PASSES)
        if self.passes >= _MESH_PASSES:
            self.options |= {"mesh": result.mesh, "accuracy": None}
        layers: list[LayerState] = []
        for of in dict.fromkeys(layer.of for layer in self.layers):
            inside = inside_of(result, of)
            solved_at = self._frequency(of)
            if self.passes <= _FREQUENCY_PASSES:
                self.frequencies[of] = _frequency(inside)
            chosen = [(place, layer) for place, layer in enumerate(self.layers) if layer.of == of]
            paths = strain_paths(inside, [layer.number for _, layer in chosen], depths=self.depths)
            for path, (place, layer) in zip(paths, chosen, strict=True):
                at = partial(layer.modulus.at, float(amplitudes[place]), reference_frequency=solved_at)
                layers.append(_seen(inside, path, layer.modulus.network, at, float(scales[place])))
        return State(amplitudes=amplitudes, scales=scales, result=result, layers=tuple(layers))

    def solved(self, amplitudes: Floats, scales: Floats, **options: Any) -> Result:
        """Solve the contact at amplitudes and scales; `options` replace those of the search."""
        moduli = {
            (layer.of, layer.number): layer.modulus.at(
                float(amplitude), reference_frequency=self._frequency(layer.of), loss_scale=float(scale)
            )
            for layer, amplitude, scale in zip(self.layers, amplitudes, scales, strict=True)
        }
        ball, on = _with_moduli(self.ball, "ball", moduli), self.on
        self.contacts += 1
        with kept_in_results():
            return solve(
                ball,
                on=None if on is None else _with_moduli(on, "counterpart", moduli),
                load=self.load,
                angular_speed=self.angular_speed,
                **(self.options | options),
            )

    def _frequency(self, of: Of) -> float:
        return self.frequencies.get(of, _FIRST_FREQUENCY * self.angular_speed)


def softening_layers(ball: RollingBody, on: Counterpart | None) -> tuple[SofteningLayer, ...]:
    """Return the layers that soften, of what rolls and then of what it rolls on."""
    sides: list[tuple[Of, RollingBody | Counterpart]] = [("ball", ball)]
    if on is not None:
        sides.append(("counterpart", on))
    return tuple(
        SofteningLayer(of, number, material.shear_modulus)
        for of, body in sides
        for number, material in enumerate(materials_of(body))
        if isinstance(material.shear_modulus, SofteningModulus)
    )


def softens(ball: RollingBody, on: Counterpart | None = None) -> bool:
    """Return whether a layer of a body, or of what it rolls on, has a modulus that falls with strain."""
    return bool(softening_layers(ball, on))


def _with_moduli(body: Any, of: Of, moduli: dict[tuple[Of, int], SoftenedModulus]) -> Any:
    materials = list(materials_of(body))
    for number, material in enumerate(materials):
        if (of, number) in moduli:
            materials[number] = replace(material, shear_modulus=moduli[of, number])
    return with_materials(body, materials)


def _frequency(inside: Inside) -> float:
    """Return Ω R/a, at which the network is what a sweep at its amplitude has [rad/s]."""
    half_width = inside.result.semi_axis_x or inside.result.ball.outer_radius * inside.result.mesh.spacing
    return inside.result.angular_speed * inside.result.ball.outer_radius / half_width


def _seen(
    inside: Inside, path: StrainPath, network: Network, at: Callable[..., SoftenedModulus], scale: float
) -> LayerState:
    """Return what a solved contact does in a layer.

    Parameters
    ----------
    inside, path
        The body, and the strain in one of its layers.
    network : Network
        Of that layer.
    at : callable
        Its modulus at the amplitude it was solved at, as a function of `loss_scale`.
    scale : float
        That it was solved with [-].
    """
    # The material of both bodies is solved as passing at Ω r_o.
    turn = inside.result.angular_speed * inside.result.ball.outer_radius / inside.radius
    g = half_range(path.p)
    loop = math.pi * g**2 * network.at(g)[1]
    weights = (loop if loop.any() else g**2) * path.volumes  # a network without loss has a mean amplitude, too
    lost = float((loop * turning_ratio(path.p, g, network.yield_strain) * path.volumes).sum())

    orders, squares = harmonic_squares(path)
    frequency, summed = turn * orders, path.volumes @ squares

    def harmonic(modulus: Callable[[Floats], NDArray[np.complex128]]) -> float:
        return float(summed @ modulus(frequency).imag)

    modulus = at(loss_scale=scale)
    return LayerState(
        amplitude=float((weights * g).sum() / weights.sum()),
        path=path,
        amplitudes=g,
        scale=_matched(lost, lambda c: harmonic(at(loss_scale=c).network_modulus), scale),
        harmonic_loss=harmonic(modulus.network_modulus),
        shear_loss=harmonic(modulus.complex_modulus),
    )


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


def _change(old: Floats, new: Floats) -> float:
    return float((np.abs(new - old) / np.maximum(np.abs(new), 1e-300)).max(initial=0.0))
