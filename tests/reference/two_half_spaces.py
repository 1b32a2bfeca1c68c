"""Frictionless rolling of two viscoelastic half-spaces on each other, by sums over the past of Love's rectangle.

With the creep compliance J(s), the displacement of a point of a moving body is that of Love's rectangle times J(0),
plus, for every past time s, the displacement where the point was then, V s upstream, times dJ. A dense matrix gives the
pressure, and the slope of each body's displacement under every patch gives its loss. The method uses no transforms and
nothing periodic.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Solid:
    """A standard linear solid: instantaneous and relaxed shear modulus [Pa], relaxation time [s], Poisson's ratio."""

    instantaneous: float
    relaxed: float
    time: float
    nu: float


@dataclass(frozen=True)
class Rolled:
    """Moment of the pressure [N m], depth [m], and loss of each body per distance [N]."""

    moment: float
    depth: float
    losses: tuple[float, float]


def _love(x, z, half_x, half_z):
    """Integrate 1/r over a rectangle about the origin, seen from (x, z) [m]: A. E. H. Love (1929)."""

    def corner(p, q):
        return p * np.arcsinh(q / np.abs(p)) + q * np.arcsinh(p / np.abs(q))

    tiny = 1e-12 * half_x
    left, right, low, high = x - half_x + tiny, x + half_x + tiny, z - half_z + tiny, z + half_z + tiny
    return corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low)


def kernel(solid: Solid, speed, spacing, xi, zeta):
    """Return displacements [m/N] at (ξ, ζ), ξ in the direction of the material, due to a force on a square patch."""
    retardation = solid.time * solid.instantaneous / solid.relaxed
    # Panels of upstream distances have the width of one spacing within the window. Farther away, the displacement is a
    # smooth function of the distance.
    across = np.arange(0.0, np.ptp(xi) + 4.0 * spacing, spacing)
    ends = np.append(across, across[-1] + np.geomspace(spacing, 40.0 * speed * retardation, 16))
    nodes, weights = np.polynomial.legendre.leggauss(4)
    sizes = np.diff(ends)
    back = (ends[:-1, None] + 0.5 * sizes[:, None] * (1.0 + nodes)).ravel()
    shares = (0.5 * sizes[:, None] * weights).ravel() * np.exp(-back / (speed * retardation)) / (speed * retardation)
    half = 0.5 * spacing
    at_once = _love(xi, zeta, half, half) / solid.instantaneous
    crept = (1.0 / solid.relaxed - 1.0 / solid.instantaneous) * sum(
        share * _love(xi - shift, zeta, half, half) for shift, share in zip(back, shares, strict=True)
    )
    return (1.0 - solid.nu) / (2.0 * np.pi) * (at_once + crept) / spacing**2


def roll(solids: tuple[Solid, Solid], radius, load, speed, spacing, reach) -> Rolled:
    """Find the contact of a paraboloid of the relative `radius` [m] on a square of ± `reach` [m]."""
    half = int(np.ceil(reach / spacing))
    axis = spacing * np.arange(-half, half + 1)
    xi, zeta = (grid.ravel() for grid in np.meshgrid(axis, axis, indexing="ij"))
    offset = np.arange(-2 * half, 2 * half + 1)

    def matrix(solid, shift):
        table = kernel(solid, speed, spacing, spacing * (offset[:, None] + shift), spacing * offset[None, :])
        row, column = (np.rint(np.subtract.outer(c, c) / spacing).astype(int) + 2 * half for c in (xi, zeta))
        return table[row, column]

    compliance = sum(matrix(solid, 0.0) for solid in solids)
    gap = (xi**2 + zeta**2) / (2.0 * radius)
    touching = gap < 0.7 * reach**2 / (2.0 * radius)
    for _ in range(60):
        inside = compliance[np.ix_(touching, touching)]
        lifted, bent = np.linalg.solve(inside, np.stack([np.ones(touching.sum()), gap[touching]], axis=1)).T
        depth = (load + bent.sum()) / lifted.sum()
        force = np.zeros_like(gap)
        force[touching] = depth * lifted - bent
        now = np.where(touching, force > 0.0, compliance @ force + gap - depth < 0.0)
        assert not now[np.maximum(np.abs(xi), np.abs(zeta)) > reach - spacing].any()
        if (now == touching).all():
            break
        touching = now
    else:
        raise AssertionError("the contact did not settle")
    losses = [force @ ((matrix(solid, 0.5) - matrix(solid, -0.5)) @ force) / spacing for solid in solids]
    return Rolled(moment=float(-(xi * force).sum()), depth=float(depth), losses=(losses[0], losses[1]))
