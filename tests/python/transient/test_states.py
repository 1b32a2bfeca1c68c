"""States of histories: copies, resumed runs, and files; damaged states and those of other bodies are refused."""

from __future__ import annotations

import copy
import pickle
from dataclasses import astuple

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import coated_ball, command
from viscoroll import paper
from viscoroll.case import example_text

BALL = paper.ball(density=0.0)
COARSE = vr.Mesh(nodes_per_revolution=100)
OPTIONS = {"load": 100.0, "mesh": vr.Mesh(nodes_per_revolution=60), "averaged_meshes": 1}


@pytest.fixture(scope="module")
def state():
    stepper = vr.RollingHistory(BALL, **OPTIONS)
    stepper.advance(time=0.1, angle=0.2, load=100.0)
    return stepper.state


@pytest.fixture
def saved(state, tmp_path):
    state.save(tmp_path / "ball.state")
    return tmp_path / "ball.state"


def test_a_file_keeps_every_bit(state, saved):
    again = vr.RollingState.load(saved)
    np.testing.assert_array_equal(again.numbers.view(np.uint64), state.numbers.view(np.uint64))
    assert again.bodies == state.bodies


def test_any_changed_byte_is_found(saved):
    content = saved.read_bytes()
    for place in [*range(200), *range(200, len(content), 97), len(content) - 1]:
        saved.write_bytes(content[:place] + bytes([content[place] ^ 1]) + content[place + 1 :])
        with pytest.raises(ValueError, match=r"ball.state (is damaged|is not a saved state|must be a state of format)"):
            vr.RollingState.load(saved)


@pytest.mark.parametrize("cut", [0, 10, 40, 300, -8, -1])
def test_a_truncated_file_is_found(saved, cut):
    saved.write_bytes(saved.read_bytes()[:cut])
    with pytest.raises(ValueError, match=r"ball.state (is damaged|is not a saved state)"):
        vr.RollingState.load(saved)


def test_a_numpy_file_is_not_a_state(state, saved):
    with saved.open("wb") as file:
        np.save(file, state.numbers)
    with pytest.raises(ValueError, match=r"is not a saved state of viscoroll: roll from the start"):
        vr.RollingState.load(saved)


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("_FORMAT", b"2", "must be a state of format 1, got '2'"),
        ("_MADE_BY", "0.0.1, commit abc", "must be written by viscoroll .*, got a state written by 0.0.1, commit abc"),
    ],
)
def test_other_versions_are_refused(state, tmp_path, monkeypatch, name, value, message):
    with monkeypatch.context() as other:
        other.setattr(f"viscoroll.transient.state_file.{name}", value)
        state.save(tmp_path / "ball.state")
    with pytest.raises(ValueError, match=message):
        vr.RollingState.load(tmp_path / "ball.state")


@pytest.mark.parametrize(
    ("ball", "on"),
    [
        (BALL, vr.Groove(radius=0.03)),
        (BALL, vr.CoatedSphere(core_radius=0.05, layers=[])),
        (vr.CoatedSphere(core_radius=30e-3, layers=BALL.layers), None),
    ],
)
def test_other_bodies_are_refused(saved, ball, on):
    with pytest.raises(ValueError, match=r"start must be a state of CoatedSphere\(.*, got a state of CoatedSphere\("):
        vr.RollingHistory(ball, on=on, start=vr.RollingState.load(saved), **OPTIONS)


def test_the_command_refuses_damaged_checkpoints(tmp_path):
    (tmp_path / "case.toml").write_text(example_text("motion"), encoding="utf-8")
    (tmp_path / "ball.state").write_bytes(b"\x93NUMPY")
    done = command("roll", tmp_path / "case.toml", "--checkpoint", tmp_path / "ball.state")
    assert done.returncode == 2
    assert done.stderr.startswith(f"viscoroll: {tmp_path / 'ball.state'} is not a saved state of viscoroll")


def test_a_step_of_a_copy_leaves_the_original_unchanged():
    stepper = vr.RollingHistory(BALL, load=100.0, mesh=COARSE)
    twin = copy.copy(stepper)
    tried = twin.advance(time=0.1, angle=0.2, load=110.0)
    assert stepper.current.time == 0.0
    assert astuple(stepper.advance(time=0.1, angle=0.2, load=110.0)) == astuple(tried)


def test_a_pickled_history_continues():
    """The unpickled history has the same mesh, which was chosen for the first load, and the same options."""
    mat = vr.CoatedPlane(layers=BALL.layers)
    first = vr.RollingHistory(
        vr.CoatedSphere(core_radius=21e-3), on=mat, load=80.0, averaged_meshes=1, steps_per_spacing=2
    )
    first.advance(time=0.1, distance=4e-3, load=100.0)
    second = pickle.loads(pickle.dumps(first))
    assert astuple(second.current)[:3] == astuple(first.current)[:3]
    assert (second.mesh, second.steps, second.on) == (first.mesh, first.steps, mat)
    ends = [stepper.advance(time=0.15, distance=3e-3, load=90.0) for stepper in (first, second)]
    np.testing.assert_array_equal(astuple(ends[0]), astuple(ends[1]))
    assert first.steps == second.steps


def test_resume_from_a_file(tmp_path):
    def motion(**options):
        return vr.roll(BALL, time=[0, 0.1, 0.1, 0.3], angle=[0, 0.2, 0.2, 0.6], load=[100, 100, 120, 140], mesh=COARSE,
                       averaged_meshes=2, **options)  # fmt: skip

    whole = motion()
    path = tmp_path / "ball.state"
    stepper = vr.RollingHistory(BALL, load=100.0, mesh=COARSE, averaged_meshes=2)
    stepper.advance(time=0.1, angle=0.2, load=100.0)
    stepper.state.save(path)
    rest = motion(start=vr.RollingState.load(path))
    assert rest.time[0] == 0.1
    assert rest.resisting_torque[-1] == whole.resisting_torque[-1]
    assert rest.dissipated_energy[-1] == whole.dissipated_energy[-1]


def test_a_displacement_that_is_a_sum_is_not_repeated_after_an_interruption():
    """The stored displacement of the center is a sum over the steps, which may differ in its last digit."""
    rubber = vr.StandardLinearSolid(
        instantaneous_modulus=12318.57, relaxed_modulus=3278.575, relaxation_time=0.08608771
    )
    ball = vr.CoatedSphere(core_radius=0.004830962130925986)
    coating = vr.Layer(thickness=0.0013036386, shear_modulus=rubber, poisson_ratio=-0.637)
    given = {
        "on": vr.Groove(path_radius=-0.04989456115642726, layers=[coating]),
        "time": [0.0, 0.033612242649761516, 0.06951770577952446, 0.08246789992721505],
        "angle": [0.0, 0.32466043447968984, 0.01101571503167964, 0.0907112678916267],
        "load": [1.4855840681168245e-3] * 3 + [1.2099963734308686e-3],
        "center_displacement": [0.0, 0.0016378051101923643, 5.557065923422956e-05, 0.00045760851131439255],
        "friction": 0.55,
        "mesh": vr.Mesh(nodes_per_revolution=102),
        "averaged_meshes": 1,
        "steps_per_spacing": 2,
    }
    series = ("time", "angle", "load", "center_displacement")
    first = vr.roll(ball, **given | {name: given[name][:3] for name in series})
    assert first.center_displacement[-1] != given["center_displacement"][2]  # otherwise the test proves nothing
    rest = vr.roll(ball, **given | {"start": first.state})
    whole = vr.roll(ball, **given)
    np.testing.assert_array_equal(rest.time, whole.time[-len(rest.time) :])
    np.testing.assert_array_equal(rest.resisting_torque, whole.resisting_torque[-len(rest.time) :])


def test_an_interrupted_run_leaves_a_checkpoint(tmp_path):
    def stop(stage: str, fraction: float) -> None:
        if stage == "rolling" and fraction > 0.3:
            raise KeyboardInterrupt

    given = {"time": [0, 20.0], "angle": [0, 50.0], "load": 100.0, "mesh": COARSE, "averaged_meshes": 1}
    path = tmp_path / "ball.state"
    with pytest.raises(KeyboardInterrupt):
        vr.roll(BALL, **given, checkpoint=path, progress=stop)
    rest = vr.roll(BALL, **given, start=vr.RollingState.load(path))
    whole = vr.roll(BALL, **given)
    assert 0.0 < rest.time[0] < 20.0
    assert rest.resisting_torque[-1] == whole.resisting_torque[-1]


def test_a_state_of_another_ball_is_refused():
    state = vr.RollingHistory(BALL, load=100.0, mesh=COARSE, averaged_meshes=1).state
    other = coated_ball(vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=1.0))
    with pytest.raises(ValueError, match="start must be a state of the same materials"):
        vr.RollingHistory(other, load=100.0, mesh=COARSE, averaged_meshes=1, start=state)
    with pytest.raises(ValueError, match="start must be a state of the same bodies and mesh"):
        vr.RollingHistory(BALL, load=100.0, mesh=vr.Mesh(nodes_per_revolution=120), averaged_meshes=1, start=state)
    with pytest.raises(ValueError, match="the same number of averaged meshes"):
        vr.RollingHistory(BALL, load=100.0, mesh=COARSE, averaged_meshes=2, start=state)
    with pytest.raises(ValueError, match="start must be a state of a rolling history"):
        vr.RollingHistory(BALL, load=100.0, mesh=COARSE, averaged_meshes=1, start=vr.RollingState(state.numbers[:100]))


def test_a_state_continues_under_a_load_that_cannot_be_supported_permanently():
    """Material that almost flows cannot support this load permanently, but a brief history continues from its state."""
    putty = vr.materials.FractionalZener(
        instantaneous_modulus=1e7, relaxed_modulus=5e3, relaxation_time=100.0, order=0.5
    )
    ball = vr.CoatedSphere(core_radius=2e-3, layers=[vr.Layer(thickness=1e-3, shear_modulus=putty, poisson_ratio=0.3)])
    given = {"load": 0.3, "mesh": vr.Mesh(nodes_per_revolution=100), "averaged_meshes": 1, "longest_time": 1e3}
    with pytest.raises(ValueError, match="load must be small enough for the coating"):
        vr.RollingHistory(ball, **given)
    undeformed = vr.RollingHistory(ball, **given, start="undeformed")
    undeformed.advance(time=1e-3, angle=0.05, load=0.3)
    others = [vr.RollingHistory(ball, **given, start=undeformed.state), pickle.loads(pickle.dumps(undeformed))]
    expected = astuple(undeformed.advance(time=2e-3, angle=0.1, load=0.25))
    for other in others:
        np.testing.assert_array_equal(astuple(other.advance(time=2e-3, angle=0.1, load=0.25)), expected)


@pytest.mark.parametrize("on", [None, vr.CoatedPlane(layers=BALL.layers)], ids=["ball", "mat"])
@pytest.mark.parametrize("wrong", [np.nan, np.inf, -1.5, 1e9, 1e300])
def test_a_corrupted_state_is_refused_or_continues(wrong, on):
    """If any number of a state is wrong, the state is refused or continues; the program does not crash."""
    body = BALL if on is None else vr.CoatedSphere(core_radius=21e-3)
    given = {"on": on, "load": 100.0, "mesh": vr.Mesh(nodes_per_revolution=60), "averaged_meshes": 1}
    stepper = vr.RollingHistory(body, **given)
    stepper.advance(time=0.01, angle=0.02, load=100.0)
    numbers = stepper.state.numbers
    whole = np.flatnonzero(numbers == np.floor(numbers))  # counts, node positions, and zeros
    refused = 0
    for place in [*range(60), *whole[-40:]]:
        corrupted = numbers.copy()
        corrupted[place] = wrong
        try:
            other = vr.RollingHistory(body, **given, start=vr.RollingState(corrupted))
            other.advance(time=other.current.time + 0.01, angle=other.current.angle + 0.02, load=100.0)
        except (ValueError, vr.ConvergenceError):
            refused += 1
    # Of 100 states. One number that is not finite is allowed: the half-width of the contact may be NaN.
    assert refused >= (99 if not np.isfinite(wrong) else 10)


@pytest.mark.parametrize(
    ("numbers", "error", "message"),
    [
        ("none", TypeError, "numbers must contain real numbers"),
        ([[1.0, 2.0]], ValueError, "numbers must be one-dimensional"),
    ],
)
def test_a_state_requires_a_one_dimensional_array_of_numbers(numbers, error, message):
    with pytest.raises(error, match=message):
        vr.RollingState(numbers)
