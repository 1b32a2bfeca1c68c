"""The center in transient rolling with friction: its mass, its prescribed displacement, and lift-off."""

from __future__ import annotations

import copy
from dataclasses import astuple

import numpy as np
import pytest
import viscoroll as vr
from scipy.integrate import trapezoid
from scipy.optimize import root_scalar
from shared_cases import coated_ball
from viscoroll import enums, paper

BALL = paper.ball(density=0.0)
RADIUS = 21e-3
LOAD = 100.0
COARSE = vr.Mesh(nodes_per_revolution=100)
ELASTIC = coated_ball(vr.Elastic(modulus=3e6))


def follow(time: np.ndarray, angle: np.ndarray, *, ball: vr.CoatedSphere = BALL, **options: object) -> vr.History:
    """Follow a motion with one step per segment between waypoints."""
    given = {"load": LOAD, "friction": 0.3, "mesh": COARSE, "averaged_meshes": 1, "steps_per_spacing": None} | options
    return vr.roll(ball, time=time, angle=angle, **given)


# --- mass -----------------------------------------------------------------------------------------------------------


def pushed_stiffness(start: enums.Start, **given: object) -> float:
    """Return the force per displacement of the center for a tiny push in a time too short for creep [N/m]."""
    h = follow(np.array([0.0, 1e-6]), np.zeros(2), start=start, center_displacement=[0.0, 1e-8], **given)
    return h.driving_force[-1] / 1e-8


def missing_share(h: vr.History, friction: float) -> np.ndarray:
    """Return the part of μP that does not act along the path, divided by μP [-].

    For a node that slips at V along the path and at w sideways, it is 1 - cos arctan(w/V), about (w/V)²/2.
    """
    return 1.0 - np.abs(h.driving_force) / (friction * LOAD)


@pytest.mark.parametrize(("ball", "retardation_time"), [(ELASTIC, np.inf), (BALL, 0.25)])
def test_a_locked_ball_slides_to_a_halt(ball, retardation_time):
    """The ball decelerates at μP/M for the time V₀M/(μP); then it sticks, and swings with the energy of the shear."""
    time = np.linspace(0.0, 0.15, 301)
    speed, mass, friction = 0.3, 10.0, 0.3
    force, stiffness = friction * LOAD, pushed_stiffness(enums.Start.RELAXED, ball=ball, friction=friction)
    h = follow(time, np.zeros_like(time), ball=ball, mass=mass, center_speed=speed, friction=friction)
    deceleration = force / mass
    sliding = (time > 0.02) & (time < 0.095)
    np.testing.assert_array_equal(h.stick_share[sliding], 0.0)
    # A sheared coating creeps, also sideways, by at most its shear μP/k per retardation time.
    sideways = force / stiffness / retardation_time
    assert missing_share(h, friction)[sliding].min() > -1e-12
    assert (missing_share(h, friction) < 1e-12 + 0.5 * (sideways / h.center_speed) ** 2)[sliding].all()
    # The error of the initial acceleration halves in each step, and has decayed when `sliding` begins.
    forces = h.driving_force[sliding]
    np.testing.assert_allclose(
        -mass * np.diff(h.center_speed[sliding]) / np.diff(time[sliding]), 0.5 * (forces[1:] + forces[:-1]), rtol=1e-7
    )
    # Before it slides, the ball is displaced by about μP/k.
    assert h.center_displacement.max() == pytest.approx(speed**2 / (2.0 * deceleration), abs=force / stiffness)
    assert h.slip_energy[-1] == pytest.approx(0.5 * mass * speed**2, rel=0.01)
    # The ball rebounds with the energy stored in shear, (μP)²/2k.
    halted = time > 0.1
    assert h.center_speed[halted].min() == pytest.approx(-force / np.sqrt(stiffness * mass), rel=0.05)
    energy = 0.5 * mass * h.center_speed**2 + h.stored_energy - h.stored_energy[0] + h.dissipated_energy
    np.testing.assert_allclose(energy, 0.5 * mass * speed**2, rtol=0.01)


def test_a_spinning_ball_catches_up():
    """A ball that suddenly spins slips, and μP accelerates its mass until the center has the speed of rolling."""
    omega, mass, friction = 0.5, 1000.0, 0.3
    time = np.linspace(0.0, 0.8, 161)
    h = follow(time, omega * time, mass=mass, friction=friction, start=enums.Start.UNDEFORMED)
    acceleration = friction * LOAD / mass
    slipping = (time > 0.1) & (time < 0.3)
    np.testing.assert_array_equal(h.stick_share[slipping], 0.0)
    # While a node passes half of the contact, it moves sideways by less than the penetration. The sideways part of
    # the traction is proportional to the inverse square of the slip along the path.
    slip = (omega * RADIUS - h.center_speed)[slipping]
    sideways = (h.penetration * omega * RADIUS / h.semi_axis_x)[slipping]
    sideways_share = missing_share(h, friction)[slipping]
    assert sideways_share.min() > 0.0
    assert (sideways_share < 0.5 * (sideways / slip) ** 2).all()
    np.testing.assert_allclose(sideways_share * slip**2, np.mean(sideways_share * slip**2), rtol=0.35)
    forces = h.driving_force[slipping]
    np.testing.assert_allclose(
        -mass * np.diff(h.center_speed[slipping]) / np.diff(time[slipping]), 0.5 * (forces[1:] + forces[:-1]), rtol=1e-4
    )
    # Until the coating is fully sheared, the force is less than μP. This delays the center by ∫(1 - F/μP) dt, which
    # is 0.6 μP/k per slip speed for Hertz's pressure on Mindlin's half-space, and 0.9 for (1 - r²/a²)² on a
    # foundation of springs. A thin incompressible coating lies between them.
    delay = 0.3 - np.interp(0.3, time, h.center_speed) / acceleration
    shear = friction * LOAD / pushed_stiffness(enums.Start.UNDEFORMED, friction=friction)
    assert 0.6 < delay / (shear / (omega * RADIUS)) < 0.9
    assert h.center_speed[-1] == pytest.approx(omega * RADIUS, rel=0.05)
    # The momentum is the impulse of all forces, by the trapezoidal rule.
    impulse = -trapezoid(h.driving_force, time)
    assert mass * h.center_speed[-1] == pytest.approx(impulse, rel=1e-3)


def test_a_light_center_rolls_freely():
    time = np.linspace(0.0, 0.3, 31)
    light = follow(time, time, mass=1e-9, start=enums.Start.UNDEFORMED)
    none = follow(time, time, start=enums.Start.UNDEFORMED)
    np.testing.assert_allclose(
        light.center_displacement, none.center_displacement, rtol=0, atol=1e-9 * none.center_displacement[-1]
    )
    np.testing.assert_allclose(light.driving_torque, none.driving_torque, rtol=0, atol=1e-7 * none.driving_torque.max())
    # The solver computes the speed from the last displacements to second order; the mean of a step would be of first.
    assert light.center_speed[-1] == pytest.approx(none.center_speed[-1], rel=1e-2)


@pytest.mark.parametrize(("mass", "rel"), [(1e6, 1e-4), (1e9, 1e-7), (1e15, 1e-13)])
def test_a_heavy_center_keeps_its_speed(mass, rel):
    """The deviation from a prescribed displacement at constant speed is proportional to 1/M, down to round-off."""
    time = np.linspace(0.0, 0.3, 31)
    heavy = follow(time, time, mass=mass, center_speed=1.01 * RADIUS)
    prescribed = follow(time, time, center_displacement=1.01 * RADIUS * time)
    np.testing.assert_allclose(prescribed.center_displacement, 1.01 * RADIUS * time, rtol=1e-14)
    np.testing.assert_allclose(heavy.center_displacement, prescribed.center_displacement, rtol=rel)
    np.testing.assert_allclose(heavy.driving_force, prescribed.driving_force, rtol=0, atol=1e3 * rel * LOAD)


def swing(steps_per_period: int) -> tuple[vr.History, float, float]:
    """Return the history of a mass that swings on a sheared elastic coating, its frequency [rad/s] and energy [J]."""
    mass, speed, friction = 2.0, 1e-4, 3.0
    given = {"ball": ELASTIC, "friction": friction}
    pushed = follow(np.array([0.0, 1.0]), np.zeros(2), center_displacement=[0.0, 1e-8], **given)
    frequency = np.sqrt(pushed.driving_force[-1] / 1e-8 / mass)
    time = np.linspace(0.0, 4.0 * np.pi / frequency, 2 * steps_per_period + 1)
    h = follow(time, np.zeros_like(time), mass=mass, center_speed=speed, **given)
    return h, frequency, 0.5 * mass * speed**2


def energy_lost_on_a_spring(steps_per_period: int) -> float:
    """Return the numerical dissipation of the same time steps for a mass on a spring in two periods, M = k = 1 [-]."""
    step = 2.0 * np.pi / steps_per_period
    displacement, speed, acceleration = 0.0, 1.0, 0.0
    for _ in range(2 * steps_per_period):
        increment = (2.0 * speed / step - displacement) / (1.0 + 2.0 / step**2)
        before, acceleration = acceleration, (increment / step - speed) / step + 0.5 * acceleration
        displacement, speed = displacement + increment, speed + step * (1.5 * acceleration - 0.5 * before)
    return 1.0 - displacement**2 - speed**2


def test_a_mass_on_an_elastic_coating_keeps_its_energy():
    """The mass swings at √(k/M). Its energy decreases only by the numerical dissipation of the time steps."""
    errors, lost = [], []
    for steps in (60, 120):
        h, frequency, energy = swing(steps)
        expected = 1e-4 * np.sin(frequency * h.time) / frequency
        errors.append(np.abs(h.center_displacement - expected).max() * frequency / 1e-4)
        work_on_coating = h.work[-1] - h.work[0]
        assert work_on_coating == pytest.approx(h.stored_energy[-1] - h.stored_energy[0], abs=1e-3 * energy)
        lost.append(1.0 - (0.5 * 2.0 * h.center_speed[-1] ** 2 + h.stored_energy[-1] - h.stored_energy[0]) / energy)
    assert errors[1] < 0.02
    assert 3.0 < errors[0] / errors[1] < 5.0  # second order
    assert 0.0 < lost[1] < 0.005
    np.testing.assert_allclose(lost, [energy_lost_on_a_spring(steps) for steps in (60, 120)], rtol=1e-4)


def test_rolling_resistance_decelerates_a_free_ball():
    """Without torque and force, M dV/dt = -T_r/H, with the steady torque of a towed ball at this angular speed."""
    mass, speed = 1e4, 1.0 * RADIUS
    mesh = vr.Mesh(nodes_per_revolution=150)
    stepper = vr.RollingHistory(
        BALL, load=LOAD, start=enums.Start.UNDEFORMED, mesh=mesh, friction=0.3, mass=mass, center_speed=speed,
        averaged_meshes=4, steps_per_spacing=None, threads=1,
    )  # fmt: skip
    step = 0.5 * mesh.spacing * RADIUS / speed
    instants = []
    turn = 0.5 * mesh.spacing
    for i in range(1, 37):

        def torque(angle: float, time: float = i * step) -> float:
            return copy.copy(stepper).advance(time=time, angle=angle, load=LOAD).driving_torque

        before = stepper.current.angle
        found = root_scalar(torque, method="secant", x0=before + turn, x1=before + 0.99 * turn, xtol=1e-10)
        instants.append(stepper.advance(time=i * step, angle=found.root, load=LOAD))
        turn = found.root - before
    rolling = instants[18:]
    duration = rolling[-1].time - rolling[0].time
    deceleration = (rolling[-1].center_speed - rolling[0].center_speed) / duration
    resisting = trapezoid([one.resisting_torque for one in rolling], [one.time for one in rolling]) / duration
    height = RADIUS - rolling[-1].penetration
    assert mass * deceleration * height == pytest.approx(-resisting, rel=1e-3)
    # The steady mesh is finer than the phase-shifted ones, because it has one position of the nodes, which changes
    # the torque by -13 % at 150 nodes per revolution.
    towed = vr.solve(
        BALL, load=LOAD, angular_speed=(rolling[-1].angle - rolling[0].angle) / duration, friction=0.3,
        drive=vr.Drive(torque=0.0), mesh=vr.Mesh(nodes_per_revolution=600), threads=1,
    )  # fmt: skip
    assert resisting == pytest.approx(towed.resisting_torque, rel=0.01)


# --- prescribed displacement of the center ---------------------------------------------------------------------------


@pytest.mark.parametrize("creepage", [0.0, 0.03])
def test_a_prescribed_displacement_ends_in_the_steady_state_of_its_creepage(creepage):
    mesh = vr.Mesh(nodes_per_revolution=300)
    steady = vr.solve(
        BALL, load=LOAD, angular_speed=0.2, friction=0.3, mesh=mesh, drive=vr.Drive(creepage=creepage), threads=1
    )
    angle = np.arange(31) * mesh.spacing
    h = follow(
        angle / 0.2,
        angle,
        mesh=mesh,
        center_displacement=(1.0 + creepage) * RADIUS * angle,
        start=enums.Start.UNDEFORMED,
    )
    assert h.driving_torque[-1] == pytest.approx(steady.driving_torque, rel=0.01)
    assert h.driving_force[-1] == pytest.approx(steady.driving_force, rel=0.01)
    np.testing.assert_allclose(h.creepage[1:], creepage, atol=1e-12)
    assert h.energy_balance_error[-1] < 0.02


# --- lift-off --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("compliance", list(enums.Compliance))
def test_a_lifted_ball_recovers(compliance):
    """Off the plane, the ball dissipates its stored energy without external work, and returns undeformed."""
    given = {"friction": 0.0, "compliance": compliance, "averaged_meshes": 2}
    time = [0.0, 0.1, 0.1, 0.2, 20.0, 20.0]
    h = follow(time, np.linspace(0.0, 0.1, 6), load=[LOAD, LOAD, 0.0, 0.0, 0.0, LOAD], **given)
    lifted = slice(2, 5)
    for name in ("resisting_torque", "driving_torque", "contact_area", "max_pressure", "semi_axis_x"):
        np.testing.assert_array_equal(getattr(h, name)[lifted], 0.0)
    stored = h.stored_energy[lifted]
    np.testing.assert_allclose(np.diff(h.dissipated_energy[lifted]), -np.diff(stored), rtol=1e-12)
    assert stored[0] > 1e-4  # J
    assert stored[-1] < 1e-30
    undeformed = vr.RollingHistory(
        BALL, load=LOAD, start=enums.Start.UNDEFORMED, mesh=COARSE, compliance=compliance, averaged_meshes=2, angle=0.1
    )
    assert h.penetration[-1] == pytest.approx(undeformed.current.penetration, rel=1e-9)
    assert h.penetration[4] == pytest.approx(0.0, abs=1.1e-5)  # the lowest node is at most half a spacing aside


def test_lifting_off_and_coming_down_while_rolling():
    """The energy balance holds as the load falls to zero and rises again, while the tables move around the ball."""
    h = vr.roll(
        BALL, time=[0.0, 0.2, 0.3, 0.5, 0.8], angle=[0.0, 0.4, 0.6, 1.0, 1.6], load=[100.0, 0.0, 0.0, 100.0, 100.0],
        mesh=vr.Mesh(nodes_per_revolution=200),
    )  # fmt: skip
    assert h.energy_balance_error[-1] < 5e-3
    assert (h.resisting_torque[h.load == 0.0] == 0.0).all()
    assert (np.diff(h.dissipated_energy) > -1e-15).all()
    steady = vr.solve(BALL, load=100.0, angular_speed=2.0, mesh=vr.Mesh(nodes_per_revolution=1600), threads=1)
    assert h.resisting_torque[-1] == pytest.approx(steady.resisting_torque, rel=0.02)


def test_a_force_accelerates_a_lifted_center():
    """Off the plane, the force Q accelerates the mass at exactly Q/M; after landing, the ball skids."""
    time = np.array([0.0, 0.05, 0.1, 0.15, 0.2, 0.2, 0.21])
    load = [LOAD, 0.0, 0.0, 0.0, 0.0, LOAD, LOAD]
    h = follow(time, np.zeros_like(time), load=load, mass=0.5, drive=vr.Drive(force=1.0), friction=1.0)
    speed = h.center_speed
    np.testing.assert_array_equal(h.driving_force[1:5], 0.0)
    # The time steps are of second order; the error of the initial acceleration halves in each step.
    assert np.diff(speed)[2] / 0.05 == pytest.approx(1.0 / 0.5, rel=0.1)
    np.testing.assert_allclose(
        np.diff(h.center_displacement)[1:4], [0.05 * v + 0.05**2 for v in speed[1:4]], rtol=1e-12
    )
    assert h.center_displacement[5] == h.center_displacement[4]  # at the same time
    assert h.center_speed[6] < h.center_speed[5]


# --- states and input -----------------------------------------------------------------------------------------------


def test_a_state_contains_the_displacement_and_speed_of_the_center():
    given = {"load": LOAD, "mesh": COARSE, "friction": 0.3, "mass": 1.0, "center_speed": 0.02, "averaged_meshes": 1}
    stepper = vr.RollingHistory(BALL, **given)
    stepper.advance(time=0.05, angle=0.05, load=LOAD)
    again = vr.RollingHistory(BALL, start=stepper.state, **given)
    ends = [one.advance(time=0.1, angle=0.1, load=LOAD) for one in (stepper, again)]
    assert ends[0].center_displacement != 0.0
    np.testing.assert_array_equal(astuple(ends[0]), astuple(ends[1]))


BAD = [
    ({"mass": -1.0}, "mass must be >= 0 kg, got -1"),
    ({"mass": 1.0, "friction": 0.0}, "mass must be 0 kg without friction"),
    ({"center_speed": 0.1}, "center_speed must be 0 m/s without a mass, got 0.1 m/s"),
    ({"center_speed": np.nan, "mass": 1.0}, "center_speed must be finite, got nan"),
    ({"center_displacement": [0.0, np.inf]}, r"center_displacement\[1\] must be finite, got inf"),
    ({"center_displacement": [0.0]}, r"center_displacement must be as long as time \(2\), got 1"),
    ({"center_displacement": [0.1, 0.2]}, r"center_displacement\[0\] must be 0 m"),
    ({"center_displacement": [0.0, 0.1], "friction": 0.0}, "center_displacement must be left out without friction"),
    (
        {"center_displacement": [0.0, 0.1], "drive": vr.Drive(force=1.0)},
        "driving_force must be 0 N if center_displacement is given",
    ),
    ({"load": [0.0, 100.0]}, "load must be > 0 N, got 0"),
]


@pytest.mark.parametrize(("change", "message"), BAD)
def test_bad_input(change, message):
    with pytest.raises(ValueError, match=message):
        follow(np.array([0.0, 0.1]), np.array([0.0, 0.1]), **change)


def test_a_heavy_center_in_a_short_step():
    # The contact force is 1e-8 of the inertial force. The solver once computed it from the displacement, where it is
    # below round-off, and then no step converged.
    soft = vr.Elastic(modulus=1e4)
    ball = vr.CoatedSphere(core_radius=21e-3, layers=[vr.Layer(thickness=2e-3, shear_modulus=soft, poisson_ratio=0.5)])
    plane = vr.CoatedPlane(layers=ball.layers)
    given = {
        "on": plane,
        "load": 3.5e-3,
        "friction": 0.45,
        "mesh": vr.Mesh(nodes_per_revolution=200),
        "averaged_meshes": 1,
    }
    h = vr.RollingHistory(ball, mass=0.5, drive=vr.Drive(force=-1e-3), center_speed=-0.036, **given)
    for time in np.arange(1, 8) * 1.37e-7:
        end = h.advance(time=time, angle=-time, load=given["load"])
        assert end.center_displacement == pytest.approx(-0.036 * time, rel=1e-6)
    assert abs(end.center_speed + 0.036) < 1e-8
