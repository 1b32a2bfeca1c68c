"""Rollers in line contact, with the rubber of section 14, incompressible: python -m tests.reference.roller.

Loads, forces and moments are per length.
"""

from __future__ import annotations

import numpy as np

from .one_layer import Table, press, roller_equations, steady

__all__ = ["coating", "half_plane_moment", "steady"]


def half_plane_moment(speed, *, load, radius, nodes):
    """Return M [N] of a rigid cylinder on a half-plane of this rubber, by collocation on uniform strips.

    The solid has the creep compliance J_0 + (J_inf - J_0)(1 - exp(-t/tau_c)). The displacement is an integral of
    Flamant's kernel over the past, by Gauss's rule on panels.
    """
    stiff, soft = 6e6, 3e6
    retarded = speed * 0.125 * stiff / soft
    width = 2.6 * np.sqrt(load * radius / (np.pi * soft)) / nodes
    # Positions of the strips in the direction of the material, which moves backward.
    place = (np.arange(nodes) - nodes / 2 + 0.5) * width
    offset = np.arange(-nodes + 1, nodes) * width

    def elastic(s):
        def integral(t):
            return np.where(t == 0.0, 0.0, t * np.log(np.abs(t) + 1e-300)) - t

        return -(integral(s + width / 2) - integral(s - width / 2)) / (np.pi * width)

    edges = np.append(
        np.arange(0.0, 2.0 * nodes * width, width / 2), np.geomspace(2.001 * nodes * width, 40 * retarded)
    )
    edges = edges[edges <= max(36.0 * retarded, width)]
    points, weights = np.polynomial.legendre.leggauss(6)
    past = 0.5 * (edges[1:, None] + edges[:-1, None]) + 0.5 * np.diff(edges)[:, None] * points
    share = 0.5 * np.diff(edges)[:, None] * weights * np.exp(-past / retarded) / retarded
    faded = sum(w * elastic(offset - y) for y, w in zip(past.ravel(), share.ravel(), strict=True))
    kernel = 0.5 * (elastic(offset) / stiff + (1.0 / soft - 1.0 / stiff) * faded)
    index = np.arange(nodes)
    compliance = kernel[index[:, None] - index[None, :] + nodes - 1]
    gap = place**2 / (2.0 * radius)
    force, _ = press(compliance, gap, load)
    return float(-(place * force).sum())


def coating(nodes):
    """Return the table of a coating of 10 mm of rubber on a core of 50 mm, with `nodes` per revolution."""
    return Table(roller_equations, 50e-3, 60e-3, nodes, 1)


def main() -> None:
    """Print the moments of docs/theory/rollers.md for the coated roller, and for a bare one on a half-plane."""
    table = coating(7000)
    for angular_speed in (0.1, 1.0, 10.0):
        moment, depth = steady(table, angular_speed, 5e3, 130)
        print(f"{angular_speed:4.1f} rad/s: {moment:.5f} N, {1e3 * depth:.5f} mm")
    for speed in (0.005, 0.05, 0.5):
        print(f"half-plane, {speed} m/s: {half_plane_moment(speed, load=5e3, radius=50e-3, nodes=800):.5f} N")


if __name__ == "__main__":
    main()
