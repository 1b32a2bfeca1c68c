"""Search for the strain of layers that soften: contact, strain and moduli are solved together.

A pass solves the contact with one modulus for each layer, evaluates the strain inside and computes the amplitude ḡ of
each layer, weighted by the loss of its network. At a given load the contact grows as its layers soften, so that
ḡ ∝ |μ|^-α with α from 1/3 to 2/3. With α from the last two passes, the next amplitude is the one at which this law
agrees with the modulus of the network. There is only one solution (docs/theory/filled-rubber.md). If a step does not
reduce the change, the search continues with fixed-point iteration, which converges.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import ConvergenceError
from .._support.result_warnings import silenced
from ..bodies import Counterbody, Mesh, RollingBody
from ..bodies.layered import materials_of, with_materials
from ..materials import SoftenedModulus
from ..materials.softening import depends_on_strain
from ..rolling import solve
from ..solution.inside import Inside, Of, inside_of
from ..solution.solution import Solution
from .softened_state import Setting, SofteningLayer, State, layer_state
from .strain_path import strain_paths

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .._support.arguments import Floats
    from .._support.progress import Report
    from ..rolling import Result

__all__ = ["SofteningSearch", "softening_layers", "softens"]

#: Number of passes after which the reference frequency is kept, because the contact length changes in steps of nodes.
#: After passes on a coarser mesh, one pass on the final mesh determines it.
_FREQUENCY_PASSES = 3

#: Number of passes after which the mesh chosen by the solver is kept: the first contact, of unstrained layers, is the
#: smallest.
_MESH_PASSES = 2

#: Largest number of passes.
_MAX_PASSES = 40

#: Start of the search on a mesh of half the nodes: fewest nodes of that mesh, largest number of passes on it, and
#: relative change of the amplitudes at which they end.
_FEWEST_NODES = 200
_COARSE_PASSES, _COARSE_CHANGE = 4, 0.03

#: Ratio ω₀/Ω = R/a of radius to half-width that is assumed before the first contact is solved.
_FIRST_FREQUENCY = 10.0

#: Options of `strain_paths` on the coarser mesh.
_COARSE_OPTIONS: dict[str, Any] = {"depths": 3, "orders": 12.0, "reach": 5.0}

#: Possible error of α.
_POWER_ERROR = 0.1

#: Value of α before two passes determine it, smallest change of ln|μ| that determines it, and its range. A layer that
#: softens next to a layer that does not can have values up to 1; coarse meshes can give any value.
_FIRST_POWER, _SMALLEST_LOG_RATIO, _POWERS = 0.5, 0.02, (0.2, 1.0)

#: Largest number of fixed-point steps to the amplitudes of the law, and their relative tolerance.
_LAW_STEPS, _LAW_TOLERANCE = 40, 1e-7


@dataclass(slots=True, kw_only=True, eq=False)
class SofteningSearch:
    """Sequence of contact solutions, on one mesh once it is chosen.

    Attributes
    ----------
    angular_speed : float
        Angular speed at which linear theory is solved [rad/s].
    options : dict
        Further arguments of `viscoroll.solve`, among them the given one of `angular_speed` and `speed`.
    history : list of ndarray
        Amplitudes that follow from each pass.
    contacts : int
        Number of contacts solved.
    """

    body: RollingBody
    on: Counterbody | None
    layers: tuple[SofteningLayer, ...]
    load: float | None
    angular_speed: float
    options: dict[str, Any]
    depths: int
    report: Report | None
    frequencies: dict[Of, float] = field(default_factory=dict)
    history: list[Floats] = field(default_factory=list)
    contacts: int = 0
    _frequency_passes: int = _FREQUENCY_PASSES
    _powers: Floats | None = None
    _last: State | None = None

    def converged(self, start: State | None = None, *, matched: bool, tolerance: float) -> State:
        """Return the state whose moduli are those of its own strain.

        Parameters
        ----------
        start : State, optional
            State from which the search continues; by default the layers are unstrained.
        matched : bool
            Whether the loss of the harmonics is matched to that of the network; otherwise the scales are 1.
        tolerance : float
            Largest relative change of amplitudes and scales at convergence.

        Raises
        ------
        ConvergenceError
            If amplitudes and scales do not converge.
        """
        state, before = self._from_unstrained(matched) if start is None else start, np.inf
        while True:
            scales = state.next_scales if matched else np.ones(len(self.layers))
            change = max(_change(state.amplitudes, state.next_amplitudes), _change(state.scales, scales))
            if change <= tolerance:
                return state
            if len(self.history) >= _MAX_PASSES:
                raise ConvergenceError(
                    f"strain softening did not converge in {_MAX_PASSES} passes: the relative change of amplitudes "
                    f"or losses in the last one was {change:.2g}"
                )
            state = self.at(self._predicted(state, scales) if change < before else state.next_amplitudes, scales)
            before = change

    def for_other_loss(self, state: State, *, matched: bool, tolerance: float) -> tuple[Floats, Floats]:
        """Return amplitudes and scales for the other kind of loss, starting from a state with one kind.

        For the harmonic loss, the law ḡ ∝ |μ|^-α alone gives the amplitudes, unless its error may exceed the tolerance.
        In all other cases the search iterates.
        """
        scales = state.next_scales if matched else np.ones(len(self.layers))
        if (scales == state.scales).all():
            return state.amplitudes, scales
        amplitudes = self._predicted(state, scales)
        if matched or _POWER_ERROR * abs(self._log_stiffness_ratios(state, amplitudes, scales)).max() > tolerance:
            found = self.converged(self.at(amplitudes, scales), matched=matched, tolerance=tolerance)
            amplitudes, scales = found.amplitudes, found.scales
        return amplitudes, scales

    def at(self, amplitudes: Floats, scales: Floats, *, coarse: Mesh | None = None) -> State:
        """Solve the contact for amplitudes and scales, and evaluate its strain; at fewer points on a coarse mesh."""
        settings = [
            Setting(amplitude=float(amplitude), scale=float(scale), frequency=self._frequency(layer.of))
            for layer, amplitude, scale in zip(self.layers, amplitudes, scales, strict=True)
        ]
        result = self.solved(amplitudes, scales, **({} if coarse is None else {"mesh": coarse}))
        rough = {} if coarse is None else _COARSE_OPTIONS
        found = {}
        for of in dict.fromkeys(layer.of for layer in self.layers):
            inside = inside_of(result, of)
            if coarse is not None or len(self.history) < self._frequency_passes:
                self.frequencies[of] = _frequency(inside)
            chosen = [position for position, layer in enumerate(self.layers) if layer.of == of]
            paths = strain_paths(
                inside, [self.layers[position].number for position in chosen], **({"depths": self.depths} | rough)
            )
            for position, path in zip(chosen, paths, strict=True):
                found[position] = layer_state(
                    inside, path, self.layers[position], settings[position], self._frequency(of)
                )
        layers = tuple(found[position] for position in range(len(self.layers)))
        state = State(amplitudes=amplitudes, scales=scales, result=result, layers=layers)
        self.history.append(state.next_amplitudes)
        if len(self.history) >= _MESH_PASSES and coarse is None:
            self.options |= {"mesh": result.mesh, "accuracy": None}
        self._update_powers(state)
        if self.report is not None:
            self.report("passes", len(self.history) / _MAX_PASSES)
        return state

    def solved(self, amplitudes: Floats, scales: Floats, **options: Any) -> Result:
        """Solve the contact for amplitudes and scales; `options` replace those of the search."""
        moduli = {
            (layer.of, layer.number): layer.modulus.at(
                float(amplitude), reference_frequency=self._frequency(layer.of), loss_scale=float(scale)
            )
            for layer, amplitude, scale in zip(self.layers, amplitudes, scales, strict=True)
        }
        body, on = _with_moduli(self.body, "body", moduli), self.on
        self.contacts += 1
        with silenced():
            return solve(
                body,
                on=None if on is None else _with_moduli(on, "counterbody", moduli),
                load=self.load,
                **(self.options | options),
            )

    def _from_unstrained(self, matched: bool) -> State:
        """Return the first state on the mesh of the search, after passes on a coarser mesh if it has enough nodes."""
        amplitudes, scales = np.zeros(len(self.layers)), np.ones(len(self.layers))
        coarse = _coarser(self.options.get("mesh"))
        for _ in range(0 if coarse is None else _COARSE_PASSES):
            state = self.at(amplitudes, scales, coarse=coarse)
            is_close = _change(state.amplitudes, state.next_amplitudes) < _COARSE_CHANGE
            if is_close and matched:
                scales = state.next_scales
            amplitudes = self._predicted(state, scales)
            if is_close:
                break
        if coarse is not None:
            self._frequency_passes = len(self.history) + 1
        return self.at(amplitudes, scales)

    def _predicted(self, state: State, scales: Floats) -> Floats:
        """Return the amplitudes at which the law ḡ ∝ |μ|^-α through a state agrees with the modulus of the network."""
        amplitudes = found = state.next_amplitudes
        if not (found > 0.0).all():
            return found
        powers = np.full(len(self.layers), _FIRST_POWER) if self._powers is None else self._powers
        matrix = self._matrix_moduli()
        solved = self._stiffness(matrix, state.amplitudes, state.scales)
        for _ in range(_LAW_STEPS):
            before = amplitudes
            amplitudes = found * (self._stiffness(matrix, amplitudes, scales) / solved) ** -powers
            if _change(before, amplitudes) < _LAW_TOLERANCE:
                break
        return amplitudes

    def _update_powers(self, state: State) -> None:
        """Update α from the last two passes on the same mesh."""
        last, self._last = self._last, state
        if last is None or last.result.mesh != state.result.mesh:
            return
        log_ratios = self._log_stiffness_ratios(last, state.amplitudes, state.scales)
        if (abs(log_ratios) > _SMALLEST_LOG_RATIO).all() and (state.next_amplitudes > 0.0).all():
            larger = np.log(state.next_amplitudes / last.next_amplitudes)
            self._powers = np.clip(-larger / log_ratios, *_POWERS)

    def _log_stiffness_ratios(self, state: State, amplitudes: Floats, scales: Floats) -> Floats:
        """Return the logarithms of the ratios of the stiffness at amplitudes and scales to that in a state."""
        matrix = self._matrix_moduli()
        solved = self._stiffness(matrix, state.amplitudes, state.scales)
        return np.asarray(np.log(self._stiffness(matrix, amplitudes, scales) / solved))

    def _matrix_moduli(self) -> NDArray[np.complex128]:
        """Return the modulus of each layer's matrix at the reference frequency of its network [Pa]."""
        alone = [SoftenedModulus(matrix=layer.modulus.matrix, network=None) for layer in self.layers]
        frequencies = [self._frequency(layer.of) for layer in self.layers]
        return np.array([m.complex_modulus([w])[0] for m, w in zip(alone, frequencies, strict=True)])

    def _stiffness(self, matrix: NDArray[np.complex128], amplitudes: Floats, scales: Floats) -> Floats:
        """Return |μ| of matrix and network of each layer [Pa]."""
        networks = [layer.modulus.network.at(g) for layer, g in zip(self.layers, amplitudes, strict=True)]
        storage, loss = np.array(networks).T
        stiffness: Floats = abs(matrix + storage + 1j * scales * loss)
        return stiffness

    def _frequency(self, of: Of) -> float:
        return self.frequencies.get(of, _FIRST_FREQUENCY * self.angular_speed)


def softening_layers(body: RollingBody, on: Counterbody | None) -> tuple[SofteningLayer, ...]:
    """Return the layers that soften, first of the rolling body and then of the counterbody."""
    sides: list[tuple[Of, RollingBody | Counterbody]] = [("body", body)]
    if on is not None:
        sides.append(("counterbody", on))
    return tuple(
        SofteningLayer(of, number, material.shear_modulus)
        for of, side in sides
        for number, material in enumerate(materials_of(side))
        if depends_on_strain(material.shear_modulus)
    )


def softens(body: RollingBody, on: Counterbody | None = None) -> bool:
    """Return whether a layer of the rolling body or the counterbody has a modulus that decreases with strain."""
    return bool(softening_layers(body, on))


def _with_moduli(body: Any, of: Of, moduli: dict[tuple[Of, int], SoftenedModulus]) -> Any:
    materials = list(materials_of(body))
    for number, material in enumerate(materials):
        if (of, number) in moduli:
            materials[number] = replace(material, shear_modulus=moduli[of, number])
    return with_materials(body, materials)


def _coarser(mesh: Mesh | None) -> Mesh | None:
    """Return a mesh of half the nodes; None if that mesh has too few nodes, or if the given mesh has a `max_order`."""
    if mesh is None or mesh.max_order is not None or mesh.nodes_per_revolution < 2 * _FEWEST_NODES:
        return None
    across = mesh.theta_nodes_per_revolution
    return Mesh(
        nodes_per_revolution=mesh.nodes_per_revolution // 2,
        theta_nodes_per_revolution=None if across is None else across // 2,
    )


def _frequency(inside: Inside) -> float:
    """Return Ω R/a, the frequency at which the network has the moduli of a sweep at its amplitude [rad/s]."""
    return inside.result.angular_speed * inside.result.body.outer_radius / _half_width(inside.result)


def _half_width(result: Solution) -> float:
    """Return half of the contact's length along its middle [m], interpolated between nodes.

    Near the edge the pressure is proportional to the root of the distance, so its square is extrapolated linearly to 0.
    """
    spacing = result.body.outer_radius * result.mesh.spacing
    squares = result.pressure[:, result.pressure.max(axis=0).argmax()] ** 2
    inside = np.flatnonzero(squares)
    if len(inside) < 4:
        return spacing
    ends = squares[inside[[0, -1]]]
    slopes = squares[inside[[1, -2]]] - ends
    beyond = np.divide(ends, slopes, out=np.ones(2), where=slopes > ends)
    return float(0.5 * spacing * (inside[-1] - inside[0] + beyond.sum()))


def _change(old: Floats, new: Floats) -> float:
    return float((np.abs(new - old) / np.maximum(np.abs(new), 1e-300)).max(initial=0.0))
