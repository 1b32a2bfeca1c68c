"""Measured materials in files and case files, and the commands that use them."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll.case import load_case
from viscoroll.case.design import design_case
from viscoroll.case.study import load_study

CASE = """
[ball]
core_radius = 20e-3
[[ball.layers]]
thickness = 2e-3
poisson_ratio = 0.5
shear_modulus = {modulus}
[rolling]
load = 50.0
angular_speed = 2.5
[numerics]
nodes_per_revolution = 400
"""
RUBBER = (
    '{ type = "standard_linear_solid", instantaneous_modulus = 6e6, relaxed_modulus = 3e6, relaxation_time = 0.125 }'
)


@pytest.fixture(scope="module")
def curve():
    data = vr.rheology.read_rheology(vr.rheology.example_data("pressure_sensitive_adhesive.txt"), tensile=False)
    return vr.rheology.superpose(data.between(288.15, 338.15), reference=293.15)


@pytest.fixture
def saved(curve, tmp_path):
    vr.rheology.save_material(tmp_path / "a.toml", curve, fit=curve.fit)
    return tmp_path / "a.toml"


def case_file(folder, modulus, more="", nodes="400"):
    path = folder / "case.toml"
    text = CASE.replace("{modulus}", modulus).replace("= 400", f"= {nodes}")
    path.write_text(text + more, encoding="utf-8")
    return path


def test_material_at_its_own_and_another_temperature(curve, saved):
    omega = np.geomspace(0.01, 100.0, 9)
    for options, expected in (
        ({}, curve.curve),
        ({"temperature": 318.15}, curve.at(temperature=318.15)),
        ({"form": "prony"}, curve.fit.series),
        ({"form": "prony", "temperature": 318.15}, curve.series_at(temperature=318.15)),
    ):
        found = vr.rheology.load_material(saved, **options).complex_modulus(omega)
        np.testing.assert_allclose(found, expected.complex_modulus(omega), rtol=1e-12)


@pytest.mark.parametrize(
    ("content", "options", "message"),
    [
        (
            None,
            {"temperature": 363.15},
            r"material .*a.toml: .*temperature must be in the measured range, 293.16 to 333.16 K \(20.01 to 60.01 °C\)",
        ),
        (None, {"form": "spline"}, "form must be 'table' or 'prony', got 'spline'"),
        ("x = 1", {}, r"must have a table \[table\]: the file is not a material file of viscoroll"),
        ("[table]\nfrequency = [1.0]", {}, r"table \[table\] must have the key storage"),
        ("[table]\nfrequency = [1.0]", {"form": "prony"}, r"must have a table \[prony\]: save the material with a fit"),
        (
            "[table]\nfrequency = [1.0]",
            {"temperature": 300.0},
            r"must have a table \[shift\]: the temperature of this material cannot be changed",
        ),
        ("[table", {}, "material .*a.toml: not a TOML file: "),
        ("a = " + 5000 * "[", {}, "material .*a.toml: not a TOML file: nested too deeply"),
        ("a = " + 5000 * "9", {}, "material .*a.toml: not a TOML file: Exceeds the limit"),
        ('[table]\nfrequency = "x"', {}, r"table.frequency must be a list of numbers, got 'x'"),
        ("[table]\nfrequency = [true, 1.0]", {}, r"table.frequency\[0\] must be a real number, got bool True"),
        ('[table]\nfrequency = ["1.0", 2.0]', {}, "table.frequency must contain real numbers"),
        (f"[table]\nfrequency = [1.0, {400 * '9'}]", {}, r"table.frequency\[1\] must be <= 1.8e\+308 in magnitude"),
        ('reference_temperature = "x"', {}, "reference_temperature must be a real number, got str 'x'"),
        ("reference_temperature = 20", {}, r"reference_temperature must be >= 100 K \(20 °C are 293.15 K\), got 20 K"),
        (
            "[table]\n[shift]\ntemperature = [273.15, 323.15]\nlog10_factor = [400.0, 0.0]",
            {"temperature": 300.0},
            r"log10_factor\[0\] must be in \[-100, 100\], got 400",
        ),
        (
            "[table]\n[shift]\ntemperature = [273.15, 273.15000001]\nlog10_factor = [1.0, 0.0]",
            {"temperature": 273.15},
            "temperature must increase from entry to entry, by at least 1e-06 K",
        ),
        (
            "[draws]\ninstantaneous_modulus = 1.0",
            {"form": "prony", "draw": 0},
            "draws.instantaneous_modulus must be a list of numbers, got 1.0",
        ),
        (
            "[draws]\ninstantaneous_modulus = [1e6, 2e6]\nweights = [[0.1]]",
            {"form": "prony", "draw": 1},
            "draws.weights must be a list of 2 lists, one for each draw",
        ),
        (
            "[draws]\ninstantaneous_modulus = [1e6, 2e6]\nweights = [[0.1], 0.1]",
            {"form": "prony", "draw": 1},
            r"draws.weights\[1\] must be a list of numbers, got 0.1",
        ),
        (
            "[draws]\ninstantaneous_modulus = [1e6]",
            {"form": "prony", "draw": 0},
            r"table \[draws\] must have the key weights",
        ),
    ],
)
def test_files_that_are_not_a_material(saved, content, options, message):
    if content is not None:
        saved.write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match=message):
        vr.rheology.load_material(saved, **options)


@pytest.mark.parametrize("option", [{"temperature": "0"}, {"temperature": True}, {"draw": 0.5}, {"draw": "0"}])
def test_arguments_of_another_type(saved, option):
    with pytest.raises(TypeError, match=f"{next(iter(option))} must be a "):
        vr.rheology.load_material(saved, **option)


def test_a_material_of_one_sweep_has_no_shift(curve, tmp_path):
    sweep = curve.data.isotherms[0]
    vr.rheology.save_material(tmp_path / "one.toml", sweep)
    table = vr.rheology.load_material(tmp_path / "one.toml")
    middle = sweep.frequency[8]
    assert table.complex_modulus(middle).real == pytest.approx(sweep.storage[8], rel=0.02)
    with pytest.raises(ValueError, match=r"path must end in .toml, got 'one.txt'"):
        vr.rheology.save_material(tmp_path / "one.txt", sweep)


@pytest.mark.parametrize(
    ("modulus", "expected"),
    [
        ("3e6", vr.Elastic(modulus=3e6)),
        (
            '{ type = "loss_factor", modulus = 1e6, loss_factor = 0.1, reference_frequency = 50.0 }',
            vr.LossFactor(modulus=1e6, loss_factor=0.1, reference_frequency=50.0),
        ),
        (
            '{ type = "hardness", hardness = 40, scale = "D" }',
            vr.Elastic(modulus=vr.rheology.hardness_to_modulus(40, scale="D").value),
        ),
        (
            '{ type = "hardness", hardness = 85.0, rebound = 0.55, reference_frequency = 120.0, decades = 2.0 }',
            vr.LossFactor(
                modulus=vr.rheology.hardness_to_modulus(85.0).value,
                loss_factor=vr.rheology.rebound_to_loss_factor(0.55).value,
                reference_frequency=120.0,
                decades=2.0,
            ),
        ),
    ],
)
def test_case_files_accept_values_of_data_sheets(tmp_path, modulus, expected):
    assert load_case(case_file(tmp_path, modulus)).body.layers[0].shear_modulus == expected


def test_case_files_refer_to_material_files(curve, saved, tmp_path):
    for modulus, expected in (
        ('"a.toml"', curve.curve),
        ('{ type = "measured", file = "a.toml", temperature = 313.15 }', curve.at(temperature=313.15)),
        ('{ type = "measured", file = "a.toml", form = "prony" }', curve.fit.series),
    ):
        found = load_case(case_file(tmp_path, modulus)).body.layers[0].shear_modulus
        np.testing.assert_allclose(
            found.complex_modulus([1.0, 10.0]), expected.complex_modulus([1.0, 10.0]), rtol=1e-12
        )


def test_studies_vary_the_temperature(curve, saved, tmp_path):
    sweep = '\n[sweep]\n"ball.layers[0].shear_modulus.temperature" = [293.15, 313.15, 333.15]\n'
    path = case_file(tmp_path, '{ type = "measured", file = "a.toml" }', sweep)
    plan = load_study(path)
    assert plan.dimensions[0].name == "temperature"
    found = [case.body.layers[0].shear_modulus.complex_modulus(1.0) for case in plan.cases]
    expected = [curve.at(temperature=t).complex_modulus(1.0) for t in (293.15, 313.15, 333.15)]
    np.testing.assert_allclose(found, expected, rtol=1e-12)


@pytest.mark.parametrize(
    ("modulus", "message"),
    [
        (
            '{ type = "hardness", hardness = 95 }',
            r"shear_modulus.hardness must be in \[20, 90\] Shore A, got 95; use scale='D' for harder materials",
        ),
        ('{ type = "hardness", hardness = 85, rebound = 55, reference_frequency = 1.0 }', "55 % is 0.55"),
        ('{ type = "hardness", hardness = 85, rebound = 0.5 }', "reference_frequency must be given with a rebound"),
        (
            '{ type = "hardness", hardness = 85, decades = 2.0 }',
            "decades must be left out without a rebound",
        ),
        ('"b.toml"', r"ball.layers\[0\].shear_modulus is invalid: material .*b.toml: No such file"),
        ('{ type = "measured" }', "shear_modulus.file must be given for the type measured"),
        ('{ type = "measured", file = "a.toml", at = 3 }', "shear_modulus.at is not a parameter of the type measured"),
        (
            '{ type = "measured", file = "a.toml", temperature = "hot" }',
            "shear_modulus.temperature must be a valid number, got 'hot'",
        ),
        ("-3e6", "modulus must be > 0 Pa, got -3"),
        ("[3e6]", r"shear_modulus must be a table, a number or the name of a file, got \[3000000.0\]"),
    ],
)
def test_case_files_with_bad_materials(saved, tmp_path, modulus, message):
    with pytest.raises(ValueError, match=message):
        load_case(case_file(tmp_path, modulus))


def test_the_material_command_requires_options_that_it_cannot_infer(tmp_path):
    data = vr.rheology.example_data("pressure_sensitive_adhesive.txt")
    for words, message in (
        ((data, "--reference", 293.15), "may be a tensile or a shear modulus"),
        (
            (data, "--shear"),
            "--reference must be given for sweeps at several temperatures, from 233.15 to 423.14 K (-40 to 150 °C)",
        ),
        ((data, "--shear", "--between", "cold"), "--between must have the form from..to, got 'cold'"),
        ((data, "--shear", "--columns", "storage"), "--columns must have the form"),
        ((data, "--shear", "--save", tmp_path / "x.csv"), "--save must end in .toml"),
    ):
        done = command("material", *words)
        assert done.returncode == 2
        assert message in done.stderr


def test_export_writes_next_to_the_case(tmp_path):
    path = case_file(tmp_path, RUBBER)
    done = command("export", path, "--for", "lethe", "--style", "viscous", "--span", 1.5)
    assert done.returncode == 0, done.stderr
    assert "set rolling friction wall" in (tmp_path / "case.lethe").read_text()
    assert len((tmp_path / "case.csv").read_text().splitlines()) == 26
    done = command("export", path, "--for", "lammps", "--span", 1.0)
    assert (done.returncode, done.stderr) == (2, "viscoroll: --span must be in (1, 100], got 1\n")


@pytest.mark.parametrize("name", ["solve", "export", "roll", "sweep", "design"])
def test_deep_nesting_is_rejected_by_every_command(tmp_path, name):
    path = tmp_path / "deep.toml"
    path.write_text("a = " + 5000 * "[", encoding="utf-8")
    done = command(name, path, *(["--for", "yade"] if name == "export" else []))
    assert (done.returncode, done.stderr) == (2, f"viscoroll: {path}: not a TOML file: nested too deeply\n")


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        ("frequency,storage,loss\n1,1e6,1e5\n0.5,2e6,1e5\n", r"master curve .*c.csv: .*frequency\[1\] must be >"),
        ("frequency,storage,loss\n1,5,1e6,1e5\n", "master curve .*c.csv: .*line 2 must have 3 cells"),
        ("frequency,storage,loss\n1,1e400,1e5\n", "line 2: storage must be a finite number, got '1e400'"),
        ("frequency,storage,loss,loss\n1,1e6,1,1\n", "column loss occurs 2 times"),
        ("", "column frequency occurs 0 times"),
    ],
)
def test_messages_name_tables_next_to_cases(tmp_path, columns, message):
    (tmp_path / "c.csv").write_text(columns, encoding="utf-8")
    with pytest.raises(ValueError, match=message):
        load_case(case_file(tmp_path, '{ type = "master_curve", file = "c.csv" }'))


def test_export_uses_the_study_of_the_file(tmp_path):
    sweep = '\n[sweep]\n"rolling.load" = [40.0, 50.0, 60.0]\n"rolling.angular_speed" = [2.0, 2.5]\n'
    path = case_file(tmp_path, RUBBER, sweep)
    done = command("export", path, "--for", "yade", "--output", tmp_path / "floor.py")
    assert done.returncode == 0, done.stderr
    assert len((tmp_path / "floor.csv").read_text().splitlines()) == 7


DESIGN = """
[design]
vary = "ball.layers[0].thickness"
from = 0.5e-3
to = 6e-3
limits = {limits}
"""


def power(thickness, folder):
    path = case_file(folder, RUBBER)
    path.write_text(path.read_text().replace("thickness = 2e-3", f"thickness = {thickness!r}"))
    result = load_case(path).solve()
    return result.dissipated_power, result


def test_design_stops_at_the_limit(tmp_path):
    """A thicker coating has a lower pressure and a larger power loss, so the best coating is the thinnest allowed."""
    _, middle = power(1.5e-3, tmp_path)
    path = case_file(tmp_path, RUBBER, DESIGN.replace("{limits}", f"{{ max_pressure = {middle.max_pressure!r} }}"))
    found = design_case(path)
    assert found.result.max_pressure <= middle.max_pressure * (1.0 + 1e-9)
    # All of twelve thicknesses that meet the limit dissipate at least as much, to the error of the mesh.
    for thickness in np.geomspace(0.5e-3, 6e-3, 12):
        watts, result = power(float(thickness), tmp_path)
        if result.max_pressure <= middle.max_pressure:
            assert found.result.dissipated_power <= watts * 1.01
    assert found.active == ("max_pressure",)
    assert found.plot().axes[0].get_ylabel() == "power dissipated [mW]"


def test_design_with_a_limit_of_temperature(tmp_path):
    """The temperature of the result is at most the limit; a case without a table [thermal] is rejected."""
    coarse = {"nodes": "120\nmax_order = 160"}  # because every point of the search computes the inner losses
    cooled = "\n[thermal]\nconvection = 20.0\nambient = 293.15\nconductivity = 0.2\n"
    middle = load_case(case_file(tmp_path, RUBBER, cooled, **coarse))
    heated = middle.thermal.temperature(middle.solve())
    hottest = heated.ambient + 0.999 * heated.maximum
    table = DESIGN.replace("{limits}", f"{{ temperature = {hottest!r} }}")
    found = design_case(case_file(tmp_path, RUBBER, cooled + table, **coarse))
    assert found.outcome.value("temperature") <= hottest
    with pytest.raises(ValueError, match=r"design.limits.temperature must be used with a table \[thermal\]"):
        design_case(case_file(tmp_path, RUBBER, table))


def test_design_of_the_load(tmp_path):
    """Any number may vary, also the load; the power is smallest at the lower end."""
    table = (
        DESIGN.replace('"ball.layers[0].thickness"', '"rolling.load"').replace("0.5e-3", "20.0").replace("6e-3", "60.0")
    )
    found = design_case(case_file(tmp_path, RUBBER, table.replace("{limits}", "{}")))
    assert found.best == pytest.approx(20.0, rel=1e-6)


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ("", 'case.toml: design must be a table, such as vary = "ball.layers'),
        (
            DESIGN.replace("{limits}", "{ pressure = 1.0 }"),
            "design.limits must be named rolling_resistance_force, .*, got 'pressure'",
        ),
        (
            DESIGN.replace("{limits}", "{ max_pressure = -1.0 }"),
            "design.limits.max_pressure must be greater than 0, got -1.0",
        ),
        (
            DESIGN.replace("{limits}", "{ max_pressure = 1.0 }"),
            r"design.limits must allow a value of ball.layers\[0\].thickness in .*: the smallest excess",
        ),
        (
            DESIGN.replace("{limits}", "{}").replace("to =", "until ="),
            "design.until is not a parameter, .*; design.to must be given",
        ),
        (DESIGN.replace("{limits}", "{}").replace("6e-3", "1e-4"), "design.from and design.to must be 0 < from < to"),
        (DESIGN.replace("{limits}", "{}").replace("thickness", "depth"), "shear|depth"),
    ],
)
def test_bad_designs(tmp_path, table, message):
    with pytest.raises(ValueError, match=message):
        design_case(case_file(tmp_path, RUBBER, table))
