"""The tables ground, tread and axle of motion files."""

from __future__ import annotations

import csv
import tomllib

import numpy as np
import pytest
import viscoroll as vr
from PIL import Image
from shared_cases import command, few_pictures
from viscoroll.case import example_text
from viscoroll.case.motion import build_motion, load_motion

MOTION = tomllib.loads(example_text("motion"))


def motion_with(**tables):
    return build_motion(MOTION | tables, None).options


@pytest.mark.parametrize(
    ("table", "profile"),
    [
        ({"type": "step", "height": 5e-4, "at": 0.01}, vr.Profile.step(5e-4, at=0.01)),
        (
            {"type": "half_sine", "height": 2e-4, "length": 6e-3, "at": 0.01},
            vr.Profile.half_sine(2e-4, length=6e-3, at=0.01),
        ),
        (
            {"type": "half_sine", "height": "0.2 mm", "length": "6 mm", "at": "10 mm"},
            vr.Profile.half_sine(2e-4, length=6e-3, at=0.01),
        ),
        ({"type": "joint", "depth": 1e-3, "width": 3e-3, "at": 0.01}, vr.Profile.joint(1e-3, width=3e-3, at=0.01)),
        ({"type": "corrugation", "amplitude": 1e-4, "period": 0.012}, vr.Profile.corrugation(1e-4, period=0.012)),
        (
            {"type": "points", "distance": ["0 mm", "10 mm"], "height": [0.0, 1e-4], "periodic": True},
            vr.Profile([0.0, 0.01], [0.0, 1e-4], periodic=True),
        ),
    ],
)
def test_each_type_is_the_profile_of_python(table, profile):
    assert motion_with(ground=table)["ground"] == profile
    assert motion_with(tread=table)["tread"] == profile


def test_a_file_beside_the_motion(tmp_path):
    (tmp_path / "floor.csv").write_text("distance,height\n0,0\n0.01,1e-4\n")
    (tmp_path / "motion.toml").write_text(example_text("motion") + '[ground]\ntype = "file"\nfile = "floor.csv"\n')
    assert load_motion(tmp_path / "motion.toml").options["ground"] == vr.Profile([0.0, 0.01], [0.0, 1e-4])
    (tmp_path / "floor.csv").unlink()
    with pytest.raises(ValueError, match=r"profile .*floor\.csv: No such file or directory"):
        load_motion(tmp_path / "motion.toml")


def test_axle_of_a_ball_and_of_a_roller():
    axle = {"mass": "2 kg", "stiffness": "3 N/mm", "damping": 4.0}
    assert motion_with(axle=axle)["axle"] == vr.Axle(mass=2.0, stiffness=3e3, damping=4.0)
    roller = {name: table for name, table in MOTION.items() if name != "ball"} | {"cylinder": MOTION["ball"]}
    per_length = {"mass": "2 kg/m", "stiffness": "3 MPa", "damping": "4 N s/m^2"}
    found = build_motion(roller | {"axle": per_length}, None).options["axle"]
    assert found == vr.Axle(mass=2.0, stiffness=3e6, damping=4.0)


def test_files_without_tables_are_smooth():
    options = motion_with()
    assert [options[name] for name in ("ground", "tread", "axle")] == [None, None, None]


def test_the_commented_tables_are_valid():
    head, _, table = example_text("motion").partition("# [ground]\n")
    lines = [line.removeprefix("# ") for line in ("[ground]\n" + table).splitlines()]
    commented = tomllib.loads("\n".join(lines[: lines.index("[tread]") - 1]))
    assert commented == {"ground": {"type": "half_sine", "height": 0.2e-3, "length": 6e-3, "at": 10e-3}}
    after = "\n".join(lines[lines.index("[axle]") :]).partition("[numerics]")[0]
    assert motion_with(**commented, **tomllib.loads(after))["axle"] == vr.Axle(mass=2.0)
    assert "[ground]" not in head


@pytest.mark.parametrize(
    ("tables", "message"),
    [
        (
            {"ground": {"type": "pebble"}},
            "ground.type must be one of points, file, step, half_sine, joint, corrugation",
        ),
        ({"ground": {"type": "step", "height": 1e-3}}, "ground.at must be given for the type step"),
        ({"ground": {"type": "step", "height": "1 kg", "at": 0.0}}, r"ground\.height must be a length \[m\]"),
        ({"ground": {"type": "half_sine", "height": 1e-3, "length": -1.0, "at": 0.0}}, r"ground\.length must be > 0 m"),
        ({"axle": {"mass": -1.0}}, r"axle\.mass must be"),
        ({"axle": {"weight": 1.0}}, r"axle\.weight is not a parameter"),
    ],
)
def test_messages(tables, message):
    with pytest.raises(vr.InvalidInput, match=message):
        motion_with(**tables)


def test_the_command_rolls_over_a_bump(tmp_path):
    """The command saves the history of Python, draws it over the ground and writes an animation of 6 s."""
    text = example_text("motion").replace("time = [0.0, 0.4, 1.0, 1.4, 1.8]", "time = [0.0, 0.4]")
    text = text.replace("angle = [0.0, 1.0, 1.0, 2.0, 1.0]", "angle = [0.0, 0.6]")
    path, out = tmp_path / "motion.toml", tmp_path / "history.csv"
    path.write_text(text + '[ground]\ntype = "half_sine"\nheight = "0.1 mm"\nlength = "6 mm"\nat = "6 mm"\n')
    with few_pictures() as requested:
        done = command("roll", path, "--save", out, "--plot", tmp_path / "a.svg", "--animate", tmp_path / "a.gif")
    assert done.returncode == 0, done.stderr
    bump = vr.Profile.half_sine(1e-4, length=6e-3, at=6e-3)
    h = load_motion(path).roll()
    assert h.ground == bump
    header, *rows = list(csv.reader(out.read_text().splitlines()))
    column = next(number for number, name in enumerate(header) if name.startswith("penetration"))
    np.testing.assert_array_equal([float(row[column]) for row in rows], h.penetration)
    assert h.penetration.min() < h.penetration[0] - 0.5e-4
    assert "push force" in (tmp_path / "a.svg").read_text() or (tmp_path / "a.svg").stat().st_size > 10_000
    assert requested == [120]
    with Image.open(tmp_path / "a.gif") as picture:
        assert (picture.format, picture.n_frames, picture.info["duration"]) == ("GIF", 2, 50)  # ms


def test_the_command_rejects_other_formats_of_animations(tmp_path):
    path = tmp_path / "motion.toml"
    path.write_text(example_text("motion"), encoding="utf-8")
    assert "must end in .gif or .mp4" in command("roll", path, "--animate", tmp_path / "a.png").stderr


def test_solve_skips_the_tables_of_a_motion(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(example_text() + '[ground]\ntype = "step"\nheight = 1e-4\nat = 0.01\n')
    assert "[ground] is for `viscoroll roll`" in command("solve", path).stderr
