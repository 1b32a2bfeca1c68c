"""Example of the paper in plain NumPy or by viscoroll: python bench/plain_numpy.py plain|viscoroll [--runs N].

The case is that of section 14 of the paper at its own resolution, pi/250 with N_t = 500, with the radial compliance.
The plain program follows the paper as written: product (32) over 50 radial sub-intervals for every order, the sum over
all orders, and the contact condition (50). The script prints CPU seconds and the error of the torque as JSON.
"""

from __future__ import annotations

import os

os.environ["OMP_NUM_THREADS"] = "1"
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse
import json
import time

import numpy as np
import viscoroll as vr
from viscoroll import enums, paper
from viscoroll.reproduce import plain

NODES_PER_REVOLUTION = 500
MAX_ORDER = 500
SUB_INTERVALS = 50
HALF_WINDOW = 20
LOAD = 100.0
ANGULAR_SPEED = 2.5

#: Resisting torque of an independent computation, docs/theory/reference-values.md [N m].
TORQUE = 11.348e-3


def radial_compliance() -> np.ndarray:
    """Return C_RR for the orders m, n = 0 ... N_t, computed row by row in m."""
    layer = plain.Layer(20e-3, 21e-3, lambda omega: plain.prony(6e6, [0.5], [0.125], omega), 0.5, 1000.0)
    n = np.arange(MAX_ORDER + 1)
    rows = [
        plain.product_compliance([layer], ANGULAR_SPEED, np.full_like(n, m), n, SUB_INTERVALS)[:, 0, 0]
        for m in range(MAX_ORDER + 1)
    ]
    return np.array(rows)


def solve_plainly() -> float:
    """Return the resisting torque of the plain program [N m]."""
    radius, spacing = paper.ball().outer_radius, 2.0 * np.pi / NODES_PER_REVOLUTION
    orders = np.arange(MAX_ORDER + 1)
    both_signs = np.where(orders == 0, 1.0, 2.0)
    patch = np.sinc(orders * spacing / (2.0 * np.pi)) * both_signs / (2.0 * np.pi * radius)
    summands = patch[:, None] * radial_compliance() * patch
    lags = np.arange(-2 * HALF_WINDOW, 2 * HALF_WINDOW + 1) * spacing
    table = (np.exp(1j * np.outer(lags, orders)) @ summands @ np.cos(np.outer(orders, lags))).real

    steps = np.arange(-HALF_WINDOW, HALF_WINDOW + 1)
    i, k = (index.ravel() for index in np.meshgrid(steps, steps, indexing="ij"))
    matrix = table[i[:, None] - i + 2 * HALF_WINDOW, k[:, None] - k + 2 * HALF_WINDOW]
    x = -radius * np.cos(k * spacing) * np.sin(i * spacing)
    depth = radius * np.cos(k * spacing) * np.cos(i * spacing)
    force, _ = plain.solve_normal_contact(matrix, depth, LOAD)
    return float(-(x * force).sum())


def solve_by_viscoroll() -> float:
    """Return the resisting torque of viscoroll on one thread [N m]."""
    mesh = vr.Mesh(nodes_per_revolution=NODES_PER_REVOLUTION, max_order=MAX_ORDER)
    result = vr.solve(
        paper.ball(),
        load=LOAD,
        angular_speed=ANGULAR_SPEED,
        mesh=mesh,
        compliance=enums.Compliance.RADIAL,
        curvature=enums.Curvature.PAPER,
        threads=1,
    )
    return result.resisting_torque


def main() -> None:
    """Run one of the programs and print times and error."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("solver", choices=("plain", "viscoroll"))
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()
    solve = solve_plainly if options.solver == "plain" else solve_by_viscoroll
    seconds = []
    for _ in range(options.runs):
        start = time.process_time()
        torque = solve()
        seconds.append(time.process_time() - start)
    print(json.dumps({"seconds": seconds, "error": torque / TORQUE - 1.0, "details": {}}))


if __name__ == "__main__":
    main()
