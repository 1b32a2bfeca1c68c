"""The comparison with closed forms finds those of the classic cases of rolling contact."""

from __future__ import annotations

import csv

import pytest
from shared_cases import command
from viscoroll.case import load_case
from viscoroll.case.compare import compare_torques

RUBBER = (
    'shear_modulus = { type = "standard_linear_solid", instantaneous_modulus = 6e6, relaxed_modulus = 3e6, '
    "relaxation_time = 0.0125 }\n"
)
STEEL_BALL = "[ball]\n[[ball.layers]]\nthickness = 10e-3\nshear_modulus = 80e9\npoisson_ratio = 0.3\n"
HALF_SPACE = f"[plane.base]\npoisson_ratio = 0.5\n{RUBBER}"
THIN_LAYER = f"[[plane.layers]]\nthickness = 0.05e-3\npoisson_ratio = 0.3\n{RUBBER}"
CASES = {
    "steel ball on a half-space": (
        f"{STEEL_BALL}{HALF_SPACE}[rolling]\nload = 0.05\nangular_speed = 5.0\n",
        {"greenwood_tabor", "persson", "low_speed"},
    ),
    "steel ball on a thin layer": (
        f"{STEEL_BALL}{THIN_LAYER}[rolling]\nload = 5.0\nangular_speed = 5.0\n",
        {"greenwood_tabor", "persson", "low_speed", "winkler"},
    ),
    "roller on a half-plane": (
        f"[cylinder]\ncore_radius = 50e-3\n{HALF_SPACE}[rolling]\nload = 500.0\nangular_speed = 5.0\n",
        {"hunter", "low_speed"},
    ),
}


@pytest.fixture
def case_file(tmp_path):
    def write(text):
        path = tmp_path / "case.toml"
        path.write_text(f"{text}[numerics]\naccuracy = 0.02\n", encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize("name", CASES)
def test_classic_cases_have_closed_forms(case_file, tmp_path, name):
    text, forms = CASES[name]
    done = command("compare", case_file(text), "--points", "3", "--output", tmp_path / "torque.svg")
    assert done.returncode == 0, done.stderr
    with (tmp_path / "torque.csv").open(encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    assert {name.removesuffix("_is_valid") for name in head if name.endswith("_is_valid")} == forms
    assert len(rows) == 3


def test_the_torques_of_a_roller_are_those_of_hunter(case_file):
    """The tolerance is the accuracy of the mesh."""
    compared = compare_torques(load_case(case_file(CASES["roller on a half-plane"][0])), points=3)
    torques, valid = compared.forms["hunter"]
    assert valid.all()
    assert compared.torques == pytest.approx(torques, rel=0.02)
    axes = compared.plot().axes[0]
    assert axes.get_title() == "$P$ = 500 N/m"
    assert axes.get_ylabel() == "resisting torque $T_r$ [mN m/m]"
    assert axes.lines[0].get_ydata() == pytest.approx(1e3 * compared.torques)


def test_a_speed_over_the_ground_gives_way_to_the_speeds_of_the_comparison(case_file):
    text, _ = CASES["steel ball on a half-space"]
    by_angle, by_speed = (
        compare_torques(load_case(case_file(one)), speeds=(2.0, 50.0), points=2)
        for one in (text, text.replace("angular_speed = 5.0", 'speed = "0.05 m/s"'))
    )
    assert by_speed.torques.tolist() == by_angle.torques.tolist()
    assert by_speed.torques[1] != pytest.approx(by_speed.torques[0], rel=0.1)
