"""Friction over a regular grid, without an initial guess on any mesh: ``python -m tests.campaign.friction_grid``.

The paper's ball and rubber roll without a force on the center, with 324 combinations of coating, speed and coefficient
on five meshes each. A case fails if no state of stick and slip is found, or if the residual exceeds 1e-10 of the load.
"""

from __future__ import annotations

import argparse
import itertools
import sys
import warnings
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass

import numpy as np
import viscoroll as vr
from viscoroll import paper

FRICTIONS = np.geomspace(1e-3, 4.0, 9)
SPEEDS = np.geomspace(0.05, 5.0, 4)
THICKNESSES = (0.5e-3, 1e-3, 5e-3)
POISSON_RATIOS = (0.3, 0.45, 0.5)
MESHES = (80, 100, 150, 200, 250)

RUBBER = paper.ball().layers[0].shear_modulus


@dataclass(frozen=True)
class Cell:
    """A case of the grid."""

    friction: float
    angular_speed: float
    thickness: float
    poisson_ratio: float
    nodes: int

    def solve(self) -> vr.Result:
        """Solve the case with one thread."""
        layer = vr.Layer(thickness=self.thickness, shear_modulus=RUBBER, poisson_ratio=self.poisson_ratio)
        return vr.solve(
            vr.CoatedSphere(core_radius=20e-3, layers=[layer]),
            load=paper.LOAD,
            angular_speed=self.angular_speed,
            friction=self.friction,
            mesh=vr.Mesh(nodes_per_revolution=self.nodes),
            threads=1,
        )


def outcome(cell: Cell) -> tuple[int, float, str]:
    """Return iterations, the residual, and a description of a failure."""
    warnings.simplefilter("ignore", vr.ResultWarning)  # coarse meshes
    try:
        r = cell.solve()
    except (ValueError, RuntimeError) as error:
        return 0, np.nan, str(error)
    complaint = "" if r.residual < 1e-10 else f"residual {r.residual:.1e}"
    return r.iterations, r.residual, complaint


def main() -> int:
    """Solve the grid and summarize."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.friction_grid", description=__doc__)
    parser.add_argument("--jobs", type=int, default=1, help="number of processes")
    jobs = parser.parse_args().jobs
    cells = [Cell(*values) for values in itertools.product(FRICTIONS, SPEEDS, THICKNESSES, POISSON_RATIOS, MESHES)]
    with ProcessPoolExecutor(jobs) as pool:
        done = list(pool.map(outcome, cells, chunksize=20))
    failed = 0
    for cell, (_, _, complaint) in zip(cells, done, strict=True):
        if complaint:
            failed += 1
            print(f"{cell}: {complaint}")
    iterations = [count for count, _, _ in done]
    print(
        f"{len(cells)} cases, {failed} failed; iterations: mean {np.mean(iterations):.1f}, largest {max(iterations)}; "
        f"largest residual {np.nanmax([residual for _, residual, _ in done]):.1e}"
    )
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
