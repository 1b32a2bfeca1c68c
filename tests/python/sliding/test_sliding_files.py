"""Sliding files and the command `viscoroll slide`."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.case import example_text
from viscoroll.case.sliding import build_sliding, load_sliding

from tests.shared_cases import command

EXAMPLE = example_text("sliding").replace("nodes = 256", "nodes = 128").replace("0.03125e-3", "0.0625e-3")


def written(tmp_path, text):
    path = tmp_path / "sliding.toml"
    path.write_text(text, encoding="utf-8")
    return path


def assert_rejected(done, message):
    assert done.returncode == 2, done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert message in done.stderr


def test_the_example_gives_the_results_of_python(tmp_path):
    found = json.loads(command("slide", written(tmp_path, EXAMPLE), "--json").stdout)
    surface = vr.RoughSurface.self_affine(
        128, 1e-3, hurst=0.8, rolloff=0.25e-3, cutoff=0.0625e-3, rms_slope=0.1, seed=1
    )
    rubber = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
    on = vr.HalfSpace(shear_modulus=rubber, poisson_ratio=0.5)
    assert [entry["speed"] for entry in found] == [1e-4, 1e-3, 1e-2]
    r = vr.slide(surface, on=on, pressure=20e3, speed=1e-3)
    numbers = {name: found[1][name] for name in r.units}
    assert numbers == pytest.approx({name: r.scalars()[name] for name in r.units}, rel=1e-9)
    assert [found[1]["status"], found[1]["warnings"]] == ["CONVERGED", ""]


def test_a_measured_surface_is_read_and_solved_in_one_command(tmp_path):
    rng = np.random.default_rng(5)
    heights = 1e-6 * rng.standard_normal((40, 30)) + 1e-5 * np.arange(40)[:, np.newaxis]
    np.savetxt(tmp_path / "asphalt.csv", heights, delimiter=",")
    head, tail = EXAMPLE.split("[surface]")
    plane = tail.split("[plane.base]")[1].replace("speed = [1e-4, 1e-3, 1e-2]", 'speed = "1 mm/s"')
    table = 'file = "asphalt.csv"\nspacing = "2 µm"\ndetrend = 1\ncutoff = "20 µm"\n'
    path = written(tmp_path, f"{head}[surface]\n{table}[plane.base]{plane}")
    done = command("slide", path, "--save", tmp_path / "out.csv", "--plot", tmp_path / "out.png")
    assert done.stdout.startswith("Sliding at 0.001 m/s under a mean pressure of 20000 Pa")
    case = load_sliding(path)
    assert case.surface.heights.shape == (80, 60)
    assert case.surface.periodic
    assert case.surface.spacing == (2e-6, 2e-6)
    (row,) = csv.DictReader((tmp_path / "out.csv").read_text(encoding="utf-8").splitlines())
    (result,) = case.slide()
    assert float(row["friction_coefficient [1]"]) == pytest.approx(result.friction_coefficient)
    assert (tmp_path / "out.png").stat().st_size > 1000


def test_a_finite_surface_with_friction(tmp_path):
    x = np.linspace(-1e-3, 1e-3, 41)
    np.save(tmp_path / "pin.npy", -(x[:, np.newaxis] ** 2 + x**2) / 0.01)
    head, tail = EXAMPLE.split("[surface]")
    plane = tail.split("[plane.base]")[1].replace("pressure = 20e3", "load = 0.05\nfriction = 0.5")
    table = 'file = "pin.npy"\nspacing = "50 µm"\nfinite = true\n'
    path = written(tmp_path, f"{head}[surface]\n{table}[plane.base]{plane}")
    case = load_sliding(path)
    assert not case.surface.periodic
    assert case.friction == 0.5
    found = json.loads(command("slide", path, "--json").stdout)
    (_, result, _) = case.slide()
    assert found[1]["total_friction_coefficient"] == pytest.approx(result.total_friction_coefficient, rel=1e-9)
    assert found[1]["persson_friction"] is None


def test_several_speeds_are_a_table(tmp_path):
    lines = command("slide", written(tmp_path, EXAMPLE)).stdout.splitlines()
    assert len(lines) == 5
    assert lines[1].split()[:3] == ["speed", "[m/s]", "friction"]


def test_files_are_checked(tmp_path):
    path = written(tmp_path, EXAMPLE)
    assert command("check", path).stdout.endswith("valid for `viscoroll slide`\n")
    assert command("example", "--sliding").stdout == example_text("sliding")


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ("pressure = 20e3", "pressure = 20e3\nload = 1.0", "sliding must have exactly one of pressure and load"),
        ("seed = 1", "", "surface.seed must be given without file"),
        ("seed = 1", "seed = -1", "surface.seed must be >= 0, got -1"),
        ("rms_slope = 0.1", "", "surface must have exactly one of rms_slope and rms_height without file"),
        ("rms_slope = 0.1", "rms_slope = 0.1\ndetrend = 1", "surface.detrend must be left out without file"),
        ("rms_slope = 0.1", "rms_slope = 0.1\nfinite = true", "surface.finite must be left out without file"),
        ("seed = 1", 'seed = 1\nfile = "a.npy"', "surface.nodes must be left out with file"),
        ("pressure = 20e3", "pressure = 20e3\nfriction = -1.0", "friction must be >= 0, got -1"),
        ("speed = [1e-4, 1e-3, 1e-2]", "speed = []", "sliding.speed must have at least one speed, got []"),
        ("hurst = 0.8", "hurts = 0.8", "surface.hurts is not a parameter"),
        ("[plane.base]", "[plate.base]", "plate is not a parameter"),
    ],
)
def test_messages(tmp_path, before, after, message):
    assert before in EXAMPLE
    assert_rejected(command("slide", written(tmp_path, EXAMPLE.replace(before, after, 1))), message)


def test_tables_without_a_folder_read_no_file():
    with pytest.raises(vr.InvalidInput, match="file must be left out here"):
        build_sliding(
            {"surface": {"file": "a.npy"}, "plane": {"layers": []}, "sliding": {"pressure": 1.0, "speed": 1.0}}, None
        )
