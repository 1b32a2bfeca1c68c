"""Fields inside wheels and their counterbodies: Bessel functions with 40 digits, rollers, planes, work, tractions."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from reference import wheel_orders as reference
from shared_cases import RUBBER, one_layer
from viscoroll import _core
from viscoroll.solution.interior_fields import order_fields
from viscoroll.solution.interior_files import save_interior

SOFT = vr.StandardLinearSolid(instantaneous_modulus=4e6, relaxed_modulus=1e6, relaxation_time=0.02)
HUB, SPEED = 40e-3, 2.5
TREAD = one_layer(thickness=10e-3)
FLAT = vr.CoatedWheel(core_radius=HUB, layers=[TREAD], width=30e-3, sides="unbounded")
CROWNED = replace(FLAT, crown_radius=0.2)
DISSIMILAR = replace(
    FLAT, layers=[one_layer(thickness=6e-3), one_layer(SOFT, thickness=4e-3, poisson_ratio=0.45)], width=50e-3
)
RADII = [HUB, 43e-3, 46e-3, 48e-3, 50e-3]  # both ends and the middle of each of two layers
MESH = vr.Mesh(nodes_per_revolution=140)

pytestmark = pytest.mark.filterwarnings("ignore:the pressure of a flat tread:viscoroll.ResultWarning")


def largest_error(found, expected):
    """Return the largest error of any component, relative to the largest component of the same field at that point.

    On the hub, whose displacement is zero, the error is relative to the largest value at all places.
    """
    worst = 0.0
    for kind in range(3):
        exact = np.array([place[kind] for place in expected])
        size = np.abs(exact).max(axis=(1, 2), keepdims=True)
        size = np.where(size > 1e-30 * size.max(), size, size.max())
        worst = max(worst, float((np.abs(found[kind][0] - exact) / size).max()))
    return worst


@pytest.mark.parametrize(("m", "n"), [(0, 1), (0, 15), (1, 1), (2, 3), (13, 20), (60, 7)])
def test_orders_agree_with_bessel_functions(m, n):
    positions, numbers = _core.places_at(DISSIMILAR._to_core(), np.array(RADII))
    places = list(zip(positions.tolist(), numbers.tolist(), strict=True))
    assert len(places) == len(RADII) + 1
    moduli = [complex(modulus.complex_modulus(m * SPEED)) for modulus in (RUBBER, SOFT)]
    given = [(6e-3, moduli[0], 0.5), (4e-3, moduli[1], 0.45)]
    expected = reference.order_fields(HUB, given, m, n / 50e-3, places)
    found = order_fields(DISSIMILAR, SPEED, [m], [n], radius=RADII)
    assert largest_error(found, expected) < 1e-11
    # A mirror plane normal to the axis changes the sign of u_z and of components with one index z.
    mirrored = order_fields(DISSIMILAR, SPEED, [m], [-n], radius=RADII)
    flips = [np.array([1, 1, -1]), *[np.array([1, 1, 1, 1, -1, -1])] * 2]
    for kind, flip in enumerate(flips):
        expected = flip[:, None] * flips[0] * found[kind]
        np.testing.assert_allclose(mirrored[kind], expected, atol=1e-12 * np.abs(expected).max())


@pytest.mark.parametrize("m", [1, 2, 13, 150])
def test_orders_without_axial_variation_agree_with_a_roller(m):
    roller = vr.CoatedCylinder(core_radius=HUB, layers=DISSIMILAR.layers)
    found = order_fields(DISSIMILAR, SPEED, [m], [0], radius=RADII)
    expected = order_fields(roller, SPEED, [m], [0], radius=RADII)
    assert largest_error(found, [tuple(kind[0, place] for kind in expected) for place in range(len(RADII) + 1)]) < 1e-10


def test_a_large_wheel_acts_as_a_plane():
    """The difference is proportional to h/R."""
    depth = np.array([0.0, 2e-3, 4e-3, 7e-3, 10e-3])
    plane = vr.CoatedPlane(layers=DISSIMILAR.layers)
    errors = []
    for radius in (10.0, 100.0):
        wheel = replace(DISSIMILAR, core_radius=radius - 10e-3)
        m, n = round(100.0 * radius), round(70.0 * radius)
        found = order_fields(wheel, 0.1 / radius, [m], [n], depth=depth)
        flat = order_fields(plane, 0.1 / radius, [m], [n], depth=depth, rolling_radius=radius)
        errors.append(largest_error(found, [tuple(kind[0, place] for kind in flat) for place in range(6)]))
    assert 1e-5 < errors[1] < 3e-3
    assert errors[1] == pytest.approx(0.1 * errors[0], rel=0.05)


@pytest.mark.parametrize("density", [0.0, 1000.0])
def test_every_order_dissipates_the_work_of_the_surface(density):
    layers = [
        replace(one_layer(SOFT, thickness=3e-3, poisson_ratio=0.45), density=density),
        replace(one_layer(thickness=4e-3), density=density),
        replace(one_layer(SOFT, thickness=3e-3, bulk_modulus=3e7), density=density),
    ]
    wheel = replace(FLAT, layers=layers)
    points, weights = np.polynomial.legendre.leggauss(60)
    m, n = np.array([1, 1, 2, 9, 30]), np.array([0, 1, -3, 12, -40])
    for load in (np.array([1.0, 0.0, 0.0]), np.array([0.3, 1.0j, -0.7])):
        lost = np.zeros(len(m))
        inner = HUB
        for layer in layers:
            radius = inner + 0.5 * layer.thickness * (1.0 + points)
            strain = order_fields(wheel, SPEED, m, n, radius=radius)[2] @ load
            err, epp, ett, erp, ert, ept = np.moveaxis(strain, 2, 0)
            trace = err + epp + ett
            square = sum(abs(e) ** 2 for e in (err, epp, ett)) + 2 * sum(abs(e) ** 2 for e in (erp, ert, ept))
            mu = layer.shear_modulus.complex_modulus(m * SPEED)
            nu = layer.poisson_ratio
            bulk = (mu * 2 * (1 + nu) / (3 * (1 - 2 * nu))).imag[:, None] if nu is not None and nu < 0.5 else 0.0
            density_lost = 2 * mu.imag[:, None] * (square - abs(trace) ** 2 / 3) + bulk * abs(trace) ** 2
            # The volume element is r dr dphi dz; only the arc length depends on the radius.
            lost += (density_lost * radius) @ (0.5 * layer.thickness * weights)
            inner += layer.thickness
        displacement = order_fields(wheel, SPEED, m, n, depth=[0.0])[0][:, 0] @ load
        np.testing.assert_allclose(lost, -wheel.outer_radius * (displacement @ load.conj()).imag, rtol=1e-8)


@pytest.fixture(scope="module")
def flat():
    """Return a flat wheel with unbounded sides in rolling contact: solver and inner fields use the same orders."""
    return vr.solve(FLAT, load=300.0, angular_speed=SPEED, friction=0.3, mesh=MESH)


def test_loss_equals_the_power_at_the_surface(flat):
    loss = flat.loss()
    assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-7)
    # The tolerance covers truncated orders, which contribute at the steep ends of the pressure near the sides.
    assert loss.attrs["power"] == pytest.approx(flat.bulk_power, rel=2e-3)
    assert loss.attrs["bulk_power"] == flat.bulk_power
    assert flat.loss_spectrum().power.sum() == pytest.approx(flat.bulk_power, rel=1e-2)


def test_displacement_at_the_surface_agrees_with_the_solver(flat):
    with pytest.warns(vr.ResultWarning, match="less than a quarter of the node spacing"):
        surface = flat.interior(depth=[0.0]).isel(depth=0)
    radial = surface.displacement.sel(direction="r").to_numpy()
    # The solver's displacement is positive upwards, which is opposite to r at the lowest point.
    np.testing.assert_allclose(radial, -flat.displacement, atol=1e-9 * np.abs(flat.displacement).max())


@pytest.mark.parametrize(
    ("wheel", "friction"), [(FLAT, 0.0), (CROWNED, 0.3), (replace(CROWNED, width=40e-3, sides="free"), 0.3)]
)
def test_stresses_at_the_surface_are_the_tractions(wheel, friction):
    """The sum over all orders gives the tractions at the centers of patches, which are not those of the mesh."""
    r = vr.solve(wheel, load=100.0, angular_speed=SPEED, friction=friction, mesh=MESH)
    with pytest.warns(vr.ResultWarning):
        surface = r.interior(depth=[0.0]).isel(depth=0)
    along, across = r.shear_traction
    # The forward direction along the plane is -φ. Tractions along the plane also have a radial component.
    ahead = 0.5 * np.pi - surface.phi.to_numpy()[:, None]
    radial = -r.pressure + along * ahead + across * r.z / wheel.crown_radius
    size = r.pressure.max()
    np.testing.assert_allclose(surface.stress.sel(component="rr"), radial, atol=2e-5 * size)
    np.testing.assert_allclose(surface.stress.sel(component="rphi"), -along, atol=2e-5 * size)
    np.testing.assert_allclose(surface.stress.sel(component="rtheta"), -across, atol=2e-5 * size)
    np.testing.assert_allclose(surface.z, r.z[0], atol=1e-15)


def test_the_middle_of_a_wide_wheel_agrees_with_a_roller():
    """The load per length is equal. The wheel is four radii wide; its periodic images are two circumferences apart."""
    wide = replace(FLAT, width=0.2)
    mesh = vr.Mesh(nodes_per_revolution=400, theta_nodes_per_revolution=60)
    roller = vr.CoatedCylinder(core_radius=HUB, layers=[TREAD])
    line = vr.solve(roller, load=5e3, angular_speed=SPEED, mesh=vr.Mesh(nodes_per_revolution=400))
    wheel = vr.solve(wide, load=5e3 * 0.2, angular_speed=SPEED, mesh=mesh)
    # The tolerance covers the effect of the edges on a tread of twenty thicknesses.
    share = wheel.pressure[:, wheel.pressure.shape[1] // 2].sum() / line.pressure[:, 0].sum()
    assert share == pytest.approx(1.0, abs=0.02)
    depth = [3e-3, 5e-3, 8e-3, 10e-3]
    of_line = line.interior(depth=depth).isel(theta=0)
    of_wheel = wheel.interior(depth=depth, phi=of_line.phi, theta=[0.5 * np.pi]).isel(theta=0)
    size = np.abs(of_line.stress).max(("component", "phi"))
    assert (np.abs(of_wheel.stress - of_line.stress).max(("component", "phi")) / size).max() < 0.02
    loss = wheel.loss()
    assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-7)
    assert loss.attrs["power"] == pytest.approx(wheel.bulk_power, rel=5e-3)
    assert float(loss.z.max() - loss.z.min()) > 0.2


@pytest.mark.parametrize(
    "on",
    [
        vr.CoatedPlane(layers=[], base=vr.HalfSpace(shear_modulus=SOFT, poisson_ratio=0.45)),
        vr.Groove(radius=-0.3, layers=[one_layer(SOFT, thickness=6e-3, poisson_ratio=0.45)]),
        vr.CoatedCylinder(core_radius=25e-3, layers=[one_layer(SOFT, thickness=5e-3, poisson_ratio=0.45)]),
        replace(CROWNED, core_radius=25e-3, width=40e-3),
    ],
    ids=["half-space", "rail", "roller", "wheel"],
)
def test_interior_of_wheel_and_counterbody(on):
    """The loss of each body equals its bulk power; for a flat wheel, the orders of the solve include no crown."""
    r = vr.solve(FLAT, on=on, load=100.0, angular_speed=SPEED, friction=0.3, mesh=MESH)
    for of, power in (("body", r.rolling_bulk_power), ("counterbody", r.counterbody_bulk_power)):
        loss = r.loss(of=of, depth=[], max_order=250)  # about 12 r_o/a
        assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-7)
        crowned = of == "counterbody" and isinstance(on, vr.CoatedWheel)
        assert loss.attrs["power"] == pytest.approx(power, rel=5e-2 if crowned else 5e-3)
    # Both bodies have the same pressure in the middle, a third of a spacing below either surface.
    inside = [r.interior(depth=[0.7e-3], theta=[0.5 * np.pi], of=of) for of in ("body", "counterbody")]
    pressed = [float(side.stress.sel(component="rr").min()) for side in inside]
    assert pressed == pytest.approx([-r.pressure[:, r.pressure.shape[1] // 2].max()] * 2, rel=0.1)


def test_bonds(flat):
    bonds = flat.bonds()
    np.testing.assert_allclose(bonds.depth, [10e-3])
    assert np.abs(bonds.displacement).max() == 0.0
    # For ν = ½ on a rigid hub, the normal stresses are equal, so shear alone causes the von Mises stress.
    np.testing.assert_allclose(bonds.von_mises, math.sqrt(3.0) * bonds.shear_traction, rtol=1e-5, atol=10.0)
    assert bonds.attrs["body"] == "CoatedWheel"


def test_interior_near_free_sides_is_a_warning():
    free = replace(CROWNED, sides="free")
    near = vr.solve(free, load=100.0, angular_speed=SPEED, mesh=MESH)
    assert near.face_distance < 10e-3
    with pytest.warns(
        vr.ResultWarning, match="stresses and loss near the faces are those of a tread without side faces"
    ) as caught:
        near.interior(depth=[2e-3], theta=[0.5 * np.pi])
    assert len(caught) == 1
    with pytest.warns(vr.ResultWarning, match="stresses and loss near the faces") as caught:
        near.loss(depth=[])
    assert len(caught) == 1
    far = vr.solve(replace(free, width=50e-3), load=20.0, angular_speed=SPEED, mesh=MESH)
    assert far.face_distance > 10e-3
    far.interior(depth=[2e-3], theta=[0.5 * np.pi])  # the test would fail on a warning
    # At this distance, the faces have no effect; the crown, which the orders neglect, changes the loss.
    assert far.loss(depth=[]).attrs["power"] == pytest.approx(far.bulk_power, rel=0.02)


def test_loss_outside_a_measured_table():
    frequency = np.geomspace(1.0, 1e3, 30)
    modulus = RUBBER.complex_modulus(frequency)
    curve = vr.MasterCurve(frequency=frequency, storage=modulus.real, loss=modulus.imag, extrapolation="hold")
    r = vr.solve(replace(FLAT, layers=[one_layer(curve, thickness=10e-3)]), load=300.0, angular_speed=SPEED, mesh=MESH)
    assert 0.0 <= r.extrapolated_loss() < 0.1


def test_files_and_pictures(flat, tmp_path):
    meshio = pytest.importorskip("meshio")
    inside = flat.interior(depth=[3e-3, 5e-3, 8e-3], phi=0.5 * np.pi + np.linspace(-0.2, 0.2, 9))
    save_interior(inside, tmp_path / "inside.nc")
    save_interior(inside, tmp_path / "inside.vtu")
    volume = meshio.read(tmp_path / "inside.vtu")
    assert {block.type for block in volume.cells} == {"hexahedron"}
    # At every depth, z is that of the nodes.
    np.testing.assert_allclose(np.unique(volume.points[:, 1].round(9)), np.sort(flat.z[0].round(9)))
    radius = np.hypot(volume.points[:, 0], volume.points[:, 2])
    np.testing.assert_allclose(np.unique(radius.round(9)), [42e-3, 45e-3, 47e-3])
    # The load is vertical, which is nearly the radial direction.
    pressed = float(inside.stress.sel(component="rr").min())
    assert volume.point_data["stress [Pa]"][:, 8].min() == pytest.approx(pressed, rel=0.02)
    flat.plot_section()
    axes = flat.plot_loss().axes[0]
    assert axes.get_xlim()[1] >= 15.0  # the picture includes the full width


def test_bad_places_are_named(flat):
    with pytest.raises(ValueError, match="theta must be within a revolution of pi/2 rad"):
        flat.interior(depth=[2e-3], theta=[9.0])
    with pytest.raises(ValueError, match="phi must be within half a revolution"):
        flat.interior(depth=[2e-3], phi=[9.0])
    with pytest.raises(ValueError, match=r"depth must be in \[0, 0.01\] m"):
        flat.interior(depth=[11e-3])
    with pytest.raises(ValueError, match=r"result\.on must have a layer or a base"):
        flat.interior(depth=[1e-3], of="counterbody")
    with pytest.raises(ValueError, match="result must have fields narrower than the circumference"):
        replace(flat, z=30.0 * flat.z).loss_spectrum()
