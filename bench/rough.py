"""Elastic contact of a rough surface solved by viscoroll and by Tamaas in the same run: python bench/rough.py NODES.

The surface is self-affine and periodic, with eight nodes in its shortest wave, and presses on an incompressible
half-space. Both programs solve the same discrete problem, so that the same nodes must be in contact. The program prints
CPU seconds on one thread, the number of nodes that are in contact in one of the two solutions only, and the largest
difference of the pressures relative to the largest pressure, as JSON.
"""

from __future__ import annotations

import os

# libgomp and the BLAS read these variables when they are loaded: set them before any import that may load either.
os.environ["OMP_NUM_THREADS"] = "1"
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse
import json
import time

import numpy as np
import tamaas
import viscoroll as vr

SIDE = 1.0
SHEAR_MODULUS = 1.0
POISSON_RATIO = 0.5
CONTACT_MODULUS = 2.0 * SHEAR_MODULUS / (1.0 - POISSON_RATIO)

#: Mean pressure per contact modulus and rms slope, for about 4.5 % of the nodes in contact.
REDUCED_PRESSURE = 0.017

#: Tolerance of both programs, each relative to its own scale: both solutions are converged far below the error of the
#: mesh, and halving the tolerance of Tamaas changes its contact by no node at 256 nodes.
TOLERANCE = 1e-9


def main() -> None:
    """Solve with both programs and print the comparison."""
    parser = argparse.ArgumentParser(description=__doc__.partition(":")[0])
    parser.add_argument("nodes", type=int)
    nodes = parser.parse_args().nodes
    surface = vr.RoughSurface.self_affine(
        nodes, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=8.0 * SIDE / nodes, rms_slope=0.1, seed=1
    )
    pressure = REDUCED_PRESSURE * CONTACT_MODULUS * surface.rms_slope
    half_space = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=SHEAR_MODULUS), poisson_ratio=POISSON_RATIO)

    start = time.process_time()
    ours = vr.slide(surface, on=half_space, pressure=pressure, speed=0.0, tolerance=TOLERANCE, threads=1)
    between = time.process_time()
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [SIDE, SIDE], [nodes, nodes])
    model.E = 2.0 * (1.0 + POISSON_RATIO) * SHEAR_MODULUS
    model.nu = POISSON_RATIO
    solver = tamaas.PolonskyKeerRey(model, surface.heights.copy(), TOLERANCE)
    solver.max_iter = 10_000
    solver.solve(pressure)
    end = time.process_time()

    theirs = np.asarray(model.traction).reshape(nodes, nodes)
    numbers = {
        "nodes": nodes,
        "contact_share": ours.contact_share,
        "viscoroll_seconds": between - start,
        "tamaas_seconds": end - between,
        "ratio": (end - between) / (between - start),
        "different_nodes": int(np.count_nonzero((theirs > 0.0) != ours.contact)),
        "pressure_difference": float(np.abs(theirs - ours.pressure).max() / ours.max_pressure),
        "tamaas": tamaas.__version__,
    }
    print(json.dumps(numbers, indent=2))


if __name__ == "__main__":
    main()
