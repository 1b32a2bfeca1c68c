"""The command: solve many random cases, write what came of each, and sum up."""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

from .cases import draw
from .runner import Outcome, run, run_case
from .summary import summary


def main() -> int:
    """Run a campaign, or one case of it."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign", description=__doc__)
    parser.add_argument("--cases", type=int, default=2000, help="number of cases")
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--seed", type=int, default=1, help="of the campaign")
    parser.add_argument("--jobs", type=int, default=1, help="number of processes, each with one thread")
    parser.add_argument(
        "--limit", type=float, default=20.0, help="processor time of a solve [s], beyond which it hangs"
    )
    parser.add_argument("--output", type=Path, default=Path("build/campaign.jsonl"), help="JSON, a line for each case")
    parser.add_argument("--case", metavar="SEED:NUMBER", action="append", help="solve this one here, and show it")
    arguments = parser.parse_args()
    if arguments.case:
        return max([_show(name) for name in arguments.case])
    numbers = range(arguments.first, arguments.first + arguments.cases)
    start = time.monotonic()
    outcomes: list[Outcome] = []
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    with arguments.output.open("w") as file:
        for outcome in run(arguments.seed, numbers, jobs=arguments.jobs, limit=arguments.limit):
            outcomes.append(outcome)
            print(json.dumps(outcome.to_dict()), file=file, flush=True)
            _report(len(outcomes), len(numbers), outcomes)
    print(file=sys.stderr)
    print(summary(outcomes))
    print(f"{time.monotonic() - start:.0f} s in all; {arguments.output} has each case, --case SEED:NUMBER repeats one")
    return int(any(outcome.failed for outcome in outcomes))


def _report(done: int, total: int, outcomes: list[Outcome]) -> None:
    failed = sum(outcome.failed for outcome in outcomes)
    print(f"\r{done} of {total}, {failed} failed", end="", file=sys.stderr, flush=True)


def _show(name: str) -> int:
    seed, number = (int(part) for part in name.split(":"))
    case = draw(seed, number)
    print("from viscoroll import *\nfrom tests.campaign.materials import *\n")
    print(f"r = {case.source()}\n", flush=True)
    outcome = run_case(case)
    for key, value in outcome.to_dict().items():
        if key != "source":
            print(f"{key}: {value}")
    return int(outcome.failed)


if __name__ == "__main__":
    sys.exit(main())
