"""Temperatures that `viscoroll app` computes for its page."""

from __future__ import annotations

import json

import numpy as np
import pytest
from viscoroll.app.temperature import temperature_answer
from viscoroll.case import build_case

CASE = {
    "cylinder": {
        "core_radius": 0.04,
        "layers": [
            {
                "thickness": 0.01,
                "shear_modulus": {
                    "type": "standard_linear_solid",
                    "instantaneous_modulus": 6e6,
                    "relaxed_modulus": 3e6,
                    "relaxation_time": 0.125,
                },
                "poisson_ratio": 0.49,
            }
        ],
    },
    "rolling": {"load": 5000.0, "angular_speed": 20.0},
}
THERMAL = {"convection": 10.0, "ambient": 293.15, "conductivity": 0.2, "core": "isothermal"}


def test_numbers_and_section_are_those_of_the_package():
    found = temperature_answer({"case": CASE, "thermal": THERMAL})["temperature"]
    expected = build_case(CASE, None).solve().temperature(**THERMAL)
    for name in ("maximum", "surface_maximum", "mean", "heat", "heat_to_core", "ambient", "heat_unit"):
        assert found[name] == getattr(expected, name)
    assert list(found["axes"]) == ["radius", "z"]
    assert np.array_equal(found["axes"]["radius"], expected.rise.radius)
    assert np.array_equal(found["rise"], expected.rise)
    assert found["warnings"] == []
    json.dumps(found, allow_nan=False)


def test_warnings_about_the_temperature_are_returned():
    slow = CASE | {"rolling": {"load": 5000.0, "angular_speed": 1e-4}}
    (warning,) = temperature_answer({"case": slow, "thermal": THERMAL})["temperature"]["warnings"]
    assert warning.startswith("between passes, the temperature of a point varies")


@pytest.mark.parametrize(
    ("request_", "parameter"),
    [
        (None, "request"),
        ({"case": CASE}, "request"),
        ({"case": CASE, "thermal": None}, "thermal"),
        ({"case": CASE, "thermal": THERMAL | {"convection": -1.0}}, "convection"),
        ({"case": CASE | {"motion": {}}, "thermal": THERMAL}, "motion"),
        ({"case": CASE | {"rolling": CASE["rolling"] | {"load": -1.0}}, "thermal": THERMAL}, "load"),
    ],
)
def test_errors_name_their_parameter(request_, parameter):
    error = temperature_answer(request_)["error"]
    assert error["parameter"].rpartition(".")[2] == parameter, error
