"""Rough surfaces with Coulomb friction at the interface: dense matrices, closed forms and the balance of power."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr

from tests.reference import sliding as reference

SIDE = 1e-3
FRICTION = 0.6
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
SOLID = reference.Solid(10e6, 1e6, 0.01)


def slid(surface, on, *, pressure=3e4, speed=0.02, **options):
    return vr.slide(surface, on=on, pressure=pressure, speed=speed, threads=1, **options)


@pytest.mark.filterwarnings("ignore:waves shorter than four spacings")
@pytest.mark.parametrize(("thickness", "poisson_ratio"), [(None, 0.3), (5e-5, 0.5), (5e-5, 0.3)])
@pytest.mark.parametrize("shape", [(24, 20), (25, 21), (40, 1)])
def test_dense_matrices(thickness, poisson_ratio, shape):
    # The losses are those of both stresses at both displacements, and the slip is the speed times the strained length.
    rng = np.random.default_rng(3)
    surface = vr.RoughSurface(1e-6 * rng.standard_normal(shape), (SIDE / shape[0], 0.8e-3 / shape[1]))
    speed = 0.02
    if thickness is None:
        on = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=poisson_ratio)

        def in_plane(k, g):
            return reference.half_space_in_plane(k, g, poisson_ratio)

        def across(k, g):
            return 1.0 / (g * k)
    else:
        on = vr.CoatedPlane(layers=[vr.Layer(thickness=thickness, shear_modulus=RUBBER, poisson_ratio=poisson_ratio)])

        def in_plane(k, g):
            return reference.layer_in_plane(k, g, poisson_ratio, thickness)

        def across(k, g):
            return np.tanh(k * thickness) / (g * k)

    inwards, along = reference.symbols_with_friction(shape, surface.spacing, SOLID, speed, FRICTION, in_plane, across)
    pressure, gap = reference.contact(surface.heights, inwards, 3e4)
    r = slid(surface, on, speed=speed, friction=FRICTION, tolerance=1e-12)
    assert r.friction == FRICTION
    assert (r.contact == (pressure > 0.0)).all()
    assert 0.02 < r.contact_share < 0.9
    assert np.abs(r.pressure - pressure).max() < 1e-9 * pressure.max()
    assert np.abs(r.gap - gap).max() < 1e-9 * gap.max()
    # Pressure and friction do the work p (-V) du_n/dx and q (-V) du_x/dx on the layers, which pass at -V.
    k_x, _ = reference.wavenumbers(shape, surface.spacing)
    if shape[0] % 2 == 0:
        k_x[shape[0] // 2] = 0.0
    spectrum = np.abs(np.fft.fft2(pressure, norm="forward")) ** 2
    normal, tangential = ((k_x * waves.imag * spectrum).sum() for waves in (inwards, FRICTION * along))
    slip = 1.0 + np.fft.ifft2(1j * k_x * along * np.fft.fft2(pressure)).real
    assert r.power_density == pytest.approx(speed * (normal + tangential), rel=1e-8)
    assert r.interface_power_density == pytest.approx(speed * (FRICTION * pressure * slip).mean(), rel=1e-9)
    assert r.total_friction_coefficient == pytest.approx(FRICTION + normal / 3e4, rel=1e-9)
    power = r.total_friction_coefficient * 3e4 * speed
    assert power == pytest.approx(r.power_density + r.interface_power_density, rel=1e-12)


def test_friction_does_not_change_the_contact_on_an_incompressible_half_space():
    # Its surface does not move inwards under shear stress. The shear stress itself is dissipated as well.
    surface = vr.RoughSurface.self_affine(
        96, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=SIDE / 12, rms_slope=0.1, seed=1
    )
    on = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5)
    without, rubbing = (slid(surface, on, friction=friction) for friction in (0.0, 0.5))
    assert np.abs(rubbing.pressure - without.pressure).max() < 1e-6 * without.max_pressure
    assert rubbing.total_friction_coefficient == pytest.approx(0.5 + without.friction_coefficient, rel=1e-6)
    assert rubbing.friction_coefficient > without.friction_coefficient
    assert without.interface_power_density == 0.0
    assert without.total_friction_coefficient == without.friction_coefficient


def test_vanishing_friction_is_no_friction():
    surface = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2 * np.pi * x / SIDE), nodes=(512, 1), side=SIDE)
    on = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.3)
    without, hardly = (slid(surface, on, friction=friction) for friction in (0.0, 1e-9))
    assert hardly.friction_coefficient == pytest.approx(without.friction_coefficient, rel=1e-6)
    assert np.abs(hardly.pressure - without.pressure).max() < 1e-6 * without.max_pressure


def test_a_cylinder_that_slides_on_an_elastic_half_plane():
    # K. L. Johnson, Contact Mechanics (1985), section 8.3: p ~ (a - x)^(1/2 + g) (a + x)^(1/2 - g) with
    # tan(pi g) = mu (1 - 2 nu) / (2 (1 - nu)), so that the moment arm of the pressure about the axis of the cylinder is
    # (8/3) g a. The pressure is larger behind the axis: the half-plane is compressed in the contact, so that less of it
    # rubs, and the slopes push forward by the power that the interface saves.
    radius, mu, nu = 0.02, 0.5, 0.2
    on = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=nu)
    nodes, side = 4097, 4e-3
    x = np.linspace(-0.5, 0.5, nodes) * side
    surface = vr.RoughSurface(-(x**2) / (2 * radius), spacing=x[1] - x[0], periodic=False)
    r = vr.slide(surface, on=on, load=100.0, speed=1.0, friction=mu, threads=1)
    half_width = 0.5 * r.contact_share * nodes * surface.spacing[0]
    g = np.arctan(mu * (1 - 2 * nu) / (2 * (1 - nu))) / np.pi
    # The contact has 1600 nodes, and its width an error of one of them.
    for slopes in (r.total_friction_coefficient - mu, (r.pressure[:, 0] * x).mean() / r.mean_pressure / radius):
        assert slopes * radius == pytest.approx(-8 / 3 * g * half_width, rel=1e-3)
    assert r.friction_coefficient == pytest.approx(0.0, abs=1e-9)
    assert r.friction_error < 1e-6


def test_messages():
    surface = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2 * np.pi * x / SIDE), nodes=(64, 1), side=SIDE)
    on = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5)
    with pytest.raises(ValueError, match=r"friction must be >= 0, got -0\.1"):
        slid(surface, on, friction=-0.1)
    with pytest.raises(ValueError, match="speed must be > 0 m/s with friction, got 0"):
        slid(surface, on, friction=0.1, speed=0.0)
