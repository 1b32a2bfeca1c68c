"""Studies from files and from the command line: varied parameters, pictures, and input checks."""

from __future__ import annotations

import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import viscoroll as vr
import xarray
from shared_cases import command
from viscoroll.case import example_text
from viscoroll.case.study import load_study
from viscoroll.studies.study import run_plan

NUMERICS = "accuracy = 0.01"
COARSE = "nodes_per_revolution = 100\nmax_order = 50"


@pytest.fixture
def study_file(tmp_path):
    def write(sweep, numerics=COARSE):
        path = tmp_path / "study.toml"
        text = example_text().replace(NUMERICS, numerics) + "\n[sweep]\n" + sweep
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_a_file_gives_the_same_study_as_python(study_file):
    path = study_file(
        '"ball.layers[0].thickness" = { from = 1e-3, to = 4e-3, count = 3, scale = "log" }\n'
        '"rolling.friction" = [0.0, 0.1]\n"rolling.load" = { from = 20, to = 60, count = 2 }'
    )
    study = run_plan(load_study(path), progress=False)
    same = vr.sweep(
        vr.paper.ball,
        thickness=np.geomspace(1e-3, 4e-3, 3),
        friction=[0.0, 0.1],
        load=[20.0, 60.0],
        angular_speed=2.5,
        mesh=vr.Mesh(nodes_per_revolution=100, max_order=50),
        progress=False,
    )
    xarray.testing.assert_equal(study[list(same.data_vars)], same)
    assert {name: study[name].attrs["units"] for name in study.indexes} == {
        "thickness": "m",
        "friction": "1",
        "load": "N",
    }
    assert study.angular_speed == 2.5


def test_any_number_can_vary(study_file):
    path = study_file(
        '"ball.layers[0].shear_modulus.relaxation_time" = [0.1, 0.2]\n"rolling.drive.creepage" = [0.0, 1e-3]\n'
        '"numerics.nodes_per_revolution" = { from = 80, to = 100, count = 2 }'
    )
    study = run_plan(load_study(path), progress=False)
    assert study.resisting_torque.dims == ("relaxation_time", "creepage", "nodes_per_revolution")
    assert study.relaxation_time.attrs["units"] == "s"
    assert study.nodes_per_revolution.values.tolist() == [80, 100]
    assert not study.resisting_torque.isnull().any()
    assert "creepage" not in study.data_vars  # an input, not a result


def test_an_angular_speed_replaces_the_speed_of_the_file(study_file):
    path = study_file('"rolling.angular_speed" = [1.0, 4.0]')
    by_angle = run_plan(load_study(path), progress=False)
    path.write_text(path.read_text(encoding="utf-8").replace("angular_speed = 2.5", "speed = 0.05"), encoding="utf-8")
    by_speed = run_plan(load_study(path), progress=False)
    xarray.testing.assert_equal(by_speed["resisting_torque"], by_angle["resisting_torque"])


def test_parameters_of_the_same_name_get_distinct_names(study_file):
    text = study_file("").read_text(encoding="utf-8")
    layer = text[text.index("\n[[ball.layers]]") : text.index("[rolling]")]
    path = study_file('"ball.layers[0].thickness" = [1e-3]\n"ball.layers[1].thickness" = [1e-3, 2e-3]')
    path.write_text(path.read_text(encoding="utf-8").replace("[rolling]", layer + "[rolling]"), encoding="utf-8")
    plan = load_study(path)
    assert [(d.name, d.unit) for d in plan.dimensions] == [("layers_0_thickness", "m"), ("layers_1_thickness", "m")]
    assert [ball.thickness for ball in plan.bodies()] == [2e-3, 3e-3]


def test_sweep_and_plot_on_the_command_line(study_file, tmp_path):
    path = study_file('"rolling.load" = [20.0, 50.0, 1e9]\n"ball.layers[0].thickness" = [1e-3, 2e-3]')
    done = command("sweep", path)
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"6 points (3 load x 2 thickness), 2 failed: {tmp_path / 'study.nc'}\n"
    assert (
        "warning: a point failed: InvalidInput: load must be small enough for the coating, got 1e+09 N" in done.stderr
    )
    assert command("sweep", path, "--output", tmp_path / "study.nc").stdout == done.stdout
    done = command("plot", tmp_path / "study.nc")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "study.png").read_bytes().startswith(b"\x89PNG")
    done = command("plot", tmp_path / "study.nc", "--variable", "heat")
    assert done.returncode == 2
    assert "variable must be one of rolling_resistance_force, finite_strain_torque, " in done.stderr
    path.write_text(path.read_text(encoding="utf-8").replace("50.0, 1e9", "50.0, 60.0"), encoding="utf-8")
    done = command("sweep", path, "--retry-failed")
    assert done.stdout == f"6 points (3 load x 2 thickness), 0 failed: {tmp_path / 'study.nc'}\n"
    with xarray.open_dataset(tmp_path / "study.nc") as study:
        assert study["load"].values.tolist() == [20.0, 50.0, 60.0]
    content = (tmp_path / "study.nc").read_bytes()
    for damaged in (content[:-1], content + b"\0", content[:9000] + b"x" + content[9001:], b""):  # HDF5 may crash
        (tmp_path / "study.nc").write_bytes(damaged)
        done = command("plot", tmp_path / "study.nc")
        assert done.returncode == 2
        assert (
            f"{tmp_path / 'study.nc'} must be a study file of viscoroll, got a file without a valid checksum"
            in done.stderr
        )


def test_ctrl_c_on_the_command_line_says_how_to_resume(study_file, tmp_path):
    # Each point would take hours: if the command ends at all, it has stopped.
    path = study_file('"rolling.load" = [90.0, 100.0]', numerics="nodes_per_revolution = 20000\nmax_order = 30000")
    with subprocess.Popen(
        [sys.executable, "-m", "viscoroll", "sweep", str(path)], stderr=subprocess.PIPE, text=True
    ) as process:
        while process.poll() is None and not (tmp_path / "study.nc.points").exists():
            time.sleep(0.01)
        # After this time the first solves run; an interrupt before them would also pass.
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        _, message = process.communicate(timeout=60)
    assert process.returncode == 130
    assert message == f"viscoroll: stopped; run the same command again to resume from {tmp_path / 'study.nc.points'}\n"


def test_the_example_is_a_study(tmp_path):
    done = command("example", "--sweep")
    assert done.stdout == example_text() + example_text("sweep")
    path = tmp_path / "study.toml"
    path.write_text(done.stdout, encoding="utf-8")
    assert load_study(path).shape == (4, 3)


@pytest.mark.parametrize(
    ("sweep", "message"),
    [
        ("", 'sweep must be a table of parameters with their values, such as "rolling.load"'),
        ('"rolling.load" = 3.0', "must be a list of numbers or a table with from, to and count, got 3.0"),
        ('"rolling.load" = ["a"]', "must be a list of numbers or a table with from, to and count"),
        ('"rolling.load" = []', "load must have at least one value, got none"),
        ('"rolling load" = [1.0]', 'keys must be paths like "ball.layers[0].thickness", got '),
        ("rolling.load = [1.0]", 'sweep.rolling: the whole path must be in quotes, as in "rolling.load"'),
        ('"rolling.laod" = [1.0]', "rolling.laod is not a parameter, got 1.0"),
        ('"ball.layers[1].thickness" = [1.0]', 'the file has no key "ball.layers[1].thickness"'),
        ('"rolling.load" = { from = 1, to = 2 }', 'sweep."rolling.load".count must be given'),
        ('"rolling.load" = { from = 1, to = 2, count = 1 }', "count must be greater than or equal to 2"),
        (
            '"rolling.load" = { from = 0, to = 2, count = 3, scale = "log" }',
            "from and to must be > 0 for a log scale",
        ),
    ],
)
def test_bad_files_have_messages_of_one_line(study_file, sweep, message):
    with pytest.raises(ValueError, match=r"study.toml: ") as raised:
        load_study(study_file(sweep))
    assert message in str(raised.value)
    assert "\n" not in str(raised.value)


def test_points_of_the_same_bodies_share_their_tables(tmp_path):
    path = tmp_path / "study.toml"
    other = "[other_ball]\ncore_radius = 0.03\n[[other_ball.layers]]\nthickness = 1e-3\npoisson_ratio = 0.5\n"
    sweep = '[sweep]\n"rolling.load" = [20.0, 60.0]\n"other_ball.layers[0].thickness" = [1e-3, 2e-3]\n'
    path.write_text(f"{example_text()}\n{other}shear_modulus = 3e6\n{sweep}", encoding="utf-8")
    tasks = load_study(path).tasks(range(4), largest=10)
    assert [len(task.indices) for task in tasks] == [2, 2]
