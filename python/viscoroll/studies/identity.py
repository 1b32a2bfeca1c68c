"""Keys of points of studies, from the text of all inputs."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..sliding import RoughSurface
from .kinds import ROLLING, SLIDING

if TYPE_CHECKING:
    from ..bodies import Counterbody, Mesh, RollingBody
    from ..bodies.layered import LayeredBody
    from ..rolling.propagation import Pair
    from .draws import DrawMethod

__all__ = ["PointKeys", "digest", "sampled_text"]

#: Nodes per revolution of the finest possible mesh, which the solver may choose if no mesh is given.
_FINEST_MESH = 1_000_000

#: Number of frequencies, spaced geometrically, at which Python functions of frequency are compared.
_SAMPLES = 96

#: Frequencies at which Python functions as materials of a plane are compared [rad/s].
_FREQUENCIES = [0.0, *np.geomspace(1e-6, 1e9, _SAMPLES).tolist()]


class PointKeys:
    """Keys of points, which are equal if all inputs that determine the result are equal.

    The text of each rolling body is made once.
    """

    def __init__(self) -> None:
        self._bodies: dict[tuple[int, float, int], str] = {}
        self._surfaces: dict[int, str] = {}

    def key(
        self,
        body: RollingBody | RoughSurface,
        arguments: Mapping[str, Any],
        fields: tuple[str, ...],
        draws: Sequence[Pair] = (),
        method: DrawMethod = "linear",
        addition: object = None,
    ) -> str:
        """Return the key of a point.

        Parameters
        ----------
        body : CoatedSphere, CoatedCylinder, CoatedWheel or RoughSurface
            Rolling body or rough surface of the point, which must outlive this object.
        arguments : mapping
            Arguments of the solver; missing ones have their defaults.
        fields : tuple of str
            Names of the fields that are stored.
        draws : sequence of pairs, default ()
            Body and counterbody of each draw. The bodies must outlive this object.
        method : "linear" or "solve", default "linear"
            Method for the results of draws.
        addition : Addition, optional
            Further results of the point.
        """
        if isinstance(body, RoughSurface):
            return self._sliding_key(body, arguments)
        case = _with_defaults(ROLLING.defaults, arguments)
        speed = case["speed"] / body.outer_radius if "speed" in case else case["angular_speed"]
        highest = _highest_harmonic(case.get("mesh"))
        if "on" in case:
            case["on"] = _counterbody_text(case["on"], speed * body.outer_radius, highest)
        text = f"{case!r} {fields!r} {self._body(body, speed, highest)}"
        if addition is not None:
            text += f"; {addition!r}"
        for drawn, on in draws:
            under = "" if on is None else _counterbody_text(on, speed * drawn.outer_radius, highest)
            text += f"; {method} draw {self._body(drawn, speed, highest)} on {under}"
        return digest(text)

    def _sliding_key(self, surface: RoughSurface, arguments: Mapping[str, Any]) -> str:
        case = _with_defaults(SLIDING.defaults, arguments)
        case["on"] = _text(case["on"], _FREQUENCIES)
        if id(surface) not in self._surfaces:
            heights = hashlib.sha256(surface.heights.tobytes()).hexdigest()
            shape = (surface.heights.shape, surface.spacing, surface.periodic)
            self._surfaces[id(surface)] = f"{heights} {shape!r}"
        return digest(f"sliding {case!r} {self._surfaces[id(surface)]}")

    def _body(self, body: RollingBody, speed: float, highest: int) -> str:
        key = (id(body), speed, highest)
        if key not in self._bodies:
            self._bodies[key] = _body_text(body, speed, highest)
        return self._bodies[key]


def digest(text: str) -> str:
    """Return a short text that differs for different texts: half of their SHA-256 checksum."""
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def _with_defaults(defaults: Mapping[str, Any], arguments: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in sorted({**defaults, **arguments}.items()) if value is not None}


def _highest_harmonic(mesh: Mesh | None) -> int:
    """Return the highest order at which the core evaluates a modulus: the truncation order, or twice the nodes."""
    if mesh is None:
        return 2 * _FINEST_MESH
    return mesh.max_order or 2 * mesh.nodes_per_revolution


def _body_text(body: LayeredBody, speed: float, highest: int) -> str:
    with np.errstate(over="ignore"):  # the solver rejects such a speed
        return _text(body, [0.0, *(speed * np.geomspace(1.0, highest, _SAMPLES)).tolist()])


def _counterbody_text(on: Counterbody, surface_speed: float, highest: int) -> str:
    if on.is_flat:
        return _text(on, _FREQUENCIES)
    return _body_text(on, surface_speed / on.surface, highest)


def sampled_text(value: object) -> str:
    """Return the text of any argument, with functions of frequency sampled between 1e-6 and 1e9 rad/s."""
    return _text(value, [0.0, *np.geomspace(1e-6, 1e9, _SAMPLES).tolist()])


def _text(value: object, frequencies: list[float]) -> str:
    """Return a text with all parameters of a body, layer, material or network, and of those that it contains."""
    if is_dataclass(value):
        parameters = (f"{field.name}={_text(getattr(value, field.name), frequencies)}" for field in fields(value))
        return f"{type(value).__name__}({', '.join(parameters)})"
    if isinstance(value, np.ndarray):
        return repr(value.tolist())
    if isinstance(value, tuple | list):
        return f"({', '.join(_text(one, frequencies) for one in value)})"
    return _sampled(value, frequencies) if callable(value) else repr(value)


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
