"""Surfaces of finite size, around which the layers are free: the ball on a mat, Hertz, Hunter, and long periods."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
MAT = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
INCOMPRESSIBLE = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5)


def paraboloid(nodes, side, radius):
    """Return a cap of a ball, with a node at its top if the number of nodes is odd."""
    x = (np.arange(nodes) - (nodes - 1) / 2) * (side / nodes)
    return vr.RoughSurface(-(x[:, np.newaxis] ** 2 + x**2) / (2 * radius), spacing=side / nodes, periodic=False)


@pytest.mark.parametrize("speed", [0.0, 0.0525])
def test_a_paraboloid_is_a_rigid_ball_on_a_mat(speed):
    # The gap, layers and nodes of a rigid ball are those of the paraboloid.
    radius, load = 21e-3, 100.0
    mesh = vr.Mesh(nodes_per_revolution=1319)  # 0.1 mm
    spacing = 2 * np.pi * radius / 1319
    surface = paraboloid(101, 101 * spacing, radius)
    r = vr.slide(surface, on=MAT, load=load, speed=speed, threads=1)
    ball = vr.CoatedSphere(core_radius=radius)
    rolled = vr.solve(
        ball, load=load, angular_speed=max(speed, 1e-7) / radius, on=MAT, mesh=mesh, curvature=vr.enums.Curvature.EXACT
    )
    assert r.converged
    assert r.warnings == {}
    assert r.max_pressure == pytest.approx(rolled.max_pressure, rel=1e-5)
    area = r.contact_share * 101**2 * spacing**2
    assert area == pytest.approx(rolled.contact_area, rel=1e-9)
    if speed == 0.0:
        assert r.friction_coefficient == 0.0
    else:
        # The torque is the moment of the pressure, and the power balance of both has the error of the mesh.
        assert r.traction_friction * radius * load == pytest.approx(rolled.resisting_torque, rel=1e-5)
        assert r.friction_error / r.friction_coefficient == pytest.approx(rolled.energy_balance_error, rel=0.02)
    assert np.isnan(r.persson.friction_coefficient)


def test_hertz():
    radius, load = 0.02, 10.0
    on = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.3)
    modulus = 2e6 / 0.7
    a = (3 * load * radius / (4 * modulus)) ** (1 / 3)
    r = vr.slide(paraboloid(201, 2.5 * a, radius), on=on, load=load, speed=0.0, threads=1)
    # 160 nodes across the contact; the pressure is that of its patches.
    assert r.max_pressure == pytest.approx(1.5 * load / (np.pi * a**2), rel=1e-3)
    assert r.corrected_contact_share * (2.5 * a) ** 2 == pytest.approx(np.pi * a**2, rel=5e-3)
    assert r.friction_coefficient == 0.0


def test_a_parabola_is_hunters_roller():
    radius, load, speed = 0.02, 1000.0, 0.05
    roller = vr.analytic.hunter(load=load, speed=speed, radius=radius, shear_modulus=RUBBER, poisson_ratio=0.5)
    nodes, side = 2049, 0.03
    x = np.linspace(-0.5, 0.5, nodes) * side
    surface = vr.RoughSurface(-(x**2) / (2 * radius), spacing=x[1] - x[0], periodic=False)
    r = vr.slide(surface, on=INCOMPRESSIBLE, load=load, speed=speed, threads=1)
    assert r.friction_coefficient * radius * load == pytest.approx(float(roller.moment), rel=1e-3)
    assert r.friction_error < 1e-3 * r.friction_coefficient


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_free_surroundings_are_a_long_period(friction):
    # A rough island with free rubber around it, and one period of four times its length. On a layer, a distance of
    # three times the length of the island separates it from its images; the layer is a seventh as thick.
    nodes, side = 48, 1e-3
    rough = vr.RoughSurface.self_affine(
        nodes, side, hurst=0.8, rolloff=side / 3, cutoff=side / 6, rms_slope=0.08, seed=5
    )
    x = (np.arange(nodes) + 0.5) / nodes - 0.5
    bowl = -2e-4 * (x[:, np.newaxis] ** 2 + x**2)
    heights = rough.heights + bowl
    on = vr.CoatedPlane(layers=[vr.Layer(thickness=side / 7, shear_modulus=RUBBER, poisson_ratio=0.4)])
    island = vr.RoughSurface(heights, side / nodes, periodic=False)
    padded = np.full((4 * nodes, 4 * nodes), heights.min() - 1e-3)
    padded[:nodes, :nodes] = heights
    options = {"on": on, "load": 0.2, "speed": 0.01, "friction": friction, "threads": 1}
    r = vr.slide(island, **options)
    with pytest.warns(vr.ResultWarning):
        long = vr.slide(vr.RoughSurface(padded, side / nodes), **options)
    assert 0.05 < r.contact_share < 0.6
    # A node has a square patch on the finite surface, and collocated waves on the periodic one: a difference of the
    # mesh.
    assert r.friction_coefficient == pytest.approx(long.friction_coefficient, rel=2e-2)
    slopes, of_long = (one.total_friction_coefficient - friction for one in (r, long))
    assert slopes == pytest.approx(of_long, rel=3e-2)
    assert r.max_pressure == pytest.approx(long.max_pressure, rel=5e-2)
    assert r.contact_share * nodes**2 == pytest.approx(long.contact_share * 16 * nodes**2, rel=3e-2)
    assert r.friction_error < 0.05 * abs(r.friction_coefficient)


def test_empty_surroundings_change_nothing():
    small = paraboloid(61, 3e-3, 5e-3)
    large = paraboloid(101, 3e-3 / 61 * 101, 5e-3)
    r, wide = (vr.slide(s, on=MAT, load=1.0, speed=0.05, threads=1) for s in (small, large))
    assert wide.friction_coefficient == pytest.approx(r.friction_coefficient, rel=1e-6)
    assert np.abs(wide.pressure[20:-20, 20:-20] - r.pressure).max() < 1e-6 * r.max_pressure


def test_reversed_surfaces():
    # Mirrored across the path, the side force changes its sign.
    tilted = paraboloid(64, 3e-3, 5e-3)
    x = np.arange(64)
    heights = tilted.heights + 2e-6 * np.sin(0.2 * x[:, np.newaxis] + 0.3 * x)
    r, image = (
        vr.slide(vr.RoughSurface(h, tilted.spacing, periodic=False), on=MAT, load=1.0, speed=0.05, threads=1)
        for h in (heights, heights[:, ::-1])
    )
    assert image.side_force_coefficient == pytest.approx(-r.side_force_coefficient, rel=1e-6)
    assert abs(r.side_force_coefficient) > 1e-6
    assert image.friction_coefficient == pytest.approx(r.friction_coefficient, rel=1e-6)


def test_a_contact_at_the_rim_has_a_warning():
    with pytest.warns(vr.ResultWarning, match="the contact reaches the rim of the surface"):
        r = vr.slide(paraboloid(31, 1e-3, 5e-3), on=MAT, load=10.0, speed=0.05, threads=1)
    assert set(r.warnings) >= {"rim"}


def test_persson_needs_a_periodic_surface():
    with pytest.raises(ValueError, match=r"surface.periodic must be True; use surface.mirrored\(\)"):
        vr.sliding.persson_estimate(paraboloid(31, 1e-3, 5e-3), on=MAT, pressure=1e4, speed=0.05)
