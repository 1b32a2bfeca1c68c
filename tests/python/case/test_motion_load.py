"""A motion without a load uses that of the table `rolling` in the same file."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll.case import example_text
from viscoroll.case.motion import load_motion

ROLLING = '\n[rolling]\nload = "0.12 kN"\nangular_speed = 2.5\n'


@pytest.fixture
def motion_file(tmp_path):
    def write(text, rolling=ROLLING):
        path = tmp_path / "motion.toml"
        path.write_text(text + rolling, encoding="utf-8")
        return path

    return write


def without_load():
    text = example_text("motion")
    row = next(row for row in text.splitlines() if row.startswith("load = "))
    return text.replace(row, "")


def test_waypoints_have_the_load_of_rolling(motion_file):
    assert load_motion(motion_file(without_load())).load == 120.0
    assert load_motion(motion_file(example_text("motion"))).load == 100.0  # that of the motion
    with pytest.raises(vr.InvalidInput, match="motion must have load"):
        load_motion(motion_file(without_load(), rolling=""))


def test_oscillations_and_files_have_the_load_of_rolling(motion_file, tmp_path):
    bodies = example_text("motion").partition("time = [")[0]
    assert load_motion(motion_file(bodies + "amplitude = 0.1\nfrequency = 1.0\n")).load == 120.0
    (tmp_path / "path.csv").write_text("time,angle\n0,0\n1,1\n", encoding="utf-8")
    assert load_motion(motion_file(bodies + 'file = "path.csv"\n')).load == 120.0
    (tmp_path / "path.csv").write_text("time,angle,load\n0,0,50\n1,1,60\n", encoding="utf-8")
    assert np.array_equal(load_motion(motion_file(bodies + 'file = "path.csv"\n')).load, [50.0, 60.0])


def test_wrong_loads_of_rolling_are_named(motion_file):
    with pytest.raises(vr.InvalidInput, match=r"rolling.load must be a force \[N\], got '3 mm'"):
        load_motion(motion_file(without_load(), ROLLING.replace("0.12 kN", "3 mm")))


def test_the_command_names_the_unused_part_of_the_table(motion_file):
    path = motion_file(without_load())
    done = command("roll", path)
    assert done.returncode == 0, done.stderr
    assert "[rolling] is for `viscoroll solve`, except the load if [motion] has none" in done.stderr
