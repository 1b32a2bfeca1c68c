"""The command line: solve, demo, example, and its input checks."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import subprocess
import sys
from functools import partial

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll import enums
from viscoroll.case import example_text, load_case

COARSE = "nodes_per_revolution = 100\nmax_order = 100"


def program(*words, encoding="utf-8"):
    """Run Python in its own process."""
    environment = os.environ | {"PYTHONIOENCODING": encoding}
    words = [sys.executable, *map(str, words)]
    return subprocess.run(words, capture_output=True, encoding=encoding, env=environment, check=False)


def assert_rejected(done, message):
    assert done.returncode == 2, done.stderr
    assert done.stderr.startswith("viscoroll: ")
    assert len(done.stderr.splitlines()) == 1
    assert message in done.stderr
    assert done.stdout == ""


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
    done = program("-m", "viscoroll", "solve", case_file(accuracy="0.1"))
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert "resisting torque T_r" in done.stdout
    assert "CONVERGED" in done.stdout


def rows_of(table):
    """Return the cells of a printed table by their labels."""
    lines = [line.strip("│").split("│") for line in table.splitlines() if line.startswith("│")]
    return {label.strip(): [cell.strip() for cell in cells] for label, *cells in lines}


def test_tables_fit_eighty_columns_and_use_suitable_units(case_file):
    path = case_file(accuracy="0.1")
    thermal = "\n[thermal]\nconvection = 10.0\nambient = 293.15\nconductivity = 0.2\n"
    path.write_text(path.read_text() + thermal, encoding="utf-8")
    done = command("solve", path)
    assert max(map(len, done.stdout.splitlines())) <= 80
    rows = rows_of(done.stdout)
    assert "" not in rows  # no label continues on the next line
    scalars = json.loads(command("solve", path, "--json").stdout)
    for label, name, error, unit, factor in [
        ("push force", "rolling_resistance_force", "model_error", "mN", 1e3),
        ("drive torque of linear theory", "rolling_resistance_torque", "model_error", "mN m", 1e3),
        ("penetration", "penetration", "penetration_model_error", "mm", 1e3),
        ("largest contact pressure", "max_pressure", "max_pressure_model_error", "MPa", 1e-6),
    ]:
        value, _, estimate = rows[label][0].removesuffix(f" {unit}").partition(" ± ")
        errors = scalars[error] * scalars[name] * factor
        assert float(estimate) >= 0.95 * errors
        assert float(value) == pytest.approx(scalars[name] * factor, abs=0.5 * errors)
    assert rows["contact area"] == [f"{scalars['contact_area'] * 1e6:.3g} mm²"]
    assert rows["strain"] == [f"{scalars['strain'] * 100:.3g} %"]
    value, _, estimate = rows["heat generated"][0].removesuffix(" mW").partition(" ± ")
    heat, power = scalars["thermal"][0]["heat"] * 1e3, rows["dissipated power"][0]
    assert float(value) == pytest.approx(heat, abs=float(estimate))
    assert power.endswith(f"± {estimate} mW")  # the error of the power
    # First the answer, then the temperature, then how certain the answer is.
    labels = ["push force", "heat generated", "relative error of the mesh", "contact area"]
    assert labels == sorted(labels, key=[*rows].index)


def test_solve_prints_json_and_writes_files(case_file, tmp_path):
    path = case_file()
    mesh = "nodes_per_revolution = 300\nmax_order = 300"
    path.write_text(path.read_text().replace("accuracy = 0.01", mesh), encoding="utf-8")
    done = command("solve", path, "--json", "--plot", tmp_path / "contact.png", "--save", tmp_path / "fields.csv")
    assert done.returncode == 0, done.stderr
    case = load_case(path)
    expected = vr.solve(case.body, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=300, max_order=300))
    assert json.loads(done.stdout) == expected.scalars()
    assert (tmp_path / "contact.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "fields.csv").read_text().startswith("x [m],z [m],pressure [Pa]")


def roller_file(folder, *, friction=0.0):
    """Write the case of a roller at 2 % strain."""
    path = folder / "roller.toml"
    text = "[cylinder]\ncore_radius = 40e-3\n[[cylinder.layers]]\nthickness = 10e-3\npoisson_ratio = 0.5\n"
    text += 'shear_modulus = {type = "standard_linear_solid", instantaneous_modulus = 2e6, relaxed_modulus = 1e6, '
    text += f"relaxation_time = 0.01}}\n[rolling]\npenetration = 2e-4\nangular_speed = 9.0\nfriction = {friction}\n"
    path.write_text(text, encoding="utf-8")
    return path


def test_finite_strain_is_solved_beside_linear_theory(tmp_path, monkeypatch):
    path = roller_file(tmp_path)
    done = command("solve", path, "--finite-strain", "--json")
    assert done.returncode == 0, done.stderr
    scalars = json.loads(done.stdout)
    found = scalars["finite_strain"]
    assert found["penetration"] == pytest.approx(2e-4, rel=1e-12)
    for name in ("load", "contact_length", "max_pressure"):
        assert found[name] == pytest.approx(scalars[name], rel=0.03)
    error = scalars["finite_strain_torque_error"]
    assert found["resisting_torque"] == pytest.approx(scalars["finite_strain_torque"], rel=error)
    assert found["overspeed"] == pytest.approx(scalars["overspeed"], rel=0.1)
    assert "Poisson" not in done.stderr
    path.write_text(path.read_text(encoding="utf-8").replace("poisson_ratio = 0.5", "poisson_ratio = 0.49"), "utf-8")
    # The warning does not depend on the finite elements of the command, which take long.
    monkeypatch.setattr(vr.finite_strain, "solve", partial(vr.finite_strain.solve, elements_across=12))
    warning = "warning: layers[0] has the Poisson's ratio 0.49, which linear theory keeps constant; the finite elements"
    assert warning in command("solve", path, "--finite-strain").stderr


def test_an_export_accepts_a_speed_over_the_ground(case_file):
    path, files = case_file(accuracy="0.1"), []
    for speed in ("angular_speed = 2.5", "speed = 0.0525"):
        path.write_text(path.read_text(encoding="utf-8").replace("angular_speed = 2.5", speed), encoding="utf-8")
        done = command("export", path, "--for", "lammps")
        assert done.returncode == 0, done.stderr
        files.append(done.stdout)
    angles = [float(re.search(r"speed Omega = (\S+) rad/s", text)[1]) for text in files]
    assert angles[1] == pytest.approx(angles[0], rel=1e-4)


def test_finite_strain_requires_a_roller_without_friction(case_file, tmp_path):
    assert_rejected(
        command("solve", roller_file(tmp_path, friction=0.3), "--finite-strain"),
        "rolling.friction must be 0 with --finite-strain, got 0.3",
    )
    assert_rejected(
        command("solve", case_file(accuracy="0.1"), "--finite-strain"),
        "--finite-strain must be left out unless the case has a roller, the table [cylinder]: finite elements at "
        "finite strain solve rollers only, got a ball",
    )
    path = roller_file(tmp_path)
    path.write_text(path.read_text(encoding="utf-8").replace("poisson_ratio = 0.5", "poisson_ratio = 0.3"))
    assert_rejected(
        command("solve", path, "--finite-strain"),
        "must have a Poisson's ratio in [0.48, 0.5] at rest, got 0.3; required by --finite-strain",
    )


def test_demo_compares_with_the_paper(tmp_path):
    done = command("demo", "--plot", tmp_path / "demo.png")
    assert done.returncode == 0, done.stderr
    assert "11.35" in done.stdout  # computed at pi/250, N_t = 500
    assert "11.38" in done.stdout  # printed in the paper
    assert "largest deviation of the 51 entries: 0.4" in done.stdout
    assert (tmp_path / "demo.png").stat().st_size > 10_000


def test_example_is_the_papers_case(case_file):
    done = command("example")
    assert done.stdout == example_text()
    case = load_case(case_file())
    assert case.body == vr.paper.ball()
    assert (case.load, case.angular_speed, case.accuracy, case.mesh) == (100.0, 2.5, 0.01, None)


def test_full_stick_is_an_infinite_friction_in_case_files(case_file):
    path = case_file()
    path.write_text(path.read_text().replace("friction = 0.0 ", "friction = inf "), encoding="utf-8")
    assert load_case(path).friction == float("inf")


MATERIALS = {
    "elastic": ('type = "elastic"\nmodulus = 1e6', vr.Elastic(modulus=1e6)),
    "prony": (
        'type = "prony"\ninstantaneous_modulus = 6e6\nweights = [0.3]\nrelaxation_times = [1.0]',
        vr.Prony(instantaneous_modulus=6e6, weights=[0.3], relaxation_times=[1.0]),
    ),
    "creep_compliance": (
        'type = "creep_compliance"\ninstantaneous_compliance = 1e-6\ncompliances = [2e-6]\nretardation_times = [1.0]',
        vr.materials.CreepCompliance(instantaneous_compliance=1e-6, compliances=[2e-6], retardation_times=[1.0]),
    ),
    "kelvin_voigt": (
        'type = "kelvin_voigt"\nmodulus = 1e6\nviscosity = 10',
        vr.materials.KelvinVoigt(modulus=1e6, viscosity=10.0),
    ),
    "fractional_zener": (
        'type = "fractional_zener"\ninstantaneous_modulus = 6e6\nrelaxed_modulus = 3e6\n'
        "relaxation_time = 1\norder = 0.5",
        vr.materials.FractionalZener(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=1.0, order=0.5),
    ),
    "havriliak_negami": (
        'type = "havriliak_negami"\ninstantaneous_modulus = 6e6\nrelaxed_modulus = 3e6\n'
        "relaxation_time = 1\norder = 0.5\nasymmetry = 0.25",
        vr.materials.HavriliakNegami(
            instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=1.0, order=0.5, asymmetry=0.25
        ),
    ),
    "master_curve": (
        'type = "master_curve"\nfrequency = [1.0, 2.0]\nstorage = [1e6, 2e6]\nloss = [0.0, 1e5]\n'
        'extrapolation = "hold"',
        vr.MasterCurve([1.0, 2.0], [1e6, 2e6], [0.0, 1e5], extrapolation=enums.Extrapolation.HOLD),
    ),
    "master_curve_file": (
        'type = "master_curve"\nfile = "curve.csv"',
        vr.MasterCurve([1.0, 2.0], [1e6, 2e6], [0.0, 1e5]),
    ),
}


def with_material(text):
    head, rest = example_text().split("[ball.layers.shear_modulus]")
    return head + "[ball.layers.shear_modulus]\n" + text + "\n\n" + rest[rest.index("[rolling]") :]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig"])
@pytest.mark.parametrize(("text", "material"), MATERIALS.values(), ids=MATERIALS)
def test_every_material_can_be_written(tmp_path, text, material, encoding):
    # The file may begin with a byte-order mark, which some editors and spreadsheets write.
    (tmp_path / "curve.csv").write_text("frequency, storage, loss\n1.0, 1e6, 0\n2.0, 2e6, 1e5\n", encoding=encoding)
    path = tmp_path / "case.toml"
    path.write_text(with_material(text), encoding=encoding)
    assert load_case(path).body.layers[0].shear_modulus == material


CURVE = 'type = "master_curve"\n'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('type = ["elastic"]', "shear_modulus.type must be one of elastic, .* softening, got ['elastic']"),
        ("type = { a = 1 }", "shear_modulus.type must be one of elastic, .* softening, got {'a': 1}"),
        (
            CURVE + 'file = "curve.csv"\nextrapolation = ["hold"]',
            "extrapolation must be 'error' or 'hold', got ['hold']",
        ),
        (CURVE + 'file = "curve.csv"\nloss = [0.0]', "file must be left out if columns are given, got also loss"),
        (CURVE + "file = 3", "shear_modulus.file must be the name of a file, got 3"),
        (CURVE + 'file = "a\\nb.csv"', r"a\nb.csv: No such file or directory"),
        (CURVE + 'file = "long.csv"', "long.csv: field larger than field limit (131072)"),
        ('type = "elastic"\n"a\\nb" = 3', r"shear_modulus.a\nb is not a parameter of the type elastic, got 3"),
        (
            'type = "elastic"\nmodulos = 3',
            "modulos is not a parameter of the type elastic, got 3; did you mean modulus?",
        ),
        ('type = "elastic"\nmodulus = ' + "{a = " * 90 + "1" + "}" * 90, "modulus must be a real number, got dict"),
    ],
)
def test_bad_materials_have_messages_of_one_line(tmp_path, text, message):
    (tmp_path / "curve.csv").write_text("frequency, storage, loss\n1.0, 1e6, 0\n2.0, 2e6, 1e5\n")
    (tmp_path / "long.csv").write_text(f"frequency, storage, loss\n1.0, 1e6, {'0' * 200_000}\n")
    path = tmp_path / "case.toml"
    path.write_text(with_material(text), encoding="utf-8")
    with pytest.raises(ValueError, match=r"case.toml: ball.layers\[0\].shear_modulus") as caught:
        load_case(path)
    assert "\n" not in str(caught.value)
    for part in message.split(".*"):
        assert part in str(caught.value)


@pytest.mark.parametrize(
    ("replacements", "message"),
    [
        ({"load": "-5.0"}, "load must be > 0 N, got -5"),
        ({"load": "20000.0", "accuracy": "0.1"}, "load must be small enough for the coating"),
        ({"load": '"heavy"'}, "rolling.load must be a valid number, got 'heavy'"),
        ({"angular_speed": "nan"}, "angular_speed must be > 0 rad/s, got nan"),
        ({"thickness": "0"}, r"ball.layers[0].thickness must be > 0 m, got 0"),
        ({"poisson_ratio": "0.6"}, r"ball.layers[0].poisson_ratio must be in (-1, 0.5], got 0.6"),
        ({"type": '"jelly"'}, "shear_modulus.type must be one of elastic, "),
        ({"relaxed_modulus": "3e6\nstiffness = 1"}, "stiffness is not a parameter of the type standard_linear_solid"),
        ({"relaxation_time": "1.0\n#"}, ""),
        ({"compliance": '"diagonal"'}, "numerics.compliance must be 'radial' or 'vertical'"),
        ({"core_radius": "0.02\ncolor = 1"}, "ball.color is not a parameter"),
        ({"accuracy": "0.01\nmax_order = 100"}, "numerics.nodes_per_revolution must be given with max_order"),
        ({"load": ""}, "not a TOML file"),
        ({"load": "[" * 20_000 + "]" * 20_000}, "case.toml: not a TOML file: nested too deeply"),
        ({"load": "1" + "0" * 400}, "rolling.load must be a valid number, got about 1e400"),
        ({"load": "1" + "0" * 5000}, "not a TOML file: "),
        ({"load": '5.0\n"a\\nb" = 1'}, r"rolling.a\nb is not a parameter"),
    ],
)
def test_bad_cases_have_messages_of_one_line_and_exit_code_2(case_file, replacements, message):
    done = command("solve", case_file(**replacements))
    if not message:
        assert done.returncode == 0
        return
    assert_rejected(done, message)


@pytest.mark.parametrize(
    ("words", "path", "message"),
    [
        ("solve case.toml --plot", "x.xyz", "--plot must end in .png, .svg or .pdf, got 'x.xyz'"),
        ("solve case.toml --plot", "a", "--plot must end in .png, .svg or .pdf, got 'a'"),
        ("solve case.toml --save", "x.xyz", "--save must end in .csv, .nc, .vtu or .vtk, got 'x.xyz'"),
        ("solve case.toml --plot", "none/x.png", "--plot must be a file in a folder that exists, got 'none/x.png'"),
        ("solve case.toml --save", "none/x.csv", "--save must be a file in a folder that exists, got 'none/x.csv'"),
        ("solve case.toml --save", "folder.csv", "--save must be a file in a folder that exists, got 'folder.csv'"),
        ("demo --plot", "a", "--plot must end in .png, .svg or .pdf, got 'a'"),
        ("sweep study.toml --output", "a", "--output must end in .nc, got 'a'"),
        ("plot study.nc --output", "a", "--output must end in .png, .svg or .pdf, got 'a'"),
    ],
)
def test_files_that_cannot_be_written_are_rejected_before_the_solve(tmp_path, words, path, message):
    (tmp_path / "folder.csv").mkdir()
    # There is no case file, so a message about the option shows that the option is checked first.
    assert_rejected(command(*words.split(), path, cwd=tmp_path), message)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[sweep]\n"a\\nb" = [1.0]', r"study.toml: sweep: keys must be paths"),
        ("[sweep]\nload = " + "[" * 20_000 + "]" * 20_000, "study.toml: not a TOML file: nested too deeply"),
        ('[sweep]\n"rolling.load" = 1' + "0" * 5000, "study.toml: not a TOML file: "),
    ],
)
def test_bad_studies_have_messages_of_one_line(tmp_path, text, message):
    (tmp_path / "study.toml").write_text(text, encoding="utf-8-sig")
    assert_rejected(command("sweep", "study.toml", cwd=tmp_path), message)


def test_too_little_memory_has_a_message_of_one_line(case_file, monkeypatch):
    def fails(*arguments, **options):
        raise MemoryError("std::bad_alloc")

    monkeypatch.setattr("viscoroll.case.case.solve", fails)
    assert_rejected(command("solve", case_file()), "this case: use a coarser mesh, or a larger accuracy")


def test_json_has_no_nan_or_infinity(case_file, monkeypatch):
    mesh = vr.Mesh(nodes_per_revolution=100, max_order=100)
    r = vr.solve(vr.paper.ball(), load=100.0, angular_speed=2.5, mesh=mesh)
    r = dataclasses.replace(r, residual=np.nan, creepage=-np.inf)
    monkeypatch.setattr("viscoroll.case.case.solve", lambda **options: r)
    values = json.loads(command("solve", case_file(), "--json").stdout, parse_constant=pytest.fail)
    assert (values["residual"], values["creepage"], values["load"]) == (None, None, 100.0)


@pytest.mark.parametrize("encoding", ["ascii", "latin-1"])
def test_characters_that_the_terminal_cannot_show_are_replaced(case_file, encoding):
    done = program("-m", "viscoroll", "solve", case_file(accuracy="0.1"), encoding=encoding)
    assert done.returncode == 0, done.stderr
    assert "? = 2.5 rad/s" in done.stdout
    assert "resisting torque T_r" in done.stdout


def test_a_coarse_mesh_is_a_warning(case_file):
    path = case_file(load="1e-9", accuracy="#")
    path.write_text(path.read_text().replace("accuracy = #", COARSE), encoding="utf-8")
    case = load_case(path)
    estimate = case.solve().error_estimate
    assert command("solve", path).stderr == (
        "warning: the mesh is too coarse: 1 nodes across the contact (recommended: at least 10), "
        f"error estimate {estimate:.3g} (recommended: at most 0.05); refine the mesh or leave it out\n"
    )


@pytest.mark.parametrize("module", ["viscoroll.cli", "typer", "pydantic"])
def test_ctrl_c_while_importing_is_quiet(module):
    text = f"""
import sys
class Interrupts:
    def find_spec(self, name, path=None, target=None):
        if name == {module!r}:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupts())
from viscoroll.__main__ import main
main()
"""
    done = program("-c", text, "solve", "case.toml")
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")


def test_missing_files_and_unknown_commands_exit_with_2(tmp_path):
    done = command("solve", tmp_path / "nowhere.toml")
    assert (done.returncode, len(done.stderr.strip().splitlines())) == (2, 1)
    assert "nowhere.toml: No such file or directory" in done.stderr
    assert command("roll").returncode == 2
    assert_rejected(command("solve", "a\nb.toml", cwd=tmp_path), r"viscoroll: a\nb.toml: No such file or directory")


def test_help_explains_every_command():
    done = command("--help")
    assert done.returncode == 0
    told = " ".join(done.stdout.split())
    assert "balls, rollers and wheels with soft viscoelastic layers, on a plane, in a groove" in told
    for name in ("solve", "sweep", "plot", "demo", "example"):
        assert name in done.stdout
        assert command(name, "--help").returncode == 0
    assert command("--version").stdout in [f"viscoroll {vr.__version__} ({fft})\n" for fft in ("FFTW", "PocketFFT")]


def test_a_missed_accuracy_is_a_warning(case_file):
    done = command("solve", case_file(load="1e-13", accuracy="0.02", density="0.0"), "--json")
    assert done.returncode == 0
    assert json.loads(done.stdout)["status"] == "ACCURACY_NOT_REACHED"
    assert "warning" in done.stderr
    assert np.isfinite(json.loads(done.stdout)["error_estimate"])


def test_import_requires_only_numpy():
    text = """
import sys
for name in ("matplotlib", "xarray", "typer", "rich", "pydantic", "meshio", "scipy", "tqdm", "netCDF4"):
    sys.modules[name] = None
import viscoroll as vr
from viscoroll import paper
vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=100, max_order=100))
"""
    done = program("-c", text)
    assert done.returncode == 0, done.stderr
    done = program("-c", "import sys; sys.modules['typer'] = None; from viscoroll.__main__ import main; main()")
    assert done.returncode == 1
    assert "pip install 'viscoroll[cli,plot]'" in done.stderr


def test_roll_follows_the_example_motion(tmp_path):
    file = tmp_path / "motion.toml"
    text = example_text("motion").replace("nodes_per_revolution = 300", "nodes_per_revolution = 100")
    file.write_text(text, encoding="utf-8")
    done = command("roll", file, "--plot", tmp_path / "h.png", "--save", tmp_path / "h.csv")
    assert done.returncode == 0, done.stderr
    assert "largest torque T_r" in done.stdout
    assert (tmp_path / "h.png").stat().st_size > 1000
    numbers = json.loads(command("roll", file, "--json").stdout)
    assert 0.04 < numbers["largest_resisting_torque"] < 0.06
    assert command("example", "--motion").stdout == example_text("motion")


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ("time = [0.0, 1.0]\nangle = [0.0]\nload = 1.0", "angle must be as long as time (2), got 1"),
        ("time = [0.0, 1.0]", "motion must have load or axle_height, and angle or distance, with time"),
        ("load = 1.0", "motion must have exactly one of time, file and amplitude, got none"),
        ("amplitude = 0.1\nfrequency = 0.0\nload = 1.0", "motion.frequency must be in [1e-100, 1e+100] Hz, got 0"),
        ("amplitude = inf\nfrequency = 1.0\nload = 1.0", "motion.amplitude must be finite, got inf"),
        ("file = 'none.csv'\nload = 1.0", "No such file"),
        ("file = 'bad.csv'\nload = 1.0", "must have numbers in the columns time and optionally angle, distance, load"),
        ("time = [0.0, 1.0]\nangle = [0.0, 1.0]\nload = 1.0\nspeed = 1.0", "motion.speed is not a parameter"),
    ],
)
def test_bad_motions_have_messages_of_one_line(tmp_path, lines, message):
    head, tail = example_text("motion").split("[motion]")
    numerics = tail[tail.index("[numerics]") :]
    (tmp_path / "bad.csv").write_text("time,angle\n0,x\n")
    (tmp_path / "motion.toml").write_text(f"{head}[motion]\n{lines}\n{numerics}", encoding="utf-8")
    assert_rejected(command("roll", tmp_path / "motion.toml"), message)


def test_roll_reads_motions_from_files_and_oscillations(tmp_path):
    from viscoroll.case.motion import load_motion

    head, tail = example_text("motion").split("[motion]")
    numerics = tail[tail.index("[numerics]") :]
    (tmp_path / "motion.csv").write_text("time,angle,load\n0,0,10\n1,0.5,20\n")
    (tmp_path / "a.toml").write_text(f"{head}[motion]\nfile = 'motion.csv'\n{numerics}", encoding="utf-8")
    case = load_motion(tmp_path / "a.toml")
    assert case.load == [10.0, 20.0]
    swing = "amplitude = 0.1\nfrequency = 2.0\ncycles = 3\nload = 50.0"
    (tmp_path / "b.toml").write_text(f"{head}[motion]\n{swing}\n{numerics}", encoding="utf-8")
    case = load_motion(tmp_path / "b.toml")
    assert case.time[-1] == pytest.approx(1.5)
    assert np.abs(case.angle).max() == pytest.approx(0.1, rel=1e-3)
    assert case.on is None


def test_roll_follows_a_distance_along_a_mat(tmp_path):
    from viscoroll.case.motion import load_motion

    (tmp_path / "motion.csv").write_text("time,distance,load\n0,0,100\n0.2,0.01,100\n")
    mat = "{ thickness = 1e-3, poisson_ratio = 0.5, shear_modulus = 3e6 }"
    text = f"[ball]\ncore_radius = 21e-3\nlayers = []\n[plane]\nlayers = [{mat}]\n[motion]\nfile = 'motion.csv'\n"
    (tmp_path / "motion.toml").write_text(f"{text}[numerics]\nnodes_per_revolution = 100\n", encoding="utf-8")
    h = load_motion(tmp_path / "motion.toml").roll()
    assert h.distance[-1] == pytest.approx(0.01)
    assert h.on.layers[0].thickness == 1e-3
    (tmp_path / "motion.csv").write_text("time,distance,angle,load\n0,0,0,100\n")
    assert_rejected(
        command("roll", tmp_path / "motion.toml"), "must have exactly one of the columns angle and distance"
    )
