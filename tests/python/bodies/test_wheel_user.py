"""Wheels in the user interface: parameters, messages, files, studies, and closed forms."""

from __future__ import annotations

import copy
import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, command, one_layer
from viscoroll import analytic, enums
from viscoroll.case import load_case
from viscoroll.studies.plan import plan_sweep

TREAD = one_layer(thickness=10e-3)
WHEEL = {"core_radius": 40e-3, "layers": [TREAD], "width": 30e-3}
FLAT = vr.CoatedWheel(**WHEEL)
CROWNED = vr.CoatedWheel(**WHEEL, crown_radius=0.3)
UNBOUNDED = replace(CROWNED, sides="unbounded")

#: About fifteen nodes across the contact under 100 N.
MESH = vr.Mesh(nodes_per_revolution=400)


def test_parameters():
    wheel = vr.CoatedWheel(**WHEEL, crown_radius=0.3, hub="crowned", sides="unbounded")
    assert (wheel.outer_radius, wheel.thickness) == pytest.approx((50e-3, 10e-3), rel=1e-15)
    assert (wheel.hub, wheel.sides, wheel.line_contact) == (enums.Hub.CROWNED, enums.Sides.UNBOUNDED, False)
    assert (FLAT.crown_radius, FLAT.hub, FLAT.sides) == (math.inf, enums.Hub.STRAIGHT, enums.Sides.FREE)
    assert pickle.loads(pickle.dumps(wheel)) == copy.deepcopy(wheel) == wheel != CROWNED
    assert wheel.layers == (TREAD,)  # frozen


def test_crown():
    # Drop of a chord of the profile's circle.
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
        ({"crown_radius": 15.1e-3}, "crown_radius must be so large that the crown drops at the faces by less than"),
        ({"hub": "round"}, "hub must be one of straight, crowned, got 'round'"),
        ({"sides": "open"}, "sides must be one of free, unbounded, got 'open'"),
        ({"layers": [replace(TREAD, thickness=1e9)]}, "core_radius must be at least 1e-09 of the radius"),
    ],
)
def test_bad_values(changes, message):
    with pytest.raises(ValueError, match=f"^{message}"):
        vr.CoatedWheel(**WHEEL | changes)


@pytest.mark.parametrize(
    ("keywords", "message"),
    [
        ({"width": "30 mm"}, "width must be a real number, got str '30 mm'"),
        ({"hub": 1}, "hub must be a viscoroll.enums.Hub, or one of straight, crowned, got 1"),
        ({"layers": [3]}, r"layers\[0\] must be a viscoroll.Layer, got 3"),
    ],
)
def test_bad_types_and_names(keywords, message):
    with pytest.raises(TypeError, match=message):
        vr.CoatedWheel(**WHEEL | keywords)


def test_lengths_in_millimeters_are_a_warning():
    wheel = vr.CoatedWheel(core_radius=40.0, layers=[replace(TREAD, thickness=10.0)], width=30.0)
    assert "SI units, got outer_radius = 50 m, width = 30 m, layers[0].thickness = 10 m" in str(wheel)
    assert "SI units" not in str(CROWNED)


def test_table_of_a_notebook():
    table = CROWNED._repr_html_()
    for cells in ('crown radius</td><td style="text-align: left">0.3</td><td style="text-align: left">m', "STRAIGHT"):
        assert cells in table


def test_a_word_is_not_a_wheel():
    with pytest.raises(TypeError, match=r"or viscoroll\.CoatedWheel, got 'wheel'"):
        vr.solve("wheel", load=1.0, angular_speed=1.0)


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
    assert case.body == vr.CoatedWheel(**WHEEL, crown_radius=0.3, hub="crowned")
    assert case.on is None
    path.write_text(CASE + "[other_wheel]\ncore_radius = 20e-3\nlayers = []\nwidth = 30e-3\n")
    assert load_case(path).on == vr.CoatedWheel(core_radius=20e-3, layers=[], width=30e-3)


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ('hub = "crowned"', 'hub = "round"', "wheel.hub must be one of straight, crowned, got 'round'"),
        ("width = 30e-3", "", "wheel.width must be given"),
        ("crown_radius", "crown", "wheel.crown is not a parameter, got 0.3"),
        ("width = 30e-3", "width = -1.0", "wheel.width must be > 0 m, got -1"),
        (
            "[rolling]",
            "[ball]\ncore_radius = 1.0\n[rolling]",
            "one of ball, cylinder, wheel must be given, got ball and",
        ),
        (
            "[rolling]",
            "[plane]\n[other_wheel]\ncore_radius = 1.0\nlayers = []\nwidth = 1.0\n[rolling]",
            "may be given, got",
        ),
    ],
)
def test_bad_case_files(tmp_path, before, after, message):
    path = tmp_path / "case.toml"
    path.write_text(CASE.replace(before, after, 1))
    with pytest.raises(ValueError, match=message):
        load_case(path)


def test_cache_keys_and_groups_distinguish_wheels():
    """The keys of a cache and the groups that share tables depend on every parameter that changes the result."""
    changes = [{}, {"width": 29e-3}, {"crown_radius": 0.31}, {"hub": "crowned"}, {"sides": "unbounded"}]
    keys = []
    for changed in changes:
        plan = plan_sweep(replace(CROWNED, **changed), {"load": [100.0], "angular_speed": 1.0}, fields=())
        keys.append(plan.keys[0])
        on = plan_sweep(CROWNED, {"on": replace(CROWNED, **changed), "load": [100.0], "angular_speed": 1.0}, fields=())
        keys.append(on.keys[0])
    assert len(set(keys)) == 2 * len(changes)


def test_closed_forms_of_flat_wheels_are_those_of_rollers():
    wide = vr.CoatedWheel(core_radius=20e-3, layers=[one_layer(thickness=30e-3)], width=0.4)
    roller = analytic.applicable(vr.CoatedCylinder(core_radius=20e-3, layers=wide.layers))
    forms = analytic.applicable(wide)
    assert forms.keys() == roller.keys() == {"low_speed", "hunter"}
    for name, form in forms.items():
        assert form(40.0, 0.5) == pytest.approx(0.4 * roller[name](100.0, 0.5), rel=1e-14)
    assert forms["hunter"].is_valid(40.0, 0.5)
    narrow = analytic.applicable(replace(wide, width=0.2))
    assert narrow["hunter"](20.0, 0.5) == pytest.approx(0.5 * forms["hunter"](40.0, 0.5), rel=1e-14)
    assert not narrow["hunter"].is_valid(20.0, 0.5)  # the faces change the contact
    assert narrow["low_speed"].is_valid(20.0, 1e-3)  # this torque does not depend on the contact


def test_closed_forms_of_crowned_wheels_are_those_of_ellipses():
    forms = analytic.applicable(CROWNED)
    assert forms.keys() == {"low_speed", "greenwood_tabor", "persson"}
    contact = analytic.hertz_ellipse(
        load=0.5, radius=50e-3, crown_radius=0.3, shear_modulus=RUBBER.relaxed_modulus, poisson_ratio=0.5
    )
    assert forms["greenwood_tabor"](0.5, 1.0) == pytest.approx(3.0 / 32.0 * contact.semi_axis_x, rel=1e-12)
    assert forms["persson"].is_valid(0.1, 1.0)
    assert not forms["persson"].is_valid([1.0, 500.0], 1.0).any()  # the longer semi-axis is 2.3 mm or more
    slow = forms["low_speed"]
    assert slow(500.0, 0.01) == pytest.approx(500.0 * 0.01 * 50e-3 * 0.125, rel=1e-9)
    np.testing.assert_array_equal(slow.is_valid(500.0, [1e-2, 10.0]), [True, False])


def test_rigid_bodies_have_no_closed_form():
    assert analytic.applicable(vr.CoatedWheel(core_radius=50e-3, layers=[], width=30e-3)) == {}
    assert analytic.applicable(vr.CoatedSphere(core_radius=50e-3)) == {}


def test_frequencies_of_rolling():
    """The highest frequency depends on the contact's length along the path, which is larger for a narrower wheel."""
    crowned, wide = replace(CROWNED, width=0.1), replace(FLAT, width=0.1)
    _, of_crowned = vr.rheology.rolling_range(crowned, load=100.0, angular_speed=1.0)
    _, of_wide = vr.rheology.rolling_range(wide, load=100.0, angular_speed=1.0)
    roller = vr.CoatedCylinder(core_radius=40e-3, layers=[TREAD])
    assert (1.0, of_wide) == vr.rheology.rolling_range(roller, load=100.0 / 0.1, angular_speed=1.0)
    assert of_crowned < of_wide
    ball = vr.CoatedSphere(core_radius=40e-3, layers=[TREAD])
    as_round = replace(crowned, crown_radius=50e-3, width=90e-3, hub="crowned")
    assert vr.rheology.rolling_range(as_round, load=100.0, angular_speed=1.0) == pytest.approx(
        vr.rheology.rolling_range(ball, load=100.0, angular_speed=1.0), rel=1e-12
    )


@pytest.fixture(scope="module")
def rolled():
    """Return the result for a crowned wheel whose contact ends before the faces."""
    return vr.solve(UNBOUNDED, load=100.0, angular_speed=2.5, accuracy=0.05)


def test_contact_width_and_distance_from_the_faces(rolled):
    """Compare with the nodes in contact; if the whole width is in contact, their patches end at the faces."""
    columns = rolled.z[0, rolled.contact.any(axis=0)]
    patch = abs(rolled.z[0, 1] - rolled.z[0, 0])
    assert rolled.contact_width == pytest.approx(np.ptp(columns) + patch, rel=1e-12)
    assert rolled.face_distance == pytest.approx(15e-3 - 0.5 * rolled.contact_width, rel=1e-9)
    assert 1.8 < rolled.contact_width / rolled.semi_axis_z < 2.3
    assert "distance from the contact to the faces" in repr(rolled)
    ball = vr.solve(vr.CoatedSphere(core_radius=40e-3, layers=[TREAD]), load=20.0, angular_speed=1.0, accuracy=0.1)
    assert ball.face_distance is None
    assert ball.contact_width == pytest.approx(2.0 * ball.semi_axis_z, rel=0.1)  # coarsely meshed disk
    roller = vr.CoatedCylinder(core_radius=40e-3, layers=[TREAD])
    line = vr.solve(roller, load=1e3, angular_speed=1.0, accuracy=0.1)
    assert (line.contact_width, line.face_distance) == (None, None)


def test_columns_of_nodes_cover_the_width(rolled):
    """The angles of a dataset are those of the nodes, whose spacing is not the mesh's."""
    theta = rolled.to_xarray().theta.to_numpy()
    np.testing.assert_allclose(np.abs(theta - 0.5 * np.pi) * UNBOUNDED.outer_radius, np.abs(rolled.z[0]), atol=1e-15)
    patches = 30e-3 / abs(rolled.z[0, 1] - rolled.z[0, 0])
    assert patches == pytest.approx(round(patches), rel=1e-9)
    spacing = 2.0 * np.pi / rolled.scalars()["theta_nodes_per_revolution"]
    assert spacing == pytest.approx(abs(theta[1] - theta[0]), rel=1e-12)


def test_files(rolled, tmp_path):
    xarray = pytest.importorskip("xarray")
    for suffix in (".csv", ".nc", ".vtu"):
        rolled.save(tmp_path / f"fields{suffix}")
    again = xarray.load_dataset(tmp_path / "fields.nc")
    assert again.attrs["face_distance"] == rolled.face_distance
    assert len((tmp_path / "fields.csv").read_text().splitlines()) == 1 + rolled.pressure.size
    copied = pickle.loads(pickle.dumps(rolled))
    assert copied.body == rolled.body
    assert copied.resisting_torque == rolled.resisting_torque


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_picture_shows_the_faces(rolled, friction):
    case = {"load": 100.0, "angular_speed": 2.5, "friction": friction, "mesh": MESH}
    result = vr.solve(UNBOUNDED, **case) if friction else rolled
    maps = result.plot().axes[: 2 if friction else 1]
    for axes in maps:
        heights = {line.get_ydata()[0] for line in axes.lines if len(set(line.get_ydata())) == 1}
        assert {-15.0, 15.0} <= {round(height, 9) for height in heights}
        assert axes.get_ylim()[1] > 15.0


def test_a_model_solves_as_a_single_call(rolled):
    model = vr.RollingModel(UNBOUNDED, angular_speed=2.5, mesh=MESH)
    one = vr.solve(UNBOUNDED, load=100.0, angular_speed=2.5, mesh=MESH)
    model.solve(load=50.0)
    # The tables reach as far as the largest load so far, so sums differ in the last digits.
    assert model.solve(load=100.0).resisting_torque == pytest.approx(one.resisting_torque, rel=1e-9)


def test_a_study(tmp_path):
    def wheel(width):
        return replace(UNBOUNDED, width=width)

    study = vr.sweep(
        wheel,
        width=[30e-3, 34e-3],
        load=[50.0, 100.0],
        angular_speed=2.5,
        accuracy=0.1,
        progress=False,
        cache=tmp_path / "study.nc",
        fields=["pressure"],
    )
    assert study.width.attrs["units"] == "m"
    assert study.attrs["title"] == "rolling resistance of a coated wheel"
    assert "crown_radius=0.3, hub=STRAIGHT, sides=UNBOUNDED" in study.attrs["body"]
    assert (study.face_distance.sel(width=34e-3) > study.face_distance.sel(width=30e-3)).all()
    # Both contacts are at least a thickness away from the faces, and an unbounded tread has no faces.
    torque = study.resisting_torque.to_numpy()
    assert torque[0] == pytest.approx(torque[1], rel=0.05)  # the meshes differ by 10 %
    with pytest.raises(ValueError, match="body must be a roller at all points or at none"):
        vr.sweep(
            lambda ends: UNBOUNDED if ends else vr.CoatedCylinder(core_radius=40e-3, layers=[TREAD]),
            ends=[0, 1],
            load=100.0,
            angular_speed=2.5,
            progress=False,
        )


def test_command_line(tmp_path):
    (tmp_path / "case.toml").write_text(CASE + "[numerics]\naccuracy = 0.1\n", encoding="utf-8")
    text = (tmp_path / "case.toml").read_text().replace('hub = "crowned"', 'sides = "unbounded"')
    (tmp_path / "case.toml").write_text(text.replace("load = 500.0", "load = 100.0"))
    done = command("solve", "case.toml", "--plot", "contact.png", "--save", "fields.csv", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "distance from the contact to the faces" in " ".join(done.stdout.split())
    assert (tmp_path / "contact.png").stat().st_size > 1000


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # the faces of an unbounded tread
@pytest.mark.parametrize("wheel", [replace(FLAT, sides="unbounded"), UNBOUNDED], ids=["flat", "crowned"])
def test_low_speed_torque(wheel):
    """T = P Ω R t for any shape of the contact, wherever the closed form declares itself valid."""
    form = analytic.applicable(wheel)["low_speed"]
    speed = 0.02
    assert form.is_valid(500.0, speed)
    r = vr.solve(wheel, load=500.0, angular_speed=speed, accuracy=0.02)
    # The torque approaches the limit slowly from below: if the surface travels 5 % of the contact in the loss time, it
    # is 9 % too small.
    assert 0.9 < r.driving_torque / form(500.0, speed) < 1.01


def test_small_contacts_agree_with_a_half_space():
    """On a thick tread far from its faces, compare with Hertz's ellipse and the torque of its spectrum."""
    tread = one_layer(vr.StandardLinearSolid(instantaneous_modulus=3.3e6, relaxed_modulus=3e6, relaxation_time=0.125))
    wheel = vr.CoatedWheel(
        core_radius=1e-3, layers=[replace(tread, thickness=49e-3)], width=60e-3, crown_radius=0.1, sides="unbounded"
    )
    load, speed = 2.0, 1.0
    torque = analytic.applicable(wheel)["persson"]
    assert torque.is_valid(load, speed)
    r = vr.solve(wheel, load=load, angular_speed=speed, accuracy=0.01)
    contact = analytic.hertz_ellipse(load=load, radius=50e-3, crown_radius=0.1, shear_modulus=3.1e6, poisson_ratio=0.5)
    # The modulus varies between 3 and 3.3 MPa, which changes lengths by 3 %. The closed form of the torque has a
    # relative error of the order of the loss factor, 0.1.
    assert (r.semi_axis_x, r.semi_axis_z) == pytest.approx((contact.semi_axis_x, contact.semi_axis_z), rel=0.03)
    assert r.driving_torque == pytest.approx(torque(load, speed), rel=0.1)
