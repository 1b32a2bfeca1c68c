"""A wheel: layers around a rigid hub, with a width, a crown and side faces."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import ClassVar

from .. import _core
from .._core import Hub, Sides
from .layered import RoundBody
from .layers import Layer

__all__ = ["CoatedWheel"]


@dataclass(frozen=True, slots=True, kw_only=True)
class CoatedWheel(RoundBody):
    """A wheel, or a roller of finite width: a tread of layers bonded to one another and to a rigid hub.

    Load, forces and torques are those of the whole wheel. It needs a hub, because a wheel without one would bend like a
    beam and have no finite approach. `outer_radius` and `thickness` are the values at the middle of the width.

    Parameters
    ----------
    core_radius : float
        Radius of the hub at the middle of the width [m], > 0.
    width : float
        Width of the tread from face to face [m], > 0, at most 1000 times the outer radius. With free sides, at least
        0.001 of the thickness of the layers.
    layers : sequence of Layer
        Layers from the hub outwards, with their thickness at the middle. By default none: a rigid wheel.
    crown_radius : float, default infinity
        Radius of the convex tread profile across the path [m], at least half of the width and at most 1e6 times the
        outer radius, or infinite for a flat tread.
    hub : Hub or str, default Hub.STRAIGHT
        Hub of a crowned tread. "straight": a cylinder, on which the tread is thinner at the faces. "crowned": a hub
        that follows the profile, so that the tread has the same thickness everywhere.
    sides : Sides or str, default Sides.FREE
        Ends of the tread. "free": faces that bulge, as those of real wheels. "unbounded": no faces; the tread continues
        beyond the width, where it carries no pressure. This is faster, and correct to 1 % if the contact ends one
        thickness before the faces. A contact that reaches the faces of a tread three thicknesses wide is a quarter too
        stiff.

    Examples
    --------
    >>> from viscoroll import StandardLinearSolid
    >>> rubber = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> tread = Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.5)
    >>> wheel = CoatedWheel(core_radius=40e-3, layers=[tread], width=30e-3, crown_radius=300e-3)
    >>> f"{wheel.crown_drop(15e-3) * 1e3:.3f} mm"  # at the faces
    '0.375 mm'
    """

    core_radius: float
    width: float = field()  # without `field`, the default would be that of the base class, None
    layers: Sequence[Layer] = ()
    crown_radius: float = math.inf
    hub: Hub = Hub.STRAIGHT
    sides: Sides = Sides.FREE

    noun = "wheel"
    curved_directions = 1
    _lengths = ("core_radius", "width", "crown_radius")
    _choices: ClassVar[dict[str, type[Enum]]] = {"hub": Hub, "sides": Sides}

    @property
    def curvatures(self) -> tuple[float, float]:
        """Curvatures of the undeformed surface along the path and across it [1/m]."""
        return 1.0 / self.outer_radius, 1.0 / self.crown_radius

    @property
    def has_free_faces(self) -> bool:
        """Whether the tread ends at side faces that bulge."""
        return self.sides is Sides.FREE

    def crown_drop(self, z: float) -> float:
        """Return how far the crown lies below its middle at an axial distance z from the middle [m]."""
        ratio = z / self.crown_radius
        return z * ratio / (1.0 + math.sqrt(1.0 - ratio**2))

    def _to_core(self) -> _core.CoatedWheel:
        return _core.CoatedWheel(
            core_radius=self.core_radius,
            layers=self._core_layers(),
            width=self.width,
            crown_radius=self.crown_radius,
            hub=self.hub,
            sides=self.sides,
        )
