"""Stress relaxation and creep: reading, one spectrum for all tests, shifts, intervals, and the command."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from campaign.time_intervals import (
    CASE,
    FREQUENCIES,
    REFERENCE,
    TIMES,
    ball,
    creep,
    measured,
    moduli_inside,
    relaxation,
    torque_interval,
    true_modulus,
)
from shared_cases import command
from viscoroll.rheology import TimeTest, fit_spectrum, read_time_tests

DATA = Path(__file__).parent / "data"


def written(tmp_path, text, name="data.csv"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


def test_a_relaxation_test_is_read_and_fitted():
    data = read_time_tests(DATA / "relaxation.csv", tensile=False)
    (test,) = data.tests
    assert (test.kind, test.time.size, test.time[0], test.modulus[0]) == ("relaxation", 40, 1e-3, 4.4798e6)
    assert fit_spectrum(data).scatter < 0.01


def test_a_creep_test_of_strain_and_stress(tmp_path):
    text = "t [min],strain [%],stress [kPa],T [°C]\n1,1,10,20\n2,1.25,10,20\n4,2,10,20\n"
    (test,) = read_time_tests(written(tmp_path, text), tensile=True, poisson_ratio=0.25).tests
    assert test.kind == "creep"
    np.testing.assert_allclose(test.time, [60.0, 120.0, 240.0], rtol=1e-15)
    np.testing.assert_allclose(test.modulus, np.array([1e6, 8e5, 5e5]) / 2.5, rtol=1e-14)
    assert test.temperature == 293.15


def test_a_relaxation_test_of_stress_and_strain(tmp_path):
    text = "Time (s);Strain (%);Stress (kPa)\n1;2,001;20\n2;2,0;16\n4;1,999;12\n8;2,0;-1\n0;2,0;30\n"
    with pytest.raises(ValueError, match=r"column 'Stress' may be that of tension or shear: pass tensile=True"):
        read_time_tests(written(tmp_path, text))
    data = read_time_tests(written(tmp_path, text), tensile=False)
    assert data.tests[0].kind == "relaxation"
    np.testing.assert_allclose(data.tests[0].modulus, [20e3 / 0.02001, 8e5, 12e3 / 0.01999], rtol=1e-14)
    assert data.dropped == 2


@pytest.mark.parametrize(
    ("header", "kind", "expected"),
    [
        ("Zeit [h],Relaxationsmodul [kPa]", "relaxation", 1e3),
        ("temps [s],complaisance [1/MPa]", "creep", 1e6),
        ("時間 [s],緩和弾性率 [MPa]", "relaxation", 1e6),
        ("t [s],J(t) [Pa^-1]", "creep", 1.0),
        ("t [s],D(t) [mm2/N]", "creep", 1e6 / 3.0),
        ("time_s,E(t) [GPa]", "relaxation", 1e9 / 3.0),
        ("Time (s),Relaxation modulus G(t) (Pa)", "relaxation", 1.0),
        ("Time (s),Relaxation modulus E(t) (Pa)", "relaxation", 1.0 / 3.0),
        ("Time (s),Creep compliance J(t) (1/Pa)", "creep", 1.0),
    ],
)
def test_names_and_units_of_tests_over_time(tmp_path, header, kind, expected):
    text = f"{header}\n1,1\n2,1\n4,1\n"
    (test,) = read_time_tests(written(tmp_path, text), tensile=None if "(t)" in header else False).tests
    assert test.kind == kind
    np.testing.assert_allclose(test.modulus, expected, rtol=1e-14)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("t [s],stress [Pa]\n1,1\n2,1\n4,1\n", "must have columns of time and relaxation, .* of strain"),
        ("t [s],G(t) [1/Pa]\n1,1\n2,1\n4,1\n", r"column 'G\(t\)' \(relaxation\) must have a unit of 'Pa'"),
        ("time [weeks],G(t) [Pa]\n1,1\n2,1\n4,1\n", "column 'time' .* must have a unit of .*, got unit 'weeks'"),
        (
            "f (Hz),G' (Pa),G'' (Pa)\n1,1e6,1e5\n10,1e6,1e5\n",
            "must contain stress relaxation or creep over time, got 1",
        ),
        ("t [s],G(t) [Pa]\n1,1\n2,1\n", "time must be one-dimensional with at least 3 points"),
        (
            "t [s],G(t) [Pa]\n1,-5\n2,-5\n4,0\n",
            "data.csv: stress relaxation must have at least 3 points with time and modulus > 0, got none: "
            "all 3 points were dropped because time or modulus is missing or not positive",
        ),
        ("t [s],G(t) [Pa],T [K]\n1,1,300\n2,1,300\n4,1,310\n", "must be isothermal within 2 K, got 300 to 310 K"),
    ],
)
def test_messages(tmp_path, text, message):
    with pytest.raises(ValueError, match=message):
        read_time_tests(written(tmp_path, text), tensile=False)


def test_exact_data_of_all_kinds_give_the_material_and_its_shifts():
    tests = measured(0, 0.0, "all")
    for chosen in (tests, [tests[0], tests[4], tests[8]], tests[1::3]):
        fit = fit_spectrum(chosen, reference=REFERENCE)
        assert fit.scatter < 2e-3  # three terms per decade
        omega = np.geomspace(1e-2, 1.0, 9)
        modulus, true = fit.series.complex_modulus(omega), true_modulus().complex_modulus(omega)
        np.testing.assert_allclose(modulus.real, true.real, rtol=5e-3)
        np.testing.assert_allclose(modulus.imag, true.imag, rtol=2e-2)
        cold = true_modulus(308.15).complex_modulus(omega)
        if len(chosen) == len(tests):
            np.testing.assert_allclose(fit.factors.log10_factor, [20.0 / 9.0, 0.0, -20.0 / 13.0], atol=0.01)  # of WLF
            found = fit.series_at(temperature=303.15).complex_modulus(omega).real
            np.testing.assert_allclose(found, true_modulus(303.15).complex_modulus(omega).real, rtol=1e-2)
            assert (found > cold.real).all()


def test_creep_and_relaxation_of_one_material_are_consistent():
    # J(t) G(t) <= 1 with equality without relaxation, and J(t) -> 1/G(t) at both ends.
    product = relaxation(TIMES, REFERENCE) / creep(TIMES, REFERENCE)
    assert (product < 1.0).all()
    glassy = creep(np.array([1e-9]), REFERENCE) / relaxation(np.array([1e-9]), REFERENCE)
    np.testing.assert_allclose(glassy, 1.0, rtol=1e-3)


@pytest.mark.parametrize("kind", ["relaxation", "creep"])
def test_intervals_contain_the_truth(kind):
    inside = np.mean([moduli_inside(seed, 0.01, kind, 12)[0] for seed in range(3)])
    assert inside > 0.8  # 42 values; 100 data sets: `python -m tests.campaign.time_intervals`


def test_draws_give_an_interval_of_the_torque():
    """The interval of a sweep over the draws contains the torque of the rubber itself."""
    _, drawn = moduli_inside(0, 0.01, "relaxation", 4)
    torque, half = torque_interval(drawn)
    assert 0.0 < half < 0.1 * torque
    assert abs(torque - vr.solve(ball(true_modulus()), **CASE).resisting_torque) <= half


def test_given_shift_factors_are_kept():
    law = vr.materials.WilliamsLandelFerry(c1=10.0, c2=110.0, reference_temperature=REFERENCE)
    fit = fit_spectrum(measured(0, 0.01, "relaxation"), reference=REFERENCE, factors=law)
    np.testing.assert_allclose(fit.factors.log10_factor, [20.0 / 9.0, 0.0, -20.0 / 13.0], rtol=1e-12)


def test_rejected_data():
    tests = measured(0, 0.01, "relaxation")
    with pytest.raises(ValueError, match="reference must be given for several temperatures"):
        fit_spectrum(tests)
    with pytest.raises(ValueError, match="reference must be in the measured range"):
        fit_spectrum(tests, reference=400.0)
    with pytest.raises(TypeError, match="data must be measurements"):
        fit_spectrum([1.0])
    unknown = TimeTest(kind="relaxation", time=TIMES, modulus=tests[0].modulus)
    with pytest.raises(ValueError, match="data must have a temperature for every test or for none"):
        fit_spectrum([unknown, tests[1]], reference=REFERENCE)
    for floor in (0.0, 1e12, math.inf):
        with pytest.raises(ValueError, match=r"relaxed_floor must be in \(0, .*\] Pa, at most the lowest modulus"):
            fit_spectrum(tests[:1], relaxed_floor=floor)
    with pytest.raises(ValueError, match="time must increase"):
        TimeTest(kind="creep", time=[1.0, 3.0, 2.0], modulus=[1.0, 1.0, 1.0])


def test_a_modulus_that_grows_with_time_is_inconsistent(tmp_path):
    """No relaxation modulus grows. The command reports the scatter of the fit and does not save it."""
    time = np.geomspace(0.01, 100.0, 20)
    check = fit_spectrum(TimeTest(kind="relaxation", time=time, modulus=1e6 * time**0.3)).check
    assert not check.passed
    assert check.limit == 0.1
    rows = "".join(f"{t!r},{1e6 * t**0.3!r}\n" for t in time.tolist())
    path = written(tmp_path, "Time (s),Relaxation modulus G(t) (Pa)\n" + rows)
    saved = tmp_path / "grown.toml"
    done = command("material", path, "--save", saved)
    assert done.returncode == 2
    assert "scatter: INCONSISTENT, scatter about one series 63.45% (limit 10%)" in done.stdout
    assert "must be consistent with one passive material, got scatter about one series" in " ".join(done.stderr.split())
    assert not saved.exists()
    assert command("material", path, "--save", saved, "--accept").returncode == 0
    assert saved.exists()


def test_the_command_fits_time_and_frequency_files_together(tmp_path):
    arguments = []
    for kelvin, test in zip((303.15, 323.15, 343.15), measured(0, 0.0, "relaxation"), strict=True):
        rows = "".join(f"{t!r},{g!r}\n" for t, g in zip(test.time.tolist(), test.modulus.tolist(), strict=True))
        path = written(tmp_path, "Time [s],G(t) [Pa]\n" + rows, f"relaxation{kelvin:g}.csv")
        arguments.append(f"{path}@{kelvin}K")
    modulus = true_modulus().complex_modulus(FREQUENCIES)
    rows = "".join(
        f"{w!r},{m.real!r},{m.imag!r}\n" for w, m in zip(FREQUENCIES.tolist(), modulus.tolist(), strict=True)
    )
    sweep = written(tmp_path, "f [rad/s],G' [Pa],G'' [Pa]\n" + rows, "sweep.csv")
    saved = tmp_path / "rubber.toml"
    options = ["--reference", "323.15", "--at", "333.15", "--draws", "3", "--save", saved]
    done = command("material", *arguments, f"{sweep}@323.15K", *options)
    assert done.returncode == 0, done.stderr
    assert "SpectrumFit of 30 of storage and loss, 90 of relaxation" in " ".join(done.stdout.split())
    assert "at 333.15 K (60 °C), measured from" in done.stdout
    found = vr.rheology.load_material(saved, temperature=343.15, form="prony", draw=2)
    np.testing.assert_allclose(
        found.complex_modulus(1.0).real, true_modulus(343.15).complex_modulus(1.0).real, rtol=0.01
    )
