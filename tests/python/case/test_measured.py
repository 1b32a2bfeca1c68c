"""Comparison of a case with measurements: files, error bands, pictures, and input checks."""

from __future__ import annotations

import csv

import numpy as np
import pytest
from shared_cases import command
from viscoroll.case import example_text, load_case
from viscoroll.case.measured import compare_measured, read_measurements

ROUGH = "accuracy = 0.05"


@pytest.fixture
def case_file(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(example_text().replace("accuracy = 0.01 ", f"{ROUGH} "), encoding="utf-8")
    return path


@pytest.fixture
def measurement_file(tmp_path):
    def write(text):
        path = tmp_path / "measured.csv"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_bands_are_the_error_estimates_of_the_results(case_file, measurement_file):
    # The loads are unordered, and one occurs twice.
    path = measurement_file("load,penetration,error\n100,1e-4,1e-6\n50, 8e-5, 2e-6\n100,2e-4,1e-6\n")
    case = load_case(case_file)
    trial = compare_measured(case, read_measurements(path))
    r = case.solve(threads=1)
    assert trial.computed[[0, 2]] == pytest.approx(r.penetration, rel=1e-12)
    assert trial.bands[0] == pytest.approx(r.penetration * (r.penetration_model_error + r.error_estimate), rel=1e-12)
    assert trial.computed[1] < trial.computed[0]


@pytest.mark.parametrize(("fraction", "agree"), [(0.9, 3), (1.1, 0)])
def test_bands_that_overlap_agree(case_file, measurement_file, fraction, agree):
    case, head = load_case(case_file), "angular_speed,driving_torque,error\n"
    found = compare_measured(case, read_measurements(measurement_file(head + "1,0,0\n2,0,0\n4,0,0\n")))
    # The bands overlap if the distance of the values is less than the sum of the half-widths.
    values = found.computed + fraction * (found.bands + 1e-3)
    rows = [f"{place},{value},1e-3\n" for place, value in zip((1, 2, 4), values, strict=True)]
    trial = compare_measured(case, read_measurements(measurement_file(head + "".join(rows))))
    assert trial.agrees.sum() == agree
    assert trial.verdict().startswith(f"{agree} of 3 measurements agree within the error bands")
    assert ("are apart by" in trial.verdict()) == (agree < 3)


def test_friction_of_the_case_is_used(case_file, measurement_file):
    case_file.write_text(case_file.read_text("utf-8").replace("friction = 0.0", "friction = 0.3"), encoding="utf-8")
    trial = compare_measured(
        load_case(case_file), read_measurements(measurement_file("angular_speed,slip_power,error\n0.2,1e-5,0\n"))
    )
    assert trial.computed[0] > 0.0


def test_command_draws_the_example(case_file, measurement_file, tmp_path):
    assert command("example", "--measured").stdout == example_text("measured")
    output = tmp_path / "both.png"
    done = command("compare", case_file, "--measured", measurement_file(example_text("measured")), "--output", output)
    assert done.returncode == 0, done.stderr
    assert "of 7 measurements agree within the error bands" in done.stdout
    assert output.stat().st_size > 10_000
    rows = list(csv.DictReader(output.with_suffix(".csv").read_text("utf-8").splitlines()))
    assert [float(row["angular_speed [rad/s]"]) for row in rows] == [0.25, 0.5, 1.0, 2.5, 5.0, 10.0, 25.0]
    apart = [
        abs(float(row["measured driving_torque [N m]"]) - float(row["computed driving_torque [N m]"]))
        - float(row["measured error [N m]"])
        - float(row["computed band [N m]"])
        for row in rows
    ]
    assert [row["agrees"] == "True" for row in rows] == list(np.array(apart) <= 0.0)


def test_a_roller_has_units_per_length(case_file, measurement_file):
    text = case_file.read_text("utf-8").replace("[ball]", "[cylinder]").replace("[[ball.", "[[cylinder.")
    text = (
        text.replace("[ball.", "[cylinder.")
        .replace('inner_boundary = "rigid"', "")
        .replace("load = 100.0", "load = 1e3")
    )
    case_file.write_text(text, encoding="utf-8")
    path = measurement_file("load,driving_torque,error\n1e3,1e-2,1e-3\n")
    axes = compare_measured(load_case(case_file), read_measurements(path)).plot().axes[0]
    assert axes.get_xlabel() == "load [kN/m]"
    assert axes.get_ylabel() == "driving torque T [mN m/m]"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "columns must be angular_speed or load, the name of a scalar result and error, got ''"),
        ("speed,driving_torque,error\n1,1,1\n", "columns must be .*, got 'speed,driving_torque,error'"),
        ("load,grip,error\n1,1,1\n", "columns must be .*, got 'load,grip,error'"),
        ("load,driving_torque\n1,1\n", "columns must be"),
        ("load,driving_torque,error\n", "load must have at least one value, got none"),
        ("load,driving_torque,error\n1,one,1\n", "must have numbers in the columns load, driving_torque, error"),
        ("load,driving_torque,error\n0,1,1\n", "load must be > 0 N, got 0"),
        ("angular_speed,driving_torque,error\n-1,1,1\n", "angular_speed must be > 0 rad/s, got -1"),
        ("load,driving_torque,error\n1,nan,1\n", "line 2: driving_torque must be a finite number, got 'nan'"),
        ("load,driving_torque,error\n1,0,5,0,1\n", r"line 2 must have 3 cells like the header, got 5"),
        ("load,driving_torque,error\n1_0,1,1\n", "line 2: load must be a finite number, got '1_0'"),
        ("load,driving_torque,error\n1,1,-2\n", "error must be >= 0, got -2"),
    ],
)
def test_bad_files_are_rejected(measurement_file, text, message):
    with pytest.raises(ValueError, match=message):
        read_measurements(measurement_file(text))


def test_undetermined_results_are_rejected(case_file, measurement_file):
    with pytest.raises(ValueError, match="creepage must be determined by the case, got None"):
        compare_measured(load_case(case_file), read_measurements(measurement_file("load,creepage,error\n100,0,1\n")))


def test_missing_files_and_options_that_exclude_each_other(case_file, measurement_file, tmp_path):
    done = command("compare", case_file, "--measured", tmp_path / "none.csv")
    assert done.returncode == 2
    assert "No such file" in done.stderr
    path = measurement_file(example_text("measured"))
    assert "--speeds must be left out" in command("compare", case_file, "--measured", path, "--speeds", "1..2").stderr
    assert "must be given alone, got --motion and --measured" in command("example", "--measured", "--motion").stderr
