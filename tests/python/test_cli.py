"""The command line: solve, demo, example, and how it refuses."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.case import example_text, load_case


def run(*arguments, cwd=None):
    return subprocess.run(
        [sys.executable, "-m", "viscoroll", *map(str, arguments)], capture_output=True, text=True, cwd=cwd, check=False
    )


@pytest.fixture
def case_file(tmp_path):
    def write(text=None, **replacements):
        text = example_text() if text is None else text
        for old, new in replacements.items():
            line = next(row for row in text.splitlines() if row.startswith(f"{old} ="))
            text = text.replace(line, f"{old} = {new}")
        path = tmp_path / "case.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_solve_prints_a_table(case_file):
    done = run("solve", case_file(accuracy="0.1"))
    assert done.returncode == 0, done.stderr
    assert "resisting torque T_r" in done.stdout
    assert "CONVERGED" in done.stdout


def test_solve_prints_json_and_writes_files(case_file, tmp_path):
    path = case_file()
    mesh = "nodes_per_revolution = 300\nmax_order = 300"
    path.write_text(path.read_text().replace("accuracy = 0.01", mesh), encoding="utf-8")
    done = run("solve", path, "--json", "--plot", tmp_path / "contact.png", "--save", tmp_path / "fields.csv")
    assert done.returncode == 0, done.stderr
    case = load_case(path)
    expected = vr.solve(case.ball, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=300, max_order=300))
    assert json.loads(done.stdout) == expected.scalars()
    assert (tmp_path / "contact.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "fields.csv").read_text().startswith("x [m],z [m],pressure [Pa]")


def test_demo_compares_with_the_paper(tmp_path):
    done = run("demo", "--plot", tmp_path / "demo.png")
    assert done.returncode == 0, done.stderr
    assert "11.35" in done.stdout  # computed at pi/250, N_t = 500
    assert "11.38" in done.stdout  # printed there
    assert "largest deviation of the 51 entries: 0.4" in done.stdout
    assert (tmp_path / "demo.png").stat().st_size > 10_000


def test_example_is_the_papers_case(case_file):
    done = run("example")
    assert done.stdout == example_text()
    case = load_case(case_file())
    assert case.ball == vr.paper.ball()
    assert (case.load, case.angular_speed, case.accuracy, case.mesh) == (100.0, 2.5, 0.01, None)


MATERIALS = {
    "elastic": ('type = "elastic"\nmodulus = 1e6', vr.Elastic(modulus=1e6)),
    "prony": (
        'type = "prony"\ninstantaneous_modulus = 6e6\nweights = [0.3]\nrelaxation_times = [1.0]',
        vr.Prony(instantaneous_modulus=6e6, weights=[0.3], relaxation_times=[1.0]),
    ),
    "kelvin_voigt": (
        'type = "kelvin_voigt"\nmodulus = 1e6\nviscosity = 10',
        vr.KelvinVoigt(modulus=1e6, viscosity=10.0),
    ),
    "fractional_zener": (
        'type = "fractional_zener"\ninstantaneous_modulus = 6e6\nrelaxed_modulus = 3e6\n'
        "relaxation_time = 1\norder = 0.5",
        vr.FractionalZener(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=1.0, order=0.5),
    ),
    "master_curve": (
        'type = "master_curve"\nfrequency = [1.0, 2.0]\nstorage = [1e6, 2e6]\nloss = [0.0, 1e5]\n'
        'extrapolation = "hold"',
        vr.MasterCurve([1.0, 2.0], [1e6, 2e6], [0.0, 1e5], extrapolation=vr.Extrapolation.HOLD),
    ),
    "master_curve_file": (
        'type = "master_curve"\nfile = "curve.csv"',
        vr.MasterCurve([1.0, 2.0], [1e6, 2e6], [0.0, 1e5]),
    ),
}


@pytest.mark.parametrize(("text", "material"), MATERIALS.values(), ids=MATERIALS)
def test_every_material_can_be_written(case_file, tmp_path, text, material):
    (tmp_path / "curve.csv").write_text("frequency, storage, loss\n1.0, 1e6, 0\n2.0, 2e6, 1e5\n")
    head, rest = example_text().split("[ball.layers.shear_modulus]")
    path = case_file(head + "[ball.layers.shear_modulus]\n" + text + "\n\n" + rest[rest.index("[rolling]") :])
    assert load_case(path).ball.layers[0].shear_modulus == material


@pytest.mark.parametrize(
    ("replacements", "message"),
    [
        ({"load": "-5.0"}, "load must be > 0 N, got -5"),
        ({"load": "20000.0", "accuracy": "0.1"}, "load must be small enough for the coating"),
        ({"load": '"heavy"'}, "rolling.load: input should be a valid number, got 'heavy'"),
        ({"angular_speed": "nan"}, "angular_speed must be > 0 rad/s, got nan"),
        ({"thickness": "0"}, r"ball.layers[0]: thickness must be > 0 m, got 0"),
        ({"poisson_ratio": "0.6"}, r"ball.layers[0]: poisson_ratio must be in (-1, 0.5], got 0.6"),
        ({"type": '"jelly"'}, "shear_modulus.type must be one of elastic, "),
        ({"relaxed_modulus": "3e6\nstiffness = 1"}, "standard_linear_solid has no parameter stiffness"),
        ({"relaxation_time": "1.0\n#"}, ""),
        ({"compliance": '"diagonal"'}, "numerics.compliance: input should be 'vertical' or 'radial'"),
        ({"core_radius": "0.02\ncolor = 1"}, "ball.color: extra inputs are not permitted"),
        ({"accuracy": "0.01\nmax_order = 100"}, "nodes_per_revolution and numerics.max_order must be given together"),
        ({"load": ""}, "not a TOML file"),
    ],
)
def test_bad_cases_are_one_line_and_exit_code_2(case_file, replacements, message):
    done = run("solve", case_file(**replacements))
    if not message:
        assert done.returncode == 0
        return
    assert done.returncode == 2
    assert done.stderr.startswith("viscoroll: ")
    assert len(done.stderr.strip().splitlines()) == 1
    assert message in done.stderr
    assert done.stdout == ""


def test_missing_files_and_unknown_commands_exit_with_2(tmp_path, case_file):
    done = run("solve", tmp_path / "nowhere.toml")
    assert (done.returncode, len(done.stderr.strip().splitlines())) == (2, 1)
    assert "nowhere.toml: No such file or directory" in done.stderr
    assert run("roll").returncode == 2
    done = run("solve", case_file(accuracy="0.2"), "--save", tmp_path / "fields.xls")
    assert (done.returncode, "path must end in .csv" in done.stderr) == (2, True)


def test_help_explains_every_command():
    done = run("--help")
    assert done.returncode == 0
    for command in ("solve", "sweep", "plot", "demo", "example"):
        assert command in done.stdout
        assert run(command, "--help").returncode == 0
    assert run("--version").stdout == f"viscoroll {vr.__version__}\n"


def test_accuracy_that_is_not_reached_is_a_warning(case_file):
    done = run("solve", case_file(angular_speed="0.001", accuracy="0.02", density="0.0"), "--json")
    assert done.returncode == 0
    assert json.loads(done.stdout)["status"] == "ACCURACY_NOT_REACHED"
    assert "warning" in done.stderr
    assert np.isfinite(json.loads(done.stdout)["error_estimate"])


def test_import_needs_numpy_alone():
    program = """
import sys
for name in ("matplotlib", "xarray", "typer", "rich", "pydantic", "meshio", "scipy", "tqdm", "netCDF4"):
    sys.modules[name] = None
import viscoroll as vr
from viscoroll import paper
vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=100, max_order=100))
"""
    subprocess.run([sys.executable, "-c", program], check=True)
    program = "import sys; sys.modules['typer'] = None; from viscoroll.__main__ import main; main()"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "pip install 'viscoroll[cli,plot]'" in done.stderr
