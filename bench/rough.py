"""Contact of a rough surface solved by viscoroll, and by Tamaas in the same run if the surface is at rest.

The surface is self-affine and periodic, with eight nodes in its shortest wave, and presses on an incompressible
half-space. At rest the half-space is elastic, and both programs solve the same discrete problem, so that the same nodes
must be in contact. The program prints the number of nodes that are in contact in one of the two solutions only, and the
largest difference of the pressures relative to the largest pressure. A sliding surface meets rubber with memory, which
Tamaas does not solve; its error is the difference of the friction coefficients from power and tractions, relative to
the friction. Times are CPU seconds on one thread:

    python bench/rough.py 1024                 # at rest, with Tamaas
    python bench/rough.py 1024 --speed 1e-3    # sliding
"""

from __future__ import annotations

import os

# libgomp and the BLAS read these variables when they are loaded: set them before any import that may load either.
os.environ["OMP_NUM_THREADS"] = "1"
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse
import json
import resource
import statistics
import time
from typing import Any

import numpy as np
import viscoroll as vr

SHEAR_MODULUS = 1e6
POISSON_RATIO = 0.5
CONTACT_MODULUS = 2.0 * SHEAR_MODULUS / (1.0 - POISSON_RATIO)

#: Side of the surface [m].
SIDE = 1e-3

#: Mean pressure per contact modulus and rms slope, for about 4.5 % of the nodes in contact at rest, and at 1 mm/s.
REDUCED_PRESSURE = 0.017
REDUCED_SLIDING_PRESSURE = 0.15

#: Tolerance of both programs, each relative to its own scale: both solutions are converged far below the error of the
#: mesh, and halving the tolerance of Tamaas changes its contact by no node at 256 nodes.
TOLERANCE = 1e-9


def main() -> None:
    """Solve, and print times and the comparison."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("nodes", type=int)
    parser.add_argument(
        "--speed", type=float, default=0.0, help="sliding speed [m/s]; rubber has 10 MPa / 1 MPa, 10 ms"
    )
    parser.add_argument("--runs", type=int, default=1, help="number of repetitions")
    options = parser.parse_args()
    nodes, speed = options.nodes, options.speed
    surface = vr.RoughSurface.self_affine(
        nodes, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=8.0 * SIDE / nodes, rms_slope=0.1, seed=1
    )
    reduced = REDUCED_PRESSURE if speed == 0.0 else REDUCED_SLIDING_PRESSURE
    pressure = reduced * CONTACT_MODULUS * surface.rms_slope
    rubber = vr.StandardLinearSolid(
        instantaneous_modulus=10.0 * SHEAR_MODULUS, relaxed_modulus=SHEAR_MODULUS, relaxation_time=0.01
    )
    half_space = vr.HalfSpace(
        shear_modulus=rubber if speed > 0.0 else vr.Elastic(modulus=SHEAR_MODULUS), poisson_ratio=POISSON_RATIO
    )

    seconds = []
    for _ in range(options.runs):
        start = time.process_time()
        ours = vr.slide(surface, on=half_space, pressure=pressure, speed=speed, tolerance=TOLERANCE, threads=1)
        seconds.append(time.process_time() - start)
    details = {
        "contact_share": f"{ours.contact_share:.4f}",
        "friction_coefficient": f"{ours.friction_coefficient:.6f}",
        "iterations": ours.iterations,
        "operator_applications": ours.operator_applications,
        "gigabytes": f"{resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20:.2f}",
    }
    if speed == 0.0:
        differences = compared(ours, pressure, statistics.median(seconds))
        error = differences["pressure_difference"]
        details |= differences
    else:
        error = ours.friction_error / ours.friction_coefficient
    print(json.dumps({"seconds": seconds, "error": error, "details": details}, indent=2))


def compared(ours: vr.SlidingResult, pressure: float, seconds: float) -> dict[str, Any]:
    """Solve the same contact with Tamaas, and return its time and the differences."""
    import tamaas

    heights = ours.surface.heights
    start = time.process_time()
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [SIDE, SIDE], list(heights.shape))
    model.E = 2.0 * (1.0 + POISSON_RATIO) * SHEAR_MODULUS
    model.nu = POISSON_RATIO
    solver = tamaas.PolonskyKeerRey(model, heights.copy(), TOLERANCE)
    solver.max_iter = 10_000
    solver.solve(pressure)
    tamaas_seconds = time.process_time() - start
    theirs = np.asarray(model.traction).reshape(heights.shape)
    return {
        "tamaas_seconds": tamaas_seconds,
        "ratio": tamaas_seconds / seconds,
        "different_nodes": int(np.count_nonzero((theirs > 0.0) != ours.contact)),
        "pressure_difference": float(np.abs(theirs - ours.pressure).max() / ours.max_pressure),
        "tamaas": tamaas.__version__,
    }


if __name__ == "__main__":
    main()
