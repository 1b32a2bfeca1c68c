"""Axles with mass, spring and damper: flight and landing, vibration, energy, and an independent program."""

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


def over(ground, speed, axle, *, end=80e-3, mesh=FINE, **options):
    return vr.roll(
        ROLLER, time=[0.0, end / speed], distance=[0.0, end], load=LOAD, ground=ground, axle=axle, mesh=mesh, **options
    )


@pytest.mark.parametrize(("speed", "load", "place", "force"), [(0.3, 8061, 54.0, 546), (0.6, 19596, 59.0, 1156)])
def test_heavy_axle_over_a_bump(speed, load, place, force):
    """Values of `python -m tests.reference.ground 1000`; on 2000 nodes another program has 8075 and 19 610 N/m."""
    h = over(BUMP, speed, vr.Axle(mass=500.0))
    highest = h.load.argmax()
    assert h.load[highest] == pytest.approx(load, rel=2e-3)
    assert h.distance[highest] * 1e3 == pytest.approx(place, abs=0.2)
    assert h.resisting_torque.max() / RADIUS == pytest.approx(force, rel=2e-3)
    assert (h.load.min() == 0.0) == (speed == 0.6)
    assert h.energy_balance_error[-1] < 1e-3


@pytest.mark.parametrize("steps", [4, 8])
def test_the_time_integration_conserves_the_energy_of_the_axle(steps):
    """Work of the forces on the axle by the trapezoidal rule, over two flights and landings."""
    h = over(BUMP, 0.6, vr.Axle(mass=500.0), averaged_meshes=1, mesh=COARSE, steps_per_spacing=steps)
    assert (h.load == 0.0).sum() > 50
    force, sunk = h.axle_force - h.load, np.diff(h.penetration)
    work = np.append(0.0, np.cumsum(0.5 * (force[1:] + force[:-1]) * sunk))
    np.testing.assert_allclose(work, h.axle_energy, atol=1e-9 * h.axle_energy.max())
    assert h.energy_balance_error[-1] < 2e-3  # of one coarse mesh


def test_flight_is_free_fall():
    h = over(BUMP, 0.6, vr.Axle(mass=500.0))
    flying = np.flatnonzero(h.load == 0.0)
    assert flying.size > 5
    np.testing.assert_allclose(h.axle_acceleration[flying], -LOAD / 500.0, rtol=1e-9)
    whole = flying[20:60]  # the time integration follows a change of the force within some steps
    falls = np.diff(h.axle_height[whole], 2)
    np.testing.assert_allclose(falls / np.diff(h.time[whole])[:-1] ** 2, -LOAD / 500.0, rtol=1e-3)


def test_light_axle_follows_like_a_load():
    h = over(BUMP, 6e-3, vr.Axle(mass=1e-3), mesh=COARSE, averaged_meshes=1, end=60e-3)
    free = over(BUMP, 6e-3, None, mesh=COARSE, averaged_meshes=1, end=60e-3)
    np.testing.assert_allclose(h.load, LOAD, rtol=2e-3)
    found = np.interp(free.distance, h.distance, h.resisting_torque)
    np.testing.assert_allclose(found, free.resisting_torque, atol=0.05)


def test_stiff_spring_holds_the_height():
    h = over(vr.Profile.half_sine(0.5e-3, length=20e-3, at=40e-3), 60e-3, vr.Axle(stiffness=1e12))
    assert h.load.max() == pytest.approx(28483, rel=2e-3)  # that of a fixed height
    assert np.ptp(h.axle_height) < 1e-7


def test_spring_without_mass():
    """The spring takes up part of the lift: P + k (d - d_0) = W at every instant."""
    stiffness = 1e7
    h = over(BUMP, 60e-3, vr.Axle(stiffness=stiffness), mesh=COARSE)
    np.testing.assert_allclose(h.load + stiffness * (h.penetration - h.penetration[0]), LOAD, rtol=1e-6)
    assert h.energy_balance_error[-1] < 1e-3


@pytest.mark.parametrize("axle", [vr.Axle(mass=200.0, damping=2e3), vr.Axle(mass=100.0, stiffness=5e6, damping=1e4)])
def test_energy_balance(axle):
    h = over(BUMP, 0.3, axle)
    assert h.energy_balance_error[-1] < 1e-3
    assert h.axle_energy.max() > 0.0


def test_axle_at_rest_stays_at_rest():
    h = vr.roll(
        ROLLER, time=[0.0, 0.2], angle=[0.0, 0.0], load=LOAD, axle=vr.Axle(mass=100.0), mesh=COARSE, averaged_meshes=1
    )
    np.testing.assert_allclose(h.load, LOAD, rtol=1e-9)
    np.testing.assert_allclose(h.axle_speed, 0.0, atol=1e-12)


def test_vibration_of_an_elastic_contact():
    """A small jump of the force on the axle excites the frequency of the mass on the tangent stiffness dP/dd."""
    elastic = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(vr.Elastic(modulus=3e6), thickness=10e-3)])
    depths = [vr.RollingHistory(elastic, load=load, mesh=COARSE).current.penetration for load in (4.95e3, 5.05e3)]
    stiffness = 100.0 / (depths[1] - depths[0])
    mass = 100.0
    period = 2.0 * np.pi * np.sqrt(mass / stiffness)
    h = vr.roll(
        elastic, time=[0.0, 0.0, 3.0 * period], angle=[0.0, 0.0, 0.0], load=[5e3, 5.02e3, 5.02e3],
        axle=vr.Axle(mass=mass), mesh=COARSE,
    )  # fmt: skip
    above = h.load - 5.02e3
    crossings = np.flatnonzero(np.diff(np.sign(above[1:]))) + 1
    times = [
        np.interp(0.0, *zip(*sorted(((above[k], h.time[k]), (above[k + 1], h.time[k + 1]))), strict=True))
        for k in crossings
    ]
    assert 2.0 * np.diff(times).mean() == pytest.approx(period, rel=1e-2)


def test_saved_states_resume_to_the_last_bit(tmp_path):
    options = {
        "ground": BUMP,
        "axle": vr.Axle(mass=500.0, stiffness=1e5, damping=1e2),
        "averaged_meshes": 2,
        "mesh": COARSE,
    }
    plan = {"time": [0.0, 0.12], "distance": [0.0, 72e-3], "load": LOAD}
    whole = vr.roll(ROLLER, **plan, contact_times=[0.1], **options)
    first = vr.roll(ROLLER, time=[0.0, 0.1], distance=[0.0, 60e-3], load=LOAD, **options)
    first.state.save(tmp_path / "a.state")
    rest = vr.roll(ROLLER, **plan, start=vr.RollingState.load(tmp_path / "a.state"), **options)
    half = np.searchsorted(whole.time, 0.1)
    for name, values in rest._series().items():
        np.testing.assert_array_equal(values, getattr(whole, name)[half:], err_msg=name)


def test_reference_on_a_corrugation():
    r = reference.roll(reference.corrugation(0.1e-3, 12e-3), nodes=500, speed=0.3, end=40e-3, mass=500.0, steps=20)
    ground, end = vr.Profile.corrugation(0.1e-3, period=12e-3), float(r.distance[-1])
    h = over(ground, 0.3, vr.Axle(mass=500.0), mesh=COARSE, end=end, steps_per_spacing=20)
    np.testing.assert_allclose(h.distance, r.distance, atol=1e-12)  # the same steps
    np.testing.assert_allclose(h.load, r.load, atol=1e-3 * r.load.max())
    np.testing.assert_allclose(h.penetration, r.penetration, atol=1e-7)


@pytest.mark.parametrize("friction", [0.3, 2.0])
@pytest.mark.parametrize("axle", [vr.Axle(mass=500.0), vr.Axle(mass=100.0, stiffness=1e7), vr.Axle(stiffness=1e7)])
def test_friction_with_an_axle_is_friction_under_its_load(axle, friction):
    """The same steps with the load that the axle found, given, repeat penetration and tractions."""
    options = {"friction": friction, "mesh": COARSE, "averaged_meshes": 1}
    h = over(BUMP, 0.3, axle, end=60e-3, **options)
    assert np.ptp(h.load) > 2e3
    given = vr.roll(
        ROLLER, time=h.time, distance=h.distance, load=h.load, ground=BUMP, steps_per_spacing=None, **options
    )
    np.testing.assert_allclose(given.penetration, h.penetration, atol=1e-8 * np.ptp(h.penetration))
    np.testing.assert_allclose(given.driving_torque, h.driving_torque, atol=1e-7 * h.resisting_torque.max())
    np.testing.assert_allclose(given.slip_energy, h.slip_energy, atol=1e-7 * h.slip_energy[-1])
    assert h.energy_balance_error[-1] < 2e-3


def test_friction_in_flight():
    """In the air, the center keeps its speed, and nothing slips."""
    h = over(BUMP, 0.6, vr.Axle(mass=500.0), mesh=COARSE, averaged_meshes=1, friction=0.4)
    flying = (h.load[1:] == 0.0) & (h.load[:-1] == 0.0)
    assert flying.sum() > 50
    np.testing.assert_array_equal(np.diff(h.slip_energy)[flying], 0.0)
    np.testing.assert_allclose(h.center_speed[1:][flying], 0.6, rtol=0.1)
    assert h.center_displacement[-1] == pytest.approx(80e-3, rel=0.02)
    assert h.energy_balance_error[-1] < 5e-3
    smooth = over(BUMP, 0.6, vr.Axle(mass=500.0), mesh=COARSE, averaged_meshes=1)
    assert h.load.max() == pytest.approx(smooth.load.max(), rel=0.1)


def test_height_is_rejected():
    stepper = vr.RollingHistory(ROLLER, load=LOAD, axle=vr.Axle(mass=1.0), mesh=COARSE, averaged_meshes=1)
    with pytest.raises(vr.InvalidInput, match="axle_height must be left out with an axle, whose motion is a result"):
        stepper.advance(time=0.1, angle=0.0, axle_height=59e-3)
