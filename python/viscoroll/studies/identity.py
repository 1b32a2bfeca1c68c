"""What makes two points of studies the same: all inputs as text."""

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
    Counterpart,
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
    from .draws import Way

__all__ = ["PointKeys", "digest"]

#: Nodes per revolution of the finest mesh there is, which a solve may choose by itself where none is given.
_FINEST_MESH = 1_000_000

#: Harmonics at which Python functions of frequency are compared, at equal ratios.
_SAMPLES = 96

_DEFAULTS = {
    name: parameter.default
    for name, parameter in inspect.signature(solve).parameters.items()
    if name in LOAD_CASE and parameter.default is not parameter.empty
}


class PointKeys:
    """Keys of points: equal where all that decides the result is. Balls are described once."""

    def __init__(self) -> None:
        self._balls: dict[tuple[int, float, int], str] = {}

    def key(
        self,
        ball: RollingBody,
        arguments: Mapping[str, Any],
        fields: tuple[str, ...],
        draws: Sequence[Pair] = (),
        way: Way = "linear",
    ) -> str:
        """Return the key of a point.

        Parameters
        ----------
        ball : CoatedSphere, CoatedCylinder or CoatedWheel
            Its ball, which must outlive this object.
        arguments : mapping
            Arguments of `viscoroll.solve`; what is left out has its default.
        fields : tuple of str
            Fields that are kept.
        draws : sequence of pairs
            Bodies with draws of materials, which must outlive this object.
        way : "linear" or "solve"
            How results of draws are found.
        """
        case = {name: value for name, value in sorted({**_DEFAULTS, **arguments}.items()) if value is not None}
        speed, highest = case["angular_speed"], _highest_harmonic(case.get("mesh"))
        if "on" in case:
            case["on"] = _counterpart_text(case["on"], speed * ball.outer_radius, highest)
        text = f"{case!r} {fields!r} {self._ball(ball, speed, highest)}"
        for drawn, on in draws:
            under = "" if on is None else _counterpart_text(on, speed * drawn.outer_radius, highest)
            text += f"; {way} draw {self._ball(drawn, speed, highest)} on {under}"
        return digest(text)

    def _ball(self, ball: RollingBody, speed: float, highest: int) -> str:
        place = (id(ball), speed, highest)
        if place not in self._balls:
            self._balls[place] = _ball_text(ball, speed, highest)
        return self._balls[place]


def digest(text: str) -> str:
    """Return a short text that differs wherever the long one does."""
    return hashlib.sha256(text.encode()).hexdigest()[:32]


def _highest_harmonic(mesh: Mesh | None) -> int:
    """Highest order that is asked of a function of frequency: `measured_order` of the core, or the truncation order."""
    if mesh is None:
        return 2 * _FINEST_MESH
    return mesh.max_order or 2 * mesh.nodes_per_revolution


def _ball_text(ball: RollingBody, speed: float, highest: int) -> str:
    with np.errstate(over="ignore"):  # the solver refuses such a speed
        frequencies = [0.0, *(speed * np.geomspace(1.0, highest, _SAMPLES)).tolist()]
    return "; ".join([_shape_text(ball), *(_layer_text(layer, frequencies) for layer in ball.layers)])


def _shape_text(ball: RollingBody) -> str:
    match ball:
        case CoatedSphere():
            return f"{ball.inner_boundary.name} {ball.core_radius!r}"
        case CoatedCylinder():
            return f"cylinder {ball.core_radius!r}"
        case CoatedWheel():
            ends = (ball.width, ball.crown_radius, ball.hub.name, ball.sides.name)
            return f"wheel {ball.core_radius!r} {ends!r}"
        case _:
            assert_never(ball)


def _counterpart_text(on: Counterpart, surface_speed: float, highest: int) -> str:
    """Text of what a body rolls on."""
    if isinstance(on, RollingBody):
        return _ball_text(on, surface_speed / on.outer_radius, highest)
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
    """Text of a Python function of frequency: its values, or what it raises, at each frequency."""
    try:
        return repr(np.asarray(modulus(np.array(frequencies))).tolist())
    except Exception:
        return repr([_value_or_error(modulus, frequency) for frequency in frequencies])


def _value_or_error(modulus: Callable[[Any], Any], frequency: float) -> object:
    try:
        return np.asarray(modulus(np.array([frequency]))).tolist()
    except Exception as error:
        return f"{type(error).__name__}: {error}"
