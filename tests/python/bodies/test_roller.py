"""Rollers in line contact: limits, closed forms, an independent computation, units, and invalid input."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference import roller as reference
from shared_cases import RUBBER
from viscoroll import analytic, enums

SOFT = vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
ROLLER = vr.CoatedCylinder(core_radius=50e-3, layers=[SOFT])
HALF_PLANE = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
STEEL = vr.CoatedCylinder(core_radius=50e-3, layers=[])


@pytest.mark.parametrize("speed", [0.005, 0.05, 0.5])
def test_hunters_closed_form_agrees_with_collocation(speed):
    # 800 strips have an error of about 1e-5; 400 strips differ from them by as much.
    found = analytic.hunter(load=5e3, speed=speed, radius=50e-3, shear_modulus=RUBBER, poisson_ratio=0.5).moment
    assert found == pytest.approx(reference.half_plane_moment(speed, load=5e3, radius=50e-3, nodes=400), rel=1e-4)


def test_hunter_tends_to_hertz_and_the_low_speed_limit():
    common = {"load": 5e3, "radius": 50e-3, "poisson_ratio": 0.3}
    slow = analytic.hunter(**common, speed=1e-6, shear_modulus=RUBBER)
    hertz = analytic.hertz_line(**common, shear_modulus=3e6)
    assert slow.half_width == pytest.approx(hertz.half_width, rel=1e-4)
    assert slow.moment == pytest.approx(5e3 * 1e-6 * 0.125, rel=1e-3)  # P V τ (G₀ - G_∞)/G_∞
    fast = analytic.hunter(**common, speed=1e4, shear_modulus=RUBBER)
    assert fast.half_width == pytest.approx(hertz.half_width / np.sqrt(2.0), rel=1e-4)
    assert fast.center == pytest.approx(0.0, abs=1e-4 * fast.half_width)


@pytest.mark.parametrize("angular_speed", [0.1, 1.0, 10.0])
def test_rigid_roller_on_a_half_plane_agrees_with_hunter(angular_speed):
    r = vr.solve(STEEL, on=HALF_PLANE, load=5e3, angular_speed=angular_speed, accuracy=1e-3)
    exact = analytic.hunter(
        load=5e3, speed=angular_speed * 50e-3, radius=50e-3, shear_modulus=RUBBER, poisson_ratio=0.5
    )
    assert r.resisting_torque == pytest.approx(exact.moment, rel=1e-3)
    assert r.semi_axis_x == pytest.approx(exact.half_width, rel=0.01)  # resolution of whole nodes
    assert r.penetration is r.strain is r.model_error is r.center_height is None
    assert np.isfinite(r.displacement).all()


@pytest.fixture(scope="module")
def coating():
    return reference.coating(nodes=7000)


@pytest.mark.parametrize(("angular_speed", "moment"), [(0.1, 2.806), (1.0, 2.456), (10.0, 0.2888)])
def test_roller_on_a_rigid_plane(coating, angular_speed, moment):
    # Compare with an independent program (docs/theory/rollers.md): first with its limit of fine meshes, which is
    # accurate to 0.3 %; then on the same mesh, where the sums differ by 2e-9.
    given = {"load": 5e3, "angular_speed": angular_speed}
    r = vr.solve(ROLLER, accuracy=1e-3, **given)
    assert r.resisting_torque == pytest.approx(moment, rel=3e-3)
    assert r.energy_balance_error < 1e-3
    r = vr.solve(ROLLER, mesh=vr.Mesh(nodes_per_revolution=7000), **given)
    torque, depth = reference.steady(coating, angular_speed, 5e3, half=130)
    assert r.resisting_torque == pytest.approx(torque, rel=1e-8)
    assert r.penetration == pytest.approx(depth, rel=1e-8)


def test_resistance_does_not_depend_on_which_body_is_coated():
    # The layer on a large roller acts like a flat one. Whether it is on the roller or the plane changes only whether a
    # torque or a force drives.
    mat = vr.CoatedPlane(layers=[SOFT])
    on_mat = vr.solve(vr.CoatedCylinder(core_radius=2.0, layers=[]), on=mat, load=5e3, angular_speed=0.02)
    thick = vr.CoatedCylinder(core_radius=1.99, layers=[SOFT])
    coated = vr.solve(thick, load=5e3, angular_speed=0.02)
    assert on_mat.resisting_torque == pytest.approx(coated.resisting_torque, rel=0.01)
    assert on_mat.driving_torque == pytest.approx(0.0, abs=5e-3 * on_mat.resisting_torque)
    assert on_mat.driving_force * 2.0 == pytest.approx(on_mat.resisting_torque, rel=5e-3)
    assert coated.driving_force == 0.0
    assert coated.driving_torque == coated.resisting_torque


def test_thin_layers_tend_to_their_closed_forms():
    # Errors of the order h/a = 1/30; an incompressible layer approaches the limit slowly.
    hard = vr.Elastic(modulus=1e6)
    for nu, form in ((0.3, analytic.thin_compressible_layer_line), (0.5, analytic.thin_incompressible_layer_line)):
        given = {"load": 6e4 if nu == 0.3 else 5e6, "radius": 1.0, "thickness": 1e-3, "shear_modulus": 1e6}
        exact = form(**given, **({"poisson_ratio": nu} if nu == 0.3 else {}))
        layer = vr.Layer(thickness=1e-3, shear_modulus=hard, poisson_ratio=nu)
        r = vr.solve(vr.CoatedCylinder(core_radius=0.999, layers=[layer]), load=given["load"], angular_speed=1.0)
        a_per_h = exact.half_width / 1e-3
        assert a_per_h > 25.0
        assert r.semi_axis_x == pytest.approx(exact.half_width, rel=2.0 / a_per_h)
        assert r.penetration == pytest.approx(exact.approach, rel=1.0 / a_per_h)
        assert r.max_pressure == pytest.approx(exact.max_pressure, rel=2.0 / a_per_h)


def test_winkler_line_is_near_the_solver_on_a_thin_foam():
    foam = vr.StandardLinearSolid(instantaneous_modulus=6e5, relaxed_modulus=3e5, relaxation_time=0.01)
    layer = vr.Layer(thickness=0.2e-3, shear_modulus=foam, poisson_ratio=0.2)
    roller = vr.CoatedCylinder(core_radius=49.8e-3, layers=[layer])
    forms = analytic.applicable(roller)
    assert set(forms) == {"low_speed", "hunter", "winkler_line"}
    assert forms["winkler_line"].is_valid(1e3, 2.0)
    r = vr.solve(roller, load=1e3, angular_speed=2.0, accuracy=1e-3)
    assert forms["winkler_line"](1e3, 2.0) == pytest.approx(r.resisting_torque, rel=0.03)  # h/a = 0.08


def test_hunters_validity_requires_thick_layers_and_short_wakes():
    thick = vr.Layer(thickness=40e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    roller = vr.CoatedCylinder(core_radius=20e-3, layers=[thick])
    form = analytic.applicable(roller)["hunter"]
    for speed in (0.1, 0.5):
        assert form.is_valid(2e3, speed)
        r = vr.solve(roller, load=2e3, angular_speed=speed, accuracy=3e-3)
        assert form(2e3, speed) == pytest.approx(r.resisting_torque, rel=0.02)
    assert not form.is_valid(2e3, 10.0)  # the wake reaches the core: the closed form is 37 % too large


def test_pictures_of_rollers_are_profiles(tmp_path):
    r = vr.solve(ROLLER, load=5e3, angular_speed=1.0, accuracy=0.05)
    assert len(r.plot().axes) == 2  # tractions, and the gap
    for suffix in ("csv", "nc", "vtu"):
        r.save(tmp_path / f"roller.{suffix}")
        assert (tmp_path / f"roller.{suffix}").stat().st_size > 0


def test_low_speed_torque_is_load_times_speed_times_loss_time():
    # The torque is proportional to the speed only if the travel in the loss time is small compared with the contact,
    # so two speeds are extrapolated.
    torque = [
        vr.solve(ROLLER, load=5e3, angular_speed=speed, mesh=vr.Mesh(nodes_per_revolution=12000)).resisting_torque
        / (5e3 * speed * 60e-3 * 0.125)
        for speed in (0.004, 0.008)
    ]
    assert 2.0 * torque[0] - torque[1] == pytest.approx(1.0, rel=5e-3)


def test_units_are_per_length():
    r = vr.solve(ROLLER, load=5e3, angular_speed=1.0, accuracy=0.05)
    assert [r.unit(name) for name in ("load", "resisting_torque", "bulk_power", "contact_area", "max_pressure")] == [
        "N/m",
        "N m/m",
        "W/m",
        "m",
        "Pa",
    ]
    text = repr(r)
    assert "P = 5 kN/m" in text
    assert "W/m" in text
    assert r.semi_axis_z is None
    assert r.pressure.shape[1] == 1
    assert r.contact_area == pytest.approx(2.0 * r.semi_axis_x)


def test_roller_model_gives_the_results_of_solve():
    mesh = vr.Mesh(nodes_per_revolution=3000)
    model = vr.RollingModel(ROLLER, angular_speed=1.0, mesh=mesh)
    one = vr.solve(ROLLER, load=5e3, angular_speed=1.0, mesh=mesh)
    assert model.solve(load=5e3).resisting_torque == pytest.approx(one.resisting_torque, rel=1e-12)


def test_lateral_creepage_shears_a_roller_along_its_axis():
    # On a thick elastic coating, shear along the axis follows Carter's curve with the antiplane compliance of a
    # half-plane, 1/(μk) in place of (1-ν)/(μk). At ν = ½ this compliance is twice as large, so the same creepage
    # causes half the force.
    a = 1e-4
    load = np.pi * 1e7 * a**2 / 0.1
    layer = vr.Layer(thickness=60e-3, shear_modulus=vr.Elastic(modulus=1e7), poisson_ratio=0.5)
    roller = vr.CoatedCylinder(core_radius=40e-3, layers=[layer])
    mesh = vr.Mesh(nodes_per_revolution=300_000)
    full = 0.3 * a / 0.1
    drive = vr.Drive(creepage=0.0, lateral_creepage=0.5 * full)
    r = vr.solve(roller, load=load, angular_speed=1.0, friction=0.3, drive=drive, mesh=mesh)
    expected = 0.3 * load * (1.0 - (1.0 - 0.25) ** 2)
    assert abs(r.lateral_force) == pytest.approx(expected, rel=0.02)


def _carter_pair(nu: float, share: float, across: int):
    """Roll a thick coating on an identical half-plane: a pair without cross compliance for any ν."""
    hard = vr.Elastic(modulus=1e7)
    radius, a = 0.1, 1e-4
    layer = vr.Layer(thickness=60e-3, shear_modulus=hard, poisson_ratio=nu)
    ground = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=hard, poisson_ratio=nu))
    given = {"load": np.pi * 1e7 * a**2 / (4.0 * (1.0 - nu) * radius), "radius": radius, "poisson_ratio": nu}
    given["shear_modulus"] = 0.5e7  # combined modulus of both bodies
    drive = vr.Drive(creepage=share * 0.3 * a / radius)
    mesh = vr.Mesh(nodes_per_revolution=round(across * np.pi * radius / a))
    roller = vr.CoatedCylinder(core_radius=40e-3, layers=[layer])
    r = vr.solve(roller, on=ground, load=given["load"], angular_speed=1.0, friction=0.3, drive=drive, mesh=mesh)
    return r, analytic.carter_force(creepage=drive.creepage, friction=0.3, **given)


@pytest.mark.parametrize("nu", [0.3, 0.5])
def test_two_identical_bodies_follow_carter(nu):
    for share in (-0.5, 0.2, 0.8):
        r, force = _carter_pair(nu, share, 100)
        assert r.driving_force / (0.3 * r.load) == pytest.approx(force / (0.3 * r.load), abs=0.01)
    errors = [abs(r.driving_force - force) for r, force in (_carter_pair(nu, 0.5, n) for n in (50, 200))]
    assert errors[1] < 0.4 * errors[0]  # first order, except for the creepage of the free roller


def test_creepage_changes_its_sign_with_the_body_that_deforms():
    # The same layer is on a plane, and on a roller so large that the layer is nearly flat. Only the signs of creepage
    # and traction differ.
    radius, given = 2.0, {"load": 5e3, "angular_speed": 0.02, "friction": 0.3}
    mesh = vr.Mesh(nodes_per_revolution=100_000)
    thick = vr.CoatedCylinder(core_radius=radius - 10e-3, layers=[SOFT])
    mat = vr.CoatedPlane(layers=[SOFT])
    for creepage in (-1e-3, 0.0, 1e-3):
        coated = vr.solve(thick, **given, mesh=mesh, drive=vr.Drive(creepage=creepage))
        bare = vr.CoatedCylinder(core_radius=radius, layers=[])
        on_mat = vr.solve(bare, on=mat, **given, mesh=mesh, drive=vr.Drive(creepage=1.0 / (1.0 + creepage) - 1.0))
        dragged = on_mat.driving_force - on_mat.resisting_torque / radius  # without the component of the pressure
        assert dragged == pytest.approx(-coated.driving_force, abs=2e-3 * 0.3 * 5e3)
        assert on_mat.slip_power == pytest.approx(coated.slip_power, rel=1e-2)
        assert on_mat.counterbody_bulk_power == pytest.approx(coated.rolling_bulk_power, rel=1e-2)
        assert max(on_mat.energy_balance_error, coated.energy_balance_error) < 2e-3


@pytest.mark.parametrize("drive", [vr.Drive(force=0.0), vr.Drive(torque=0.0), vr.Drive(creepage=0.01)])
def test_power_balance_of_two_soft_bodies_with_friction(drive):
    floor = vr.CoatedPlane(layers=[SOFT], base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.3))
    mesh = vr.Mesh(nodes_per_revolution=8000)
    r = vr.solve(ROLLER, on=floor, load=5e3, angular_speed=1.0, friction=0.3, drive=drive, mesh=mesh)
    assert min(r.rolling_bulk_power, r.counterbody_bulk_power, r.slip_power) > 0.0
    assert r.energy_balance_error < 3e-3
    given = {"force": r.driving_force * 60e-3, "torque": r.driving_torque}
    for name, value in given.items():
        if getattr(drive, name) is not None:
            assert abs(value) < 1e-8 * r.resisting_torque


def test_power_balance_of_each_roller():
    floor = vr.CoatedPlane(layers=[SOFT])
    r = vr.solve(ROLLER, on=floor, load=5e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=8000))
    assert r.driving_torque * r.angular_speed == pytest.approx(r.rolling_bulk_power, rel=1e-3)
    assert r.driving_force * r.angular_speed * 60e-3 == pytest.approx(r.counterbody_bulk_power, rel=1e-3)


OTHER = vr.CoatedCylinder(
    core_radius=95e-3,
    layers=[
        vr.Layer(thickness=5e-3, shear_modulus=vr.materials.KelvinVoigt(modulus=5e6, viscosity=5e4), poisson_ratio=0.4)
    ],
)


def test_exchanged_rollers_dissipate_the_same_power():
    first = vr.solve(ROLLER, on=OTHER, load=5e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=6000))
    other = vr.solve(OTHER, on=ROLLER, load=5e3, angular_speed=0.6, mesh=vr.Mesh(nodes_per_revolution=10000))
    assert first.rolling_bulk_power == pytest.approx(other.counterbody_bulk_power, rel=1e-4)
    assert first.counterbody_bulk_power == pytest.approx(other.rolling_bulk_power, rel=1e-4)
    assert max(first.energy_balance_error, other.energy_balance_error) < 2e-4


def test_a_large_roller_acts_as_a_plane():
    layers = OTHER.layers
    given = {"load": 5e3, "angular_speed": 1.0, "friction": 0.2, "drive": vr.Drive(force=0.0)}
    mesh = vr.Mesh(nodes_per_revolution=6000)
    on_plane = vr.solve(ROLLER, on=vr.CoatedPlane(layers=layers), mesh=mesh, **given)
    on_large = vr.solve(ROLLER, on=vr.CoatedCylinder(core_radius=100.0, layers=layers), mesh=mesh, **given)
    for name in ("resisting_torque", "driving_torque", "rolling_bulk_power", "counterbody_bulk_power", "creepage"):
        assert getattr(on_large, name) == pytest.approx(getattr(on_plane, name), rel=2e-3), name


@pytest.mark.parametrize("creepage", [-3e-3, 0.0, 3e-3])
def test_exchanged_rollers_have_the_same_results(creepage):
    speed, given = 60e-3, {"load": 5e3, "friction": 0.2}
    back = 1.0 / (1.0 + creepage) - 1.0
    meshes = [vr.Mesh(nodes_per_revolution=n) for n in (6000, 10000)]  # the same distance between nodes
    first = vr.solve(
        ROLLER, on=OTHER, angular_speed=speed / 60e-3, drive=vr.Drive(creepage=creepage), mesh=meshes[0], **given
    )
    other = vr.solve(
        OTHER,
        on=ROLLER,
        angular_speed=(1.0 + creepage) * speed / 100e-3,
        drive=vr.Drive(creepage=back),
        mesh=meshes[1],
        **given,
    )
    traction = [-r.shear_traction[0].sum() * np.ptp(r.x) / (len(r.x) - 1) for r in (first, other)]
    assert traction[0] == pytest.approx(-traction[1], abs=2e-3 * 0.2 * 5e3)
    # The loss per distance is the same, but the surface speeds differ by the creepage.
    assert first.rolling_bulk_power == pytest.approx(other.counterbody_bulk_power, rel=1e-3 + abs(creepage))
    assert first.counterbody_bulk_power == pytest.approx(other.rolling_bulk_power, rel=1e-3 + abs(creepage))
    assert first.slip_power == pytest.approx(other.slip_power, rel=1e-2)
    assert max(first.energy_balance_error, other.energy_balance_error) < 5e-4


@pytest.mark.parametrize("drive", [vr.Drive(force=0.0), vr.Drive(torque=0.0)])
def test_power_balance_of_two_rollers_with_friction(drive):
    mesh = vr.Mesh(nodes_per_revolution=6000)
    r = vr.solve(ROLLER, on=OTHER, load=5e3, angular_speed=1.0, friction=0.2, drive=drive, mesh=mesh)
    given = r.driving_force * 60e-3 if drive.force is not None else r.driving_torque
    assert abs(given) < 1e-8 * r.resisting_torque
    assert r.energy_balance_error < 5e-4


def test_equal_rollers_do_not_slip():
    # The rollers are mirror images for any Poisson's ratio, so pressure causes no slip at zero creepage.
    mesh = vr.Mesh(nodes_per_revolution=6000)
    layer = vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.3)
    roller = vr.CoatedCylinder(core_radius=50e-3, layers=[layer])
    r = vr.solve(roller, on=roller, load=5e3, angular_speed=1.0, friction=0.2, drive=vr.Drive(creepage=0.0), mesh=mesh)
    assert r.slip_power < 1e-6 * r.bulk_power
    assert np.abs(r.shear_traction).max() < 1e-3 * r.max_pressure
    assert r.driving_torque * r.angular_speed == pytest.approx(r.rolling_bulk_power, rel=1e-3)


def test_roller_in_a_ring_has_the_relative_radius():
    relative = 1.0 / (1.0 / 60e-3 - 1.0 / 90e-3)
    r = vr.solve(
        ROLLER, on=vr.Groove(path_radius=90e-3), load=5e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=6000)
    )
    # The pressure has moments about the roller's axis and about the ring's; the whole power is their sum.
    assert r.driving_torque == pytest.approx(r.resisting_torque * 60e-3 / relative, rel=1e-12)
    assert r.bulk_power == pytest.approx(60e-3 * r.resisting_torque / relative, rel=1e-3)
    assert r.driving_force == pytest.approx(r.resisting_torque / 90e-3, rel=1e-12)
    base = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e7), poisson_ratio=0.3)
    lined = vr.Groove(path_radius=90e-3, base=base)
    hertz = vr.solve(STEEL, on=lined, load=1e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=20000))
    a = np.sqrt(2.0 * 0.7 * 1e3 / (np.pi * 1e7) / (1.0 / STEEL.outer_radius - 1.0 / 90e-3))
    second_moment = (hertz.pressure * hertz.x**2).sum() / hertz.pressure.sum()
    assert 2.0 * np.sqrt(second_moment) == pytest.approx(a, rel=1e-3)  # K. L. Johnson (1985), (4.43)
    assert hertz.penetration is None


def test_a_convex_track_with_a_thin_layer_acts_as_a_roller():
    # A groove's layers are flat, which changes the result by h/R = 1/500.
    layer = vr.Layer(thickness=0.2e-3, shear_modulus=RUBBER, poisson_ratio=0.3)
    given = {"load": 2e3, "angular_speed": 1.0, "friction": 0.2, "mesh": vr.Mesh(nodes_per_revolution=6000)}
    on_track, on_roller = (
        vr.solve(ROLLER, on=on, drive=vr.Drive(creepage=2e-3), **given)
        for on in (vr.Groove(path_radius=-0.1, layers=[layer]), vr.CoatedCylinder(core_radius=99.8e-3, layers=[layer]))
    )
    for name in ("resisting_torque", "driving_torque", "counterbody_bulk_power", "slip_power", "penetration"):
        assert getattr(on_track, name) == pytest.approx(getattr(on_roller, name), rel=3e-3), name


@pytest.mark.parametrize("layers", [[], ROLLER.layers])
@pytest.mark.parametrize("drive", [vr.Drive(force=0.0), vr.Drive(torque=0.0), vr.Drive(creepage=5e-3)])
def test_power_balance_in_a_ring_with_friction(layers, drive):
    ring = vr.Groove(path_radius=90e-3, layers=layers)
    mesh = vr.Mesh(nodes_per_revolution=4000)
    r = vr.solve(ROLLER, on=ring, load=5e3, angular_speed=1.0, friction=0.2, drive=drive, mesh=mesh)
    assert r.slip_power > 0.0
    assert r.energy_balance_error < 1e-3


def _carters_traction(s, share: float):
    """Return t / (μ p₀) at x = s a; the stick zone has half width 1 - share and begins at the leading edge."""

    def hertz(s):
        return np.sqrt(np.maximum(1.0 - s**2, 0.0))

    stick = 1.0 - share
    return hertz(s) - stick * hertz((s - share) / stick)


def _error_of_carters_traction(share: float, across: int):
    """Return x / a, the error of the traction / its maximum, and the error of its sum, at `share` of full sliding."""
    a, radius = 1e-4, 0.1
    load = np.pi * 1e7 * a**2 / radius
    layer = vr.Layer(thickness=60e-3, shear_modulus=vr.Elastic(modulus=1e7), poisson_ratio=0.5)
    mesh = vr.Mesh(nodes_per_revolution=round(across * np.pi * radius / a))
    model = vr.RollingModel(vr.CoatedCylinder(core_radius=40e-3, layers=[layer]), angular_speed=1.0, mesh=mesh)
    free = model.solve(load=load, friction=0.3)
    r = model.solve(load=load, friction=0.3, drive=vr.Drive(creepage=free.creepage + share * 0.3 * a / radius))
    x, most = r.x.ravel() / a, 0.3 * 2.0 * load / (np.pi * a)
    error = np.abs(-r.shear_traction[0].ravel() / most - _carters_traction(x, share))
    return x, error, r.driving_force / (0.3 * load) - (1.0 - (1.0 - share) ** 2)


@pytest.mark.parametrize("share", [0.25, 0.5, 0.75])
def test_traction_of_a_fine_mesh_is_carters_within_a_percent(share):
    # Root mean square error.
    x, error, _ = _error_of_carters_traction(share, 200)
    assert np.linalg.norm(error) < 0.01 * np.linalg.norm(_carters_traction(x, share))


@pytest.mark.parametrize("share", [0.25, 0.5, 0.75])
def test_traction_along_the_contact_is_carters(share):
    # F. W. Carter (1926). Incompressible coating, thick compared with the contact, on a rigid plane. The mean error is
    # of first order in the mesh, down to one of the order a/R = 1/1000. Errors above 1 % occur only at the nodes next
    # to the ends of slip and stick, where the slope of Carter's curve is infinite.
    _, coarse, _ = _error_of_carters_traction(share, 50)
    x, fine, force = _error_of_carters_traction(share, 100)
    assert np.abs(force) < 0.01
    assert fine.sum() / 100 < 0.55 * coarse.sum() / 50
    assert fine.sum() / 100 < 4e-3
    ends = np.min(np.abs(x[:, None] - [-1.0, 2.0 * share - 1.0, 1.0]), axis=1)
    assert fine[ends > 2.5 * 0.02].max() < 0.01


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"core_radius": 0.0, "layers": [SOFT]}, "core_radius must be > 0 m .without a core"),
        ({"core_radius": -1.0, "layers": [SOFT]}, "core_radius must be > 0 m, got -1"),
        ({"core_radius": 1.0, "layers": [3.0]}, r"layers\[0\] must be a viscoroll.Layer"),
    ],
)
def test_bad_cylinders(arguments, message):
    with pytest.raises((ValueError, TypeError), match=message):
        vr.CoatedCylinder(**arguments)


@pytest.mark.parametrize(
    ("roller", "given", "message"),
    [
        (STEEL, {}, "layers must be a list of at least one layer unless on.layers or on.base"),
        (ROLLER, {"load": -1.0}, "load must be > 0 N/m, got -1"),
        (ROLLER, {"load": 1e9}, "load must be small enough for the coating, got 1e[+]09 N/m .the roller"),
        (ROLLER, {"curvature": enums.Curvature.EXACT}, "curvature must be left out for a roller"),
        (ROLLER, {"patch_load": enums.PatchLoad.SPHERICAL}, "patch_load must be FLAT for a roller"),
        (
            ROLLER,
            {"mesh": vr.Mesh(nodes_per_revolution=1000, theta_nodes_per_revolution=500)},
            "mesh.theta_nodes_per_revolution must be left out for a roller",
        ),
        (
            STEEL,
            {"on": HALF_PLANE, "compliance": enums.Compliance.VERTICAL},
            "compliance must be RADIAL if the counterbody deforms",
        ),
        (ROLLER, {"on": vr.Groove(radius=0.1, path_radius=0.1)}, "on.radius must be left out under a roller"),
        (
            ROLLER,
            {"on": vr.Groove(path_radius=0.0605)},
            "on.path_radius must be at least 2 % larger than the radius of the roller",
        ),
        (
            STEEL,
            {"on": HALF_PLANE, "mesh": vr.Mesh(nodes_per_revolution=1000, max_order=600)},
            "mesh.max_order must be left out with a deformable plane",
        ),
    ],
)
def test_bad_input(roller, given, message):
    with pytest.raises(ValueError, match=message):
        vr.solve(roller, **{"load": 5e3, "angular_speed": 1.0} | given)


def test_fast_rollers_with_mass_are_refused():
    heavy = vr.CoatedCylinder(
        core_radius=50e-3,
        layers=[vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.5, density=1000.0)],
    )
    critical = vr.modal.critical_speed(heavy)
    # Rayleigh wave of the short-time modulus, 0.9553 of the shear wave's speed (ν = ½).
    assert critical == pytest.approx(0.9553 * np.sqrt(6e6 / 1000.0) / 60e-3, rel=1e-3)
    with pytest.raises(ValueError, match="angular_speed must be below the critical speed"):
        vr.solve(heavy, load=5e3, angular_speed=1.01 * critical)


def test_studies_of_rollers_have_units_per_length():
    study = vr.sweep(ROLLER, load=[4e3, 5e3], angular_speed=1.0, accuracy=0.05)
    assert study["load"].attrs["units"] == "N/m"
    assert study["resisting_torque"].attrs["units"] == "N m/m"
    assert study["bulk_power"].attrs["units"] == "W/m"


def test_case_files_with_cylinders(tmp_path):
    from viscoroll.case import load_case

    path = tmp_path / "roller.toml"
    path.write_text(
        """
        [cylinder]
        core_radius = 50e-3
        [[cylinder.layers]]
        thickness = 10e-3
        poisson_ratio = 0.5
        shear_modulus = { type = "standard_linear_solid", instantaneous_modulus = 6e6, relaxed_modulus = 3e6,
                          relaxation_time = 0.125 }
        [rolling]
        load = 5e3
        angular_speed = 1.0
        """.replace("relaxed_modulus = 3e6,\n                          ", "relaxed_modulus = 3e6, ")
    )
    case = load_case(path)
    assert case.body == ROLLER
    path.write_text("[rolling]\nload = 1.0\nangular_speed = 1.0\n")
    with pytest.raises(ValueError, match="one of ball, cylinder, wheel must be given, got none"):
        load_case(path)
