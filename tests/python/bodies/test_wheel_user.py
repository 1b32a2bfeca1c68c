"""What users meet of a wheel besides the numbers of a solve: parameters, messages, files, studies, closed forms."""

from __future__ import annotations

import copy
import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from specimens import RUBBER, one_layer
from viscoroll import analytic
from viscoroll.case import load_case
from viscoroll.studies.plan import plan_sweep

TREAD = one_layer(thickness=10e-3)
WHEEL = {"core_radius": 40e-3, "layers": [TREAD], "width": 30e-3}
FLAT = vr.CoatedWheel(**WHEEL)
CROWNED = vr.CoatedWheel(**WHEEL, crown_radius=0.3)


def test_parameters():
    wheel = vr.CoatedWheel(**WHEEL, crown_radius=0.3, hub="crowned", sides="endless")
    assert (wheel.outer_radius, wheel.thickness) == pytest.approx((50e-3, 10e-3), rel=1e-15)
    assert (wheel.hub, wheel.sides, wheel.line_contact) == (vr.Hub.CROWNED, vr.Sides.ENDLESS, False)
    assert (FLAT.crown_radius, FLAT.hub, FLAT.sides) == (math.inf, vr.Hub.STRAIGHT, vr.Sides.FREE)
    assert pickle.loads(pickle.dumps(wheel)) == copy.deepcopy(wheel) == wheel != CROWNED
    assert wheel.layers == (TREAD,)  # frozen


def test_crown():
    # A chord of the profile's circle.
    assert CROWNED.crown_drop(15e-3) == pytest.approx(0.3 - math.sqrt(0.3**2 - 15e-3**2), rel=1e-12)
    assert CROWNED.crown_drop(-15e-3) == CROWNED.crown_drop(15e-3)
    assert FLAT.crown_drop(15e-3) == 0.0


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"core_radius": 0.0}, "core_radius must be > 0 m .without a hub a wheel bends as a beam .*, got 0"),
        ({"core_radius": -1.0}, "core_radius must be > 0 m, got -1"),
        ({"width": 0.0}, "width must be > 0 m, got 0"),
        ({"width": math.inf}, "width must be > 0 m, got inf"),
        ({"crown_radius": 14e-3}, "crown_radius must be at least half of the width, 0.015 m, got 0.014 m"),
        ({"crown_radius": -1.0}, "crown_radius must be at least half of the width, .* got -1 m"),
        ({"crown_radius": 15.1e-3}, "crown_radius must be so large that the crown stays within the outermost layer"),
        ({"hub": "round"}, "hub must be one of straight, crowned, got 'round'"),
        ({"sides": "open"}, "sides must be one of free, endless, got 'open'"),
        ({"layers": [replace(TREAD, thickness=1e308)] * 2}, "outer radius must be finite, got inf"),
    ],
)
def test_bad_values(changes, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        vr.CoatedWheel(**WHEEL | changes)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"width": "30 mm"}, "width must be a real number, got str '30 mm'"),
        ({"hub": 1}, "hub must be a viscoroll.Hub, or one of straight, crowned, got 1"),
        ({"layers": [3]}, r"layers\[0\] must be a viscoroll.Layer, got 3"),
        ({"crown": 0.3}, "CoatedWheel.. got an unexpected keyword argument 'crown'; did you mean crown_radius?"),
        ({"breadth": 0.03}, "did you mean width?"),
        ({"tread": TREAD}, "did you mean layers?"),
    ],
)
def test_bad_types_and_names(keywords, message):
    with pytest.raises(TypeError, match=message):
        vr.CoatedWheel(**WHEEL | keywords)


def test_lengths_in_millimeters_are_told():
    wheel = vr.CoatedWheel(core_radius=40.0, layers=[replace(TREAD, thickness=10.0)], width=30.0)
    assert "SI units: outer_radius = 50 m, width = 30 m, layers[0].thickness = 10 m" in str(wheel)
    assert "SI units" not in str(CROWNED)


def test_table_of_a_notebook():
    table = CROWNED._repr_html_()
    for cells in ('crown radius</td><td style="text-align: left">0.3</td><td style="text-align: left">m', "STRAIGHT"):
        assert cells in table


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: vr.roll(FLAT, time=[0.0, 1.0], angle=[0.0, 1.0], load=1.0), "ball must be a ball: starting and stop"),
        (lambda: vr.RollingHistory(FLAT, load=1.0), "of a wheel is not there yet"),
        (
            lambda: vr.self_heating(FLAT, load=1.0, angular_speed=1.0, convection=1.0, ambient=293.0, shift=abs),
            "ball must be a ball: self-heating of a wheel is not there yet",
        ),
        (lambda: vr.solve("wheel", load=1.0, angular_speed=1.0), "or viscoroll.CoatedWheel, got 'wheel'"),
    ],
)
def test_what_wheels_do_not_have_yet(call, message):
    with pytest.raises(TypeError, match=message):
        call()


CASE = """
[wheel]
core_radius = 40e-3
width = 30e-3
crown_radius = 0.3
hub = "crowned"
[[wheel.layers]]
thickness = 10e-3
poisson_ratio = 0.5
shear_modulus = { type = "standard_linear_solid", instantaneous_modulus = 6e6, relaxed_modulus = 3e6, \
relaxation_time = 0.125 }
[rolling]
load = 500.0
angular_speed = 2.5
"""


def test_case_files(tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(CASE)
    case = load_case(path)
    assert case.ball == vr.CoatedWheel(**WHEEL, crown_radius=0.3, hub="crowned")
    assert case.on is None
    path.write_text(CASE + "[other_wheel]\ncore_radius = 20e-3\nlayers = []\nwidth = 30e-3\n")
    assert load_case(path).on == vr.CoatedWheel(core_radius=20e-3, layers=[], width=30e-3)


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ('hub = "crowned"', 'hub = "round"', "wheel: hub must be one of straight, crowned, got 'round'"),
        ("width = 30e-3", "", "wheel.width: field required"),
        ("crown_radius", "crown", "wheel.crown: .* not permitted, got 0.3"),
        ("width = 30e-3", "width = -1.0", "wheel: width must be > 0 m, got -1"),
        (
            "[rolling]",
            "[ball]\ncore_radius = 1.0\n[rolling]",
            "one of ball, cylinder, wheel must be given, got ball and",
        ),
        ("[rolling]", "[plane]\n[other_wheel]\ncore_radius = 1.0\nlayers = []\nwidth = 1.0\n[rolling]", "at most, got"),
    ],
)
def test_bad_case_files(tmp_path, before, after, message):
    path = tmp_path / "case.toml"
    path.write_text(CASE.replace(before, after, 1))
    with pytest.raises(ValueError, match=message):
        load_case(path)


def test_studies_tell_wheels_apart():
    """By everything that changes the result, in the keys of a cache and in the groups that share tables."""
    changes = [{}, {"width": 29e-3}, {"crown_radius": 0.31}, {"hub": "crowned"}, {"sides": "endless"}]
    keys = []
    for changed in changes:
        plan = plan_sweep(replace(CROWNED, **changed), {"load": [100.0], "angular_speed": 1.0}, fields=())
        keys.append(plan.keys[0])
        on = plan_sweep(CROWNED, {"on": replace(CROWNED, **changed), "load": [100.0], "angular_speed": 1.0}, fields=())
        keys.append(on.keys[0])
    assert len(set(keys)) == 2 * len(changes)


def test_flat_wheels_have_the_forms_of_rollers():
    wide = vr.CoatedWheel(core_radius=20e-3, layers=[one_layer(thickness=30e-3)], width=0.4)
    roller = analytic.applicable(vr.CoatedCylinder(core_radius=20e-3, layers=wide.layers))
    forms = analytic.applicable(wide)
    assert forms.keys() == roller.keys() == {"low_speed", "hunter"}
    for name, form in forms.items():
        assert form(40.0, 0.5) == pytest.approx(0.4 * roller[name](100.0, 0.5), rel=1e-14)
    assert forms["hunter"].holds(40.0, 0.5)
    narrow = analytic.applicable(replace(wide, width=0.2))
    assert narrow["hunter"](20.0, 0.5) == pytest.approx(0.5 * forms["hunter"](40.0, 0.5), rel=1e-14)
    assert not narrow["hunter"].holds(20.0, 0.5)  # the faces count
    assert narrow["low_speed"].holds(20.0, 1e-3)  # but not where the torque is that of any contact


def test_crowned_wheels_have_the_forms_of_ellipses():
    forms = analytic.applicable(CROWNED)
    assert forms.keys() == {"low_speed", "greenwood_tabor", "persson"}
    contact = analytic.hertz_ellipse(
        load=0.5, radius=50e-3, crown_radius=0.3, shear_modulus=RUBBER.relaxed_modulus, poisson_ratio=0.5
    )
    assert forms["greenwood_tabor"](0.5, 1.0) == pytest.approx(3.0 / 32.0 * contact.semi_axis_x, rel=1e-12)
    assert forms["persson"].holds(0.1, 1.0)
    assert not forms["persson"].holds([1.0, 500.0], 1.0).any()  # the longer semi-axis is 2.3 mm, and more
    slow = forms["low_speed"]
    assert slow(500.0, 0.01) == pytest.approx(500.0 * 0.01 * 50e-3 * 0.125, rel=1e-9)
    np.testing.assert_array_equal(slow.holds(500.0, [1e-2, 10.0]), [True, False])


def test_rigid_bodies_have_no_closed_form():
    assert analytic.applicable(vr.CoatedWheel(core_radius=50e-3, layers=[], width=30e-3)) == {}
    assert analytic.applicable(vr.CoatedSphere(core_radius=50e-3)) == {}


def test_frequencies_of_rolling():
    """The highest goes with the contact's length along the path: the narrower the wheel, the longer."""
    crowned, wide = replace(CROWNED, width=0.1), replace(FLAT, width=0.1)
    _, of_crowned = vr.rolling_range(crowned, load=100.0, angular_speed=1.0)
    _, of_wide = vr.rolling_range(wide, load=100.0, angular_speed=1.0)
    roller = vr.CoatedCylinder(core_radius=40e-3, layers=[TREAD])
    assert (1.0, of_wide) == vr.rolling_range(roller, load=100.0 / 0.1, angular_speed=1.0)
    assert of_crowned < of_wide
    ball = vr.CoatedSphere(core_radius=40e-3, layers=[TREAD])
    as_round = replace(crowned, crown_radius=50e-3, width=90e-3, hub="crowned")
    assert vr.rolling_range(as_round, load=100.0, angular_speed=1.0) == pytest.approx(
        vr.rolling_range(ball, load=100.0, angular_speed=1.0), rel=1e-12
    )
