"""Which of two bodies is looked into, and what the core has to know of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias, assert_never

import numpy as np

from .. import _core
from .._core import Sides
from .._support.arguments import as_float_array
from .._support.cautions import warn
from .._support.text import shown
from ..bodies import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    CoatedWheel,
    Groove,
    HalfSpace,
    Layer,
)
from ..bodies.layered import materials_of
from .solution import Solution, node_angles, node_spacings

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["BodyInside", "Inside", "Of", "boundaries_of", "finite_line", "inside_of", "places_of"]

#: What has an inside.
BodyInside: TypeAlias = CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel

#: What rolls, a roller, too, or what it rolls on.
Of = Literal["ball", "counterpart"]


@dataclass(frozen=True, slots=True)
class Inside:
    """One of the two bodies of a result, which has layers.

    Attributes
    ----------
    of : str
        ``"ball"`` or ``"counterpart"``.
    body : CoatedSphere or CoatedCylinder or CoatedPlane or CoatedWheel
        Its layers; of a groove those of a plane, and of a roller under a wheel those of a wheel without sides.
    radius : float
        At which its angles φ and θ are arcs [m]: its own, of a plane that of what rolls.
    """

    result: Solution
    of: Of
    body: BodyInside
    radius: float

    @property
    def turns(self) -> bool:
        """Whether it has a radius; else positions are heights above its surface."""
        return not isinstance(self.body, CoatedPlane)

    @property
    def layers(self) -> tuple[Layer | HalfSpace, ...]:
        """All layers, the base of a plane first."""
        return materials_of(self.body)

    @property
    def thickness(self) -> float:
        """How deep it is [m]; infinite with a base that deforms."""
        return _thickness(self.body)

    def depth(self, positions: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return how far below the surface places are [m]."""
        return _surface(self.body) - positions

    def bonded(self) -> NDArray[np.float64]:
        """Return the positions where layers are bonded, to something rigid and to one another [m], outwards."""
        held = not isinstance(self.body, CoatedSphere) or self.body.inner_boundary is _core.InnerBoundary.RIGID
        positions = boundaries_of(self.body)[:-1]
        return positions[np.isfinite(positions)] if held else positions[1:]

    @property
    def line_contact(self) -> bool:
        """Whether forces and powers are per length."""
        return self.result.ball.line_contact

    @property
    def passes(self) -> float:
        """Angle of its material that passes the contact per time [rad/s]: of what turns its angular speed."""
        result = self.result
        if self.of == "ball":
            return result.angular_speed
        rolling = result.angular_speed * result.ball.outer_radius
        return abs(rolling if result.linear_speed is None else result.linear_speed) / self.radius

    @property
    def bulk_power(self) -> float:
        """Power lost in it [W], under a line [W/m]."""
        return self.result.rolling_bulk_power if self.of == "ball" else self.result.counterpart_bulk_power

    def tractions(self) -> _core.Tractions:
        """Return what acts on it, as the core knows it."""
        result = self.result
        counterpart = self.of == "counterpart"
        return _core.Tractions(
            mesh=result.mesh._to_core(),
            radius=result.ball.outer_radius,
            theta_spacing=node_spacings(result)[1] if isinstance(result.ball, CoatedWheel) else None,
            crown_radius=result.ball.crown_radius if isinstance(result.ball, CoatedWheel) else None,
            line=self.line_contact,
            pressure=np.ascontiguousarray(result.pressure),
            shear_traction=np.ascontiguousarray(result.shear_traction),
            friction=result.friction > 0.0,
            compliance=result.compliance,
            curvature=result.curvature,
            patch_load=result.patch_load,
            counterpart=counterpart,
            counterpart_curvature=self._curvatures() if counterpart else (0.0, 0.0),
        )

    def _curvatures(self) -> tuple[float, float]:
        """Return how the counterpart bends along the path and across [1/m]."""
        match on := self.result.on:
            case None | CoatedPlane():
                return 0.0, 0.0
            case CoatedSphere(outer_radius=radius):
                return 1.0 / radius, 1.0 / radius
            case CoatedCylinder(outer_radius=radius):
                return 1.0 / radius, 0.0
            case CoatedWheel(outer_radius=radius, crown_radius=crown):
                return 1.0 / radius, 1.0 / crown
            case Groove(path_radius=along, radius=across):
                return (0.0 if along is None else -1.0 / along), (0.0 if across is None else -1.0 / across)
            case _:
                assert_never(on)

    def places(
        self, depth: ArrayLike | None, radius: ArrayLike | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Return positions and layers of places, see `places_of`."""
        return places_of(self.body, depth, radius)

    def node_angles(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return φ and θ of the nodes [rad], at its own radius."""
        turns = self.result.ball.outer_radius / self.radius
        phi, theta = (0.5 * np.pi + (angles - 0.5 * np.pi) * turns for angles in node_angles(self.result))
        return phi, theta

    def node_spacings(self) -> tuple[float, float]:
        """Return the angles between nodes along φ and θ [rad], likewise."""
        turns = self.result.ball.outer_radius / self.radius
        phi, theta = node_spacings(self.result)
        return phi * turns, theta * turns

    def warn_of_sides(self) -> None:
        """Warn where the sides of a tread are free and near: what is inside is that of one that goes on."""
        body, across = self.body, self.result.contact_width
        if not isinstance(body, CoatedWheel) or body.sides is not Sides.FREE or across is None:
            return
        distance = max(0.5 * (body.width - across), 0.0)
        if distance < body.thickness * (1.0 - 1e-9):
            near = f"the contact ends {distance:.3g} m from the sides, nearer than the tread is thick"
            endless = (
                "stresses near the faces are not those of free sides but of a tread that goes on, and so is the loss"
            )
            warn([f"{near} ({body.thickness:.3g} m): {endless}"])


def inside_of(result: Solution, of: Of | None = None) -> Inside:
    """Return the body of a result that is looked into.

    Parameters
    ----------
    of : "ball" or "counterpart", optional
        What rolls, or what it rolls on; by default the one that deforms, of two what rolls.

    Raises
    ------
    ValueError
        For another word, and where that body is rigid.
    """
    if of not in (None, "ball", "counterpart"):
        raise ValueError(f"of must be 'ball' or 'counterpart', got {shown(of)}")
    ball, on = result.ball, result.on
    if of is None:
        of = "ball" if ball.layers or on is None else "counterpart"
    radius = ball.outer_radius
    if of == "ball":
        if not ball.layers:
            raise ValueError("result.ball must have a layer, for there to be an inside, got none (it is rigid)")
        return Inside(result, of, ball, radius)
    if isinstance(on, CoatedCylinder) and on.layers and isinstance(ball, CoatedWheel):
        tread = CoatedWheel(core_radius=on.core_radius, layers=on.layers, width=ball.width, sides=Sides.ENDLESS)
        return Inside(result, of, tread, on.outer_radius)
    if isinstance(on, CoatedCylinder | CoatedSphere | CoatedWheel) and on.layers:
        return Inside(result, of, on, on.outer_radius)
    if isinstance(on, CoatedPlane | Groove) and (on.layers or on.base is not None):
        return Inside(result, of, CoatedPlane(layers=on.layers, base=on.base), radius)
    raise ValueError("result.on must have a layer or a base, for there to be an inside, got none (it is rigid)")


def places_of(
    body: BodyInside, depth: ArrayLike | None, radius: ArrayLike | None = None
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Return positions and layers of places given by depth or radius: two where layers meet.

    A position is a radius, in a plane the height above its surface [m].

    Raises
    ------
    TypeError, ValueError
        Unless exactly one of the two is given, as real numbers within the layers.
    """
    if (depth is None) == (radius is None):
        raise ValueError("exactly one of depth and radius must be given")
    shape = body._to_core()
    if depth is None:
        if isinstance(body, CoatedPlane):
            raise ValueError("depth must be given in place of radius in a plane")
        assert radius is not None
        return _core.places_at(shape, finite_line("radius", radius))
    below = finite_line("depth", depth)
    thickness = _thickness(body)
    if below.size and not (below.min() >= 0.0 and below.max() <= thickness * (1.0 + 1e-12)):
        raise ValueError(f"depth must be in [0, {thickness:g}] m, got {below.min():g} to {below.max():g}")
    # The innermost place is the core's to the last bit.
    innermost = boundaries_of(body)[0]
    positions = np.where(below >= thickness * (1.0 - 1e-12), innermost, _surface(body) - below)
    return _core.places_at(shape, np.clip(positions, innermost, None))


def boundaries_of(body: BodyInside) -> NDArray[np.float64]:
    """Return the positions where layers begin and end [m], outwards."""
    if not isinstance(body, CoatedPlane):
        return body.core_radius + np.cumsum([0.0, *(layer.thickness for layer in body.layers)])
    heights = -np.cumsum([0.0, *(layer.thickness for layer in reversed(body.layers))])[::-1]
    return heights if body.base is None else np.concatenate([[-np.inf], heights])


def _thickness(body: BodyInside) -> float:
    return np.inf if isinstance(body, CoatedPlane) and body.base is not None else body.thickness


def _surface(body: BodyInside) -> float:
    return 0.0 if isinstance(body, CoatedPlane) else body.outer_radius


def finite_line(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return finite numbers in one dimension.

    Raises
    ------
    TypeError, ValueError
        For anything else.
    """
    array = np.atleast_1d(as_float_array(name, values))
    if array.ndim != 1:
        raise ValueError(f"{name} must be one-dimensional, got shape {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite, got {shown(array[~np.isfinite(array)][0])}")
    return np.ascontiguousarray(array)
