"""Rough surfaces that slide on viscoelastic layers: closed forms, limits, dense matrices, and another program."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.sliding import persson_estimate

from tests.reference import sliding as reference

SIDE = 1e-3
TIME = 0.01
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=TIME)
SOLID = reference.Solid(10e6, 1e6, TIME)
INCOMPRESSIBLE = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5)
ELASTIC = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5)
CONTACT_MODULUS = 4e6  # of the relaxed rubber, 2 G / (1 - nu) [Pa]

pytestmark = pytest.mark.filterwarnings("ignore:the layers recover over", "ignore:the friction coefficients from")


def slid(surface, on=INCOMPRESSIBLE, *, pressure=2e4, speed=1e-3, **options):
    return vr.slide(surface, on=on, pressure=pressure, speed=speed, threads=1, **options)


def sinusoid(nodes, amplitude):
    return vr.RoughSurface.of(lambda x, z: amplitude * np.cos(2 * np.pi * x / SIDE), nodes=(nodes, 1), side=SIDE)


def rough(nodes, seed=1):
    return vr.RoughSurface.self_affine(
        nodes, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=SIDE / 32, rms_slope=0.1, seed=seed
    )


def full_contact(surface, waves, pressure):
    spectrum = np.fft.fft2(surface.heights)
    spectrum = np.divide(spectrum, waves, out=np.zeros_like(spectrum), where=waves != 0.0)
    return pressure + np.fft.ifft2(spectrum).real


@pytest.mark.parametrize(
    ("speed", "mean", "friction", "share", "largest", "gap"),
    # s = 2 pi V tau / L and p / p*; results of an independent NumPy program with 16384 nodes, whose last digits may
    # differ by one.
    [
        (0.1, 0.1, 0.28306, 0.0940, 1.6681, 0.79105),
        (0.1, 0.5, 0.45875, 0.3296, 2.1652, 0.27818),
        (1.0, 0.5, 0.15454, 0.1468, 4.4087, 0.77916),
        (10.0, 0.1, 0.004594, 0.0638, 2.0000, 0.94392),
    ],
)
def test_sinusoids_on_a_half_space(speed, mean, friction, share, largest, gap):
    amplitude = 0.01 * SIDE
    scale = np.pi * CONTACT_MODULUS * amplitude / SIDE
    r = slid(sinusoid(16384, amplitude), pressure=mean * scale, speed=speed * SIDE / (2 * np.pi * TIME))
    digits = 1e-6 if friction < 0.1 else 1e-5
    assert r.friction_coefficient * SIDE / (2 * np.pi * amplitude) == pytest.approx(friction, abs=1.5 * digits)
    assert r.contact_share == pytest.approx(share, abs=1.5e-4)
    assert r.max_pressure / scale == pytest.approx(largest, abs=1.5e-4)
    assert r.mean_gap / amplitude == pytest.approx(gap, abs=1.5e-5)


@pytest.mark.parametrize(
    ("poisson_ratio", "friction", "share", "largest"),
    # The same program with 1024 nodes; p* is that of incompressible rubber.
    [(0.5, 0.11034, 0.141, 4.587), (0.45, 0.12236, 0.149, 4.362)],
)
def test_sinusoids_on_a_layer(poisson_ratio, friction, share, largest):
    amplitude = 0.01 * SIDE
    mat = vr.CoatedPlane(layers=[vr.Layer(thickness=SIDE / 4, shear_modulus=RUBBER, poisson_ratio=poisson_ratio)])
    scale = np.pi * CONTACT_MODULUS * amplitude / SIDE
    r = slid(sinusoid(1024, amplitude), mat, pressure=0.5 * scale, speed=SIDE / (2 * np.pi * TIME))
    assert r.friction_coefficient * SIDE / (2 * np.pi * amplitude) == pytest.approx(friction, abs=1.5e-5)
    assert r.contact_share == pytest.approx(share, abs=1.5e-3)
    assert r.max_pressure / scale == pytest.approx(largest, abs=1.5e-3)


@pytest.mark.parametrize("share_of_full", [0.05, 0.3, 0.7])
def test_westergaard(share_of_full):
    # H. M. Westergaard, J. Appl. Mech. 6 (1939) A49-A53: contact over (2/pi) asin sqrt(p/p*) of the wavelength, largest
    # pressure 2 sqrt(p p*). The ends of the contact lie between nodes.
    nodes, amplitude = 4096, 1e-5
    scale = np.pi * CONTACT_MODULUS * amplitude / SIDE
    r = slid(sinusoid(nodes, amplitude), ELASTIC, pressure=share_of_full * scale, speed=0.0)
    assert r.contact_share == pytest.approx(2 / np.pi * np.arcsin(np.sqrt(share_of_full)), abs=1.01 / nodes)
    assert r.max_pressure == pytest.approx(2 * np.sqrt(share_of_full) * scale, rel=2e-6)
    assert r.friction_coefficient == 0.0


@pytest.mark.parametrize("nodes", [64, 63])
@pytest.mark.parametrize("speed", [0.0, 1e-3, 1.0])
def test_full_contact(nodes, speed):
    # p_k = -h_k / C, and the loss follows from the spectrum of the heights.
    surface = rough(128).cutoff(SIDE / 30).resampled(nodes)
    waves = reference.symbol(
        surface.heights.shape, surface.spacing, SOLID, speed, lambda k, g: reference.half_space(k, g, 0.5)
    )
    pressure = 1e8
    r = slid(surface, pressure=pressure, speed=speed)
    expected = full_contact(surface, waves, pressure)
    assert r.contact.all()
    assert np.abs(r.pressure - expected).max() < 1e-12 * pressure
    spread = expected - pressure
    assert np.abs(r.pressure - expected).max() < 1e-9 * np.abs(spread).max()
    assert r.friction_coefficient == pytest.approx(
        reference.loss(expected, waves, surface.spacing) / pressure, rel=1e-9, abs=1e-18
    )
    assert r.traction_friction == pytest.approx(r.friction_coefficient, rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("thickness", [None, 2e-4])
@pytest.mark.parametrize("poisson_ratio", [0.5, 0.3])
@pytest.mark.parametrize("shape", [(24, 20), (25, 21), (40, 1)])
def test_dense_matrices(thickness, poisson_ratio, shape):
    rng = np.random.default_rng(3)
    surface = vr.RoughSurface(1e-6 * rng.standard_normal(shape), (SIDE / shape[0], 0.8e-3 / shape[1]))
    if thickness is None:
        on = vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=poisson_ratio)
        compliance = reference.half_space
        more = ()
    else:
        on = vr.CoatedPlane(layers=[vr.Layer(thickness=thickness, shear_modulus=RUBBER, poisson_ratio=poisson_ratio)])
        compliance, more = reference.layer, (thickness,)
    speed = 0.02
    waves = reference.symbol(shape, surface.spacing, SOLID, speed, lambda k, g: compliance(k, g, poisson_ratio, *more))
    pressure, gap = reference.contact(surface.heights, waves, 3e4)
    with pytest.warns(vr.ResultWarning, match="waves shorter than four spacings"):
        r = slid(surface, on, pressure=3e4, speed=speed, tolerance=1e-12)
    assert (r.contact == (pressure > 0.0)).all()
    assert 0.02 < r.contact_share < 0.9
    assert np.abs(r.pressure - pressure).max() < 1e-9 * pressure.max()
    assert np.abs(r.gap - gap).max() < 1e-9 * gap.max()
    assert r.friction_coefficient == pytest.approx(reference.loss(pressure, waves, surface.spacing) / 3e4, rel=1e-8)


def test_friction_at_low_speed_is_that_of_the_relaxed_pressure():
    # With one relaxation function, mu -> V tau <p h_xx> / p with the relaxed pressure and the mean time
    # tau = sum g_k tau_k / g_inf, here 9 tau. The error of the curvature is proportional to the spacing.
    errors = []
    for nodes in (256, 512):
        surface = rough(nodes)
        k_x, _ = reference.wavenumbers(surface.heights.shape, surface.spacing)
        curvature = np.fft.ifft2(k_x**2 * np.fft.fft2(surface.heights)).real
        at_rest = slid(surface, pressure=2e4, speed=0.0)
        speed = 1e-6
        law = speed * 9.0 * TIME * (at_rest.pressure * curvature).mean() / 2e4
        errors.append(1.0 - slid(surface, pressure=2e4, speed=speed).friction_coefficient / law)
    assert 0.0 < errors[1] < 0.025
    assert errors[0] == pytest.approx(2.0 * errors[1], rel=0.3)


def test_friction_at_high_speed_falls_with_the_speed():
    # mu V p -> (1/G_inf - 1/G_0) / t_r sum_{k_x != 0} (1 - nu) |p_k|^2 / k with the pressure at that speed and the
    # retardation time t_r = tau G_0 / G_inf.
    surface = rough(128)
    k = np.hypot(*reference.wavenumbers(surface.heights.shape, surface.spacing))
    retardation = TIME * 10.0
    for speed, error in ((1.0, 1e-3), (10.0, 1e-4), (100.0, 1e-5)):
        r = slid(surface, speed=speed)
        squares = np.abs(np.fft.fft2(r.pressure, norm="forward")) ** 2
        squares[64] = 0.0  # the highest wave along x has no direction
        law = (1e-6 - 1e-7) / retardation * (0.5 * squares[1:] / k[1:]).sum() / 2e4 / speed
        assert r.friction_coefficient == pytest.approx(law, rel=error)


def test_symmetries():
    surface = rough(96)
    r = slid(surface)
    moved = slid(vr.RoughSurface(np.roll(surface.heights, (17, 40), axis=(0, 1)), surface.spacing))
    assert moved.friction_coefficient == pytest.approx(r.friction_coefficient, rel=1e-6)
    assert np.abs(moved.pressure - np.roll(r.pressure, (17, 40), axis=(0, 1))).max() < 1e-6 * r.max_pressure
    image = slid(vr.RoughSurface(surface.heights[:, ::-1], surface.spacing))
    assert image.side_force_coefficient == pytest.approx(-r.side_force_coefficient, rel=1e-5)
    assert image.friction_coefficient == pytest.approx(r.friction_coefficient, rel=1e-6)
    double = slid(surface.scaled(2.0), pressure=4e4)
    assert np.abs(double.pressure - 2.0 * r.pressure).max() < 1e-6 * r.max_pressure
    assert double.friction_coefficient == pytest.approx(2.0 * r.friction_coefficient, rel=1e-6)


def test_long_periods_give_hunters_roller():
    # The moment of a rigid cylinder on a half-plane; its error falls with the square of the period. The surface is a
    # parabola, and its friction coefficient is M / (P R).
    radius, load, speed = 0.02, 1000.0, 0.05
    roller = vr.analytic.hunter(load=load, speed=speed, radius=radius, shear_modulus=RUBBER, poisson_ratio=0.5)
    found = []
    for side in (0.1, 0.2):
        x = (np.arange(8192) + 0.5) / 8192 * side - 0.5 * side
        surface = vr.RoughSurface(-(x**2) / (2 * radius), spacing=side / 8192)
        r = vr.slide(surface, on=INCOMPRESSIBLE, load=load, speed=speed, threads=1)
        found.append(r.friction_coefficient * radius * load)
    assert found[1] + (found[1] - found[0]) / 3.0 == pytest.approx(float(roller.moment), rel=1e-3)


@pytest.mark.parametrize(("speed", "mesh_error"), [(1e-4, 0.03), (1e-3, 5e-3), (1e-2, 2e-3)])
def test_friction_converges_with_the_mesh(speed, mesh_error):
    coarse, fine = (slid(rough(nodes), speed=speed) for nodes in (256, 512))
    assert coarse.friction_coefficient == pytest.approx(fine.friction_coefficient, rel=mesh_error)
    assert fine.friction_error < 0.02 * fine.friction_coefficient + 5e-4
    # The error of the contact area is that of the patches at its edges, proportional to the spacing, so that two meshes
    # give its limit. The correction of the edges must bring both meshes closer to it.
    limit = 2.0 * fine.contact_share - coarse.contact_share
    for r in (coarse, fine):
        assert abs(r.corrected_contact_share - limit) < abs(r.contact_share - limit)


def test_the_power_balance_is_exact_without_edges_of_contacts():
    # In full contact, the displacement is the surface itself on every mesh, and power and tractions agree to rounding.
    r = slid(rough(128), pressure=2e7, speed=1e-3)
    assert r.contact_share == 1.0
    assert r.friction_error < 1e-15


def test_the_power_balance_has_the_error_of_the_edges_of_contacts():
    # At an edge the pressure rises as the square root of the distance, and the gap as its power 3/2: between the nodes
    # they overlap over a spacing, with a product proportional to the square of the spacing. The error does not depend
    # on the tolerance of the solver.
    wavy = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2 * np.pi * x / SIDE), nodes=(256, 1), side=SIDE)
    coarse, fine = (slid(wavy.resampled(nodes), pressure=6e4, speed=0.01) for nodes in (256, 16384))
    assert fine.friction_error < 1e-6 * coarse.friction_coefficient
    # 64 times as many nodes; the place of the edge between two nodes changes the error by a factor of about 10.
    assert fine.friction_error < 10.0 * coarse.friction_error / 64**2
    strict = slid(wavy, pressure=6e4, speed=0.01, tolerance=1e-12)
    assert strict.friction_error == pytest.approx(coarse.friction_error, rel=1e-3)


@pytest.mark.parametrize("nodes", [256, 255, pytest.param(511, marks=pytest.mark.slow)])
def test_large_contacts_converge(nodes):
    # On 511 x 511 nodes, a node with neither force nor gap once changed the contact without end; see the active set in
    # tests/cpp/test_contact.cpp.
    r = slid(rough(nodes), pressure=6e4, speed=1e-4, max_iterations=40)
    assert 0.15 < r.contact_share < 0.25
    assert r.converged
    assert r.residual < 1e-7


def test_persson_estimate():
    # The sum over waves, written out.
    surface = rough(72)
    k_x, k_z = reference.wavenumbers(surface.heights.shape, surface.spacing)
    waves = reference.symbol(
        surface.heights.shape, surface.spacing, SOLID, 1e-3, lambda k, g: reference.half_space(k, g, 0.5)
    )
    used = waves != 0.0
    used[36] = False
    squares = (np.abs(np.fft.fft2(surface.heights, norm="forward")) ** 2)[used]
    stiffness = 1.0 / waves[used]
    k = np.hypot(k_x, k_z)[used]
    # Waves of the same length belong to the same share of contact.
    variance = (squares * np.abs(stiffness) ** 2 * (k <= k[:, np.newaxis] * (1 + 1e-9))).sum(axis=1)
    share = np.array([math.erf(2e4 / math.sqrt(2.0 * value)) for value in variance])
    power = squares * np.abs((k_x + 0.0 * k_z)[used] * stiffness.imag)
    for gamma in (0.5, 1.0):
        estimate = persson_estimate(surface, on=INCOMPRESSIBLE, pressure=2e4, speed=1e-3, gamma=gamma)
        expected = (power * share * (gamma + (1 - gamma) * share**2)).sum() / 2e4
        assert estimate.friction_coefficient == pytest.approx(expected, rel=1e-9)
        assert estimate.contact_share == pytest.approx(share.min(), rel=1e-9)
    assert slid(surface, speed=1e-3).persson == persson_estimate(surface, on=INCOMPRESSIBLE, pressure=2e4, speed=1e-3)
