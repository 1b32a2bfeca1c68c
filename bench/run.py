"""Run the benchmarks and append medians with errors to results.csv: python bench/run.py [--keep-dirty]."""

from __future__ import annotations

import argparse
import csv
import json
import os
import platform
import statistics
import subprocess
from collections import defaultdict
from datetime import UTC, datetime
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "bench" / "bench" / "bench_solve"
RESULTS = Path(__file__).with_name("results.csv")
COLUMNS = ["date", "commit", "cpu", "threads", "case", "runs", "median_s", "min_s", "max_s", "error", "contact_nodes"]


def git(*arguments: str) -> str:
    return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()


def cpu_name() -> str:
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def measure(runs: int) -> list[dict[str, object]]:
    """Return one row for each case, from `runs` repetitions after a warm-up."""
    arguments = [f"--benchmark_repetitions={runs}", "--benchmark_min_warmup_time=0.1", "--benchmark_format=json"]
    output = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True).stdout
    repetitions = defaultdict(list)
    for run in json.loads(output)["benchmarks"]:
        if run["run_type"] == "iteration":
            repetitions[run["run_name"].removesuffix("/real_time").replace("/iterations:1", "")].append(run)
    rows = []
    for case, done in repetitions.items():
        seconds = [run["real_time"] * 1e-3 for run in done]
        rows.append(
            {
                "date": datetime.now(UTC).strftime("%Y-%m-%d"),
                "commit": git("rev-parse", "--short", "HEAD"),
                "cpu": cpu_name(),
                "threads": len(os.sched_getaffinity(0)),
                "case": case,
                "runs": len(seconds),
                "median_s": f"{statistics.median(seconds):.4g}",
                "min_s": f"{min(seconds):.4g}",
                "max_s": f"{max(seconds):.4g}",
                "error": f"{done[0]['error']:.2e}",
                "contact_nodes": int(done[0].get("contact_nodes", 0)),
            }
        )
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5, help="repetitions of each case")
    parser.add_argument("--keep-dirty", action="store_true", help="record uncommitted sources as well")
    options = parser.parse_args()

    rows = measure(options.runs)
    for row in rows:
        print(f"{row['case']:<40} {row['median_s']:>8} s  [{row['min_s']}, {row['max_s']}]  error {row['error']}")
    if git("status", "--porcelain", "--", "cpp", "bench") and not options.keep_dirty:
        print("sources differ from the commit: not recorded")
        return
    new = not RESULTS.exists()
    with RESULTS.open("a", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        if new:
            writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
