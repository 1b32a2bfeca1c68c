"""Closed forms that apply to a pair of bodies, against the solver in the classic cases of rolling contact."""

from __future__ import annotations

import pytest
import viscoroll as vr
from viscoroll.analytic import applicable

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.0125)
HALF_SPACE = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
STEEL = vr.Layer(thickness=10e-3, shear_modulus=80e9, poisson_ratio=0.3)
BALL = vr.CoatedSphere(core_radius=10e-3)
STEEL_BALL = vr.CoatedSphere(layers=[STEEL])
ROLLER = vr.CoatedCylinder(core_radius=50e-3)
COVER = vr.Layer(thickness=10e-3, shear_modulus=RUBBER, poisson_ratio=0.45)
COVERED = vr.CoatedCylinder(core_radius=50e-3, layers=[COVER])


def thin_plane(thickness=0.2e-3):
    return vr.CoatedPlane(layers=[vr.Layer(thickness=thickness, shear_modulus=RUBBER, poisson_ratio=0.3)])


def solved(body, on, load, speed):
    """Return the torque of the solver, and the closed forms that are valid, at a small load without a large strain."""
    torque = vr.solve(body, on=on, load=load, angular_speed=speed, accuracy=0.005).resisting_torque
    forms = applicable(body, on=on)
    return torque, {name: float(form(load, speed)) for name, form in forms.items() if form.is_valid(load, speed)}


@pytest.mark.parametrize("speed", [0.05, 1.0, 5.0, 50.0])
def test_a_roller_on_a_half_plane_has_the_torque_of_hunter(speed):
    """Hunter's solution is exact; the tolerance is that of the mesh."""
    torque, forms = solved(ROLLER, HALF_SPACE, 500.0, speed)
    assert forms["hunter"] == pytest.approx(torque, rel=5e-3)


@pytest.mark.parametrize("ball", [BALL, STEEL_BALL])
@pytest.mark.parametrize(("speed", "tolerance"), [(0.05, 0.02), (5.0, 0.15)])
def test_a_steel_ball_on_a_half_space_has_the_torque_of_persson(ball, speed, tolerance):
    """Persson assumes the pressure at rest, which holds at low speed and is wrong by about a tenth at the peak.

    At the low speed, the surface travels 2 % of the contact radius within the relaxation time.
    """
    torque, forms = solved(ball, HALF_SPACE, 0.05, speed)
    assert set(forms) >= {"persson", "greenwood_tabor"}
    assert forms["persson"] == pytest.approx(torque, rel=tolerance)
    # All work of deformation, of which a fraction is dissipated.
    assert forms["greenwood_tabor"] > torque


@pytest.mark.parametrize("speed", [0.05, 5.0])
def test_a_ball_on_a_thin_layer_has_the_torque_of_springs(speed):
    """The tolerance is about the ratio of thickness to contact radius, 0.1, times that of the Winkler springs."""
    torque, forms = solved(vr.CoatedSphere(core_radius=20e-3), thin_plane(), 20.0, speed)
    assert forms["winkler"] == pytest.approx(torque, rel=5e-3)


@pytest.mark.parametrize(
    "pair",
    [
        (COVERED, vr.CoatedCylinder(core_radius=60e-3)),
        (vr.CoatedCylinder(core_radius=60e-3), COVERED),
        (COVERED, COVERED),
        (COVERED, vr.CoatedPlane(layers=[STEEL])),
    ],
)
def test_rollers_have_the_low_speed_form(pair):
    """A speed at which the surface moves by 1 % of the contact within the loss time; the torque is linear in it."""
    torque, forms = solved(*pair, 100.0, 0.005)
    assert forms["low_speed"] == pytest.approx(torque, rel=0.02)


def test_forms_of_thick_and_thin_layers_differ():
    assert set(applicable(BALL, on=HALF_SPACE)) == {"low_speed", "greenwood_tabor", "persson"}
    assert set(applicable(BALL, on=thin_plane())) == {"low_speed", "greenwood_tabor", "persson", "winkler"}
    assert set(applicable(ROLLER, on=HALF_SPACE)) == {"low_speed", "hunter"}
    assert set(applicable(ROLLER, on=thin_plane())) == {"low_speed", "hunter", "winkler_line"}


@pytest.mark.parametrize(
    "pair",
    [
        (STEEL_BALL, None),
        (STEEL_BALL, STEEL_BALL),
        (vr.CoatedSphere(layers=[COVER]), HALF_SPACE),
        (BALL, vr.CoatedPlane(layers=[COVER], base=HALF_SPACE.base)),
        (BALL, vr.Groove(radius=0.03, base=HALF_SPACE.base)),
    ],
)
def test_stiffness_decides_which_body_is_rigid(pair):
    """Bodies of similar stiffness have no form, except of one material on a rigid plane and of identical bodies."""
    forms = applicable(pair[0], on=pair[1])
    assert bool(forms) == (pair[0] is STEEL_BALL)
