"""What rolls, and what it rolls on: bonded viscoelastic layers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from types import UnionType
from typing import ClassVar, TypeAlias, get_args

from .. import _core
from .._core import InnerBoundary
from .._support.arguments import as_member, require_type, store_floats
from .layered import LayeredBody, RoundBody
from .layers import HalfSpace, Layer, as_layers
from .wheel import CoatedWheel

__all__ = [
    "CoatedCylinder",
    "CoatedPlane",
    "CoatedSphere",
    "Counterpart",
    "Groove",
    "RollingBody",
    "core_counterpart",
    "require_body",
]


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedSphere(RoundBody):
    """Layers bonded to one another, and to a rigid core if there is one.

    Parameters
    ----------
    core_radius : float
        Radius of the core or the cavity [m], > 0; 0, which may be left out, for a solid ball.
    layers : sequence of Layer
        From the center outwards; with none a rigid ball, which rolls on what deforms.
    inner_boundary : InnerBoundary or str, default InnerBoundary.RIGID
        What lies within: a rigid core, a cavity (HOLLOW), or nothing, the layers reaching the center (SOLID), as they
        do where no radius of a core is given. Without a core, the mean rotation of the coating is taken to be zero, for
        no other can be told from turning the ball.

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
    _choices: ClassVar[dict[str, type[Enum]]] = {"inner_boundary": InnerBoundary}

    def __post_init__(self) -> None:
        """Take layers without a core for a solid ball, and check the parameters."""
        store_floats(self, self._lengths)
        boundary = as_member("inner_boundary", self.inner_boundary, InnerBoundary)
        if boundary is InnerBoundary.RIGID and self.core_radius == 0.0 and as_layers(self.layers):
            object.__setattr__(self, "inner_boundary", InnerBoundary.SOLID)
        RoundBody.__post_init__(self)

    def _to_core(self) -> _core.CoatedSphere:
        return _core.CoatedSphere(
            core_radius=self.core_radius, layers=self._core_layers(), inner_boundary=self.inner_boundary
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedCylinder(RoundBody):
    """A roller: layers bonded to one another and to a rigid core, in line contact.

    It is as long as one likes, in plane strain: load, forces, torques and powers are per length. Without a core a line
    load would have no finite compliance.

    Parameters
    ----------
    core_radius : float
        Radius of the core [m], > 0.
    layers : sequence of Layer
        From the core outwards; none: rigid.

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
    line_contact = True

    def _to_core(self) -> _core.CoatedCylinder:
        return _core.CoatedCylinder(core_radius=self.core_radius, layers=self._core_layers())


class _Ground(LayeredBody):
    """What planes and grooves have in common: a base."""

    __slots__ = ()

    base: HalfSpace | None

    def _core_plane(self) -> _core.CoatedPlane:
        require_type("base", self.base, HalfSpace, optional=True)
        return _core.CoatedPlane(layers=self._core_layers(), base=None if self.base is None else self.base._to_core())


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedPlane(_Ground):
    """An unbounded plane of bonded layers on a rigid base or a half-space.

    Parameters
    ----------
    layers : sequence of Layer
        From the base outwards.
    base : HalfSpace, optional
        What carries them; rigid without it.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> mat = Layer(thickness=5e-3, shear_modulus=Elastic(modulus=3e6), poisson_ratio=0.5)
    >>> CoatedPlane(layers=[mat]).thickness
    0.005
    """

    layers: Sequence[Layer] = ()
    base: HalfSpace | None = None

    def _to_core(self) -> _core.CoatedPlane:
        return self._core_plane()


@dataclass(frozen=True, slots=True, kw_only=True)
class Groove(_Ground):
    """What a ball rolls along or in: a surface that is hollow, or bulges, across the path, along it, or both ways.

    A roller rolls along it, in a ring or on a drum: there it is straight across.

    Layers and base are taken to be flat, which is as good as they are thin beside the radii.

    Parameters
    ----------
    radius : float, optional
        Of curvature across the path [m]: at least 1.02 times the ball's where it is hollow, < 0 where it bulges;
        straight without it, as under a roller.
    path_radius : float, optional
        The same along the path: a dish, or the race of a bearing.
    layers : sequence of Layer
        From the base outwards; none: rigid.
    base : HalfSpace, optional
        What carries them; rigid without it.

    Examples
    --------
    >>> Groove(radius=30e-3).path_radius is None
    True
    """

    radius: float | None = None
    path_radius: float | None = None
    layers: Sequence[Layer] = ()
    base: HalfSpace | None = None

    _optional_lengths = ("radius", "path_radius")

    def _to_core(self) -> _core.Groove:
        return _core.Groove(radius=self.radius, path_radius=self.path_radius, surface=self._core_plane())


#: What rolls: a ball, a roller, whose load and results are per length, or a wheel.
RollingBody: TypeAlias = CoatedSphere | CoatedCylinder | CoatedWheel

#: What it rolls on: a plane, a groove, or another body that turns.
Counterpart: TypeAlias = CoatedPlane | Groove | CoatedSphere | CoatedCylinder | CoatedWheel


def core_counterpart(
    on: Counterpart | None,
) -> _core.CoatedPlane | _core.Groove | _core.CoatedSphere | _core.CoatedCylinder | _core.CoatedWheel:
    """Return what the core knows it as; without any, the rigid plane."""
    require_type("on", on, Counterpart, optional=True)
    return CoatedPlane()._to_core() if on is None else on._to_core()


def require_body(name: str, body: object, kind: type[RoundBody] | UnionType, what: str) -> None:
    """Raise a TypeError unless a body is of that kind; of others that roll it says that `what` is not there yet."""
    if isinstance(body, RollingBody) and not isinstance(body, kind):
        wanted = " or ".join(one.noun for one in get_args(kind) or (kind,))
        raise TypeError(f"{name} must be a {wanted}: {what} of a {body.noun} is not there yet")
    require_type(name, body, kind)
