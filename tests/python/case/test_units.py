"""Numbers with units in files: the same case as its twin in SI units, and messages about wrong units."""

from __future__ import annotations

import math
import subprocess
import sys
from decimal import Decimal

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll.case import build_case, example_text, load_case
from viscoroll.case.design import design_case
from viscoroll.case.motion import load_motion
from viscoroll.case.quantities import as_quantity, in_si, range_in_si
from viscoroll.case.study import load_study

#: Exact values of units, from their definitions: the inch and the pound of 1959, the kilogram-force with 9.80665 m/s².
POUND_FORCE = Decimal("0.45359237") * Decimal("9.80665")
EXACT = {
    "m": {"m": "1", "mm": "1e-3", "cm": "1e-2", "µm": "1e-6", "um": "1e-6", "in": "0.0254", "ft": "0.3048"},
    "Pa": {"Pa": "1", "kPa": "1e3", "MPa": "1e6", "GPa": "1e9", "bar": "1e5", "N/mm^2": "1e6", "kgf/cm²": "98066.5"},
    "N": {"N": "1", "kN": "1e3", "kgf": "9.80665", "kg": "9.80665", "lbf": POUND_FORCE},
    "kg/m³": {"kg/m^3": "1", "g/cm³": "1e3", "g/cm3": "1e3", "t/m^3": "1e3"},
    "s": {"s": "1", "ms": "1e-3", "min": "60", "h": "3600"},
    "W/(m K)": {"W/(m K)": "1", "W/m/K": "1", "mW/(m K)": "1e-3"},
    "W/(m² K)": {"W/(m^2 K)": "1", "W/m²/K": "1"},
    "J/mol": {"J/mol": "1", "kJ/mol": "1e3"},
    "m/s": {"m/s": "1", "mph": "0.44704", "mm/s": "1e-3"},
}


@pytest.mark.parametrize(("si", "unit"), [(si, unit) for si, units in EXACT.items() for unit in units])
def test_decimal_units_are_converted_to_the_last_digit(si, unit):
    rng = np.random.default_rng(48)
    for _ in range(200):
        number = f"{rng.uniform(0.1, 1000.0):.{rng.integers(0, 8)}f}"
        assert in_si(f"{number} {unit}", si, path="x") == float(Decimal(number) * Decimal(EXACT[si][unit]))


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("36 km/h", "m/s", 10.0),
        ("90 rpm", "rad/s", 3.0 * math.pi),
        ("1 Hz", "rad/s", 2.0 * math.pi),
        ("60 rpm", "Hz", 1.0),
        ("45 deg", "rad", math.pi / 4.0),
        ("23 degC", "K", 296.15),
        ("-10 °C", "K", 263.15),
        ("68 degF", "K", 293.15),
        ("23 C", "K", 296.15),
        ("51.6 K", "K", 51.6),
        ("55 %", "1", 0.55),
        ("1 psi", "Pa", float(POUND_FORCE / Decimal("0.0254") ** 2)),
        ("1 MPA", "Pa", 1e6),
        ("2 kN·m", "N m", 2000.0),
        ("5 Nm", "N m", 5.0),
        ('2 "', "m", 0.0508),
    ],
)
def test_units_have_their_usual_meaning(text, unit, value):
    assert in_si(text, unit, path="x") == value


@pytest.mark.parametrize(
    ("text", "unit", "message"),
    [
        ("10 MPa", "m", r"^x must be a length \[m\], got '10 MPa'$"),
        (
            "5 furlong",
            "m",
            r"^x must be a length \[m\], got '5 furlong'; the unit 'furlong' is not known; use for example mm",
        ),
        ("10", "m", r"^x must be a length \[m\], with its unit or without quotes, got '10'$"),
        ("4 km/h", "rad/s", "give the speed of the ground as speed$"),
        ("90 rpm", "m/s", "give the angular speed as angular_speed$"),
        ("300 N", "N/m", "values of rollers are per length: divide by the width$"),
        ("3 N/mm", "N", "only values of rollers are per length: multiply by the width$"),
        ("1 /s", "rad/s", "must be an angular speed or angular frequency"),
        ("1 m^99999", "m", "is not known; use for example mm, cm, m, in$"),
        ("1 mm)", "m", "is not known; use for example mm, cm, m, in$"),
        ("1e999 m", "m", "must be a finite number, got '1e999 m'$"),
        (
            "60 Shore",
            "Pa",
            r"got '60 Shore'; a hardness is a table: \{ type = \"hardness\", hardness = 60 \}, whose loss",
        ),
        ("45 Shore D", "Pa", r"a hardness is a table: \{ type = \"hardness\", hardness = 45, scale = \"D\" \}, whose"),
    ],
)
def test_wrong_units_are_rejected(text, unit, message):
    with pytest.raises(vr.InvalidInput, match=message):
        in_si(text, unit, path="x")


def test_a_difference_of_temperatures_has_no_zero():
    assert in_si("51.6 K", "K", path="c2", difference=True) == 51.6
    with pytest.raises(vr.InvalidInput, match="same number in K as in °C"):
        in_si("51.6 degC", "K", path="c2", difference=True)


@pytest.mark.parametrize("text", ["60A.toml", "60 Shore A.toml", "rubber", "1.2.csv", "../10 mm.csv", "3d_curve"])
def test_names_of_files_are_not_quantities(text):
    assert as_quantity(text) is None


WHEEL = """
[wheel]
{size}
width = {width}
[[wheel.layers]]
thickness = {thickness}
poisson_ratio = 0.5
density = {density}
[wheel.layers.shear_modulus]
type = "prony"
instantaneous_modulus = {modulus}
weights = [0.3, 0.2]
relaxation_times = [{t1}, {t2}]
[rolling]
load = {load}
angular_speed = {speed}
friction = 0.5
drive = {{ torque = {torque} }}
[thermal]
convection = {convection}
ambient = {ambient}
conductivity = [{conductivity}]
shift = {{ type = "williams_landel_ferry", c1 = 8.86, c2 = {c2}, reference_temperature = {reference} }}
"""

STYLES = {
    "SI": {
        "size": ("core_radius", 1, "m"), "width": (1, "m"), "thickness": (1, "m"), "density": (1, "kg/m^3"),
        "modulus": (1, "Pa"), "time": (1, "s"), "load": (1, "N"), "torque": (1, "N m"), "convection": (1, "W/(m^2 K)"),
        "conductivity": (1, "W/(m K)"), "temperature": (0, "K"),
    },
    "millimeters": {
        "size": ("outer_diameter", "1e-3", "mm"), "width": ("1e-3", "mm"), "thickness": ("1e-3", "mm"),
        "density": ("1e3", "g/cm^3"), "modulus": ("1e6", "MPa"), "time": ("1e-3", "ms"), "load": ("9.80665", "kgf"),
        "torque": ("1e-3", "N mm"), "convection": (1, "W/m²/K"), "conductivity": ("1e-3", "mW/(m K)"),
        "temperature": ("273.15", "degC"),
    },
    "inches": {
        "size": ("outer_diameter", "0.0254", "in"), "width": ("0.0254", "inch"), "thickness": ("2.54e-5", "mil"),
        "density": (1, "kg/m³"), "modulus": ("1e3", "kPa"), "time": (60, "min"), "load": (POUND_FORCE, "lbf"),
        "torque": (POUND_FORCE * Decimal("0.0254"), "lbf in"), "convection": (1, "W/(m² K)"),
        "conductivity": (1, "W/m/K"), "temperature": ("273.15", "°C"),
    },
}  # fmt: skip


@pytest.mark.parametrize("style", STYLES)
def test_files_in_units_equal_their_twins_in_si_units(tmp_path, style):
    rng = np.random.default_rng(4)
    units = STYLES[style]
    for _ in range(25):
        key, *of_size = units["size"]
        kinds = {
            "size": (of_size, rng.uniform(50, 400) * 1e-3), "width": (units["width"], rng.uniform(10, 100) * 1e-3),
            "thickness": (units["thickness"], rng.uniform(1, 9) * 1e-3),
            "density": (units["density"], rng.uniform(900, 1300)),
            "modulus": (units["modulus"], rng.uniform(1, 9) * 1e6), "t1": (units["time"], rng.uniform(0.001, 0.1)),
            "t2": (units["time"], rng.uniform(0.2, 9)), "load": (units["load"], rng.uniform(50, 900)),
            "torque": (units["torque"], rng.uniform(0.1, 3)), "convection": (units["convection"], rng.uniform(5, 50)),
            "conductivity": (units["conductivity"], rng.uniform(0.1, 0.4)),
        }  # fmt: skip
        typed, twin = {}, {}
        for name, ((scale, unit), value) in kinds.items():
            number = f"{Decimal(value) / Decimal(scale):.5g}"
            typed[name], twin[name] = f'"{number} {unit}"', repr(float(Decimal(number) * Decimal(scale)))
        zero, unit = units["temperature"]
        for name, value in (("ambient", rng.uniform(280, 310)), ("reference", rng.uniform(280, 310))):
            number = f"{Decimal(value) - Decimal(zero):.2f}"
            typed[name], twin[name] = f'"{number} {unit}"', repr(float(Decimal(number) + Decimal(zero)))
        number = f"{rng.uniform(10, 900):.2f}"  # 2 pi/60 is no decimal number: within one unit of the last digit
        typed["speed"], speed = f'"{number} rpm"', float(number) * math.pi / 30.0
        typed["c2"], twin["c2"] = '"101.6 K"', "101.6"
        cases = []
        for values in (typed, twin | {"speed": repr(speed)}):
            path = tmp_path / "case.toml"
            path.write_text(WHEEL.format(**values | {"size": f"{key} = {values['size']}"}), encoding="utf-8")
            cases.append(load_case(path))
        one, other = cases
        assert abs(one.angular_speed - speed) <= math.ulp(speed)
        assert (one.body, one.load, one.drive, one.thermal) == (other.body, other.load, other.drive, other.thermal)


COVER = {"thickness": "8 mm", "shear_modulus": "2 MPa", "poisson_ratio": 0.5}
ROLLER = {
    "cylinder": {"outer_diameter": "100 mm", "layers": [COVER]},
    "rolling": {"load": "3 kN/m", "speed": "36 km/h"},
}


def test_keys_that_bodies_do_not_have():
    for key, message in (
        ("width", "loads, forces and torques of rollers are per length: multiply them by the width"),
        ("shear_modulus", "did you mean cylinder.layers\\[0\\].shear_modulus"),
    ):
        with pytest.raises(vr.InvalidInput, match=rf"cylinder.{key} is not a parameter, got 1.0; {message}"):
            build_case(ROLLER | {"cylinder": ROLLER["cylinder"] | {key: 1.0}}, None)


@pytest.mark.parametrize(
    ("text", "unit", "ends"),
    [
        ("0.05..25", "rad/s", (0.05, 25.0)),
        ("30..60 rpm", "rad/s", (math.pi, 2.0 * math.pi)),
        ("-35C..20.5C", "K", (238.15, 293.65)),
        ("-35..20.5 degC", "K", (238.15, 293.65)),
        ("238..433", "K", (238.0, 433.0)),
    ],
)
def test_ranges_with_units(text, unit, ends):
    assert range_in_si(text, unit, path="--range") == pytest.approx(ends, rel=1e-15)


@pytest.mark.parametrize("text", ["5", "5 m..6 m", "..5", "cold..hot"])
def test_wrong_ranges(text):
    with pytest.raises(vr.InvalidInput, match=r"^--range must (have the form from\.\.to|be a temperature \[K\]), got"):
        range_in_si(text, "K", path="--range")


def test_rollers_have_loads_per_length():
    case = build_case(ROLLER, None)
    assert (case.load, case.speed, case.body.core_radius, case.body.outer_radius) == (3000.0, 10.0, 0.042, 0.05)
    with pytest.raises(
        vr.InvalidInput, match=r"rolling.load must be a force per length \[N/m\], got '3 kN'; values of"
    ):
        build_case(ROLLER | {"rolling": ROLLER["rolling"] | {"load": "3 kN"}}, None)


def test_messages_list_all_wrong_units():
    wrong = {"wheel": {"outer_diameter": "50 MPa", "width": "30 mm", "layers": [{"thickness": "10 MPa"}]}}
    message = r"^wheel.outer_diameter must be a length .*, got '50 MPa'; wheel.layers\[0\].thickness must be a length"
    with pytest.raises(vr.InvalidInput, match=message):
        build_case(wrong, None)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"core_radius": 0.04}, r"^cylinder.outer_diameter must be left out if core_radius is given$"),
        (
            {"outer_diameter": "16 mm"},
            r"^cylinder.outer_diameter must be > 0.016 m, twice the thickness of the layers, got",
        ),
        ({"outer_diameter": math.nan}, "cylinder.outer_diameter must be"),
    ],
)
def test_outer_diameters_are_checked(changes, message):
    with pytest.raises(vr.InvalidInput, match=message):
        build_case(ROLLER | {"cylinder": ROLLER["cylinder"] | changes}, None)


def test_solid_balls_have_no_outer_diameter():
    ball = {"outer_diameter": "16 mm", "inner_boundary": "solid", "layers": [COVER]}
    with pytest.raises(vr.InvalidInput, match=r"^ball.outer_diameter must be left out for a solid ball"):
        build_case({"ball": ball, "rolling": {"load": 1.0, "angular_speed": 1.0}}, None)


def test_a_missing_size_is_reported_as_the_radius_of_the_core():
    with pytest.raises(vr.InvalidInput, match=r"^cylinder.core_radius must be given"):
        build_case(ROLLER | {"cylinder": {"layers": [COVER]}}, None)


def written(tmp_path, text):
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_axes_of_a_study_have_units(tmp_path):
    text = (
        example_text().replace("core_radius = 20e-3", 'outer_diameter = "42 mm"')
        + '[sweep]\n"rolling.load" = ["100 N", "20 kgf"]\n'
        + '"ball.layers[0].thickness" = { from = "1 mm", to = "2 mm", count = 2 }\n'
    )
    plan = load_study(written(tmp_path, text))
    assert [one.values for one in plan.dimensions] == [(100.0, 196.133), (0.001, 0.002)]
    assert [case.body.outer_radius for case in plan.cases] == pytest.approx(
        [0.021] * 4, rel=1e-15
    )  # the diameter is kept
    wrong = text.replace('"20 kgf"', '"20 mm"')
    with pytest.raises(vr.InvalidInput, match=r"sweep.\"rolling.load\"\[1\] must be a force \[N\], got '20 mm'"):
        load_study(written(tmp_path, wrong))


def test_designs_have_units(tmp_path):
    text = example_text() + (
        '[design]\nvary = "ball.layers[0].thickness"\nfrom = "1 mm"\nto = "10 MPa"\n'
        'limits = { max_pressure = "5 MPa" }\n'
    )
    with pytest.raises(vr.InvalidInput, match=r"design.to must be a length \[m\], got '10 MPa'"):
        design_case(written(tmp_path, text))
    with pytest.raises(vr.InvalidInput, match=r"design.limits.max_pressure must be a stress or modulus"):
        design_case(written(tmp_path, text.replace("10 MPa", "4 mm").replace("5 MPa", "5 mm")))


def test_motions_have_units(tmp_path):
    text = example_text("motion")
    typed = text.replace("time = [0.0, 0.4,", 'time = ["0 ms", "400 ms",').replace("load = 100.0", 'load = "0.1 kN"', 1)
    one, other = load_motion(written(tmp_path, typed)), load_motion(written(tmp_path, text))
    assert np.array_equal(one.time, other.time)
    assert one.load == other.load
    swing = text[: text.index("time = [")] + 'load = 100.0\namplitude = "5 deg"\nfrequency = "60 rpm"\n'
    swung = load_motion(written(tmp_path, swing))
    assert max(swung.angle) == pytest.approx(math.radians(5.0), rel=1e-14)
    assert swung.time[-1] == 1.0


def test_pint_is_imported_only_for_texts_with_units(tmp_path):
    plain = written(tmp_path, example_text())
    check = "import sys; from viscoroll.case import load_case; load_case(sys.argv[1]); print('pint' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", check, plain], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout == "False\n"
    plain.write_text(example_text().replace("load = 100.0 ", 'load = "100 N" '), encoding="utf-8")
    done = subprocess.run([sys.executable, "-c", check, plain], capture_output=True, encoding="utf-8", check=True)
    assert done.stdout == "True\n"


def test_the_command_names_file_and_key(tmp_path):
    path = written(tmp_path, example_text().replace("thickness = 1e-3", 'thickness = "10 MPa"', 1))
    done = command("solve", path)
    assert done.returncode == 2
    assert done.stderr.strip().endswith("case.toml: ball.layers[0].thickness must be a length [m], got '10 MPa'")
