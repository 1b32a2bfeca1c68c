"""Layers with different relaxation functions: each order of the influence has creep times of its own."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference.pressed_ball import penetration
from shared_cases import RUBBER, coated_ball, one_layer

SOFTER = vr.StandardLinearSolid(instantaneous_modulus=4e6, relaxed_modulus=1e6, relaxation_time=0.02)
LAYERS = [one_layer(SOFTER, thickness=0.5e-3), one_layer(thickness=0.5e-3)]
STEEL = vr.CoatedSphere(core_radius=21e-3)
MAT = vr.CoatedPlane(layers=LAYERS)
BALL = vr.CoatedSphere(core_radius=20e-3, layers=LAYERS)


#: Back and forth, with one step per segment between waypoints, so that all materials have the same steps.
STEPS = {
    "time": np.linspace(0.0, 0.2, 81), "angle": 0.2 - np.abs(np.linspace(-0.2, 0.1, 81)), "load": 100.0,
    "mesh": vr.Mesh(nodes_per_revolution=150), "averaged_meshes": 1, "steps_per_spacing": None,
}  # fmt: skip


def mesh(nodes):
    return vr.Mesh(nodes_per_revolution=nodes)


def test_start_agrees_with_an_independent_program():
    """The values are limits of a plain NumPy program from π/150, π/250 and π/350, to 1e-7 m and 0.05 mN m."""
    h = vr.roll(STEEL, on=MAT, time=[0.0, 0.04], distance=[0.0, 2.1e-3], load=100.0, mesh=mesh(300))
    assert h.penetration[0] == pytest.approx(0.2384e-3, rel=5e-4)
    assert h.resisting_torque.max() == pytest.approx(76.94e-3, rel=2e-3)  # error of the mesh 1e-3
    assert h.distance[h.resisting_torque.argmax()] == pytest.approx(1.385e-3, abs=0.03e-3)  # one step is 0.11 mm


def test_penetration_at_rest_agrees_with_zonal_harmonics():
    """The limit of zonal harmonics is 0.24343 mm."""
    expected = penetration(20e-3, [(0.5e-3, 1e6), (0.5e-3, 3e6)], 100.0, rings=50)
    still = vr.RollingHistory(BALL, load=100.0, mesh=mesh(500), averaged_meshes=4)
    assert still.current.penetration == pytest.approx(expected, rel=5e-4)  # error of the mesh 4e-4


def test_a_smaller_spectrum_tolerance_changes_the_torque_little():
    """The creep times that the solver chooses for all orders have an error below the tolerance."""
    torques = []
    for tolerance in (1e-2, 1e-5):
        h = vr.roll(
            STEEL, on=MAT, time=[0.0, 0.3], distance=[0.0, 16e-3], load=100.0, mesh=mesh(150),
            spectrum_tolerance=tolerance, averaged_meshes=1,
        )  # fmt: skip
        assert 0.0 < h.spectrum_error < tolerance
        torques.append(h.resisting_torque)
    few, many = torques
    assert 0.0 < np.abs(few - many).max() < 1e-3 * many.max()


def test_nearly_identical_layers_act_as_one_layer():
    """A relaxation time that is longer by a factor of 1 + 2e-5 is enough to make the layers dissimilar."""
    other = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125 * (1 + 2e-5))
    two = vr.CoatedSphere(core_radius=20e-3, layers=[one_layer(m, thickness=0.5e-3) for m in (other, RUBBER)])
    a, b = (vr.roll(ball, **STEPS) for ball in (two, coated_ball()))
    assert a.spectrum_error > 0.0 == b.spectrum_error
    np.testing.assert_allclose(a.resisting_torque, b.resisting_torque, rtol=0, atol=2e-5 * b.resisting_torque.max())
    assert a.dissipated_energy[-1] == pytest.approx(b.dissipated_energy[-1], rel=2e-5)


def test_a_layer_with_a_large_bulk_modulus_equals_an_incompressible_one():
    """3 K = 2 mu (1 + nu) / (1 - 2 nu): if K is much larger than every mu, Poisson's ratio nu is 1/2 at all times."""
    stiff, soft, none = (
        vr.roll(coated_ball(**kind), **STEPS)
        for kind in ({"bulk_modulus": 1e13}, {"bulk_modulus": 2e7}, {"poisson_ratio": 0.5})
    )
    np.testing.assert_allclose(stiff.resisting_torque, none.resisting_torque, rtol=1e-4, atol=1e-6)
    assert soft.resisting_torque.max() < 0.99 * none.resisting_torque.max()
    assert soft.penetration[0] > 1.1 * none.penetration[0]


def test_friction_ends_in_the_steady_state():
    omega = 2.5
    h = vr.roll(
        BALL, time=[0.0, 0.4], angle=[0.0, 0.4 * omega], load=100.0, friction=0.3, mesh=mesh(200), averaged_meshes=2
    )
    r = vr.solve(BALL, load=100.0, angular_speed=omega, friction=0.3, mesh=mesh(800))
    assert h.resisting_torque[h.angle > 0.8].mean() == pytest.approx(r.resisting_torque, rel=2e-2)  # coarse mesh


def random_layers(rng):
    layers = []
    for _ in range(rng.integers(2, 4)):
        terms = rng.integers(1, 5)
        modulus = vr.Prony(
            instantaneous_modulus=10 ** rng.uniform(5.8, 7.2),
            weights=rng.uniform(0.2, 0.9) * rng.dirichlet(np.ones(terms)),
            relaxation_times=10 ** rng.uniform(-3.0, 1.0, terms),
        )
        layers.append(one_layer(modulus, thickness=rng.uniform(2e-4, 1e-3), poisson_ratio=rng.choice([0.3, 0.45, 0.5])))
    return layers


@pytest.mark.parametrize("seed", range(8))
def test_no_step_gains_energy(seed):
    """The common creep times of all orders may have negative weights, but every step still dissipates energy."""
    plane = vr.CoatedPlane(layers=random_layers(np.random.default_rng(seed)))
    h = vr.roll(
        STEEL, on=plane, time=[0.0, 0.02, 0.5, 0.9, 1.0], distance=[0.0, 4e-3, 0.8e-3, 0.8e-3, 6e-3],
        load=[20.0, 20.0, 20.0, 40.0, 10.0], mesh=mesh(160), averaged_meshes=1,
    )  # fmt: skip
    assert np.diff(h.dissipated_energy).min() > 0.0


def test_a_saved_state_continues():
    first = vr.RollingHistory(STEEL, on=MAT, load=100.0, mesh=mesh(120), averaged_meshes=2)
    first.advance(time=0.1, distance=5e-3, load=100.0)
    second = vr.RollingHistory(STEEL, on=MAT, load=100.0, mesh=mesh(120), averaged_meshes=2, start=first.state)
    ends = [stepper.advance(time=0.15, distance=4e-3, load=90.0) for stepper in (first, second)]
    assert ends[0] == ends[1]
