"""Fields inside rollers, planes and both bodies of a pair: fifty digits, closed forms, and an independent program."""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from reference import interior as shells_of
from reference import interior_flat as reference
from shared_cases import RUBBER
from test_interior_orders import CORE, SURFACE, layers_of, shells
from viscoroll import _core
from viscoroll.solution.interior_fields import order_fields
from viscoroll.solution.interior_files import save_interior

HEIGHTS = [-3e-3, -2.5e-3, -2e-3, -1e-3, -0.5e-3, 0.0]  # three layers of one millimeter
BELT = vr.CoatedPlane(layers=[vr.Layer(thickness=6e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
MAT = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
PIN = vr.CoatedCylinder(core_radius=79.5e-3)


def roller(poisson_ratio=0.5, modulus=RUBBER, core_radius=50e-3, thickness=10e-3):
    layer = vr.Layer(thickness=thickness, shear_modulus=modulus, poisson_ratio=poisson_ratio)
    return vr.CoatedCylinder(core_radius=core_radius, layers=[layer])


def largest_error(got, expected):
    """Return the largest error of any component, relative to the largest component of the same field at that point."""
    worst = 0.0
    for kind in range(3):
        exact = np.array([place[kind] for place in expected])
        size = np.abs(exact).max(axis=(1, 2), keepdims=True)
        worst = max(worst, float((np.abs(got[kind][0] - exact) / np.maximum(size, 1e-300)).max()))
    return worst


@pytest.mark.parametrize("m", [1, 2, 13, 150])
def test_orders_of_a_roller_agree_with_fifty_digits(m):
    layers = shells(bulk=2e8)
    body = vr.CoatedCylinder(core_radius=CORE, layers=layers_of(layers))
    radii = [CORE, 20.5e-3, 21e-3, 22e-3, 22.5e-3, SURFACE]
    positions, numbers = _core.places_at(body._to_core(), np.array(radii))
    places = list(zip(positions.tolist(), numbers.tolist(), strict=True))
    expected = reference.roller_fields(layers, 2.5, m, places)
    assert largest_error(order_fields(body, 2.5, [m], [0], radius=radii), expected) < 1e-12


@pytest.mark.parametrize(("m", "n"), [(1, 0), (2, -1), (13, 7), (150, 40)])
@pytest.mark.parametrize("density", [0.0, 1000.0])
def test_orders_of_flat_layers_agree_with_fifty_digits(m, n, density):
    """The inertial case runs at 0.6 of a shear wave's speed."""
    angular_speed = 0.6 * math.sqrt(1e6 / 1000.0) / SURFACE if density else 2.5
    ends = [-3e-3, -2e-3, -1e-3, 0.0]
    layers = [
        shells_of.Shell(
            inner=ends[j],
            outer=ends[j + 1],
            prony=shell.prony,
            poisson_ratio=shell.poisson_ratio,
            bulk_modulus=shell.bulk_modulus,
            density=density,
        )
        for j, shell in enumerate(shells(bulk=2e8))
    ]
    plane = vr.CoatedPlane(layers=layers_of(layers))
    positions, numbers = _core.places_at(plane._to_core(), np.array(HEIGHTS))
    nearest = [min(HEIGHTS, key=lambda height, p=p: abs(height - p)) for p in positions]
    places = list(zip(nearest, numbers.tolist(), strict=True))
    expected = reference.flat_fields(layers, angular_speed * SURFACE, m / SURFACE, n / SURFACE, places)
    got = order_fields(plane, angular_speed, [m], [n], depth=[-h for h in HEIGHTS], rolling_radius=SURFACE)
    assert largest_error(got, expected) < 1e-12


#: A roller of 50 mm with 10 mm of rubber under 5 kN/m at 1 rad/s: mean power density [W/m^3] at 0.1, 0.3, 0.5, 0.7, 0.9
#: and 1 of the thickness; largest von Mises stress there, shear at the bond and least normal stress on it [MPa]. From
#: an independent program in NumPy: orders in closed form, an active set on its own 130 nodes.
ROLLERS = {
    0.5: ([683.40, 1062.84, 826.20, 557.34, 428.40, 610.88], 0.52146, 0.16203, -0.38140, 0.28065),
    0.45: ([819.48, 1105.82, 886.86, 638.71, 505.54, 617.47], 0.50277, 0.14595, -0.37641, 0.25508),
}


@pytest.mark.parametrize("poisson_ratio", ROLLERS)
def test_a_roller_agrees_with_an_independent_program(poisson_ratio):
    density, von_mises, shear, normal, at_bond = ROLLERS[poisson_ratio]
    r = vr.solve(roller(poisson_ratio), load=5e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=12000))
    loss = r.loss(depth=np.array([0.1, 0.3, 0.5, 0.7, 0.9, 1.0]) * 10e-3)
    np.testing.assert_allclose(loss.power_density[:, 0], density, rtol=2e-4)
    assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-10)
    assert loss.attrs["power"] == pytest.approx(r.bulk_power, rel=1e-4)
    assert loss.layer_power.attrs["units"] == "W m-1"
    inside = r.interior(depth=np.linspace(0.1, 0.4, 7) * 10e-3)
    assert inside.von_mises.max() == pytest.approx(von_mises * 1e6, rel=3e-4)
    bonds = r.bonds()
    assert np.abs(bonds.stress.sel(component="rphi")).max() == pytest.approx(shear * 1e6, rel=1e-3)
    assert bonds.stress.sel(component="rr").min() == pytest.approx(normal * 1e6, rel=1e-3)
    assert bonds.von_mises.max() == pytest.approx(at_bond * 1e6, rel=1e-3)


def test_a_belt_agrees_with_an_independent_program():
    """A rigid idler of 79.5 mm on 6 mm of rubber, 2 kN/m, 5 m/s: energy per volume and pass [J/m^3], and stresses."""
    mesh = vr.Mesh(nodes_per_revolution=8000)
    r = vr.solve(PIN, on=BELT, load=2e3, angular_speed=5.0 / 79.5e-3, mesh=mesh)
    loss = r.loss(depth=np.array([0.1, 0.3, 0.5, 0.7, 0.9, 1.0]) * 6e-3)
    np.testing.assert_allclose(loss.loss_density[:, 0], [11.819, 17.733, 14.170, 9.992, 8.674, 11.771], rtol=3e-4)
    assert loss.attrs["power"] / 5.0 == pytest.approx(0.074324, rel=3e-4)
    assert "power_density" not in loss
    far = np.linspace(-0.25, 0.25, 1001)  # angles [rad]: 20 mm to each side
    inside = r.interior(depth=[1.8e-3, 6e-3], phi=0.5 * np.pi + far)
    assert inside.von_mises[0].max() == pytest.approx(0.28773e6, rel=1e-4)
    shear = inside.stress.sel(component="rphi")[1, :, 0]
    assert shear.min() == pytest.approx(-0.09349e6, rel=2e-4)
    assert shear.max() == pytest.approx(0.09349e6, rel=2e-4)
    assert inside.x[int(shear.argmin("phi"))] == pytest.approx(3.60e-3, abs=0.05e-3)
    assert inside.stress.sel(component="rr")[1].min() == pytest.approx(-0.24307e6, rel=2e-4)


def test_a_mat_under_a_ball_agrees_with_an_independent_program():
    """A rigid ball of 21 mm on 1 mm of rubber, 100 N, 52.5 mm/s: energy per volume below the path, and across it."""
    mesh = vr.Mesh(nodes_per_revolution=1885)
    r = vr.solve(vr.CoatedSphere(core_radius=21e-3), on=MAT, load=100.0, angular_speed=2.5, mesh=mesh)
    loss = r.loss(depth=np.array([0.1, 0.3, 0.5, 0.7, 0.9, 1.0]) * 1e-3)
    below = loss.loss_density.sel(theta=0.5 * np.pi, method="nearest") / 1e3
    np.testing.assert_allclose(below, [113.2, 125.9, 120.6, 112.5, 135.4, 177.9], rtol=1.5e-3)
    across = loss.loss_density.sum("theta") * abs(float(loss.z[1] - loss.z[0]))
    np.testing.assert_allclose(across, [388.6, 467.6, 495.7, 541.8, 746.9, 992.6], rtol=5e-4)
    assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-8)
    bonds = r.bonds()
    assert bonds.stress.sel(component="rr").min() == pytest.approx(-7.40e6, rel=1e-3)
    assert bonds.shear_traction.max() == pytest.approx(2.065e6, rel=1e-3)


@pytest.mark.parametrize(
    ("poisson_ratio", "von_mises", "where"),
    [(0.3, 0.55752, 0.70429), (0.45, 0.52238, 0.78118), (0.5, 0.52011, 0.78615)],
)
def test_a_half_plane_under_a_roller_agrees_with_mcewen(poisson_ratio, von_mises, where):
    """Compare stresses on and off the axis with K. L. Johnson, Contact Mechanics (1985), equations (4.49)."""
    base = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=poisson_ratio)
    mesh = vr.Mesh(nodes_per_revolution=20000)
    r = vr.solve(PIN, on=vr.CoatedPlane(base=base), load=500.0, angular_speed=1.0, mesh=mesh)
    a = math.sqrt(2.0 * 500.0 * 79.5e-3 * (1.0 - poisson_ratio) / (math.pi * 3e6))
    p = 2.0 * 500.0 / (math.pi * a)
    depths = np.array([0.2, 0.5, where, 1.0, 2.0]) * a
    x = np.array([0.0, 0.4, -0.9]) * a
    inside = r.interior(depth=depths, phi=0.5 * np.pi - x / 79.5e-3)
    assert inside.von_mises[2, 0] == pytest.approx(von_mises * p, rel=1e-3)
    assert np.isnan(inside.displacement).all()
    y = depths[:, None]
    difference = a**2 - x**2 + y**2
    root = np.sqrt(difference**2 + 4.0 * x**2 * y**2)
    m, n = np.sqrt(0.5 * (root + difference)), np.sign(x) * np.sqrt(0.5 * (root - difference))
    share = (y**2 + n**2) / (m**2 + n**2)
    stress = inside.stress.to_numpy()[..., 0]
    np.testing.assert_allclose(stress[0], -p / a * m * (1.0 - share), atol=1e-3 * p)
    np.testing.assert_allclose(stress[1], -p / a * (m * (1.0 + share) - 2.0 * y), atol=2e-3 * p)
    np.testing.assert_allclose(stress[2], poisson_ratio * (stress[0] + stress[1]), atol=1e-9 * p)
    np.testing.assert_allclose(stress[3], -p / a * n * (m**2 - y**2) / (m**2 + n**2), atol=1e-3 * p)


@pytest.mark.parametrize(
    ("poisson_ratio", "width", "von_mises", "shear"),
    [
        (0.5, 0.35, 0.600, 0.161),
        (0.5, 1.0, 0.500, 0.289),
        (0.5, 2.0, 0.505, 0.291),
        (0.45, 0.35, 0.611, 0.145),
        (0.45, 1.0, 0.542, 0.259),
        (0.45, 2.0, 0.454, 0.258),
        (0.3, 0.35, 0.663, 0.108),
        (0.3, 1.0, 0.688, 0.187),
        (0.3, 2.0, 0.634, 0.174),
    ],
)
def test_largest_stresses_in_a_bonded_layer(poisson_ratio, width, von_mises, shear):
    """Largest von Mises stress and bond shear / largest pressure, from an independent program accurate to 0.002."""
    thickness, radius = 1e-3, 0.4
    layer = vr.Layer(thickness=thickness, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=poisson_ratio)
    mesh = vr.Mesh(nodes_per_revolution=int(2.0 * math.pi * radius / (width * thickness / 100.0)))
    load = 3e6 * (width * thickness) ** 2 / radius
    for _ in range(12):
        r = vr.solve(
            vr.CoatedCylinder(core_radius=radius),
            on=vr.CoatedPlane(layers=[layer]),
            load=load,
            angular_speed=1.0,
            mesh=mesh,
        )
        ratio = width * thickness / r.semi_axis_x
        if abs(ratio - 1.0) < 0.005:
            break
        load *= ratio**2.5  # the exponent is between 2, for half-planes, and 5, for thin films
    assert abs(ratio - 1.0) < 0.02
    inside = r.interior(depth=np.linspace(0.05, 1.0, 20) * thickness)
    assert inside.von_mises.max().item() / r.max_pressure == pytest.approx(von_mises, abs=0.004)
    assert r.bonds().shear_traction.max().item() / r.max_pressure == pytest.approx(shear, abs=0.003)


def test_thin_films_dissipate_by_shear():
    """Lubrication theory gives the power density w = 3 w_mean (d/h)^2; the film is 1/50 of the contact's width."""
    film = roller(thickness=0.1e-3, core_radius=1.0)
    r = vr.solve(film, load=4e6, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=200000))
    assert r.semi_axis_x > 45 * 0.1e-3
    share = np.array([0.25, 0.5, 0.75, 1.0])
    loss = r.loss(depth=share * 0.1e-3)
    mean = r.bulk_power / (r.angular_speed * 1.00005 * 0.1e-3)
    np.testing.assert_allclose(loss.loss_density[:, 0] / mean, 3.0 * share**2, atol=0.015)


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_loss_of_each_of_two_rollers(friction):
    soft = vr.StandardLinearSolid(instantaneous_modulus=4e6, relaxed_modulus=1e6, relaxation_time=0.02)
    r = vr.solve(
        roller(),
        on=roller(0.45, soft, 30e-3, 5e-3),
        load=3e3,
        angular_speed=2.5,
        friction=friction,
        mesh=vr.Mesh(nodes_per_revolution=3000),
    )
    for of, power in (("body", r.rolling_bulk_power), ("counterbody", r.counterbody_bulk_power)):
        loss = r.loss(of=of)
        assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-8)
        assert loss.attrs["power"] == pytest.approx(power, rel=1e-3 if friction else 2e-4)
        assert r.loss_spectrum(of=of).power.sum() == pytest.approx(power, rel=3e-3)
    # Both bodies have the same pressure and opposite shear.
    ball, counterbody = (r.interior(depth=[0.5e-3], of=of).isel(depth=0, theta=0) for of in ("body", "counterbody"))
    pressure = r.pressure[:, 0]
    for side in (ball, counterbody):
        assert side.stress.sel(component="rr").min() == pytest.approx(-pressure.max(), rel=0.05)
    if friction:
        shears = [side.stress.sel(component="rphi").to_numpy().sum() for side in (ball, counterbody)]
        assert abs(sum(shears)) < 0.3 * abs(shears[0]) + 1e-3 * pressure.sum()


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_losses_of_a_coated_ball_and_a_mat(friction):
    ball = vr.CoatedSphere(
        core_radius=20e-3, layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)]
    )
    mesh = vr.Mesh(nodes_per_revolution=600)
    r = vr.solve(ball, on=MAT, load=60.0, angular_speed=2.5, friction=friction, mesh=mesh)
    for of, power in (("body", r.rolling_bulk_power), ("counterbody", r.counterbody_bulk_power)):
        loss = r.loss(of=of, depth=[0.5e-3])
        assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-7)
        assert loss.attrs["power"] == pytest.approx(power, rel=3e-3)


def test_files_and_pictures_of_both_bodies(tmp_path):
    r = vr.solve(roller(), on=BELT, load=3e3, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=2000))
    for of in ("body", "counterbody"):
        inside = r.interior(depth=[1e-3, 3e-3, 5e-3], of=of)
        save_interior(inside, tmp_path / f"{of}.vtu")
        save_interior(inside, tmp_path / f"{of}.nc")
        r.plot_section(of=of)
        r.plot_loss(of=of)
    import meshio

    below = meshio.read(tmp_path / "counterbody.vtu")
    assert below.points[:, 2].max() == pytest.approx(-1e-3)
    assert {block.type for block in below.cells} == {"quad"}
    above = meshio.read(tmp_path / "body.vtu")
    assert above.points[:, 2].min() == pytest.approx(-59e-3)
    # The load is vertical, along z of both files.
    for volume in (below, above):
        vertical = volume.point_data["stress [Pa]"][:, 8]
        assert vertical.min() < -0.8 * r.max_pressure
