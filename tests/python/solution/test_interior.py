"""Fields and loss inside the coating under a rolling contact."""

from __future__ import annotations

import math

import meshio
import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll import enums, paper
from viscoroll.solution.interior_files import save_interior

THICKNESS = 1e-3


@pytest.fixture(scope="module")
def base_case():
    """Solve the paper's example at π/800 with the radial compliance."""
    return vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=1600))


@pytest.fixture(scope="module")
def coarse():
    return vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=400))


@pytest.fixture(scope="module")
def inside(base_case):
    return base_case.interior(depth=THICKNESS * np.array([0.23, 1.0]))


def test_tractions_on_the_core_of_the_base_case(base_case, inside):
    """Compare with an independent computation: σ_rr -7.41 MPa at x = +0.16 mm, σ_rφ -2.19 and +2.13 MPa."""
    core = inside.isel(depth=1)
    radial = core.stress.sel(component="rr").to_numpy() / 1e6
    place = np.unravel_index(radial.argmin(), radial.shape)
    assert radial.min() == pytest.approx(-7.41, rel=5e-3)
    spacing = 21e-3 * math.pi / 800
    assert base_case.x[place] == pytest.approx(0.16e-3, abs=0.5 * spacing)
    shear = core.stress.sel(component="rphi") / 1e6
    assert float(shear.min()) == pytest.approx(-2.19, rel=5e-3)
    assert float(shear.max()) == pytest.approx(2.13, rel=5e-3)


def test_von_mises_of_the_base_case(inside):
    """Compare with an independent computation: 3.22 MPa at depth 0.23 h and 3.79 MPa at the core."""
    largest = inside.von_mises.max(["phi", "theta"]) / 1e6
    np.testing.assert_allclose(largest, [3.22, 3.79], rtol=5e-3)


def test_incompressible_rubber_on_a_rigid_core(inside):
    """The rubber cannot stretch on the core: σ_φφ = σ_θθ = σ_rr, and von Mises is √3 times the shear on it."""
    core = inside.isel(depth=1)
    radial = core.stress.sel(component="rr")
    for component in ("phiphi", "thetatheta"):
        np.testing.assert_allclose(core.stress.sel(component=component), radial, atol=1e-3 * 7.4e6 * 1e-3)
    np.testing.assert_allclose(core.von_mises, math.sqrt(3.0) * core.shear_traction, rtol=1e-5, atol=1e2)
    assert float(np.abs(core.displacement).max()) == 0.0
    assert float(np.abs(inside.strain[:3].sum("component")).max()) < 1e-12


def test_principal_stresses_and_pressure(inside):
    principal = inside.principal_stress
    trace = inside.stress[:3].sum("component")
    np.testing.assert_allclose(principal.sum("principal"), trace, atol=1e-6 * 7e6)
    np.testing.assert_allclose(inside.hydrostatic_pressure, -trace / 3.0, rtol=1e-12)
    a, b, c = (principal.sel(principal=i) for i in (1, 2, 3))
    np.testing.assert_allclose(
        np.sqrt(0.5 * ((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2)), inside.von_mises, rtol=1e-8, atol=1.0
    )


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("compliance", enums.Compliance)
def test_stresses_at_the_surface_are_the_tractions(friction, compliance):
    """The sum over all orders gives the tractions at the centers of the patches."""
    mesh = vr.Mesh(nodes_per_revolution=200)
    r = vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=mesh, friction=friction, compliance=compliance)
    with pytest.warns(vr.ResultWarning, match="less than a quarter of the node spacing"):
        surface = r.interior(depth=[0.0]).isel(depth=0)
    sin, cos = np.sin(surface.phi.to_numpy())[:, None], np.cos(surface.phi.to_numpy())[:, None]
    pressure, (along, across) = r.pressure, r.shear_traction
    ball = r.body.outer_radius
    if compliance is enums.Compliance.RADIAL:
        # The forward direction along the plane is -φ. Tractions along the plane also have a radial component.
        radial = -pressure + along * (0.5 * math.pi - surface.phi.to_numpy())[:, None] + across * r.z / ball
        tangential = -along
    else:
        y = np.sqrt(ball**2 - r.x**2 - r.z**2)
        radial = (along * r.x - pressure * y + across * r.z) / ball
        tangential = -along * sin - pressure * cos
    size = pressure.max()
    np.testing.assert_allclose(surface.stress.sel(component="rr"), radial, atol=1e-5 * size)
    np.testing.assert_allclose(surface.stress.sel(component="rphi"), tangential, atol=1e-5 * size)


def test_displacement_at_the_surface_agrees_with_the_solver(coarse):
    """The influence tables and the inner fields sum the same orders independently."""
    with pytest.warns(vr.ResultWarning):
        surface = coarse.interior(depth=[0.0]).isel(depth=0)
    radial = surface.displacement.sel(direction="r").to_numpy()
    # The solver's displacement is positive upwards, which is opposite to r at the lowest point.
    np.testing.assert_allclose(radial, -coarse.displacement, atol=1e-6 * np.abs(coarse.displacement).max())


def test_sum_of_single_orders_agrees_with_sum_by_octaves():
    """The truncation order of the second mesh exceeds all orders whose fields reach these depths."""
    case = {"load": 100.0, "angular_speed": 2.5}
    every = vr.solve(paper.ball(), mesh=vr.Mesh(nodes_per_revolution=200), **case)
    whole = vr.solve(paper.ball(), mesh=vr.Mesh(nodes_per_revolution=200, max_order=900), **case)
    depths = THICKNESS * np.array([0.3, 0.6, 1.0])
    a, b = every.interior(depth=depths), whole.interior(depth=depths)
    # The tractions of the two meshes differ by the tables' orders beyond 900.
    size = float(np.abs(a.stress).max())
    assert float(np.abs(a.stress - b.stress).max()) < 2e-3 * size


def test_sections_and_single_points_agree_with_the_window(coarse):
    whole = coarse.interior(depth=[0.4e-3])
    phi, theta = whole.phi.to_numpy(), whole.theta.to_numpy()
    part = coarse.interior(depth=[0.4e-3], phi=phi[5:8], theta=theta[[9, 3]])
    np.testing.assert_allclose(part.stress, whole.stress[..., 5:8, [9, 3]], atol=2e-6 * 7e6)
    around = coarse.interior(depth=[1e-3], phi=np.linspace(-0.5, 1.5, 5) * math.pi, theta=[0.5 * math.pi])
    np.testing.assert_allclose(around.stress[..., 0, :], around.stress[..., -1, :], atol=1.0)  # one revolution


def test_truncation_changes_fields_only_near_the_surface(coarse):
    """The error of a sum up to order N is about N exp(-N d/r_o) at depth d: large near the surface, 6e-5 at core."""
    depths = np.array([0.1e-3, 1e-3])
    whole, ended = (coarse.interior(depth=depths, max_order=order).strain.to_numpy() for order in (None, 200.0))
    off = abs(ended - whole).max(axis=(0, 2, 3)) / abs(whole).max(axis=(0, 2, 3))
    assert off[0] > 1e-3
    assert off[1] < 6e-5
    np.testing.assert_array_equal(coarse.interior(depth=depths, max_order=1e9).strain, whole)


def test_both_sides_of_a_boundary(two_layer_ball):
    r = vr.solve(two_layer_ball, load=20.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=200))
    inside = r.interior(depth=[1e-3])
    assert inside.layer.to_numpy().tolist() == [1, 0]
    size = float(np.abs(inside.stress).max())
    for component in ("rr", "rphi", "rtheta"):
        outer, inner = inside.stress.sel(component=component)
        np.testing.assert_allclose(outer, inner, atol=1e-9 * size)
    outer, inner = inside.stress.sel(component="phiphi")
    assert float(np.abs(outer - inner).max()) > 0.05 * size
    bonds = r.bonds()
    assert bonds.radius.to_numpy().tolist() == pytest.approx([20e-3, 22e-3, 22e-3])
    assert float(bonds.opening_traction.min()) == 0.0


@pytest.mark.parametrize("within", ["HOLLOW", "SOLID"])
def test_other_inner_boundaries(within, rubber):
    solid = within == "SOLID"
    layer = vr.Layer(thickness=21e-3 if solid else 6e-3, shear_modulus=rubber, poisson_ratio=0.45)
    ball = vr.CoatedSphere(
        core_radius=0.0 if solid else 15e-3, layers=[layer], inner_boundary=enums.InnerBoundary[within]
    )
    r = vr.solve(ball, load=5.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=400))
    inside = r.interior(depth=[2e-3, 5.999999e-3])
    assert np.isfinite(inside.stress).all()
    if not solid:
        cavity = r.interior(radius=[15e-3]).isel(depth=0)
        assert float(np.abs(cavity.stress.sel(component="rr")).max()) < 1e-9 * r.max_pressure
        with pytest.raises(ValueError, match=r"result\.body must have a rigid core, a rigid base or several layers"):
            r.bonds()
    loss = r.loss()
    assert loss.attrs["power"] == pytest.approx(r.bulk_power, rel=2e-3)


def test_centrifugal_stress(rubber):
    """Incompressible rubber on a core does not move: σ_rr = -ρΩ²(r_o² - r²)/2, equal in all directions."""
    density, speed = 1000.0, 20.0
    layer = vr.Layer(thickness=5e-3, shear_modulus=rubber, poisson_ratio=0.5, density=density)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    r = vr.solve(ball, load=1e-6, angular_speed=speed, mesh=vr.Mesh(nodes_per_revolution=20000))
    inside = r.interior(radius=[20e-3, 23e-3], phi=[-0.5 * math.pi], theta=[0.5 * math.pi])
    for radius, place in zip((20e-3, 23e-3), inside.stress.squeeze().to_numpy().T, strict=True):
        expected = 0.5 * density * speed**2 * (25e-3**2 - radius**2)
        np.testing.assert_allclose(place[:3], expected, rtol=1e-4)


@pytest.mark.parametrize(("poisson_ratio", "shear", "depth"), [(0.3, 0.310, 0.48), (0.5, 0.266, 0.55)])
def test_hertz(poisson_ratio, shear, depth):
    """Largest shear below a Hertzian contact on a thick coating (K. L. Johnson, Contact Mechanics, section 4.2)."""
    radius, modulus = 21e-3, 3e6
    contact = 0.003 * radius
    load = 8.0 * modulus * contact**3 / (3.0 * (1.0 - poisson_ratio) * radius)
    layer = vr.Layer(thickness=16e-3, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=poisson_ratio)
    ball = vr.CoatedSphere(core_radius=radius - 16e-3, layers=[layer])
    mesh = vr.Mesh(nodes_per_revolution=int(2.0 * math.pi * radius / (contact / 20.0)))
    r = vr.solve(ball, load=load, angular_speed=1.0, mesh=mesh)
    depths = contact * np.arange(0.40, 0.66, 0.01)
    inside = r.interior(depth=depths, phi=[0.5 * math.pi], theta=[0.5 * math.pi]).squeeze()
    largest = 0.5 * (inside.principal_stress[0] - inside.principal_stress[2])
    peak = 1.5 * load / (math.pi * contact**2)
    assert float(largest.max()) / peak == pytest.approx(shear, rel=5e-3)
    assert depths[int(largest.to_numpy().argmax())] / contact == pytest.approx(depth, abs=0.02)


def test_power_density_of_the_base_case(base_case):
    """Compare with an independent computation in the middle of the track."""
    loss = base_case.loss(depth=THICKNESS * np.array([0.1, 0.3, 0.5, 0.7, 0.9, 1.0]))
    middle = loss.power_density.sel(theta=0.5 * math.pi, method="nearest") / 1e3
    np.testing.assert_allclose(middle, [44.2, 51.2, 50.9, 48.7, 59.8, 80.2], rtol=5e-3)
    assert loss.attrs["power"] == pytest.approx(base_case.bulk_power, rel=2e-4)


def _balls(rubber):
    one = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    thick = vr.Layer(thickness=5e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    compressible = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.3)
    soft = vr.Prony(instantaneous_modulus=3e6, weights=[0.3, 0.4], relaxation_times=[0.02, 0.5])
    other = vr.Layer(thickness=1e-3, shear_modulus=soft, bulk_modulus=5e8, density=1000.0)
    return {"base": [one], "5 mm": [thick], "two layers": [other, one], "nu 0.3": [compressible], "friction": [one]}


@pytest.mark.parametrize("name", ["base", "5 mm", "two layers", "nu 0.3", "friction"])
def test_loss_in_the_volume_is_the_power_of_the_surface(name, rubber):
    """On the same orders, those of a mesh with a truncation order, both powers agree to 1e-8."""
    ball = vr.CoatedSphere(core_radius=20e-3, layers=_balls(rubber)[name])
    mesh = vr.Mesh(nodes_per_revolution=200, max_order=150)
    r = vr.solve(ball, load=100.0, angular_speed=2.5, mesh=mesh, friction=0.3 if name == "friction" else 0.0)
    loss = r.loss(max_order=150)
    assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-9)
    assert loss.attrs["power"] == pytest.approx(r.bulk_power, rel=1e-8)
    assert float(loss.layer_power.sum()) == pytest.approx(loss.attrs["power"], rel=1e-12)
    np.testing.assert_allclose(loss.relaxation_power.sum("term"), loss.layer_power, rtol=1e-12)


def test_loss_equals_the_power_for_both_compliances_and_patches(rubber):
    ball = vr.CoatedSphere(core_radius=20e-3, layers=_balls(rubber)["base"])
    mesh = vr.Mesh(nodes_per_revolution=200, max_order=150)
    for patch_load in enums.PatchLoad:
        r = vr.solve(
            ball,
            load=100.0,
            angular_speed=2.5,
            mesh=mesh,
            friction=0.2,
            compliance=enums.Compliance.VERTICAL,
            patch_load=patch_load,
        )
        # The tables of spherical patches omit Legendre terms whose degrees sum to more than 2.
        tolerance = 1e-8 if patch_load is enums.PatchLoad.FLAT else 1e-5
        assert r.loss(max_order=150).attrs["power"] == pytest.approx(r.bulk_power, rel=tolerance)


def test_an_elastic_coating_dissipates_nothing():
    layer = vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.3)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    r = vr.solve(ball, load=50.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=200))
    loss = r.loss()
    assert loss.attrs["power"] == 0.0
    assert float(loss.loss_density.max()) == 0.0


def test_files_contain_the_computed_fields(coarse, tmp_path):
    inside = coarse.interior(depth=THICKNESS * np.array([0.3, 0.6, 1.0]))
    save_interior(inside, tmp_path / "inside.nc")
    xarray.testing.assert_allclose(xarray.load_dataset(tmp_path / "inside.nc"), inside)
    save_interior(inside, tmp_path / "inside.vtu")
    volume = meshio.read(tmp_path / "inside.vtu")
    depth, phi, theta = (inside.sizes[name] for name in ("depth", "phi", "theta"))
    assert len(volume.cells[0].data) == (depth - 1) * (phi - 1) * (theta - 1)
    np.testing.assert_allclose(volume.point_data["von_mises [Pa]"], inside.von_mises.to_numpy().ravel())
    # The trace of a tensor and the length of a vector are independent of directions.
    tensors = volume.point_data["stress [Pa]"].reshape(-1, 3, 3)
    np.testing.assert_allclose(
        np.trace(tensors, axis1=1, axis2=2), inside.stress[:3].sum("component").to_numpy().ravel(), atol=1.0
    )
    np.testing.assert_allclose(np.linalg.norm(volume.points, axis=1).min(), 20e-3, rtol=1e-12)
    # Inverted cells would have negative volumes.
    corners = volume.points[volume.cells[0].data]
    edges = [corners[:, i] - corners[:, 0] for i in (1, 3, 4)]
    assert (np.einsum("ni,ni->n", np.cross(edges[0], edges[1]), edges[2]) > 0.0).all()
    with pytest.raises(ValueError, match=r"path must end in \.nc or \.vtu"):
        save_interior(inside, tmp_path / "inside.txt")
    with pytest.raises(ValueError, match="at least two depths"):
        save_interior(inside.isel(depth=[0]), tmp_path / "inside.vtu")


def test_pictures(coarse, tmp_path):
    heated = coarse.temperature(conductivity=0.2, convection=10.0, ambient=293.15)
    for name, figure in {
        "section": coarse.plot_section(),
        "loss": coarse.plot_loss(),
        "temperature": heated.plot(),
    }.items():
        figure.savefig(tmp_path / f"{name}.png")
        assert (tmp_path / f"{name}.png").stat().st_size > 10000


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({}, "exactly one of depth and radius"),
        ({"depth": [1e-3], "radius": [20e-3]}, "exactly one of depth and radius"),
        ({"depth": [2e-3]}, r"depth must be in \[0, 0.001\] m"),
        ({"depth": [math.nan]}, "depth must be finite"),
        ({"radius": [19e-3]}, r"radius must be in \[0.02, 0.021\] m"),
        ({"depth": [1e-3], "phi": [9.0]}, "phi must be within half a revolution"),
        ({"depth": [1e-3], "max_order": 0.0}, "max_order must be > 0, got 0"),
    ],
)
def test_bad_input_is_named(coarse, arguments, message):
    with pytest.raises(ValueError, match=message):
        coarse.interior(**arguments)


def test_the_exact_sphere_is_rejected():
    r = vr.solve(
        paper.ball(density=0.0),
        load=100.0,
        angular_speed=2.5,
        mesh=vr.Mesh(nodes_per_revolution=100),
        curvature=enums.Curvature.EXACT,
    )
    with pytest.raises(ValueError, match="curvature must be SPHERE or PAPER"):
        r.interior(depth=[1e-3])
    with pytest.raises(ValueError, match="curvature must be SPHERE or PAPER"):
        r.loss()
    with pytest.raises(ValueError, match=r"max_order must be in \[1, 20000\]"):
        vr.solve(paper.ball(), load=1.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=400)).loss(max_order=0)


@pytest.mark.parametrize("on", [vr.CoatedPlane(layers=paper.ball().layers), vr.Groove(radius=30e-3), paper.ball()])
def test_interior_of_a_ball_on_other_counterbodies(on):
    r = vr.solve(paper.ball(), on=on, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=500))
    loss = r.loss(depth=[0.5e-3])
    assert loss.attrs["power"] == pytest.approx(loss.attrs["surface_power"], rel=1e-7)
    assert loss.attrs["power"] == pytest.approx(r.rolling_bulk_power, rel=3e-3)


def test_rigid_bodies_have_no_interior():
    layers = paper.ball().layers
    mesh = vr.Mesh(nodes_per_revolution=500)
    rigid = vr.solve(
        vr.CoatedSphere(core_radius=21e-3), on=vr.CoatedPlane(layers=layers), load=100.0, angular_speed=2.5, mesh=mesh
    )
    with pytest.raises(ValueError, match=r"result.body must have a layer to be evaluated inside"):
        rigid.loss(of="body")
    assert rigid.loss(max_order=50).attrs["of"] == "counterbody"
    soft = vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=mesh)
    with pytest.raises(ValueError, match=r"result.on must have a layer or a base.*got a rigid body"):
        soft.interior(depth=[0.5e-3], of="counterbody")
    with pytest.raises(ValueError, match="of must be 'body' or 'counterbody', got 'plane'"):
        soft.bonds(of="plane")
