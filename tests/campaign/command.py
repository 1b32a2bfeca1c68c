"""Command of randomized tests: solve many random cases, write each outcome, and summarize."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from .runner import Outcome, run
from .summary import summary

__all__ = ["main"]


def main(
    program: str,
    description: str | None,
    output: str,
    draw: Callable[[int, int], Any],
    run_case: Callable[..., Outcome],
) -> int:
    """Run randomized tests, or some of their cases, as the command line requests.

    Parameters
    ----------
    program, description : str
        Name and description for the help text.
    output : str
        Default path of the results.
    draw, run_case : callable
        Same as in `runner.run`.
    """
    parser = argparse.ArgumentParser(prog=program, description=description)
    parser.add_argument("--cases", type=int, default=2000, help="number of cases")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--seed", type=int, default=1, help="seed of the random cases")
    parser.add_argument("--jobs", type=int, default=1, help="number of processes, each with one thread")
    parser.add_argument("--limit", type=float, default=20.0, help="largest processor time of a solve [s]")
    parser.add_argument(
        "--output", type=Path, default=Path(output), help="output file with one line of JSON for each case"
    )
    parser.add_argument("--case", metavar="SEED:NUMBER", action="append", help="solve and print only this case")
    arguments = parser.parse_args()
    if arguments.case:
        return max([_show(draw(*map(int, name.split(":"))), run_case) for name in arguments.case])
    numbers = range(arguments.first, arguments.first + arguments.cases)
    start = time.monotonic()
    outcomes: list[Outcome] = []
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    with arguments.output.open("w") as file:
        for outcome in run(
            arguments.seed, numbers, jobs=arguments.jobs, limit=arguments.limit, draw=draw, run_case=run_case
        ):
            outcomes.append(outcome)
            print(json.dumps(outcome.to_dict()), file=file, flush=True)
            _report(len(outcomes), len(numbers), outcomes)
    print(file=sys.stderr)
    print(summary(outcomes))
    print(
        f"{time.monotonic() - start:.0f} s in total; {arguments.output} has all cases, --case SEED:NUMBER repeats one"
    )
    return int(any(outcome.failed for outcome in outcomes))


def _report(done: int, total: int, outcomes: list[Outcome]) -> None:
    failed = sum(outcome.failed for outcome in outcomes)
    print(f"\r{done} of {total}, {failed} failed", end="", file=sys.stderr, flush=True)


def _show(case: Any, run_case: Callable[..., Outcome]) -> int:
    print("from viscoroll import *\nfrom viscoroll.materials import *\nfrom tests.campaign.materials import *\n")
    print(f"r = {case.source()}\n", flush=True)
    outcome = run_case(case)
    for key, value in outcome.to_dict().items():
        if key != "source":
            print(f"{key}: {value}")
    return int(outcome.failed)
