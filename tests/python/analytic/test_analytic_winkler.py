"""The bed of viscoelastic springs, compared with independent integrals, its limits, and the solver on thin coatings."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import viscoroll as vr
from scipy import integrate, optimize
from viscoroll import analytic, enums

THICKNESS, MODULUS, TAU = 1e-3, 3e5, 0.01
RADIUS = 1.0
SHAPE = {"radius": RADIUS, "thickness": THICKNESS}


def close(expected, *, rel):
    return pytest.approx(expected, rel=rel, abs=0.0)


def solid(ratio):
    return vr.StandardLinearSolid(instantaneous_modulus=ratio * MODULUS, relaxed_modulus=MODULUS, relaxation_time=TAU)


def load_at(contact_radius, poisson_ratio):
    confined = 2.0 * MODULUS * (1.0 - poisson_ratio) / (1.0 - 2.0 * poisson_ratio)
    return np.pi * confined * contact_radius**4 / (4.0 * RADIUS * THICKNESS)


@pytest.mark.parametrize("speed", [0.05, 1.0, 20.0])
@pytest.mark.parametrize("bulk", [None, 2e6], ids=["one function", "elastic bulk"])
def test_against_the_memory_integral(speed, bulk):
    # Quadrature over the past gives the pressure, its root gives the end of a strip, and quadrature over the contact
    # gives load and torque. The second of the two relaxation times is long.
    weights, times, stiff, nu = np.array([0.3, 0.5]), np.array([TAU, 0.2]), 1e6, 0.25
    factor, stays = (2.0 * 0.75 / 0.5, 0.0) if bulk is None else (4.0 / 3.0, bulk)
    a0, velocity = 15e-3, speed * RADIUS

    def relaxation(t):
        return stays + factor * stiff * (1.0 - weights.sum() + weights @ np.exp(-t / times))

    def pressure(u, a):
        def part(s):
            return relaxation((u - s) / velocity) * (a - s) / (RADIUS * THICKNESS)

        edges = sorted({0.0, *(max(0.0, u - k * velocity * TAU) for k in (1.0, 5.0, 30.0)), u})
        return sum(integrate.quad(part, *ends, epsrel=1e-10)[0] for ends in pairwise(edges))

    def strip(z):
        a = np.sqrt(a0**2 - z**2)
        end = optimize.brentq(pressure, a, 2.0 * a, args=(a,), xtol=1e-12)
        nodes, dw = np.polynomial.legendre.leggauss(24)
        u, p = 0.5 * end * (1.0 + nodes), np.array([pressure(u, a) for u in 0.5 * end * (1.0 + nodes)])
        return 0.5 * end * np.array([dw @ p, dw @ ((a - u) * p)])

    nodes, weight = np.polynomial.legendre.leggauss(8)
    psi = 0.25 * np.pi * (1.0 + nodes)
    strips = np.array([strip(a0 * np.sin(angle)) for angle in psi])
    load, torque = 0.5 * np.pi * (weight * a0 * np.cos(psi)) @ strips
    material = vr.Prony(instantaneous_modulus=stiff, weights=weights, relaxation_times=times)
    given = {"poisson_ratio": nu} if bulk is None else {"bulk_modulus": bulk}
    found = analytic.winkler_torque(load=load, angular_speed=speed, shear_modulus=material, **SHAPE, **given)
    assert found == close(torque, rel=2e-6)


@pytest.mark.parametrize("material", [solid(2.0), vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=MODULUS * TAU)])
def test_slow_rolling(material):
    case = {"load": 20.0, "angular_speed": 1e-6}
    torque = analytic.winkler_torque(**case, **SHAPE, shear_modulus=material, poisson_ratio=0.3)
    assert torque == close(analytic.low_speed_torque(**case, radius=RADIUS, loss_time=TAU), rel=1e-5)


def test_fast_rolling_on_dashpots():
    # Dashpots support the load: p = c Omega x / h with c = 2 (1-nu)/(1-2nu) eta on the front half-disk, so that
    # P = c Omega 2 a^3 / (3h) and T = P (3 pi/16) a.
    viscosity, speed, load = 100.0, 1e5, 20.0
    material = vr.materials.KelvinVoigt(modulus=1e-3, viscosity=viscosity)
    a = np.cbrt(1.5 * load * THICKNESS / (3.5 * viscosity * speed))
    torque = analytic.winkler_torque(load=load, angular_speed=speed, **SHAPE, shear_modulus=material, poisson_ratio=0.3)
    assert torque == close(3.0 * np.pi / 16.0 * load * a, rel=1e-6)


def test_no_loss_no_torque():
    spring = vr.Elastic(modulus=MODULUS)
    torque = analytic.winkler_torque(load=20.0, angular_speed=1.0, **SHAPE, shear_modulus=spring, poisson_ratio=0.3)
    assert abs(torque) < 1e-12 * 20.0 * RADIUS


@pytest.mark.parametrize(
    ("slenderness", "poisson_ratio", "path", "ratio", "tolerance"),
    [
        (20, 0.2, 0.1, 2.0, 1e-3),
        (20, 0.2, 1.0, 2.0, 1e-3),
        (20, 0.3, 1.0, 2.0, 1e-3),
        (3, 0.3, 0.3, 2.0, 0.006),
        (10, 0.45, 1.0, 2.0, 0.013),
        (10, 0.45, 0.3, 10.0, 0.026),
    ],
)
def test_solver_on_a_thin_coating(slenderness, poisson_ratio, path, ratio, tolerance):
    # With a/R = 0.02 and 50 nodes per contact radius, the mesh has an error of 2e-4. Larger tolerances are errors of
    # the closed form, which its docstring states.
    a = 1.001 * slenderness * THICKNESS
    radius, material = a / 0.02, solid(ratio)
    load = load_at(a, poisson_ratio) * RADIUS / radius
    speed = path * a / (radius * TAU)
    layer = vr.Layer(thickness=THICKNESS, shear_modulus=material, poisson_ratio=poisson_ratio)
    ball = vr.CoatedSphere(core_radius=radius - THICKNESS, layers=[layer])
    mesh = vr.Mesh(nodes_per_revolution=2 * round(50 * np.pi * 50))
    r = vr.solve(ball, load=load, angular_speed=speed, mesh=mesh, compliance=enums.Compliance.RADIAL)
    form = analytic.applicable(ball)["winkler"]
    assert r.resisting_torque == close(form(load, speed), rel=tolerance)
    assert form.is_valid(load, speed) == (slenderness >= 5)


def test_range_of_validity():
    layer = vr.Layer(thickness=THICKNESS, shear_modulus=solid(2.0), poisson_ratio=0.45)
    form = analytic.applicable(vr.CoatedSphere(core_radius=RADIUS - THICKNESS, layers=[layer]))["winkler"]
    loads = load_at(np.array([9.0, 11.0, 190.0, 210.0]) * THICKNESS, 0.45)
    assert form.is_valid(loads, 1.0).tolist() == [False, True, True, False]
    assert form.is_valid(loads[1], np.array([60.0, 70.0])).tolist() == [True, False]
    assert form(loads, 1.0).shape == (4,)
    free = vr.CoatedSphere(core_radius=RADIUS, layers=[layer], inner_boundary=enums.InnerBoundary.HOLLOW)
    assert "winkler" not in analytic.applicable(free)


VALID = {"load": 1.0, "angular_speed": 1.0, "shear_modulus": solid(2.0), "poisson_ratio": 0.3} | SHAPE


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"poisson_ratio": 0.5}, ValueError, r"poisson_ratio must be in \(-1, 0.5\), got 0.5"),
        ({"bulk_modulus": 1e6}, ValueError, "poisson_ratio or bulk_modulus must be given, and not both, got both"),
        ({"load": -1.0}, ValueError, "load must be > 0 N, got -1"),
        ({"thickness": 0.0}, ValueError, "thickness must be > 0 m, got 0"),
        ({"shear_modulus": 3e6}, TypeError, "shear_modulus must be a viscoroll.materials.ShearModulus, got 3000000.0"),
        (
            {"shear_modulus": vr.MasterCurve([1.0, 2.0], [1.0, 1.0], [0.1, 0.1])},
            ValueError,
            "whose relaxation function is a sum of exponentials, got MasterCurve",
        ),
    ],
)
def test_bad_arguments(changes, error, message):
    with pytest.raises(error, match=message):
        analytic.winkler_torque(**VALID | changes)
