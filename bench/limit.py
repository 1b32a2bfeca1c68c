"""Compare the times of five cases with the limits of the machine, phase by phase: python bench/limit.py.

The script writes the table of bench/README.md. The method requires an amount of work in each phase of a case, as
counted below. The lower bound of the time is that of this work at the speed of one core (dense products of NumPy) or at
the memory bandwidth (sums of large arrays), whichever is longer. The table compares it with the measured time of the
phase, from stacks sampled by `perf`.

The work is that of the method, not of the program: transforms of exactly twice the contact size, every number read and
written once. Data in the caches counts no bytes.

The last column is the fraction of a phase that one of two threads runs alone, also from the samples. By Amdahl's law,
this part remains with any number of cores.
"""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from run import PROGRAM, cpu_name, git

PAGE = Path(__file__).with_name("README.md")
PLACE = ("<!-- limit: made by bench/limit.py -->\n", "<!-- end of limit -->")

DOUBLE = 8.0
#: Even and odd terms of a polynomial in one direction that represents a smooth function to thirteen digits.
TERMS = 2 * 24
#: Orders m that are summed, and orders n at which each is sampled, for a window on any mesh.
ORDERS, SAMPLED = 250, 96
#: Sample frequency of the profiler [Hz].
FREQUENCY = 997

#: Phases by functions in a stack; the first match counts. The name of a library stands for all its functions.
PHASES: list[tuple[str, tuple[str, ...]]] = [
    ("page faults", ("asm_exc_page_fault", "do_syscall_64")),
    (
        "tables",
        (
            "OrderSum",
            "Synthesis",
            "ThetaSums",
            "BandWaves",
            "CoatingSum",
            "SelfSimilar",
            "make_model",
            "CreepingTables::CreepingTables",
        ),
    ),
    ("factorizations", ("factor<", "dense_inverse", "bordered_inverse", "SingleFactors", "DenseFactors")),
    ("inverse of the contact", ("ContactInverse::times", "selfadjoint_matrix_vector_product", "KeptInverse")),
    ("stored rows", ("RowMemory",)),
    ("transforms", ("libfftw3", "RealFft", "SpectralProduct", "InverseConvolution")),
    ("products without transforms", ("TableProduct", "normal_compliance", "general_matrix_vector", "MirroredTables")),
    ("products without transforms", ("gebp_kernel", "gemm_pack")),
    ("orthogonalization", ("solve_krylov", "Arnoldi")),
    ("results", ("make_result", "SurfaceWindow", "extended")),
]
REST = "active sets and the rest"


@dataclass(frozen=True)
class Work:
    """Minimum work of a phase."""

    flop: float = 0.0
    bytes: float = 0.0

    def __add__(self, other: Work) -> Work:
        """Return the sum of two works."""
        return Work(self.flop + other.flop, self.bytes + other.bytes)

    def __mul__(self, times: float) -> Work:
        """Return the work of several repetitions."""
        return Work(times * self.flop, times * self.bytes)


def width(contact_nodes: float) -> float:
    """Return the nodes across a round contact."""
    return math.sqrt(4.0 * contact_nodes / math.pi)


def transforms_of_product(b: float, fields: int = 1, tables: int = 1) -> Work:
    """Return the work of a product on b by b nodes: transforms both ways on twice as many nodes in each direction.

    Half of the lines are zero. A line of n real numbers takes 2.5 n log2(n) operations, of complex numbers twice that.
    """
    lines = 2.5 * 2.0 * b * math.log2(2.0 * b) * b
    columns = 5.0 * 2.0 * b * math.log2(2.0 * b) * b
    flop = 2.0 * fields * (lines + columns) + 8.0 * tables * 2.0 * b * b
    between = 4.0 * 2.0 * DOUBLE * b * b  # lines written and read again, in both transforms
    return Work(flop, fields * (2.0 * DOUBLE * b * b + between) + tables * 2.0 * DOUBLE * 2.0 * b * b)


def transforms_of_preconditioner(b: float, fields: int = 1) -> Work:
    """Return the work of a product that is periodic in the contact."""
    flop = fields * (2.0 * 2.5 * b * b * math.log2(b * b)) + 8.0 * fields**2 * 0.5 * b * b
    return Work(flop, fields * (2.0 + 4.0) * DOUBLE * b * b + fields**2 * DOUBLE * b * b)


def orthogonalization(unknowns: float, steps: float) -> Work:
    """Return the work of two passes over all previous directions, each of which is read and subtracted."""
    pairs = 0.5 * steps * (steps + 1.0) * 2.0
    return Work(4.0 * unknowns * pairs, 3.0 * DOUBLE * unknowns * pairs)


def tables(phi_reach: float, theta_reach: float, count: int = 1) -> Work:
    """Return the work for compliances of the orders, their sums in both directions, and writing every entry once.

    A compliance is a series of about two dozen complex terms; the sums multiply real and imaginary parts.
    """
    entries = count * (2.0 * phi_reach + 1.0) * (theta_reach + 1.0)
    compliances = ORDERS * SAMPLED * 4.0 * 24.0
    along_theta = 4.0 * ORDERS * SAMPLED * TERMS
    along_phi = 4.0 * ORDERS * TERMS * (theta_reach + 1.0)
    return Work(count * (compliances + along_theta + along_phi) + 2.0 * TERMS * entries, DOUBLE * entries)


def large_window(counters: Mapping[str, float]) -> dict[str, Work]:
    """Return the work of a frictionless solve that uses the mirror symmetry: one side of the path only."""
    nodes, window = counters["contact_nodes"], counters["window"]
    products, passes = counters["operator_applications"], counters["iterations"]
    b = width(nodes)
    steps = (products - 2.0 * passes - 1.0) / passes
    of_products = transforms_of_product(b) * products + transforms_of_preconditioner(b) * (products - 2.0 * passes)
    return {
        "tables": tables(window - 1.0, window - 1.0) + tables(b, b),
        "transforms": of_products * 0.5,
        "orthogonalization": orthogonalization(0.5 * nodes, steps) * passes,
        "results": Work(0.0, (9.0 * DOUBLE + 3.0) * window**2),
        REST: Work(0.0, 3.0 * DOUBLE * b * b * passes),
    }


def small_solves(counters: Mapping[str, float], solves: int = 2000, models: int = 200) -> dict[str, Work]:
    """Return the work of contacts solved by a matrix, with mirror images as one unknown; all data in the caches."""
    half = 0.5 * counters["contact_nodes"]
    window = 1.2 * width(counters["contact_nodes"])
    every_node = 2.0 * half * window * window  # products that compute all gaps
    return {
        "tables": Work(2.0 * tables(window, window).flop * models),
        "factorizations": Work(2.0 / 3.0 * half**3 * solves),
        "products without transforms": Work(
            2.0 * half * half * (counters["operator_applications"] - counters["iterations"])
            + every_node * counters["iterations"]
        ),
    }


def small_friction(counters: Mapping[str, float]) -> dict[str, Work]:
    """Return the work of a frictional solve with three components; all data in the caches."""
    b = width(counters["contact_nodes"])
    products = counters["operator_applications"]
    return {
        "tables": Work(tables(counters["window"], counters["window"], 12).flop),
        "transforms": Work(
            (transforms_of_product(b, 3, 9).flop + transforms_of_preconditioner(b, 3).flop) * products,
        ),
    }


def instants(counters: Mapping[str, float]) -> dict[str, Work]:
    """Return the work of time steps: inverse of half the contact, and one product with the rows within reach."""
    steps = counters["steps"]
    # Steady contact at 1000 nodes per revolution: 1310 nodes. Its tables extend over half a revolution.
    half, rows, aside, reach = 675.0, 40.0, 21.0, 500.0
    return {
        "inverse of the contact": Work(2.0 * half * half) * steps,
        "products without transforms": Work(2.0 * rows * (2.0 * reach + rows) * aside * aside) * steps,
        "stored rows": Work(0.0, 2.0 * DOUBLE * (2.0 * reach + rows) * aside * 2.0) * steps,
    }


@dataclass(frozen=True)
class Case:
    """A benchmark, and its minimum work as a function of its counters."""

    name: str
    title: str
    work: Callable[[Mapping[str, float]], dict[str, Work]]
    is_parallel: bool = False


CASES = [
    Case("speed_sweep", "2000 small solves", small_solves),
    Case("fine_rolling/1024", "window of 1024²", large_window, is_parallel=True),
    Case("fine_rolling/2048", "window of 2048²", large_window, is_parallel=True),
    Case("friction/mu_03_pi_250", "friction at π/250", small_friction),
    Case("revolution/1000_one_lattice", "4000 time steps, 1000 nodes", instants),
]


def speed() -> float:
    """Return the speed of one core in a product of dense matrices [flop/s]."""
    a = np.random.default_rng(1).random((1500, 1500))
    return 2.0 * 1500.0**3 / best_time(lambda: a @ a)


def bandwidth() -> float:
    """Return the memory bandwidth of one core in sums of large arrays [B/s]."""
    a, b = np.ones(20_000_000), np.ones(20_000_000)
    c = np.zeros_like(a)
    return 3.0 * a.nbytes / best_time(lambda: np.add(a, b, out=c))


def best_time(work: Callable[[], object]) -> float:
    """Return the shortest of seven times [s]."""
    times = []
    for _ in range(7):
        before = time.perf_counter()
        work()
        times.append(time.perf_counter() - before)
    return min(times)


@dataclass(frozen=True)
class Profile:
    """Counters of a benchmark, samples of each phase in the busiest thread and in all threads, and its time [s]."""

    counters: dict[str, float]
    by_one: Counter[str]
    by_all: Counter[str]
    seconds: float


def profile(case: str, cores: set[int]) -> Profile:
    """Return the profile of a benchmark on given cores."""
    os.sched_setaffinity(0, cores)
    chosen = [str(PROGRAM), f"--benchmark_filter=^{case}/", "--benchmark_format=json"]
    with tempfile.NamedTemporaryFile() as data:
        record = ["perf", "record", "--quiet", "-g", "-F", str(FREQUENCY), "-e", "cpu-clock", "-o", data.name]
        output = subprocess.run([*record, *chosen], capture_output=True, text=True, check=True).stdout
        script = ["perf", "script", "-i", data.name, "-F", "tid,ip,sym,dso"]
        stacks = subprocess.run(script, capture_output=True, text=True, check=True).stdout.split("\n\n")
    (done,) = (run for run in json.loads(output)["benchmarks"] if run["run_type"] == "iteration")
    samples = Counter((stack.split(maxsplit=1)[0], phase_of(stack)) for stack in stacks if stack.strip())
    threads: Counter[str] = Counter()
    by_all: Counter[str] = Counter()
    for (thread, phase), count in samples.items():
        threads[thread] += count
        by_all[phase] += count
    busiest = max(threads, key=threads.__getitem__)
    by_one = Counter({phase: count for (thread, phase), count in samples.items() if thread == busiest})
    counters = {key: float(value) for key, value in done.items() if isinstance(value, int | float)}
    return Profile(counters, by_one, by_all, done["real_time"] * 1e-3)


def alone(two: Profile, phase: str | None = None) -> str:
    """Return the fraction of a phase, or of the run, during which one of two threads works and the other waits."""
    one = two.by_one[phase] if phase else two.by_one.total()
    others = (two.by_all[phase] if phase else two.by_all.total()) - one
    return f"{100.0 * max(0.0, 1.0 - others / one):.0f} %" if one > 0 else ""


def phase_of(stack: str) -> str:
    """Return the phase of a stack: that of the first rule that matches one of its functions."""
    return next((phase for phase, names in PHASES if any(name in stack for name in names)), REST)


def rows() -> Iterable[str]:
    """Return the lines of the table."""
    cores = sorted(os.sched_getaffinity(0))
    flops, bytes_per_second = speed(), bandwidth()
    yield (
        f"On {cpu_name()}, one core: {flops / 1e9:.1f} Gflop/s in dense products, "
        f"{bytes_per_second / 1e9:.1f} GB/s in sums of large arrays; at {git('rev-parse', '--short', 'HEAD')}.\n"
    )
    yield "| case, phase | Gflop | GB | lower bound [ms] | measured [ms] | ratio | one of two threads works |"
    yield "|---|---|---|---|---|---|---|"
    for case in CASES:
        run = profile(case.name, {cores[0]})
        two = profile(case.name, set(cores[:2])) if case.is_parallel and len(cores) > 1 else None
        works = case.work(run.counters)
        least = {phase: max(work.flop / flops, work.bytes / bytes_per_second) for phase, work in works.items()}
        total = sum(works.values(), Work())
        yield row(f"**{case.title}**", total, sum(least.values()), run.seconds, alone(two) if two else "")
        for phase, count in run.by_all.most_common():
            took = run.seconds * count / run.by_all.total()
            if took > 0.01 * run.seconds:
                share = alone(two, phase) if two else ""
                yield row(phase, works.get(phase, Work()), least.get(phase, 0.0), took, share)


def row(name: str, work: Work, least: float, took: float, share: str) -> str:
    """Return a line of the table."""
    known = least > 0.0
    numbers = [f"{work.flop / 1e9:.3g}", f"{work.bytes / 1e9:.3g}", f"{1e3 * least:.3g}"] if known else ["", "", ""]
    times = f"{took / least:.1f}" if known else ""
    return " | ".join(["| " + name, *numbers, f"{1e3 * took:.3g}", times, share + " |"])


def main() -> None:
    if shutil.which("perf") is None:
        sys.exit("the table was not updated: perf, which identifies the phases, is not installed")
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(PLACE[0])
    after = rest.split(PLACE[1])[1]
    made = "\n".join(rows())
    PAGE.write_text(f"{before}{PLACE[0]}{made}\n\n{PLACE[1]}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
