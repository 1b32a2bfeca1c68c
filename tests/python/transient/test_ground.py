"""Rolling over uneven ground and with treads: laws, an independent program, and saved states.

`python -m tests.reference.ground 1000` prints the reference values; they agree with those of another program within the
printed digits (docs/theory/ground.md, "Evidence").
"""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference import ground as reference
from shared_cases import one_layer

LOAD, RADIUS = 5e3, 60e-3
ROLLER = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(thickness=10e-3)])
BUMP = vr.Profile.half_sine(1e-3, length=20e-3, at=40e-3)
FINE, COARSE = vr.Mesh(nodes_per_revolution=1000), vr.Mesh(nodes_per_revolution=500)


def over(ground, speed, *, body=ROLLER, start=0.0, end=80e-3, mesh=FINE, **options):
    """Return the history of a body that rolls from one distance to another [m] at a speed [m/s]."""
    options = {"load": LOAD} | options
    distance = [start, end]
    return vr.roll(body, time=[0.0, abs(end - start) / speed], distance=distance, ground=ground, mesh=mesh, **options)


def series(history):
    return history._series()


@pytest.mark.parametrize(
    ("speed", "moments", "extremes", "deepest", "dissipated"),
    [
        (6e-3, [29.7566, 15.9288, 1.3169, -13.2233, -26.8606], (34.471, -30.031), -0.63063, 3.6022),
        (60e-3, [29.4406, 16.4308, 2.2222, -12.1565, -25.7814], (35.319, -30.561), -0.71192, 3.4497),
    ],
)
def test_half_sine_bump(speed, moments, extremes, deepest, dissipated):
    """Moments at single positions depend on the round-off of the time steps in the last digits of the reference."""
    h = over(BUMP, speed)
    found = np.interp([30e-3, 35e-3, 40e-3, 45e-3, 50e-3], h.distance, h.resisting_torque)
    np.testing.assert_allclose(found, moments, atol=2e-3)
    assert h.resisting_torque.max() == pytest.approx(extremes[0], abs=0.05)
    assert h.resisting_torque.min() == pytest.approx(extremes[1], abs=0.05)
    assert h.penetration.min() * 1e3 == pytest.approx(deepest, abs=1e-4)
    assert h.dissipated_energy[-1] == pytest.approx(dissipated, abs=2e-3)
    assert h.energy_balance_error[-1] < 1e-3


def test_the_window_reaches_an_obstacle_ahead():
    """With the window of flat ground, the largest moment would be 75.1 N at 21.2 mm."""
    with pytest.warns(vr.ResultWarning, match="heights of ground differ by 0.05 of the radius"):
        h = over(vr.Profile.half_sine(3e-3, length=20e-3, at=40e-3), 60e-3, end=60e-3)
    highest = h.resisting_torque.argmax()
    assert h.resisting_torque[highest] == pytest.approx(79.77, abs=0.05)
    assert h.distance[highest] * 1e3 == pytest.approx(20.0, abs=0.1)
    assert h.energy_balance_error[-1] < 1e-3


def test_a_thin_layer_climbs_a_bump_that_is_higher_than_its_thickness():
    """The contact lies ahead of the axle, where the surface of the body is higher: the layer is hardly indented."""
    thin = vr.CoatedCylinder(core_radius=59.7e-3, layers=[one_layer(thickness=0.3e-3)])
    h = over(BUMP, 60e-3, body=thin, end=50e-3, mesh=vr.Mesh(nodes_per_revolution=2000), averaged_meshes=1)
    assert h.penetration.min() == pytest.approx(-1e-3, abs=0.1e-3)
    assert h.energy_balance_error[-1] < 5e-3


def test_step_and_joint():
    """Largest moment and penetration converge at a step (2.1, 0.95, 0.43 N between meshes of 500, 1000, 2000 nodes)."""
    h = over(vr.Profile.step(0.5e-3, at=40e-3), 60e-3)
    assert h.resisting_torque.max() == pytest.approx(24.056, abs=0.02)
    assert h.penetration[-1] * 1e3 == pytest.approx(-0.3048, abs=2e-4)
    h = over(vr.Profile.joint(1e-3, width=6e-3, at=40e-3), 60e-3)
    assert h.resisting_torque.max() == pytest.approx(11.144, abs=0.05)
    assert h.dissipated_energy[-1] == pytest.approx(3.4894, abs=1e-3)


def test_corrugation():
    r = reference.roll(reference.corrugation(1e-4, 12e-3), nodes=500, speed=60e-3, end=84e-3)
    h = over(vr.Profile.corrugation(1e-4, period=12e-3), 60e-3, mesh=COARSE, end=float(r.distance[-1]))
    np.testing.assert_allclose(h.resisting_torque, r.moment, atol=5e-3)
    assert h.dissipated_energy[-1] == pytest.approx(r.dissipated[-1], rel=1e-3)


def test_axle_at_a_fixed_height():
    flat = over(None, 60e-3, end=1e-3)
    bump = vr.Profile.half_sine(0.5e-3, length=20e-3, at=40e-3)
    for speed, load, place, moment in ((6e-3, 19827, 39.4, 42.67), (60e-3, 28483, 38.5, 66.07)):
        h = over(bump, speed, load=None, axle_height=float(flat.axle_height[0]))
        highest = h.load.argmax()
        assert h.load[0] == pytest.approx(LOAD, rel=1e-3)  # the mean height of four meshes
        assert h.load[highest] == pytest.approx(load, rel=2e-3)
        assert h.distance[highest] * 1e3 == pytest.approx(place, abs=0.15)
        assert h.resisting_torque.max() == pytest.approx(moment, rel=2e-3)
        np.testing.assert_allclose(h.axle_height, flat.axle_height[0], rtol=1e-12)
        assert h.energy_balance_error[-1] < 1e-3


@pytest.mark.parametrize("friction", [0.3, 2.0])
def test_friction_at_a_given_height(friction):
    """The heights that a history under load found, given, return its load and its tractions."""
    options = {"friction": friction, "mesh": COARSE, "averaged_meshes": 1}
    h = over(BUMP, 60e-3, end=60e-3, **options)
    stepper = vr.RollingHistory(ROLLER, load=LOAD, ground=BUMP, steps_per_spacing=None, **options)
    found = [
        stepper.advance(time=time, angle=angle, axle_height=height)
        for time, angle, height in zip(h.time[1:], h.angle[1:], h.axle_height[1:], strict=True)
    ]
    np.testing.assert_allclose([one.load for one in found], LOAD, rtol=1e-7)
    torque = [one.driving_torque for one in found]
    np.testing.assert_allclose(torque, h.driving_torque[1:], atol=1e-6 * h.resisting_torque.max())
    assert found[-1].slip_energy == pytest.approx(h.slip_energy[-1], rel=1e-6)


def test_friction_from_a_given_height():
    """From the start, which depends on how the body was pressed onto the ground."""
    options = {"mesh": COARSE, "averaged_meshes": 1, "friction": 0.3}
    height = float(over(None, 60e-3, end=1e-3, **options).axle_height[0])
    # The error of the balance halves with the time step: 1.07e-3 with 4 steps per spacing, 0.57e-3 with 8.
    h = over(BUMP, 60e-3, load=None, axle_height=height, steps_per_spacing=8, **options)
    smooth = over(BUMP, 60e-3, load=None, axle_height=height, mesh=COARSE, averaged_meshes=1)
    np.testing.assert_allclose(h.axle_height, height, rtol=1e-12)
    assert h.load[0] == pytest.approx(LOAD, rel=2e-3)
    assert h.load.max() == pytest.approx(smooth.load.max(), rel=0.1)  # friction stiffens the contact
    assert h.energy_balance_error[-1] < 1e-3


def test_axle_height_and_push_force_are_results():
    h = over(BUMP, 60e-3, mesh=COARSE, end=10e-3)
    np.testing.assert_allclose(h.axle_height, RADIUS - h.penetration, rtol=1e-14)
    np.testing.assert_allclose(h.resisting_force, h.resisting_torque / RADIUS, rtol=1e-12, atol=1e-12)
    assert h.units["resisting_force"] == "N/m"
    assert h.scalars()["largest_resisting_force"] == h.resisting_force.max()


def test_zero_profiles_are_smooth_to_the_last_digit():
    zero = vr.Profile([0.0, 1.0], [0.0, 0.0])
    plain, flat = (
        over(None, 60e-3, mesh=COARSE),
        over(zero, 60e-3, mesh=COARSE, tread=vr.Profile([0.0, 0.1], [0.0, 0.0])),
    )
    for name, values in series(plain).items():
        np.testing.assert_array_equal(values, getattr(flat, name), err_msg=name)


def test_shift_by_whole_spacings():
    moved = 7 * RADIUS * COARSE.spacing
    one = over(BUMP, 60e-3, mesh=COARSE)
    other = over(
        vr.Profile.half_sine(1e-3, length=20e-3, at=40e-3 + moved), 60e-3, mesh=COARSE, start=moved, end=80e-3 + moved
    )
    np.testing.assert_allclose(other.resisting_torque, one.resisting_torque, atol=1e-9 * one.resisting_torque.max())
    np.testing.assert_allclose(other.penetration, one.penetration, atol=1e-12)


def test_elastic_body_rolls_back_with_the_opposite_moment():
    elastic = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(vr.Elastic(modulus=3e6), thickness=10e-3)])
    lopsided = vr.Profile([30e-3, 45e-3, 50e-3], [0.0, 1e-3, 0.0])
    mirrored = vr.Profile([-50e-3, -45e-3, -30e-3], [0.0, 1e-3, 0.0])
    forward = over(lopsided, 60e-3, body=elastic, mesh=COARSE)
    backward = over(mirrored, 60e-3, body=elastic, mesh=COARSE, end=-80e-3)
    assert forward.dissipated_energy[-1] == pytest.approx(0.0, abs=1e-12)
    largest = forward.resisting_torque.max()
    np.testing.assert_allclose(backward.resisting_torque, -forward.resisting_torque, atol=3e-3 * largest)
    np.testing.assert_allclose(forward.work, forward.stored_energy - forward.stored_energy[0], atol=2e-3 * largest)


def test_slow_rolling_loses_what_flat_ground_loses():
    """D = V τ̄ P L / R with τ̄ = 0.125 s, over any profile; ratios of another program: 0.985 and 0.988 on 1000 nodes."""
    speed, length = 0.2e-3, 80e-3
    law = speed * 0.125 * LOAD * length / RADIUS
    bump = over(BUMP, speed)
    flat = over(None, speed)
    ends = [0, -1]
    assert np.diff(bump.dissipated_energy[ends])[0] / law == pytest.approx(0.985, abs=2e-3)
    assert np.diff(flat.dissipated_energy[ends])[0] / law == pytest.approx(0.988, abs=2e-3)


def test_slow_rolling_at_a_fixed_height():
    """D = (V τ̄ / R) ∫ P ds with the elastic load, which the load approaches; ratio of another program: 0.991."""
    speed = 0.1e-3
    flat = over(None, speed, end=1e-3)
    bump = vr.Profile.half_sine(0.5e-3, length=20e-3, at=40e-3)
    h = over(bump, speed, load=None, axle_height=float(flat.axle_height[0]))
    work = 0.5 * np.sum((h.load[1:] + h.load[:-1]) * np.diff(h.distance))
    assert h.dissipated_energy[-1] / (speed * 0.125 / RADIUS * work) == pytest.approx(0.991, abs=4e-3)


def test_lugs():
    """24 lugs of 2 mm with 40 % void at 1 rad/s: another program has a mean of 2.806 N on 720 nodes."""
    pitch = 2.0 * np.pi * RADIUS / 24
    lugs = vr.Profile([0.0, 0.6 * pitch, 0.6 * pitch, pitch], [0.0, 0.0, -2e-3, -2e-3], periodic=True)
    h = over(None, RADIUS, tread=lugs, mesh=vr.Mesh(nodes_per_revolution=720), end=4.0 * RADIUS)
    pitches = h.angle > 4.0 - 9.0 * np.pi / 12.0
    assert h.resisting_torque[pitches].mean() == pytest.approx(2.806, abs=0.03)
    assert h.resisting_torque[pitches].min() == pytest.approx(-7.1, abs=0.3)
    assert h.resisting_torque[pitches].max() == pytest.approx(11.8, abs=0.3)
    assert h.energy_balance_error[-1] < 0.03  # steps of the height


def test_tread_and_ground_against_the_reference():
    texture = vr.Profile.corrugation(0.2e-3, period=2.0 * np.pi * RADIUS / 20)
    r = reference.roll(
        reference.half_sine(0.6e-3, 20e-3, 40e-3),
        tread=reference.corrugation(0.2e-3, 2.0 * np.pi * RADIUS / 20),
        nodes=500,
        speed=60e-3,
        end=60e-3,
    )
    bump = vr.Profile.half_sine(0.6e-3, length=20e-3, at=40e-3)
    h = over(bump, 60e-3, tread=texture, mesh=COARSE, end=float(r.distance[-1]))
    np.testing.assert_allclose(h.distance, r.distance, atol=1e-12)  # the same steps
    np.testing.assert_allclose(h.resisting_torque, r.moment, atol=0.01)
    assert h.dissipated_energy[-1] == pytest.approx(r.dissipated[-1], rel=1e-3)


def test_tread_returns_with_every_turn():
    flat_spot = vr.Profile([0.1, 0.11, 0.12], [0.0, -0.2e-3, 0.0])
    circumference = 2.0 * np.pi * RADIUS
    h = over(None, 0.5, tread=flat_spot, mesh=COARSE, end=3.0 * circumference, averaged_meshes=1)
    turns = [np.interp(0.11 + (k + 0.02) * circumference, h.distance, h.resisting_torque) for k in (1, 2)]
    assert turns[0] == pytest.approx(turns[1], rel=1e-3)


def test_force_on_the_center_follows_the_slope():
    """T = M - R Q, and Q = Σ p b' has the work of the lift: M is even about a symmetric bump of an elastic body."""
    h = over(BUMP, 60e-3)
    np.testing.assert_allclose(
        h.driving_torque, h.resisting_torque - RADIUS * h.driving_force, atol=1e-9 * h.resisting_torque.max()
    )
    assert h.driving_force.max() > 300.0


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_rigid_ball_over_a_bump_of_a_mat(friction):
    mat = vr.CoatedPlane(layers=[one_layer(thickness=2e-3)])
    ball = vr.CoatedSphere(core_radius=20e-3)
    bump = vr.Profile.half_sine(0.2e-3, length=6e-3, at=10e-3)
    h = vr.roll(
        ball, on=mat, time=[0.0, 0.3], distance=[0.0, 18e-3], load=20.0, ground=bump, friction=friction,
        mesh=vr.Mesh(nodes_per_revolution=400), averaged_meshes=1,
    )  # fmt: skip
    assert h.resisting_torque.max() > 2.0 * h.resisting_torque[h.distance < 4e-3].min()
    assert h.energy_balance_error[-1] < 0.02
    assert np.abs(h.driving_torque).max() < 1e-6 * h.resisting_torque.max() or friction > 0.0


def test_friction_over_a_bump():
    h = over(BUMP, 60e-3, mesh=COARSE, friction=0.5, averaged_meshes=1)
    smooth = over(BUMP, 60e-3, mesh=COARSE, averaged_meshes=1)
    assert h.energy_balance_error[-1] < 5e-3
    assert h.penetration.min() == pytest.approx(smooth.penetration.min(), rel=0.05)
    assert h.resisting_torque.max() == pytest.approx(smooth.resisting_torque.max(), rel=0.1)


def test_lifted_body_touches_the_highest_point():
    ground = vr.Profile.half_sine(1e-3, length=20e-3, at=40e-3)
    h = vr.roll(
        ROLLER, time=[0.0, 0.0, 4.0, 4.0], distance=[0.0, 0.0, 40e-3, 40e-3], load=[LOAD, 0.0, 0.0, 0.0],
        ground=ground, mesh=COARSE, averaged_meshes=1,
    )  # fmt: skip
    assert h.penetration[-1] == pytest.approx(-1e-3, rel=1e-2)


@pytest.mark.parametrize(
    "options", [{"ground": BUMP}, {"tread": vr.Profile.corrugation(1e-4, period=RADIUS * np.pi / 20)}]
)
def test_saved_states_resume_to_the_last_bit(options, tmp_path):
    plan = {"time": [0.0, 1.0], "distance": [0.0, 60e-3], "load": LOAD, "mesh": COARSE, "averaged_meshes": 2}
    whole = vr.roll(ROLLER, **plan, contact_times=[0.5], **options)
    first = vr.roll(ROLLER, **plan | {"time": [0.0, 0.5], "distance": [0.0, 30e-3]}, **options)
    first.state.save(tmp_path / "a.state")
    rest = vr.roll(ROLLER, **plan, start=vr.RollingState.load(tmp_path / "a.state"), **options)
    half = np.searchsorted(whole.time, 0.5)
    for name, values in series(rest).items():
        np.testing.assert_array_equal(values, getattr(whole, name)[half:], err_msg=name)


def test_a_state_of_another_ground_is_rejected():
    stepper = vr.RollingHistory(ROLLER, load=LOAD, mesh=COARSE, averaged_meshes=1, ground=BUMP)
    with pytest.raises(vr.InvalidInput, match="start must be a state with the same ground, got a state with another"):
        vr.RollingHistory(ROLLER, load=LOAD, mesh=COARSE, averaged_meshes=1, start=stepper.state)
    with pytest.raises(vr.InvalidInput, match="start must be a state with the same tread"):
        vr.RollingHistory(
            ROLLER, load=LOAD, mesh=COARSE, averaged_meshes=1, start=stepper.state, ground=BUMP,
            tread=vr.Profile([0.0, 0.1], [0.0, 1e-4]),
        )  # fmt: skip


def test_warnings():
    with pytest.warns(vr.ResultWarning, match=r"shortest feature of ground is 0\.001 m, 1\.3 node spacings"):
        over(vr.Profile.half_sine(1e-5, length=1e-3, at=5e-3), 60e-3, mesh=COARSE, end=8e-3, averaged_meshes=1)
    with pytest.warns(vr.ResultWarning, match="largest slope of ground is 1"):
        over(vr.Profile([0.0, 1e-2, 1.1e-2, 1.0], [0.0, 0.0, 1e-3, 1e-3]), 60e-3, end=1e-3, averaged_meshes=1)
    with pytest.warns(vr.ResultWarning, match=r"rolls beyond the end of ground at 0\.01 m, where its height stays"):
        over(vr.Profile([-1.0, 0.0, 0.01], [0.0, 0.0, 1e-4]), 60e-3, mesh=COARSE, end=12e-3, averaged_meshes=1)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (
            {"tread": vr.Profile([0.0, 1.0], [0.0, 1e-4])},
            r"tread\.distance must be in \[0, 0\.377\] m, the circumference",
        ),
        ({"tread": vr.Profile.corrugation(1e-4, period=0.1)}, r"tread\.distance must be such that the circumference"),
        ({"load": None, "axle_height": 61e-3}, r"axle_height must be < r_o = 0\.06"),
        ({"axle_height": 59.8e-3}, "exactly one of load and axle_height must be given, got both"),
        ({"load": None}, "exactly one of load and axle_height must be given, got none"),
    ],
)
def test_messages(options, message):
    with pytest.raises(ValueError, match=message):
        over(BUMP, 60e-3, mesh=COARSE, **options)


def test_line_contact_on_a_half_space():
    """A half-space is a much thicker mat; the window sees the obstacle ahead without a penetration."""
    rubber = one_layer(thickness=10e-3).shear_modulus
    rigid = vr.CoatedCylinder(core_radius=RADIUS)
    soft = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=rubber, poisson_ratio=0.5))
    thick = vr.CoatedPlane(layers=[vr.Layer(thickness=0.3, shear_modulus=rubber, poisson_ratio=0.5)])
    bump = vr.Profile.half_sine(2e-3, length=24e-3, at=40e-3)
    h, mat = (over(bump, 60e-3, body=rigid, on=on, mesh=COARSE, averaged_meshes=2, end=60e-3) for on in (soft, thick))
    np.testing.assert_allclose(h.resisting_torque, mat.resisting_torque, atol=0.02 * mat.resisting_torque.max())
    np.testing.assert_allclose(h.contact_length, mat.contact_length, rtol=0.1)  # a node of 15 in contact
    assert np.isnan(h.penetration).all()
    assert np.isnan(h.axle_height).all()
    assert h.energy_balance_error[-1] < 1e-3
    with pytest.raises(vr.InvalidInput, match="axle must be left out in line contact on a half-space"):
        over(bump, 60e-3, body=rigid, on=soft, mesh=COARSE, axle=vr.Axle(mass=1.0))
