"""Rolling of filled rubber: contact and strain-dependent moduli are solved together."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from .._support.arguments import as_count, as_float, as_float_in, require_type
from .._support.errors import Range
from .._support.extras import extra
from .._support.progress import ProgressLike, reporting
from .._support.result_warnings import warn
from ..bodies import Counterbody, HalfSpace, Layer, RollingBody
from ..bodies.layered import materials_of, with_materials
from ..materials.softening import depends_on_strain
from ..rolling import solve
from ..rolling.steady import solved_speed
from ..solution.text import result_warnings
from .softened_state import SofteningLayer, State
from .softening_result import NetworkLoss, StrainSoftening, as_network_loss
from .softening_search import SofteningSearch, softening_layers

if TYPE_CHECKING:
    from ..rolling import Result

__all__ = ["strain_softening"]

#: Range of loss scales in which the model was compared with exact solutions, and largest strain for linear theory.
_VALIDATED_SCALES = (0.5, 1.5)
_LARGE_STRAIN = 0.2


def strain_softening(
    body: RollingBody,
    *,
    on: Counterbody | None = None,
    load: float | None = None,
    angular_speed: float | None = None,
    speed: float | None = None,
    loss: NetworkLoss = "network",
    sublayers: int = 1,
    depths: int = 4,
    tolerance: float = 1e-3,
    progress: ProgressLike = None,
    **options: Any,
) -> StrainSoftening:
    """Solve rolling of layers whose moduli decrease with strain (`SofteningModulus`), together with their strain.

    Each layer has one modulus, that of its strain amplitude. At a point, the amplitude is half of the largest distance
    between two strains of the point; the amplitude of the layer is the mean weighted by the loss of the network.

    Parameters
    ----------
    body, on, load, angular_speed, speed
        Same as in `solve`. Layers of either body, and the base of a plane, may soften.
    loss : {"network", "harmonic"}, default "network"
        Loss of the network. "network": that of a rate-independent network, which depends only on the turning points of
        the strain; a factor on the loss modulus makes the harmonics dissipate as much. "harmonic": the sum over
        harmonics with the loss modulus at the amplitude, as in the tire industry. `torque_bounds` contains both.
    sublayers : int, default 1
        Number of parts into which every layer that softens is divided, each with its own amplitude, in [1, 20]. It
        matters only if a contact is shorter than a third of the layer.
    depths : int, default 4
        Number of depths in a layer at which strain is evaluated, in [2, 20]; in thick layers several times this number.
    tolerance : float, default 1e-3
        Largest relative change of amplitudes and losses at convergence [-], in [1e-9, 0.1].
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) after every pass.
    **options
        Options of `solve`: penetration instead of the load, friction, drive, accuracy, mesh, compliance, and so on.
        Curvature EXACT is not allowed.

    Returns
    -------
    StrainSoftening
        Contact, strain, moduli and both torques. If no layer softens, the result of `solve`.

    Raises
    ------
    ValueError, TypeError
        If an argument is invalid, same as in `solve`.
    ConvergenceError
        If the amplitudes do not converge.
    ImportError
        If the extra `viscoroll[studies]` or `viscoroll[files]` is missing.

    Warns
    -----
    ResultWarning
        Same as in `solve`; also if strain lies outside of a measured sweep, if the harmonic sum is outside of 0.67 to 2
        times the loss of the network, or if the strain amplitude is above 0.2.

    Notes
    -----
    The model is the steady loop of a network that does not recover between passes. Rubber that recovers dissipates
    more (13 to 82 % more in a foundation of independent columns), which exceeds all corrections made here. The model
    has no set, no first pass (Mullins effect) and no drift. It assumes that the loss under rotating strain axes follows
    von Mises plasticity.

    Examples
    --------
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> network = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
    >>> tread = vr.materials.SofteningModulus(matrix=rubber, network=network)
    >>> layer = vr.Layer(thickness=1e-2, shear_modulus=tread, poisson_ratio=0.5)
    >>> roller = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    >>> soft = vr.strain_softening(roller, load=2e3, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=600))
    >>> print(f"{soft.layer_amplitudes[0]:.1%}")
    1.3%
    """
    require_type("body", body, RollingBody)
    require_type("on", on, Counterbody, optional=True)
    as_network_loss("loss", loss)
    parts, columns = as_count("sublayers", sublayers, 1, 20), as_count("depths", depths, 2, 20)
    largest_change = as_float_in(Range(1e-9, 0.1), "tolerance", tolerance)
    layers = softening_layers(body, on)
    if not layers:
        return _linear_result(
            solve(body, on=on, load=load, angular_speed=angular_speed, speed=speed, progress=progress, **options), loss
        )
    body, on = _with_sublayers(body, parts), None if on is None else _with_sublayers(on, parts)
    layers = softening_layers(body, on)
    with extra("files"), reporting(progress) as report:
        search = SofteningSearch(
            body=body,
            on=on,
            layers=layers,
            load=None if load is None else as_float("load", load),
            angular_speed=solved_speed(body, angular_speed, speed),
            options=options | ({"angular_speed": angular_speed} if speed is None else {"speed": speed}),
            depths=columns,
            report=report,
        )
        matched = loss == "network"
        state = search.converged(matched=matched, tolerance=largest_change)
        amplitudes, scales = search.for_other_loss(state, matched=not matched, tolerance=largest_change)
        given: dict[str, Any] = {name: options.get(name) for name in ("mesh", "accuracy")}
        found = state.result if given["mesh"] is not None else search.solved(state.amplitudes, state.scales, **given)
        bound = search.solved(amplitudes, scales, **given)
    return _softening_result(search, state, found, (bound, found) if matched else (found, bound), loss)


def _softening_result(
    search: SofteningSearch, state: State, result: Result, bounds: tuple[Result, Result], loss: NetworkLoss
) -> StrainSoftening:
    moduli = tuple(
        tuple(float(part) for part in layer.modulus.network.at(amplitude))
        for layer, amplitude in zip(search.layers, state.amplitudes, strict=True)
    )
    lost = sum(layer.shear_loss for layer in state.layers)
    softened = tuple(_warnings(search.layers, state))
    warn([*result_warnings(result), *softened])
    return StrainSoftening(
        result=result,
        loss=loss,
        layer_amplitudes=tuple(state.amplitudes.tolist()),
        largest_amplitudes=tuple(float(layer.amplitudes.max()) for layer in state.layers),
        layer_moduli=moduli,  # type: ignore[arg-type]
        loss_scales=tuple(state.scales.tolist()),
        network_share=sum(layer.harmonic_loss for layer in state.layers) / lost if lost > 0.0 else 0.0,
        torque_bounds=(bounds[0].resisting_torque, bounds[1].resisting_torque),
        iterations=search.contacts,
        history=tuple(tuple(amplitudes.tolist()) for amplitudes in search.history),
        warnings=softened,
        _layers=search.layers,
        _state=state,
    )


def _linear_result(result: Result, loss: NetworkLoss) -> StrainSoftening:
    """Return the result for bodies without a layer that softens."""
    return StrainSoftening(
        result=result,
        loss=loss,
        layer_amplitudes=(),
        largest_amplitudes=(),
        layer_moduli=(),
        loss_scales=(),
        network_share=0.0,
        torque_bounds=(result.resisting_torque, result.resisting_torque),
        iterations=1,
        history=(),
        warnings=(),
        _layers=(),
        _state=None,
    )


def _warnings(layers: tuple[SofteningLayer, ...], state: State) -> list[str]:
    texts = []
    for layer, found, amplitude, scale in zip(layers, state.layers, state.amplitudes, state.scales, strict=True):
        where = f"{layer.of}, layer {layer.number}"
        least, most = layer.modulus.network.known_strains
        largest = float(found.amplitudes.max())
        if not least <= amplitude <= most or largest > most:
            texts.append(
                f"{where}: the strain {amplitude:.3g} or the largest strain {largest:.3g} is outside the sweep, "
                f"{least:.3g} to {most:.3g}; moduli outside are those at its ends"
            )
        if not _VALIDATED_SCALES[0] <= scale <= _VALIDATED_SCALES[1]:
            texts.append(
                f"{where}: the harmonics dissipate {1.0 / scale:.3g} times as much as the network; comparisons with "
                "exact solutions cover ratios from 0.67 to 2"
            )
        if largest > _LARGE_STRAIN:
            texts.append(f"{where}: the strain amplitude is up to {largest:.3g}; linear theory is inaccurate above 0.2")
    return texts


def _with_sublayers(body: Any, parts: int) -> Any:
    if parts == 1:
        return body
    materials: list[Layer | HalfSpace] = []
    for material in materials_of(body):
        if isinstance(material, Layer) and depends_on_strain(material.shear_modulus):
            materials += [replace(material, thickness=material.thickness / parts)] * parts
        else:
            materials.append(material)
    return with_materials(body, materials)
