"""Single orders: state matrix and surface compliance, compared with the paper's equations and 50-digit arithmetic."""

from __future__ import annotations

import itertools
import math

import mpmath
import numpy as np
import pytest
import viscoroll as vr
from reference import layers as reference
from viscoroll import enums

# Balls of the reference package: radii [m], Prony parameters (G0, weights, times), Poisson's ratio, density.
RUBBER = (6e6, [0.5], [0.125])
SOFT = (2e6, [0.3, 0.2], [0.01, 1.0])


def reference_layer(inner, outer, material, poisson_ratio, density):
    return reference.Layer(inner, outer, lambda w: reference.prony(*material, w), poisson_ratio, density)


def ball_of(layers):
    def convert(layer, material):
        modulus = vr.Prony(instantaneous_modulus=material[0], weights=material[1], relaxation_times=material[2])
        return vr.Layer(
            thickness=layer.outer - layer.inner,
            shear_modulus=modulus,
            poisson_ratio=layer.poisson_ratio,
            density=layer.density,
        )

    return vr.CoatedSphere(core_radius=layers[0][0].inner, layers=[convert(*layer) for layer in layers])


TWO_LAYERS = [
    (reference_layer(20e-3, 22e-3, RUBBER, 0.45, 1000.0), RUBBER),
    (reference_layer(22e-3, 23e-3, SOFT, 0.5, 1500.0), SOFT),
]


@pytest.mark.parametrize("angular_speed", [2.5, 300.0])
@pytest.mark.parametrize(("m", "n"), [(0, 0), (3, -4), (-7, 11)])
def test_state_matrix_is_equation_26(angular_speed, m, n):
    ball = ball_of(TWO_LAYERS)
    for (layer, _), core_layer in zip(TWO_LAYERS, ball.layers, strict=True):
        r = 0.3 * layer.inner + 0.7 * layer.outer
        a = reference.system_matrix(layer, angular_speed, m, n, r)
        # Transform dq/dr = A q with stresses sigma to dz/d(ln r) = B z with r sigma.
        d = np.diag([1, 1, 1, r, r, r])
        expected = np.diag([0, 0, 0, 1, 1, 1]) + r * d @ a @ np.linalg.inv(d)
        b = vr.modal.state_matrix(core_layer, angular_speed, r, m, n, curvature=enums.Curvature.PAPER)
        np.testing.assert_allclose(b, expected, rtol=1e-13, atol=1e-14)


@pytest.mark.parametrize("angular_speed", [2.5, 300.0])
def test_two_layers_with_inertia_agree_with_the_papers_product(angular_speed):
    m, n = np.array([0, 1, 2, 5, -7, 20, 60, 90]), np.array([0, 3, -2, 0, 11, 20, -60, 5])
    expected = reference.extrapolated_compliance([layer for layer, _ in TWO_LAYERS], angular_speed, m, n, (20, 40, 80))
    compliance = vr.modal.surface_compliance(ball_of(TWO_LAYERS), angular_speed, m, n, curvature=enums.Curvature.PAPER)
    size = np.abs(expected).max(axis=(1, 2), keepdims=True)
    # Error of the extrapolation of the sub-intervals at order 90.
    assert (np.abs(compliance - expected) < 1e-9 * size).all()


def test_the_papers_product_overflows_where_the_recursion_does_not():
    layer = reference_layer(11e-3, 21e-3, RUBBER, 0.5, 0.0)
    with np.errstate(all="ignore"):
        assert not np.isfinite(reference.product_compliance([layer], 2.5, 1500, 0, 50)).all()
    assert np.isfinite(vr.modal.surface_compliance(ball_of([(layer, RUBBER)]), 2.5, 1500, 0)).all()


def membrane_stiffness(k2, curvature):
    """Return the term that replaces k^2 beside the shear modulus in the paper's (26) for a curvature."""
    if curvature is enums.Curvature.PAPER:
        return k2
    return k2 - 2 if k2 >= 4 else mpmath.mpf(k2) / 2


def exact_compliance(layers, angular_speed, m, n, curvature, *, digits=50, hollow=False):
    """Return the surface compliance without inertia to `digits` digits, by matrix exponentials of the layers in ln r.

    Material deeper than exp(-70 / k) is left out (its effect is below exp(-140)), and the working precision covers the
    growth of the exponentials in the rest.
    """
    k = math.hypot(m, n)
    with mpmath.workdps(digits + (80 if k else 20) + 20):
        y = mpmath.zeros(3)
        outermost = mpmath.mpf(layers[-1][0].outer)
        for layer, (g0, weights, times) in layers:
            inner, outer = mpmath.mpf(layer.inner), mpmath.mpf(layer.outer)
            if k:
                inner = max(inner, outermost * mpmath.exp(-70 / mpmath.mpf(k)))
            if inner >= outer:
                continue
            w = mpmath.mpf(abs(m)) * mpmath.mpf(angular_speed)
            terms = [mpmath.mpf(g) * 1j * w * t / (1 + 1j * w * t) for g, t in zip(weights, times, strict=True)]
            mu = mpmath.mpf(g0) * (1 - sum(mpmath.mpf(g) for g in weights) + sum(terms))
            mu = mpmath.conj(mu) if m < 0 else mu
            nu = mpmath.mpf(layer.poisson_ratio)
            a, b = nu / (1 - nu), (1 - 2 * nu) / (2 * (1 - nu))
            gamma = mu * (3 * a + 2 * b)
            membrane = mu * membrane_stiffness(m**2 + n**2, curvature)
            i = mpmath.mpc(0, 1)
            matrix = mpmath.matrix(
                [
                    [-2 * a, -i * m * a, -i * n * a, b / mu, 0, 0],
                    [-i * m, 1, 0, 0, 1 / mu, 0],
                    [-i * n, 0, 1, 0, 0, 1 / mu],
                    [4 * gamma, 2 * i * m * gamma, 2 * i * n * gamma, 1 - 4 * b, -i * m, -i * n],
                    [-2 * i * m * gamma, m**2 * gamma + membrane, m * n * gamma, -i * m * a, -2, 0],
                    [-2 * i * n * gamma, m * n * gamma, n**2 * gamma + membrane, -i * n * a, 0, -2],
                ]
            )
            t = mpmath.expm(matrix * mpmath.log(outer / inner), method="taylor")
            if hollow and inner == layer.inner and layer is layers[0][0]:
                y = t[:3, :3] * mpmath.inverse(t[3:, :3])
            else:
                y = (t[:3, :3] * y + t[:3, 3:]) * mpmath.inverse(t[3:, :3] * y + t[3:, 3:])
        return np.array((y * outermost).tolist(), dtype=complex)


CURVATURES = [enums.Curvature.SPHERE, enums.Curvature.PAPER]
# Radius 21 mm: from a layer of 1e-3 of the radius to a core of 1e-3 of it [m].
THICKNESSES = [21e-6, 0.2e-3, 1e-3, 5e-3, 20.979e-3]
ORDERS = [
    (0, 0),
    (0, 1),
    (1, 0),
    (2, -1),
    (13, 7),
    (0, 60),
    (150, 40),
    (-500, 499),
    (1500, 0),
    (5000, 5000),
    (1, 1),
    (2, 0),
]


KINDS = [(1, enums.Curvature.SPHERE), (2, enums.Curvature.SPHERE), (1, enums.Curvature.PAPER)]


@pytest.mark.parametrize(
    ("thickness", "poisson_ratio", "count", "curvature", "first"),
    # Not all combinations are tested, because matrix exponentials with fifty digits are slow. `make test` tests every
    # second order of each combination, so that all orders occur with every thickness and with every Poisson's ratio.
    [
        (thickness, poisson_ratio, *KINDS[(i + j) % 3], (i + j) % 2)
        for i, thickness in enumerate(THICKNESSES)
        for j, poisson_ratio in enumerate([0.0, 0.3, 0.49999, 0.5])
    ],
)
@pytest.mark.parametrize("part", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_surface_compliance_agrees_with_fifty_digits(thickness, poisson_ratio, count, curvature, first, part):
    inner = 21e-3 - thickness
    bounds = np.linspace(inner, 21e-3, count + 1)
    materials = [RUBBER, SOFT][:count]
    layers = [
        (reference_layer(float(low), float(high), material, poisson_ratio, 0.0), material)
        for (low, high), material in zip(itertools.pairwise(bounds), materials, strict=True)
    ]
    ball = ball_of(layers)
    for m, n in ORDERS[(first + part) % 2 :: 2]:
        expected = exact_compliance(layers, 2.5, m, n, curvature)
        compliance = vr.modal.surface_compliance(ball, 2.5, m, n, curvature=curvature)
        # C is positive definite, so C_ij is at most (C_ii C_jj)^(1/2). The thickness is a difference of radii, which
        # loses a digit or two.
        diagonal = np.abs(np.diag(expected))
        size = np.sqrt(np.outer(diagonal, diagonal))
        assert (np.abs(compliance - expected) <= 1e-9 * size).all(), (m, n)
        assert abs(compliance[0, 0] - expected[0, 0]) <= 1e-9 * abs(expected[0, 0]), (m, n)


def test_exponents_of_the_paper_agree_with_their_closed_form(rubber):
    nu, m, n = 0.3, 3, 4
    layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=nu)
    k = math.hypot(m, n)
    step = k * math.sqrt((5 - 4 * nu) / (1 - nu))
    roots = [math.sqrt(k**2 + 9 / 4 + shift) for shift in (-step, 0.0, step)]
    expected = sorted(-0.5 + sign * root for root in roots for sign in (-1, 1))
    exponents = np.linalg.eigvals(vr.modal.state_matrix(layer, 2.5, 20e-3, m, n, curvature=enums.Curvature.PAPER))
    np.testing.assert_allclose(sorted(exponents.real), expected, rtol=1e-8)
    np.testing.assert_allclose(exponents.imag, 0.0, atol=1e-6)


@pytest.mark.parametrize("poisson_ratio", [0.0, 0.3, 0.5])
@pytest.mark.parametrize(("m", "n"), [(2, 0), (3, -4), (4, 12)])
def test_exponents_on_a_sphere_agree_with_classical_solutions(rubber, poisson_ratio, m, n):
    """Compare with the powers of r of the spheroidal and toroidal solutions, with l (l + 1) = k^2."""
    degree = math.sqrt(m**2 + n**2 + 0.25) - 0.5
    spheroidal = [degree + 1, degree - 1, -degree, -degree - 2]
    expected = sorted([*spheroidal, degree, -degree - 1])
    layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=poisson_ratio)
    exponents = np.linalg.eigvals(vr.modal.state_matrix(layer, 2.5, 20e-3, m, n))
    np.testing.assert_allclose(sorted(exponents.real), expected, atol=1e-6)
    np.testing.assert_allclose(exponents.imag, 0.0, atol=1e-6)


@pytest.mark.parametrize("inner_boundary", enums.InnerBoundary)
@pytest.mark.parametrize("curvature", CURVATURES)
def test_every_order_is_passive(rubber, inner_boundary, curvature):
    """Any load does work on the coating and dissipates energy in it: thin, thick and nearly solid balls."""
    m, n = (order.ravel() for order in np.meshgrid(np.arange(6), np.arange(-6, 7)))
    for thickness in (1e-3, 0.1, 0.5, 0.501, 0.9, 0.999):
        solid = inner_boundary is enums.InnerBoundary.SOLID
        for compressibility in ({"poisson_ratio": -0.9}, {"poisson_ratio": 0.5}, {"bulk_modulus": 1e5}):
            layer = vr.Layer(thickness=1.0 if solid else thickness, shear_modulus=rubber, **compressibility)
            core = 0.0 if solid else 1.0 - thickness
            ball = vr.CoatedSphere(core_radius=core, layers=[layer], inner_boundary=inner_boundary)
            c = vr.modal.surface_compliance(ball, 2.5, m, n, curvature=curvature)
            stored = np.linalg.eigvalsh(0.5 * (c + c.conj().transpose(0, 2, 1)))
            lost = np.linalg.eigvalsh(0.5j * (c - c.conj().transpose(0, 2, 1)))
            largest = stored[:, -1:]
            assert (stored >= -1e-12 * largest).all()
            assert (lost >= -1e-12 * largest).all()


def test_symmetries(two_layer_ball):
    m, n = np.array([0, 1, 5, 40]), np.array([2, 3, 0, 17])
    c = vr.modal.surface_compliance(two_layer_ball, 250.0, m, n)
    np.testing.assert_allclose(
        vr.modal.surface_compliance(two_layer_ball, 250.0, -m, -n), c.conj(), rtol=1e-14, atol=1e-30
    )
    odd_in_n = np.array([[1, 1, -1], [1, 1, -1], [-1, -1, 1]])
    np.testing.assert_allclose(
        vr.modal.surface_compliance(two_layer_ball, 250.0, m, -n), c * odd_in_n, rtol=1e-11, atol=1e-22
    )
    reciprocal = np.array([[1, -1, -1], [-1, 1, 1], [-1, 1, 1]])
    np.testing.assert_allclose(c.transpose(0, 2, 1), c * reciprocal, rtol=1e-11, atol=1e-22)


def test_identical_layers_act_as_one_layer(rubber):
    def ball(count):
        layer = vr.Layer(thickness=5e-3 / count, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer] * count)

    m, n = np.meshgrid([0, 1, 7, 80, 400], [0, 3, 50])
    one, seven = (vr.modal.surface_compliance(ball(count), 25.0, m, n) for count in (1, 7))
    # Errors are relative to the geometric mean of the diagonal entries.
    diagonal = np.abs(np.einsum("...ii->...i", one))
    size = np.sqrt(diagonal[..., :, None] * diagonal[..., None, :])
    assert (np.abs(one - seven) <= 1e-12 * size).all()
    mesh = vr.Mesh(nodes_per_revolution=200, max_order=200)
    torques = [vr.solve(ball(c), load=100.0, angular_speed=25.0, mesh=mesh).resisting_torque for c in (1, 7)]
    assert torques[0] == pytest.approx(torques[1], rel=1e-10)


def test_constant_bulk_modulus_tends_to_incompressible(rubber):
    def compliance(**compressibility):
        layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, **compressibility)
        return vr.modal.surface_compliance(vr.CoatedSphere(core_radius=20e-3, layers=[layer]), 2.5, [1, 20], [2, 30])

    incompressible = compliance(poisson_ratio=0.5)
    errors = [np.abs(compliance(bulk_modulus=k) / incompressible - 1.0).max() for k in (1e12, 1e13)]
    # C_rr of a thin layer grows by about mu / K times the square of its slenderness, (r_o / (k h))^2 = 90 at (1, 2).
    assert errors[1] < 3.0 * 90.0 * 6e6 / 1e13
    assert errors[0] == pytest.approx(10 * errors[1], rel=0.01)


def test_constant_bulk_modulus_of_an_elastic_layer_is_its_poisson_ratio():
    shear, nu = 2e6, 0.37
    bulk = 2 * shear * (1 + nu) / (3 * (1 - 2 * nu))

    def ball(**compressibility):
        layer = vr.Layer(thickness=3e-3, shear_modulus=vr.Elastic(modulus=shear), density=1000.0, **compressibility)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    m, n = [0, 3, 50], [0, 5, 40]
    np.testing.assert_allclose(
        vr.modal.surface_compliance(ball(bulk_modulus=bulk), 9.0, m, n),
        vr.modal.surface_compliance(ball(poisson_ratio=nu), 9.0, m, n),
        rtol=1e-11,
        atol=1e-20,
    )


def test_poisson_ratio_is_complex_with_a_constant_bulk_modulus(rubber):
    # nu = (3K - 2 mu) / (2 (3K + mu)) at the complex mu of each order: C_rr of order (0, 0) in closed form.
    bulk, inner, outer = 8e6, 20e-3, 25e-3
    layer = vr.Layer(thickness=outer - inner, shear_modulus=rubber, bulk_modulus=bulk)
    ball = vr.CoatedSphere(core_radius=inner, layers=[layer])
    mu = rubber.complex_modulus(0.0)
    # u = A r + B / r^2 with u(r_i) = 0; sigma_rr = 3K A - 4 mu B / r^3.
    a, b = 1.0, -(inner**3)
    expected = (a * outer + b / outer**2) / (3 * bulk * a - 4 * mu * b / outer**3)
    # Compliances are small numbers in m/Pa, which the absolute tolerance of pytest.approx, 1e-12, would hide.
    assert vr.modal.surface_compliance(ball, 2.5, 0, 0)[0, 0] == pytest.approx(expected, rel=1e-12, abs=0.0)


def test_shapes_broadcast(paper_ball):
    assert vr.modal.surface_compliance(paper_ball, 2.5, 3, 4).shape == (3, 3)
    assert vr.modal.surface_compliance(paper_ball, 2.5, np.arange(4)[:, None], np.arange(5)).shape == (4, 5, 3, 3)
    assert vr.modal.surface_compliance(paper_ball, 2.5, np.zeros(0, int), 1).shape == (0, 3, 3)


@pytest.mark.parametrize("thickness", [1e-2, 0.3, 0.9])
@pytest.mark.parametrize("poisson_ratio", [0.0, 0.3, 0.5])
def test_hollow_ball_agrees_with_fifty_digits(thickness, poisson_ratio):
    layers = [(reference_layer(1.0 - thickness, 1.0, RUBBER, poisson_ratio, 0.0), RUBBER)]
    solid_core = ball_of(layers)
    ball = vr.CoatedSphere(
        core_radius=1.0 - thickness, layers=solid_core.layers, inner_boundary=enums.InnerBoundary.HOLLOW
    )
    for m, n in [(0, 1), (1, 0), (2, 1), (3, -5), (40, 7), (300, 300)]:
        expected = exact_compliance(layers, 2.5, m, n, enums.Curvature.SPHERE, hollow=True)
        compliance = vr.modal.surface_compliance(ball, 2.5, m, n)
        # A thin shell is far more compliant in bending than in stretching, and the ratio costs digits.
        assert np.abs(compliance - expected).max() < 1e-9 / thickness * np.abs(expected).max()
        if thickness * math.hypot(m, n) > 40.0:  # fields decay before they reach the inner surface
            np.testing.assert_allclose(compliance, vr.modal.surface_compliance(solid_core, 2.5, m, n), rtol=1e-12)


def regular_compliance(poisson_ratio, mu, m, n):
    """Return the compliance of a homogeneous solid ball of radius 1, from the three r^s with the largest exponents."""
    layer = vr.Layer(thickness=1.0, shear_modulus=vr.Elastic(modulus=mu), poisson_ratio=poisson_ratio)
    exponents, solutions = np.linalg.eig(vr.modal.state_matrix(layer, 1.0, 1.0, m, n))
    regular = solutions[:, np.argsort(exponents.real)[3:]]
    return regular[:3] @ np.linalg.inv(regular[3:])


@pytest.mark.parametrize("poisson_ratio", [0.0, 0.3, 0.5])
def test_solid_ball_keeps_the_regular_solutions(poisson_ratio):
    mu, radius = 2e6, 0.7
    layer = vr.Layer(thickness=radius, shear_modulus=vr.Elastic(modulus=mu), poisson_ratio=poisson_ratio)
    ball = vr.CoatedSphere(layers=[layer], inner_boundary=enums.InnerBoundary.SOLID)
    for m, n in [(0, 1), (1, 0), (1, 1), (2, 1), (3, -5), (40, 7)]:
        expected = radius * regular_compliance(poisson_ratio, mu, m, n)
        compliance = vr.modal.surface_compliance(ball, 1.0, m, n)
        np.testing.assert_allclose(compliance, expected, rtol=0.0, atol=1e-9 * np.abs(expected).max())
    # Order (0, 0): uniform expansion u_r = r sigma / 3K, and no mean rotation.
    bulk = 2.0 * mu * (1.0 + poisson_ratio) / (3.0 * (1.0 - 2.0 * poisson_ratio)) if poisson_ratio < 0.5 else np.inf
    np.testing.assert_allclose(
        vr.modal.surface_compliance(ball, 1.0, 0, 0), np.diag([radius / (3.0 * bulk), 0.0, 0.0]), rtol=1e-12, atol=1e-22
    )


def test_solid_ball_is_the_limit_of_small_cores():
    rubber = vr.materials.KelvinVoigt(modulus=1e6, viscosity=1e3)
    solid = vr.CoatedSphere(
        layers=[vr.Layer(thickness=20e-3, shear_modulus=rubber, poisson_ratio=0.3, density=1000.0)],
        inner_boundary=enums.InnerBoundary.SOLID,
    )
    core = vr.CoatedSphere(
        core_radius=2e-5,
        layers=[vr.Layer(thickness=20e-3 - 2e-5, shear_modulus=rubber, poisson_ratio=0.3, density=1000.0)],
    )
    m, n = np.array([5, 10, 0, 3]), np.array([0, 7, 4, 1])
    np.testing.assert_allclose(
        vr.modal.surface_compliance(solid, 5.0, m, n),
        vr.modal.surface_compliance(core, 5.0, m, n),
        rtol=1e-6,
        atol=1e-15,
    )
    swelling = vr.modal.centrifugal_displacement(core, 5.0)
    assert vr.modal.centrifugal_displacement(solid, 5.0) == pytest.approx(swelling, rel=1e-6, abs=0.0)
    assert vr.modal.critical_speed(solid) == vr.modal.critical_speed(core)
