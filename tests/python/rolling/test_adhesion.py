"""Rolling contact with adhesion: closed forms, elastic bodies, power balance, input checks."""

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import analytic

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
ROLLER = vr.CoatedCylinder(core_radius=50e-3)
HALF_PLANE = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
MAT = vr.CoatedPlane(layers=[vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)])
BALL = vr.CoatedSphere(core_radius=21e-3)

SOFT = {"radius": 10e-3, "shear_modulus": 1e6, "poisson_ratio": 0.5}
SOFT_SPACE = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5))


@pytest.mark.parametrize("speed", [0.5, 0.05, 0.005])
@pytest.mark.parametrize("load", [5000.0, 100.0])
def test_roller_on_a_half_plane(load: float, speed: float) -> None:
    """The moment agrees with the closed form for an attraction of vanishing range, and the power balances."""
    adhesion = vr.Adhesion(work=1.0)
    found = vr.solve(ROLLER, on=HALF_PLANE, load=load, speed=speed, adhesion=adhesion, accuracy=0.005)
    exact = analytic.adhesive_hunter(
        load=load, speed=speed, radius=50e-3, shear_modulus=RUBBER, poisson_ratio=0.5, work=1.0
    )
    assert found.rolling_resistance_torque == pytest.approx(float(exact.moment), rel=0.005)
    assert found.resisting_torque == pytest.approx(float(exact.moment), rel=0.01)
    # The edge of the closed form lies within the cohesive zone.
    assert found.contact_length < 2.0 * exact.half_width < found.attracted_area
    # In fast rolling the moments of both edges almost cancel.
    is_fast = 0.125 * speed > float(exact.half_width)
    assert found.energy_balance_error < (4e-3 if is_fast else 1e-3)
    assert found.opening_energy_ratio == pytest.approx(2.0)
    assert found.closing_energy_ratio == pytest.approx(0.5)


@pytest.mark.parametrize("load", [200.0, 0.0, -200.0])
def test_elastic_roller(load: float) -> None:
    """An elastic roller has no torque, and the half-width of the closed form."""
    roller = vr.CoatedCylinder(core_radius=SOFT["radius"])
    mesh = vr.Mesh(nodes_per_revolution=6000)
    found = vr.solve(roller, on=SOFT_SPACE, load=load, angular_speed=1.0, adhesion=vr.Adhesion(work=10.0), mesh=mesh)
    exact = analytic.jkr_line(load=load, **SOFT, work=10.0)
    spacing = 2.0 * np.pi * SOFT["radius"] / mesh.nodes_per_revolution
    assert found.resisting_torque == 0.0
    # The contact of the closed form includes a part of the cohesive zone, 0.276 of 12.5 spacings.
    assert 0.5 * found.contact_length == pytest.approx(float(exact.half_width), abs=4.0 * spacing)


def test_largest_tension_of_a_roller() -> None:
    """The largest tension is that of the closed form, and larger ones are rejected with its value."""
    roller = vr.CoatedCylinder(core_radius=SOFT["radius"])
    options = {"on": SOFT_SPACE, "angular_speed": 1.0, "adhesion": vr.Adhesion(work=10.0)}
    exact = analytic.jkr_line(load=0.0, **SOFT, work=10.0).pull_off
    mesh = vr.Mesh(nodes_per_revolution=4000)
    assert vr.pull_off(roller, **options, mesh=mesh).load == pytest.approx(exact, rel=0.02)
    with pytest.raises(
        vr.InvalidInput, match=r"load must be > -2\d\d N/m, at which the roller lifts off, got -290 N/m"
    ):
        vr.solve(roller, **options, load=-290.0, mesh=mesh)


@pytest.mark.parametrize("works", [1.1, 1.5])
def test_elastic_roller_with_different_works(works: float) -> None:
    """An elastic roller dissipates the difference of the works: M = R (w_open - w_close)."""
    roller = vr.CoatedCylinder(core_radius=SOFT["radius"])
    adhesion = vr.Adhesion(work=10.0, separation_work=10.0 * works)
    found = vr.solve(roller, on=SOFT_SPACE, load=200.0, angular_speed=1.0, adhesion=adhesion, accuracy=0.005)
    assert found.resisting_torque == pytest.approx(SOFT["radius"] * 10.0 * (works - 1.0), rel=0.01)
    assert found.adhesion_power == pytest.approx(found.dissipated_power)


@pytest.mark.parametrize("load", [1.0, 0.0, -1.0])
def test_elastic_ball(load: float) -> None:
    """The approach of a ball tends to that of a short range; its error is proportional to the range."""
    ball, work = vr.CoatedSphere(core_radius=SOFT["radius"]), 0.1
    force = load * np.pi * work * SOFT["radius"]
    exact = analytic.jkr(load=force, **SOFT, work=work)
    approaches = [
        vr.solve(
            ball,
            on=SOFT_SPACE,
            load=force,
            angular_speed=1.0,
            adhesion=vr.Adhesion(work=work),
            mesh=vr.Mesh(nodes_per_revolution=nodes),
        ).penetration
        for nodes in (8000, 16000)
    ]
    size = exact.half_width**2 / SOFT["radius"]
    assert abs(approaches[1] - exact.approach) < 0.01 * size
    assert 2.0 * approaches[1] - approaches[0] == pytest.approx(float(exact.approach), abs=4e-3 * float(size))


def test_ball_on_a_mat_at_small_load() -> None:
    """The torque at 1 N and 0.1 N increases as in an independent computation, and the power balances."""
    adhesion = vr.Adhesion(work=0.05)
    # Increase of the torque and its uncertainty: NumPy program with Fourier kernels, plain and equivalent works.
    for load, increase, uncertainty in ((1.0, 0.011, 0.002), (0.1, 0.095, 0.015)):
        bare = vr.solve(BALL, on=MAT, load=load, angular_speed=2.5)
        found = vr.solve(BALL, on=MAT, load=load, angular_speed=2.5, adhesion=adhesion)
        assert found.resisting_torque / bare.resisting_torque - 1.0 == pytest.approx(increase, abs=uncertainty)
        assert found.energy_balance_error < 1e-3
        assert found.attracted_area > found.contact_area > bare.contact_area


def test_slow_rolling_is_refined_until_the_power_balances() -> None:
    """A ball rolls 1.2 % of the contact length in a relaxation time; its first mesh has a balance error of 0.8 %."""
    found = vr.solve(BALL, on=MAT, load=0.1, angular_speed=0.005, adhesion=vr.Adhesion(work=0.05), accuracy=0.05)
    assert found.refinements[0].energy_balance_error > 5e-3
    assert found.energy_balance_error < 2e-3
    # Two meshes with the same cohesive zones do not show the error of these zones, which the first mesh shows.
    assert found.error_estimate > 0.005


@pytest.mark.parametrize(("load", "error"), [(0.05, 1e-5), (-0.002, 2e-3)])
def test_given_penetration_returns_the_load(load: float, error: float) -> None:
    """A given penetration, also one without overlap, gives the load that leads to this penetration.

    The law follows from the contact on the mesh of twice the spacing, whose load differs at a given penetration. The
    difference is larger near the largest tension. It decreases to 1e-4 and 1e-5 with two and four times the nodes.
    """
    mesh = vr.Mesh(nodes_per_revolution=20000)
    options = {"on": MAT, "angular_speed": 0.5, "adhesion": vr.Adhesion(work=0.05), "mesh": mesh}
    by_load = vr.solve(BALL, **options, load=load)
    by_penetration = vr.solve(BALL, **options, penetration=by_load.penetration)
    assert by_penetration.load == pytest.approx(load, rel=error)
    assert by_penetration.resisting_torque == pytest.approx(by_load.resisting_torque, rel=error)


def test_zones_longer_than_a_thin_layer_are_a_warning() -> None:
    """The laws at the edges are those of a half-plane, so that the zones of a mesh must be short beside the layer."""
    thin = vr.CoatedPlane(layers=[vr.Layer(thickness=2e-6, shear_modulus=RUBBER, poisson_ratio=0.5)])
    options = {"on": thin, "load": 100.0, "angular_speed": 2.0, "mesh": vr.Mesh(nodes_per_revolution=500_000)}
    with pytest.warns(vr.ResultWarning, match=r"cohesive zones are 3\.\d+ times as long as .* the outermost layer"):
        vr.solve(ROLLER, **options, adhesion=vr.Adhesion(work=0.2))


def test_an_open_balance_is_a_warning() -> None:
    """In fast rolling the moments of the edges almost cancel in `resisting_torque`, but not in the power."""
    case = {"load": 100.0, "angular_speed": 1e3, "mesh": vr.Mesh(nodes_per_revolution=32_000)}
    with pytest.warns(vr.ResultWarning, match="rolling_resistance_torque, which follows from the dissipated power"):
        found = vr.solve(ROLLER, on=HALF_PLANE, **case, adhesion=vr.Adhesion(work=0.5))
    exact = analytic.adhesive_hunter(
        load=100.0, speed=50.0, radius=50e-3, shear_modulus=RUBBER, poisson_ratio=0.5, work=0.5
    )
    assert found.energy_balance_error > 0.05
    assert found.rolling_resistance_torque == pytest.approx(float(exact.moment), rel=0.02)


def test_identical_bodies() -> None:
    """Two identical rollers dissipate the same power, more than without adhesion, and the power balances."""
    layer = vr.Layer(thickness=2e-3, shear_modulus=RUBBER, poisson_ratio=0.45)
    roller = vr.CoatedCylinder(core_radius=48e-3, layers=[layer])
    adhesion = vr.Adhesion(work=0.5)
    pair = vr.solve(roller, on=roller, load=500.0, angular_speed=1.0, adhesion=adhesion)
    assert pair.energy_balance_error < 2e-3
    assert pair.rolling_bulk_power == pytest.approx(pair.counterbody_bulk_power, rel=1e-6)
    assert pair.resisting_torque > vr.solve(roller, on=roller, load=500.0, angular_speed=1.0).resisting_torque


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"work": 0.0}, "adhesion.work must be"),
        ({"work": 0.05, "separation_work": 0.04}, "adhesion.separation_work must be at least the work of adhesion"),
        ({"work": 0.05, "strength": 1e6, "range": 1e-8}, "adhesion.range must be left out if the strength is given"),
    ],
)
def test_rejected_adhesion(values: dict[str, float], message: str) -> None:
    """Values out of range are rejected."""
    with pytest.raises(vr.InvalidInput, match=message):
        vr.Adhesion(**values)


def test_friction_is_rejected() -> None:
    """The strength of an adhesive contact under shear is not known."""
    with pytest.raises(vr.InvalidInput, match="friction must be 0 with adhesion"):
        vr.solve(BALL, on=MAT, load=1.0, angular_speed=1.0, adhesion=vr.Adhesion(work=0.05), friction=0.3)


def test_wheels_are_rejected() -> None:
    """The faces of a wheel would detach first."""
    layer = vr.Layer(thickness=2e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
    wheel = vr.CoatedWheel(core_radius=20e-3, width=10e-3, crown_radius=30e-3, layers=[layer])
    with pytest.raises(vr.InvalidInput, match="adhesion must be left out for bodies with side faces"):
        vr.solve(wheel, load=1.0, angular_speed=1.0, adhesion=vr.Adhesion(work=0.05))


def test_sensitivities_are_rejected() -> None:
    """Sensitivities keep the nodes in contact, which is not defined for the cohesive zone."""
    mesh = vr.Mesh(nodes_per_revolution=3000)
    found = vr.solve(BALL, on=MAT, load=1.0, angular_speed=2.5, adhesion=vr.Adhesion(work=0.05), mesh=mesh)
    assert found.adhesion == vr.Adhesion(work=0.05)
    with pytest.raises(vr.InvalidInput, match="adhesion must be left out for sensitivities"):
        found.sensitivity()


def test_ordinary_results_estimate_the_adhesion_of_clean_surfaces() -> None:
    """The estimate agrees with a solution with adhesion, and is left out where it is small or does not apply."""
    case = {"on": MAT, "angular_speed": 0.05, "accuracy": 0.05}
    bare = vr.solve(BALL, load=0.1, **case)
    clean = vr.solve(BALL, load=0.1, adhesion=vr.Adhesion(work=0.05), **case)
    increase = clean.rolling_resistance_torque / bare.rolling_resistance_torque - 1.0
    assert bare.clean_adhesion_increase == pytest.approx(increase, rel=0.3)
    assert "torque increase if clean surfaces adhere" in str(bare)
    assert clean.clean_adhesion_increase is None
    heavy = vr.solve(BALL, load=100.0, **case)
    assert heavy.clean_adhesion_increase is None
    assert "adhere" not in str(heavy)
