"""Tables of the site that are written nowhere by hand: each is made of what tests, benchmarks or the library know."""

from __future__ import annotations

import csv
import tomllib
from collections.abc import Iterable, Sequence
from pathlib import Path

from viscoroll.solution.scalars import PER_LENGTH, SCALARS


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def validation_table(path: Path) -> str:
    """Return what is held against what, how far the two are apart, and the tests that say so."""
    rows = tomllib.loads(path.read_text(encoding="utf-8"))["row"]
    return table(
        ("what", "against", "found", "test"),
        [
            (row["what"], row["against"], row["found"], "<br>".join(f"`{test}`" for test in row["tests"]))
            for row in rows
        ],
    )


def outside_tables(path: Path) -> dict[str, str]:
    """Return a table for each benchmark of others: their number, ours, the difference, and the test that holds both."""

    def difference(row: dict[str, str]) -> str:
        return f"{100.0 * (float(row['ours']) / float(row['theirs']) - 1.0):+.2f} %"

    return {
        name: table(
            ("what", "theirs", "ours", "difference", "test"),
            [
                (row["what"], row["theirs"], row["ours"], difference(row), f"`{row['test']}`")
                for row in benchmark["row"]
            ],
        )
        for name, benchmark in tomllib.loads(path.read_text(encoding="utf-8")).items()
    }


def benchmark_table(path: Path) -> str:
    """Return the latest run of every benchmark."""
    with path.open(encoding="utf-8", newline="") as file:
        latest = {row["case"]: row for row in csv.DictReader(file)}
    return table(
        ("case", "median [s]", "from .. to [s]", "clock", "threads", "error", "memory [MB]", "day, commit, processor"),
        [
            (
                f"`{case}`",
                row["median_s"],
                f"{row['min_s']} .. {row['max_s']}",
                row["clock"],
                row["threads"],
                row["error"],
                row["peak_mb"],
                f"{row['date']}, {row['commit']}, {row['cpu']}",
            )
            for case, row in sorted(latest.items())
        ],
    )


def scalar_table() -> str:
    """Return all scalar results with their units."""
    return table(
        ("name", "unit", "of a roller", "what"),
        [
            (f"`{name}`", shown(unit), shown(PER_LENGTH.get(unit, unit)), label)
            for name, (unit, label) in SCALARS.items()
        ],
    )


def shown(unit: str) -> str:
    """Return a unit for people: a number has none."""
    return "-" if unit == "1" else unit.replace("^2", "²")
