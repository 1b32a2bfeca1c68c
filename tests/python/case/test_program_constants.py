"""Case files and the command line with constants of finite-element programs."""

from __future__ import annotations

import viscoroll as vr
from shared_cases import command
from viscoroll.case import load_case

DECK = """\
*MATERIAL, NAME=TREAD
*ELASTIC, MODULI=INSTANTANEOUS
6.0, 0.5
*VISCOELASTIC, TIME=PRONY
0.3, 0.3, 0.1
*TRS
293.15, 8.86, 101.6
"""
CASE = """\
[rolling]
load = 50.0
angular_speed = 2.5

[ball]
core_radius = 20e-3

[[ball.layers]]
thickness = 2e-3
poisson_ratio = 0.5
shear_modulus = {{ type = "constants", file = "tread.inp", units = "mm-t-s"{more} }}
"""


def case_with(tmp_path, more=""):
    (tmp_path / "tread.inp").write_text(DECK)
    path = tmp_path / "case.toml"
    path.write_text(CASE.format(more=more))
    return path


def test_a_layer_takes_its_modulus_from_a_deck(tmp_path):
    case = load_case(case_with(tmp_path))
    expected = vr.Prony(instantaneous_modulus=2e6, weights=[0.3], relaxation_times=[0.1])
    assert case.body.layers[0].shear_modulus == expected
    shifted = load_case(case_with(tmp_path, ", temperature = 303.15")).body.layers[0].shear_modulus
    law = vr.materials.WilliamsLandelFerry(c1=8.86, c2=101.6, reference_temperature=293.15)
    assert shifted.relaxation_times == (0.1 * law(303.15),)


def test_a_layer_takes_absolute_moduli(tmp_path):
    deck = '{{ type = "constants", file = "tread.inp", units = "mm-t-s"{more} }}'
    series = '{{ type = "generalized_maxwell", relaxed_modulus = 1e6, moduli = [1e6], relaxation_times = [0.1] }}'
    path = tmp_path / "case.toml"
    path.write_text(CASE.replace(deck, series).format())
    expected = vr.Prony(instantaneous_modulus=2e6, weights=[0.5], relaxation_times=[0.1])
    assert load_case(path).body.layers[0].shear_modulus == expected


def test_messages_name_the_files(tmp_path):
    path = case_with(tmp_path, ', name = "other"')
    done = command("solve", path)
    assert done.returncode == 2
    assert "name must be that of one viscoelastic material, 'TREAD', got 'other'" in done.stderr
    (tmp_path / "tread.inp").unlink()
    assert "tread.inp: No such file or directory" in command("solve", path).stderr


def test_the_command_prints_the_constants_of_a_deck(tmp_path):
    case_with(tmp_path)
    done = command("material", tmp_path / "tread.inp", "--units", "mm-t-s")
    assert "Abaqus TREAD: shear modulus Prony(instantaneous_modulus=2000000.0" in done.stdout
    assert "shear_modulus = { type = 'constants', file = 'tread.inp', units = 'mm-t-s' }" in done.stdout


def test_the_command_takes_temperatures_in_degrees_celsius(tmp_path):
    path = case_with(tmp_path, ', temperature_unit = "C"')
    deck = tmp_path / "tread.inp"
    deck.write_text(DECK.replace("293.15,", "20.0,"))
    failed = command("material", deck, "--units", "mm-t-s")
    assert failed.returncode == 2
    expected = (
        "line 6 (*TRS) must have a reference temperature >= 100 K, got 20 K; "
        'give temperature_unit="C" if the temperatures of the text are in °C'
    )
    assert expected in failed.stderr
    done = command("material", deck, "--units", "mm-t-s", "--temperature-unit", "C")
    assert "reference_temperature=293.15" in done.stdout
    line = "shear_modulus = { type = 'constants', file = 'tread.inp', units = 'mm-t-s', temperature_unit = 'C' }"
    assert line in done.stdout
    before, _, _ = path.read_text().partition("shear_modulus")
    path.write_text(before + line)
    assert load_case(path).body.layers[0].shear_modulus.instantaneous_modulus == 2e6


def test_options_that_do_not_apply_are_rejected_by_name(tmp_path):
    case_with(tmp_path)
    deck = tmp_path / "tread.inp"
    options = ("--save", tmp_path / "a.toml", "--at", "300", "--reference", "300", "--draws", "9", "--shear")
    failed = command("material", deck, "--units", "mm-t-s", *options)
    assert failed.returncode == 2
    assert f"--reference, --at, --tensile/--shear, --draws, --save must be left out with constants, which {deck}" in (
        failed.stderr
    )
    assert not (tmp_path / "a.toml").exists()
    measured = tmp_path / "a.csv"
    measured.write_text("frequency,storage,loss\n1,1e6,1e5\n")
    failed = command("material", measured, "--units", "mm-t-s")
    assert "--units must be left out without one input file of another program" in failed.stderr
    failed = command("material", tmp_path / "missing.inp", "--units", "mm-t-s")
    assert "--units" not in failed.stderr
