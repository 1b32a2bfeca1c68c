"""Temperatures of wheels: comparison with closed forms, rollers, and finite elements of the cross section."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from reference.section_heat import Section, sample_source
from scipy import optimize, special
from shared_cases import one_layer
from viscoroll import enums
from viscoroll.solution.inside import inside_of
from viscoroll.thermal.conduction import Conduction
from viscoroll.thermal.heat_modes import film_matrix_of_wheel, modes_of_roller, modes_of_wheel
from viscoroll.thermal.heated_body import heated_body
from viscoroll.thermal.surroundings import Surroundings

HUB, OUTER, WIDTH, K, H, SIDE = 40e-3, 50e-3, 36e-3, 0.25, 15.0, 12.0
CAPACITY = 2e6
AIR = {"conductivity": K, "convection": H, "ambient": 293.15}
TREAD = one_layer(thickness=10e-3)
FLAT = vr.CoatedWheel(core_radius=HUB, layers=[TREAD], width=WIDTH, sides="unbounded")
CROWNED = replace(FLAT, width=50e-3, crown_radius=0.1)
MESH = vr.Mesh(nodes_per_revolution=300)

pytestmark = pytest.mark.filterwarnings("ignore:the pressure of a flat tread:viscoroll.ResultWarning")


def root(j, biot):
    """Return the root x of wave j, by bisection: x tan x = Bi if j is even, -x cot x = Bi if j is odd."""

    def left(x):
        even = x * math.sin(x) - biot * math.cos(x)
        return even if j % 2 == 0 else x * math.cos(x) + biot * math.sin(x)

    return optimize.brentq(left, 0.5 * math.pi * j, 0.5 * math.pi * (j + 1), xtol=1e-14)


@pytest.mark.parametrize("biot", [0.02, 0.9, 30.0])
def test_waves_between_faces(biot):
    """The waves satisfy the condition at the faces and are orthogonal; the even ones are those of a roller."""
    side = 2.0 * biot / WIDTH
    modes = modes_of_wheel(WIDTH, side, 9)
    beta = np.sqrt(modes.rate(np.array([OUTER]))[:, 0])
    np.testing.assert_allclose(0.5 * WIDTH * beta, [root(j, biot) for j in range(9)], rtol=1e-12)
    points, weights = np.polynomial.legendre.leggauss(60)
    values = modes.values(0.5 * WIDTH * points)
    products = math.pi * WIDTH * (values * weights) @ values.T  # over z and the circumference
    np.testing.assert_allclose(products, np.diag(modes.square), atol=1e-14)
    np.testing.assert_allclose(math.pi * WIDTH * values @ weights, modes.area, atol=1e-14)
    np.testing.assert_allclose(modes.unity[::2], modes_of_roller(WIDTH, side, 5).unity, rtol=1e-13)


def test_waves_between_insulated_faces_are_cosines():
    modes = modes_of_wheel(WIDTH, 0.0, 4)
    z = np.linspace(-0.5, 0.5, 7) * WIDTH
    expected = [np.cos(j * math.pi * (z / WIDTH + 0.5)) for j in range(4)]
    np.testing.assert_allclose(np.abs(modes.values(z)), np.abs(expected), atol=1e-14)
    np.testing.assert_allclose(modes.unity, [1.0, 0.0, 0.0, 0.0], atol=1e-15)


@pytest.mark.parametrize("j", [0, 1, 6])
@pytest.mark.parametrize("hub", [0.0, 8.0, None])
def test_one_wave_by_bessel_functions(j, hub):
    modes = modes_of_wheel(WIDTH, SIDE / K, 7)
    layers = Conduction((HUB, OUTER), (K,), modes, film=H, inner=None if hub is None else np.full(7, hub))
    source = np.zeros((7, layers.coordinate.size))
    source[j] = 2e3
    rises = layers.solve(source)
    beta = 2.0 * root(j, 0.5 * SIDE / K * WIDTH) / WIDTH
    particular = 2e3 / (K * beta**2)
    rows = [
        [K * beta * special.iv(1, beta * OUTER) + H * special.iv(0, beta * OUTER)],
        [
            special.iv(0, beta * HUB)
            if hub is None
            else K * beta * special.iv(1, beta * HUB) - hub * special.iv(0, beta * HUB)
        ],
    ]
    rows[0].append(-K * beta * special.kv(1, beta * OUTER) + H * special.kv(0, beta * OUTER))
    rows[1].append(
        special.kv(0, beta * HUB)
        if hub is None
        else -K * beta * special.kv(1, beta * HUB) - hub * special.kv(0, beta * HUB)
    )
    a, b = np.linalg.solve(rows, [-H * particular, -particular if hub is None else hub * particular])
    r = beta * layers.coordinate
    np.testing.assert_allclose(
        rises[j], particular + a * special.iv(0, r) + b * special.kv(0, r), rtol=1e-8, atol=1e-10 * rises.max()
    )
    out = layers.heat_outwards(rises) + layers.heat_inwards(source, rises) + layers.heat_sideways(rises)
    assert out == pytest.approx(layers.total_heat(source), abs=1e-12 * 2e3 * WIDTH)


def expanded(modes, layers, source):
    """Return the coefficients q_j of a source q(r, z), by Gauss quadrature."""
    points, weights = np.polynomial.legendre.leggauss(200)
    z = 0.5 * WIDTH * points
    waves = math.pi * WIDTH * weights * modes.values(z) / modes.square[:, None]
    return waves @ source(layers.coordinate, z[:, None])


def varying_film(z):
    """Return a convection coefficient that is larger towards one face."""
    return H * (2.0 + z / WIDTH)


@pytest.mark.parametrize("hub", [0.0, 8.0, None])
@pytest.mark.parametrize("film", [H, varying_film])
def test_a_section_agrees_with_finite_elements(hub, film):
    """For an asymmetric heat source, both agree to 2e-6 of the largest rise; elements twice as large give 1e-5."""
    modes = modes_of_wheel(WIDTH, SIDE / K, 80)
    inner = None if hub is None else np.full(80, hub)
    outer = (
        film
        if film is H
        else film_matrix_of_wheel(lambda theta: film(OUTER * (0.5 * math.pi - theta)), modes, WIDTH, OUTER)
    )
    layers = Conduction((HUB, OUTER), (K,), modes, film=outer, inner=inner)
    rises = layers.solve(expanded(modes, layers, sample_source), 3.0 if hub is None else 0.0)
    section = Section(
        (HUB, OUTER), WIDTH, K, surface_convection=film, side_convection=SIDE, hub_convection=hub, elements=(48, 96)
    )
    radius, z = layers.coordinate[1::4], np.linspace(-0.45, 0.45, 7) * WIDTH
    expected = section.values(section.steady(sample_source, 3.0), radius, z)
    found = rises[:, 1::4].T @ modes.values(z)
    # On a hub at 3 K, the temperature jumps at the corners with the colder faces, which waves resolve poorly.
    np.testing.assert_allclose(found, expected, atol=(2e-6 if hub is not None else 1e-3) * expected.max())


def test_a_cold_start_agrees_with_finite_elements():
    """Compare after five minutes, in steps of 1 s; later, the slowest mode decays at its rate in closed form."""
    modes = modes_of_wheel(WIDTH, SIDE / K, 80)
    layers = Conduction((HUB, OUTER), (K,), modes, film=H, inner=np.zeros(80))
    steady = layers.solve(expanded(modes, layers, sample_source))
    after = layers.transient(steady, np.zeros_like(steady), np.array([300.0]), CAPACITY)
    section = Section((HUB, OUTER), WIDTH, K, surface_convection=H, side_convection=SIDE, hub_convection=0.0)
    radius, z = layers.coordinate[1::4], np.linspace(-0.45, 0.45, 7) * WIDTH
    expected = section.values(section.after(sample_source, 300.0, CAPACITY, 300), radius, z)
    np.testing.assert_allclose(after[0, :, 1::4].T @ modes.values(z), expected, atol=2e-5 * expected.max())

    def left(kappa):
        def mode(r, order):
            bessel, other = special.jv(order, kappa * r), special.yv(order, kappa * r)
            return bessel * special.yv(1, kappa * HUB) - other * special.jv(1, kappa * HUB)

        return -K * kappa * mode(OUTER, 1) + H * mode(OUTER, 0)

    kappa = optimize.brentq(left, 20.0, 150.0)
    beta = 2.0 * root(0, 0.5 * SIDE / K * WIDTH) / WIDTH
    assert layers.time_constants(CAPACITY, 1)[0] == pytest.approx(CAPACITY / (K * (kappa**2 + beta**2)), rel=1e-8)


@pytest.fixture(scope="module")
def flat():
    return vr.solve(FLAT, load=300.0, angular_speed=10.0, mesh=MESH)


@pytest.fixture(scope="module")
def crowned():
    return vr.solve(CROWNED, load=100.0, angular_speed=10.0, mesh=MESH)


@pytest.mark.parametrize("sides", [{}, {"side_convection": SIDE}])
@pytest.mark.parametrize(
    "hub", [{}, {"hub_conductance": 0.2}, {"core": enums.Core.ISOTHERMAL, "core_temperature": 300.0}]
)
def test_with_a_uniform_load_a_wheel_is_as_warm_as_a_roller(flat, sides, hub):
    """A wheel with the loss of a roller at every axial position has the roller's temperature, for any cooling."""
    roller = vr.solve(
        vr.CoatedCylinder(core_radius=HUB, layers=[TREAD]),
        load=8e3,
        angular_speed=10.0,
        mesh=vr.Mesh(nodes_per_revolution=900),
    )
    of_roller = roller.temperature(width=WIDTH, **sides, **hub, **AIR)
    line = roller.loss()
    across = np.linspace(-0.5, 0.5, 40) * 4.0 * WIDTH
    even = (
        line.isel(theta=0)
        .drop_vars(["theta", "z"])
        .expand_dims(theta=across.size, axis=1)
        .assign_coords(z=("theta", -across))
    )
    given = Surroundings(convection=H, ambient=293.15, **sides, **hub)
    body = heated_body(inside_of(flat), given, K)
    body = replace(body, power=roller.bulk_power * WIDTH)
    source = body.source(even)
    rises = body.conduction.solve(source, body.inner_rise)
    found = rises[:, [0, -1]].T @ body.values(of_roller.rise.z.to_numpy())
    expected = of_roller.rise.isel(radius=[0, -1])
    # The solutions have 80 and 40 even waves, which differ at the corners.
    np.testing.assert_allclose(found, expected, atol=1e-4 * of_roller.maximum)
    assert body.means(source, rises)[0] == pytest.approx(of_roller.mean, rel=1e-6)


@pytest.mark.parametrize("wheel", ["flat", "crowned"])
@pytest.mark.parametrize(
    "options",
    [
        {},
        {"side_convection": SIDE, "hub_conductance": 0.1},
        {"side_convection": SIDE, "core": enums.Core.ISOTHERMAL},
        {"convection": "that of the plane, too"},
    ],
)
def test_heat_balance(wheel, options, request):
    r = request.getfixturevalue(wheel)
    if "convection" in options:
        options = {"convection": r.plane_cooling(convection=H, conductivity=K, plane_effusivity=500.0)}
    t = r.temperature(max_order=60, **AIR | options)
    assert t.heat == pytest.approx(r.bulk_power, rel=1e-12)
    assert t.heat_unit == "W"
    assert t.heat_to_core + t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-8)
    np.testing.assert_allclose(t.rise.z, -t.rise.z[::-1], atol=1e-15)
    assert float(t.rise.z.max()) == pytest.approx(0.5 * r.body.width)
    t.plot()


def test_the_temperature_field_follows_from_the_loss(crowned):
    """Compare with finite elements of the section, heated by the loss interpolated between its nodes."""
    t = crowned.temperature(side_convection=SIDE, hub_conductance=0.1, max_order=120, **AIR)
    depth = np.linspace(0.0, 10e-3, 81)
    loss = crowned.loss(depth=depth, max_order=120)
    z = loss.z.to_numpy()[::-1]
    density = loss.power_density.to_numpy()[:, ::-1]

    def source(radius, place):
        below = (OUTER - radius) / depth[1]
        row = np.clip(below.astype(int), 0, depth.size - 2)
        across = (place - z[0]) / (z[1] - z[0])
        column = np.clip(across.astype(int), 0, z.size - 2)
        s, c = below - row, across - column
        upper = (1.0 - c) * density[row, column] + c * density[row, column + 1]
        lower = (1.0 - c) * density[row + 1, column] + c * density[row + 1, column + 1]
        return (1.0 - s) * upper + s * lower

    hub = 0.1 / (2.0 * math.pi * HUB * CROWNED.width)
    section = Section((HUB, OUTER), CROWNED.width, K, surface_convection=H, side_convection=SIDE, hub_convection=hub)
    share = crowned.bulk_power / (2.0 * math.pi * section.load(source).sum())
    assert share == pytest.approx(1.0, abs=0.02)  # effect of the crown and of the faces
    rise = section.steady(source)
    places = t.rise.z.to_numpy()[::20]
    expected = share * section.values(rise, t.rise.radius.to_numpy()[1::6], places)
    # The tolerance covers linear interpolation of the loss between nodes.
    np.testing.assert_allclose(t.rise[1::6, ::20], expected, atol=2e-3 * t.maximum)


def test_the_middle_of_a_wide_wheel_is_as_warm_as_a_roller():
    """Compare rises relative to the loss in the middle, because the ends of the pressure change this loss."""
    mesh = vr.Mesh(nodes_per_revolution=300, theta_nodes_per_revolution=60)
    wide = vr.solve(replace(FLAT, width=0.2), load=8e3 * 0.2, angular_speed=10.0, mesh=mesh)
    line = vr.solve(vr.CoatedCylinder(core_radius=HUB, layers=[TREAD]), load=8e3, angular_speed=10.0, mesh=MESH)
    depth = [3e-3, 5e-3, 8e-3]
    loss = wide.loss(depth=depth, max_order=60).power_density
    lost = loss.interp(theta=0.5 * math.pi)
    within = float(loss.where(abs(loss.z) <= 0.1).sum() / loss.sum())
    assert 0.97 < within < 0.995
    share = (lost / line.loss(depth=depth, max_order=60).power_density.isel(theta=0)).to_numpy()
    assert share == pytest.approx([share.mean()] * 3, rel=0.01)
    t, of_line = wide.temperature(max_order=60, **AIR), line.temperature(max_order=60, **AIR)
    middle = float(t.rise.sel(z=0.0, method="nearest").max())
    assert middle == pytest.approx(share.mean() / within * of_line.maximum, rel=0.005)


def test_a_crown_is_hotter_than_a_flat_tread(flat, crowned):
    """Relative to the power, the crowned wheel is hotter, because its heat is generated in a smaller volume."""
    cooling = AIR | {"side_convection": SIDE, "core": enums.Core.ISOTHERMAL}
    of_flat, of_crowned = (r.temperature(max_order=60, **cooling) for r in (flat, crowned))
    assert of_crowned.maximum / of_crowned.heat > 1.1 * of_flat.maximum / of_flat.heat


def test_temperatures_after_one_hour(crowned):
    cooling = AIR | {"side_convection": SIDE, "hub_conductance": 0.1, "max_order": 60}
    t = crowned.temperature(time=[0.0, 60.0, 3600.0, 1e5], **cooling)
    maximum = t.history.maximum.to_numpy()
    assert abs(maximum[0]) < 1e-12
    assert (np.diff(maximum) > 0.0).all()
    assert maximum[-1] == pytest.approx(t.maximum, rel=1e-9)
    # Starting from the steady state, nothing changes.
    still = crowned.temperature(time=[0.0, 600.0], start=t, **cooling).history
    np.testing.assert_allclose(still.maximum, t.maximum, rtol=1e-9)


def test_temperature_of_the_counterbody_of_a_wheel():
    """A roller requires its width and a plane the time between passes; a wheel may be either body."""
    soft = vr.StandardLinearSolid(instantaneous_modulus=4e6, relaxed_modulus=2e6, relaxation_time=0.02)
    layer = one_layer(soft, thickness=5e-3)
    air = AIR | {"max_order": 50}
    given = {"load": 100.0, "angular_speed": 10.0, "mesh": vr.Mesh(nodes_per_revolution=160)}
    roller = vr.solve(FLAT, on=vr.CoatedCylinder(core_radius=25e-3, layers=[layer]), **given)
    with pytest.raises(ValueError, match="width must be given for a roller under a wheel"):
        roller.temperature(of="counterbody", **air)
    t = roller.temperature(of="counterbody", width=80e-3, side_convection=SIDE, **air)
    assert t.heat == pytest.approx(roller.counterbody_bulk_power, rel=1e-12)
    assert t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-8)
    assert float(t.rise.z.max()) == pytest.approx(40e-3)
    assert float(t.rise.radius.max()) == pytest.approx(30e-3)

    plane = vr.solve(FLAT, on=vr.CoatedPlane(layers=[layer]), **given)
    t = plane.temperature(of="counterbody", period=2.0, core=enums.Core.ISOTHERMAL, **air)
    assert t.heat == pytest.approx(plane.counterbody_bulk_power / (0.5 * 2.0), rel=1e-12)  # at 0.5 m/s
    assert t.heat_to_core + t.heat_to_surroundings == pytest.approx(t.heat, rel=1e-8)
    assert plane.temperature(**air).heat == pytest.approx(plane.rolling_bulk_power, rel=1e-12)

    pair = vr.solve(CROWNED, on=replace(CROWNED, width=40e-3), **given)
    of_both = [pair.temperature(of=of, **air) for of in ("body", "counterbody")]
    assert [float(t.rise.z.max()) for t in of_both] == pytest.approx([25e-3, 20e-3])
    assert of_both[0].heat == pytest.approx(of_both[1].heat, rel=1e-2)  # identical, except for the mesh


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"width": 0.03}, "width must be left out with a wheel, got 0.03"),
        ({"period": 1.0}, "period must be left out with a wheel"),
        ({"base_convection": 1.0}, "base_convection must be left out with a wheel"),
        ({"side_convection": -1.0}, r"side_convection must be >= 0 W/\(m\^2 K\)"),
        ({"hub_conductance": -1.0}, "hub_conductance must be >= 0 W/K"),
        ({"convection": 0.0}, r"convection must be > 0 W/\(m\^2 K\) if nothing else removes heat"),
        ({"convection": lambda theta: -1.0}, "convection must return finite coefficients"),
        ({"convection": lambda theta: [1.0, 2.0]}, r"or one for each of the given angles, got shape \(2,\)"),
        (
            {"convection": lambda theta: 0.0 * theta},
            r"convection must be > 0 W/\(m\^2 K\) if nothing else removes heat",
        ),
        ({"core": enums.Core.ISOTHERMAL, "hub_conductance": 1.0}, "hub_conductance must be left out"),
        ({"of": "counterbody"}, r"result\.on must have a layer or a base"),
        ({"convection": lambda theta: 15.0, "time": [1.0]}, "convection must be a number for temperatures over time"),
    ],
)
def test_bad_input_for_a_wheel(flat, options, message):
    with pytest.raises(ValueError, match=message):
        flat.temperature(**AIR | options)


def test_cooled_faces_of_layers_with_different_conductivities_are_rejected():
    two = replace(FLAT, layers=[one_layer(thickness=4e-3), one_layer(thickness=6e-3)])
    r = vr.solve(two, load=300.0, angular_speed=10.0, mesh=MESH)
    t = r.temperature(max_order=60, **AIR | {"conductivity": [0.2, 0.3]})
    assert len(t.layer_means) == 2
    with pytest.raises(ValueError, match="conductivity must be the same in all layers if side faces are cooled"):
        r.temperature(side_convection=SIDE, **AIR | {"conductivity": [0.2, 0.3]})
