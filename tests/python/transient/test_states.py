"""Files of saved states: damaged files, other versions, and states of other bodies are refused."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll import paper
from viscoroll.case import example_text

BALL = paper.ball(density=0.0)
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
