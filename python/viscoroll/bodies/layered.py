"""What bodies have in common: layers, and around a core."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from enum import Enum
from typing import Any, ClassVar, TypeVar

from .. import _core
from .._support.arguments import as_member, store_floats
from .._support.tables import ParameterTable
from .layers import HalfSpace, Layer, as_layers, at_rest
from .si_hints import si_hint

__all__ = ["LayeredBody", "RoundBody", "with_materials"]

Body = TypeVar("Body", bound="LayeredBody")


class LayeredBody(ParameterTable):
    """What all bodies have in common: layers, from the inside outwards."""

    __slots__ = ()

    layers: Sequence[Layer]

    #: Parameters that are lengths, those that may be left out, and those that are one of several names.
    _lengths: ClassVar[tuple[str, ...]] = ()
    _optional_lengths: ClassVar[tuple[str, ...]] = ()
    _choices: ClassVar[dict[str, type[Enum]]] = {}

    def __post_init__(self) -> None:
        """Store lengths as floats, freeze the list of layers, find what is named, and check the parameters."""
        store_floats(self, self._lengths, optional=self._optional_lengths)
        object.__setattr__(self, "layers", as_layers(self.layers))
        for name, kind in self._choices.items():
            object.__setattr__(self, name, as_member(name, getattr(self, name), kind))
        with_materials(self, at_rest)._to_core()

    @property
    def thickness(self) -> float:
        """Thickness of all layers together [m]."""
        return sum(layer.thickness for layer in self.layers)

    def _core_layers(self) -> list[_core.Layer]:
        return [layer._to_core() for layer in self.layers]

    def _to_core(self) -> object:
        """Return what the core knows it as, which checks the parameters."""
        raise NotImplementedError


def with_materials(body: Body, change: Callable[[Any], Any]) -> Body:
    """Return a body with layers, and a base where it has one, that are `change` of what they are.

    It is the same body where none of them changes.
    """
    layers = tuple(change(layer) for layer in body.layers)
    base = getattr(body, "base", None)
    parts: dict[str, Any] = {}
    if any(new is not old for new, old in zip(layers, body.layers, strict=True)):
        parts["layers"] = layers
    if isinstance(base, HalfSpace) and (changed := change(base)) is not base:
        parts["base"] = changed
    return replace(body, **parts) if parts else body


class RoundBody(LayeredBody):
    """What all that rolls has in common: a core."""

    __slots__ = ()

    core_radius: float

    _lengths: ClassVar[tuple[str, ...]] = ("core_radius",)

    #: What messages and pictures call it, and whether loads, forces and torques are per length.
    noun: ClassVar[str]
    line_contact: ClassVar[bool] = False

    @property
    def outer_radius(self) -> float:
        """Outer radius r_o [m]."""
        return self.core_radius + self.thickness

    def __str__(self) -> str:
        """Return the parameters, and how they read in SI units where that is implausible."""
        return "\n".join(filter(None, [repr(self), si_hint(self)]))
