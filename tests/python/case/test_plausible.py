"""Lengths in millimeters that a file gives as meters are rejected; large real bodies are not."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from campaign.unit_mistakes import MISTAKES, mistaken, outcome, random_file
from shared_cases import command
from viscoroll.app.answer import readable_case
from viscoroll.case import build_case, example_text
from viscoroll.case.plausible import speed_text, speed_warning

RUBBER = {"shear_modulus": 1e6, "poisson_ratio": 0.5}
ROLLING = {"load": 100.0, "angular_speed": 2.5}


def file_of(name, layer=2e-3, **body):
    return {name: body | {"layers": [RUBBER | {"thickness": layer}]}, "rolling": ROLLING}


@pytest.mark.parametrize(
    ("document", "message"),
    [
        (
            file_of("ball", 1.0, core_radius=20.0),
            r"^ball.core_radius must be at most 1.5 m, unless allow_large = true is written at the beginning of the "
            r'file, got 20 m; if millimeters were meant, write "20 mm"; also implausible: '
            r"ball.layers\[0\].thickness = 1 m$",
        ),
        (
            file_of("wheel", outer_diameter=125.0, width=0.03),
            r'^wheel.outer_diameter must be at most 8 m.*, got 125 m; if millimeters were meant, write "125 mm"$',
        ),
        (file_of("ball", 1.0, core_radius=0.02), r"^ball.layers\[0\].thickness must be at most 0.4 m"),
        (file_of("ball", 0.3, core_radius=0.02), r"thickness must be at most 8 times the radius of the core"),
        (file_of("wheel", core_radius=0.05, width=32.0), r'^wheel.width must be at most 15 m.*write "32 mm"$'),
        (file_of("wheel", core_radius=0.02, width=10.0), r"^wheel.width must be at most 100 times the outer radius"),
        (file_of("wheel", core_radius=0.05, width=0.03, crown_radius=300.0), r"^wheel.crown_radius must be so small"),
        (file_of("cylinder", core_radius=40.0), r"^cylinder.core_radius must be at most 4 m"),
        (file_of("ball", core_radius=0.02) | {"groove": {"radius": 30.0}}, r"^groove.radius must be at most 100 times"),
        (
            file_of("ball", core_radius=0.02) | {"plane": {"layers": [RUBBER | {"thickness": 3.0}]}},
            r"^plane.layers\[0\]",
        ),
        (
            file_of("cylinder", core_radius=0.04) | {"thermal": {"convection": 10.0, "ambient": 293.0, "width": 300.0}},
            r"^thermal.width must be at most 15 m",
        ),
    ],
)
def test_millimeters_are_rejected(document, message):
    with pytest.raises(vr.InvalidInput, match=message):
        build_case(document, None)
    assert build_case({"allow_large": True} | document, None)


def test_a_layer_in_millimeters_does_not_fit_into_the_outer_diameter():
    message = (
        r"^wheel.outer_diameter must be > 16 m, twice the thickness of the layers, got 0.125; "
        r'layers\[0\].thickness is 8 m: if millimeters were meant, write "8 mm"$'
    )
    with pytest.raises(vr.InvalidInput, match=message):
        build_case(file_of("wheel", 8.0, outer_diameter=0.125, width=0.03), None)


@pytest.mark.parametrize(
    "document",
    [
        file_of("cylinder", 20e-3, core_radius=3.3),  # drying cylinder of a paper machine
        file_of("wheel", 0.3, core_radius=1.6, width=1.2),  # tire of a dump truck
        file_of("wheel", 15e-3, core_radius=0.6, width=11.0),  # press roll
        file_of("wheel", 10e-3, core_radius=0.025, width=1.2),  # roller of a conveyor
        file_of("wheel", 10e-3, core_radius=0.1, width=1.0, crown_radius=1250.0),  # crown of 0.1 mm
        file_of("ball", core_radius=0.05) | {"groove": {"radius": 4.0}},  # dish of an isolation platform
        file_of("wheel", core_radius=1.0, width=0.3) | {"plane": {"layers": [RUBBER | {"thickness": 0.5}]}},  # road
    ],
)
def test_large_real_bodies_are_accepted(document):
    assert build_case(document, None)


def test_the_page_shows_units_and_accepts_all_sizes():
    assert readable_case(file_of("cylinder", core_radius=6.0)).body.core_radius == 6.0


def test_the_speed_of_the_surface_is_printed(tmp_path):
    assert speed_text(900.0, 0.05) == "surface at 45 m/s (162 km/h), 8594 rpm"
    assert speed_warning(900.0, 0.05).startswith("angular_speed = 900 rad/s: surface at 45 m/s")
    assert speed_warning(90.0, 0.05) == ""
    path = tmp_path / "case.toml"
    path.write_text(example_text().replace("accuracy = 0.01", "accuracy = 0.3"), encoding="utf-8")
    assert "surface at 0.0525 m/s (0.189 km/h), 23.87 rpm" in command("solve", path).stdout


def test_random_correct_files_are_accepted():
    rng = np.random.default_rng(3)
    for _ in range(200):
        assert build_case(random_file(rng), None)


@pytest.mark.parametrize("kind", MISTAKES)
def test_random_mistakes_are_not_solved_silently(kind):
    rng = np.random.default_rng(7)
    for _ in range(2):
        how = outcome(mistaken(random_file(rng), kind, rng))
        assert how in ("rejected", "warned") or (kind == "rpm for rad/s" and how == "stated")


def test_a_shore_hardness_in_place_of_a_modulus_is_recognized():
    ball = vr.CoatedSphere(core_radius=0.02, layers=[vr.Layer(thickness=1e-3, shear_modulus=60.0, poisson_ratio=0.5)])
    with pytest.warns(vr.ResultWarning, match="60 Pa at rest; were megapascals or a Shore hardness meant"):
        vr.solve(ball, penetration=5e-5, angular_speed=2.5, accuracy=0.3)
