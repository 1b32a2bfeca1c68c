"""One mutated file: drawn from seed and number, and checked in its own folder."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random

from ..runner import Outcome
from .kinds import KINDS

__all__ = ["FileCase", "draw", "run_case"]


@dataclass(frozen=True)
class FileCase:
    """One mutated file.

    Attributes
    ----------
    name : str
        "SEED:NUMBER".
    kind : str
        One of `KINDS`.
    seed : int
        Seed of its check.
    """

    name: str
    kind: str
    seed: int


def draw(seed: int, number: int) -> FileCase:
    """Return the file of a number; the kinds alternate."""
    kinds = list(KINDS)
    return FileCase(f"{seed}:{number}", kinds[number % len(kinds)], Random(f"{seed}:{number}").getrandbits(64))


def run_case(case: FileCase, before_each: Callable[[Outcome], object] = lambda _: None) -> Outcome:
    """Check a mutated file.

    Parameters
    ----------
    case : FileCase
        The file.
    before_each : callable
        Called before the check with the outcome so far, in which the kind of file is the stage.
    """
    outcome = Outcome(case=case.name, stage=case.kind)
    before_each(outcome)
    start = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        failure = KINDS[case.kind](case.seed, Path(folder))
    outcome.seconds = time.process_time() - start
    if failure is not None:
        outcome.kind, outcome.message = "error", failure
    return outcome
