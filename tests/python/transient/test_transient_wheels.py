"""Wheels whose treads end at free faces: steady and slow rolling, back and forth, one turn, and standing."""

from __future__ import annotations

import pickle
import warnings
from dataclasses import astuple, replace

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, one_layer
from viscoroll import analytic, enums
from viscoroll.case.motion import load_motion

SOFTER = vr.StandardLinearSolid(instantaneous_modulus=4e6, relaxed_modulus=1e6, relaxation_time=0.02)
TREAD = one_layer(thickness=10e-3)
#: Layers of half the thickness; the inner one is twice as stiff at every frequency, or has other relaxation times.
STIFFER = vr.StandardLinearSolid(instantaneous_modulus=12e6, relaxed_modulus=6e6, relaxation_time=0.125)
TWO_SIMILAR, TWO_DISSIMILAR = (
    [one_layer(inner, thickness=5e-3), one_layer(thickness=5e-3)] for inner in (STIFFER, SOFTER)
)  # fmt: skip
FLAT = vr.CoatedWheel(core_radius=50e-3, layers=[TREAD], width=30e-3)
CROWNED = replace(FLAT, crown_radius=0.1)
NARROW = replace(FLAT, width=8e-3)
MAT = vr.CoatedPlane(layers=[one_layer(SOFTER, thickness=5e-3)])

#: Rolling body, counterbody, load [N], and the least relative difference of the torque with unbounded sides.
WHEELS = {
    "flat": (FLAT, None, 300.0, 0.1),
    "flat, of two similar layers": (replace(FLAT, layers=TWO_SIMILAR), None, 300.0, 0.1),
    "flat, of two dissimilar layers": (replace(FLAT, layers=TWO_DISSIMILAR), None, 200.0, 0.1),
    "crowned, on a straight hub": (CROWNED, None, 300.0, 0.02),
    "crowned, on a crowned hub": (replace(CROWNED, hub=enums.Hub.CROWNED), None, 300.0, 0.02),
    "crowned, of two dissimilar layers": (replace(CROWNED, layers=TWO_DISSIMILAR), None, 200.0, 0.02),
    "narrower than thick": (NARROW, None, 100.0, 0.3),
    "crowned on a mat": (CROWNED, MAT, 300.0, 0.01),
    "flat under another wheel": (FLAT, replace(CROWNED, core_radius=40e-3, width=25e-3), 200.0, 0.03),
}
EVERY = pytest.mark.parametrize(
    ("body", "on", "load", "apart"),
    [
        # Sections and orders of dissimilar layers are solved for all their times, and again by the steady solver.
        pytest.param(*wheel, id=name, marks=[pytest.mark.slow] if "dissimilar" in name else [])
        for name, wheel in WHEELS.items()
    ],
)
COARSE = vr.Mesh(nodes_per_revolution=100)


def unbounded(body):
    return replace(body, sides=enums.Sides.UNBOUNDED) if isinstance(body, vr.CoatedWheel) else body


def solved(body, on, **case):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)  # large strains, sides and edges
        return vr.solve(body, on=on, **case)


@EVERY
def test_motion_ends_in_the_steady_state(body, on, load, apart):
    """Power, torque and penetration agree with the steady solver; the torque with unbounded sides differs.

    At 400 nodes per revolution, the history differs from its limit by 7e-4, and the steady solver by as much.
    """
    omega, turn, mesh = 2.5, 1.4, vr.Mesh(nodes_per_revolution=400)
    h = vr.roll(body, on=on, time=[0.0, turn / omega], angle=[0.0, turn], load=load, mesh=mesh)
    r = solved(body, on, load=load, angular_speed=omega, accuracy=2e-3)
    far = solved(unbounded(body), unbounded(on), load=load, angular_speed=omega, mesh=vr.Mesh(nodes_per_revolution=400))
    last = h.angle > 0.7 * turn
    power = np.ptp((h.dissipated_energy + h.stored_energy)[last]) / np.ptp(h.time[last])
    assert power == pytest.approx(r.bulk_power, rel=2e-3)
    assert h.resisting_torque[last].mean() == pytest.approx(r.resisting_torque, rel=2e-3)
    assert h.penetration[-1] == pytest.approx(r.penetration, rel=2e-3)
    assert abs(r.resisting_torque / far.resisting_torque - 1.0) > apart
    assert h.energy_balance_error[-1] < 1e-3
    assert np.diff(h.dissipated_energy).min() >= 0.0


@pytest.mark.parametrize("body", [FLAT, CROWNED, NARROW], ids=["flat", "crowned", "narrow"])
def test_low_speed_law(body):
    """At low speed, T = P Ω r_o τ for any tread, with the loss time τ of the material.

    Nodes join and leave the contact within steps. On this mesh, with a spacing of 2 mm, the error of the torque is 1
    to 2 % with 32 steps per spacing, and 5 % with 4 steps.
    """
    load, omega, turn = 100.0, 1e-3, 0.3
    h = vr.roll(
        body, time=[0.0, turn / omega], angle=[0.0, turn], load=load, mesh=vr.Mesh(nodes_per_revolution=200),
        steps_per_spacing=32,
    )  # fmt: skip
    last = h.angle > 0.5 * turn
    torque = np.ptp(h.dissipated_energy[last]) / np.ptp(h.angle[last])
    law = analytic.low_speed_torque(
        load=load, angular_speed=omega, radius=body.outer_radius, loss_time=analytic.loss_time(RUBBER)
    )
    assert torque == pytest.approx(law, rel=2e-2)


@pytest.mark.parametrize("body", [FLAT, CROWNED], ids=["flat", "crowned"])
def test_mirrored_motion_has_mirrored_torque(body):
    time, angle = [0.0, 0.1, 0.2, 0.25], np.array([0.0, 0.2, 0.2, 0.1])
    a, b = (vr.roll(body, time=time, angle=s * angle, load=200.0, mesh=COARSE, averaged_meshes=1) for s in (1.0, -1.0))
    largest = np.abs(a.resisting_torque).max()
    np.testing.assert_allclose(a.resisting_torque, -b.resisting_torque, rtol=0, atol=1e-8 * largest)
    np.testing.assert_allclose(a.penetration, b.penetration, rtol=1e-9)


def test_standing_follows_lee_and_radok():
    """While the contact grows, the approach is that of an elastic tread under the load ∫J dP, in units of G₀."""
    h = vr.roll(FLAT, time=[0.0, 0.5], angle=[0.0, 0.0], load=200.0, start="undeformed", mesh=COARSE, averaged_meshes=1)
    stiff = replace(FLAT, layers=[one_layer(vr.Elastic(modulus=6e6), thickness=10e-3)])
    for i in (0, len(h.time) // 2, -1):
        load = 200.0 * (2.0 - np.exp(-h.time[i] / 0.25))
        alone = vr.RollingHistory(stiff, load=load, mesh=COARSE, averaged_meshes=1)
        assert h.penetration[i] == pytest.approx(alone.current.penetration, rel=1e-9)
    assert np.abs(h.resisting_torque).max() < 1e-10


@pytest.mark.parametrize("body", [FLAT, CROWNED], ids=["flat", "crowned"])
def test_elastic_wheels_have_the_penetration_of_the_steady_solver(body):
    """On the same nodes, the symmetrized influence and the truncated tables change the penetration by 2e-6."""
    wheel = replace(body, layers=[one_layer(vr.Elastic(modulus=3e6), thickness=10e-3)])
    mesh = vr.Mesh(nodes_per_revolution=300)
    depth = vr.RollingHistory(wheel, load=300.0, mesh=mesh, averaged_meshes=1).current.penetration
    steady = solved(wheel, None, load=300.0, angular_speed=1.0, mesh=mesh)
    assert depth == pytest.approx(steady.penetration, rel=3e-6)


def test_a_flat_spot_returns_each_turn():
    """λ = 10 s: one peak per turn, which decays by e^(-2π/(Ωλ)) each turn."""
    slow = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=5.0)
    wheel, omega = replace(FLAT, layers=[one_layer(slow, thickness=10e-3)]), 2.5
    h = vr.roll(wheel, time=[0.0, 8 * np.pi / omega], angle=[0.0, 8 * np.pi], load=200.0, mesh=COARSE)
    turn = (h.angle / (2 * np.pi) + 0.5).astype(int)
    steady = np.median(h.resisting_torque[turn == 3])
    peaks = np.array([h.resisting_torque[turn == k].max() for k in range(4)]) - steady
    np.testing.assert_allclose(peaks[1:] / peaks[:-1], np.exp(-2 * np.pi / (omega * 10.0)), rtol=0.03)


@pytest.mark.parametrize(("body", "friction"), [(CROWNED, 0.0), (FLAT, 0.3)], ids=["crowned", "with friction"])
def test_a_saved_state_continues_bit_for_bit(body, friction):
    """The motion includes a load jump and a lift-off."""
    options = {"load": 100.0, "mesh": vr.Mesh(nodes_per_revolution=80), "averaged_meshes": 2, "friction": friction}
    whole = vr.RollingHistory(body, **options)
    whole.advance(time=0.05, angle=0.1, load=100.0)
    halves = [pickle.loads(pickle.dumps(whole)), vr.RollingHistory(body, **options, start=whole.state)]
    for time, angle, load in [(0.1, 0.2, 110.0), (0.11, 0.15, 100.0), (0.11, 0.15, 0.0), (0.15, 0.3, 90.0)]:
        expected = astuple(whole.advance(time=time, angle=angle, load=load))
        for half in halves:
            np.testing.assert_array_equal(astuple(half.advance(time=time, angle=angle, load=load)), expected)


def test_a_rising_load_widens_the_tables():
    """A crowned wheel that reaches its faces agrees with a history that begins under the final load."""
    h = vr.roll(
        CROWNED, time=[0.0, 1.0, 6.0], angle=[0.0, 0.5, 0.5], load=[10.0, 900.0, 900.0], mesh=COARSE, averaged_meshes=1
    )
    alone = vr.RollingHistory(CROWNED, load=900.0, angle=0.5, mesh=COARSE, averaged_meshes=1)
    assert h.semi_axis_z[0] < 0.5 * h.semi_axis_z[-1]
    assert h.semi_axis_z[-1] == pytest.approx(0.5 * CROWNED.width, rel=0.05)
    assert h.penetration[-1] == pytest.approx(alone.current.penetration, rel=1e-6)


def test_a_state_of_unbounded_sides_is_refused():
    options = {"load": 100.0, "mesh": COARSE, "averaged_meshes": 1}
    state = vr.RollingHistory(unbounded(FLAT), **options).state
    with pytest.raises(ValueError, match=r"start must be a state of .*sides=FREE.*, got a state of .*sides=UNBOUNDED"):
        vr.RollingHistory(FLAT, **options, start=state)
    # A state from bare numbers names no body; then the core compares the influence of both treads.
    unnamed = vr.RollingState(state.numbers)
    with pytest.raises(ValueError, match="start must be a state of the same bodies and mesh"):
        vr.RollingHistory(FLAT, **options, start=unnamed)


@pytest.mark.parametrize("drive", [{}, {"drive": vr.Drive(torque=0.0)}], ids=["free", "towed"])
def test_motion_with_friction_ends_in_the_steady_state(drive):
    """The error of the history with 200 nodes per revolution is 4e-3, and that of the steady solver with 600 is 2e-3.

    The steady solver is of first order along x.
    """
    omega, turn = 2.5, 1.4
    options = {"load": 300.0, "friction": 0.3} | drive
    h = vr.roll(FLAT, time=[0.0, turn / omega], angle=[0.0, turn], mesh=vr.Mesh(nodes_per_revolution=200), **options)
    r = solved(FLAT, None, angular_speed=omega, mesh=vr.Mesh(nodes_per_revolution=600), **options)
    last = h.angle > 0.7 * turn
    assert h.resisting_torque[last].mean() == pytest.approx(r.resisting_torque, rel=6e-3)
    assert h.driving_torque[last].mean() == pytest.approx(r.driving_torque, rel=6e-3, abs=1e-9)
    assert h.driving_force[last].mean() == pytest.approx(r.driving_force, rel=6e-3, abs=1e-9)
    creepage = np.ptp(h.center_displacement[last]) / np.ptp(h.angle[last]) / FLAT.outer_radius - 1.0
    assert creepage == pytest.approx(r.creepage, rel=2e-2)
    assert h.penetration[-1] == pytest.approx(r.penetration, rel=2e-3)
    assert h.energy_balance_error[-1] < 5e-3


def test_a_motion_file_without_sides_has_free_sides(tmp_path):
    file = tmp_path / "motion.toml"
    file.write_text(
        """
        [wheel]
        core_radius = 50e-3
        width = 30e-3
        [[wheel.layers]]
        thickness = 10e-3
        poisson_ratio = 0.5
        [wheel.layers.shear_modulus]
        type = "standard_linear_solid"
        instantaneous_modulus = 6e6
        relaxed_modulus = 3e6
        relaxation_time = 0.125
        [motion]
        time = [0.0, 0.1, 0.3]
        angle = [0.0, 0.2, 0.2]
        load = 200.0
        [numerics]
        nodes_per_revolution = 100
        """,
        encoding="utf-8",
    )
    a = load_motion(file).roll()
    b = vr.roll(FLAT, time=[0.0, 0.1, 0.3], angle=[0.0, 0.2, 0.2], load=200.0, mesh=COARSE)
    np.testing.assert_array_equal(a.resisting_torque, b.resisting_torque)
