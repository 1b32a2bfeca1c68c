"""Axisymmetric contact of a ball with incompressible layers on a rigid plane.

Run it with `python -m tests.reference.pressed_ball [rings]`. The displacements in each layer are the zonal harmonics of
Lamb's solutions (Love, Treatise, 4th edition, section 172), and the core is rigid. The pressure is constant on each of
several rings. The rings are narrower towards the edge of the contact, where the pressure decreases to zero.
"""

from __future__ import annotations

import sys

import numpy as np
from scipy.optimize import brentq

#: Number of orders for which the layers are solved. At higher orders the outermost layer acts as a half-space with a
#: correction for curvature.
SOLVED = 5000


def penetration(core_radius, layers, load, rings=100, orders=10000):
    """Return the penetration [m] at a load [N]; layers are (thickness [m], modulus [Pa]) from the core outwards."""
    radius = core_radius + sum(thickness for thickness, _ in layers)
    compliance = np.array([_compliance(n, core_radius, layers) for n in range(1, SOLVED + 1)])
    high = np.arange(SOLVED + 1, orders + 1)
    half_space = radius / (2.0 * layers[-1][1])
    curvature = (compliance[-1] * SOLVED / half_space - 1.0) * SOLVED
    compliance = np.append(compliance, half_space / high * (1.0 + curvature / high))

    def solution(edge):
        """Return the pressure on each ring [Pa], and the penetration [m], for a contact up to an angle [rad]."""
        bound = edge * np.sin(np.linspace(0.0, 0.5 * np.pi, rings + 1))
        middle = 0.5 * (bound[1:] + bound[:-1])
        system = np.zeros((rings + 1, rings + 1))
        system[:-1, :-1] = _influence(compliance, np.cos(bound), np.cos(middle))
        system[:-1, -1] = -1.0
        system[-1, :-1] = 2.0 * np.pi * radius**2 * -np.diff(np.cos(bound))
        return np.linalg.solve(system, [*(-radius * (1.0 - np.cos(middle))), load])

    def edge_pressure(edge):
        pressure = solution(edge)
        return pressure[rings - 1] / pressure[0]

    return solution(brentq(edge_pressure, 0.12, 0.2, xtol=1e-6))[-1]


def _influence(compliance, bound, middle):
    """Return the displacements at the middles of the rings due to unit pressures on the rings.

    `bound` and `middle` are cosines of the polar angle. The Legendre polynomials follow from their recursion.
    """
    before, here, before_middle, here_middle = np.ones_like(bound), bound, np.ones_like(middle), middle
    influence = np.zeros((middle.size, middle.size))
    for n, value in enumerate(compliance, start=1):
        after = ((2 * n + 1) * bound * here - n * before) / (n + 1)
        influence += np.outer(value * here_middle, -0.5 * np.diff(after - before))
        before, here = here, after
        after_middle = ((2 * n + 1) * middle * here_middle - n * before_middle) / (n + 1)
        before_middle, here_middle = here_middle, after_middle
    return influence


def _compliance(n, core_radius, layers):
    """Return the radial surface displacement P_n per pressure P_n [m/Pa]."""
    size = 4 * len(layers)
    system, right = np.zeros((size, size)), np.zeros(size)
    unit = np.array([1.0, 1.0, core_radius / (n * layers[0][1]), core_radius / (n * layers[0][1])])
    inner = core_radius
    for number, (thickness, modulus) in enumerate(layers):
        own, outer = slice(4 * number, 4 * number + 4), inner + thickness
        below, above = (unit[:, None] * _solutions(n, modulus, r, inner, outer) for r in (inner, outer))
        if number == 0:
            system[:2, own] = below[:2]
        else:
            system[4 * number - 2 : 4 * number + 2, own] = -below
        if number < len(layers) - 1:
            system[4 * number + 2 : 4 * number + 6, own] = above
        else:
            system[-2:, own] = above[2:]
        inner = outer
    right[-2] = unit[2]
    scale = np.abs(system).max(axis=0)
    return above[0] @ (np.linalg.solve(system / scale, right) / scale)[own]


def _solutions(n, modulus, r, inner, outer):
    """Return the factors of u_r, u_theta, s_rr and s_rtheta in each of the four solutions, one per column.

    u_r and s_rr are proportional to P_n, u_theta and s_rtheta to its derivative.
    """
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
    """Print the penetration at 100 N of a core of 20 mm radius with one layer and with two layers."""
    for count in rings or (50, 100):
        for layers in ([(1e-3, 3e6)], [(5e-4, 1e6), (5e-4, 3e6)]):
            print(f"{count} rings, {layers}: {1e3 * penetration(20e-3, layers, 100.0, rings=count):.5f} mm", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
