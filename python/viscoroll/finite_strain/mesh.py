"""Mesh of the cover: elements in polar coordinates with nine nodes each, fine at the contact."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

__all__ = ["RingMesh", "ring_mesh"]

#: Gauss points and weights on [-1, 1] along the angle and along the radius. With two points along the angle, strains
#: are evaluated where those of quadratic elements are most accurate.
_ANGLE_POINTS = np.array([-1.0, 1.0]) / np.sqrt(3.0)
_RADIUS_POINTS = np.array([-np.sqrt(0.6), 0.0, np.sqrt(0.6)])
_RADIUS_WEIGHTS = np.array([5.0, 8.0, 5.0]) / 9.0

#: Largest growth of an element over its neighbor outside of the contact.
_GROWTH = 1.15

#: Largest length of an element, as an angle [rad] and in units of the thickness of the cover.
_LARGEST_ANGLE, _LARGEST_LENGTH = 0.15, 1.0

#: Largest size of the elements at the surface along the radius, per half-length of the contact, and their growth with
#: depth. At a strain of 0.1 %, uniform elements make the penetration 1 % too small.
_SURFACE_SIZE, _DEPTH_GROWTH = 0.3, 0.35


@dataclass(frozen=True, eq=False)
class RingMesh:
    """Quadratic elements on a ring; lengths are in units of the outer radius.

    The angle φ is measured from the lowest point, in the direction in which the material moves. Elements are numbered
    first along the radius, then along the angle. A Gauss point has four indices: element along the angle, point along
    the angle (2), element along the radius, point along the radius (3).

    Attributes
    ----------
    angles : ndarray, shape (2 m,)
        Angles of the nodes [rad], increasing, for m elements along the angle.
    radii : ndarray, shape (2 n + 1,)
        Radii of the nodes, for n elements along the radius.
    layers : ndarray of int, shape (n,)
        Layer of each element along the radius.
    nodes : ndarray of int, shape (m n, 9)
        Nodes of the elements. Node i + (2 n + 1) j has the radius i and the angle j.
    gauss_angles : ndarray, shape (2 m,)
        Angles of the Gauss points [rad].
    gauss_radii : ndarray, shape (3 n,)
        Radii of the Gauss points.
    ring_weights : ndarray, shape (3 n,)
        Integration weights along the radius, R dR.
    weights : ndarray, shape (m n, 6)
        Integration weights R dR dφ.
    slopes : ndarray, shape (m n, 6, 2, 9)
        Derivatives ∂N/∂R and ∂N/(R ∂φ) of the shape functions at the Gauss points.
    shapes : ndarray, shape (6, 9)
        Shape functions at the Gauss points.
    directions : ndarray, shape (m n, 6, 2, 2)
        Unit vectors e_R and e_φ at the Gauss points, as components along the ground and upwards.
    pressure_shapes : ndarray, shape (6, 3)
        Shape functions of the pressure at the Gauss points: 1 and the two local coordinates.
    """

    angles: NDArray[np.float64]
    radii: NDArray[np.float64]
    layers: NDArray[np.intp]
    nodes: NDArray[np.intp]
    gauss_angles: NDArray[np.float64]
    gauss_radii: NDArray[np.float64]
    ring_weights: NDArray[np.float64]
    weights: NDArray[np.float64]
    slopes: NDArray[np.float64]
    shapes: NDArray[np.float64]
    directions: NDArray[np.float64]
    pressure_shapes: NDArray[np.float64]

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of elements along the angle and along the radius."""
        return len(self.angles) // 2, len(self.layers)

    @property
    def positions(self) -> NDArray[np.float64]:
        """Undeformed positions of the nodes, along the ground and upwards from the axis, of shape (nodes, 2)."""
        angle, radius = np.meshgrid(self.angles, self.radii, indexing="ij")
        return np.stack([radius * np.sin(angle), -radius * np.cos(angle)], axis=-1).reshape(-1, 2)

    @property
    def surface(self) -> NDArray[np.intp]:
        """Nodes on the outer surface, in the order of their angles."""
        return np.arange(1, len(self.angles) + 1) * len(self.radii) - 1

    @property
    def core(self) -> NDArray[np.intp]:
        """Nodes on the core, in the order of their angles."""
        return np.arange(len(self.angles)) * len(self.radii)

    def by_ring(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return values at Gauss points, of shape (m n, 6, k), as an array of shape (2 m, 3 n, k)."""
        m, n = self.shape
        return values.reshape(m, n, 2, 3, -1).swapaxes(1, 2).reshape(2 * m, 3 * n, -1)

    def by_element(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return values of shape (2 m, 3 n, k) as an array of shape (m n, 6, k): the inverse of `by_ring`."""
        m, n = self.shape
        return values.reshape(m, 2, n, 3, -1).swapaxes(1, 2).reshape(m * n, 6, -1)


def ring_mesh(
    *, core_radius: float, thicknesses: Sequence[float], half_angle: float, across: int, through: int
) -> RingMesh:
    """Return a mesh for a contact of a given size.

    Parameters
    ----------
    core_radius : float
        Radius of the core in units of the outer radius.
    thicknesses : sequence of float
        Thicknesses of the layers from the core outwards, in units of the outer radius.
    half_angle : float
        Half of the angle over which elements have equal size [rad].
    across : int
        Number of elements over twice this angle.
    through : int
        Number of elements through a cover that is thinner than the contact is long. A thicker cover has more of them,
        finer near the surface; every layer has at least two.
    """
    corners = _angles(half_angle, across, sum(thicknesses))
    radii, layers = _radii(core_radius, thicknesses, half_angle, through)
    return _assemble(corners, radii, layers)


def _angles(half_angle: float, across: int, thickness: float) -> NDArray[np.float64]:
    """Return the angles between the elements from -π to π."""
    step = 2.0 * half_angle / across
    largest = max(step, min(_LARGEST_ANGLE, _LARGEST_LENGTH * thickness))
    sizes: list[float] = []
    while half_angle + sum(sizes) < np.pi:
        sizes.append(min(step * _GROWTH ** (len(sizes) + 1), largest))
    outside = half_angle + np.cumsum(sizes) * (np.pi - half_angle) / sum(sizes)
    inside = np.linspace(-half_angle, half_angle, across + 1)
    return np.concatenate([-outside[::-1], inside, outside])


def _radii(
    core_radius: float, thicknesses: Sequence[float], half_angle: float, through: int
) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Return the radii between the elements, and the layer of each element."""
    thickness = sum(thicknesses)
    depth = np.linspace(0.0, thickness, 2001)
    largest = thickness / through
    size = np.minimum(min(_SURFACE_SIZE * half_angle, largest) + _DEPTH_GROWTH * depth, largest)
    # Number of elements above a depth.
    above = np.concatenate([[0.0], np.cumsum(np.diff(depth) * 0.5 * (1.0 / size[1:] + 1.0 / size[:-1]))])
    bounds = thickness - np.concatenate([[0.0], np.cumsum(thicknesses)])
    radii, layers = [np.array([core_radius])], []
    for layer, (low, high) in enumerate(pairwise(np.interp(bounds, depth, above))):
        count = max(2, round(low - high))
        layers += [layer] * count
        radii.append(core_radius + thickness - np.interp(np.linspace(low, high, count + 1)[1:], above, depth))
    return np.concatenate(radii), np.array(layers)


def _assemble(corners: NDArray[np.float64], radii: NDArray[np.float64], layers: NDArray[np.intp]) -> RingMesh:
    m, n = len(corners) - 1, len(layers)
    half_angle, half_radius = 0.5 * np.diff(corners), 0.5 * np.diff(radii)
    middle_angle, middle_radius = corners[:-1] + half_angle, radii[:-1] + half_radius
    gauss_angles = middle_angle[:, None] + half_angle[:, None] * _ANGLE_POINTS
    gauss_radii = middle_radius[:, None] + half_radius[:, None] * _RADIUS_POINTS
    ring_weights = gauss_radii * half_radius[:, None] * _RADIUS_WEIGHTS

    rows = 2 * n + 1
    i, j = 2 * np.arange(n), 2 * np.arange(m)
    local_i, local_j = (part.ravel() for part in np.meshgrid(np.arange(3), np.arange(3), indexing="ij"))
    nodes = (i[None, :, None] + local_i) + rows * ((j[:, None, None] + local_j) % (2 * m))

    shape, slope = _quadratic(_ANGLE_POINTS), _quadratic_slopes(_ANGLE_POINTS)
    shape_r, slope_r = _quadratic(_RADIUS_POINTS), _quadratic_slopes(_RADIUS_POINTS)
    # Indices: element along angle and radius, point along angle and radius, node along radius and angle.
    along_radius = np.einsum("aj,bi->abij", shape, slope_r)[None, None] / half_radius[None, :, None, None, None, None]
    along_angle = np.einsum("aj,bi->abij", slope, shape_r)[None, None] / (
        half_angle[:, None, None, None, None, None] * gauss_radii[None, :, None, :, None, None]
    )
    slopes = np.stack(np.broadcast_arrays(along_radius, along_angle), axis=4).reshape(m * n, 6, 2, 9)
    weights = np.broadcast_to(half_angle[:, None, None, None] * ring_weights[None, :, None, :], (m, n, 2, 3))
    sine, cosine = np.sin(gauss_angles), np.cos(gauss_angles)
    vectors = np.stack([np.stack([sine, -cosine], axis=-1), np.stack([cosine, sine], axis=-1)], axis=-2)
    directions = np.broadcast_to(vectors[:, None, :, None], (m, n, 2, 3, 2, 2)).reshape(m * n, 6, 2, 2)
    xi, eta = (part.ravel() for part in np.meshgrid(_ANGLE_POINTS, _RADIUS_POINTS, indexing="ij"))
    return RingMesh(
        angles=np.stack([corners[:-1], middle_angle], axis=1).ravel(),
        radii=np.append(np.stack([radii[:-1], middle_radius], axis=1).ravel(), radii[-1]),
        layers=layers,
        nodes=nodes.reshape(m * n, 9),
        gauss_angles=gauss_angles.ravel(),
        gauss_radii=gauss_radii.ravel(),
        ring_weights=ring_weights.ravel(),
        weights=weights.reshape(m * n, 6),
        slopes=slopes,
        shapes=np.einsum("aj,bi->abij", shape, shape_r).reshape(6, 9),
        directions=directions,
        pressure_shapes=np.stack([np.ones(6), xi, eta], axis=1),
    )


def _quadratic(s: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([0.5 * s * (s - 1.0), 1.0 - s**2, 0.5 * s * (s + 1.0)], axis=1)


def _quadratic_slopes(s: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([s - 0.5, -2.0 * s, s + 0.5], axis=1)
