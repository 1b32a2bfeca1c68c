"""Command that mutates many files and reads each in a process that may hang or crash."""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter, defaultdict

import tests.campaign.files as package

from ..runner import Outcome, run
from .kinds import KINDS
from .running import draw, run_case


def main() -> int:
    """Run all files, or report what is wrong with one of them."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.files", description=package.__doc__)
    parser.add_argument("--count", type=int, default=20000, help="number of files")
    parser.add_argument("--first", type=int, default=0, help="number of the first file")
    parser.add_argument("--seed", type=int, default=1, help="seed of the random files")
    parser.add_argument("--jobs", type=int, default=1, help="number of processes")
    parser.add_argument("--limit", type=float, default=10.0, help="largest processor time of a file [s]")
    parser.add_argument("--file", metavar="SEED:NUMBER", action="append", help="read and print only this file")
    arguments = parser.parse_args()
    if arguments.file:
        return max(_show(*map(int, name.split(":"))) for name in arguments.file)
    numbers = range(arguments.first, arguments.first + arguments.count)
    start = time.monotonic()
    outcomes: list[Outcome] = []
    for outcome in run(
        arguments.seed, numbers, jobs=arguments.jobs, limit=arguments.limit, draw=draw, run_case=run_case
    ):
        outcomes.append(outcome)
        if len(outcomes) % 100 == 0:
            failed = sum(one.failed for one in outcomes)
            print(f"\r{len(outcomes)} of {len(numbers)}, {failed} failed", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    print(_summary(outcomes))
    print(f"{time.monotonic() - start:.0f} s in total; --file SEED:NUMBER repeats a file")
    return int(any(outcome.failed for outcome in outcomes))


def _show(seed: int, number: int) -> int:
    case = draw(seed, number)
    outcome = run_case(case)
    print(f"{case.name}, {case.kind}, seed {case.seed}: {outcome.message or 'passed'}")
    return int(outcome.failed)


def _summary(outcomes: list[Outcome]) -> str:
    """Return counts by kind of file, and examples of each class of failure."""
    lines = []
    for kind in KINDS:
        of_kind = [outcome for outcome in outcomes if outcome.stage == kind]
        seconds = sum(outcome.seconds for outcome in of_kind)
        failed = sum(outcome.failed for outcome in of_kind)
        lines.append(f"  {kind:<24} {len(of_kind):6d} files  {failed:5d} failed  {seconds:6.1f} s")
    lines.append(f"  {'all':<24} {len(outcomes):6d} files  {sum(outcome.failed for outcome in outcomes):5d} failed")
    members: defaultdict[str, list[Outcome]] = defaultdict(list)
    for outcome in outcomes:
        if outcome.failed:
            members[f"{outcome.kind} [{outcome.stage}] {outcome.message.partition(': ')[0]}"].append(outcome)
    for shape, count in Counter({shape: len(found) for shape, found in members.items()}).most_common():
        lines += [f"{count:6d}  {shape}"]
        lines += [f"        {outcome.case}  {outcome.message[:200]}" for outcome in members[shape][:3]]
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
