"""Randomized tests with far too small or too large numbers: their cases, and a subset of them."""

from __future__ import annotations

import pytest
from campaign.extremes import draw, run_case
from campaign.runner import run


def test_only_one_number_of_the_case_changes():
    case = draw(33, 5)
    given, changed = {"body": case.base.body, **case.base.arguments}, case.arguments
    again = [name for name, value in changed().items() if value is not given[name] and value != given[name]]
    assert again == [case.path[0]]


@pytest.mark.slow
def test_extreme_numbers_are_solved_or_rejected():
    kinds = {
        outcome.case: outcome.kind for outcome in run(33, range(30), jobs=1, limit=120.0, draw=draw, run_case=run_case)
    }
    assert set(kinds.values()) <= {"solved", "rejected", "no convergence"}, kinds
    assert list(kinds.values()).count("rejected") > 5
