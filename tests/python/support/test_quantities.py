"""Values with units as text: readable units, and as many digits as error estimates support."""

from __future__ import annotations

import math

import numpy as np
import pytest
from viscoroll._support.quantities import percent_text, plain_number, quantity_text, quantity_texts, with_error
from viscoroll._support.scales import Scale
from viscoroll._support.units import DISPLAY_UNITS, PER_LENGTH, suitable_unit, unit_in_contact


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (35.97, 0.32, "36.0 ± 0.3"),
        (35.97, 0.28, "35.97 ± 0.28"),
        (466.43, 74.2, "470 ± 70"),
        (466.43, 12.4, "466 ± 12"),
        (-22.952, 1.2, "-23.0 ± 1.2"),
        (0.3, 1.4, "0.3 ± 1.4"),
        (11.391712, 1e-9, "11.3917"),
        (11.391712, None, "11.39"),
        (0.0, 0.0, "0"),
        (0.0, None, "0"),
        (math.inf, 1.0, "inf"),
        (2.0, math.inf, "2"),
    ],
)
def test_digits_follow_the_error(value, error, text):
    assert with_error(value, error) == text


def test_rounding_changes_a_value_by_less_than_its_error():
    rng = np.random.default_rng(48)
    for _ in range(2000):
        value = rng.choice([-1.0, 1.0]) * 10.0 ** rng.uniform(-3.0, 3.0)
        error = abs(value) * 10.0 ** rng.uniform(-8.0, 0.5)
        printed, _, shown = with_error(value, error).partition(" ± ")
        digits = printed.lstrip("-0.").replace(".", "")
        assert len(digits) <= 6, printed
        assert abs(float(printed) - value) <= 0.51 * max(error, 1e-5 * abs(value))
        if shown:
            # An error below the sixth digit of the value is rounded up to this digit.
            assert 0.6 * error <= float(shown) <= max(1.5 * error, 1.01e-5 * abs(value))


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (1.803, "N m", "1.803 N m"),
        (0.011392, "N m", "11.39 mN m"),
        (0.00075, "N m", "0.75 mN m"),
        (2.34e-3, "N m/m", "2.34 mN m/m"),
        (0.000147523, "m", "0.1475 mm"),
        (8.4613e6, "Pa", "8.461 MPa"),
        (1.2e5, "Pa", "0.12 MPa"),
        (5e3, "N/m", "5 kN/m"),
        (2.26e-5, "m^2", "22.6 mm²"),
        (0.0525, "m/s", "52.5 mm/s"),
        (0.0054, "1", "0.0054"),
        (293.15, "K", "293.1 K"),
        (0.0, "N m", "0 N m"),
        (None, "m", "undetermined"),
        (5, "1", "5"),
    ],
)
def test_units_are_readable(value, unit, text):
    assert quantity_text(value, unit) == text


def test_values_in_a_row_have_one_unit():
    assert quantity_texts([0.5, 20.0, None], "N", [0.1, None, None]) == (["0.50 ± 0.05", "20", "undetermined"], "N")


def test_ratios_in_percent():
    assert percent_text(0.14753) == "14.8 %"
    assert plain_number(123456.0) == "123500"
    assert plain_number(1.234e-7) == "1.234e-07"


@pytest.mark.parametrize("unit", DISPLAY_UNITS)
def test_displayed_numbers_are_moderate(unit):
    """Within the range of a table, displayed numbers are between 0.01 and 1e4; areas have squared prefixes."""
    scales = [scale for scale, _ in DISPLAY_UNITS[unit].values()]
    assert 1.0 in scales
    assert scales == sorted(scales, reverse=True)
    largest = 1e6 if unit == "m^2" else 1e4
    for value in np.geomspace(scales[-1], scales[0], 200):
        _, scale = suitable_unit(float(value), unit)
        assert 1e-3 <= value / scale <= largest


def test_units_in_line_contact_are_per_length():
    assert {unit_in_contact(unit, line_contact=True) for unit in ("N", "N m", "W")} == {"N/m", "N m/m", "W/m"}
    assert unit_in_contact("Pa", line_contact=True) == "Pa"
    assert unit_in_contact("N m", line_contact=False) == "N m"
    assert set(PER_LENGTH) >= {"N", "N m", "W", "m^2"}


def test_the_scale_of_an_axis_suits_its_largest_finite_value():
    assert Scale.of([1e-3, -20.0, np.nan, np.inf], "N m") == Scale(1.0, "N m")
    assert Scale.of([], "N") == Scale(1.0, "N")
    assert Scale.of([2e-3], "m").text("depth") == "depth [mm]"
    assert Scale.of([0.1], "1").text("creepage") == "creepage"
