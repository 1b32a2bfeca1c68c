"""The fitted surface of rolling resistance: NumPy's polynomials, and quantities outside the fit."""

from __future__ import annotations

import json

import numpy as np
import pytest
import viscoroll as vr
from numpy.polynomial.chebyshev import chebval2d
from viscoroll import enums

LOAD, SPEED = (20.0, 200.0), (0.5, 8.0)


@pytest.fixture
def surface():
    coefficients = np.random.default_rng(3).normal(size=(4, 3)) * 0.1 + [[-4.0, 0.5, 0.0]] + [[0.0]] * 4
    return vr.studies.RollingResistance(
        load=LOAD, angular_speed=SPEED, radius=0.021, coefficients=coefficients, error=1e-3, largest_error=2e-3
    )


def test_is_the_polynomial_of_logarithms(surface):
    load, speed = np.geomspace(*LOAD, 7)[:, None], np.geomspace(*SPEED, 5)
    x, y = (2.0 * np.log(v / a) / np.log(b / a) - 1.0 for v, (a, b) in ((load, LOAD), (speed, SPEED)))
    found = surface(load, speed)
    assert found.shape == (7, 5)
    np.testing.assert_allclose(found, np.exp(chebval2d(*np.broadcast_arrays(x, y), surface.coefficients)), rtol=1e-13)


def test_is_odd_and_defined_at_rest(surface):
    speed = np.array([0.0, 0.1, 0.5, 3.0])
    torque = surface(50.0, speed)
    np.testing.assert_array_equal(surface(50.0, -speed), -torque)
    assert torque[0] == 0.0
    assert torque[1] == pytest.approx(0.2 * torque[2], rel=1e-14)
    assert "below the lowest speed proportional to the speed (exponent of the fit there" in repr(surface)


def test_exponent_at_the_lowest_speed_agrees_with_differences(surface):
    load, step = np.sqrt(LOAD[0] * LOAD[1]), 1e-4
    ratio = surface(load, SPEED[0] * (1.0 + step)) / surface(load, SPEED[0])
    assert f"{np.log(ratio) / np.log1p(step):.2f}" in repr(surface)


def test_option_outside(surface):
    with pytest.raises(ValueError, match=r"load must be in \[20, 200\] N, the fitted range, got 0"):
        surface(0.0, 1.0)
    with pytest.raises(ValueError, match=r"angular_speed must be in \[-8, 8\] rad/s, the fitted range, got -9"):
        surface(50.0, [1.0, -9.0])
    assert surface(50.0, -8.0) == -surface(50.0, 8.0)  # the end of the range in both directions
    with pytest.raises(ValueError, match="outside must be one of error, hold, got 'guess'"):
        surface(50.0, 1.0, outside="guess")
    held = surface([0.0, 10.0, 400.0], 100.0, outside="hold")
    np.testing.assert_allclose(held, [0.0, *(surface([20.0, 200.0], 8.0) * [0.5, 2.0])], rtol=1e-14)
    with pytest.raises(ValueError, match="load must be >= 0 N, got -1"):
        surface(-1.0, 1.0, outside=enums.Extrapolation.HOLD)


def test_a_file_gives_the_same_numbers(surface, tmp_path):
    surface.save(tmp_path / "torque.json")
    again = vr.studies.RollingResistance.load_file(tmp_path / "torque.json")
    np.testing.assert_array_equal(again.coefficients, surface.coefficients)
    assert repr(again) == repr(surface)
    document = json.loads((tmp_path / "torque.json").read_text())
    for key in document.keys() - {"what"}:
        less = {name: value for name, value in document.items() if name != key}
        (tmp_path / "less.json").write_text(json.dumps(less))
        with pytest.raises(
            ValueError, match=f"must contain a rolling resistance saved by viscoroll .*'{key}' is missing"
        ):
            vr.studies.RollingResistance.load_file(tmp_path / "less.json")
    for other, message in (
        ("[1]", r"a JSON object, got \[1\]"),
        ("{", "Expecting property name"),
        (5000 * "[", "nested too deeply"),
        (json.dumps(document | {"load": None}), "load must be one-dimensional"),
        (json.dumps(document | {"load": [1.0, 2.0, 3.0]}), "load must be the two ends of a range"),
        (json.dumps(document | {"radius": -1.0}), "radius must be > 0 m, got -1"),
        (json.dumps(document | {"radius": True}), "radius must be a real number, got bool True"),
        (json.dumps(document | {"radius": 10**400}), r"radius must be <= 1.8e\+308 in magnitude"),
        (json.dumps(document | {"coefficients": 1.0}), "coefficients must be a list of rows, got 1.0"),
        (json.dumps(document | {"coefficients": [[1.0, "x"]]}), r"coefficients\[0\] must contain real numbers"),
    ):
        (tmp_path / "other.json").write_text(other)
        with pytest.raises(
            ValueError, match=f"other.json must contain a rolling resistance saved by viscoroll .*{message}"
        ):
            vr.studies.RollingResistance.load_file(tmp_path / "other.json")
