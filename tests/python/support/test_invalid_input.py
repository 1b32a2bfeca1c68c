"""Errors about invalid input have the parameter, the rule and the value as attributes."""

from __future__ import annotations

import pickle
import re
from pathlib import Path

import pytest
import viscoroll as vr
from viscoroll._support.errors import InvalidInput, InvalidType, Range, in_file
from viscoroll.case import build_case

RUBBER = {"thickness": 0.01, "shear_modulus": 1e6, "poisson_ratio": 0.5}


def parts(error: InvalidInput) -> tuple[str, str, str]:
    return error.parameter, error.rule, error.value


@pytest.mark.parametrize(
    ("make", "expected"),
    [
        (lambda: vr.Layer(thickness=-1.0, shear_modulus=1e6), ("thickness", "must be > 0 m", "-1")),  # by the core
        (
            lambda: vr.Drive(),
            ("drive", "must have exactly one of force, torque, power and creepage", "none"),
        ),  # in Python
        (lambda: vr.Elastic(modulus="stiff"), ("modulus", "must be a real number", "str 'stiff'")),
    ],
    ids=["core", "Python", "type"],
)
def test_errors_have_parameter_rule_and_value(make, expected):
    with pytest.raises(vr.InvalidInput) as raised:
        make()
    assert parts(raised.value) == expected
    assert str(raised.value) == f"{expected[0]} {expected[1]}, got {expected[2]}"
    assert isinstance(raised.value, ValueError)


@pytest.mark.parametrize(
    ("make", "allowed"),
    [
        (  # by the core
            lambda: vr.Layer(thickness=-1.0, shear_modulus=1e6),
            Range(0.0, unit="m", excludes_minimum=True),
        ),
        (  # in Python
            lambda: vr.materials.WilliamsLandelFerry(c1=17.4, c2=-51.6, reference_temperature=293.15),
            Range(0.0, unit="K", excludes_minimum=True),
        ),
        (  # in a file
            lambda: build_case(
                {
                    "wheel": {"core_radius": 0.1, "width": -0.1, "layers": [RUBBER]},
                    "rolling": {"load": 1.0, "speed": 1.0},
                },
                None,
            ),
            Range(0.0, unit="m", excludes_minimum=True),
        ),
        (lambda: vr.Drive(), None),  # the rule is not a range
    ],
    ids=["core", "Python", "file", "other rule"],
)
def test_errors_about_ranges_have_unit_and_ends(make, allowed):
    with pytest.raises(vr.InvalidInput) as raised:
        make()
    assert raised.value.allowed == allowed
    assert pickle.loads(pickle.dumps(raised.value)).allowed == allowed
    if allowed is not None:
        assert raised.value.rule == f"must be {allowed}"


@pytest.mark.parametrize(
    ("interval", "text", "inside", "outside"),
    [
        (Range(0.0, unit="m", excludes_minimum=True), "> 0 m", [1e-9, 1e9], [0.0, -1.0]),
        (Range(maximum=4.0), "<= 4", [4.0, -1.0], [4.1]),
        (Range(0.0, 1.0, excludes_maximum=True), "in [0, 1)", [0.0, 0.9], [1.0, -0.1]),
        (Range(), "finite", [0.0, -1e300], []),
    ],
)
def test_ranges_contain_finite_numbers_between_their_ends(interval, text, inside, outside):
    assert str(interval) == text
    assert all(value in interval for value in inside)
    assert not any(value in interval for value in [*outside, float("nan"), float("inf"), -float("inf")])


def test_errors_of_wrong_types_are_type_errors():
    with pytest.raises(TypeError) as raised:
        vr.Elastic(modulus=None)
    assert isinstance(raised.value, InvalidType)


@pytest.mark.parametrize(
    ("parameter", "table", "path"),
    [
        ("thickness", "ball.layers[0]", "ball.layers[0].thickness"),
        ("core", "thermal.core", "thermal.core"),
        ("drive.spin", "rolling.drive", "rolling.drive.spin"),
        ("base.density", "plane.base", "plane.base.density"),
        ("motion.load", "motion", "motion.load"),
        ("layers[1]", "ball", "ball.layers[1]"),
        ("corestiffness", "thermal.core", "thermal.core.corestiffness"),
    ],
)
def test_paths_do_not_repeat_the_name_of_the_table(parameter, table, path):
    assert InvalidInput(parameter, "must be > 0").inside(table).parameter == path


def test_errors_keep_their_attributes_in_other_processes():
    error = InvalidType("a", "must be b", "c", more="d must be e", source="f.toml")
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is InvalidType
    assert vars(again) == vars(error)
    assert str(again) == str(error) == "f.toml: a must be b, got c; d must be e"


def test_errors_of_a_file_name_it():
    found = in_file(InvalidInput("load", "must be > 0 N", -1), "case.toml")
    assert isinstance(found, InvalidInput)
    assert (found.parameter, str(found)) == ("load", "case.toml: load must be > 0 N, got -1")
    assert str(in_file(ValueError("line\nbreak"), "a.csv")) == r"a.csv: line\nbreak"


def test_cases_name_the_path_of_the_parameter():
    layer = {"thickness": 1e-3, "shear_modulus": {"type": "prony", "instantaneous_modulus": 1e6, "weights": [2.0]}}
    layer["shear_modulus"]["relaxation_times"] = [1.0]
    case = {"wheel": {"core_radius": 0.1, "width": 0.1, "layers": [layer]}, "rolling": {"load": 1, "angular_speed": 1}}
    with pytest.raises(vr.InvalidInput) as raised:
        build_case(case, None)
    assert parts(raised.value) == ("wheel.layers[0].shear_modulus.weights[0]", "must be in [0, 1]", "2")


def test_no_code_reads_the_text_of_an_error():
    root = Path(__file__).parents[3]
    sources = [*root.glob("python/**/*.py"), *root.glob("cpp/**/*.[ch]pp"), *root.glob("wasm/src/*.[ch]pp")]
    reads = re.compile(
        r"str\((error|message)\)\.(startswith|partition|split|find)|in str\(error\)|what\(\)\)?\.?(find|substr)"
    )
    found = {path.name for path in sources if reads.search(path.read_text(encoding="utf-8"))}
    assert found == {"files.py"}  # the netCDF library reports a full disk only in the text
