"""Studies with too many points are rejected immediately, with the number of points and the limit."""

from __future__ import annotations

import time

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll import paper
from viscoroll.case import example_text

resource = pytest.importorskip("resource")

CASE = {"load": 1.0, "angular_speed": 2.5, "thickness": 1e-3, "progress": False}
MANY = np.linspace(1.0, 2.0, 10_000)


@pytest.fixture(autouse=True)
def at_once():
    """Fail if a test uses much memory or time."""
    before, start = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
    yield
    # The limit [kB] is about the size of a list of a million numbers.
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 100_000
    assert time.process_time() - start < 5.0


@pytest.mark.parametrize(
    ("varied", "count"),
    [
        ({"load": MANY, "angular_speed": MANY, "thickness": MANY}, "1000000000000 "),
        ({"load": range(1, 10**12 + 1)}, "1000000000000 "),
        ({"load": range(1, 10**40)}, "9223372036854775807 "),  # the largest length in Python
        ({"load": np.broadcast_to(1.0, (10**12,))}, "1000000000000 "),
        ({"load": range(1, 1002), "angular_speed": {f"{i}": 1.0 + i for i in range(1000)}}, "1001000 "),
        (dict.fromkeys(("load", "angular_speed", "friction", "max_iterations", *"abcdefgh"), MANY), "about 1e48 "),
    ],
)
def test_from_python(varied, count):
    def ball(thickness, **others):
        return paper.ball(thickness=thickness)

    varied = {k: v.astype(int) + np.arange(v.size) if k == "max_iterations" else v for k, v in varied.items()}
    with pytest.raises(ValueError, match=f"a study must have at most 1000000 points, got {count}"):
        vr.sweep(ball, **CASE | varied)


@pytest.mark.parametrize(
    ("table", "wanted"),
    [
        (
            f'"rolling.load" = {{ from = 1.0, to = 2.0, count = {10**12} }}',
            "count must be less than or equal to 1000000, got 1000000000000",
        ),
        (
            "\n".join(f'"rolling.{k}" = {{ from = 1, to = 2, count = 1000000 }}' for k in ("load", "angular_speed")),
            'a study must have at most 1000000 points, got 1000000000000 (1000000 of "rolling.load" x 1000000 of',
        ),
    ],
)
@pytest.mark.parametrize("words", [("sweep",), ("export", "--for", "yade")])
def test_from_files_and_the_shell(tmp_path, table, wanted, words):
    (tmp_path / "study.toml").write_text(f"{example_text('case')}\n[sweep]\n{table}\n")
    done = command(words[0], "study.toml", *words[1:], cwd=tmp_path)
    assert done.returncode == 2
    assert wanted in done.stderr
    assert [file.name for file in tmp_path.iterdir()] == ["study.toml"]


def test_speeds_of_a_comparison(tmp_path):
    (tmp_path / "case.toml").write_text(example_text("case"))
    done = command("compare", "case.toml", "--points", 10**12, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (
        2,
        "viscoroll: a study must have at most 1000000 points, got 1000000000000 (1000000000000 speeds)\n",
    )


def test_duplicate_values_are_found_fast():
    loads = [*np.linspace(1.0, 2.0, 200_000), 2.0]
    with pytest.raises(ValueError, match=r"load must have different values, got 2.0 twice"):
        vr.sweep(paper.ball, **CASE | {"load": loads})
