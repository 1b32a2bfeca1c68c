"""Rolling over a bump, with a given load or an axle: python bench/ground.py flat|bump|axle NODES [--runs N].

The roller and the bump are those of docs/theory/ground.md ("Evidence"). The history uses a single mesh and one thread,
and the time excludes its tables. The script prints CPU seconds, the error of the dissipated energy, and milliseconds
per step as JSON.
"""

from __future__ import annotations

import argparse
import copy
import json
import statistics
import time
from typing import Any

import viscoroll as vr
from viscoroll.ground import Axle, Profile

LOAD = 5e3
DISTANCE = 80e-3
BUMP = Profile.half_sine(1e-3, length=20e-3, at=40e-3)

#: Options and speed [m/s] of each case, and the energy that it dissipates [J/m]: the mean of `tests.reference.ground`
#: over four meshes of 1000 nodes.
CASES: dict[str, tuple[dict[str, Any], float, float]] = {
    "flat": ({}, 60e-3, 3.4041),
    "bump": ({"ground": BUMP}, 60e-3, 3.4497),
    "axle": ({"ground": BUMP, "axle": Axle(mass=500.0)}, 0.3, 1.0366),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("case", choices=CASES)
    parser.add_argument("nodes", type=int)
    parser.add_argument("--runs", type=int, default=5)
    given = parser.parse_args()

    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = vr.Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.5)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    options, speed, dissipated = CASES[given.case]
    still = vr.RollingHistory(
        roller, load=LOAD, mesh=vr.Mesh(nodes_per_revolution=given.nodes), averaged_meshes=1, threads=1, **options
    )
    end = {"time": DISTANCE / speed, "distance": DISTANCE, "load": LOAD}
    seconds = []
    for _ in range(given.runs + 1):
        stepper = copy.copy(still)
        begin = time.process_time()
        last = stepper.advance(**end)
        seconds.append(time.process_time() - begin)
    details = {"steps": stepper.steps, "ms_per_step": f"{1e3 * statistics.median(seconds[1:]) / stepper.steps:.3f}"}
    error = last.dissipated_energy / dissipated - 1.0
    print(json.dumps({"seconds": seconds[1:], "error": error, "details": details}))


if __name__ == "__main__":
    main()
