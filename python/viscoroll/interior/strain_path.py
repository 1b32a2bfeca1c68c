"""How the strain of a material point goes round, its amplitude, and what a linear material loses on the way.

A deviator of strain e is the vector p = (√2 e_rr, √2 e_φφ, √2 e_θθ, 2e_rφ, 2e_rθ, 2e_φθ), of length √(2 e:e): simple
shear of amplitude γ has |p| = γ.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats
from .._support.cautions import kept_in_results
from .._support.extras import extra
from ..bodies import CoatedCylinder, CoatedPlane, CoatedSphere, CoatedWheel
from ..solution.inside import Inside, boundaries_of
from ..solution.interior_fields import interior
from ..solution.loss import contact_size

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

__all__ = ["StrainPath", "deviatoric_path", "half_range", "harmonic_squares", "strain_paths"]

#: Nodes of a contact's half-width along the path, and across it, that are looked at, where the mesh has so many.
_ALONG, _ACROSS = 20, 8

#: Steps beyond 1.5 half-widths, per distance from the middle: what is farther away varies the more slowly.
_GROWTH = 0.08

#: How far along the path strain is followed, in half-widths; over the rest of the revolution it fades evenly.
_REACH = 8.0

#: How far across, and how deep, in half-widths beyond the contact: strain falls as the square of the distance.
_FAR = 6.0

#: Depth of the first of the panels that Gauss's points lie in, in half-widths, and how much each is than its depth.
_PANEL = 1.5

#: Half a revolution, of a plane the third of one that its fields are known over, less a hair [rad].
_HALF_TURN, _THIRD = 0.999 * math.pi, 0.999 * math.pi / 3.0

#: What a plane's path is lengthened by, at rest, before its harmonics are taken.
_PADDING = 8.0


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class StrainPath:
    """Strain of the points of one layer on their way through a contact, and what each of them stands for.

    Attributes
    ----------
    layer : int
        Its number, from the center or the base outwards.
    phi : ndarray, shape (steps,)
        Places along the path [rad], increasing, the contact in the middle.
    period : float
        After which all comes round [rad].
    p : ndarray, shape (points, steps, 6)
        Strain, as the head of this file has it [-].
    volumes : ndarray, shape (points,)
        Measure of each point [m²], under a line [m]: a density w per revolution is the power Ω Σ w volumes.
    depth, theta : ndarray, shape (points,)
        Where the points are [m] and [rad].
    """

    layer: int
    phi: Floats
    period: float
    p: Floats
    volumes: Floats
    depth: Floats
    theta: Floats


def strain_paths(
    inside: Inside, layers: Sequence[int], *, depths: int = 3, reach: float = _REACH
) -> tuple[StrainPath, ...]:
    """Follow the strain in layers of a body.

    Parameters
    ----------
    inside : Inside
        The body.
    layers : sequence of int
        Numbers of its layers, the base of a plane first.
    depths : int, default 3
        Gauss's points through a layer, of a thick one through each of its panels.
    reach : float, default 8
        How far along the path, in half-widths of the contact.

    Returns
    -------
    tuple of StrainPath
        One for each layer.
    """
    columns = [_depths(inside, layer, depths) for layer in layers]
    phi = _phi(inside, reach)
    theta, across = _theta(inside)
    every = np.concatenate([depth for depth, _ in columns])
    with kept_in_results():
        found = interior(inside.result, depth=every, phi=phi, theta=theta, of=inside.of)
    p = np.moveaxis(deviatoric_path(found.strain.to_numpy()), (1, 3, 2, 0), (0, 1, 2, 3))
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
    """Return p of strains, components first, (rr, φφ, θθ, rφ, rθ, φθ)."""
    deviator = strain.copy()
    deviator[:3] -= strain[:3].mean(axis=0)
    return deviator * np.sqrt([2.0, 2.0, 2.0, 4.0, 4.0, 4.0]).reshape(6, *[1] * (strain.ndim - 1))


def half_range(p: Floats) -> Floats:
    """Return the amplitude of paths, half of the largest distance between two of their places.

    Parameters
    ----------
    p : ndarray, shape (points, steps, 6)
        Strain [-].

    Returns
    -------
    ndarray, shape (points,)
        g [-]. All pairs are tried: a search for farthest points misses up to 5 %.
    """
    found = np.empty(len(p))
    for point, path in enumerate(p):
        square = (path**2).sum(axis=1)
        found[point] = (square[:, None] + square - 2.0 * path @ path.T).max()
    return 0.5 * np.sqrt(np.maximum(found, 0.0))


def harmonic_squares(path: StrainPath) -> tuple[Floats, Floats]:
    """Return orders m, which need not be whole, and what each loses by its loss modulus, 4π m |p_m|².

    Their product with μ''_m is the energy that a linear material loses per volume and revolution [J/m³], theory.md
    section 11.

    Returns
    -------
    orders : ndarray, shape (orders,)
        m [-].
    squares : ndarray, shape (points, orders)
        [-].
    """
    p = _evenly(path)
    step = 2.0 * math.pi / path.period
    orders = step * np.arange(1, p.shape[1] // 2)
    spectrum = np.fft.rfft(p, axis=1)[:, 1 : len(orders) + 1] / (p.shape[1] * step)
    return orders, 4.0 * math.pi * step * orders * (spectrum.real**2 + spectrum.imag**2).sum(axis=2)


def _evenly(path: StrainPath) -> Floats:
    """Return a path on even steps over its whole period; where it was not followed it fades evenly."""
    with extra("studies"):
        from scipy.interpolate import CubicSpline

    phi = path.phi
    count = int(2 ** math.ceil(math.log2(2.0 * path.period / np.diff(phi).min())))
    even = phi[0] + path.period / count * np.arange(count)
    followed = even <= phi[-1]
    p = np.empty((len(path.p), count, path.p.shape[2]))
    p[:, followed] = CubicSpline(phi, path.p, axis=1)(even[followed])
    share = ((even[~followed] - phi[-1]) / (phi[0] + path.period - phi[-1]))[:, None]
    p[:, ~followed] = (1.0 - share) * path.p[:, -1:] + share * path.p[:, :1]
    return p


def _phi(inside: Inside, reach: float) -> Floats:
    """Return places along the path, at nodes of the mesh, where the pressure's steps hardly show."""
    spacing = inside.node_spacings()[0]
    half_width = max((inside.result.semi_axis_x or 0.0) / inside.radius, spacing)
    limit = _HALF_TURN if inside.turns else _THIRD
    return 0.5 * math.pi + spacing * _steps(half_width / spacing, _ALONG, min(reach * half_width, limit) / spacing)


def _theta(inside: Inside) -> tuple[Floats, Floats]:
    """Return places across the path, and the weights of an integral over them [rad]; under a line one, of weight 1."""
    if inside.line_contact:
        return np.array([0.5 * math.pi]), np.ones(1)
    with extra("studies"):
        from scipy.interpolate import CubicSpline

    spacing = inside.node_spacings()[1]
    half_width = max((inside.result.semi_axis_z or 0.0) / inside.radius, spacing)
    reach = half_width + min(3.0 * inside.thickness / inside.radius, _FAR * half_width)
    if isinstance(inside.body, CoatedWheel):
        reach = min(reach, 0.5 * inside.body.width / inside.radius)
    theta = spacing * _steps(half_width / spacing, _ACROSS, min(reach, 0.5 * _HALF_TURN) / spacing)
    weights = [CubicSpline(theta, unit).integrate(theta[0], theta[-1]) for unit in np.eye(len(theta))]
    return 0.5 * math.pi + theta, np.array(weights)


def _steps(half_width: float, count: int, reach: float) -> Floats:
    """Return numbers of nodes, even ones over 1.5 half-widths and ever longer ones beyond, from -reach to reach."""
    even = max(1, int(half_width / count))
    nodes = list(range(0, int(1.5 * half_width) + even + 1, even))
    while nodes[-1] < reach:
        nodes.append(nodes[-1] + max(even, int(_GROWTH * nodes[-1])))
    kept = np.array([node for node in nodes if node <= reach], dtype=float)
    return np.concatenate([-kept[:0:-1], kept])


def _depths(inside: Inside, layer: int, points: int) -> tuple[Floats, Floats]:
    """Return depths in a layer, by Gauss in panels that grow with the depth, and their weights [m]."""
    edges = inside.depth(boundaries_of(inside.body))
    below, above = float(edges[layer]), float(edges[layer + 1])
    size = contact_size(inside.result)
    deepest = min(below, above + _FAR * 2.0 * size)
    panels = [above]
    while panels[-1] < deepest * (1.0 - 1e-9):
        panels.append(panels[-1] + _PANEL * max(size, panels[-1]))
    count = len(panels) - 1
    # Panels grow alike, and end where the layer does.
    scale = (deepest - above) / (panels[-1] - above)
    ends = above + scale * (np.array(panels) - above)
    nodes, weights = np.polynomial.legendre.leggauss(points)
    widths = np.diff(ends)
    depth = ends[:-1, None] + 0.5 * widths[:, None] * (1.0 + nodes)
    return depth.ravel(), (0.5 * widths[:, None] * np.broadcast_to(weights, (count, points))).ravel()


def _measure(inside: Inside, depth: Floats) -> Floats:
    """Return the measure of the volume integral at depths, but for dr and dθ; theory.md section 11."""
    radius = inside.radius
    match inside.body:
        case CoatedSphere():
            return (radius - depth) ** 2
        case CoatedCylinder():
            return radius - depth
        case CoatedWheel():
            return (radius - depth) * radius
        case CoatedPlane():
            return np.full(len(depth), radius if inside.line_contact else radius**2)


def _period(inside: Inside, phi: Floats) -> float:
    return 2.0 * math.pi if inside.turns else _PADDING * float(phi[-1] - phi[0])
