"""A subset of the randomized histories, and whether these tests detect errors."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from campaign import materials
from campaign.histories.cases import HistoryCase, draw
from campaign.histories.invariants import TURNED_BACK, turnover, violations
from campaign.histories.running import run_case
from campaign.histories.twins import twins
from viscoroll import enums

SEED = 1

#: Quick cases among the first ones, of most kinds of pairs.
NUMBERS = (3, 5, 10, 11, 13, 14, 22, 24, 25, 26, 28, 30, 31, 33, 35, 44, 48, 52, 53, 56, 67, 74, 75, 77, 84, 136)


@pytest.mark.parametrize("number", [*NUMBERS, pytest.param(79, marks=pytest.mark.slow)])  # 79 takes four seconds
def test_slice(number):
    outcome = run_case(draw(SEED, number))
    assert outcome.kind in ("solved", "rejected"), outcome
    assert outcome.violations == {}, outcome


def test_seed_and_number_determine_the_history():
    assert draw(1, 7).source() == draw(1, 7).source()
    assert len({draw(seed, number).source() for seed in (1, 2) for number in range(25)}) == 50


def test_source_reproduces_the_history():
    names = vars(vr) | vars(vr.materials) | vars(enums) | vars(materials) | {"inf": np.inf}
    for number in range(25):
        case = draw(3, number)
        calls: list[tuple[vr.bodies.RollingBody, dict]] = []
        names["roll"] = lambda body, calls=calls, **arguments: calls.append((body, arguments))
        eval(case.source(), names)
        assert repr(calls) == repr([(case.body, {k: v for k, v in case.arguments.items() if k != "threads"})])


def history_case(**changes: object) -> HistoryCase:
    """Return a ball that rolls, stands, is lifted and returns; with friction, unless `changes` say otherwise."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=0.1)
    layer = vr.Layer(thickness=5e-3, shear_modulus=rubber, poisson_ratio=0.4)
    arguments = {
        "time": [0.0, 0.2, 0.4, 0.5, 0.6, 0.8],
        "angle": [0.0, 0.2, 0.2, 0.2, 0.2, 0.0],
        "load": [5.0, 5.0, 5.0, 0.0, 0.0, 3.0],
        "friction": 0.3,
        "mesh": vr.Mesh(nodes_per_revolution=100),
        "averaged_meshes": 2,
        "shortest_time": 1e-5,
        "longest_time": 10.0,
        "threads": 1,
    }
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    return HistoryCase(name="0:0", body=ball, arguments=arguments | changes)


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_a_valid_history_has_no_violation(friction):
    case = history_case(friction=friction)
    assert [twin.kind for twin in twins(case)] == ["mirror", "scaling", "elsewhere", "interrupted"]
    outcome = run_case(case)
    assert (outcome.kind, outcome.violations, outcome.stage) == ("solved", {}, "case")
    assert outcome.nodes > 10


def changed(values: np.ndarray, where: slice | int, by: float) -> np.ndarray:
    values = values.copy()
    values[where] += by
    return values


ALTERED = {
    "not finite": lambda h: {"driving_torque": changed(h.driving_torque, 3, np.nan)},
    "end differs from the last waypoint": lambda h: {"angle": changed(h.angle, -1, 1e-9)},
    "time decreases": lambda h: {"time": changed(h.time, 5, -0.1)},
    "contact_area without load": lambda h: {"contact_area": h.contact_area + 1e-9},
    "no contact under load": lambda h: {"contact_area": h.contact_area - h.contact_area[0]},
    "energy gained in the body": lambda h: {"dissipated_energy": changed(h.dissipated_energy, 20, 1e-3)},
    "energy gained by slip": lambda h: {"slip_energy": changed(h.slip_energy, 20, 0.01 * turnover(h))},
    "stored energy < 0": lambda h: {"stored_energy": h.stored_energy - h.stored_energy.max()},
    "energy balance": lambda h: {"energy_balance_residual": h.energy_balance_residual + h.dissipated_energy},
    "stick share outside [0, 1]": lambda h: {"stick_share": 1.1 * h.stick_share},
    "force > friction": lambda h: {"driving_force": h.driving_force + 1.6},
    "force balance": lambda h: {"driving_force": h.driving_force + 1e-3},
}


@pytest.fixture(scope="module")
def valid_history() -> vr.History:
    case = history_case()
    return vr.roll(case.body, **case.arguments)


@pytest.mark.parametrize("name", ALTERED)
def test_altered_histories_are_detected(valid_history, name):
    assert violations(history_case(), valid_history) == {}
    assert name in violations(history_case(), replace(valid_history, **ALTERED[name](valid_history)))


def test_energy_turnover_is_positive(valid_history):
    """With friction, the counterbody may gain energy, even more than the slip dissipates."""
    gaining = replace(valid_history, dissipated_energy=-2.0 * valid_history.dissipated_energy)
    assert turnover(gaining) > turnover(valid_history) > 0.0


def test_slip_that_reverses_in_a_step_may_gain_energy():
    """A locked ball slides 20 mm and returns in one step, whose work is that of the mean of opposite forces."""
    moved = {
        "time": [0.0, 1.0, 1.0],
        "angle": [0.0, 0.0, 0.0],
        "load": [1.0, 1.0, 1.0],
        "center_displacement": [0.0, 0.02, 0.0],
    }
    case = history_case(**moved)
    history = vr.roll(case.body, **case.arguments)
    given = 0.5 * history.friction * 0.02  # [J] for a load of 1 N
    assert given > 10.0 * TURNED_BACK * turnover(history)
    back = replace(history, slip_energy=changed(history.slip_energy, -1, -given))
    assert "energy gained by slip" not in violations(case, back)
    forth = replace(history, slip_energy=changed(history.slip_energy, -2, -given))
    assert "energy gained by slip" in violations(case, forth)


def test_torque_without_force_is_detected():
    case = history_case(friction=0.0)
    history = vr.roll(case.body, **case.arguments)
    wrong = replace(history, driving_torque=1.001 * history.driving_torque)
    assert "torque and force" in violations(case, wrong)


@pytest.mark.parametrize(
    ("kind", "shift"),
    [
        ("scaling", lambda h: {"penetration": h.penetration + 1e-9}),
        ("mirror", lambda h: {"resisting_torque": h.resisting_torque + 1e-7}),
        ("elsewhere", lambda h: {"work": h.work * (1.0 + 1e-4 * h.angle[0])}),
        ("interrupted", lambda h: {"max_pressure": h.max_pressure * (1.0 + 1e-15 * len(h.time))}),
    ],
)
def test_differences_between_twins_are_detected(kind, shift):
    case = history_case(friction=0.0)
    one = vr.roll(case.body, **case.arguments)
    twin = next(twin for twin in twins(case) if twin.kind == kind)
    other = twin.roll(twin.case.body, **twin.case.arguments)
    assert twin.differences(one, other) == {}
    assert twin.differences(replace(one, **shift(one)), replace(other, **shift(other)))
