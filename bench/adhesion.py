"""Adhesion of a ball on a mat: error of the table in docs/theory/adhesion.md, and cost beside a solve without adhesion.

    python bench/adhesion.py table    # cohesive length of 0.05, 0.025 and 0.0125 half-widths, extrapolated to 0
    python bench/adhesion.py cost     # processor time with and without adhesion, at 121 000 nodes in contact

A cubic law with the cohesive length l_c has elastic zones 2.5 l_c long, which 12.5 spacings resolve. Increases of the
torque belong to the dissipated power, relative to the torque without adhesion on the same mesh. The error of the
extrapolated increase is its difference from that of the finest mesh.
"""

from __future__ import annotations

import argparse
import math
import statistics
import time

import numpy as np
import viscoroll as vr

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
MAT = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
BALL = vr.CoatedSphere(core_radius=21e-3)
CLEAN = vr.Adhesion(work=0.05)

#: Load [N] and angular speed [rad/s] of the rows of the table.
ROWS = ((1.0, 2.5), (0.1, 2.5), (1.0, 0.05), (0.1, 0.5), (0.1, 0.05), (0.1, 0.005))

#: Length of the cohesive zone on a mesh per cohesive length, and per spacing.
ZONE, SPACINGS = 2.495, 12.5


def increase(load: float, angular_speed: float, mesh: vr.Mesh) -> tuple[float, float]:
    """Return the relative increase of the torque on a mesh, and the error of the power balance."""
    case = {"on": MAT, "load": load, "angular_speed": angular_speed, "mesh": mesh}
    bare, found = vr.solve(BALL, **case), vr.solve(BALL, **case, adhesion=CLEAN)
    return found.rolling_resistance_torque / bare.rolling_resistance_torque - 1.0, found.energy_balance_error


def table() -> None:
    """Print the increase of the torque of every row on three meshes, its extrapolation, and the answer at 1 %."""
    print("load, speed: increase at l_c/a = 0.05, 0.025, 0.0125; extrapolated; default accuracy; power balance")
    for load, angular_speed in ROWS:
        case = {"on": MAT, "load": load, "angular_speed": angular_speed}
        bare, found = vr.solve(BALL, **case), vr.solve(BALL, **case, adhesion=CLEAN)
        answer = found.rolling_resistance_torque / bare.rolling_resistance_torque - 1.0
        nodes = 2.0 * math.pi * BALL.core_radius * SPACINGS / (0.05 * ZONE * 0.5 * found.contact_length)
        steps, error = [], math.nan
        for k in (1, 2, 4):
            try:
                step, error = increase(load, angular_speed, vr.Mesh(nodes_per_revolution=round(nodes * k)))
            except vr.ConvergenceError:
                if k < 4:
                    raise
                break  # the slowest row has no state on the finest mesh
            steps.append(step)
        # Errors of the zone are of the first to second order.
        change = np.diff(steps)
        ratio = float(np.clip(change[0] / change[1], 2.0, 4.0)) if change.size == 2 else 2.0
        limit = steps[-1] + change[-1] / (ratio - 1.0)
        print(
            f"{load:g} N, {angular_speed:g} rad/s: {', '.join(f'{step:.2%}' for step in steps)}; "
            f"{limit:.2%} +- {abs(limit - steps[-1]):.2%}; {answer:.2%}; {error:.1e}",
            flush=True,
        )


def cost(runs: int = 5) -> None:
    """Print the ratio of processor times of alternating solves with and without adhesion."""
    case = {"on": MAT, "load": 1.0, "angular_speed": 2.5, "mesh": vr.Mesh(nodes_per_revolution=31_000), "threads": 1}
    ratios = []
    for run in range(runs + 1):  # the first run warms up
        seconds = []
        for adhesion in (None, CLEAN):
            start = time.process_time()
            found = vr.solve(BALL, **case, adhesion=adhesion)
            seconds.append(time.process_time() - start)
        if run > 0:
            ratios.append(seconds[1] / seconds[0])
        print(f"{seconds[0]:.3f} s, {seconds[1]:.3f} s, {int(found.contact.sum())} nodes", flush=True)
    print(f"ratio {statistics.median(ratios):.2f} [{min(ratios):.2f}, {max(ratios):.2f}]")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["table", "cost"])
    {"table": table, "cost": cost}[parser.parse_args().what]()
