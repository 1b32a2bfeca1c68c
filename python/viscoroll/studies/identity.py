"""Keys of points of studies, from the text of all inputs."""

from __future__ import annotations

import hashlib
import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, assert_never

import numpy as np

from ..bodies import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    CoatedWheel,
    Counterbody,
    Groove,
    HalfSpace,
    Layer,
    RollingBody,
)
from ..materials import SofteningModulus, StrainSweep
from ..rolling import solve
from .dimensions import LOAD_CASE

if TYPE_CHECKING:
    from ..bodies import Mesh
    from ..rolling.propagation import Pair
    from .draws import DrawMethod

__all__ = ["PointKeys", "digest"]

#: Nodes per revolution of the finest possible mesh, which the solver may choose if no mesh is given.
_FINEST_MESH = 1_000_000

#: Number of frequencies, spaced geometrically, at which Python functions of frequency are compared.
_SAMPLES = 96

_DEFAULTS = {
    name: parameter.default
    for name, parameter in inspect.signature(solve).parameters.items()
    if name in LOAD_CASE and parameter.default is not parameter.empty
}


class PointKeys:
    """Keys of points, which are equal if all inputs that determine the result are equal.

    The text of each rolling body is made once.
    """

    def __init__(self) -> None:
        self._bodies: dict[tuple[int, float, int], str] = {}

    def key(
        self,
        body: RollingBody,
        arguments: Mapping[str, Any],
        fields: tuple[str, ...],
        draws: Sequence[Pair] = (),
        method: DrawMethod = "linear",
    ) -> str:
        """Return the key of a point.

        Parameters
        ----------
        body : CoatedSphere, CoatedCylinder or CoatedWheel
            Rolling body of the point, which must outlive this object.
        arguments : mapping
            Arguments of `viscoroll.solve`; missing ones have their defaults.
        fields : tuple of str
            Names of the fields that are stored.
        draws : sequence of pairs, default ()
            Body and counterbody of each draw. The bodies must outlive this object.
        method : "linear" or "solve", default "linear"
            Method for the results of draws.
        """
        case = {name: value for name, value in sorted({**_DEFAULTS, **arguments}.items()) if value is not None}
        speed, highest = case["angular_speed"], _highest_harmonic(case.get("mesh"))
        if "on" in case:
            case["on"] = _counterbody_text(case["on"], speed * body.outer_radius, highest)
        text = f"{case!r} {fields!r} {self._body(body, speed, highest)}"
        for drawn, on in draws:
            under = "" if on is None else _counterbody_text(on, speed * drawn.outer_radius, highest)
            text += f"; {method} draw {self._body(drawn, speed, highest)} on {under}"
        return digest(text)

    def _body(self, body: RollingBody, speed: float, highest: int) -> str:
        key = (id(body), speed, highest)
        if key not in self._bodies:
            self._bodies[key] = _body_text(body, speed, highest)
        return self._bodies[key]


def digest(text: str) -> str:
    """Return a short text that differs for different texts: half of their SHA-256 checksum."""
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def _highest_harmonic(mesh: Mesh | None) -> int:
    """Return the highest order at which the core evaluates a modulus: the truncation order, or twice the nodes."""
    if mesh is None:
        return 2 * _FINEST_MESH
    return mesh.max_order or 2 * mesh.nodes_per_revolution


def _body_text(body: RollingBody, speed: float, highest: int) -> str:
    with np.errstate(over="ignore"):  # the solver rejects such a speed
        frequencies = [0.0, *(speed * np.geomspace(1.0, highest, _SAMPLES)).tolist()]
    return "; ".join([_shape_text(body), *(_layer_text(layer, frequencies) for layer in body.layers)])


def _shape_text(body: RollingBody) -> str:
    match body:
        case CoatedSphere():
            return f"{body.inner_boundary.name} {body.core_radius!r}"
        case CoatedCylinder():
            return f"cylinder {body.core_radius!r}"
        case CoatedWheel():
            ends = (body.width, body.crown_radius, body.hub.name, body.sides.name)
            return f"wheel {body.core_radius!r} {ends!r}"
        case _:
            assert_never(body)


def _counterbody_text(on: Counterbody, surface_speed: float, highest: int) -> str:
    """Return the text of a counterbody."""
    if isinstance(on, RollingBody):
        return _body_text(on, surface_speed / on.outer_radius, highest)
    match on:
        case CoatedPlane():
            kind = "plane"
        case Groove():
            kind = f"groove {on.radius!r} {on.path_radius!r}"
        case _:
            assert_never(on)
    frequencies = [0.0, *np.geomspace(1e-6, 1e9, _SAMPLES).tolist()]
    base = "rigid" if on.base is None else _layer_text(on.base, frequencies)
    return "; ".join([kind, base, *(_layer_text(layer, frequencies) for layer in on.layers)])


def _layer_text(layer: Layer | HalfSpace, frequencies: list[float]) -> str:
    thickness = layer.thickness if isinstance(layer, Layer) else None
    properties = (thickness, layer.poisson_ratio, layer.bulk_modulus, layer.density)
    modulus = layer.shear_modulus
    return f"{properties!r} {_modulus_text(modulus, frequencies)}"


def _modulus_text(modulus: object, frequencies: list[float]) -> str:
    match modulus:
        case SofteningModulus(matrix=matrix, network=StrainSweep(matrix=measured) as sweep):
            table = (sweep.strain, sweep.storage, sweep.loss, sweep.kind.name, sweep.frequency)
            return f"{_modulus_text(matrix, frequencies)} {table!r} {_modulus_text(measured, frequencies)}"
        case SofteningModulus(matrix=matrix, network=network):
            return f"{_modulus_text(matrix, frequencies)} {network!r}"
    return _sampled(modulus, frequencies) if callable(modulus) else repr(modulus)


def _sampled(modulus: Callable[[Any], Any], frequencies: list[float]) -> str:
    """Return the text of a Python function of frequency: its value, or the error that it raises, at each frequency."""
    try:
        return repr(np.asarray(modulus(np.array(frequencies))).tolist())
    except Exception:
        return repr([_value_or_error(modulus, frequency) for frequency in frequencies])


def _value_or_error(modulus: Callable[[Any], Any], frequency: float) -> object:
    try:
        return np.asarray(modulus(np.array([frequency]))).tolist()
    except Exception as error:
        return f"{type(error).__name__}: {error}"
