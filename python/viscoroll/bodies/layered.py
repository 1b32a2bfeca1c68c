"""Base classes of the bodies: bodies with layers, and round bodies with a core. Both describe their geometry."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import Enum
from typing import TYPE_CHECKING, ClassVar, TypeVar

import numpy as np

from .. import _core
from .._support.arguments import as_member, store_floats
from .._support.tables import ParameterTable
from .._support.units import UNITS
from .layers import HalfSpace, Layer, as_layers, at_rest
from .si_hints import si_hint

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["LayeredBody", "RoundBody", "materials_of", "with_materials"]

Body = TypeVar("Body", bound="LayeredBody")


class LayeredBody(ParameterTable):
    """Common base class of all bodies, which have layers from the inside outwards."""

    __slots__ = ()

    layers: Sequence[Layer]

    #: Noun for the body in messages and pictures.
    noun: ClassVar[str]
    #: Number of directions in which the layers are curved: 0, 1 (along the path), or 2 (also across it).
    curved_directions: ClassVar[int]
    #: Whether loads, forces and torques are per length.
    line_contact: ClassVar[bool] = False
    #: Width from face to face [m] and radius of the crown across the path [m]; None for bodies without faces.
    width: float | None = None
    crown_radius: float | None = None

    #: Names of the parameters that are lengths, that are optional lengths, and that are members of an enum.
    _lengths: ClassVar[tuple[str, ...]] = ()
    _optional_lengths: ClassVar[tuple[str, ...]] = ()
    _choices: ClassVar[dict[str, type[Enum]]] = {}

    def __init_subclass__(cls) -> None:
        """Register the units of the lengths."""
        UNITS.update(dict.fromkeys((*cls._lengths, *cls._optional_lengths), "m"))

    def __post_init__(self) -> None:
        """Store lengths as floats, layers as a tuple and names as enum members, and check the parameters."""
        store_floats(self, self._lengths, optional=self._optional_lengths)
        object.__setattr__(self, "layers", as_layers(self.layers))
        for name, kind in self._choices.items():
            object.__setattr__(self, name, as_member(name, getattr(self, name), kind))
        with_materials(self, [at_rest(material) for material in materials_of(self)])._to_core()

    @property
    def thickness(self) -> float:
        """Total thickness of all layers [m]."""
        return sum(layer.thickness for layer in self.layers)

    @property
    def depth(self) -> float:
        """Distance from the surface to the rigid core or base, or to the innermost point [m]; may be infinite."""
        return self.thickness

    @property
    def boundaries(self) -> NDArray[np.float64]:
        """Positions of all layer boundaries from the inside outwards [m]: radii, or heights above the surface."""
        raise NotImplementedError

    @property
    def surface(self) -> float:
        """Position of the surface in the coordinate of `boundaries` [m]."""
        return float(self.boundaries[-1])

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvatures of the undeformed surface along the path and across it [1/m], positive if convex."""
        raise NotImplementedError

    @property
    def is_flat(self) -> bool:
        """Whether the layers are those of a plane, whose positions are heights above the surface."""
        return self.curved_directions == 0

    @property
    def is_deformable(self) -> bool:
        """Whether the body has a layer, or a deformable base."""
        return bool(materials_of(self))

    @property
    def is_bonded_inside(self) -> bool:
        """Whether the innermost layer is bonded to a core or a base."""
        return True

    @property
    def has_free_faces(self) -> bool:
        """Whether the layers end at side faces that bulge."""
        return False

    def interior_body(self, partner: LayeredBody) -> LayeredBody:
        """Return the body that represents this one for interior fields in contact with a partner; by default itself."""
        del partner
        return self

    def _core_layers(self) -> list[_core.Layer]:
        return [layer._to_core() for layer in self.layers]

    def _to_core(self) -> object:
        """Return the body as an object of the core, whose constructor checks the parameters."""
        raise NotImplementedError


def materials_of(body: LayeredBody) -> tuple[Layer | HalfSpace, ...]:
    """Return the materials of a body from the inside outwards, starting with the base of a plane if it has one."""
    base = getattr(body, "base", None)
    return (*((base,) if isinstance(base, HalfSpace) else ()), *body.layers)


def with_materials(body: Body, materials: Sequence[Layer | HalfSpace]) -> Body:
    """Return a copy of a body with other materials, or the body itself if its materials are unchanged."""
    if all(new is old for new, old in zip(materials, materials_of(body), strict=True)):
        return body
    layers = tuple(material for material in materials if isinstance(material, Layer))
    base = {"base": materials[0]} if isinstance(materials[0], HalfSpace) else {}
    return replace(body, layers=layers, **base)  # type: ignore[type-var]


class RoundBody(LayeredBody):
    """Common base class of the rolling bodies, which have a core."""

    __slots__ = ()

    core_radius: float

    _lengths: ClassVar[tuple[str, ...]] = ("core_radius",)

    @property
    def outer_radius(self) -> float:
        """Outer radius r_o [m]."""
        return self.core_radius + self.thickness

    @property
    def boundaries(self) -> NDArray[np.float64]:
        """Radii of all layer boundaries from the inside outwards [m]."""
        return self.core_radius + np.cumsum([0.0, *(layer.thickness for layer in self.layers)])

    @property
    def surface(self) -> float:
        """Outer radius [m]."""
        return self.outer_radius

    def __str__(self) -> str:
        """Return the parameters, followed by a hint if the values are implausible in SI units."""
        return "\n".join(filter(None, [repr(self), si_hint(self)]))
