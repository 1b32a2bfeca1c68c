"""Elastic Hertz contact solved by viscoroll, Tamaas or ASPHER: python bench/hertz.py SOLVER NODES [--runs N].

The body is elastic and incompressible, and so large that it is a half-space. The contact is half as wide as a window of
NODES by NODES. Tamaas and ASPHER press a rigid paraboloid on a half-space that is free outside the window. Their
operators, for patches of uniform pressure after Love, differ by 1e-12 of the largest displacement. viscoroll presses a
solid ball on a plane, with a contact so small that the ball is a paraboloid there, and chooses its own window. The
program prints CPU seconds and errors as JSON.
"""

from __future__ import annotations

import os

# libgomp and the BLAS read these variables when they are loaded: set them before any import that may load either.
os.environ["OMP_NUM_THREADS"] = "1"
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse
import dataclasses
import json
import math
import statistics
import time
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

SHEAR_MODULUS = 1.0
POISSON_RATIO = 0.5
RADIUS = 8.0
WINDOW = 4.0

CONTACT_RADIUS = WINDOW / 4
YOUNG_MODULUS = 2 * (1 + POISSON_RATIO) * SHEAR_MODULUS
CONTACT_MODULUS = YOUNG_MODULUS / (1 - POISSON_RATIO**2)
APPROACH = CONTACT_RADIUS**2 / RADIUS
LOAD = 4 / 3 * CONTACT_MODULUS * CONTACT_RADIUS**3 / RADIUS

# Upper bound of sum p (g - min g) / (sum p APPROACH), where g is the displacement plus the undeformed gap. The sum is
# zero if and only if pressure acts only where the gap is closed. Tamaas and ASPHER stop on
# sum p (g - min g) / (sum p scale). The scale is the standard deviation of the surface in Tamaas (0.84 APPROACH) and
# its range in ASPHER (4 APPROACH), so each gets the tolerance TOLERANCE APPROACH / scale. Recomputed from the pressures
# with Love's coefficients, for 128 to 1024 nodes: 3e-9 to 1.4e-8. viscoroll ends with every gap and overclosure of a
# node below 1e-8 APPROACH, mostly far below.
TOLERANCE = 1e-8

#: Nodes per revolution of the ball: a contact of 512 nodes is then 1/600 of the radius wide.
NODES_PER_REVOLUTION = 1_000_000


@dataclasses.dataclass(frozen=True)
class Run:
    """Cost of a solve and its errors relative to the solution of Hertz.

    Parameters
    ----------
    cpu_seconds : float
        CPU time of the solve [s], without the preparation of tables, FFT plans and buffers of the operator.
    operator_applications : int
        Number of products with the compliance operator.
    max_pressure, mean_pressure, contact_radius : float
        Relative errors [-]. The latter two depend on the contact area, which is that of the nodes under pressure.
    table_seconds : float
        CPU time for the influence table [s].
    """

    cpu_seconds: float
    operator_applications: int
    max_pressure: float
    mean_pressure: float
    contact_radius: float
    table_seconds: float


def undeformed_gap(nodes: int) -> NDArray[np.float64]:
    """Return the gap before deformation, with the apex on a node."""
    squared = ((np.arange(nodes) - nodes // 2) * (WINDOW / nodes)) ** 2
    return (squared[:, np.newaxis] + squared) / (2 * RADIUS)


def compared(
    cpu_seconds: float,
    operator_applications: int,
    pressure: NDArray[np.float64],
    patch: float,
    radius: float,
    table: float,
) -> Run:
    """Return the cost and the errors of `pressure` on patches of area `patch`; Hertz's contact has `radius`."""
    area = int(np.count_nonzero(pressure)) * patch
    load = float(pressure.sum()) * patch
    mean = load / (math.pi * radius**2)
    return Run(
        cpu_seconds,
        operator_applications,
        max_pressure=float(pressure.max()) / (1.5 * mean) - 1,
        mean_pressure=load / area / mean - 1,
        contact_radius=math.sqrt(area / math.pi) / radius - 1,
        table_seconds=table,
    )


def viscoroll(nodes: int) -> Run:
    """Solve with viscoroll."""
    import viscoroll as vr
    from viscoroll import enums

    layer = vr.Layer(thickness=RADIUS, shear_modulus=vr.Elastic(modulus=SHEAR_MODULUS), poisson_ratio=POISSON_RATIO)
    ball = vr.CoatedSphere(core_radius=0.0, layers=[layer], inner_boundary=enums.InnerBoundary.SOLID)
    mesh = vr.Mesh(nodes_per_revolution=NODES_PER_REVOLUTION)
    spacing = RADIUS * mesh.spacing
    radius = nodes / 4 * spacing
    load = 4 / 3 * CONTACT_MODULUS * radius**3 / RADIUS

    start = time.process_time()
    model = vr.RollingModel(ball, angular_speed=1.0, mesh=mesh, threads=1)
    model.solve(load=load, compliance=enums.Compliance.RADIAL, threads=1)
    both = time.process_time() - start
    start = time.process_time()
    result = model.solve(load=load, compliance=enums.Compliance.RADIAL, threads=1)
    seconds = time.process_time() - start
    return compared(seconds, result.operator_applications, result.pressure, spacing**2, radius, both - seconds)


def tamaas(nodes: int) -> Run:
    """Solve with Tamaas: Polonsky-Keer-Rey with the non-periodic operator."""
    import tamaas as tm

    class Counter(tm.Functional):  # type: ignore[misc]
        """Count evaluations of the gradient: Tamaas does not report its iterations."""

        evaluations = 0

        def computeF(self, _pressure: Any, _gap: Any) -> float:  # noqa: N802
            return 0.0

        def computeGradF(self, _pressure: Any, _gradient: Any) -> None:  # noqa: N802
            self.evaluations += 1

    tm.set_log_level(tm.LogLevel.warning)
    surface = -undeformed_gap(nodes)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [WINDOW, WINDOW], [nodes, nodes])
    # Set the moduli before the operator: if they are set later, it silently keeps wrong coefficients.
    model.E, model.nu = YOUNG_MODULUS, POISSON_RATIO
    start = time.process_time()
    tm.ModelFactory.registerNonPeriodic(model, "dcfft")
    scale = APPROACH / float(surface.std(ddof=1))
    solver = tm.PolonskyKeerRey(model, surface, TOLERANCE * scale)
    solver.setIntegralOperator("dcfft")  # without this, Tamaas silently solves the periodic problem
    solver.max_iter = 10_000
    counter = Counter()
    solver.addFunctionalTerm(counter)
    model.operators["dcfft"](np.zeros_like(surface), np.empty_like(surface))
    table = time.process_time() - start

    start = time.process_time()
    error = solver.solve(LOAD / WINDOW**2)
    seconds = time.process_time() - start
    if not error <= solver.tolerance:
        raise RuntimeError(f"Tamaas: error {error:g} after {counter.evaluations} evaluations")
    pressure = np.array(model.traction)
    # Two products per iteration, and one evaluation after the last iteration.
    return compared(seconds, 2 * counter.evaluations, pressure, (WINDOW / nodes) ** 2, CONTACT_RADIUS, table)


def aspher(nodes: int) -> Run:
    """Solve with ASPHER: FFT with the Fourier preconditioner."""
    import aspher as asp

    gap = undeformed_gap(nodes)
    start = time.process_time()
    solver = asp.ContactSolver(grid_size=nodes, domain_size=WINDOW, E_star=CONTACT_MODULUS, backend="fft")
    scale = APPROACH / float(np.ptp(gap))
    solver.matvec(np.zeros(gap.size))
    table = time.process_time() - start

    start = time.process_time()
    # "fourier-fft" applies the symbol |k| by FFT; since 0.1.3, "fourier" truncates it to a stencil and is slower.
    result = solver.solve(gap.ravel(), LOAD / WINDOW**2, tol=TOLERANCE * scale, precond="fourier-fft")
    seconds = time.process_time() - start
    if not result.converged:
        raise RuntimeError(f"ASPHER: {result.status}, error {result.fw_error:g} after {result.iterations} iterations")
    pressure = np.asarray(result.pressure)
    return compared(seconds, 2 * result.iterations, pressure, (WINDOW / nodes) ** 2, CONTACT_RADIUS, table)


def aspher_nested(nodes: int) -> Run:
    """Solve with ASPHER started from coarser meshes, its fastest method; counts products on the finest mesh."""
    import aspher as asp

    gap = undeformed_gap(nodes)
    scale = APPROACH / float(np.ptp(gap))
    problem = {"domain_size": WINDOW, "E_star": CONTACT_MODULUS, "tol": TOLERANCE * scale}

    start = time.process_time()
    result = asp.solve_nested(nodes, gap.ravel(), LOAD / WINDOW**2, backend="fft", precond_engine="fft", **problem)
    table = result.timings["build"]  # the call also builds the operators
    seconds = time.process_time() - start - table
    if not result.converged:
        raise RuntimeError(f"ASPHER: {result.status}, error {result.fw_error:g} after {result.iterations} iterations")
    pressure = np.asarray(result.pressure)
    return compared(seconds, 2 * result.iterations, pressure, (WINDOW / nodes) ** 2, CONTACT_RADIUS, table)


SOLVERS: dict[str, Callable[[int], Run]] = {
    solver.__name__: solver for solver in (viscoroll, tamaas, aspher, aspher_nested)
}


def main() -> None:
    """Run a solver and print times, error and details."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("solver", choices=SOLVERS)
    parser.add_argument("nodes", type=int, help="number of nodes along a side of the window")
    parser.add_argument("--runs", type=int, default=5, help="number of solves after a warm-up")
    options = parser.parse_args()
    solver = SOLVERS[options.solver]
    solver(64)
    runs = [solver(options.nodes) for _ in range(options.runs)]
    last = runs[-1]
    details = {
        "operator_applications": last.operator_applications,
        "table_s": f"{statistics.median(run.table_seconds for run in runs):.3g}",
        "mean_pressure_error": f"{last.mean_pressure:.1e}",
        "contact_radius_error": f"{last.contact_radius:.1e}",
    }
    print(json.dumps({"seconds": [run.cpu_seconds for run in runs], "error": last.max_pressure, "details": details}))


if __name__ == "__main__":
    main()
