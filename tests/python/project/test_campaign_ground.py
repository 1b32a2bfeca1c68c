"""A subset of the random histories over uneven ground, and whether these tests detect errors."""

from __future__ import annotations

from dataclasses import replace

import pytest
from campaign.ground import draw, run_case, violations
from campaign.runner import Outcome, attempt
from viscoroll import roll

SEED = 1

#: Quick cases of most kinds of pairs, with and without friction, ground, tread and axle. In case 124 of seed 2, a ball
#: that slides lifts off.
NUMBERS = (13, 14, 22, 23, 30, 33, 44, 48, 65, 70, 71, 82, 89, 99, 131, 145, 168, 182)


@pytest.mark.parametrize(
    ("seed", "number"),
    # Case 67, a solid ball with friction, takes three seconds.
    [*((SEED, number) for number in NUMBERS), (2, 124), pytest.param(SEED, 67, marks=pytest.mark.slow)],
)
def test_slice(seed, number):
    outcome = run_case(draw(seed, number))
    assert outcome.kind == "solved", outcome
    assert outcome.violations == {}, outcome


def test_seed_and_number_determine_the_history():
    assert draw(1, 7).source() == draw(1, 7).source()
    assert len({draw(seed, number).source() for seed in (1, 2) for number in range(25)}) == 50


@pytest.mark.parametrize("name", ["load", "stored_energy", "energy_balance_residual", "contact_area", "driving_torque"])
def test_altered_histories_are_detected(name):
    case = draw(SEED, 48)
    history = attempt(roll, case, Outcome(case=case.name))
    assert violations(case, history) == {}
    values = getattr(history, name)
    wrong = {"load": -values, "stored_energy": values * float("nan"), "contact_area": 0.0 * values}
    largest = abs(history.work).max() + abs(history.resisting_torque).max()
    assert violations(case, replace(history, **{name: wrong.get(name, values + largest)}))
