"""Transient rolling with friction for all pairs of bodies: the steady state, the energy balance, and statics."""

from __future__ import annotations

import pickle
import warnings
from dataclasses import astuple

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import one_layer
from test_transient_pairs import BALL, EARTH, MAT, PAIRS, ROLLER, STEEL, THICK_MAT

FREE, TOWED = vr.Drive(force=0.0), vr.Drive(torque=0.0)
PRESSED_EARTH = vr.CoatedPlane(layers=[], base=EARTH)

#: Rolling body, counterbody, drive, load, and nodes per revolution for an error of half a percent of the creepage.
#: This error decreases with the square of the spacing.
STEADY = {
    "ball on mat": (STEEL, MAT, FREE, 100.0, 400),
    "towed ball on mat": (STEEL, MAT, TOWED, 100.0, 400),
    "sliding ball on mat": (STEEL, MAT, vr.Drive(creepage=0.1), 100.0, 400),
    "pushed ball on mat": (STEEL, MAT, vr.Drive(force=5.0), 100.0, 500),
    "towed ball on half-space": (STEEL, PRESSED_EARTH, TOWED, 100.0, 300),
    "sliding soft ball on mat": (*PAIRS["soft ball on mat"][:2], vr.Drive(creepage=0.05), 100.0, 400),
    "ball in soft groove": (STEEL, vr.Groove(radius=0.1, layers=MAT.layers), FREE, 100.0, 400),
    "roller on mat": (*PAIRS["roller on mat"][:2], TOWED, 5e3, 1600),
    "roller on roller": (*PAIRS["soft roller on roller"][:2], FREE, 5e3, 2000),
    "sliding roller on roller": (*PAIRS["soft roller on roller"][:2], vr.Drive(creepage=0.05), 5e3, 800),
    "sliding roller in ring": (*PAIRS["soft roller in ring"][:2], vr.Drive(creepage=0.05), 5e3, 800),
}
SLOW = {"pushed ball on mat", "sliding soft ball on mat", "ball in soft groove", "roller on roller"}


@pytest.mark.parametrize(
    ("body", "on", "drive", "load", "nodes"),
    [
        pytest.param(*values, id=name, marks=[pytest.mark.slow] if name in SLOW else [])
        for name, values in STEADY.items()
    ],
)
def test_friction_ends_in_the_steady_state(body, on, drive, load, nodes):
    """Force, torque, creepage, and the dissipation in each body and by slip agree."""
    omega, turn = 2.5, 1.4
    options = {"on": on, "load": load, "friction": 0.3}
    moved = {"drive": drive}
    if drive.creepage is not None:
        moved = {"center_displacement": [0.0, (1.0 + drive.creepage) * body.outer_radius * turn]}
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    h = vr.roll(body, time=[0.0, turn / omega], angle=[0.0, turn], mesh=mesh, averaged_meshes=2, **options, **moved)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)  # large strains
        r = vr.solve(body, angular_speed=omega, drive=drive, accuracy=1e-3, **options)
    last = h.angle > 0.7 * turn
    duration = np.ptp(h.time[last])
    speed = np.ptp(h.center_displacement[last]) / duration / (omega * body.outer_radius)
    small = 3e-4 if abs(r.creepage) < 1e-3 else 0.0  # the creepage on a half-space nearly vanishes
    assert speed - 1.0 == pytest.approx(r.creepage, rel=5e-3, abs=small)
    assert h.resisting_torque[last].mean() == pytest.approx(r.resisting_torque, rel=5e-3)
    # The absolute tolerances are for torques and forces that are zero.
    assert h.driving_torque[last].mean() == pytest.approx(r.driving_torque, rel=5e-3, abs=1e-7 * r.resisting_torque)
    zero = 1e-7 * r.resisting_torque / body.outer_radius
    assert h.driving_force[last].mean() == pytest.approx(r.driving_force, rel=5e-3, abs=zero)
    gained = h.dissipated_energy + h.stored_energy - h.slip_energy
    counterbody = h.counterbody_dissipated_energy + h.counterbody_stored_energy
    assert np.ptp(gained[last]) / duration == pytest.approx(r.bulk_power, rel=5e-3)
    assert np.ptp(counterbody[last]) / duration == pytest.approx(r.counterbody_bulk_power, rel=5e-3)
    slip = np.ptp(h.slip_energy[last]) / duration
    # Half of the slip power is dissipated at a few nodes, so its own relative error is larger.
    assert slip == pytest.approx(r.slip_power, abs=1e-2 * r.dissipated_power)
    assert h.energy_balance_error[-1] < 2e-3


#: Bound of the relative error of the energy balance on half the nodes of PAIRS.
BALANCE_ERRORS = {
    "ball on mat": 5e-3, "soft ball on mat": 1e-3, "soft ball in dish": 1e-3, "soft ball in rigid dish": 3e-3,
    "ball on ball": 2e-3, "roller on mat": 1e-3, "soft roller on roller": 1e-3, "soft roller in ring": 1e-3,
    "ball on dissimilar layers": 2e-3, "wheel": 3e-3, "wheel on mat": 2e-3,
}  # fmt: skip


@pytest.mark.parametrize(("pair", "bound"), BALANCE_ERRORS.items(), ids=BALANCE_ERRORS)
def test_energy_balances_with_slip(pair, bound):
    """Start, stop, reverse: the work of torque, force and load is stored or dissipated; slip only dissipates."""
    body, on, load, nodes = PAIRS[pair]
    h = vr.roll(
        body, on=on, time=[0.0, 0.1, 0.2, 0.3], angle=[0.0, 0.2, 0.2, 0.1], load=load * np.array([1.0, 1.1, 0.9, 1.0]),
        friction=0.2, mesh=vr.Mesh(nodes_per_revolution=nodes // 2), averaged_meshes=1,
    )  # fmt: skip
    assert h.slip_energy[-1] > 0.0
    # The work of a step uses the mean of both tractions, which is inexact at a node whose slip reverses in the step.
    assert (np.diff(h.slip_energy) > -1e-6 * h.work[-1]).all()
    assert np.abs(h.driving_force).max() < 1e-9 * load, "no force acts on the center"
    assert h.energy_balance_error[-1] < bound


def _thick(core_radius):
    """Return a roller with a soft elastic layer of 20 mm."""
    return vr.CoatedCylinder(core_radius=core_radius, layers=[one_layer(vr.Elastic(modulus=0.1e6), thickness=20e-3)])


@pytest.mark.parametrize(
    ("body", "on"),
    [
        (_thick(10e-3), None),
        (_thick(10e-3), _thick(20e-3)),
        (vr.CoatedCylinder(core_radius=30e-3, layers=[]), _thick(20e-3)),
    ],
    ids=["soft on plane", "soft on soft", "rigid on soft"],
)
def test_energy_balances_in_a_wide_contact(body, on):
    """The residual of a sliding contact of half-length r_o/3 or r_o/5 vanishes with the steps.

    Inclinations by the sines of angles left 1 % of the work on the plane, and the turn of a curved counterbody, if it
    counted as dissipated, left 1 to 2 %.
    """
    load = 1e3 if on is None else 500.0
    h = vr.roll(
        body, on=on, time=[0.0, 1.0], angle=[0.0, 0.4], center_displacement=[0.0, 0.36 * body.outer_radius], load=load,
        friction=0.5, mesh=vr.Mesh(nodes_per_revolution=160), averaged_meshes=1, steps_per_spacing=64,
    )  # fmt: skip
    assert h.semi_axis_x.max() > 0.17 * body.outer_radius
    exchanged = np.abs(np.diff(h.work)).sum()
    assert np.abs(h.energy_balance_residual).max() < 3e-4 * exchanged


@pytest.mark.parametrize("pair", ["ball on mat", "soft ball on mat", "soft ball in dish", "soft roller on roller"])
def test_mirrored_motion_has_mirrored_forces(pair):
    body, on, load, _ = PAIRS[pair]
    time, angle = [0.0, 0.1, 0.2, 0.25], np.array([0.0, 0.2, 0.2, 0.1])
    options = {"on": on, "load": load, "mesh": vr.Mesh(nodes_per_revolution=100), "friction": 0.3, "averaged_meshes": 1}
    a, b = (vr.roll(body, time=time, angle=s * angle, drive=TOWED, **options) for s in (1.0, -1.0))
    for name in ("resisting_torque", "driving_force", "center_displacement"):
        there, back = getattr(a, name), getattr(b, name)
        np.testing.assert_allclose(there, -back, rtol=0, atol=1e-7 * np.abs(there).max(), err_msg=name)
    np.testing.assert_allclose(a.slip_energy, b.slip_energy, rtol=0, atol=1e-7 * a.slip_energy[-1])


def test_a_towed_rigid_ball_starts_on_a_mat():
    """A towed rigid ball has no torque at any instant, and its force is M/R."""
    motion = {"time": [0.0, 0.2, 0.4], "distance": [0.0, 10.5e-3, 10.5e-3], "load": 100.0}
    options = {"on": MAT, "mesh": vr.Mesh(nodes_per_revolution=200)}
    towed = vr.roll(STEEL, **motion, **options, friction=0.3, drive=TOWED)
    assert np.abs(towed.driving_torque).max() < 1e-12 * 100.0 * 21e-3
    # The tractions have no moment about the center, so their sum is at most (a/R)²/2 = 1 % of μP: their moment arms
    # differ by the sagitta of the contact.
    np.testing.assert_allclose(towed.driving_force, towed.resisting_torque / 21e-3, rtol=0, atol=0.01 * 30.0)
    early = towed.time <= 0.2
    assert towed.driving_force[early] == pytest.approx(towed.resisting_torque[early] / 21e-3, rel=1e-2, abs=1e-3)
    assert towed.slip_energy[-1] > 0.0
    assert towed.driving_force.max() > 3.0 * towed.driving_force[early][-1]  # the break-away force is larger


def test_friction_that_tends_to_zero_gives_the_frictionless_torque():
    motion = {"time": [0.0, 0.1], "angle": [0.0, 0.25], "load": 100.0}
    options = {"on": MAT, "mesh": vr.Mesh(nodes_per_revolution=200), "averaged_meshes": 1}
    smooth = vr.roll(STEEL, **motion, **options)
    little, more = (vr.roll(STEEL, **motion, **options, friction=mu, drive=TOWED) for mu in (3e-3, 6e-3))
    limit = 2.0 * little.resisting_torque - more.resisting_torque  # linear extrapolation to zero friction
    np.testing.assert_allclose(limit, smooth.resisting_torque, rtol=0, atol=2e-3 * smooth.resisting_torque.max())


def test_exchanged_rollers_have_equal_forces_and_slip():
    """A creepage of 5 % is -4.8 % for the exchanged rollers: forces and slip are the same."""
    other = vr.CoatedCylinder(core_radius=70e-3, layers=THICK_MAT.layers)
    elastic = [
        vr.CoatedCylinder(
            core_radius=body.core_radius,
            layers=[one_layer(vr.Elastic(modulus=2e6), thickness=body.layers[0].thickness, poisson_ratio=0.495)],
        )
        for body in (ROLLER, other)
    ]
    distance, creepage = 12e-3, 0.05
    arc = 2.0 * np.pi * ROLLER.outer_radius / 1000

    def history(body, on, rolled, went):
        nodes = 2 * round(np.pi * body.outer_radius / arc)  # equal spacings on both
        return vr.roll(
            body, on=on, time=[0.0, 0.5], distance=[0.0, rolled], center_displacement=[0.0, went], load=5e3,
            friction=0.5, mesh=vr.Mesh(nodes_per_revolution=nodes),
        )  # fmt: skip

    a = history(*elastic, distance, (1.0 + creepage) * distance)
    b = history(*elastic[::-1], (1.0 + creepage) * distance, distance)
    assert a.slip_energy[-1] == pytest.approx(b.slip_energy[-1], rel=3e-3)
    # Torque about the axis of the other roller: T_2 = T_1 + Q (R_1 + R_2 - d).
    axis_distance = sum(body.outer_radius for body in elastic) - a.penetration[-1]
    other_torque = a.driving_torque[-1] + a.driving_force[-1] * axis_distance
    assert other_torque == pytest.approx(b.driving_torque[-1], rel=1e-3)
    assert a.driving_force[-1] == pytest.approx(-b.driving_force[-1], rel=1e-3)


@pytest.mark.parametrize("pair", ["ball on mat", "soft ball on mat", "soft roller in ring"])
def test_saved_states_with_friction_continue_bit_for_bit(pair):
    body, on, load, nodes = PAIRS[pair]
    options = {"on": on, "mesh": vr.Mesh(nodes_per_revolution=nodes // 3), "averaged_meshes": 2, "friction": 0.3}
    whole = vr.RollingHistory(body, load=load, drive=TOWED, **options)
    whole.advance(time=0.05, distance=4e-3, load=load)
    half = pickle.loads(pickle.dumps(whole))
    for time, distance, share in [(0.1, 7e-3, 1.1), (0.11, 6e-3, 1.0), (0.11, 6e-3, 0.0), (0.15, 9e-3, 0.9)]:
        expected = astuple(whole.advance(time=time, distance=distance, load=share * load))
        np.testing.assert_array_equal(astuple(half.advance(time=time, distance=distance, load=share * load)), expected)


def test_a_locked_ball_slides_over_a_mat():
    """At full sliding, the force is μP plus that of the asymmetric pressure, and the torque is μP times the radius."""
    h = vr.roll(
        STEEL, on=MAT, time=[0.0, 0.5], distance=[0.0, 0.0], center_displacement=[0.0, 5e-3], load=100.0, friction=0.2,
        mesh=vr.Mesh(nodes_per_revolution=200), averaged_meshes=1,
    )  # fmt: skip
    assert h.stick_share[-1] == 0.0
    pressure_force = h.resisting_torque[-1] / 21e-3
    assert h.driving_force[-1] == pytest.approx(20.0 + pressure_force, rel=1e-3)
    assert -h.driving_torque[-1] == pytest.approx(20.0 * 21e-3, rel=1e-2)  # minus the sagitta of the contact
    assert h.slip_energy[-1] == pytest.approx(20.0 * 5e-3, rel=0.05)  # the ball sticks at first


@pytest.mark.parametrize("nodes", [100, 200])
@pytest.mark.parametrize("on", ["mat", "half-space", "roller"])
@pytest.mark.parametrize(("modulus", "load", "friction"), [(1e6, 1e3, 0.1), (1e7, 5e4, 0.1), (5e7, 1e3, 0.3)])
def test_a_roller_pressed_without_rolling_stays_centered(on, modulus, load, friction, nodes):
    """All nodes of a phase-shifted mesh may slip; then the balance of forces does not determine the displacement."""
    layer = vr.Layer(thickness=10e-3, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=0.5)
    counterbody = {
        "mat": vr.CoatedPlane(layers=[layer]),
        "half-space": vr.CoatedPlane(
            layers=[], base=vr.HalfSpace(shear_modulus=layer.shear_modulus, poisson_ratio=0.3)
        ),
        "roller": vr.CoatedCylinder(core_radius=50e-3, layers=[layer]),
    }[on]
    soft = vr.Layer(thickness=10e-3, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.0)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[soft])
    options = {"on": counterbody, "load": load, "mesh": vr.Mesh(nodes_per_revolution=nodes), "averaged_meshes": 2}
    pressed = vr.RollingHistory(roller, friction=friction, **options)
    # The solver's tolerance is 1e-9 at each instant.
    assert abs(pressed.current.driving_force) < 1e-9 * load
    assert abs(pressed.current.center_displacement) < 1e-9 * pressed.current.semi_axis_x


def test_a_drive_that_exceeds_friction_is_rejected():
    """The mat resists with 2.5 N, more than the 1 N of friction; the torque 0.64 N m needs more than μP = 30 N."""
    motion = {"time": [0.0, 0.02], "distance": [0.0, 1.4e-3], "load": 100.0}
    options = {"on": MAT, "mesh": vr.Mesh(nodes_per_revolution=200), "averaged_meshes": 1}
    slides = r"at angle 0\.\d+ rad, otherwise the ball slides permanently, got"
    with pytest.raises(ValueError, match=rf"driving_force must be between 0\.\d+ N and 2\.\d+ N {slides} 0 N"):
        vr.roll(STEEL, **motion, **options, friction=0.01)
    with pytest.raises(ValueError, match=r"driving_torque must be between -0\.62\d N m and 0\.62\d N m .* 0\.64 N m"):
        vr.roll(STEEL, **motion, **options, friction=0.3, drive=vr.Drive(torque=0.64))
    # More friction, or the torque alone, keeps the ball rolling.
    assert vr.roll(STEEL, **motion, **options, friction=0.03).stick_share[-1] > 0.0
    towed = vr.roll(STEEL, **motion, **options, friction=0.01, drive=TOWED)
    assert towed.driving_force.max() > 2.0


def test_two_identical_balls_roll_as_without_friction():
    """Mirror images never slide, so friction changes only terms of the order (a/R)^4."""
    twin = vr.CoatedSphere(core_radius=BALL.core_radius, layers=BALL.layers)
    motion = {"time": [0.0, 0.1], "angle": [0.0, 0.2], "load": 100.0}
    options = {"on": twin, "mesh": vr.Mesh(nodes_per_revolution=120), "averaged_meshes": 1}
    smooth, rough = (vr.roll(BALL, **motion, **options, friction=friction) for friction in (0.0, 0.3))
    atol = 1e-4 * smooth.resisting_torque.max()
    np.testing.assert_allclose(rough.resisting_torque, smooth.resisting_torque, rtol=0, atol=atol)
    assert rough.slip_energy[-1] < 1e-4 * rough.work[-1]
