"""Strain path of a material point, its amplitude, and the loss of a linear material along it.

A strain deviator e is represented by the vector p = (√2 e_rr, √2 e_φφ, √2 e_θθ, 2e_rφ, 2e_rθ, 2e_φθ) of length
√(2 e:e): simple shear of amplitude γ has |p| = γ.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats
from .._support.extras import extra
from ..solution.inside import Inside
from ..solution.interior_fields import strains
from ..solution.loss import contact_size

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

__all__ = ["StrainPath", "deviatoric_path", "half_range", "harmonic_squares", "strain_paths"]

#: Number of nodes per half-width of the contact at which strain is evaluated along the path, if the mesh has so many.
_ALONG = 20

#: Number of Gauss points across the path: over the half-width of the contact, and over each panel beside the contact.
_ACROSS, _BESIDE = 6, 4

#: Step divided by the distance from the middle, beyond 1.5 half-widths, where strain varies more slowly.
_GROWTH = 0.08

#: Limits of the evaluated region: largest distance along the path, and across it from the edge of the contact, in
#: half-widths; largest depth divided by that distance; largest distance across in thicknesses of a thin layer, of whose
#: loss 1e-3 lies beyond 3 thicknesses and 1e-4 beyond 8. Over the rest of a revolution, strain is assumed linear.
_REACH, _DEEP, _FAR_IN_THIN = 8.0, 1.5, 8.0

#: Highest order of the strain in units of radius/half-width: amplitudes have a relative error of 1e-3. At the ends of a
#: contact on a thin layer, strain varies over the thickness; the highest order is then at least 0.16 times the first
#: factor times radius/thickness. It is at most π divided by the node spacing.
_ORDERS_PER_CONTACT, _OF_THICKNESS = 25.0, 0.16

#: Length of a panel of Gauss points, in depth or beside the contact, divided by the half-width of the contact or by the
#: distance of the panel from the first panel, whichever is larger.
_PANEL = 1.5

#: Largest angle from the contact [rad]: just below half a revolution, and below a third of that on a plane.
_HALF_TURN, _THIRD = 0.999 * math.pi, 0.999 * math.pi / 3.0

#: Largest difference between the tractions on both sides of a symmetric contact, due to the tolerance of the solver,
#: relative to the largest traction.
_SAME_SIDES = 1e-4

#: Ratio of the period of the harmonics to the evaluated path on a plane; the material is at rest in between.
_PADDING = 8.0


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class StrainPath:
    """Strain paths of the points of one layer through a contact, with the volume of each point.

    Attributes
    ----------
    layer : int
        Number of the layer, from the center or the base outwards.
    phi : ndarray, shape (steps,)
        Angles of the steps along the path [rad], increasing, with the contact in the middle.
    period : float
        Period of the path [rad].
    p : ndarray, shape (points, steps, 6)
        Strain vectors, as defined at the top of this file [-].
    volumes : ndarray, shape (points,)
        Volume of each point per angle φ [m³/rad], in line contact [m²/rad]. A loss w per volume and revolution [J/m³]
        is the power Ω Σ w volumes.
    depth, theta : ndarray, shape (points,)
        Depth [m] and angle θ [rad] of the points.
    """

    layer: int
    phi: Floats
    period: float
    p: Floats
    volumes: Floats
    depth: Floats
    theta: Floats


def strain_paths(
    inside: Inside,
    layers: Sequence[int],
    *,
    depths: int = 4,
    reach: float = _REACH,
    orders: float = _ORDERS_PER_CONTACT,
) -> tuple[StrainPath, ...]:
    """Return the strain paths in layers of a body.

    Parameters
    ----------
    inside : Inside
        Body of the result.
    layers : sequence of int
        Numbers of the layers, the base of a plane first.
    depths : int, default 4
        Number of Gauss points through a layer, or through each panel of a thick layer.
    reach : float, default 8
        Distance along the path and across it, in half-widths of the contact.
    orders : float, default 25
        Highest order of the strain, divided by the ratio of the radius to the half-width of the contact.

    Returns
    -------
    tuple of StrainPath
        One for each layer.
    """
    columns = [_depths(inside, layer, depths, reach) for layer in layers]
    phi = _phi(inside, reach)
    theta, across = _theta(inside, reach)
    every = np.concatenate([depth for depth, _ in columns])
    strain = strains(inside, every, phi, theta, max_order=_max_order(inside, orders))
    p = np.moveaxis(deviatoric_path(np.moveaxis(strain, 1, 0)), (1, 3, 2, 0), (0, 1, 2, 3))
    paths = []
    for number, (depth, weights), start in zip(
        layers, columns, np.cumsum([0, *(len(d) for d, _ in columns)]), strict=False
    ):
        part = p[start : start + len(depth)]
        measure = _measure(inside, depth) * weights
        paths.append(
            StrainPath(
                layer=number,
                phi=phi,
                period=_period(inside, phi),
                p=np.ascontiguousarray(part.reshape(-1, len(phi), 6)),
                volumes=(measure[:, None] * across).ravel(),
                depth=np.repeat(depth, len(theta)),
                theta=np.tile(theta, len(depth)),
            )
        )
    return tuple(paths)


def deviatoric_path(strain: NDArray[np.float64]) -> Floats:
    """Return the vectors p of strains, with the components (rr, φφ, θθ, rφ, rθ, φθ) on the first axis."""
    deviator = strain.copy()
    deviator[:3] -= strain[:3].mean(axis=0)
    return deviator * np.sqrt([2.0, 2.0, 2.0, 4.0, 4.0, 4.0]).reshape(6, *[1] * (strain.ndim - 1))


def half_range(p: Floats) -> Floats:
    """Return the amplitude of paths: half of the largest distance between two strains of a path.

    Parameters
    ----------
    p : ndarray, shape (points, steps, 6)
        Strain [-].

    Returns
    -------
    ndarray, shape (points,)
        g [-]. All pairs are compared, because a search for the farthest points misses up to 5 %.
    """
    found = np.empty(len(p))
    for point, path in enumerate(p):
        square = (path**2).sum(axis=1)
        found[point] = (square[:, None] + square - 2.0 * path @ path.T).max()
    return 0.5 * np.sqrt(np.maximum(found, 0.0))


def harmonic_squares(path: StrainPath) -> tuple[Floats, Floats]:
    """Return orders m, which need not be integers, and the loss of each per loss modulus, 4π m |p_m|².

    The product with μ''_m is the energy that a linear material dissipates per volume and revolution [J/m³],
    docs/theory/dissipation.md.

    Returns
    -------
    orders : ndarray, shape (orders,)
        Orders m [-].
    squares : ndarray, shape (points, orders)
        4π m |p_m|² of each point and order [-].
    """
    p = _resampled(path)
    step = 2.0 * math.pi / path.period
    orders = step * np.arange(1, p.shape[1] // 2)
    spectrum = np.fft.rfft(p, axis=1)[:, 1 : len(orders) + 1] / (p.shape[1] * step)
    return orders, 4.0 * math.pi * step * orders * (spectrum.real**2 + spectrum.imag**2).sum(axis=2)


def _resampled(path: StrainPath) -> Floats:
    """Return a path at even steps over its whole period; strain is linear over the part that was not evaluated."""
    with extra("studies"):
        from scipy.fft import next_fast_len
        from scipy.interpolate import CubicSpline

    phi = path.phi
    count = next_fast_len(math.ceil(path.period / np.diff(phi).min()), real=True)
    even = phi[0] + path.period / count * np.arange(count)
    followed = even <= phi[-1]
    p = np.empty((len(path.p), count, path.p.shape[2]))
    p[:, followed] = CubicSpline(phi, path.p, axis=1)(even[followed])
    fraction = ((even[~followed] - phi[-1]) / (phi[0] + path.period - phi[-1]))[:, None]
    p[:, ~followed] = (1.0 - fraction) * path.p[:, -1:] + fraction * path.p[:, :1]
    return p


def _phi(inside: Inside, reach: float) -> Floats:
    """Return angles along the path at nodes of the mesh, where the pressure steps between patches matter least."""
    spacing = inside.node_spacings()[0]
    half_width = max((inside.result.semi_axis_x or 0.0) / inside.radius, spacing)
    limit = _HALF_TURN if inside.has_radius else _THIRD
    return 0.5 * math.pi + spacing * _steps(half_width / spacing, _ALONG, min(reach * half_width, limit) / spacing)


def _theta(inside: Inside, reach: float) -> tuple[Floats, Floats]:
    """Return Gauss points across the path, and their weights [rad]; in line contact, one point of weight 1.

    For a mirror-symmetric contact, the points lie on one side, with double weights.
    """
    if inside.line_contact:
        return np.array([0.5 * math.pi]), np.ones(1)
    half_width = max((inside.result.semi_axis_z or 0.0) / inside.radius, inside.node_spacings()[1])
    far = half_width + min(_FAR_IN_THIN * inside.thickness / inside.radius, reach * half_width)
    if inside.body.has_free_faces and inside.body.width is not None:
        far = min(far, 0.5 * inside.body.width / inside.radius)
    far = min(far, _HALF_TURN)
    inner = min(half_width, far)
    ends = _panels(inner, far, half_width)
    counts = [_ACROSS, *[_BESIDE] * (len(ends) - 1)]
    theta, weights = _gauss(np.concatenate([[0.0], ends]), counts)
    if _is_mirrored(inside):
        return 0.5 * math.pi + theta, 2.0 * weights
    return 0.5 * math.pi + np.concatenate([-theta[::-1], theta]), np.concatenate([weights[::-1], weights])


def _is_mirrored(inside: Inside) -> bool:
    """Return whether the contact is mirror-symmetric about its middle plane."""
    result = inside.result
    along, sideways = result.shear_traction
    pairs = [(result.pressure, 1.0), (along, 1.0), (sideways, -1.0)]
    largest = max(float(abs(values).max()) for values, _ in pairs)
    return all(float(abs(values - sign * values[:, ::-1]).max()) <= _SAME_SIDES * largest for values, sign in pairs)


def _panels(near: float, far: float, size: float) -> Floats:
    """Return the ends of panels of increasing length between two distances; the last panel ends at `far`."""
    ends = [near]
    while ends[-1] < far * (1.0 - 1e-9):
        ends.append(ends[-1] + _PANEL * max(size, ends[-1] - near))
    scale = (far - near) / (ends[-1] - near) if len(ends) > 1 else 1.0
    return near + scale * (np.array(ends) - near)


def _gauss(ends: Floats, counts: Sequence[int]) -> tuple[Floats, Floats]:
    """Return Gauss points in panels, with the given number in each, and their weights."""
    places, weights = [], []
    for low, high, count in zip(ends[:-1], ends[1:], counts, strict=True):
        nodes, unit_weights = np.polynomial.legendre.leggauss(count)
        places.append(low + 0.5 * (high - low) * (1.0 + nodes))
        weights.append(0.5 * (high - low) * unit_weights)
    return np.concatenate(places), np.concatenate(weights)


def _max_order(inside: Inside, orders: float) -> float:
    """Return the highest order of the strain sum of a contact."""
    spacing = min(inside.node_spacings()[: 1 if inside.line_contact else 2])
    thinnest = float(np.diff(inside.body.boundaries).min())
    length = min(contact_size(inside.result), thinnest / _OF_THICKNESS)
    return min(orders * inside.radius / length, math.pi / spacing)


def _steps(half_width: float, count: int, reach: float) -> Floats:
    """Return node numbers from -reach to reach: even steps over 1.5 half-widths, and increasing steps beyond."""
    even = max(1, int(half_width / count))
    nodes = list(range(0, int(1.5 * half_width) + even + 1, even))
    while nodes[-1] < reach:
        nodes.append(nodes[-1] + max(even, int(_GROWTH * nodes[-1])))
    kept = np.array([node for node in nodes if node <= reach], dtype=float)
    return np.concatenate([-kept[:0:-1], kept])


def _depths(inside: Inside, layer: int, points: int, reach: float) -> tuple[Floats, Floats]:
    """Return depths in a layer, Gauss points in panels that grow with the depth, and their weights [m]."""
    edges = inside.depth(inside.body.boundaries)
    below, above = float(edges[layer]), float(edges[layer + 1])
    size = contact_size(inside.result)
    ends = _panels(above, min(below, above + _DEEP * reach * size), max(size, above))
    return _gauss(ends, [points] * (len(ends) - 1))


def _measure(inside: Inside, depth: Floats) -> Floats:
    """Return the volume element at depths without dr and dθ; docs/theory/dissipation.md."""
    curved = inside.body.curved_directions
    directions = 1 if inside.line_contact else 2
    return (inside.radius - depth) ** curved * inside.radius ** (directions - curved)


def _period(inside: Inside, phi: Floats) -> float:
    return 2.0 * math.pi if inside.has_radius else _PADDING * float(phi[-1] - phi[0])
