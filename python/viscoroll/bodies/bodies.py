"""Rolling bodies and counterbodies made of bonded viscoelastic layers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from types import UnionType
from typing import TYPE_CHECKING, ClassVar, TypeAlias, TypeGuard, get_args

import numpy as np

from .. import _core
from .._core import InnerBoundary, Sides
from .._support.arguments import as_member, require_type, store_floats
from .._support.errors import InvalidType
from .layered import LayeredBody, RoundBody
from .layers import HalfSpace, Layer, as_layers
from .wheel import CoatedWheel

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "CoatedCylinder",
    "CoatedPlane",
    "CoatedSphere",
    "Counterbody",
    "Groove",
    "RollingBody",
    "core_counterbody",
    "is_body",
    "require_body",
]


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedSphere(RoundBody):
    """A ball: layers bonded to one another, and to a rigid core if there is one.

    Parameters
    ----------
    core_radius : float
        Radius of the core or the cavity [m], > 0. By default 0, which means a solid ball.
    layers : sequence of Layer
        Layers from the center outwards. By default none: a rigid ball, which needs a deformable counterbody.
    inner_boundary : InnerBoundary or str, default InnerBoundary.RIGID
        Inner boundary of the layers: a rigid core (RIGID), a cavity (HOLLOW), or none, with layers that reach the
        center (SOLID), the default for layers without a core radius. Without a core, the mean rotation of the coating
        is set to zero, because any other value cannot be distinguished from a rotation of the whole ball.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> layer = Layer(thickness=1e-3, shear_modulus=Elastic(modulus=3e6), poisson_ratio=0.5)
    >>> CoatedSphere(core_radius=20e-3, layers=[layer, layer]).outer_radius
    0.022
    """

    core_radius: float = 0.0
    layers: Sequence[Layer] = ()
    inner_boundary: InnerBoundary = InnerBoundary.RIGID

    noun = "ball"
    curved_directions = 2
    _choices: ClassVar[dict[str, type[Enum]]] = {"inner_boundary": InnerBoundary}

    def __post_init__(self) -> None:
        """Set the inner boundary to SOLID for layers without a core radius, and check the parameters."""
        store_floats(self, self._lengths)
        boundary = as_member("inner_boundary", self.inner_boundary, InnerBoundary)
        if boundary is InnerBoundary.RIGID and self.core_radius == 0.0 and as_layers(self.layers):
            object.__setattr__(self, "inner_boundary", InnerBoundary.SOLID)
        RoundBody.__post_init__(self)

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvatures of the undeformed surface along the path and across it [1/m]."""
        return 1.0 / self.outer_radius, 1.0 / self.outer_radius

    @property
    def is_bonded_inside(self) -> bool:
        """Whether the innermost layer is bonded to a rigid core."""
        return self.inner_boundary is InnerBoundary.RIGID

    def _to_core(self) -> _core.CoatedSphere:
        return _core.CoatedSphere(
            core_radius=self.core_radius, layers=self._core_layers(), inner_boundary=self.inner_boundary
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedCylinder(RoundBody):
    """A roller: layers bonded to one another and to a rigid core, in line contact.

    The roller is infinitely long and in plane strain: load, forces, torques and powers are per length. It needs a core,
    because a line load on a roller without a core would have no finite compliance.

    Parameters
    ----------
    core_radius : float
        Radius of the core [m], > 0.
    layers : sequence of Layer
        Layers from the core outwards. By default none: a rigid roller.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> layer = Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.5)
    >>> CoatedCylinder(core_radius=50e-3, layers=[layer]).outer_radius
    0.060000000000000005
    """

    core_radius: float
    layers: Sequence[Layer] = ()

    noun = "roller"
    curved_directions = 1
    line_contact = True

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvatures of the undeformed surface along the path and across it [1/m]."""
        return 1.0 / self.outer_radius, 0.0

    def interior_body(self, partner: LayeredBody) -> LayeredBody:
        """Return the roller, or under a wheel a tread without side faces: the contact then varies across the path."""
        if partner.width is None:
            return self
        return CoatedWheel(core_radius=self.core_radius, layers=self.layers, width=partner.width, sides=Sides.UNBOUNDED)

    def _to_core(self) -> _core.CoatedCylinder:
        return _core.CoatedCylinder(core_radius=self.core_radius, layers=self._core_layers())


class _Ground(LayeredBody):
    """Common base class of planes and grooves, which have layers on a base."""

    __slots__ = ()

    base: HalfSpace | None

    curved_directions = 0

    @property
    def depth(self) -> float:
        """Depth of the layers above a rigid base [m]; infinite above a half-space."""
        return self.thickness if self.base is None else np.inf

    @property
    def boundaries(self) -> NDArray[np.float64]:
        """Heights of all layer boundaries above the surface from the base outwards [m]; a half-space starts at -inf."""
        heights = -np.cumsum([0.0, *(layer.thickness for layer in reversed(self.layers))])[::-1]
        return heights if self.base is None else np.concatenate([[-np.inf], heights])

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvatures of the undeformed surface along the path and across it [1/m]: none."""
        return 0.0, 0.0

    def _core_plane(self) -> _core.CoatedPlane:
        require_type("base", self.base, HalfSpace, optional=True)
        return _core.CoatedPlane(layers=self._core_layers(), base=None if self.base is None else self.base._to_core())


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedPlane(_Ground):
    """An unbounded plane of bonded layers on a rigid base or a half-space.

    Parameters
    ----------
    layers : sequence of Layer
        Layers from the base outwards. By default none.
    base : HalfSpace, optional
        Half-space that supports the layers. By default the base is rigid.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> mat = Layer(thickness=5e-3, shear_modulus=Elastic(modulus=3e6), poisson_ratio=0.5)
    >>> CoatedPlane(layers=[mat]).thickness
    0.005
    """

    layers: Sequence[Layer] = ()
    base: HalfSpace | None = None

    noun = "plane"

    def _to_core(self) -> _core.CoatedPlane:
        return self._core_plane()


@dataclass(frozen=True, slots=True, kw_only=True)
class Groove(_Ground):
    """A surface that is concave or convex across the path, along it, or both: groove, dish, ring or drum.

    For a roller, the groove is a ring or a drum: curved along the path (`path_radius`) and straight across.

    Layers and base are treated as flat. The layers must therefore be thin compared with the radii.

    Parameters
    ----------
    radius : float, optional
        Radius of curvature across the path [m]: positive if concave, then at least 1.02 times the radius of the body;
        negative if convex. By default straight across, as rollers require.
    path_radius : float, optional
        Radius of curvature along the path [m], with the same signs and limits, for a dish or the race of a bearing.
        By default straight along the path.
    layers : sequence of Layer
        Layers from the base outwards. By default none: a rigid groove.
    base : HalfSpace, optional
        Half-space that supports the layers. By default the base is rigid.

    Examples
    --------
    >>> Groove(radius=30e-3).path_radius is None
    True
    """

    radius: float | None = None
    path_radius: float | None = None
    layers: Sequence[Layer] = ()
    base: HalfSpace | None = None

    noun = "groove"
    _optional_lengths = ("radius", "path_radius")

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvatures of the undeformed surface along the path and across it [1/m], negative if concave."""
        along, across = (0.0 if one is None else -1.0 / one for one in (self.path_radius, self.radius))
        return along, across

    def interior_body(self, partner: LayeredBody) -> LayeredBody:
        """Return a plane with the layers and the base of the groove."""
        del partner
        return CoatedPlane(layers=self.layers, base=self.base)

    def _to_core(self) -> _core.Groove:
        return _core.Groove(radius=self.radius, path_radius=self.path_radius, surface=self._core_plane())


#: Rolling body: a ball, a roller or a wheel. Load and results of a roller are per length.
RollingBody: TypeAlias = CoatedSphere | CoatedCylinder | CoatedWheel

#: Counterbody: a plane, a groove, or another ball, roller or wheel.
Counterbody: TypeAlias = CoatedPlane | Groove | CoatedSphere | CoatedCylinder | CoatedWheel


def is_body(value: object) -> TypeGuard[Counterbody]:
    """Return whether a value is a rolling body or a counterbody."""
    return isinstance(value, Counterbody)


def core_counterbody(
    on: Counterbody | None,
) -> _core.CoatedPlane | _core.Groove | _core.CoatedSphere | _core.CoatedCylinder | _core.CoatedWheel:
    """Return the counterbody as an object of the core; None means the rigid plane."""
    require_type("on", on, Counterbody, optional=True)
    return CoatedPlane()._to_core() if on is None else on._to_core()


def require_body(name: str, body: object, kind: type[RoundBody] | UnionType, what: str) -> None:
    """Raise a TypeError unless a body is of that kind; the message says that `what` does not support other kinds."""
    if isinstance(body, RollingBody) and not isinstance(body, kind):
        wanted = " or ".join(one.noun for one in get_args(kind) or (kind,))
        raise InvalidType(name, f"must be a {wanted}: {what} of a {body.noun} is not implemented")
    require_type(name, body, kind)
