"""Closed forms of the torque, compared with quadrature, the correspondence principle, and limits of the solver."""

from __future__ import annotations

import inspect
import math
from itertools import pairwise

import mpmath
import numpy as np
import pytest
import viscoroll as vr
from hypothesis import given, settings
from hypothesis import strategies as st
from reference.bonded_layer import bonded_layer
from scipy import integrate, optimize, special
from viscoroll import analytic, enums, paper

RADIUS = 20e-3
MODULUS = 3e6
TAU = 0.01
ELASTIC = {"radius": RADIUS, "shear_modulus": MODULUS}


def close(expected, *, rel):
    """Return a relative comparison, without the absolute tolerance of pytest.approx, which exceeds small torques."""
    return pytest.approx(expected, rel=rel, abs=0.0)


def nearly_solid(**material):
    """Return a ball of radius RADIUS whose core has a thousandth of it."""
    layer = vr.Layer(thickness=0.999 * RADIUS, **material)
    return vr.CoatedSphere(core_radius=1e-3 * RADIUS, layers=[layer])


def roll(ball, *, load, angular_speed=1.0, nodes=800, order=None):
    mesh = vr.Mesh(nodes_per_revolution=nodes, max_order=order or 3 * nodes // 2)
    # With PAPER, the pressure is closer to that of a half-space: at a/R = 0.2, its peak is 0.4 % below Hertz's, and
    # with SPHERE 1.3 %.
    return vr.solve(ball, load=load, angular_speed=angular_speed, mesh=mesh, curvature=enums.Curvature.PAPER)


def hertz_load(contact_radius, poisson_ratio):
    return 8.0 * MODULUS * contact_radius**3 / (3.0 * (1.0 - poisson_ratio) * RADIUS)


def standard_linear_solid(ratio):
    return vr.StandardLinearSolid(instantaneous_modulus=ratio * MODULUS, relaxed_modulus=MODULUS, relaxation_time=TAU)


def bulk_modulus(poisson_ratio):
    return 2.0 * MODULUS * (1.0 + poisson_ratio) / (3.0 * (1.0 - 2.0 * poisson_ratio))


LOSS_TIMES = [
    (vr.Elastic(modulus=3e6), 0.0),
    (vr.materials.KelvinVoigt(modulus=2e6, viscosity=1e3), 5e-4),
    (vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=2e6, relaxation_time=0.125), 0.25),
    (vr.Prony(instantaneous_modulus=6e6, weights=[0.3, 0.5], relaxation_times=[1e-6, 1e3]), (0.3e-6 + 500.0) / 0.2),
    (
        vr.materials.FractionalZener(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=1.0),
        0.125,
    ),
    (lambda omega: 5.0 * np.exp(0.03j * omega), 0.03),
]


@pytest.mark.parametrize(("modulus", "expected"), LOSS_TIMES)
def test_loss_time(modulus, expected):
    assert analytic.loss_time(modulus) == close(expected, rel=1e-9)


@pytest.mark.parametrize(
    ("modulus", "message"),
    [
        (
            vr.materials.FractionalZener(
                instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=0.9
            ),
            r"^shear_modulus must have a loss modulus proportional to frequency near 0 rad/s, got .* s at 1e-12 rad/s",
        ),
        (vr.MasterCurve([0.0, 1.0, 9.0], [1.0, 1.0, 2.0], [0.0, 0.1, 0.1]), "within the master curve's table"),
        (
            vr.MasterCurve([1.0, 9.0], [1.0, 2.0], [0.1, 0.1], extrapolation=enums.Extrapolation.HOLD),
            "shear_modulus must have a loss modulus proportional to frequency",
        ),
    ],
)
def test_materials_without_a_loss_time(modulus, message):
    with pytest.raises(ValueError, match=message):
        analytic.loss_time(modulus)


@settings(max_examples=100, deadline=None)
@given(
    poisson_ratio=st.floats(-0.9, 0.499),
    shear_viscosity=st.floats(1.0, 1e6),
    bulk_viscosity=st.floats(0.0, 1e6),
)
def test_sphere_loss_time_by_correspondence(poisson_ratio, shear_viscosity, bulk_viscosity):
    # By the correspondence principle, the compliance of a half-space is (1-nu^2)/Y with complex Young's modulus Y and
    # Poisson's ratio. With 60 digits, the term of first order in omega = 1e-30 is accurate to 1e-20.
    with mpmath.workdps(60):
        omega = mpmath.mpf("1e-30")
        g = MODULUS + 1j * omega * shear_viscosity
        nu = mpmath.mpf(poisson_ratio)
        k = 2 * MODULUS * (1 + nu) / (3 * (1 - 2 * nu)) + 1j * omega * bulk_viscosity
        young, ratio = 9 * k * g / (3 * k + g), (3 * k - 2 * g) / (6 * k + 2 * g)
        expected = -mpmath.arg((1 - ratio**2) / young) / omega
    time = analytic.sphere_loss_time(
        shear_modulus=MODULUS,
        poisson_ratio=poisson_ratio,
        shear_viscosity=shear_viscosity,
        bulk_viscosity=bulk_viscosity,
    )
    assert time == close(float(expected), rel=1e-12)


@pytest.mark.parametrize(("poisson_ratio", "printed_over_right"), [(0.1, 17.8), (0.3, 0.689), (0.4, 0.148)])
def test_short_waves_on_a_solid_ball_lag_by_the_sphere_loss_time(poisson_ratio, printed_over_right):
    # At order m, the solver's compliance differs from that of a half-space by a relative amount of order 1/m: 6e-5 at
    # m = 10000, which is small enough to distinguish the two coefficients.
    kelvin_voigt = vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=3e4)
    ball = nearly_solid(shear_modulus=kelvin_voigt, bulk_modulus=bulk_modulus(poisson_ratio))
    constants = {"shear_modulus": MODULUS, "poisson_ratio": poisson_ratio, "shear_viscosity": 3e4}
    compliance = vr.modal.surface_compliance(ball, 1e-8, 10_000, 0)[0, 0]
    lag = -compliance.imag / compliance.real / (10_000 * 1e-8)
    assert lag == close(analytic.sphere_loss_time(**constants), rel=1e-4)
    assert analytic.brilliantov_poschel_time(**constants) / lag == close(printed_over_right, rel=2e-3)


@settings(deadline=None)
@given(poisson_ratio=st.floats(0.01, 0.499), time=st.floats(1e-6, 1.0))
def test_both_coefficients_agree_if_bulk_and_shear_have_the_same_loss_time(poisson_ratio, time):
    constants = {
        "shear_modulus": MODULUS,
        "poisson_ratio": poisson_ratio,
        "shear_viscosity": MODULUS * time,
        "bulk_viscosity": bulk_modulus(poisson_ratio) * time,
    }
    assert analytic.sphere_loss_time(**constants) == close(time, rel=1e-12)
    # 1 - 2 nu loses up to three digits, here and in K.
    assert analytic.brilliantov_poschel_time(**constants) == close(time, rel=1e-10)


def test_defects_of_the_coefficient_of_1998():
    def times(**constants):
        constants = {"shear_modulus": MODULUS, "shear_viscosity": 3e4} | constants
        return analytic.brilliantov_poschel_time(**constants), analytic.sphere_loss_time(**constants)

    assert times(poisson_ratio=0.5) == (0.0, pytest.approx(0.01))
    assert times(poisson_ratio=0.3, bulk_viscosity=2e4)[0] == 0.0
    assert times(poisson_ratio=1e-3)[0] > 1e4 * times(poisson_ratio=1e-3)[1]


def test_all_orders_of_layers_with_the_same_loss_time_have_it():
    # The layers differ in relaxation function, modulus and Poisson's ratio, but not in their loss time.
    layers = [
        vr.Layer(thickness=3e-3, shear_modulus=standard_linear_solid(3.0), poisson_ratio=0.3),
        vr.Layer(thickness=1e-3, shear_modulus=vr.materials.KelvinVoigt(modulus=1e5, viscosity=2e3), poisson_ratio=0.5),
    ]
    ball = vr.CoatedSphere(core_radius=RADIUS, layers=layers)
    m = np.array([1, 20, 300])
    compliance = vr.modal.surface_compliance(ball, 1e-6, m, np.array([0, 5, 200]))[:, 0, 0]
    np.testing.assert_allclose(-compliance.imag / compliance.real / (m * 1e-6), 2.0 * TAU, rtol=1e-7)
    assert [analytic.loss_time(layer.shear_modulus) for layer in layers] == pytest.approx([2.0 * TAU] * 2)


def limit_at_low_speed(ball, time, *, load, shifts, **mesh):
    """Return the torque relative to P Omega r_o t, extrapolated to zero speed.

    `shifts` are the distances [node spacings] that the surface travels in the loss time.
    """
    ratios = []
    for shift in shifts:
        speed = shift * 2.0 * np.pi / mesh["nodes"] / time
        torque = analytic.low_speed_torque(load=load, angular_speed=speed, radius=ball.outer_radius, loss_time=time)
        ratios.append(roll(ball, load=load, angular_speed=speed, **mesh).resisting_torque / torque)
    assert ratios[0] > ratios[1] > ratios[2]
    return np.polynomial.Polynomial.fit(shifts, ratios, 2)(0.0)


def test_solver_on_a_thick_and_a_thin_kelvin_voigt_coating():
    # There are 10 and 13 nodes per contact radius. The pressure has a step at the trailing edge, which the surface must
    # cross by several nodes in the loss time. Extrapolation from such large shifts has an error of 1 %.
    kelvin_voigt = vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=MODULUS * TAU)
    solid = nearly_solid(shear_modulus=kelvin_voigt, poisson_ratio=0.5)
    limit = limit_at_low_speed(solid, TAU, load=hertz_load(2e-3, 0.5), shifts=[2.0, 4.0, 8.0], nodes=800)
    assert limit == pytest.approx(1.0, abs=0.02)
    coating = vr.Layer(thickness=1e-3, shear_modulus=kelvin_voigt, poisson_ratio=0.3)
    coated = vr.CoatedSphere(core_radius=RADIUS - 1e-3, layers=[coating])
    limit = limit_at_low_speed(coated, TAU, load=20.0, shifts=[2.0, 4.0, 8.0], nodes=500)
    assert limit == pytest.approx(1.0, abs=0.02)


def test_solver_on_a_solid_ball_with_an_elastic_bulk():
    # With nu = 0.4 at rest, the coefficient of 1998 would give 6.7. The mesh has 13 nodes per contact radius.
    time = analytic.sphere_loss_time(shear_modulus=MODULUS, poisson_ratio=0.4, shear_viscosity=MODULUS * TAU)
    kelvin_voigt = vr.materials.KelvinVoigt(modulus=MODULUS, viscosity=MODULUS * TAU)
    ball = nearly_solid(shear_modulus=kelvin_voigt, bulk_modulus=bulk_modulus(0.4))
    limit = limit_at_low_speed(ball, time, load=hertz_load(4e-3, 0.4), shifts=[1.0, 2.0, 4.0], nodes=400, order=200)
    assert limit == pytest.approx(1.0, abs=0.02)


def test_greenwood_tabor_is_equation_64_of_the_paper():
    torque = analytic.greenwood_tabor_torque(load=70.0, radius=0.02, shear_modulus=2e6, poisson_ratio=0.3)
    assert torque == close((3**4 * 0.7 * 0.02 * 70.0**4 / (2**15 * 2e6)) ** (1 / 3), rel=1e-12)
    half = analytic.greenwood_tabor_torque(
        load=70.0, radius=0.02, shear_modulus=2e6, poisson_ratio=0.3, loss_fraction=0.5
    )
    assert half == close(0.5 * torque, rel=1e-15)


def test_greenwood_tabor_is_the_moment_of_the_front_half():
    contact = analytic.hertz(load=100.0, poisson_ratio=0.3, **ELASTIC)
    moment, _ = integrate.dblquad(
        lambda r, phi: contact.pressure(r) * r**2 * np.cos(phi), -np.pi / 2, np.pi / 2, 0.0, contact.radius
    )
    assert analytic.greenwood_tabor_torque(load=100.0, poisson_ratio=0.3, **ELASTIC) == close(moment, rel=1e-8)


def persson(modulus, *, load, angular_speed, **changes):
    arguments = {"radius": RADIUS, "shear_modulus": modulus, "poisson_ratio": 0.5} | changes
    return analytic.persson_torque(load=load, angular_speed=angular_speed, **arguments)


@pytest.mark.parametrize("speed", [1.0, 1e3])
@pytest.mark.parametrize("bulk", [math.inf, bulk_modulus(0.1)], ids=["incompressible", "elastic bulk"])
def test_persson_by_direct_quadrature(speed, bulk):
    # Integrate in polar coordinates up to x = qa = 100 pi; larger wave numbers contribute 1e-6. The compliance is
    # (1-nu^2)/E with complex nu and Young's modulus E, which changes 20-fold. The contact radius is found as a root.
    load, velocity, ratio = 10.0, speed * RADIUS, 20.0

    def compliance(omega):
        g = MODULUS * (ratio - (ratio - 1.0) / (1.0 + 1j * omega * TAU))
        young = 3.0 * g / (1.0 + g / (3.0 * bulk))
        nu = young / (2.0 * g) - 1.0
        return 2.0 * (1.0 - nu**2) / young

    a = optimize.brentq(lambda a: a**3 - 0.375 * load * RADIUS * abs(compliance(velocity / a)), 1e-4, 1e-2, xtol=1e-15)

    def ring(x):
        def wave(phi):
            return np.sin(phi) * -compliance(velocity / a * x * np.sin(phi)).imag

        pressure = 3.0 * load * special.spherical_jn(1, x) / x
        return 4.0 * integrate.quad(wave, 0.0, np.pi / 2, epsabs=0.0, limit=200)[0] * pressure**2 * x / a**2

    edges = np.pi * np.array([0.0, 1e-3, 1e-2, 0.1, *range(1, 101)])
    whole = sum(integrate.quad(ring, *ends, epsrel=1e-8)[0] for ends in pairwise(edges))
    material = {"poisson_ratio": 0.5} if bulk == math.inf else {"poisson_ratio": None, "bulk_modulus": bulk}
    torque = persson(standard_linear_solid(ratio), load=load, angular_speed=speed, **material)
    assert torque == close(RADIUS * whole / (2.0 * np.pi) ** 2, rel=1e-5)


ELASTIC_BULK = {"poisson_ratio": None, "bulk_modulus": bulk_modulus(0.3)}


@pytest.mark.parametrize("material", [{"poisson_ratio": 0.5}, ELASTIC_BULK])
def test_persson_at_low_speed(material):
    # The limit also holds for a sphere with an elastic bulk. In the time tau, the surface travels 1e-6 of the contact
    # radius; the quadrature has an error of 1e-5.
    at_rest = {"shear_modulus": MODULUS, "poisson_ratio": material["poisson_ratio"] or 0.3}
    time = analytic.sphere_loss_time(shear_viscosity=MODULUS * TAU, **at_rest)
    case = {"load": 1.0, "angular_speed": 1e-5}
    limit = analytic.low_speed_torque(radius=RADIUS, loss_time=time, **case)
    assert persson(standard_linear_solid(2.0), **case, **material) == close(limit, rel=2e-5)


def test_frequency_factor_chooses_the_modulus_of_the_contact():
    # At c = 0 and at c = infinity, the contact radius is Hertz's with the relaxed and the instantaneous modulus. Then
    # T a^2 depends only on V/a.
    rubber = standard_linear_solid(8.0)
    radii = np.array([analytic.hertz(load=1.0, poisson_ratio=0.5, **ELASTIC).radius] * 2) * [1.0, 0.5]
    low = persson(rubber, load=1.0, angular_speed=2.0, frequency_factor=0.0)
    high = persson(rubber, load=1.0, angular_speed=1.0, frequency_factor=1e12)
    assert low * radii[0] ** 2 == close(high * radii[1] ** 2, rel=1e-9)
    between = persson(rubber, load=1.0, angular_speed=2.0)
    assert low < between < persson(rubber, load=1.0, angular_speed=2.0, frequency_factor=1e12)


@pytest.mark.parametrize(("path", "tolerance"), [(0.1, 0.01), (0.5, 4e-3), (2.0, 4e-3), (10.0, 0.012)])
def test_persson_is_exact_for_little_loss(path, tolerance):
    # The moduli differ by 2 %, so the pressure is Hertz's. The dissipated power is less sensitive to the mesh of 13
    # nodes per contact radius than the torque. The tolerances are larger for a travel of 0.1 a, which is one spacing,
    # and of 10 a, where the finite size of the ball has an effect.
    nearly_elastic = standard_linear_solid(1.02)
    load, speed = hertz_load(2e-3, 0.5), path * 2e-3 / RADIUS / TAU
    r = roll(nearly_solid(shear_modulus=nearly_elastic, poisson_ratio=0.5), load=load, angular_speed=speed)
    torque = persson(nearly_elastic, load=load, angular_speed=speed)
    assert r.dissipated_power / speed == close(torque, rel=tolerance)


@pytest.mark.parametrize(
    ("ratio", "path", "slenderness", "nodes", "share"),
    [
        (2.0, 30.0, 0.05, 3200, 0.98),
        (2.0, 0.3, 0.05, 3200, 1.13),
        (10.0, 1.0, 0.05, 1600, 0.96),
        (10.0, 0.1, 0.1, 800, 1.40),
        (100.0, 10.0, 0.05, 2400, 0.93),
        (100.0, 10.0, 0.1, 1600, 0.89),
        (100.0, 0.01, 0.1, 800, 1.53),
    ],
)
def test_solver_relative_to_persson_as_in_the_docstring(ratio, path, slenderness, nodes, share):
    # Compare with the two decimals of the docstring. At low speed, 13 nodes per contact radius are enough. At high
    # speed, the contact has a fifth of its size at rest if the moduli differ by a factor of 100.
    load, speed = hertz_load(slenderness * RADIUS, 0.5), path * slenderness / TAU
    rubber = standard_linear_solid(ratio)
    ball = nearly_solid(shear_modulus=rubber, poisson_ratio=0.5)
    r = roll(ball, load=load, angular_speed=speed, nodes=nodes)
    assert r.resisting_torque / persson(rubber, load=load, angular_speed=speed) == pytest.approx(share, abs=0.01)


def test_loads_and_speeds_may_be_arrays():
    rubber = standard_linear_solid(2.0)
    loads, speeds = np.array([[1.0], [2.0]]), np.array([0.1, 1.0, 10.0])
    torques = persson(rubber, load=loads, angular_speed=speeds)
    assert torques.shape == (2, 3)
    assert torques[1, 2] == persson(rubber, load=2.0, angular_speed=10)
    slow = analytic.low_speed_torque(load=loads, angular_speed=speeds, radius=RADIUS, loss_time=TAU)
    np.testing.assert_allclose(slow, loads * speeds * RADIUS * TAU, rtol=1e-15)
    contact = analytic.hertz(load=loads, poisson_ratio=0.5, **ELASTIC)
    assert contact.pressure(speeds * 1e-4).shape == (2, 3)
    assert type(persson(rubber, load=1, angular_speed=np.float64(1.0))) is float
    single = analytic.hertz(load=1, poisson_ratio=0.5, **ELASTIC)
    assert type(single.radius) is type(single.pressure(0.0)) is float


SPRING = vr.Elastic(modulus=1.0)
HERTZ = ELASTIC | {"load": 1.0, "poisson_ratio": 0.3}
SPRINGS, FILM = HERTZ | {"thickness": 1e-3}, ELASTIC | {"load": 1.0, "thickness": 1e-3}
SLOW = {"load": 1.0, "angular_speed": 1.0, "radius": 1.0, "loss_time": 1.0}
PERSSON = {"load": 1.0, "angular_speed": 1.0, "radius": 1.0, "shear_modulus": SPRING, "poisson_ratio": 0.5}
SPHERE = {"shear_modulus": 1.0, "poisson_ratio": 0.3, "shear_viscosity": 1.0, "bulk_viscosity": 1.0}


@pytest.mark.parametrize(
    ("function", "valid", "changes", "message"),
    [
        (analytic.hertz, HERTZ, {"load": [1.0, -2.0]}, "load must be > 0 N, got -2"),
        (analytic.hertz, HERTZ, {"load": math.nan}, "load must be > 0 N, got nan"),
        (analytic.hertz, HERTZ, {"radius": math.inf}, "radius must be > 0 m, got inf"),
        (analytic.hertz, HERTZ, {"shear_modulus": 0.0}, "shear_modulus must be > 0 Pa, got 0"),
        (analytic.hertz, HERTZ, {"poisson_ratio": 0.6}, r"poisson_ratio must be in \(-1, 0.5\], got 0.6"),
        (analytic.thin_compressible_layer, SPRINGS, {"poisson_ratio": 0.5}, r"must be in \(-1, 0.5\), got 0.5"),
        (analytic.thin_compressible_layer, SPRINGS, {"thickness": 0}, "thickness must be > 0 m, got 0"),
        (analytic.thin_incompressible_layer, FILM, {"thickness": -1}, "thickness must be > 0 m, got -1"),
        (analytic.low_speed_torque, SLOW, {"angular_speed": 0.0}, "angular_speed must be > 0 rad/s, got 0"),
        (analytic.low_speed_torque, SLOW, {"loss_time": -1.0}, "loss_time must be >= 0 s, got -1"),
        (analytic.sphere_loss_time, SPHERE, {"bulk_viscosity": -1.0}, "bulk_viscosity must be >= 0 Pa s, got -1"),
        (analytic.brilliantov_poschel_time, SPHERE, {"shear_viscosity": 0}, "shear_viscosity must be > 0 Pa s, got 0"),
        (analytic.brilliantov_poschel_time, SPHERE, {"poisson_ratio": 0}, "poisson_ratio must be .* not 0, .* got 0"),
        (analytic.greenwood_tabor_torque, HERTZ, {"loss_fraction": 1.5}, r"loss_fraction must be in \[0, 1\], got 1.5"),
        (analytic.persson_torque, PERSSON, {"frequency_factor": -1.0}, "frequency_factor must be >= 0, got -1"),
        (analytic.persson_torque, PERSSON, {"bulk_modulus": 1.0}, "poisson_ratio or bulk_modulus must .* got both"),
        (
            analytic.persson_torque,
            PERSSON,
            {"poisson_ratio": None},
            "poisson_ratio or bulk_modulus must .* got none",
        ),
    ],
)
def test_values_out_of_range(function, valid, changes, message):
    function(**valid)
    with pytest.raises(ValueError, match=message):
        function(**valid | changes)


@pytest.mark.parametrize(
    ("function", "valid", "changes", "message"),
    [
        (analytic.hertz, HERTZ, {"load": "1"}, "load must contain real numbers, got "),
        (analytic.hertz, HERTZ, {"radius": [1.0, 2.0]}, "radius must be a real number, got list"),
        (analytic.hertz, HERTZ, {"shear_modulus": SPRING}, "shear_modulus must be a real number, got Elastic"),
        (analytic.persson_torque, PERSSON, {"shear_modulus": "1"}, "shear_modulus must be a modulus of viscoroll"),
        (
            analytic.applicable,
            {"body": paper.ball()},
            {"body": "ball"},
            "body must be a viscoroll.CoatedSphere",
        ),
    ],
)
def test_values_of_another_type(function, valid, changes, message):
    function(**valid)
    with pytest.raises(TypeError, match=message):
        function(**valid | changes)


def ball_of(*moduli, **material):
    layers = [vr.Layer(thickness=0.45 * RADIUS, shear_modulus=modulus, **material) for modulus in moduli]
    return vr.CoatedSphere(core_radius=0.1 * RADIUS, layers=layers)


RUBBER = standard_linear_solid(2.0)
FRACTIONAL = vr.materials.FractionalZener(
    instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=TAU, order=0.5
)
CURVE = vr.MasterCurve([0.0, 1.0, 1e9], [MODULUS, MODULUS, 2 * MODULUS], [0.0, 0.0, 1e5])
ALL = {"low_speed", "greenwood_tabor", "persson"}


@pytest.mark.parametrize(
    ("ball", "names"),
    [
        (ball_of(RUBBER, RUBBER, poisson_ratio=0.5), ALL),
        (ball_of(RUBBER, standard_linear_solid(3.0), poisson_ratio=0.5), set()),
        (ball_of(RUBBER, vr.materials.KelvinVoigt(modulus=1.0, viscosity=TAU), poisson_ratio=0.0), {"low_speed"}),
        (ball_of(RUBBER, bulk_modulus=1e7), ALL | {"winkler"}),
        (ball_of(RUBBER, vr.materials.KelvinVoigt(modulus=1.0, viscosity=TAU), bulk_modulus=1e7), set()),
        (ball_of(FRACTIONAL, poisson_ratio=0.4), {"greenwood_tabor", "persson"}),
        (ball_of(CURVE, poisson_ratio=0.4), {"greenwood_tabor"}),
        (ball_of(lambda omega: MODULUS + 1e3j * omega, poisson_ratio=0.5), ALL),
    ],
)
def test_closed_forms_that_apply_to_a_ball(ball, names):
    forms = analytic.applicable(ball)
    assert set(forms) == names
    loads, speeds = np.array([[1e-3], [1.0]]), np.array([1e-3, 1.0, 1e3])
    for form in forms.values():
        assert form(loads, speeds).shape == form.is_valid(loads, speeds).shape == (2, 3)
        assert type(form(1.0, 2.0)) is float
        assert form.validity
        assert form(1.0, 2.0) == form.torque(1.0, 2.0)


@pytest.mark.parametrize("material", [{"poisson_ratio": 0.4}, {"bulk_modulus": bulk_modulus(0.4)}])
def test_forms_of_a_ball_agree_with_the_functions(material):
    ball = ball_of(RUBBER, **material)
    ball = vr.CoatedSphere(core_radius=0.55 * RADIUS, layers=ball.layers)
    forms = analytic.applicable(ball)
    sphere = {"shear_modulus": MODULUS, "poisson_ratio": 0.4}
    bulk_viscosity = TAU * bulk_modulus(0.4) if "poisson_ratio" in material else 0.0
    time = analytic.sphere_loss_time(**sphere, shear_viscosity=TAU * MODULUS, bulk_viscosity=bulk_viscosity)
    case = {"load": 2.0, "angular_speed": 0.3}
    expected = {
        "winkler": analytic.winkler_torque(
            **case, radius=RADIUS, thickness=0.45 * RADIUS, shear_modulus=RUBBER, **material
        ),
        "low_speed": analytic.low_speed_torque(**case, radius=RADIUS, loss_time=time),
        "greenwood_tabor": analytic.greenwood_tabor_torque(load=2.0, radius=RADIUS, **sphere),
        "persson": analytic.persson_torque(**case, radius=RADIUS, shear_modulus=RUBBER, **material),
    }
    assert {name: form(**case) for name, form in forms.items()} == close(expected, rel=1e-12)


@pytest.mark.parametrize("material", [{"poisson_ratio": 0.5}, {"bulk_modulus": 1e2 * MODULUS}])
def test_forms_are_valid_for_small_contacts_and_slow_rolling(material):
    # The thickness is 0.55 of the radius, so a fifth of the thickness is 0.11 R.
    ball = ball_of(RUBBER, **material)
    ball = vr.CoatedSphere(core_radius=0.55 * RADIUS, layers=ball.layers)
    forms = analytic.applicable(ball)
    small, large = hertz_load(np.array([0.08, 0.1]) * RADIUS, 0.5)
    for name in ("greenwood_tabor", "persson"):
        assert forms[name].is_valid([small, large], 1.0).tolist() == [True, False]
    # 5 % of the small contact radius is 0.004 R.
    assert forms["low_speed"].is_valid(small, np.array([0.3, 0.5])).tolist() == [True, False]
    assert forms["low_speed"].is_valid(large, 0.3) == ("poisson_ratio" in material)


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.5])
def test_limit_of_low_speed_on_a_thin_coating_depends_on_the_contact_radius(poisson_ratio):
    # At a/h = 20, the limit of validity is a travel of 5 % of the exact contact radius, to within 10 %.
    load = bonded_layer(20, poisson_ratio)[0] * MODULUS * 1e-3**3 / 0.25
    layer = vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=poisson_ratio)
    form = analytic.applicable(vr.CoatedSphere(core_radius=0.249, layers=[layer]))["low_speed"]
    limit = 0.05 * 20e-3 / (0.25 * TAU)
    assert form.is_valid(load, np.array([0.99, 1.1]) * limit).tolist() == [True, False]


def test_everything_public_is_documented_with_an_example():
    for name in analytic.__all__:
        doc = inspect.getdoc(getattr(analytic, name))
        assert doc, name
        if inspect.isfunction(getattr(analytic, name)):
            assert all(section in doc for section in ("Parameters", "Returns", "Raises", "Examples")), name


def test_closed_forms_of_balls_on_balls_use_the_relative_radius():
    # Both forms agree within some percent with the solver here, as they do on the plane.
    soft = vr.materials.KelvinVoigt(modulus=2e4, viscosity=20.0)
    gel = vr.Layer(thickness=18e-3, shear_modulus=soft, poisson_ratio=0.5)
    ball, rigid = vr.CoatedSphere(core_radius=2e-3, layers=[gel]), vr.CoatedSphere(core_radius=30e-3)
    load, speed = 2e-3, 0.2  # in the loss time the surface travels 4 % of the contact radius
    for first, other, omega in ((ball, rigid, speed), (rigid, ball, speed * 20.0 / 30.0), (ball, ball, speed)):
        forms = analytic.applicable(first, on=other)
        mesh = vr.Mesh(nodes_per_revolution=round(4000 * first.outer_radius / 20e-3))
        found = vr.solve(first, on=other, load=load, angular_speed=omega, mesh=mesh, threads=1).resisting_torque
        assert set(forms) == {"low_speed", "greenwood_tabor", "persson"}
        for name in ("low_speed", "persson"):
            assert forms[name].is_valid(load, omega), name
            assert forms[name](load, omega) == pytest.approx(found, rel=0.1), name
    assert analytic.applicable(ball, on=vr.CoatedSphere(core_radius=10e-3, layers=[gel])) == {}
    assert analytic.applicable(vr.CoatedCylinder(core_radius=0.1, layers=[gel]), on=rigid) == {}
    assert set(analytic.applicable(ball, on=vr.CoatedPlane())) == {"low_speed", "greenwood_tabor", "persson"}
    assert analytic.applicable(ball, on=vr.CoatedPlane(layers=[gel])) == {}
