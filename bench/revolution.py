"""One revolution of transient rolling from Python: python bench/revolution.py roll|advance NODES [--runs N].

The history uses a single mesh (`averaged_meshes=1`) and one thread, and the time excludes its tables, as in the cases
`revolution/..._one_lattice` of bench_solve. `roll` follows the motion in one call; `advance` calls
`RollingHistory.advance` for each step, as an equation of motion does. The script prints CPU seconds, the error of the
torque averaged over the last spacing, and milliseconds per step as JSON.
"""

from __future__ import annotations

import argparse
import copy
import json
import statistics
import time

import numpy as np
import viscoroll as vr
from viscoroll import enums, paper

ANGULAR_SPEED = 2.5
LOAD = 100.0
STEPS_PER_SPACING = 4

#: Resisting torque of the steady state, on meshes of π/6600 and finer [N m].
TORQUE = 11.3867e-3


def by_roll(stepper: vr.RollingHistory, turn: float) -> list[float]:
    """Return the torques of the last steps of a motion that is followed in one call."""
    waypoints = {
        "time": [0.0, turn / ANGULAR_SPEED],
        "angle": [0.0, turn],
        "load": [LOAD, LOAD],
        "center_displacement": [],
        "axle_height": [],
    }
    instants = stepper._history.roll(**waypoints, progress=None)
    return instants.resisting_torque[-STEPS_PER_SPACING:].tolist()


def by_advance(stepper: vr.RollingHistory, turn: float) -> list[float]:
    """Return the torques of the last steps of a motion with one call per step."""
    count = stepper.mesh.nodes_per_revolution * STEPS_PER_SPACING
    angles = np.linspace(0.0, turn, count + 1)[1:].tolist()
    torques = [stepper.advance(time=a / ANGULAR_SPEED, angle=a, load=LOAD).resisting_torque for a in angles]
    return torques[-STEPS_PER_SPACING:]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("call", choices=("roll", "advance"))
    parser.add_argument("nodes", type=int)
    parser.add_argument("--runs", type=int, default=5)
    options = parser.parse_args()

    follow = {"roll": by_roll, "advance": by_advance}[options.call]
    undeformed = vr.RollingHistory(
        paper.ball(),
        load=LOAD,
        start=enums.Start.UNDEFORMED,
        mesh=vr.Mesh(nodes_per_revolution=options.nodes),
        averaged_meshes=1,
        steps_per_spacing=STEPS_PER_SPACING,
        threads=1,
    )
    seconds = []
    for _ in range(options.runs + 1):
        stepper = copy.copy(undeformed)
        begin = time.process_time()
        torques = follow(stepper, 2.0 * np.pi)
        seconds.append(time.process_time() - begin)
    details = {"steps": stepper.steps, "ms_per_step": f"{1e3 * statistics.median(seconds[1:]) / stepper.steps:.3f}"}
    error = float(np.mean(torques)) / TORQUE - 1.0
    print(json.dumps({"seconds": seconds[1:], "error": error, "details": details}))


if __name__ == "__main__":
    main()
