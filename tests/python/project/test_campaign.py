"""A subset of the randomized tests, and whether the tests detect errors."""

from __future__ import annotations

import os
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from campaign import materials
from campaign.cases import Case, draw
from campaign.invariants import violations
from campaign.runner import run, run_case
from campaign.summary import summary
from campaign.twins import twins
from viscoroll import enums

SEED = 1

#: Quick cases among the first ones, and some of rollers and of counterbodies other than planes.
NUMBERS = (
    *(3, 7, 11, 12, 16, 31, 32, 34, 36, 38, 73, 145, 152, 231, 240, 258, 321, 323),
    *(2, 23, 29, 42, 46, 67, 88, 97, 100, 111, 123, 141, 161, 163, 166, 177, 199),
    *(220, 229, 254, 275, 280, 290, 309, 310, 334, 342, 353, 357, 378, 383, 393),
)

#: Cases that take several seconds, with their twins: wheels on meshes that the solver chooses, and a ball in a groove.
LONG = (37, 267, 346)


@pytest.mark.parametrize("number", [*NUMBERS, *(pytest.param(number, marks=pytest.mark.slow) for number in LONG)])
def test_slice(number):
    outcome = run_case(draw(SEED, number))
    assert outcome.kind in ("solved", "rejected"), outcome
    assert outcome.violations == {}, outcome


def test_seed_and_number_determine_the_case():
    assert draw(1, 7).source() == draw(1, 7).source()
    assert len({draw(seed, number).source() for seed in (1, 2) for number in range(50)}) == 100


def test_source_reproduces_the_case():
    names = vars(vr) | vars(vr.materials) | vars(enums) | vars(materials)
    for number in range(50):
        case = draw(3, number)
        calls: list[tuple[vr.CoatedSphere, dict]] = []
        names["solve"] = lambda body, calls=calls, **arguments: calls.append((body, arguments))
        eval(case.source(), names)
        assert repr(calls) == repr([(case.body, {k: v for k, v in case.arguments.items() if k != "threads"})])


def elastic_case(**changes) -> Case:
    layer = vr.Layer(thickness=5e-3, shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.4)
    arguments = {
        "load": 1.0,
        "angular_speed": 1.0,
        "friction": 0.3,
        "drive": vr.Drive(torque=0.0),
        "mesh": vr.Mesh(nodes_per_revolution=250),
        "threads": 1,
    }
    ball = changes.pop("body", vr.CoatedSphere(core_radius=20e-3, layers=[layer]))
    return Case(name="0:0", body=ball, arguments=arguments | changes)


def test_a_valid_case_has_no_violation():
    outcome = run_case(elastic_case())
    assert (outcome.kind, outcome.violations, outcome.stage) == ("solved", {}, "case")
    assert outcome.nodes > 20


ALTERED = {
    "not finite": lambda r: {"driving_torque": np.nan},
    "pressure < 0": lambda r: {"pressure": np.where(r.contact, r.pressure, -1e-3 * r.max_pressure)},
    "gap < 0": lambda r: {"gap": r.gap - 1e-4 * r.penetration},
    "load balance": lambda r: {"pressure": 1.001 * r.pressure},
    "penetration >= thickness": lambda r: {"penetration": r.body.thickness},
    "residual": lambda r: {"residual": 1e-4},
    "iteration limit reached": lambda r: {"status": enums.Status.MAX_ITERATIONS},
    "traction > friction": lambda r: {"shear_traction": 1.01 * r.shear_traction},
    "slip below the limit": lambda r: {"slip": r.contact, "stick": ~r.contact & False},
    "slip not opposite to traction": lambda r: {"shear_traction": -r.shear_traction},
    "slip of sticking nodes": lambda r: {"stick": r.contact, "slip": ~r.contact & False},
    "stick and slip": lambda r: {"stick": r.contact, "slip": r.contact},
    "driving force": lambda r: {"driving_force": r.driving_force + 0.01},
    "torque balance": lambda r: {"driving_torque": 1e-3},
    "power gained in the coating": lambda r: {"bulk_power": -1e-3},
    "power gained by slip": lambda r: {"slip_power": -1e-3},
    "power dissipated in an elastic coating": lambda r: {"bulk_power": 1e-3},
    "symmetry of pressure": lambda r: {"pressure": np.roll(r.pressure, 1, axis=1)},
}


@pytest.fixture(scope="module")
def valid_result() -> vr.Result:
    case = elastic_case()
    return vr.solve(case.body, **case.arguments)


@pytest.mark.parametrize("name", ALTERED)
def test_altered_results_are_detected(valid_result, name):
    assert violations(elastic_case(), valid_result) == {}
    assert name in violations(elastic_case(), replace(valid_result, **ALTERED[name](valid_result)))


def pair_case() -> Case:
    """Return two identical balls without friction."""
    modulus = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=0.1)
    layer = vr.Layer(thickness=5e-3, shear_modulus=modulus, poisson_ratio=0.4)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    return elastic_case(on=ball, friction=0.0, drive=vr.Drive(force=0.0), load=5.0, body=ball)


def test_a_valid_pair_has_no_violation():
    case = pair_case()
    assert [twin.kind for twin in twins(case)] == ["scaling", "split layer", "swap", "mirror plane"]
    outcome = run_case(case)
    assert (outcome.kind, outcome.violations, outcome.stage) == ("solved", {}, "case")


@pytest.mark.parametrize(
    ("name", "changed"),
    [
        ("power of the rolling body", lambda r: {"driving_torque": 10.0 * r.driving_torque}),
        ("power of the counterbody", lambda r: {"counterbody_bulk_power": 10.0 * r.counterbody_bulk_power}),
        ("total power of a pair", lambda r: {"dissipated_power": 10.0 * r.dissipated_power}),
    ],
)
def test_a_wrong_power_balance_of_a_pair_is_detected(name, changed):
    case = pair_case()
    result = vr.solve(case.body, **case.arguments)
    assert name in violations(case, replace(result, **changed(result)))


def test_a_solution_that_does_not_scale_is_detected(monkeypatch):
    solve = vr.solve

    def shifted(*args, **kwargs):
        result = solve(*args, **kwargs)
        return replace(result, penetration=result.penetration + 1e-9)

    monkeypatch.setattr(vr, "solve", shifted)
    # The second solution of the penetration check is shifted as well.
    assert set(run_case(elastic_case()).violations) == {
        "scaling: penetration",
        "penetration: penetration",
        "penetration: load",
    }


@pytest.mark.parametrize(
    ("message", "kind"),
    [
        ("load must be small enough", "rejected"),
        ("layers[0].thickness must be > 0 m", "rejected"),
        ("drive.torque must be between 1 N m and 2 N m", "rejected"),
        ("mesh.nodes_per_revolution must be so small that there are 4000 unknown forces", "improper message"),
        ("accuracy must be less, though nobody gave one", "improper message"),
        ("the matrix is singular", "improper message"),
    ],
)
def test_messages_are_judged(monkeypatch, message, kind):
    def refuse(*args, **kwargs):
        raise ValueError(message)

    monkeypatch.setattr(vr, "solve", refuse)
    assert run_case(elastic_case()).kind == kind


def test_rejection_of_a_supportable_load_is_detected(monkeypatch):
    solve = vr.solve

    def refuse(body, *, load, **kwargs):
        if load > 0.5:
            raise ValueError("load must be small enough for the coating, got 1 N")
        return solve(body, load=load, **kwargs)

    monkeypatch.setattr(vr, "solve", refuse)
    assert "supportable load rejected" in run_case(elastic_case()).violations


def loop(omega):
    while True:
        pass


def end(omega):
    os._exit(7)


def bad_case(seed: int, number: int) -> Case:
    """Return a case that hangs, one that crashes, and then valid cases."""
    case = elastic_case()
    if number > 1:
        return replace(case, name=f"{seed}:{number}")
    layer = replace(case.body.layers[0], shear_modulus=(loop, end)[number])
    return replace(case, name=f"{seed}:{number}", body=replace(case.body, layers=[layer]))


def test_the_runner_survives_cases_that_hang_or_crash():
    kinds = {outcome.case: outcome for outcome in run(0, range(3), jobs=1, limit=1.0, draw=bad_case)}
    assert [kinds[f"0:{number}"].kind for number in range(3)] == ["hang", "crash", "solved"]
    text = summary(list(kinds.values()))
    assert "3 cases, 3 with friction" in text
    assert "hang [case]" in text
    assert "crash [case] exit code #" in text
