"""A subset of the randomized rough surfaces, and whether these tests detect errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from campaign.sliding import draw, run_case, violations
from viscoroll.sliding import SlidingResult

SEED = 1
NUMBERS = range(40)


@pytest.mark.parametrize("number", NUMBERS)
def test_slice(number):
    outcome = run_case(draw(SEED, number))
    assert outcome.kind == "solved", outcome
    assert outcome.violations == {}, outcome


def test_the_cases_differ():
    cases = [draw(SEED, number) for number in NUMBERS]
    assert draw(SEED, 7).source() == cases[7].source()
    assert {case.body.periodic for case in cases} == {case.body.is_profile for case in cases} == {True, False}
    assert {case.has_friction for case in cases} == {True, False}
    assert {case.arguments["speed"] == 0.0 for case in cases} == {True, False}


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
@pytest.mark.parametrize(
    ("change", "violated"),
    [
        ({"friction_coefficient": -0.1}, "power < 0"),
        ({"power_density": 1.0}, "force and power"),
        ({"friction_error": 1.0}, "tractions and losses"),
        ({"converged": False}, "not converged"),
        ({"mean_gap": np.nan}, "not finite"),
        ({"residual": 1.0}, "residual"),
    ],
)
def test_errors_are_detected(change, violated):
    case = next(case for number in NUMBERS if (case := draw(SEED, number)).arguments["speed"] > 0.0)
    found = vr.slide(case.body, **case.arguments)
    assert isinstance(found, SlidingResult)
    assert violations(case, found) == {}
    assert violated in violations(case, replace(found, **change))
