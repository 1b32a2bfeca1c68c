"""Run the benchmarks and append medians with errors to results.csv: python bench/run.py [--runs N] [--keep-dirty].

Every case runs in a process of its own, whose peak memory is measured.
"""

from __future__ import annotations

import argparse
import csv
import importlib.util
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "bench" / "bench" / "bench_solve"
TRANSFORMS = [ROOT / "build" / build / "bench" / "bench_transforms" for build in ("bench", "bench-pocketfft")]
RESULTS = Path(__file__).with_name("results.csv")
COLUMNS = ["date", "commit", "cpu", "threads", "case", "runs", "clock", "median_s", "min_s", "max_s", "error"]
COLUMNS += ["contact_nodes", "peak_mb", "details"]

HERTZ = [(solver, nodes) for nodes in (256, 512, 1024) for solver in ("viscoroll", "tamaas", "aspher", "aspher_nested")]
GROUNDS = ("flat", "bump", "axle")
ROUGH_NODES = ("1024", "2048")
MODULES = {"aspher_nested": "aspher"} | dict.fromkeys(("roll", "advance", *GROUNDS, *ROUGH_NODES), "viscoroll")


def git(*arguments: str) -> str:
    return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()


def cpu_name() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def run(*command: object) -> tuple[Any, float]:
    """Return the JSON output of a command, and its peak memory [MB]."""
    with tempfile.TemporaryFile("w+") as output:
        process = subprocess.Popen([str(part) for part in command], stdout=output)
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            raise RuntimeError(f"{command} failed")
        output.seek(0)
        return json.load(output), usage.ru_maxrss / 1024.0


def row(case: str, clock: str, seconds: list[float], error: float, peak: float, **rest: Any) -> dict[str, object]:
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d"),
        "commit": git("rev-parse", "--short", "HEAD"),
        "cpu": cpu_name(),
        "threads": len(os.sched_getaffinity(0)) if clock == "wall" else 1,
        "case": case,
        "runs": len(seconds),
        "clock": clock,
        "median_s": f"{statistics.median(seconds):.4g}",
        "min_s": f"{min(seconds):.4g}",
        "max_s": f"{max(seconds):.4g}",
        "error": f"{abs(error):.2e}",
        "peak_mb": f"{peak:.0f}",
    } | rest


def transform_cases(runs: int, only: re.Pattern[str]) -> Iterator[dict[str, object]]:
    """Yield the cases of bench_transforms, built with FFTW and with PocketFFT: wall time on one core."""
    for program in TRANSFORMS:
        if not program.exists():
            print(f"{program.relative_to(ROOT)} skipped: not built")
            continue
        names = subprocess.run([program, "--benchmark_list_tests"], capture_output=True, text=True, check=True).stdout
        for name in filter(only.search, names.splitlines()):
            done, peak = repetitions(program, name, runs)
            seconds = [repetition["real_time"] * 1e-3 for repetition in done]
            yield row(name.removesuffix("/real_time"), "wall", seconds, done[0]["error"], peak, threads=1, details="")


def repetitions(program: Path, name: str, runs: int) -> tuple[list[dict[str, Any]], float]:
    """Return the output of a benchmark for each run, and its peak memory [MB]."""
    several = [f"--benchmark_repetitions={runs}", "--benchmark_min_warmup_time=0.1"]
    output, peak = run(program, f"--benchmark_filter=^{name}$", *several, "--benchmark_format=json")
    return [repetition for repetition in output["benchmarks"] if repetition["run_type"] == "iteration"], peak


def library_cases(runs: int, only: re.Pattern[str]) -> Iterator[dict[str, object]]:
    """Yield the cases of bench_solve: wall time on all cores."""
    names = subprocess.run([PROGRAM, "--benchmark_list_tests"], capture_output=True, text=True, check=True).stdout
    for name in names.splitlines():
        case = name.removesuffix("/real_time").replace("/iterations:1", "")
        if not only.search(case):
            continue
        done, peak = repetitions(PROGRAM, name, runs)
        details: dict[str, object] = {
            key: int(done[0][key])
            for key in ("iterations", "operator_applications", "window", "steps")
            if key in done[0]
        }
        if "steps" in details:
            real = statistics.median(repetition["real_time"] for repetition in done)
            details["ms_per_step"] = f"{real / details['steps']:.3f}"
        yield row(
            case,
            "wall",
            [repetition["real_time"] * 1e-3 for repetition in done],
            done[0]["error"],
            peak,
            contact_nodes=int(done[0].get("contact_nodes", 0)),
            details=text(details) if {"operator_applications", "steps"} & details.keys() else "",
        )


def script_cases(runs: int, only: re.Pattern[str]) -> Iterator[dict[str, object]]:
    """Yield the cases of other solvers and of viscoroll from Python: CPU time on one core."""
    folder = Path(__file__).parent
    cases = [(f"hertz/{nodes}/{solver}", folder / "hertz.py", solver, nodes) for solver, nodes in HERTZ]
    cases += [(f"paper_resolution/{solver}", folder / "plain_numpy.py", solver) for solver in ("viscoroll", "plain")]
    cases += [(f"revolution_python/500_{call}", folder / "revolution.py", call, 500) for call in ("roll", "advance")]
    cases += [(f"ground/1000_{case}", folder / "ground.py", case, 1000) for case in GROUNDS]
    cases += [(f"rough/{nodes}_memory", folder / "rough.py", nodes, "--speed", 1e-3) for nodes in ROUGH_NODES]
    for case, script, solver, *rest in cases:
        if not only.search(case):
            continue
        module = MODULES.get(str(solver), str(solver))
        if module != "plain" and importlib.util.find_spec(module) is None:
            print(f"{case:<40} skipped: {module} is not installed")
            continue
        output, peak = run(sys.executable, script, solver, *rest, "--runs", runs)
        yield row(case, "cpu", output["seconds"], output["error"], peak, details=text(output["details"]))


def text(details: dict[str, object]) -> str:
    return " ".join(f"{key}={value}" for key, value in details.items())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5, help="number of repetitions of each case")
    parser.add_argument(
        "--only", type=re.compile, default=re.compile(""), help="regular expression for the cases to run"
    )
    parser.add_argument(
        "--keep-dirty", action="store_true", help="record results even if there are uncommitted sources"
    )
    options = parser.parse_args()

    rows = []
    for cases in (library_cases, transform_cases, script_cases):
        for done in cases(options.runs, options.only):
            print(f"{done['case']:<40} {done['median_s']:>8} s  [{done['min_s']}, {done['max_s']}]", end="  ")
            print(f"error {done['error']}  {done['peak_mb']} MB  {done['details']}", flush=True)
            rows.append(done)
    if git("status", "--porcelain", "--", "cpp", "python", "bench") and not options.keep_dirty:
        print("results not recorded: there are uncommitted sources")
        return
    with RESULTS.open("a", newline="") as file:
        csv.DictWriter(file, COLUMNS).writerows(rows)


if __name__ == "__main__":
    main()
