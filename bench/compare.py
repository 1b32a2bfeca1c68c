"""Compare new benchmarks with earlier ones of the same processor: python bench/compare.py [--tolerance 0.25].

Times depend on the machine and on its load, so a difference is a hint where to look, not a failed test. The exit code
is 1 if a case has become slower or less accurate by more than the tolerance.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

RESULTS = Path(__file__).with_name("results.csv")

#: Errors below this value are round-off and may vary.
_ROUND_OFF = 1e-12


@dataclass(frozen=True)
class Change:
    """Results of a case at two commits, the earlier one first."""

    case: str
    commits: tuple[str, str]
    seconds: tuple[float, float]
    errors: tuple[float, float]

    @property
    def slower(self) -> float:
        """Relative increase of the time."""
        return self.seconds[1] / self.seconds[0] - 1.0

    def judgment(self, tolerance: float) -> str:
        """Return "less accurate", "slower" or "faster" for a change above the tolerance, else an empty text."""
        if self.errors[1] > (1.0 + tolerance) * max(self.errors[0], _ROUND_OFF):
            return "less accurate"
        if self.slower > tolerance:
            return "slower"
        return "faster" if self.slower < -tolerance / (1.0 + tolerance) else ""


def changes(rows: list[dict[str, str]]) -> list[Change]:
    """Return the last result of every case and the one of an earlier commit with equal processor, threads and clock.

    Cases without a result of the last recorded commit are left out.
    """
    series: dict[tuple[str, ...], list[dict[str, str]]] = defaultdict(list)
    for row in rows:
        series[row["cpu"], row["threads"], row["clock"], row["case"]].append(row)
    found = []
    for (*_, case), measured in series.items():
        *earlier, now = measured
        before = [row for row in earlier if row["commit"] != now["commit"]]
        if before and now["commit"] == rows[-1]["commit"]:
            pair = (before[-1], now)
            found.append(
                Change(
                    case=case,
                    commits=tuple(row["commit"] for row in pair),
                    seconds=tuple(float(row["median_s"]) for row in pair),
                    errors=tuple(float(row["error"]) for row in pair),
                )
            )
    return found


def main() -> int:
    """Print time and error of every case, before and now."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tolerance", type=float, default=0.25, help="largest relative change that is not reported")
    parser.add_argument("results", nargs="?", type=Path, default=RESULTS, help="file written by bench/run.py")
    options = parser.parse_args()
    if not 0.0 < options.tolerance < 10.0:
        parser.error(f"--tolerance must be in (0, 10), got {options.tolerance}")
    with options.results.open(newline="") as file:
        found = changes(list(csv.DictReader(file)))
    if not found:
        print("nothing to compare: there are no earlier results for cases of the last commit on this processor")
    worse = 0
    for change in found:
        judgment = change.judgment(options.tolerance)
        worse += judgment in ("slower", "less accurate")
        (before, now), (error_before, error_now) = change.seconds, change.errors
        print(
            f"{change.case:<45} {change.commits[0]} {before:>8.4g} s, now {now:>8.4g} s {change.slower:>+7.0%}", end=""
        )
        print(f"  error {error_before:.1e}, now {error_now:.1e}  {judgment}".rstrip())
    return int(worse > 0)


if __name__ == "__main__":
    sys.exit(main())
