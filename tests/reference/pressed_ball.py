"""A ball with incompressible layers pressed on a plane, axisymmetric: python -m tests.reference.pressed_ball [rings].

The fields are zonal harmonics of Lamb's solutions (Love, Treatise, 4th edition, section 172) in each layer, on a rigid
core; pressure is constant on rings, which are narrower towards the edge, where it falls to zero.
"""

from __future__ import annotations

import sys

import numpy as np
from scipy.optimize import brentq

#: Number of solved orders; the outermost layer alone determines higher ones, as a half-space with a curvature term.
SOLVED = 5000


def pressed_depth(core_radius, layers, load, rings=100, orders=10000):
    """Return the approach of the plane [m]; layers are (thickness, modulus) from the core outwards."""
    radius = core_radius + sum(thickness for thickness, _ in layers)
    compliance = np.array([_compliance(n, core_radius, layers) for n in range(1, SOLVED + 1)])
    high = np.arange(SOLVED + 1, orders + 1)
    half_space = radius / (2.0 * layers[-1][1])
    curved = (compliance[-1] * SOLVED / half_space - 1.0) * SOLVED
    compliance = np.append(compliance, half_space / high * (1.0 + curved / high))

    def forces(edge):
        bound = edge * np.sin(np.linspace(0.0, 0.5 * np.pi, rings + 1))
        middle = 0.5 * (bound[1:] + bound[:-1])
        system = np.zeros((rings + 1, rings + 1))
        system[:-1, :-1] = _influence(compliance, np.cos(bound), np.cos(middle))
        system[:-1, -1] = -1.0
        system[-1, :-1] = 2.0 * np.pi * radius**2 * -np.diff(np.cos(bound))
        return np.linalg.solve(system, [*(-radius * (1.0 - np.cos(middle))), load])

    def at_the_edge(edge):
        pressure = forces(edge)
        return pressure[rings - 1] / pressure[0]

    return forces(brentq(at_the_edge, 0.12, 0.2, xtol=1e-6))[-1]


def _influence(compliance, bound, middle):
    """Return displacements at cosines of middles due to unit pressures between those of bounds, by recursion."""
    before, here, of_middle, next_middle = np.ones_like(bound), bound, np.ones_like(middle), middle
    influence = np.zeros((middle.size, middle.size))
    for n, yielding in enumerate(compliance, start=1):
        after = ((2 * n + 1) * bound * here - n * before) / (n + 1)
        influence += np.outer(yielding * next_middle, -0.5 * np.diff(after - before))
        before, here = here, after
        of_middle, next_middle = next_middle, ((2 * n + 1) * middle * next_middle - n * of_middle) / (n + 1)
    return influence


def _compliance(n, core_radius, layers):
    """Return the radial displacement of an order due to its pressure [m/Pa]."""
    size = 4 * len(layers)
    system, right = np.zeros((size, size)), np.zeros(size)
    unit = np.array([1.0, 1.0, core_radius / (n * layers[0][1]), core_radius / (n * layers[0][1])])
    inner = core_radius
    for place, (thickness, modulus) in enumerate(layers):
        own, outer = slice(4 * place, 4 * place + 4), inner + thickness
        below, above = (unit[:, None] * _solutions(n, modulus, r, inner, outer) for r in (inner, outer))
        if place == 0:
            system[:2, own] = below[:2]
        else:
            system[4 * place - 2 : 4 * place + 2, own] = -below
        if place < len(layers) - 1:
            system[4 * place + 2 : 4 * place + 6, own] = above
        else:
            system[-2:, own] = above[2:]
        inner = outer
    right[-2] = unit[2]
    scale = np.abs(system).max(axis=0)
    return above[0] @ (np.linalg.solve(system / scale, right) / scale)[own]


def _solutions(n, modulus, r, inner, outer):
    """Return u_r, u_theta, s_rr and s_rtheta (by P_n, and its derivative) of the four solutions, one per column."""
    columns = []
    for m, reference in ((n, outer), (-n - 1, inner)):
        power = (r / reference) ** m
        columns.append(
            np.array([m / r, 1.0 / r, 2.0 * modulus * m * (m - 1) / r**2, 2.0 * modulus * (m - 1) / r**2]) * power
        )
        radial, along = m / (2.0 * (2 * m + 3)), (m + 3) / (2.0 * (m + 1) * (2 * m + 3))
        fields = [radial * r / modulus, along * r / modulus, 2.0 * (m + 1) * radial - 1.0, m * along + radial]
        columns.append(np.array(fields) * power * modulus / outer)
    return np.array(columns).T


def main(*rings: int) -> None:
    """Print depths of 20 mm with 1 mm of 3 MPa, and with its inner half replaced by 1 MPa, under 100 N."""
    for count in rings or (50, 100):
        for layers in ([(1e-3, 3e6)], [(5e-4, 1e6), (5e-4, 3e6)]):
            print(
                f"{count} rings, {layers}: {1e3 * pressed_depth(20e-3, layers, 100.0, rings=count):.5f} mm", flush=True
            )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
