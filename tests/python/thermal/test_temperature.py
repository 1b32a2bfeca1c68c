"""Steady conduction compared with closed forms, and the heat balance."""

from __future__ import annotations

import math
import warnings

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import enums, paper
from viscoroll.thermal.conduction import Conduction
from viscoroll.thermal.heat_modes import film_matrix_of_ball, modes_of_ball

INNER, OUTER = 15e-3, 21e-3
K, H, Q = 0.2, 10.0, 5e4


def shell(*, core=0.0, degrees=9, conductivities=(K,), radii=(INNER, OUTER), convection=H):
    film = film_matrix_of_ball(convection, degrees) if callable(convection) else convection
    inner = None if core is None else core * np.arange(degrees) / radii[0]
    return Conduction(radii, conductivities, modes_of_ball(degrees), film=film, inner=inner)


def source_of(layers, degree, values):
    source = np.zeros((layers.modes.count, layers.coordinate.size))
    source[degree] = values
    return source


def test_uniform_source_on_an_insulated_core():
    layers = shell()
    source = source_of(layers, 0, Q)
    rises = layers.solve(source)
    r = layers.coordinate
    expected = (
        Q * (OUTER**3 - INNER**3) / (3 * H * OUTER**2)
        + Q * (OUTER**2 - r**2) / (6 * K)
        + Q * INNER**3 / (3 * K) * (1 / OUTER - 1 / r)
    )
    np.testing.assert_allclose(rises[0], expected, rtol=1e-10)
    assert layers.heat_outwards(rises) == pytest.approx(layers.total_heat(source), rel=1e-12)


def test_uniform_source_on_an_isothermal_core():
    layers = shell(core=None)
    source = source_of(layers, 0, Q)
    rises = layers.solve(source, inner_rise=3.0)
    r = layers.coordinate
    # The solution is T = -q r²/6k + A - B/r, with T = 3 at the core and -k T' = h T at the surface.
    matrix = [[1.0, -1.0 / INNER], [H, -H / OUTER + K / OUTER**2]]
    a, b = np.linalg.solve(matrix, [3.0 + Q * INNER**2 / (6 * K), Q * OUTER / 3 + H * Q * OUTER**2 / (6 * K)])
    np.testing.assert_allclose(rises[0], -Q * r**2 / (6 * K) + a - b / r, rtol=1e-10)
    out = layers.heat_inwards(source, rises) + layers.heat_outwards(rises)
    assert out == pytest.approx(layers.total_heat(source), rel=1e-11)
    assert layers.heat_inwards(source, rises) == pytest.approx(
        4 * math.pi * INNER**2 * K * (b / INNER**2 - Q * INNER / (3 * K)), rel=1e-9
    )


@pytest.mark.parametrize("degree", [1, 4, 60])
@pytest.mark.parametrize("core", [0.0, None, 40.0])
def test_one_degree(degree, core):
    """T_l = -q r²/(k (6 - l(l+1))) + A (r/r_o)^l + B (r_i/r)^(l+1); A and B follow from the boundary conditions."""
    layers = shell(core=core, degrees=degree + 1)
    rises = layers.solve(source_of(layers, degree, Q))
    particular = -Q / (K * (6 - degree * (degree + 1)))
    ratio = INNER / OUTER

    def row(value, slope, radius, *, inner):
        if inner:
            if core is None:
                return value
            return K * slope - core * degree * value / radius
        return K * slope + H * value

    columns = [
        ((ratio**degree, degree * ratio**degree / INNER), (1.0, degree / OUTER)),
        ((1.0, -(degree + 1) / INNER), (ratio ** (degree + 1), -(degree + 1) * ratio ** (degree + 1) / OUTER)),
        ((particular * INNER**2, 2 * particular * INNER), (particular * OUTER**2, 2 * particular * OUTER)),
    ]
    system = np.array(
        [[row(*column[0], INNER, inner=True), row(*column[1], OUTER, inner=False)] for column in columns]
    ).T
    a, b = np.linalg.solve(system[:, :2], -system[:, 2])
    r = layers.coordinate
    expected = particular * r**2 + a * (r / OUTER) ** degree + b * (INNER / r) ** (degree + 1)
    np.testing.assert_allclose(rises[degree], expected, rtol=1e-7, atol=1e-9 * np.abs(expected).max())


def test_dissimilar_layers_on_an_insulated_core():
    """The mean heat flows only outwards, so the temperature drops of the layers add up."""
    radii, conductivities, heats = (15e-3, 18e-3, 21e-3), (0.5, 0.1), (2e4, 7e4)
    layers = shell(radii=radii, conductivities=conductivities)
    rises = layers.solve(source_of(layers, 0, np.array(heats)[layers.layer]))
    below = 0.0
    flows = []  # r² times the flux: its value at the layer's inner radius plus q (r³ - r_j³)/3
    for inner, outer, heat in zip(radii[:-1], radii[1:], heats, strict=True):
        flows.append((below, heat, inner, outer))
        below += heat * (outer**3 - inner**3) / 3
    rise = below / (H * OUTER**2)
    for (start, heat, inner, outer), k in zip(flows[::-1], conductivities[::-1], strict=True):
        held = start - heat * inner**3 / 3
        rise += held / k * (1 / inner - 1 / outer) + heat * (outer**2 - inner**2) / (6 * k)
    assert rises[0, 0] == pytest.approx(rise, rel=1e-10)


def test_thin_shell_acts_as_a_fin():
    """A fin has T_l = q h / (h_c + k h l(l+1)/R²)."""
    h = 1e-5
    layers = shell(radii=(OUTER - h, OUTER), degrees=7)
    for degree in (0, 2, 6):
        rises = layers.solve(source_of(layers, degree, Q))
        fin = Q * h / (H + K * h * degree * (degree + 1) / OUTER**2)
        assert rises[degree, -1] == pytest.approx(fin, rel=2e-3)  # errors of h/R and of the Biot number


def test_varying_convection_conserves_heat():
    """A constant function equals the number; with a varying coefficient, the heat balance holds."""
    uniform = shell(convection=lambda theta: np.full(theta.shape, H))
    source = np.random.default_rng(1).uniform(0.5, 1.0, (9, uniform.coordinate.size)) * Q
    np.testing.assert_allclose(uniform.solve(source), shell().solve(source), rtol=1e-10)
    varying = shell(convection=lambda theta: H * (1.0 + np.sin(theta) ** 2))
    rises = varying.solve(source)
    assert varying.heat_outwards(rises) == pytest.approx(varying.total_heat(source), rel=1e-11)
    # Fit a polynomial to the rises in the outer layer; its slope gives the heat flux at the surface.
    layer = varying.layer == 0
    fit = np.polynomial.Polynomial.fit(varying.coordinate[layer], rises[:, layer].T[:, 0], 12)
    assert np.isfinite(fit.deriv()(OUTER))


@pytest.fixture(scope="module")
def base_case():
    return vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=1600))


def test_base_case_on_an_insulated_core(base_case):
    """Compare with an independent computation: surface 1.85 K, 1.69 K weighted by the loss, and 1.90 K at most."""
    t = base_case.temperature(conductivity=0.2, convection=10.0, ambient=293.15)
    assert t.surface_maximum == pytest.approx(1.85, rel=5e-3)
    assert t.maximum == pytest.approx(1.90, rel=5e-3)
    near_surface = base_case.loss(depth=[0.0]).power_density.isel(depth=0)
    weighted = float((near_surface * t.rise.isel(radius=-1)).sum() / near_surface.sum())
    assert weighted == pytest.approx(1.69, rel=5e-3)
    assert weighted < t.mean < t.maximum
    assert t.heat == pytest.approx(base_case.bulk_power, rel=1e-12)
    assert t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-10)
    mean = t.heat / (4 * math.pi * 21e-3**2 * 10.0)
    surface = t.rise.isel(radius=-1)
    weights = np.sin(surface.theta)
    assert float((surface * weights).sum() / weights.sum()) == pytest.approx(mean, rel=1e-3)  # quadrature error in θ


def test_isothermal_core_removes_the_heat_with_a_warning_of_fluctuations(base_case):
    """At 2.5 rad/s, a point cools between passages, so the mean over a revolution is not its temperature."""
    with pytest.warns(vr.ResultWarning, match="varies by up to 0.1"):
        t = base_case.temperature(conductivity=0.2, convection=10.0, ambient=293.15, core=enums.Core.ISOTHERMAL)
    assert t.heat_to_core + t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-9)
    assert t.heat_to_core > 0.9 * t.heat
    assert t.ripple == pytest.approx(0.11, rel=0.05)


def test_conducting_core_lies_between_insulated_and_isothermal(base_case):
    options = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15}
    insulated = base_case.temperature(**options)
    steel = base_case.temperature(core=45.0, **options)
    assert steel.heat_to_surroundings == pytest.approx(steel.heat, rel=1e-10)
    assert steel.maximum < insulated.maximum


def test_the_plane_cools_the_track(base_case):
    """A metal plane cools the track of a contact of 2 a = 4.7 mm by about 85 W/(m² K); this contact is longer."""
    film = base_case.plane_cooling(convection=10.0, conductivity=0.2, heat_capacity=2e6)
    assert film(np.array([0.5 * math.pi]))[0] == pytest.approx(
        10.0 + 85.0 * math.sqrt(2.0 * base_case.semi_axis_x / 4.7e-3), rel=0.02
    )
    assert film(np.array([0.5]))[0] == 10.0
    cooled = base_case.temperature(conductivity=0.2, convection=film, ambient=293.15)
    assert cooled.maximum < base_case.temperature(conductivity=0.2, convection=10.0, ambient=293.15).maximum


def test_conductivity_may_be_given_in_the_layers(base_case):
    layer = vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5, conductivity=0.2)
    assert layer.conductivity == 0.2
    with pytest.raises(ValueError, match=r"conductivity must be > 0 W/\(m K\)"):
        vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5, conductivity=-1.0)
    with pytest.raises(ValueError, match="conductivity must be given here or in every layer"):
        base_case.temperature(convection=10.0, ambient=293.15)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"conductivity": -0.2}, "conductivity must be > 0 W"),
        ({"conductivity": [0.2, 0.2]}, "conductivity must have one value for each of 1 layers, got 2"),
        ({"convection": -1.0}, "convection must be >= 0 W"),
        ({"convection": 0.0}, "convection must be > 0 W"),
        ({"ambient": 20.0}, r"ambient must be >= 100 K \(20 °C are 293.15 K\), got 20 K"),
        ({"core": -1.0}, "core must be > 0 W"),
        ({"core_temperature": 300.0}, "core_temperature must be left out unless core is ISOTHERMAL"),
    ],
)
def test_bad_input_is_named(base_case, arguments, message):
    with pytest.raises(ValueError, match=message):
        base_case.temperature(**{"conductivity": 0.2, "convection": 10.0, "ambient": 293.15} | arguments)


def test_a_rise_that_destroys_the_layers_is_a_warning(base_case):
    """The mean rise of the surface is the power per area and coefficient of convection; within, it is 1 K higher."""
    options = {"conductivity": 0.2, "ambient": 293.15}
    flux = base_case.bulk_power / (4 * math.pi * base_case.body.outer_radius**2)
    with pytest.warns(vr.ResultWarning, match=r"rises by 21\d K \(recommended: at most 200 K\): this destroys"):
        base_case.temperature(convection=flux / 214.0, **options)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        base_case.temperature(convection=flux / 195.0, **options)
