"""Case files that the page opens, in Python and on the site."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import pytest
from viscoroll.app.case_text import opened
from viscoroll.case import example_text

PAGE = Path(__file__).parents[3] / "python" / "viscoroll" / "app" / "page"
NODE = shutil.which("node")

WHEEL = """
allow_large = false
wheel.outer_diameter = "100 mm"
wheel.width = "32 mm"
[[wheel.layers]]
thickness = "0.4 in"
density = "1.1 g/cm³"
poisson_ratio = 0.495
shear_modulus = { type = "loss_factor", modulus = "9 MPa", loss_factor = 0.2, reference_frequency = "50 Hz" }
[rolling]
load = "80 kg"
speed = "4 km/h"
"""
ROLLER = """
[cylinder]
outer_diameter = 0.1
[[cylinder.layers]]
thickness = 5e-3
poisson_ratio = 0.5
shear_modulus = { type = "published", name = "vinyl_nitrile_foam", temperature = "20 °C" }
[other_cylinder]
core_radius = "5 cm"
layers = []
[rolling]
load = "2 N/mm"
angular_speed = "90 rpm"
friction = 0.3
drive = { torque = "3 N mm/mm" }
[thermal]
convection = 10.0
ambient = "23 °C"
[sweep]
"rolling.load" = [1e3, 2e3]
"""


def test_tables_are_in_si_units():
    found = opened(WHEEL)
    assert found["skipped"] == []
    assert found["tables"]["rolling"] == {"load": pytest.approx(784.532), "speed": pytest.approx(4.0 / 3.6)}
    assert found["tables"]["wheel"]["core_radius"] == pytest.approx(0.05 - 0.4 * 0.0254)


def test_tables_that_the_page_does_not_support_are_skipped():
    found = opened(ROLLER)
    assert found["skipped"] == ["sweep"]
    assert list(found["tables"]) == ["cylinder", "other_cylinder", "rolling", "thermal"]
    assert found["tables"]["thermal"] == {"convection": 10.0, "ambient": 296.15}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (5, "request must be the text of a case file"),
        ("a = ", "not a TOML file: Invalid value (at end of document)"),
        (
            example_text().replace("friction = 0.0", "friction = inf"),
            "rolling.friction must be finite on the page, got inf",
        ),
        (example_text().replace("20e-3", "20.0"), "allow_large = true"),
        (example_text().replace("core_radius", "core_radios"), "core_radios"),
        (WHEEL.replace("9 MPa", "9 mm"), "must be"),
        (ROLLER.replace("convection", "convektion"), "convektion"),
        (WHEEL.replace('{ type = "loss_factor"', '{ file = "rubber.toml", type = "measured"'), "file"),
    ],
)
def test_other_files_are_rejected(text, message):
    assert message in opened(text)["error"]["message"]


@pytest.mark.skipif(NODE is None, reason="no node")
@pytest.mark.parametrize("text", [example_text(), WHEEL, ROLLER])
def test_the_site_reads_the_same_case(text):
    script = (
        f"import {{ openCase }} from {json.dumps((PAGE / 'case_file.js').as_uri())};"
        "console.log(JSON.stringify(openCase(process.argv[1])))"
    )
    words = [NODE, "--input-type=module", "--eval", script, text]
    found = json.loads(subprocess.run(words, capture_output=True, check=True, encoding="utf-8").stdout)
    expected = opened(text)
    unsupported = ["thermal"] if expected["tables"].pop("thermal", None) else []  # the site computes no temperatures
    assert found["skipped"] == unsupported + expected["skipped"]
    assert_same(found["tables"], expected["tables"])


def assert_same(found, expected):
    """Assert that tables have the same keys and values, and numbers that agree to the 13 digits of the page."""
    if isinstance(expected, dict):
        assert set(found) == set(expected)
        for name, value in expected.items():
            assert_same(found[name], value)
    elif isinstance(expected, list):
        assert len(found) == len(expected)
        for one, value in zip(found, expected, strict=True):
            assert_same(one, value)
    else:
        assert found == (pytest.approx(expected, rel=1e-12) if isinstance(expected, float) else expected)
