"""Balls on planes and in grooves: independent computations, exact relations, and the power dissipated in each body."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from viscoroll import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    CoatedWheel,
    Drive,
    Elastic,
    Groove,
    HalfSpace,
    Layer,
    Mesh,
    RollingModel,
    StandardLinearSolid,
    solve,
    sweep,
)
from viscoroll.case import build_case
from viscoroll.enums import Compliance

RADIUS = 21e-3
RUBBER = StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
LAYER = Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
RIGID = CoatedSphere(core_radius=RADIUS)
SOFT = CoatedSphere(core_radius=20e-3, layers=[LAYER])
MAT = CoatedPlane(layers=[LAYER])
MESH = Mesh(nodes_per_revolution=1500)


def rolled(ball, on, *, load=100.0, speed=52.5e-3, mesh=MESH, **options):
    return solve(ball, on=on, load=load, angular_speed=speed / RADIUS, mesh=mesh, threads=1, **options)


@pytest.mark.parametrize(
    ("speed", "base", "moment"),
    # Moments of independent computations with the gap of a paraboloid; one of them is tests/reference/rolling_plane.py.
    [
        (2.1e-3, None, 20.10e-3),
        (10.5e-3, None, 31.41e-3),
        (52.5e-3, None, 11.179e-3),
        (210e-3, None, 3.109e-3),
        (52.5e-3, 1e7, 4.405e-3),
    ],
)
@pytest.mark.filterwarnings("ignore:the strain")  # both computations use linear theory
def test_rigid_ball_on_a_layer(speed, base, moment):
    plane = CoatedPlane(
        layers=[LAYER],
        base=None if base is None else HalfSpace(shear_modulus=Elastic(modulus=base), poisson_ratio=0.5),
    )
    r = rolled(RIGID, plane, speed=speed, mesh=Mesh(nodes_per_revolution=2400))
    assert r.resisting_torque == pytest.approx(moment, rel=2e-3)
    assert r.driving_torque == 0.0  # the pressure is normal to the ball
    assert r.driving_force * RADIUS == pytest.approx(r.resisting_torque, rel=1e-12)
    assert r.energy_balance_error < 1e-3
    assert r.rolling_bulk_power == 0.0
    assert r.rolling_resistance_coefficient == pytest.approx(r.counterbody_bulk_power / (100.0 * speed), rel=1e-12)


@pytest.mark.parametrize(
    ("s", "torque", "depth"), [(0.1, 0.0850, 1.5806), (0.5, 0.1992, 1.4859), (2.0, 0.1256, 1.2585)]
)
def test_viscoelastic_half_space(s, torque, depth):
    # An independent computation gives T / (P a_0) and d R / a_0^2 for s = V tau / a_0, where a_0 is Hertz's contact
    # radius for G_0; a/R = 0.03.
    load = 0.3
    a = (3.0 * load * RADIUS / (16.0 * 6e6)) ** (1 / 3)
    ground = CoatedPlane(base=HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
    r = rolled(RIGID, ground, load=load, speed=s * a / 0.125, mesh=Mesh(nodes_per_revolution=6000))
    assert r.resisting_torque / (load * a) == pytest.approx(torque, rel=2e-3)
    assert r.penetration * RADIUS / a**2 == pytest.approx(depth, rel=2e-3)


def test_compliances_add_up_exactly():
    # If the ball's coating were flat, ball and mat would act as one plane of twice the compliance. The ball's equations
    # include the curvature of the coating, so the results differ a little.
    half = StandardLinearSolid(instantaneous_modulus=3e6, relaxed_modulus=1.5e6, relaxation_time=0.125)
    both = rolled(SOFT, MAT)
    one = rolled(RIGID, CoatedPlane(layers=[Layer(thickness=1e-3, shear_modulus=half, poisson_ratio=0.5)]))
    curved = rolled(SOFT, None).resisting_torque / rolled(RIGID, MAT).resisting_torque
    assert both.resisting_torque / one.resisting_torque == pytest.approx(math.sqrt(curved), rel=2e-3)


@pytest.mark.parametrize("speed", [2.1e-3, 52.5e-3, 210e-3])
def test_power_balance_of_each_body(speed):
    # The fine mesh has more than 100 nodes across. The deviations of both balances are errors of the mesh.
    errors = []
    for nodes in (600, 2400):
        r = rolled(SOFT, MAT, speed=speed, mesh=Mesh(nodes_per_revolution=nodes))
        own = r.driving_torque * r.angular_speed / r.rolling_bulk_power - 1.0
        counterbody = r.driving_force * speed / r.counterbody_bulk_power - 1.0
        assert r.bulk_power == pytest.approx(r.rolling_bulk_power + r.counterbody_bulk_power, rel=1e-12)
        errors.append(np.abs([own, counterbody]))
    assert r.contact.any(axis=1).sum() > 100
    assert np.all(errors[-1] < 1e-3)
    assert errors[-1].max() < 0.25 * errors[0].max()


def test_friction_too_small_for_the_rolling_resistance_is_rejected_with_the_range_of_forces():
    # The mat resists with 0.53 N, and friction supports 0.3 N.
    message = r"drive\.force must be between 0\.\d+ N and 0\.\d+ N, otherwise the ball slides permanently, got 0 N"
    with pytest.raises(ValueError, match=message):
        rolled(RIGID, MAT, friction=0.003, mesh=Mesh(nodes_per_revolution=600))
    assert rolled(RIGID, MAT, friction=0.02, mesh=Mesh(nodes_per_revolution=600)).driving_force == 0.0


@pytest.mark.parametrize("drive", [Drive(torque=0.0), Drive(force=0.0), Drive(creepage=0.0, spin=5.0)])
def test_rigid_ball_on_a_plane_with_friction(drive):
    # 43 nodes across.
    r = rolled(RIGID, MAT, friction=0.3, drive=drive, mesh=Mesh(nodes_per_revolution=1120))
    assert int(r.contact.any(axis=1).sum()) >= 40
    assert r.energy_balance_error < 1e-2
    if drive.torque == 0.0:
        assert abs(r.driving_torque) < 1e-8
        assert r.driving_force == pytest.approx(0.466, rel=1e-2)  # independent computation on its own mesh
    if drive.force == 0.0:
        assert abs(r.driving_force) < 1e-8


def test_two_soft_bodies_with_friction():
    for drive in (Drive(torque=0.0), Drive(force=0.0)):
        r = rolled(SOFT, MAT, friction=0.3, drive=drive, mesh=Mesh(nodes_per_revolution=600))
        assert r.energy_balance_error < 1e-2
        given = r.driving_torque if drive.torque is not None else r.driving_force * RADIUS
        assert abs(given) < 1e-8 * r.resisting_torque


@pytest.mark.parametrize(
    ("drive", "name", "given"),
    [
        (Drive(torque=0.0), "driving_torque", 0.0),
        (Drive(torque=1e-3), "driving_torque", 1e-3),
        (Drive(force=0.0), "driving_force", 0.0),
        (Drive(force=0.5), "driving_force", 0.5),
        (Drive(creepage=0.03), "creepage", 0.03),
    ],
)
def test_results_contain_the_prescribed_value_of_the_drive_exactly(drive, name, given):
    r = rolled(SOFT, MAT, friction=0.05, drive=drive, mesh=Mesh(nodes_per_revolution=600))
    assert getattr(r, name) == r.scalars()[name] == given


def test_creepage_of_free_rolling_depends_on_which_body_deforms():
    # An incompressible surface lengthens in contact. A coating on the ball moves the center ahead; one on the plane
    # makes it lag.
    free = {"friction": 1.0, "mesh": Mesh(nodes_per_revolution=600)}
    assert rolled(SOFT, None, **free).creepage > 1e-3
    assert rolled(RIGID, MAT, **free).creepage < -1e-3


KALKER_MODULUS, KALKER_RADIUS = 1e6, 20e-3
HARD = Elastic(modulus=KALKER_MODULUS)
ON_GROUND = {
    "body": CoatedSphere(core_radius=KALKER_RADIUS),
    "on": CoatedPlane(base=HalfSpace(shear_modulus=HARD, poisson_ratio=0.5)),
}
THICKLY_COATED = {
    "body": CoatedSphere(
        core_radius=0.5 * KALKER_RADIUS,
        layers=[Layer(thickness=0.5 * KALKER_RADIUS, shear_modulus=HARD, poisson_ratio=0.5)],
    ),
    "on": None,
}


def kalker(pair, ratio, across):
    """Return C_23, C_32, C_33, scaled by the mean radius of the contact.

    `ratio` is R / a, and `across` is the number of nodes across the contact; nu = 1/2.
    """
    modulus, radius = KALKER_MODULUS, KALKER_RADIUS
    a = radius / ratio
    mesh = Mesh(nodes_per_revolution=round(np.pi * ratio * across))
    model = RollingModel(pair["body"], on=pair["on"], angular_speed=1.0, mesh=mesh, threads=1)
    load = 16 / 3 * modulus * a**3 / radius
    spin = 1e-6 / a
    sideways = model.solve(load=load, friction=math.inf, drive=Drive(creepage=0.0, lateral_creepage=1e-6))
    spinning = model.solve(load=load, friction=math.inf, drive=Drive(creepage=0.0, spin=spin))
    free = model.solve(load=load, friction=math.inf, drive=Drive(creepage=0.0))
    mean = math.sqrt(spinning.contact_area / math.pi)
    scale = 2.0 * modulus * mean**3
    return np.abs(
        [
            (spinning.lateral_force - free.lateral_force) / (scale * spin),
            sideways.spin_moment / (scale * 1e-6),
            spinning.spin_moment / (scale * mean * spin),
        ]
    )


# With full stick on elastic bodies, the power in the denominator of the error is nearly zero.
@pytest.mark.filterwarnings("ignore:the relative error of the power balance")
@pytest.mark.parametrize(
    ("pair", "ratio"), [(ON_GROUND, 40), (THICKLY_COATED, 160)], ids=["half-space", "thick coating"]
)
def test_kalkers_coefficients_of_spin(pair, ratio):
    # J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), table E3, nu = 1/2, circle; the other
    # body is rigid.
    exact = np.array([1.63, 1.63, 1.16])
    coarse, fine = kalker(pair, ratio, 20), kalker(pair, ratio, 40)
    # The mesh of a coated ball is curved, so C_23 and C_32 differ slightly.
    assert fine[0] == pytest.approx(fine[1], rel=1e-6 if pair is ON_GROUND else 1e-4)
    np.testing.assert_allclose(fine[:2], exact[:2], rtol=0.03)
    assert fine[2] == pytest.approx(exact[2], rel=0.05)
    assert np.all(np.abs(fine - exact) < np.abs(coarse - exact))


def test_straight_groove():
    flat = rolled(SOFT, None)
    wide = rolled(SOFT, Groove(radius=1e6))
    assert wide.resisting_torque == pytest.approx(flat.resisting_torque, rel=1e-6)
    close = rolled(SOFT, Groove(radius=30e-3))
    assert close.semi_axis_z > 1.3 * close.semi_axis_x
    assert close.resisting_torque < flat.resisting_torque
    assert close.energy_balance_error < 1e-3
    assert rolled(SOFT, Groove(radius=-30e-3)).semi_axis_z < flat.semi_axis_z
    rubbing = rolled(SOFT, Groove(radius=30e-3), friction=0.3, mesh=Mesh(nodes_per_revolution=600))
    assert rubbing.energy_balance_error < 1e-2


def test_power_balance_in_a_dish():
    r = rolled(SOFT, Groove(radius=60e-3, path_radius=60e-3))
    relative = 1.0 / (1.0 / RADIUS - 1.0 / 60e-3)
    assert r.driving_torque == pytest.approx(r.resisting_torque * RADIUS / relative, rel=1e-12)
    # The power is the torque times V / R_relative, with an error of 2.4e-4 on this mesh. If the slope of the gap were
    # not the moment arm of the pressure, terms of (a/R)^2 would leave 2.7e-3.
    assert r.bulk_power == pytest.approx(52.5e-3 * r.resisting_torque / relative, rel=5e-4)


def test_power_balance_in_close_rigid_grooves():
    # In a close fit, the gap is a small difference of two circles. Terms of (a/R)^2 that are missing in one of them
    # grow by 1 / (1 - R/rho), and would cause errors of 5 and 4 %; the mesh causes 0.1 and 0.5 %.
    mesh = Mesh(nodes_per_revolution=600)
    assert rolled(SOFT, Groove(radius=23e-3, path_radius=23e-3), mesh=mesh).energy_balance_error < 3e-3
    layer = replace(LAYER, thickness=10e-3)
    wheel = CoatedWheel(core_radius=50e-3, layers=[layer], width=30e-3, crown_radius=0.1)
    r = solve(wheel, on=Groove(path_radius=68e-3), load=300.0, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=300))
    assert r.energy_balance_error < 1e-2


@pytest.mark.parametrize("layers", [[], [LAYER]])
@pytest.mark.parametrize("drive", [Drive(force=0.0), Drive(torque=0.0), Drive(creepage=5e-3)])
def test_dish_with_friction(drive, layers):
    # A dish is a raceway that rotates about its own axis: its surface is slower away from the middle, like the ball's.
    dish = Groove(radius=40e-3, path_radius=80e-3, layers=layers)
    r = rolled(SOFT, dish, friction=0.3, drive=drive, mesh=Mesh(nodes_per_revolution=900))
    assert r.slip_power > 0.0
    assert r.energy_balance_error < 3e-3
    for name, value in {"force": r.driving_force * RADIUS, "torque": r.driving_torque}.items():
        if getattr(drive, name) is not None:
            assert abs(value) < 1e-8 * r.resisting_torque


@pytest.mark.parametrize("ball", [RIGID, SOFT])
def test_towing_power_of_a_ball_is_dissipated(ball):
    # The mat passes at the speed of the center, not at that of the ball's surface.
    r = rolled(ball, MAT, load=200.0, friction=0.4, drive=Drive(torque=0.0))
    assert r.creepage < -1e-3
    assert r.driving_force / 200.0 == pytest.approx(r.rolling_resistance_coefficient, rel=3e-3)


def test_power_is_dissipated_in_both_directions_of_the_mat():
    # The whole contact slides, and the center moves equally fast in both directions.
    forth, back = (
        rolled(SOFT, MAT, friction=0.3, drive=Drive(creepage=creepage), mesh=Mesh(nodes_per_revolution=600))
        for creepage in (-0.5, -1.5)
    )
    assert back.counterbody_bulk_power > 0.0
    assert back.counterbody_bulk_power == pytest.approx(forth.counterbody_bulk_power, rel=2e-2)


def test_an_elastic_half_space_dissipates_nothing():
    ground = CoatedPlane(base=HalfSpace(shear_modulus=Elastic(modulus=1e7), poisson_ratio=0.3))
    r = rolled(RIGID, ground, mesh=Mesh(nodes_per_revolution=600))
    assert abs(r.resisting_torque) < 1e-9 * 100.0 * r.semi_axis_x
    assert r.bulk_power < 1e-9
    assert r.strain == pytest.approx(r.penetration / r.semi_axis_x, rel=0.05)
    coated = rolled(RIGID, CoatedPlane(layers=[LAYER], base=ground.base), mesh=Mesh(nodes_per_revolution=600))
    width = math.sqrt(coated.semi_axis_x * coated.semi_axis_z)
    assert coated.strain == pytest.approx(coated.penetration / (1e-3 + 0.3 * width), rel=1e-12)  # 3 MPa on 10 MPa


def test_accuracy_refines_a_pair():
    r = solve(RIGID, on=MAT, load=100.0, angular_speed=2.5, accuracy=0.02, threads=1)
    assert r.status.name == "CONVERGED"
    assert r.error_estimate < 0.02
    assert r.resisting_torque == pytest.approx(11.16e-3, rel=5e-3)
    assert r.strain == pytest.approx(r.penetration / 1e-3, rel=1e-12)


def test_model_and_sweep_share_tables():
    model = RollingModel(RIGID, on=MAT, angular_speed=2.5, mesh=Mesh(nodes_per_revolution=600), threads=1)
    one = model.solve(load=50.0)
    assert one.on is MAT
    data = sweep(
        RIGID,
        on=[MAT, CoatedPlane(layers=[LAYER, LAYER])],
        load=[50.0],
        angular_speed=2.5,
        mesh=Mesh(nodes_per_revolution=600),
    )
    torques = data["resisting_torque"].values.ravel()
    assert torques[0] == pytest.approx(one.resisting_torque, rel=1e-9)
    assert torques[1] > torques[0]


def test_case_file():
    rubber = {
        "type": "standard_linear_solid",
        "instantaneous_modulus": 6e6,
        "relaxed_modulus": 3e6,
        "relaxation_time": 0.125,
    }
    layer = {"thickness": 1e-3, "shear_modulus": rubber, "poisson_ratio": 0.5}
    stone = {"type": "elastic", "modulus": 1e7}
    document = {
        "ball": {"core_radius": RADIUS},
        "plane": {
            "layers": [layer],
            "base": {"shear_modulus": stone, "poisson_ratio": 0.5},
        },
        "rolling": {"load": 100.0, "angular_speed": 2.5},
        "numerics": {"nodes_per_revolution": 600},
    }
    case = build_case(document, None)
    assert isinstance(case.on, CoatedPlane)
    assert case.on.base.shear_modulus == Elastic(modulus=1e7)
    del document["plane"]
    document["groove"] = {"radius": 0.03, "layers": [layer]}
    assert build_case(document, None).on == Groove(radius=0.03, layers=[LAYER])
    with pytest.raises(ValueError, match=r"at most one of plane, groove, .*, got plane and groove"):
        build_case(document | {"plane": {}}, None)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"on": None}, "two rigid bodies"),
        (
            {"on": CoatedPlane()},
            r"layers must be a list of at least one layer.*on\.base of the counterbody is given, got two rigid bodies",
        ),
        ({"on": Groove(radius=0.1)}, "two rigid bodies"),
        (
            {"on": Groove(radius=0.021, layers=[LAYER])},
            r"on\.radius must be at least 2 % larger than the radius of the ball",
        ),
        ({"on": CoatedCylinder(core_radius=0.1, layers=[LAYER])}, "on must be a CoatedPlane or a Groove"),
        ({"compliance": Compliance.VERTICAL}, "compliance must be RADIAL"),
        ({"mesh": Mesh(nodes_per_revolution=600, max_order=400)}, r"mesh\.max_order must be left out"),
        ({"load": 1e9}, "load must be small enough"),
    ],
)
def test_bad_input(arguments, message):
    given = {"on": MAT, "load": 100.0, "angular_speed": 2.5, "mesh": Mesh(nodes_per_revolution=600)}
    with pytest.raises(ValueError, match=message):
        solve(RIGID, **given | arguments)


def test_bad_planes_are_named():
    with pytest.raises(ValueError, match=r"base\.poisson_ratio"):
        HalfSpace(shear_modulus=Elastic(modulus=1e7), poisson_ratio=0.7)
    straight = (
        r"groove\.{} must be finite and nonzero, or left out if the groove is straight in this direction, got {} m"
    )
    with pytest.raises(ValueError, match=straight.format("radius", "0")):
        Groove(radius=0.0)
    with pytest.raises(ValueError, match=straight.format("path_radius", "inf")):
        Groove(radius=0.1, path_radius=math.inf)
    with pytest.raises(ValueError, match=r"groove\.radius or groove\.path_radius must be given"):
        Groove()
    with pytest.raises(TypeError, match="on must be a viscoroll"):
        solve(RIGID, on=LAYER, load=1.0, angular_speed=1.0)
    with pytest.raises(ValueError, match=r"drive\.spin must be 0 without drive\.creepage"):
        Drive(torque=0.0, spin=1.0)
    heavy = Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5, density=1e6)
    with pytest.raises(ValueError, match="critical speed"):
        solve(RIGID, on=CoatedPlane(layers=[heavy]), load=1.0, angular_speed=200.0)
