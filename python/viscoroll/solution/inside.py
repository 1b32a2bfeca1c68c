"""Selection of one of the two bodies of a result, and its input for the core."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeAlias, cast

import numpy as np

from .. import _core
from .._support.arguments import as_float_array
from .._support.errors import InvalidInput, Range
from .._support.result_warnings import warn
from .._support.text import shown
from ..bodies import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    CoatedWheel,
    Counterbody,
    HalfSpace,
    Layer,
    RollingBody,
)
from ..bodies.layered import materials_of
from .solution import Solution, node_angles, node_spacings

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["BodyInside", "Inside", "LayersInside", "Of", "finite_line", "inside_of", "places_of"]

#: Types of bodies whose interior can be evaluated.
BodyInside: TypeAlias = CoatedSphere | CoatedCylinder | CoatedPlane | CoatedWheel

#: Rolling body (of any kind) or counterbody.
Of = Literal["body", "counterbody"]


@dataclass(frozen=True, slots=True, kw_only=True)
class LayersInside:
    """Layers whose interior is evaluated.

    Attributes
    ----------
    body : CoatedSphere or CoatedCylinder or CoatedPlane or CoatedWheel
        The body.
    """

    body: BodyInside

    @property
    def has_radius(self) -> bool:
        """Whether positions in the body are radii; in a plane they are heights above its surface."""
        return not self.body.is_flat

    @property
    def layers(self) -> tuple[Layer | HalfSpace, ...]:
        """All materials from the inside outwards, the base of a plane first."""
        return materials_of(self.body)

    @property
    def thickness(self) -> float:
        """Depth of the body [m]; infinite if it has a deformable base."""
        return self.body.depth

    def depth(self, positions: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the depths of positions below the surface [m]."""
        return self.body.surface - positions

    def bonded(self) -> NDArray[np.float64]:
        """Return the positions of all bonds, to a rigid core or base and between layers [m], outwards."""
        positions = self.body.boundaries[:-1]
        return positions[np.isfinite(positions)] if self.body.is_bonded_inside else positions[1:]

    def places(
        self, depth: ArrayLike | None, radius: ArrayLike | None = None
    ) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Return the positions [m] and the numbers of the layers at depths or radii; see `places_of`."""
        return places_of(self.body, depth, radius)


@dataclass(frozen=True, slots=True, kw_only=True)
class Inside(LayersInside):
    """Deformable body of a result, selected for evaluation of its interior.

    A groove is represented by a plane with its layers, a roller under a wheel by a wheel without side faces.

    Attributes
    ----------
    of : str
        ``"body"`` or ``"counterbody"``.
    radius : float
        Radius by which arcs are divided to give the angles φ and θ [m]: that of the body, or for a plane that of the
        rolling body.
    """

    result: Solution
    of: Of
    radius: float

    @property
    def selected(self) -> RollingBody | Counterbody:
        """Body of the result as the user gave it; `body` may be another body that represents it."""
        on = self.result.on
        if self.of == "body":
            return self.result.body
        assert on is not None
        return on

    @property
    def line_contact(self) -> bool:
        """Whether forces and powers are per length (line contact)."""
        return self.result.body.line_contact

    @property
    def passing_speed(self) -> float:
        """Angular speed at which the material of the body passes the contact [rad/s]: its surface speed / `radius`."""
        result = self.result
        if self.of == "body":
            return result.angular_speed
        rolling = result.angular_speed * result.body.outer_radius
        return abs(rolling if result.linear_speed is None else result.linear_speed) / self.radius

    @property
    def bulk_power(self) -> float:
        """Power dissipated in the body [W], in line contact [W/m]."""
        return self.result.rolling_bulk_power if self.of == "body" else self.result.counterbody_bulk_power

    def tractions(self) -> _core.Tractions:
        """Return the tractions on the body as an object of the core."""
        result = self.result
        counterbody = self.of == "counterbody"
        return _core.Tractions(
            mesh=result.mesh._to_core(),
            radius=result.body.outer_radius,
            theta_spacing=None if result.body.width is None else node_spacings(result)[1],
            crown_radius=result.body.crown_radius,
            line=self.line_contact,
            pressure=np.ascontiguousarray(result.pressure),
            shear_traction=np.ascontiguousarray(result.shear_traction),
            friction=result.friction > 0.0,
            compliance=result.compliance,
            curvature=result.curvature,
            patch_load=result.patch_load,
            counterbody=counterbody,
            counterbody_curvature=self.selected.curvatures if counterbody else (0.0, 0.0),
        )

    def node_angles(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return φ and θ of the nodes [rad], arcs divided by the radius of this body."""
        ratio = self.result.body.outer_radius / self.radius
        phi, theta = (0.5 * np.pi + (angles - 0.5 * np.pi) * ratio for angles in node_angles(self.result))
        return phi, theta

    def node_spacings(self) -> tuple[float, float]:
        """Return the spacings of the nodes along φ and θ [rad], arcs divided by the radius of this body."""
        ratio = self.result.body.outer_radius / self.radius
        phi, theta = node_spacings(self.result)
        return phi * ratio, theta * ratio

    def warn_of_sides(self) -> None:
        """Warn if free side faces are near the contact: the fields are those of a tread that continues beyond them."""
        body, across = self.body, self.result.contact_width
        if not body.has_free_faces or body.width is None or across is None:
            return
        distance = max(0.5 * (body.width - across), 0.0)
        if distance < body.thickness * (1.0 - 1e-9):
            near = "reaches the side faces"
            if distance > 0.0:
                near = f"ends {distance:.3g} m from the side faces, less than the thickness of the tread, "
                near += f"{body.thickness:.3g} m"
            warn([f"the contact {near}: stresses and loss near the faces are those of a tread without side faces"])


def inside_of(result: Solution, of: Of | None = None) -> Inside:
    """Return one body of a result, for the evaluation of its interior.

    Parameters
    ----------
    of : "body" or "counterbody", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.

    Raises
    ------
    ValueError
        If `of` has another value, or that body is rigid.
    """
    if of not in (None, "body", "counterbody"):
        raise InvalidInput("of", "must be 'body' or 'counterbody'", shown(of))
    body, on = result.body, result.on
    if of is None:
        of = "body" if body.layers or on is None else "counterbody"
    if of == "body":
        if not body.layers:
            raise InvalidInput("result.body", "must have a layer to be evaluated inside", "a rigid body")
        return Inside(result=result, of=of, body=body, radius=body.outer_radius)
    if on is None or not on.is_deformable:
        raise InvalidInput("result.on", "must have a layer or a base to be evaluated inside", "a rigid body")
    representative = cast(BodyInside, on.interior_body(body))
    radius = body.outer_radius if representative.is_flat else representative.surface
    return Inside(result=result, of=of, body=representative, radius=radius)


def places_of(
    body: BodyInside, depth: ArrayLike | None, radius: ArrayLike | None = None
) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Return positions and layers of places given by depth or radius; a boundary between layers yields two places.

    Returns
    -------
    positions : ndarray, shape (places,)
        Radii, or in a plane heights above its surface [m].
    layers : ndarray of int, shape (places,)
        Numbers of the layers, counted from the center or the base outwards.

    Raises
    ------
    TypeError, ValueError
        Unless exactly one of depth and radius is given, as real numbers within the layers.
    """
    if (depth is None) == (radius is None):
        raise ValueError("exactly one of depth and radius must be given")
    shape = body._to_core()
    if depth is None:
        if body.is_flat:
            raise InvalidInput("depth", "must be given instead of radius for a plane")
        assert radius is not None
        return _core.places_at(shape, finite_line("radius", radius))
    below = finite_line("depth", depth)
    thickness = body.depth
    if below.size and not (below.min() >= 0.0 and below.max() <= thickness * (1.0 + 1e-12)):
        raise Range(0.0, thickness, "m").error("depth", f"{below.min():g} to {below.max():g}")
    # The innermost position must equal that of the core to the last bit.
    innermost = body.boundaries[0]
    positions = np.where(below >= thickness * (1.0 - 1e-12), innermost, body.surface - below)
    return _core.places_at(shape, np.clip(positions, innermost, None))


def finite_line(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return values as a one-dimensional array of finite numbers.

    Raises
    ------
    TypeError, ValueError
        If they are not real, finite or one-dimensional.
    """
    array = np.atleast_1d(as_float_array(name, values))
    if array.ndim != 1:
        raise InvalidInput(name, "must be one-dimensional", f"shape {array.shape}")
    if not np.isfinite(array).all():
        raise InvalidInput(name, "must be finite", shown(array[~np.isfinite(array)][0]))
    return np.ascontiguousarray(array)
