"""Bodies whose size a file gives by the outer diameter."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from decimal import Decimal
from typing import Any, TypeVar

from .._support.arguments import as_positive
from .._support.errors import InvalidInput, Range
from ..bodies import Layer
from ..enums import InnerBoundary
from .plausible import thick_layers
from .tables import StrictTable, Table

__all__ = ["SIZES", "SizedTable"]

#: Keys that give the size of a body.
SIZES = ("core_radius", "outer_diameter")

_Body = TypeVar("_Body")


class SizedTable(Table):
    """Annotation of a body whose table may give the outer diameter in place of the radius of the core.

    Parameters
    ----------
    kind : class
        Class of the body.
    **types : type
        Types of keys.
    """

    def __init__(self, kind: type, **types: Any) -> None:
        super().__init__(make=_sized(kind), **types)
        self._kind = kind

    def _model_of(self, make: Callable[..., Any]) -> type[StrictTable]:
        model = super()._model_of(make)
        model.documented_by = (self._kind, _sized)
        if inspect.signature(self._kind).parameters["core_radius"].default is inspect.Parameter.empty:
            model.one_of = (SIZES,)
        return model


def _sized(kind: Callable[..., _Body]) -> Callable[..., _Body]:
    """Return a function that makes a body from the parameters of its class, or with `outer_diameter`.

    Parameters
    ----------
    outer_diameter : float
        Outer diameter of the body at rest [m], > 0, in place of `core_radius`.
    """

    def made(*, outer_diameter: object = None, **given: Any) -> _Body:
        if outer_diameter is None:
            return kind(**given)
        return kind(**given | {"core_radius": _core_radius(outer_diameter, given)})

    diameter = inspect.Parameter("outer_diameter", inspect.Parameter.KEYWORD_ONLY, default=None)
    parameters = inspect.signature(kind).parameters
    core = parameters["core_radius"].replace(default=None)
    made.__signature__ = inspect.Signature([*(parameters | {"core_radius": core}).values(), diameter])  # type: ignore[attr-defined]
    made.__name__ = kind.__name__
    return made


def _core_radius(outer_diameter: object, given: dict[str, Any]) -> float:
    """Return the radius of the core of a body of a given outer diameter [m]."""
    if "core_radius" in given:
        raise InvalidInput("outer_diameter", "must be left out if core_radius is given")
    if given.get("inner_boundary") in (InnerBoundary.SOLID, "solid"):
        raise InvalidInput("outer_diameter", "must be left out for a solid ball, whose layers give its size")
    diameter = as_positive("outer_diameter", outer_diameter, "m")
    layers: list[Layer] = given.get("layers") or []
    # Decimals, so that a diameter of 0.042 m and a layer of 0.001 m leave a core of 0.02 m without round-off.
    thickness = sum((Decimal(repr(layer.thickness)) for layer in layers), Decimal(0))
    radius = Decimal(repr(diameter)) / 2 - thickness
    if radius <= 0:
        allowed = Range(2 * float(thickness), unit="m", excludes_minimum=True)
        error = allowed.error("outer_diameter", f"{diameter:g}", ", twice the thickness of the layers")
        raise error.with_more("; ".join(thick_layers(layers)))
    return float(radius)
