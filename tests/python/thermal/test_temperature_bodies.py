"""Steady and transient temperatures of rollers, belts and tracks: closed forms and an independent program."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from scipy import optimize, special
from shared_cases import RUBBER
from viscoroll import enums
from viscoroll.thermal.conduction import Conduction
from viscoroll.thermal.heat_modes import modes_of_ball, modes_of_roller, modes_of_slab

INNER, OUTER, K, H, Q = 50e-3, 60e-3, 0.25, 15.0, 2e3
AIR = {"conductivity": K, "convection": H, "ambient": 293.15}
PU = vr.StandardLinearSolid(instantaneous_modulus=14e6, relaxed_modulus=12e6, relaxation_time=0.01)


def annulus(inner, *, width=None, side=0.0, count=1, conductivities=(K,), radii=(INNER, OUTER)):
    return Conduction(radii, conductivities, modes_of_roller(width, side, count), film=H, inner=inner)


def test_an_annulus_on_an_insulated_hub():
    """Compare with T = q (r_o² - r_i²)/2 h r_o + q (r_o² - r²)/4k - (q r_i²/2k) ln(r_o/r)."""
    layers = annulus(np.zeros(1))
    rises = layers.solve(np.full((1, layers.coordinate.size), Q))
    r = layers.coordinate
    expected = (
        Q * (OUTER**2 - INNER**2) / (2 * H * OUTER)
        + Q * (OUTER**2 - r**2) / (4 * K)
        - Q * INNER**2 / (2 * K) * np.log(OUTER / r)
    )
    np.testing.assert_allclose(rises[0], expected, rtol=1e-12)


@pytest.mark.parametrize("hub", [0.0, 8.0, None])
def test_side_faces_by_bessel_functions(hub):
    """Each wave cos(β z) is a sum of I_0 and K_0; the supplied heat leaves through surface, hub and faces."""
    width, side = 40e-3, 15.0 / K
    modes = modes_of_roller(width, side, 12)
    layers = annulus(None if hub is None else np.full(12, hub), width=width, side=side, count=12)
    source = np.repeat(modes.unity[:, None] * Q, layers.coordinate.size, axis=1)
    rises = layers.solve(source, 2.0 if hub is None else 0.0)
    for j in range(12):
        root = optimize.brentq(
            lambda x: x * math.sin(x) - 0.5 * side * width * math.cos(x), j * math.pi, (j + 0.5) * math.pi
        )
        beta = 2.0 * root / width
        c = 4.0 * math.sin(root) / (2.0 * root + math.sin(2.0 * root))
        assert modes.unity[j] == pytest.approx(c, rel=1e-10)
        i0, i1 = (lambda r, b=beta: special.iv(0, b * r)), (lambda r, b=beta: b * special.iv(1, b * r))
        k0, k1 = (lambda r, b=beta: special.kv(0, b * r)), (lambda r, b=beta: -b * special.kv(1, b * r))
        particular = c * Q / (K * beta**2)
        rows = [[K * i1(OUTER) + H * i0(OUTER), K * k1(OUTER) + H * k0(OUTER)]]
        right = [-H * particular]
        if hub is None:
            rows.append([i0(INNER), k0(INNER)])
            right.append(2.0 * c - particular)
        else:
            rows.append([K * i1(INNER) - hub * i0(INNER), K * k1(INNER) - hub * k0(INNER)])
            right.append(hub * particular)
        a, b = np.linalg.solve(rows, right)
        expected = particular + a * i0(layers.coordinate) + b * k0(layers.coordinate)
        np.testing.assert_allclose(rises[j], expected, rtol=1e-8, atol=1e-10 * np.abs(rises).max())
    out = layers.heat_outwards(rises) + layers.heat_inwards(source, rises) + layers.heat_sideways(rises)
    assert out == pytest.approx(layers.total_heat(source), rel=1e-10)


def test_a_slab_cooled_on_both_faces():
    """Solve T'' = -q/k with -k T' = h T on the upper face and k T' = g T on the lower face."""
    h, g = 10.0, 4.0
    layers = Conduction((-6e-3, 0.0), (K,), modes_of_slab(None), film=h, inner=np.full(1, g))
    rises = layers.solve(np.full((1, layers.coordinate.size), Q))
    y = layers.coordinate + 6e-3
    below, slope = np.linalg.solve([[g, -K], [h, K + h * 6e-3]], [0.0, Q * 6e-3 + h * Q * 6e-3**2 / (2 * K)])
    np.testing.assert_allclose(rises[0], below + slope * y - Q * y**2 / (2 * K), rtol=1e-11)


def test_a_source_that_varies_along_a_slab():
    """A source of one cosine on an isothermal base gives q/(k κ²) (1 - cosh κ y + …)."""
    period, h = 20e-3, 3e-3
    modes = modes_of_slab(period, 4)
    layers = Conduction((-h, 0.0), (K,), modes, film=0.0, inner=None)
    source = np.zeros((4, layers.coordinate.size))
    source[3] = Q
    kappa = 2.0 * math.pi * 3 / period
    y = layers.coordinate + h
    exact = Q / (K * kappa**2) * (1.0 - np.cosh(kappa * (h - y)) / math.cosh(kappa * h))
    np.testing.assert_allclose(layers.solve(source)[3], exact, atol=1e-12 * exact.max())


def test_one_mode_in_time():
    """A rise sin(x y/h) on an isothermal base decays at the rate k x²/(ρc h²); x solves the surface condition."""
    h, film, capacity = 6e-3, 40.0, 2e6
    layers = Conduction((-h, 0.0), (K,), modes_of_slab(None), film=film, inner=None)
    x = optimize.brentq(lambda x: K * x / h * math.cos(x) + film * math.sin(x), 0.5 * math.pi, math.pi)
    rate = K * (x / h) ** 2 / capacity
    start = np.sin(x * (layers.coordinate + h) / h)[None]
    times = np.array([0.0, 0.3, 1.0, 2.0]) / rate
    rises = layers.transient(np.zeros_like(start), start, times, capacity)
    np.testing.assert_allclose(rises[:, 0], np.exp(-rate * times)[:, None] * start, atol=1e-9)
    assert layers.time_constants(capacity, 1)[0] == pytest.approx(1.0 / rate, rel=1e-9)


@pytest.mark.parametrize(
    ("modes", "inner"),
    [
        (modes_of_ball(30), 0.2 * np.arange(30.0) / 20e-3),  # a conducting core
        (modes_of_ball(30), None),
        (modes_of_roller(50e-3, 15.0 / K, 30), np.full(30, 40.0)),
    ],
    ids=["on a core", "on an isothermal core", "between faces"],
)
def test_slowest_time_constants(modes, inner):
    """Compare with the late decay of each mode."""
    capacity = 2e6
    layers = Conduction((20e-3, 22e-3, 25e-3), (K, 2.0 * K), modes, film=12.0, inner=inner)
    found = layers.time_constants(capacity, 3)
    np.testing.assert_allclose(found, layers.time_constants(capacity, 30)[:3], rtol=1e-12)
    start = np.where(layers.coordinate > layers.coordinate[0], 1.0, 0.0) * np.ones((30, 1))
    late = np.array([6.0, 6.5]) * found[0]
    left = layers.transient(np.zeros_like(start), start, late, capacity)[:, :3, -1]
    each = (late[1] - late[0]) / np.log(left[0] / left[1])
    np.testing.assert_allclose(found, each, rtol=1e-3)


@pytest.fixture(scope="module")
def rolling_roller():
    """Return a roller of 50 + 10 mm under 5 kN/m at 10 rad/s."""
    layer = vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    body = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    return vr.solve(body, load=5e3, angular_speed=10.0, mesh=vr.Mesh(nodes_per_revolution=6000))


def test_a_roller_agrees_with_an_independent_program(rolling_roller):
    """Compare the mean weighted by the loss, the maximum and the surface maximum [K] with a NumPy program."""
    hub = 8.0 * 2.0 * math.pi * 50e-3 * 50e-3
    for options, mean, most, surface in (
        ({}, 0.60875, 0.65841, 0.51073),
        ({"core": enums.Core.ISOTHERMAL}, 0.09630, 0.12277, 0.11323),
        ({"width": 50e-3, "hub_conductance": hub}, 0.39146, 0.40616, 0.34218),
    ):
        t = rolling_roller.temperature(**AIR, **options)
        assert t.mean == pytest.approx(mean, rel=2e-4)
        assert t.maximum == pytest.approx(most, rel=5e-4)  # the program evaluates 24 points
        assert t.surface_maximum == pytest.approx(surface, rel=2e-4)
        assert t.heat_to_core + t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-9)
        assert t.heat_unit == ("W" if "width" in options else "W/m")
        t.plot()
    slender = rolling_roller.temperature(width=0.3, **AIR).plot().axes[0]  # 30 times as wide as the cover is thick
    assert slender.get_aspect() == "auto"


def test_a_polyurethane_roller_of_finite_width():
    """Compare largest rises [K] with the same program: isothermal hub, hub of 1 W/K, and cooled side faces."""
    layer = vr.Layer(thickness=15e-3, shear_modulus=PU, poisson_ratio=0.49)
    body = vr.CoatedCylinder(core_radius=80e-3, layers=[layer])
    r = vr.solve(body, load=80e3, angular_speed=10.0, mesh=vr.Mesh(nodes_per_revolution=6000))
    assert r.bulk_power == pytest.approx(319.8, rel=2e-4)
    for options, most in (
        ({"core": enums.Core.ISOTHERMAL}, 10.69),
        ({"width": 50e-3, "hub_conductance": 1.0}, 17.10),
        ({"width": 50e-3, "side_convection": 15.0, "core": enums.Core.ISOTHERMAL}, 10.43),
    ):
        t = r.temperature(**AIR, **options)
        assert t.maximum == pytest.approx(most, abs=0.01)
        assert t.heat_to_core + t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-9)


def test_a_belt_is_hardly_warmed():
    """With a pass every 0.24 s, the same program gives rises of 9.0e-6 K per pass and 0.01652 K on average."""
    belt = vr.CoatedPlane(layers=[vr.Layer(thickness=6e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
    mesh = vr.Mesh(nodes_per_revolution=8000)
    r = vr.solve(vr.CoatedCylinder(core_radius=79.5e-3), on=belt, load=2e3, angular_speed=5.0 / 79.5e-3, mesh=mesh)
    faces = AIR | {"convection": 10.0, "base_convection": 10.0, "period": 0.24, "heat_capacity": 1.98e6}
    t = r.temperature(**faces)
    assert t.maximum == pytest.approx(0.01652, rel=1e-3)
    assert t.ripple == pytest.approx(9.0e-6, rel=0.01)
    assert t.heat_unit == "W/m²"
    with pytest.raises(ValueError, match="period must be given for a plane"):
        r.temperature(**AIR)


def test_the_track_of_a_ball_back_and_forth():
    """On an isothermal base, the same program gives 0.1303 K, with tracks 25.6 mm apart."""
    mat = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
    mesh = vr.Mesh(nodes_per_revolution=1885)
    r = vr.solve(vr.CoatedSphere(core_radius=21e-3), on=mat, load=100.0, angular_speed=2.5, mesh=mesh)
    options = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15, "period": 0.1 / 0.0525}
    with pytest.warns(vr.ResultWarning, match="between passes"):
        t = r.temperature(core=enums.Core.ISOTHERMAL, **options)
    assert t.maximum == pytest.approx(0.1303, rel=1e-3)
    insulated = r.temperature(**options)
    assert 0.985 * 2.4555 < insulated.maximum < 2.4555  # the neighboring tracks are farther away here
    assert insulated.heat_to_surroundings == pytest.approx(insulated.heat, rel=1e-9)


def test_a_cold_start_ends_in_the_steady_state(rolling_roller):
    t = rolling_roller.temperature(time=[0.0, 10.0, 1e3, 1e5], **AIR)
    assert t.history is not None
    maximum = t.history.maximum.to_numpy()
    assert abs(maximum[0]) < 1e-12
    assert (np.diff(maximum) > 0.0).all()
    assert maximum[-1] == pytest.approx(t.maximum, rel=1e-6)
    # At first, all heat stays where it is generated.
    early = rolling_roller.temperature(time=[1e-3], **AIR).history
    assert early.maximum[0] == pytest.approx(
        1e-3 * rolling_roller.loss().power_density.max().item() / 2e6, rel=5e-3
    )  # the maximum lies between nodes

    # The slowest mode is R = J_0 Y_1(κ r_i) - Y_0 J_1(κ r_i), with -k R' = h R at the surface.
    def left(kappa):
        def mode(r, order):
            bessel, other = special.jv(order, kappa * r), special.yv(order, kappa * r)
            return bessel * special.yv(1, kappa * INNER) - other * special.jv(1, kappa * INNER)

        return -K * kappa * mode(OUTER, 1) + H * mode(OUTER, 0)

    kappa = optimize.brentq(left, 20.0, 150.0)
    assert t.times[0] == pytest.approx(2e6 / (K * kappa**2), rel=1e-8)
    # Cooling to the surroundings after the load is removed.
    again = rolling_roller.temperature(time=[0.0, 500.0], start=t, **AIR).history
    assert again.maximum[0] == pytest.approx(t.maximum, rel=1e-5)


def test_a_thick_layer_warms_like_a_half_space():
    """Heated at the surface, it lacks the fraction e^(x²) erfc x of its final rise, x = h √(κt)/k: 13 % after a day."""
    h, capacity, depth = 10.0, 2e6, 6.0  # so deep that the heat does not reach the end within these times
    places = (-depth, -3.0, -1.5, -0.7, -0.3, -0.1, -0.03, -0.01, -1e-3, -5e-5, 0.0)
    layers = Conduction(places, (K,) * 10, modes_of_slab(None), film=h, inner=np.zeros(1))
    source = np.where(layers.layer == 9, Q, 0.0)[None]
    times = np.array([86400.0, 30 * 86400.0])
    steady = layers.solve(source)
    rises = layers.transient(steady, np.zeros_like(steady), times, capacity)
    lacking = 1.0 - rises[:, 0, -1] / steady[0, -1]
    np.testing.assert_allclose(lacking, special.erfcx(h * np.sqrt(times / (K * capacity))), rtol=2e-3)
    np.testing.assert_allclose(lacking, [0.132, 0.0248], rtol=5e-3)
    assert layers.time_constants(capacity, 1)[0] > 2 * 365 * 86400.0
    block = vr.CoatedPlane(layers=[], base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
    r = vr.solve(vr.CoatedCylinder(core_radius=20e-3), on=block, load=500.0, angular_speed=10.0)
    with pytest.raises(ValueError, match="got a half-space: give a thick layer"):
        r.temperature(period=1.0, **AIR)


def test_from_a_steady_state_nothing_changes(rolling_roller):
    """A start from a field of temperatures determines the coefficients of the axial waves."""
    cooling = AIR | {"width": 50e-3, "side_convection": 15.0}
    t = rolling_roller.temperature(**cooling)
    with pytest.raises(ValueError, match="start must be left out without time"):
        rolling_roller.temperature(start=t, **cooling)
    still = rolling_roller.temperature(time=[0.0, 1.0, 100.0], start=t, **cooling).history
    np.testing.assert_allclose(still.maximum, t.maximum, rtol=1e-8)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"side_convection": 5.0}, "width must be given with side_convection"),
        ({"hub_conductance": 5.0}, "width must be given with hub_conductance"),
        ({"width": -1.0}, "width must be > 0 m"),
        ({"period": 1.0}, "period must be left out with a roller"),
        ({"time": [-1.0]}, "time must be >= 0 s"),
        ({"core": enums.Core.ISOTHERMAL, "hub_conductance": 1.0, "width": 0.1}, "hub_conductance must be left out"),
        ({"convection": 0.0}, "convection must be > 0"),
    ],
)
def test_bad_input_for_a_roller(rolling_roller, options, message):
    with pytest.raises(ValueError, match=message):
        rolling_roller.temperature(**AIR | options)
