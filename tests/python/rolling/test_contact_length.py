"""Contact length: closed forms, continuity in the load, convergence, mirror images, and histories."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER
from viscoroll import analytic

RADIUS = 50e-3
MODULUS, POISSON = 3.8e6, 0.3
ELASTIC = {"shear_modulus": MODULUS, "poisson_ratio": POISSON}
HALF_SPACE = vr.CoatedPlane(base=vr.HalfSpace(**ELASTIC))
ROLLER = vr.CoatedCylinder(core_radius=RADIUS)
BALL = vr.CoatedSphere(core_radius=RADIUS)
SOFT = vr.Layer(thickness=2e-3, shear_modulus=RUBBER, poisson_ratio=0.5)


def hertz_line_length(load):
    return 2.0 * np.sqrt(4.0 * load * RADIUS * (1.0 - POISSON) / (2.0 * np.pi * MODULUS))


def hertz_ball_length(load):
    return 2.0 * (3.0 * load * RADIUS * (1.0 - POISSON) / (8.0 * MODULUS)) ** (1.0 / 3.0)


# Small loads: the curvature of the circle changes the length of Hertz's parabola by 3e-6.
@pytest.mark.parametrize("accuracy", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize("load", [10.0, 10.3, 10.7])
def test_roller_on_an_elastic_half_plane(accuracy, load):
    # The torque is zero, so that its relative error never settles at 1e-4.
    given = {"mesh": vr.Mesh(nodes_per_revolution=160000)} if accuracy < 1e-3 else {"accuracy": accuracy}
    r = vr.solve(ROLLER, on=HALF_SPACE, load=load, angular_speed=1.0, **given)
    assert r.contact_length == pytest.approx(hertz_line_length(load), rel=accuracy)
    assert r.contact_area == r.contact_length == 2.0 * r.semi_axis_x
    assert r.unit("contact_length") == "m"


@pytest.mark.parametrize("accuracy", [1e-2, 1e-3])
@pytest.mark.parametrize("load", [0.1, 0.11])
def test_ball_on_an_elastic_half_space(accuracy, load):
    r = vr.solve(BALL, on=HALF_SPACE, load=load, angular_speed=1.0, accuracy=accuracy)
    assert r.contact_length == pytest.approx(hertz_ball_length(load), rel=accuracy)
    assert r.contact_length_error < accuracy


@pytest.mark.parametrize("accuracy", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize(("ratio", "time"), [(2.0, 0.125), (2.0, 1e-3), (20.0, 1e-2), (20.0, 1e-3)])
def test_roller_on_hunters_half_plane(accuracy, ratio, time):
    """The relaxation length is 0.1 to 17 half-widths. The shorter it is, the steeper is the front of the pressure."""
    solid = vr.StandardLinearSolid(instantaneous_modulus=3e6 * ratio, relaxed_modulus=3e6, relaxation_time=time)
    ground = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=solid, poisson_ratio=0.5))
    r = vr.solve(ROLLER, on=ground, load=50.0, angular_speed=1.0, accuracy=accuracy)
    exact = analytic.hunter(load=50.0, speed=RADIUS, radius=RADIUS, shear_modulus=solid, poisson_ratio=0.5)
    assert r.contact_length == pytest.approx(2.0 * exact.half_width, rel=accuracy)


def test_length_has_no_steps_over_the_load():
    """The error is at most 0.01 spacings at each edge, while the nodes enter the contact one by one."""
    mesh = vr.Mesh(nodes_per_revolution=60000)
    model = vr.RollingModel(ROLLER, on=HALF_SPACE, angular_speed=1.0, mesh=mesh)
    loads = np.linspace(10.0, 11.5, 40)
    lengths = np.array([model.solve(load=load).contact_length for load in loads])
    spacing = 2.0 * np.pi * RADIUS / mesh.nodes_per_revolution
    exact = hertz_line_length(loads)
    assert np.ptp(exact) > 3.0 * spacing
    assert np.abs(lengths - exact).max() < 0.02 * spacing
    assert (np.diff(lengths) > 0.0).all()


def test_error_is_proportional_to_the_spacing():
    errors = []
    for nodes in (20000, 40000, 80000):
        model = vr.RollingModel(ROLLER, on=HALF_SPACE, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=nodes))
        loads = np.linspace(10.0, 12.0, 15)
        lengths = np.array([model.solve(load=load).contact_length for load in loads])
        errors.append(np.abs(lengths / hertz_line_length(loads) - 1.0).max())
    assert errors[1] / errors[0] == pytest.approx(0.5, abs=0.1)
    assert errors[2] / errors[1] == pytest.approx(0.5, abs=0.1)


@pytest.mark.parametrize("width", [10e-3, 3e-3])
def test_crowned_wheel(width):
    """The wide tread contains the contact, and the contact reaches the faces of the narrow one."""
    wheel = vr.CoatedWheel(core_radius=20e-3, layers=[SOFT], crown_radius=60e-3, width=width)
    case = {"load": 10.0, "angular_speed": 2.5}
    coarse, fine = (vr.solve(wheel, accuracy=accuracy, **case) for accuracy in (1e-2, 2e-3))
    assert (fine.face_distance == 0.0) == (width < 5e-3)
    assert coarse.contact_length == pytest.approx(fine.contact_length, rel=1e-2)
    assert coarse.contact_length_error < 1e-2


def test_exchanged_bodies_have_the_same_length():
    plane = vr.CoatedPlane(layers=[SOFT])
    layered = vr.CoatedCylinder(core_radius=RADIUS, layers=[SOFT])
    case = {"load": 200.0, "angular_speed": 1.0, "accuracy": 1e-4}
    both = vr.solve(layered, on=layered, **case)
    # The plane of symmetry is a rigid plane.
    alone = vr.solve(layered, **case)
    assert both.contact_length == pytest.approx(alone.contact_length, rel=1e-4)
    # A layer on the roller is curved, and its length differs by the order of its thickness over the radius.
    rolled = vr.solve(ROLLER, on=plane, **case)
    assert rolled.contact_length == pytest.approx(alone.contact_length, rel=0.04)


def test_printed_results_name_the_nip_length():
    r = vr.solve(ROLLER, on=HALF_SPACE, load=10.0, angular_speed=1.0)
    assert "nip length" in str(r)
    assert "nip length" in r._repr_html_()
    assert "contact area" not in r._repr_html_()
    assert "contact area" in vr.solve(BALL, on=HALF_SPACE, load=0.1, angular_speed=1.0)._repr_html_()


@pytest.mark.parametrize("body", [ROLLER, BALL])
def test_histories_settle_to_the_steady_length(body):
    plane = vr.CoatedPlane(layers=[SOFT])
    load = 200.0 if body is ROLLER else 5.0
    mesh = vr.Mesh(nodes_per_revolution=4000 if body is ROLLER else 1500)
    steady = vr.solve(body, on=plane, load=load, angular_speed=0.1, mesh=mesh)
    # The contact rolls over four times its length of fresh track.
    h = vr.roll(body, on=plane, mesh=mesh, time=[0.0, 3.0], distance=[0.0, 15e-3], load=load)
    spacing = 2.0 * np.pi * RADIUS / mesh.nodes_per_revolution
    # Both have the uncertainty of a contact of 20 nodes; the history is an average over phase-shifted meshes.
    assert h.contact_length[-1] == pytest.approx(steady.contact_length, abs=0.5 * spacing)
    assert h.units["contact_length"] == "m"


def test_length_of_a_body_that_has_lifted_off():
    plane = vr.CoatedPlane(layers=[SOFT])
    history = vr.RollingHistory(ROLLER, on=plane, load=200.0, mesh=vr.Mesh(nodes_per_revolution=2000))
    assert history.current.contact_length > 0.0
    assert history.advance(time=0.2, distance=0.0, load=0.0).contact_length == 0.0
