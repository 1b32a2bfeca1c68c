"""Validation without a solve, values given by --set, and several cases side by side."""

from __future__ import annotations

import json

import pytest
from shared_cases import command
from viscoroll.case import example_text, load_case
from viscoroll.solution.text import scalar_text

COARSE = example_text().replace("accuracy = 0.01", "accuracy = 0.3")


@pytest.fixture
def file(tmp_path):
    def write(text=COARSE, name="case"):
        path = tmp_path / f"{name}.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_valid_files_name_their_commands(file):
    done = command("check", file(COARSE + example_text("sweep") + example_text("design")))
    assert done.returncode == 0
    assert done.stdout.endswith("valid for `viscoroll solve`, `viscoroll sweep`, `viscoroll design`\n")
    assert command("check", file(example_text("motion"))).stdout.endswith("valid for `viscoroll roll`\n")


def test_all_errors_are_listed(file):
    text = COARSE.replace("thickness = 1e-3", 'thickness = "1 MPa"').replace("load = 100.0", "load = true")
    text = text.replace("core_radius = 20e-3", 'core_radius = "1 s"\ncolor = 3')
    done = command("check", file(text), file(name="other"))
    assert done.returncode == 2
    messages = [line.partition("case.toml: ")[2] for line in done.stderr.splitlines()]
    assert messages == [
        "ball.core_radius must be a length [m], got '1 s'",
        "ball.layers[0].thickness must be a length [m], got '1 MPa'",
        "ball.color is not a parameter, got 3",
        "rolling.load must be a valid number, got True",
    ]
    assert "other.toml: valid for" in done.stdout


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("rolling.load=-5", "load must be > 0 N, got -5"),
        ("rolling.load=1 MPa", "rolling.load must be a force [N], got '1 MPa'"),
        ("rolling.lod=5", "rolling.lod is not a parameter, got 5"),
        ("ball.core_radius=20", "ball.core_radius must be at most 1.5 m"),
        ("ball.layers[3].thickness=1", '--set: the file has no key "ball.layers[3].thickness"'),
        ("rolling.load=1,5 kN", "rolling.load must be a force [N], got '1,5 kN'; write a decimal point"),
        ("rolling.load=5 kgs", "the unit 'kgs' is not known; use for example N, kN, kgf, lbf"),
        ("ball.layers[0].shear_modulus=70 Shore A", 'a hardness is a table: { type = "hardness", hardness = 70 }'),
        (
            "ball.shear_modulus=9 MPa",
            "ball.shear_modulus is not a parameter, got '9 MPa'; did you mean ball.layers[0].",
        ),
        ("ball.width=2 mm", "ball.width is not a parameter, got '2 mm'"),
        ("ball.layers[0].youngs_modulus=5", "did you mean shear_modulus = E / (2 (1 + nu))?"),
        ("ball.diameter=42 mm", "did you mean outer_diameter?"),
        ("load=5 N", "load is not a parameter, got '5 N'; did you mean rolling.load?"),
        ("numerics.allow_large=true", "did you mean allow_large, at the beginning of the file?"),
        ("rolling", "--set must have the form KEY=VALUE, such as rolling.load=500, got 'rolling'"),
        ("rolling.angular_speed=0", "angular_speed must be"),
    ],
)
def test_values_are_checked_without_a_solve(file, change, message):
    done = command("check", file(), "--set", change)
    assert done.returncode == 2
    assert message in done.stderr
    assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("thermal.ambient=23", "thermal.ambient must be >= 100 K (20 °C are 293.15 K), got 23 K"),
        ("thermal.ambient=23 degrees", 'write "degC" for degrees Celsius'),
        ("thermal.convecton=5", "did you mean convection or side_convection?"),
    ],
)
def test_tables_of_temperature_are_checked(file, change, message):
    text = COARSE + "\n[thermal]\nconvection = 10.0\nambient = 293.15\nconductivity = 0.2\n"
    done = command("check", file(text), "--set", change)
    assert done.returncode == 2
    assert message in done.stderr


def test_values_replace_those_of_the_file(file):
    path = file()
    changes = ("--set", "rolling.load=5 kgf", "--set", "numerics.accuracy=0.2", "--set", "rolling.speed=36 km/h")
    scalars = json.loads(command("solve", path, "--json", *changes).stdout)
    assert scalars["load"] == pytest.approx(49.03325, rel=1e-14)
    case = load_case(path, {"rolling.speed": "36 km/h", "ball.outer_diameter": "50 mm"})
    assert (case.speed, case.body.outer_radius) == (10.0, 0.025)
    assert case.angular_speed == pytest.approx(400.0, rel=1e-14)


def test_several_cases_are_printed_side_by_side(file, tmp_path):
    pytest.importorskip("matplotlib")
    paths = [file(name="one"), file(name="two")]
    picture = tmp_path / "both.png"
    done = command("solve", *paths, "--plot", picture)
    assert done.returncode == 0, done.stderr
    rows = [
        [cell.strip() for cell in line.strip("│┃").replace("┃", "│").split("│")] for line in done.stdout.splitlines()
    ]
    assert ["", "one", "two"] in rows
    assert rows[3][0] == "push force"  # the answer comes first
    row = next(row for row in rows if row[0] == "resisting torque T_r")
    result = load_case(paths[0]).solve()
    assert row[1] == row[2] == scalar_text(result, "resisting_torque")
    alone = json.loads(command("solve", paths[0], "--json").stdout)["resisting_torque"]
    assert alone == result.resisting_torque
    assert picture.stat().st_size > 1000
    both = json.loads(command("solve", *paths, "--json").stdout)
    assert both["one"]["resisting_torque"] == both["two"]["resisting_torque"] == alone


def test_options_of_a_single_case_are_rejected_with_several(file, tmp_path):
    done = command("solve", file(name="one"), file(name="two"), "--save", tmp_path / "fields.csv")
    assert done.returncode == 2
    assert "--save must be left out with several case files" in done.stderr
    assert "must be different files" in command("solve", file(), file()).stderr


def test_rollers_and_balls_side_by_side_have_their_own_units(file):
    roller = (
        "[cylinder]\ncore_radius = 0.04\n[[cylinder.layers]]\nthickness = 5e-3\nshear_modulus = 1e6\n"
        "poisson_ratio = 0.5\n[rolling]\nload = 2e3\nangular_speed = 10.0\n[numerics]\naccuracy = 0.3\n"
    )
    done = command("solve", file(), file(roller, name="roller"))
    assert done.returncode == 0, done.stderr
    assert "2 kN/m" in done.stdout
    assert "100 N" in done.stdout
