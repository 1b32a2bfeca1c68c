"""Compute a history and its twins, which must agree with it, and check them."""

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
    """Roll a case and, unless it is slow, its twins, and check the histories.

    Parameters
    ----------
    case : HistoryCase
        The history.
    before_each : callable
        Called before each history with the outcome so far.
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
    if case.unphysical_argument:
        outcome.violations[f"unphysical {case.unphysical_argument} accepted"] = math.inf
    for twin in twins(case) if outcome.seconds < SLOW else ():
        outcome.stage = twin.kind
        before_each(outcome)
        twin_history = attempt(twin.roll, twin.case, outcome)
        if twin_history is None:  # the library rejects the twin, or fails, although it solved the case
            outcome.violations[f"{twin.kind}: no solution"] = math.inf
            return outcome
        differences = twin.differences(history, twin_history)
        outcome.violations |= {f"{twin.kind}: {name}": error for name, error in differences.items()}
    outcome.stage = "case"
    return outcome
