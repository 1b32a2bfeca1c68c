"""The exact sphere: single harmonics, Hertz on a solid ball, low speeds, the power balance, thin and thick coatings."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
import viscoroll as vr
from viscoroll import enums, paper

EXACT = enums.Curvature.EXACT
RADIAL = enums.Compliance.RADIAL
OUTER = 21e-3


def elastic_ball(thickness, *, modulus=1.0, poisson_ratio=0.5, radius=1.0, inner_boundary=enums.InnerBoundary.RIGID):
    layer = vr.Layer(
        thickness=thickness, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=poisson_ratio, density=0.0
    )
    core = 0.0 if inner_boundary is enums.InnerBoundary.SOLID else radius - thickness
    return vr.CoatedSphere(core_radius=core, layers=[layer], inner_boundary=inner_boundary)


def paper_ball(thickness):
    return paper.ball(thickness=thickness, core_radius=OUTER - thickness, density=0.0)


def incompressible_solutions(degree):
    """Return solutions u Y + v Psi of an incompressible layer, mu = 1: (s, u, v, s_rr, s_rv) at r = 1 for each r^s.

    The potentials u = grad(r^l Y) and grad(r^(-l-1) Y) have no pressure. The solutions of the pressure p = r^l Y or
    r^(-l-1) Y are u = a r^(s) Y + b r^(s) sqrt(L) Psi with div u = 0 and laplace(u) = grad p (H. Lamb, Hydrodynamics,
    art. 335).
    """
    root = mpmath.sqrt(degree * (degree + 1))

    def stress(s, u, v, pressure):
        # s_rr = -p + 2 u', s_rv = v' - v / r + sqrt(L) u / r
        return s, u, v, -pressure + 2 * s * u, (s - 1) * v + root * u

    solutions = []
    for power in (mpmath.mpf(degree), mpmath.mpf(-degree - 1)):
        # The gradient of r^power Y has the exponent power - 1.
        solutions.append(stress(power - 1, power, root, mpmath.mpf(0)))
        # The product of x and laplace(u) = grad p is laplace(x . u) = x . grad p + 2 div u = power p, which
        # x . u = c r^(power + 2) Y solves.
        c = power / ((power + 2) * (power + 3) - degree * (degree + 1))
        # From div u = 0 follows (s + 2) u = sqrt(L) v, with s = power + 1.
        solutions.append(stress(power + 1, c, (power + 3) * c / root, mpmath.mpf(1)))
    return solutions


def closed_compliance(degree, core):
    """Return the spheroidal and toroidal compliance of an incompressible layer on a rigid core; mu = r_o = 1."""
    with mpmath.workdps(60 + int(2 * degree * -math.log10(core))):
        core = mpmath.mpf(core)
        solutions = incompressible_solutions(degree)
        fixed = mpmath.matrix([[core**s * value for s, *values in solutions for value in (values[i],)] for i in (0, 1)])
        surface = mpmath.matrix([[values[i] for _, *values in solutions] for i in range(4)])
        system = mpmath.matrix(4, 4)
        system[:2, :] = fixed
        system[2:, :] = surface[2:, :]
        result = np.zeros((3, 3))
        for column in (0, 1):
            load = mpmath.matrix([0, 0, 0, 0])
            load[2 + column] = 1
            moved = surface * mpmath.lu_solve(system, load)
            result[:2, column] = float(moved[0]), float(moved[1])
        # The toroidal displacement is w = r^l - c r^(-l-1), and its stress at r = 1 is w' - w.
        c = core ** (2 * degree + 1)
        result[2, 2] = float((1 - c) / (degree - 1 + c * (degree + 2)))
        return result


@pytest.mark.parametrize("core", [0.001, 0.2, 0.5, 0.95])
@pytest.mark.parametrize("degree", [1, 2, 3, 10, 77, 400])
def test_degrees_agree_with_the_closed_solutions(degree, core):
    c = vr.modal.degree_compliance(elastic_ball(1.0 - core), 1.0, degree, min(degree, 3))
    expected = closed_compliance(degree, core)
    size = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    assert np.abs(c - expected).max() <= 1e-9 * size.max()
    assert (np.abs(c - expected) <= 1e-9 * size + 1e-14 * np.abs(expected).max()).all()


def test_frequency_depends_on_the_order_and_not_on_the_degree(rubber):
    layer = vr.Layer(thickness=0.3, shear_modulus=rubber, poisson_ratio=0.4)
    ball = vr.CoatedSphere(core_radius=0.7, layers=[layer])
    order = np.arange(-5, 6)
    c = vr.modal.degree_compliance(ball, 2.5, 5, order)
    modulus = rubber.complex_modulus(2.5 * np.abs(order))
    modulus = np.where(order < 0, modulus.conj(), modulus)
    expected = vr.modal.degree_compliance(elastic_ball(0.3, poisson_ratio=0.4), 2.5, 5, 0) / modulus[:, None, None]
    np.testing.assert_allclose(c, expected, rtol=1e-12, atol=1e-25)


@pytest.mark.parametrize("poisson_ratio", [0.0, 0.3, 0.45])
def test_degree_one_of_a_solid_ball_is_the_limit_of_slow_vibration(poisson_ratio):
    """Compare with a free ball under slow harmonic surface loads, whose rigid motion is subtracted."""

    def vibration(omega2, load):
        # The displacement is a sum of grad(j1(alpha r) Y) and curl curl(x j1(beta r) Y), with mu = rho = 1.
        confined = mpmath.mpf(2 * (1 - poisson_ratio)) / (1 - 2 * poisson_ratio)
        alpha, beta = mpmath.sqrt(omega2 / confined), mpmath.sqrt(omega2)
        root = mpmath.sqrt(2)

        def j1(x):
            return mpmath.sin(x) / x**2 - mpmath.cos(x) / x

        def longitudinal(r):
            return mpmath.diff(lambda s: j1(alpha * s), r), root * j1(alpha * r) / r

        def transverse(r):
            return 2 * j1(beta * r) / r, root * mpmath.diff(lambda s: s * j1(beta * s), r) / r

        columns = []
        for field in (longitudinal, transverse):
            u, v = field(mpmath.mpf(1))
            du, dv = (mpmath.diff(lambda r, i=i, field=field: field(r)[i], mpmath.mpf(1)) for i in (0, 1))
            dilation = du + 2 * u - root * v
            columns.append((u, v, (confined - 2) * dilation + 2 * du, dv - v + root * u))
        system = mpmath.matrix([[column[2] for column in columns], [column[3] for column in columns]])
        amount = mpmath.lu_solve(system, mpmath.matrix(load))
        return [sum(a * column[i] for a, column in zip(amount, columns, strict=True)) for i in (0, 1)]

    with mpmath.workdps(40):
        omega2 = mpmath.mpf("1e-9")
        expected = np.zeros((2, 2))
        for column, load in enumerate(([1, 0], [0, 1])):
            # The rigid motion is (1, sqrt(2)). Its amplitude is the projected force s + sqrt(2) tau per projected
            # mass; the latter is 1/3 of the square of (1, sqrt(2)), because the mass is 4 pi / 3.
            rigid = -(load[0] + mpmath.sqrt(2) * load[1]) / omega2
            moved = vibration(omega2, load)
            expected[:, column] = float(moved[0] - rigid), float(moved[1] - mpmath.sqrt(2) * rigid)
    ball = elastic_ball(1.0, poisson_ratio=poisson_ratio, inner_boundary=enums.InnerBoundary.SOLID)
    c = vr.modal.degree_compliance(ball, 1.0, 1, 0)
    np.testing.assert_allclose(c[:2, :2], expected, rtol=0.0, atol=1e-8 * np.abs(expected).max())


@pytest.mark.parametrize("inner_boundary", enums.InnerBoundary)
def test_every_degree_is_passive(rubber, inner_boundary):
    degree = np.arange(1, 30)
    for thickness in (1e-3, 0.1, 0.5, 0.9, 0.999):
        solid = inner_boundary is enums.InnerBoundary.SOLID
        layer = vr.Layer(thickness=1.0 if solid else thickness, shear_modulus=rubber, poisson_ratio=0.3)
        ball = vr.CoatedSphere(
            core_radius=0.0 if solid else 1.0 - thickness, layers=[layer], inner_boundary=inner_boundary
        )
        c = vr.modal.degree_compliance(ball, 2.5, degree, np.minimum(degree, 4))
        np.testing.assert_allclose(c, c.transpose(0, 2, 1), rtol=1e-9, atol=1e-20)
        stored = np.linalg.eigvalsh(c.real)
        assert (stored >= -1e-9 * stored[:, -1:]).all()
        assert (np.linalg.eigvalsh(-c.imag) >= -1e-9 * stored[:, -1:]).all()


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.5])
def test_hertz_on_a_solid_ball(poisson_ratio):
    """The penetration differs from Hertz's in proportion to a / R: the center moves less than a point at infinity."""
    radius, modulus = 20e-3, 1e6
    ball = elastic_ball(
        radius, modulus=modulus, poisson_ratio=poisson_ratio, radius=radius, inner_boundary=enums.InnerBoundary.SOLID
    )
    shares, penetrations = [0.1, 0.05, 0.025], []
    for share in shares:
        a = share * radius
        load = 8.0 / 3.0 * modulus / (1.0 - poisson_ratio) * a**3 / radius
        mesh = vr.Mesh(nodes_per_revolution=round(2.0 * np.pi / share * 20))
        r = vr.solve(ball, load=load, angular_speed=1.0, mesh=mesh, compliance=RADIAL, curvature=EXACT)
        penetrations.append(r.penetration / (a**2 / radius))
        assert r.semi_axis_x == pytest.approx(a, rel=1e-2)  # a fifth of a spacing
        assert r.max_pressure == pytest.approx(1.5 * load / (np.pi * a**2), rel=0.5 * share**2 + 5e-3)
        assert abs(r.resisting_torque) < 1e-9 * load * a
    assert penetrations[0] < penetrations[1] < penetrations[2] < 1.0
    # The influence function of a compressible sphere is singular like 1/r, as for a half-space, plus a logarithm:
    # E. Sternberg and F. Rosenthal, J. Appl. Mech. 19 (1952) 413-421.
    s = np.array(shares)
    limit = np.linalg.solve(np.stack([s**0, s, s * np.log(s)], axis=1), penetrations)[0]
    assert limit == pytest.approx(1.0, abs=1e-3)


def roll(ball, curvature, **options):
    return vr.solve(ball, load=100.0, angular_speed=2.5, curvature=curvature, **options)


#: Errors of PAPER and SPHERE relative to the exact sphere [%], torque and penetration, by thickness / outer radius.
ERRORS = {
    0.05: ((-0.07, -0.03), (-0.02, 0.01)),
    0.2: ((-0.62, -0.43), (-0.17, 0.06)),
    0.5: ((-2.80, -3.39), (-0.79, -0.45)),
    0.8: ((-10.51, -19.0), (-6.02, -11.1)),
}


@pytest.mark.parametrize("share", ERRORS)
def test_errors_of_the_approximate_curvatures(share):
    ball = paper_ball(share * OUTER)
    mesh = vr.Mesh(nodes_per_revolution=800)
    exact = roll(ball, EXACT, mesh=mesh, compliance=RADIAL)
    for curvature, (torque, penetration) in zip(
        (enums.Curvature.PAPER, enums.Curvature.SPHERE), ERRORS[share], strict=True
    ):
        r = roll(ball, curvature, mesh=mesh, compliance=RADIAL)
        assert 100.0 * (r.resisting_torque / exact.resisting_torque - 1.0) == pytest.approx(torque, abs=0.06)
        assert 100.0 * (r.penetration / exact.penetration - 1.0) == pytest.approx(penetration, abs=0.06)


@pytest.mark.parametrize("compliance", enums.Compliance)
@pytest.mark.parametrize("patch_load", enums.PatchLoad)
@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_power_balance(compliance, patch_load, friction):
    """The dissipated power, an independent sum over degrees and orders, converges to the work done."""
    errors = []
    for nodes in (200, 400):
        mesh = vr.Mesh(nodes_per_revolution=nodes)
        options = {"compliance": compliance, "patch_load": patch_load, "friction": friction}
        r = roll(paper_ball(10e-3), EXACT, mesh=mesh, **options)
        assert r.residual < 1e-8
        errors.append(r.energy_balance_error)
    assert errors[0] < 8e-3
    assert errors[1] < 2e-3


def test_low_speed():
    """T -> P Omega r_o sum g tau / g_inf for any thickness; the remaining difference decreases with the speed."""
    ball, time = paper_ball(0.7 * OUTER), 0.125
    ratios, shifts = [], [0.5, 1.0, 1.5]
    nodes = 300
    for shift in shifts:
        speed = shift * 2.0 * np.pi / nodes / time
        mesh = vr.Mesh(nodes_per_revolution=nodes)
        r = vr.solve(ball, load=100.0, angular_speed=speed, mesh=mesh, compliance=RADIAL, curvature=EXACT)
        ratios.append(r.resisting_torque / (100.0 * speed * OUTER * time))
    assert np.polynomial.Polynomial.fit(shifts, ratios, 2)(0.0) == pytest.approx(1.0, abs=0.02)


def test_truncated_sums_converge_to_the_sum_of_all_degrees():
    ball = paper_ball(8e-3)
    whole = roll(ball, EXACT, mesh=vr.Mesh(nodes_per_revolution=200), compliance=RADIAL)
    cut = roll(ball, EXACT, mesh=vr.Mesh(nodes_per_revolution=200, max_order=600), compliance=RADIAL)
    assert cut.resisting_torque == pytest.approx(whole.resisting_torque, rel=3e-3)
    assert cut.penetration == pytest.approx(whole.penetration, rel=1e-3)


def test_inertia_that_is_not_negligible_is_rejected():
    ball = paper.ball(thickness=5e-3)
    mesh = vr.Mesh(nodes_per_revolution=100)
    slow = vr.solve(ball, load=50.0, angular_speed=2.5, mesh=mesh, curvature=EXACT)
    without = vr.solve(
        paper.ball(thickness=5e-3, density=0.0), load=50.0, angular_speed=2.5, mesh=mesh, curvature=EXACT
    )
    assert slow.resisting_torque == pytest.approx(without.resisting_torque, rel=1e-6)
    with pytest.raises(ValueError, match=r"layers\[0\].density must be so small that inertia is negligible"):
        vr.solve(ball, load=50.0, angular_speed=500.0, mesh=mesh, curvature=EXACT)


def test_bad_orders_and_degrees_are_rejected(paper_ball):
    with pytest.raises(ValueError, match="curvature must be SPHERE or PAPER"):
        vr.modal.surface_compliance(paper_ball, 2.5, 1, 2, curvature=EXACT)
    with pytest.raises(ValueError, match="order must be at most the degree 2 in magnitude, got 3"):
        vr.modal.degree_compliance(paper_ball, 2.5, 2, 3)
    with pytest.raises(ValueError, match=r"degree must be in \[0, 1000000\], got -1"):
        vr.modal.degree_compliance(paper_ball, 2.5, -1, 0)


@pytest.mark.parametrize("compliance", enums.Compliance)
@pytest.mark.parametrize("angular_speed", [1.0, 4.0])
def test_strong_memory_of_a_thin_coating(compliance, angular_speed):
    """Compare with the curvature SPHERE, from which a thin coating differs little; displacements decay slowly."""
    layer = vr.Layer(
        thickness=1e-3, shear_modulus=vr.materials.KelvinVoigt(modulus=3e6, viscosity=3e4), poisson_ratio=0.5
    )
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    case = {"load": 50.0, "angular_speed": angular_speed, "mesh": vr.Mesh(nodes_per_revolution=800)}
    exact, torus = (vr.solve(ball, compliance=compliance, curvature=c, **case) for c in (EXACT, enums.Curvature.SPHERE))
    assert exact.driving_torque == pytest.approx(torus.driving_torque, rel=1e-3)
    assert exact.penetration == pytest.approx(torus.penetration, rel=1e-3)
    assert exact.energy_balance_error < torus.energy_balance_error + 1e-3


def test_shell_that_rests_on_the_rim_of_a_dent():
    # About twenty nodes around the dent support the load, and each bends the whole shell. The iterative solver once
    # kept 120 search directions, which were not enough.
    material = vr.Prony(
        instantaneous_modulus=3.609e8, weights=[0.3147, 0.68495], relaxation_times=[0.03267702, 0.04400252]
    )
    shell = vr.CoatedSphere(
        core_radius=0.43003391,
        layers=[vr.Layer(thickness=0.02071857, shear_modulus=material, poisson_ratio=-0.66079)],
        inner_boundary=enums.InnerBoundary.HOLLOW,
    )
    mesh = vr.Mesh(nodes_per_revolution=502, max_order=345)
    r = vr.solve(shell, load=21.228, angular_speed=9.4e-3, mesh=mesh, curvature=EXACT)
    assert r.status is enums.Status.CONVERGED
    assert not r.contact[r.contact.shape[0] // 2, r.contact.shape[1] // 2]
    assert (r.pressure * r.body.outer_radius**2 * (2 * math.pi / 502) ** 2).sum() == pytest.approx(21.228, rel=2e-2)


def rolled_exactly(ball, on, *, load=10.0, nodes=600, **options):
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    return vr.solve(ball, on=on, load=load, angular_speed=2.5, mesh=mesh, curvature=EXACT, threads=1, **options)


@pytest.mark.parametrize("thickness", [1e-3, 10e-3])
def test_exact_ball_on_a_deformable_plane(thickness):
    """The compliances add; on a nearly rigid plane, only the positions of the nodes differ, by (a/R)² = 1e-2."""
    ball = paper_ball(thickness)
    bare = rolled_exactly(ball, None)
    stiff = vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=1e14), poisson_ratio=0.3)
    hard = rolled_exactly(ball, vr.CoatedPlane(layers=[stiff]))
    assert hard.resisting_torque == pytest.approx(bare.resisting_torque, rel=2e-3)
    assert hard.penetration == pytest.approx(bare.penetration, rel=1e-3)
    pair = rolled_exactly(ball, ball)
    assert pair.resisting_torque == pytest.approx(hard.resisting_torque, rel=1e-6)
    assert pair.penetration == pytest.approx(2.0 * hard.penetration, rel=1e-6)
    assert pair.counterbody_bulk_power == pytest.approx(pair.rolling_bulk_power, rel=1e-9)
    mat = vr.CoatedPlane(layers=paper.ball().layers)
    soft = rolled_exactly(ball, mat, nodes=1200)
    assert soft.driving_torque * 2.5 == pytest.approx(soft.rolling_bulk_power, rel=5e-3)  # error of the mesh
    assert soft.driving_force * 2.5 * OUTER == pytest.approx(soft.counterbody_bulk_power, rel=5e-3)
    rubbing = rolled_exactly(ball, mat, nodes=1200, friction=0.3)
    assert rubbing.slip_power > 0.0
    assert rubbing.energy_balance_error < 5e-3


def test_exchanged_exact_balls_have_the_same_results():
    ball, small = paper_ball(5e-3), paper.ball(thickness=5e-3, core_radius=8e-3, density=0.0)
    first = rolled_exactly(ball, small, nodes=840)
    other = vr.solve(
        small,
        on=ball,
        load=10.0,
        angular_speed=2.5 * 21.0 / 13.0,
        mesh=vr.Mesh(nodes_per_revolution=520),
        curvature=EXACT,
        threads=1,
    )
    for name in ("penetration", "resisting_torque"):
        assert getattr(first, name) == pytest.approx(getattr(other, name), rel=1e-5), name
    assert first.rolling_bulk_power == pytest.approx(other.counterbody_bulk_power, rel=1e-5)
    assert first.counterbody_bulk_power == pytest.approx(other.rolling_bulk_power, rel=1e-5)


def test_two_solid_balls_are_hertzian():
    solid = {"inner_boundary": enums.InnerBoundary.SOLID, "poisson_ratio": 0.3}
    first = elastic_ball(20e-3, modulus=5e6, radius=20e-3, **solid)
    other = elastic_ball(50e-3, modulus=2e6, radius=50e-3, **solid)
    radius = 1.0 / (1.0 / 20e-3 + 1.0 / 50e-3)
    modulus = 1.0 / (0.7 / (2.0 * 5e6) + 0.7 / (2.0 * 2e6))
    a = 0.4e-3
    load = 4.0 / 3.0 * modulus * a**3 / radius
    r = rolled_exactly(first, other, load=load, nodes=round(40 * math.pi * 20e-3 / a))
    second_moment = (r.pressure * r.x**2).sum() / r.pressure.sum()
    assert math.sqrt(5.0 * second_moment) == pytest.approx(a, rel=2e-3)
    # The approach of each ball is smaller than Hertz's by a relative amount of a/R = 1/50: see the docstring of hertz.
    assert r.penetration == pytest.approx(a**2 / radius, rel=2e-2)
