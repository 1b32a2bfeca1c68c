"""Results at finite strain: overspeed of the surface in the contact, and the torque that follows from it."""

import csv
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.case import example_text, load_case

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
COVER = vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
ROLLER = vr.CoatedCylinder(core_radius=40e-3, layers=[COVER])
BALL = vr.CoatedSphere(core_radius=20e-3, layers=[replace(COVER, thickness=1e-3)])
CASES = {
    "ball": (BALL, {"load": 100.0}),
    "roller": (ROLLER, {"load": 2e4}),
    "wheel": (vr.CoatedWheel(core_radius=40e-3, layers=[COVER], width=30e-3), {"load": 500.0}),
    "exact sphere": (BALL, {"load": 100.0, "curvature": "exact"}),
    "penetration": (ROLLER, {"penetration": 1e-3}),
}


def outer_difference(values, contact):
    """Return values at the front of a row minus those at its rear, at the sides of the outermost patches."""
    first, *_, last = np.flatnonzero(contact)
    return 0.5 * (values[first - 1] + values[first] - values[last] - values[last + 1])


@pytest.mark.parametrize(("body", "case", "nodes"), [(BALL, {"load": 100.0}, 800), (ROLLER, {"load": 2e4}, 3000)])
@pytest.mark.filterwarnings("ignore:depth")
def test_overspeed_is_the_stretch_of_the_surface(body, case, nodes):
    # The displacements inside the layers are summed by another module. They are extrapolated to the surface, where
    # u_r also moves the surface forward, by u_r x / r_o. Both extrapolations have errors of some percent.
    r = vr.solve(body, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=nodes), **case)
    spacing = body.outer_radius * r.mesh.spacing
    near, deep = r.interior(depth=[0.3 * spacing, 0.6 * spacing]).displacement.values[:2].swapaxes(0, 1)
    radial, along = 2.0 * near - deep
    forward = radial * r.x / body.outer_radius - along
    loads = r.pressure.sum(axis=0)
    stretch = [
        load * outer_difference(forward[:, k], r.contact[:, k]) / outer_difference(r.x[:, k], r.contact[:, k])
        for k, load in enumerate(loads)
        if load > 0.0
    ]
    assert r.overspeed == pytest.approx(np.sum(stretch) / loads.sum(), rel=0.02)


# Overspeed of linear theory on rollers of incompressible rubber that relaxes to half of its modulus, from the table
# in docs/theory/finite-strain.md, whose finite elements used the same loads.
@pytest.mark.parametrize(
    ("thickness", "speed", "strain", "known"),
    [(0.05, 0.004, 0.03, 0.0212), (0.25, 0.008, 0.03, 0.0161), (0.25, 0.008, 0.1, 0.0719), (1.0, 0.012, 0.1, 0.0582)],
)
@pytest.mark.filterwarnings("ignore")
def test_overspeed_of_rollers(thickness, speed, strain, known):
    rubber = vr.StandardLinearSolid(instantaneous_modulus=2.0, relaxed_modulus=1.0, relaxation_time=1.0)
    cover = vr.Layer(thickness=thickness, shear_modulus=rubber, poisson_ratio=0.5)
    roller = vr.CoatedCylinder(core_radius=1.0, layers=[cover])
    r = vr.solve(roller, penetration=strain * thickness, angular_speed=speed)
    assert r.overspeed == pytest.approx(known, rel=0.04)  # at the same load, strains differ by up to 3 %


@pytest.mark.parametrize("name", CASES)
def test_torque_at_finite_strain_is_that_of_a_faster_surface(name):
    # The torque at (1 + c) times the speed is interpolated, and the ratio is that of a coarser mesh (0.1 % noise).
    body, case = CASES[name]
    r = vr.solve(body, angular_speed=2.5, **case)
    faster = 1.0 + r.overspeed
    at_same_load = {key: value for key, value in case.items() if key != "penetration"} | {"load": r.load}
    linear = vr.solve(body, angular_speed=2.5 * faster, finite_strain=False, **at_same_load)
    assert r.finite_strain_torque == pytest.approx(faster * linear.resisting_torque, rel=3e-3)
    assert r.finite_strain_angular_speed == 2.5
    assert 0.0 < r.finite_strain_torque_error < 0.2


@pytest.mark.parametrize("name", ["ball", "roller", "wheel"])
def test_speed_of_the_ground(name):
    body, case = CASES[name]
    r = vr.solve(body, speed=0.1, **case)
    assert r.angular_speed == pytest.approx(0.1 / body.outer_radius, rel=1e-15)
    turning = (1.0 + r.overspeed) * body.outer_radius * r.finite_strain_angular_speed
    assert turning == pytest.approx(0.1, rel=1e-14)
    # The power at the axle is that of linear theory: the force against the speed of the ground needs no correction.
    power = r.finite_strain_torque * r.finite_strain_angular_speed
    assert power == pytest.approx(r.resisting_torque * r.angular_speed, rel=1e-14)
    again = vr.solve(body, angular_speed=r.finite_strain_angular_speed, **case)
    assert again.finite_strain_torque == pytest.approx(r.finite_strain_torque, rel=5e-3)


def test_a_model_has_the_results_of_solve():
    mesh = vr.Mesh(nodes_per_revolution=500)
    for speed in ({"angular_speed": 2.5}, {"speed": 0.05}):
        model = vr.RollingModel(BALL, mesh=mesh, **speed)
        for load in (50.0, 100.0):
            expected = vr.solve(BALL, load=load, mesh=mesh, **speed)
            assert model.solve(load=load).scalars() == expected.scalars()


def test_a_fine_given_mesh_is_corrected_on_a_coarser_one():
    found = [
        vr.solve(BALL, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=nodes))
        for nodes in (2000, 8000)
    ]
    ratios = [r.finite_strain_torque / r.resisting_torque for r in found]
    assert ratios[1] == pytest.approx(ratios[0], rel=2e-3)


def test_a_cover_without_loss_has_no_torque():
    cover = replace(COVER, shear_modulus=vr.Elastic(modulus=3e6))
    r = vr.solve(vr.CoatedCylinder(core_radius=40e-3, layers=[cover]), load=2e4, angular_speed=2.5)
    assert r.overspeed > 0.01
    assert abs(r.finite_strain_torque) < 1e-12 * r.load * r.contact_length


COVERED = ("strain", "raw ratio", "corrected ratio", "penetration ratio", "pressure ratio")

UNKNOWN = {
    "friction": {"friction": 0.3},
    "vertical compliance": {"compliance": "vertical"},
    "deformable plane": {"on": vr.CoatedPlane(layers=[COVER])},
    "left out": {"finite_strain": False},
}


@pytest.mark.parametrize("case", UNKNOWN.values(), ids=UNKNOWN)
def test_where_the_torque_at_finite_strain_is_not_known(case):
    r = vr.solve(BALL, load=50.0, angular_speed=2.5, accuracy=0.05, **case)
    assert r.model_error > 0.0
    for name in ("overspeed", "finite_strain_torque", "finite_strain_torque_error", "finite_strain_angular_speed"):
        assert getattr(r, name) is None, name


def test_errors_cover_finite_elements():
    # Rows of docs/finite-strain.md up to 20 % strain, computed by `python -m tests.campaign.finite_strain`.
    lines = (Path(__file__).parents[3] / "docs/recorded/finite-strain.csv").read_text(encoding="utf-8").splitlines()
    rows = [{name: float(row[name]) for name in COVERED} for row in csv.DictReader(lines)]
    rows = [row for row in rows if row["strain"] < 0.21]
    assert len(rows) == 180
    r = vr.solve(ROLLER, penetration=1e-3, angular_speed=2.5, accuracy=0.05)
    assert r.strain == pytest.approx(0.1, rel=1e-12)
    of_strain = r.finite_strain_torque_error - r.error_estimate
    assert of_strain == pytest.approx(0.5 * 0.1 + 4.0 * 0.1**3, rel=1e-12)
    assert r.model_error == pytest.approx((0.9 + 4.5 * 0.1) * 0.1, rel=1e-12)
    errors = {
        "corrected ratio": lambda strain: 0.5 * strain + 4.0 * strain**3,
        "raw ratio": lambda strain: (0.9 + 4.5 * strain) * strain,
        "penetration ratio": lambda strain: strain * r.penetration_model_error / 0.1,
        "pressure ratio": lambda strain: strain * r.max_pressure_model_error / 0.1,
    }
    for name, error in errors.items():
        covered = [abs(row[name] - 1.0) <= error(row["strain"]) for row in rows]
        assert np.mean(covered) > 0.95, name


def test_speed_and_angular_speed_exclude_each_other():
    def message(**case):
        with pytest.raises(vr.InvalidInput) as caught:
            vr.solve(BALL, load=50.0, **case)
        return str(caught.value)

    assert message() == "angular_speed must be given, or speed instead of it, got neither"
    assert message(angular_speed=1.0, speed=1.0) == "speed must be left out if the angular speed is given, got 1 m/s"
    with pytest.raises(vr.InvalidInput, match=r"^speed must be left out if the angular speed is given, got 1 m/s$"):
        vr.RollingModel(BALL, angular_speed=1.0, speed=1.0, mesh=vr.Mesh(nodes_per_revolution=200))
    with pytest.raises(vr.InvalidInput, match=r"^speed must be left out if the angular speed is given"):
        vr.sweep(BALL, load=[1.0], angular_speed=[1.0, 2.0], speed=0.1, progress=False)
    with pytest.raises(TypeError, match=r"^finite_strain must be a bool, got "):
        vr.solve(BALL, load=50.0, angular_speed=1.0, finite_strain=1)
    assert message(speed=-1.0) == "speed must be > 0 m/s, got -1"
    assert message(speed=1.0, friction=0.3) == "speed must be left out with friction, which determines it, got 1 m/s"


HEAVY = replace(COVER, density=1100.0)
HEAVY_BALL = vr.CoatedSphere(core_radius=20e-3, layers=[replace(HEAVY, thickness=1e-3)])
HEAVY_ROLLER = vr.CoatedCylinder(core_radius=40e-3, layers=[HEAVY])
HEAVY_WHEEL = vr.CoatedWheel(core_radius=40e-3, layers=[HEAVY], width=30e-3)
HEAVY_PLANE = vr.CoatedPlane(layers=[HEAVY])
RIGID_ROLLER = vr.CoatedCylinder(core_radius=50e-3)
MELTING = vr.Prony(instantaneous_modulus=6e6, weights=[0.5, 0.5], relaxation_times=[0.1, 1e5])
MELT = vr.CoatedCylinder(core_radius=40e-3, layers=[replace(COVER, shear_modulus=MELTING)])

# Rolling body, counterbody, and the limit of the speed of the ground [m/s].
LIMITS = {
    "ball": (HEAVY_BALL, None, vr.modal.critical_speed(HEAVY_BALL) * HEAVY_BALL.outer_radius),
    "roller": (HEAVY_ROLLER, None, vr.modal.critical_speed(HEAVY_ROLLER) * HEAVY_ROLLER.outer_radius),
    "wheel": (HEAVY_WHEEL, None, vr.modal.critical_speed(HEAVY_WHEEL) * HEAVY_WHEEL.outer_radius),
    "counterbody": (ROLLER, HEAVY_ROLLER, vr.modal.critical_speed(HEAVY_ROLLER) * HEAVY_ROLLER.outer_radius),
    "larger counterbody": (BALL, HEAVY_BALL, vr.modal.critical_speed(HEAVY_BALL) * HEAVY_BALL.outer_radius),
    "plane": (RIGID_ROLLER, HEAVY_PLANE, 0.95531 * (6e6 / 1100.0) ** 0.5),  # of Rayleigh waves
    "melt": (MELT, None, 10.0 * MELT.outer_radius),
}


@pytest.mark.parametrize("name", LIMITS)
def test_errors_about_the_speed_name_the_given_one(name):
    body, on, limit = LIMITS[name]
    speed = limit * (0.5 if name == "melt" else 2.0)
    mesh = vr.Mesh(nodes_per_revolution=400)

    def error_of(solve, **given):
        with pytest.raises(vr.InvalidInput) as caught:
            solve(body, on=on, **given)
        assert caught.value.parameter in given
        return caught.value

    def stated(error, unit):
        """Return the value of an error, the limit that its rule names, and the rule without the limit."""
        found = re.search(rf"([\d.e+-]+) {unit}", error.rule)
        return float(error.value.removesuffix(f" {unit}")), float(found[1]), error.rule.replace(found[0], "")

    radius = body.outer_radius
    value, limited, rule = stated(error_of(vr.solve, load=1.0, angular_speed=speed / radius), "rad/s")
    assert value == speed / radius
    assert limited == pytest.approx(limit / radius, rel=1e-4)
    first = error_of(vr.solve, load=1.0, speed=speed)
    assert stated(first, "m/s") == (speed, pytest.approx(limit, rel=1e-4), rule)
    assert str(error_of(vr.RollingModel, speed=speed, mesh=mesh)) == str(first)
    with pytest.warns(vr.ResultWarning):
        study = vr.sweep(body, on=on, load=[1.0, 2.0], speed=speed, mesh=mesh, progress=False)
    assert study.error.values.tolist() == [f"InvalidInput: {first}"] * 2


def test_coupled_solutions_take_the_speed_of_the_ground():
    network = vr.materials.MasingNetwork(storage=3e6, critical_strain=0.01)
    soft = replace(COVER, shear_modulus=vr.materials.SofteningModulus(matrix=RUBBER, network=network))
    roller = vr.CoatedCylinder(core_radius=40e-3, layers=[soft])
    mesh = vr.Mesh(nodes_per_revolution=400)
    at_speed = vr.strain_softening(roller, load=2e4, speed=0.5, mesh=mesh)
    turning = vr.strain_softening(roller, load=2e4, angular_speed=10.0, mesh=mesh)
    assert at_speed.torque_bounds == pytest.approx(turning.torque_bounds, rel=1e-12)
    assert at_speed.result.finite_strain_angular_speed < 10.0
    shift = vr.materials.Arrhenius(activation_energy=60e3, reference_temperature=293.15)
    heat = {"load": 2e4, "mesh": mesh, "shift": shift, "conductivity": 0.2, "ambient": 293.15, "points": 4}
    turning, at_speed = (
        vr.self_heating(ROLLER, convection=500.0, **heat, **given) for given in ({"angular_speed": 2.0}, {"speed": 0.1})
    )
    assert at_speed.states[0].mean_temperature == pytest.approx(turning.states[0].mean_temperature, rel=1e-9)
    rule = r"^speed must be at most about [\d.]+ m/s for a steady temperature below .*, got 100 m/s: rolling dissipates"
    with pytest.raises(ValueError, match=rule):
        vr.self_heating(ROLLER, convection=1.0, **heat, speed=100.0)


def test_studies_and_case_files_take_the_speed_of_the_ground(tmp_path):
    study = vr.sweep(
        BALL, load=[50.0, 100.0], speed=[0.05, 0.1], mesh=vr.Mesh(nodes_per_revolution=500), progress=False
    )
    one = vr.solve(BALL, load=100.0, speed=0.1, mesh=vr.Mesh(nodes_per_revolution=500))
    assert float(study.finite_strain_torque.sel(load=100.0, speed=0.1)) == one.finite_strain_torque
    assert study.speed.attrs["units"] == "m/s"

    text = example_text()
    file = tmp_path / "case.toml"
    file.write_text(text.replace("angular_speed = 2.5", "speed = 0.1"), encoding="utf-8")
    case = load_case(file)
    assert case.arguments()["speed"] == 0.1
    assert "angular_speed" not in case.arguments()
    assert case.angular_speed == pytest.approx(0.1 / case.body.outer_radius, rel=1e-15)
    file.write_text(text.replace("angular_speed = 2.5", "angular_speed = 2.5\nspeed = 0.1"), encoding="utf-8")
    with pytest.raises(
        vr.InvalidInput, match=r"rolling.speed must be left out if the angular speed is given, got 0.1$"
    ):
        load_case(file)
