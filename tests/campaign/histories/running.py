"""Rolling a history and its twins, and judging them."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import viscoroll as vr

from ..runner import SLOW, Outcome, attempt
from .cases import HistoryCase
from .invariants import nodes_of, violations
from .twins import twins

__all__ = ["run_case"]


def run_case(case: HistoryCase, before_each: Callable[[Outcome], object] = lambda _: None) -> Outcome:
    """Roll a case and its twins, if it is not a slow one, and check the histories.

    Parameters
    ----------
    case : HistoryCase
        What to roll.
    before_each : callable
        Called before each history with what is known so far.
    """
    outcome = Outcome(case=case.name, has_friction=case.has_friction, source=case.source())
    before_each(outcome)
    start = time.process_time()
    history = attempt(vr.roll, case, outcome)
    outcome.seconds = time.process_time() - start
    if history is None:
        return outcome
    outcome.nodes = nodes_of(history)
    outcome.violations |= violations(case, history)
    if case.absurd:
        outcome.violations[f"absurd {case.absurd} accepted"] = math.inf
    for twin in twins(case) if outcome.seconds < SLOW else ():
        outcome.stage = twin.kind
        before_each(outcome)
        other = attempt(twin.roll, twin.case, outcome)
        if other is None:  # which is refused or not found, where its like was
            outcome.violations[f"{twin.kind}: not rolled"] = math.inf
            return outcome
        found = twin.differences(history, other)
        outcome.violations |= {f"{twin.kind}: {name}": error for name, error in found.items()}
    outcome.stage = "case"
    return outcome
