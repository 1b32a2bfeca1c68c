"""A subset of the tests with damaged files, and whether these tests detect errors."""

from __future__ import annotations

import numpy as np
import pytest
from campaign.files import judging, mutations, states
from campaign.files.kinds import KINDS
from campaign.files.running import draw, run_case

SEED = 1


@pytest.mark.parametrize("kind", KINDS)
def test_slice(kind):
    """Test fifteen files of each kind."""
    kinds = list(KINDS)
    first = kinds.index(kind)
    for number in range(first, first + 15 * len(kinds), len(kinds)):
        outcome = run_case(draw(SEED, number))
        assert not outcome.failed, outcome


def test_seed_and_number_determine_the_file():
    assert draw(1, 7) == draw(1, 7)
    assert len({draw(seed, number).seed for seed in (1, 2) for number in range(25)}) == 50


def test_all_mutations_change_files_of_all_sizes():
    random = mutations.Random(0)
    for content in (b"", b"1", b"a = 1\nb = [2.0, 3.0]\n" * 20):
        changed = [mutations.mutated(content, random) for _ in range(200)]
        assert sum(new != content for new in changed) > 100


def refused(message, kind=ValueError):
    def read(path):
        raise kind(message.format(path=path))

    return read


@pytest.mark.parametrize(
    ("read", "failure"),
    [
        (lambda path: {"loss": 1.0}, None),
        (lambda path: {"loss": np.array([1.0, np.inf])}, "read as inf: loss"),
        (lambda path: [][0], "uncaught IndexError"),
        (refused("deep", RecursionError), "uncaught RecursionError"),
        (refused("modulus must be > 0"), "message does not name the file"),
        (refused("{path}: modulus\nmust be > 0"), "message has several lines"),
        (refused("{path}: 'NoneType' object is not iterable"), "message has internal terms"),
        (refused("{path}: pass allow_pickle=True"), "message has internal terms"),
        (refused("{path}: modulus must be > 0 Pa, got -1"), None),
    ],
)
def test_readers_are_judged(tmp_path, read, failure):
    found = judging.reading_failure(read, tmp_path / "a.toml", judging.infinite)
    assert found == failure or found.startswith(failure)


def test_commands_are_judged(tmp_path, monkeypatch):
    assert judging.command_failure(("solve", tmp_path / "none.toml"), tmp_path) is None
    monkeypatch.setattr("viscoroll.case.load_case", lambda path, changes: [][0])
    assert judging.command_failure(("solve", tmp_path / "none.toml"), tmp_path).startswith(
        "solve raises IndexError in app.py:solve"
    )


def test_a_changed_state_is_detected(monkeypatch, tmp_path):
    monkeypatch.setattr(states, "reading_failure", lambda read, path, judge: judge(states.vr.RollingState([1.0])))
    assert states.check(1, tmp_path) == "numbers differ from the file"
