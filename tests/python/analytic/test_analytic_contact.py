"""Closed forms of contacts at rest, compared with quadrature, the exact bonded layer, and the solver."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import viscoroll as vr
from reference import sphere
from reference.bonded_layer import bonded_layer
from scipy import integrate
from viscoroll import analytic, enums

RADIUS = 20e-3
MODULUS = 3e6
ELASTIC = {"radius": RADIUS, "shear_modulus": MODULUS}
THIN = ELASTIC | {"thickness": 1e-3}


def close(expected, *, rel):
    """Return a relative comparison, without the absolute tolerance of pytest.approx, which exceeds small torques."""
    return pytest.approx(expected, rel=rel, abs=0.0)


def nearly_solid(**material):
    """Return a ball of radius RADIUS whose core has a thousandth of it."""
    layer = vr.Layer(thickness=0.999 * RADIUS, **material)
    return vr.CoatedSphere(core_radius=1e-3 * RADIUS, layers=[layer])


def press(ball, *, load, nodes):
    mesh = vr.Mesh(nodes_per_revolution=nodes, max_order=3 * nodes // 2)
    # With PAPER, the pressure is closer to that of a half-space: at a/R = 0.2, its peak is 0.4 % below Hertz's, and
    # with SPHERE 1.3 %.
    return vr.solve(ball, load=load, angular_speed=1.0, mesh=mesh, curvature=enums.Curvature.PAPER)


def hertz_load(contact_radius, poisson_ratio):
    return 8.0 * MODULUS * contact_radius**3 / (3.0 * (1.0 - poisson_ratio) * RADIUS)


CONTACTS = {
    "hertz": analytic.hertz(load=100.0, poisson_ratio=0.3, **ELASTIC),
    "springs": analytic.thin_compressible_layer(load=100.0, poisson_ratio=0.3, **THIN),
    "squeezed": analytic.thin_incompressible_layer(load=100.0, **THIN),
}


@pytest.mark.parametrize("contact", CONTACTS.values(), ids=CONTACTS)
def test_pressure_supports_the_load(contact):
    load, _ = integrate.quad(lambda r: 2.0 * np.pi * r * contact.pressure(r), 0.0, contact.radius)
    assert load == close(100.0, rel=1e-10)
    assert contact.pressure(0.0) == contact.max_pressure
    assert contact.pressure(np.array([1.0, 1.5]) * contact.radius).tolist() == [0.0, 0.0]


@pytest.mark.parametrize("share", [0.0, 0.3, 0.7, 1.0])
def test_hertz_pressure_flattens_a_half_space(share):
    # By Boussinesq, u = (1-nu)/(2 pi G) * integral of p / distance, which must be d - r^2/2R. In polar coordinates
    # (s, phi) around the point at r, the distance cancels. The square root of p at the edge limits the quadrature to
    # 1e-7.
    contact = CONTACTS["hertz"]
    a, r = contact.radius, share * contact.radius

    def pressure(s, phi):
        return contact.pressure(np.sqrt(r**2 + s**2 + 2.0 * r * s * np.cos(phi)))

    def edge(phi):
        return -r * np.cos(phi) + np.sqrt(a**2 - (r * np.sin(phi)) ** 2)

    potential, _ = integrate.dblquad(pressure, 0.0, 2.0 * np.pi, 0.0, edge, epsrel=1e-9)
    displacement = 0.7 / (2.0 * np.pi * MODULUS) * potential
    assert displacement == close(contact.approach - r**2 / (2.0 * RADIUS), rel=1e-7)


def test_springs_have_the_confined_modulus():
    # The confined modulus is K + 4G/3, with K from nu = 0.3.
    contact = CONTACTS["springs"]
    confined = 2.0 * MODULUS * 1.3 / (3.0 * 0.4) + 4.0 / 3.0 * MODULUS
    r = np.linspace(0.0, 1.0, 7) * contact.radius
    expected = confined * (contact.approach - r**2 / (2.0 * RADIUS)) / 1e-3
    np.testing.assert_allclose(contact.pressure(r), expected, rtol=0.0, atol=1e-12 * contact.max_pressure)


def test_squeezed_layer_is_a_film():
    # The film satisfies div((h^3/3G) grad p) = -(d - r^2/2R), without flow at the edge. mpmath differentiates
    # p = p0 (1 - r^2/a^2)^2.
    contact = CONTACTS["squeezed"]

    def pressure(r):
        return contact.max_pressure * (1 - (r / contact.radius) ** 2) ** contact.exponent

    assert float(pressure(0.4 * contact.radius)) == close(contact.pressure(0.4 * contact.radius), rel=1e-14)
    for r in np.array([0.2, 0.6, 0.9]) * contact.radius:
        with mpmath.workdps(40):
            divergence = mpmath.diff(lambda s: s * mpmath.diff(pressure, s), r) / r
        squeeze = -3.0 * MODULUS / 1e-3**3 * (contact.approach - r**2 / (2.0 * RADIUS))
        assert float(divergence) == close(squeeze, rel=1e-9)
    assert float(mpmath.diff(pressure, contact.radius)) == pytest.approx(0.0, abs=1e-6 * contact.max_pressure)


def test_bonded_layer():
    load, approach = bonded_layer(5, 0.5)
    assert load / 5**3 == close(53.046949, rel=1e-7)
    assert approach / 5**2 == close(0.359125, rel=2e-6)


def thin_contact(poisson_ratio, **arguments):
    if poisson_ratio == 0.5:
        return analytic.thin_incompressible_layer(**arguments)
    return analytic.thin_compressible_layer(poisson_ratio=poisson_ratio, **arguments)


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.5])
def test_thin_layers_are_the_limit_of_bonded_ones(poisson_ratio):
    # The contact radius that the closed form gives for the exact load is a + const h. A parabola in h/a extrapolates it
    # from a/h = 10, 20 and 40; the next order, (h/a)^3, is 2e-5 at a/h = 40.
    shares = []
    for slenderness in (10, 20, 40):
        load, approach = bonded_layer(slenderness, poisson_ratio)
        contact = thin_contact(poisson_ratio, load=load, radius=1.0, thickness=1.0, shear_modulus=1.0)
        shares.append((contact.radius / slenderness, contact.approach / approach))
    radius, approach = np.array(shares).T
    assert (8.0 * radius[2] - 6.0 * radius[1] + radius[0]) / 3.0 == pytest.approx(1.0, abs=5e-4)
    # At given load, the approach has no error of first order.
    assert abs(approach[2] - 1.0) < 0.3 * abs(approach[0] - 1.0) < 0.02
    assert approach[2] == pytest.approx(1.0, abs=5e-3)


def test_numbers_of_the_docstrings():
    def excess(slenderness, poisson_ratio):
        load, approach = bonded_layer(slenderness, poisson_ratio)
        springs = 2.0 * (1.0 - poisson_ratio) / max(1.0 - 2.0 * poisson_ratio, 1e-9) * np.pi * slenderness**4 / 4.0
        at_radius = np.pi * slenderness**6 / 32.0 if poisson_ratio == 0.5 else springs
        return load / at_radius, load / (2.0 * np.pi * approach**3)

    assert excess(10, 0.5)[0] == pytest.approx(2.2, abs=0.05)
    assert 1.0 - 1.0 / excess(10, 0.5)[1] == pytest.approx(0.13, abs=0.005)
    assert 1.0 - 1.0 / excess(20, 0.5)[1] == pytest.approx(0.04, abs=0.005)
    # Near h/a = 0, the exact load at given a is larger by the fraction s h/a.
    shares = {0.0: 0.73, 0.1: 0.76, 0.2: 0.72, 0.3: 0.49, 0.4: -0.45, 0.45: -2.2, 0.48: -6.1, 0.49: -10.8}
    for poisson_ratio, share in shares.items():
        s40, s80 = ((excess(a, poisson_ratio)[0] - 1.0) * a for a in (40, 80))
        assert 2.0 * s80 - s40 == pytest.approx(share, abs=0.006 if abs(share) < 1.0 else 0.06), poisson_ratio


def test_approach_of_an_exact_sphere_is_smaller_than_hertz():
    # Compare with numbers of the docstring; the rings have an error of 2e-4. With the compliance 1/(2n+1) of a
    # half-space for degree n, the approach would be Hertz's.
    assert sphere.compliance(1e4) == close(1.0 / 2e4, rel=1e-3)
    for slenderness, share, between in ((0.1, 0.06, 0.029), (0.05, 0.03, 0.014)):
        assert 1.0 - sphere.approach(slenderness) == pytest.approx(share, abs=1.5e-3)
        assert 1.0 - sphere.approach(slenderness, planes=2) == pytest.approx(between, abs=1.5e-3)


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.5])
def test_solver_on_a_nearly_solid_ball_agrees_with_hertz(poisson_ratio):
    # The approach differs from that of a half-space in proportion to a/R, so it is extrapolated from two values.
    material = {"shear_modulus": vr.Elastic(modulus=MODULUS), "poisson_ratio": poisson_ratio}
    shares = []
    for slenderness, nodes in [(0.1, 800), (0.05, 1600)]:
        load = hertz_load(slenderness * RADIUS, poisson_ratio)
        contact = analytic.hertz(load=load, poisson_ratio=poisson_ratio, **ELASTIC)
        assert contact.radius == close(slenderness * RADIUS, rel=1e-12)
        r = press(nearly_solid(**material), load=load, nodes=nodes)
        shares.append(r.penetration / contact.approach)
        assert r.max_pressure == close(contact.max_pressure, rel=5e-3)
        # The torque of Greenwood and Tabor is the moment of the front half. There are 13 nodes per contact radius.
        front = (np.clip(r.x, 0.0, None) * r.pressure).sum() / r.pressure.sum() * load
        torque = analytic.greenwood_tabor_torque(load=load, poisson_ratio=poisson_ratio, **ELASTIC)
        assert front == close(torque, rel=5e-3)
    assert shares[0] < shares[1] < 1.0
    assert 2.0 * shares[1] - shares[0] == pytest.approx(1.0, abs=4e-3)


@pytest.mark.parametrize(("poisson_ratio", "tolerance"), [(0.3, 2e-3), (0.5, 0.015)])
def test_solver_on_a_thin_coating(poisson_ratio, tolerance):
    # Here a/h = 20 and a/R = 0.08, with 24 nodes per contact radius. Relative to the exact layer, the closed form is
    # 0.1 % low at nu = 0.3 and 1.4 % high at nu = 1/2, where the error of the mesh cancels half of it.
    thickness, radius = 1e-3, 20e-3 / 0.08
    load = bonded_layer(20, poisson_ratio)[0] * MODULUS * thickness**3 / radius
    layer = vr.Layer(thickness=thickness, shear_modulus=vr.Elastic(modulus=MODULUS), poisson_ratio=poisson_ratio)
    contact = thin_contact(poisson_ratio, load=load, radius=radius, thickness=thickness, shear_modulus=MODULUS)
    r = press(vr.CoatedSphere(core_radius=radius - thickness, layers=[layer]), load=load, nodes=1880)
    assert r.penetration == close(contact.approach, rel=tolerance)
