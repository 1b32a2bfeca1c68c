"""States of stick and slip that are hard to find, inputs without a state, and independence of the order of frictions.

Each state was once missed or took minutes.
"""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import coated_ball
from viscoroll import enums

CASES = tomllib.loads((Path(__file__).parent / "friction_states.toml").read_text(encoding="utf-8"))


def rows(kind):
    return pytest.mark.parametrize("row", [pytest.param(row, id=row["name"]) for row in CASES[kind]])


def power_law(*, modulus, amplitude, time, exponent):
    """Return a spring parallel to a springpot, as a user's function."""
    return lambda omega: modulus + amplitude * (1j * time * omega) ** exponent


def layer(*, shear_modulus, **given):
    ((kind, parameters),) = shear_modulus.items()
    modulus = power_law if kind == "power_law" else getattr(vr.materials, kind)
    return vr.Layer(shear_modulus=modulus(**parameters), **given)


def solve(row):
    ball = vr.CoatedSphere(**row["ball"] | {"layers": [layer(**given) for given in row["ball"]["layers"]]})
    kinds = {"drive": vr.Drive, "mesh": vr.Mesh}
    given = {name: kinds[name](**value) if name in kinds else value for name, value in row["solve"].items()}
    return vr.solve(ball, **given)


def bounded_quantities(r):
    """Return the quantities that friction_states.toml may bound."""
    speed = np.hypot(*r.slip_velocity)
    slip_of_stuck = speed.max(initial=0.0, where=r.stick)
    slip_of_curvature = (r.semi_axis_x / r.body.outer_radius) ** 2 * r.angular_speed * r.body.outer_radius
    return {
        "contact": r.contact.sum(),
        "stick_share": r.stick.sum() / r.contact.sum(),
        "residual": r.residual,
        "iterations": r.iterations,
        "slip_of_stuck": slip_of_stuck / slip_of_curvature,
        "slip_of_stuck_relative": slip_of_stuck / speed.max(),
    }


@rows("state")
@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # strains of about a tenth
def test_hard_states_are_found(row):
    r = solve(row)
    assert r.status is enums.Status[row.get("status", "CONVERGED")]
    assert r.slip_power >= 0.0
    assert (np.hypot(*r.shear_traction) <= r.friction * r.pressure + 1e-8 * r.max_pressure).all()
    assert r.driving_force == row["solve"].get("drive", {}).get("force", r.driving_force)
    values = bounded_quantities(r)
    for name, bound in row.get("above", {}).items():
        assert values[name] > bound, name
    for name, bound in row.get("below", {}).items():
        assert values[name] < bound, name


@rows("rejected")
@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
def test_inputs_without_a_state_are_rejected(row):
    with pytest.raises(ValueError, match=row["message"]):
        solve(row)


def test_a_torque_is_found_from_states_at_prescribed_creepages():
    # Iterations from full stick and from zero friction do not reach this state. Those from states at prescribed
    # creepages do, and one of these states is reached only from a smaller friction.
    modulus = vr.Prony(
        instantaneous_modulus=719306705.8964465,
        weights=[
            0.11776874943618196,
            0.24953626248974753,
            0.10311469824515498,
            0.15961091109345082,
            0.0058231079540967,
        ],
        relaxation_times=[
            0.08246223585170435,
            0.022630251619810332,
            0.08977084313554048,
            0.00913250291033089,
            0.8836423948824675,
        ],
    )
    ball = coated_ball(
        modulus, thickness=8.29155541701685e-06, poisson_ratio=0.49999972521432157, core_radius=0.005190828126701303
    )
    options = {
        "load": 0.6328787337473702,
        "angular_speed": 0.0010937770860999462,
        "friction": 4.0,
        "patch_load": "SPHERICAL",
        "mesh": vr.Mesh(nodes_per_revolution=1193),
    }
    torque = 0.0022444622585602344
    r = vr.solve(ball, drive=vr.Drive(torque=torque), **options)
    assert r.driving_torque == pytest.approx(torque, rel=1e-9)
    assert -0.034 < r.creepage < -0.025
    given = vr.solve(ball, drive=vr.Drive(creepage=-0.032143), **options)
    assert given.status is enums.Status.CONVERGED
    assert (np.hypot(*given.shear_traction) <= 4.0 * given.pressure + 1e-8 * given.max_pressure).all()


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # large strain
def test_a_contact_that_fits_with_friction_if_it_fits_without():
    # With friction, the load was once rejected. The first contact is solved on every fourth node of the widest window,
    # and this coarse window was smaller than the contact.
    modulus = vr.StandardLinearSolid(instantaneous_modulus=1e6, relaxed_modulus=5e5, relaxation_time=0.1)
    ball = coated_ball(modulus, thickness=21e-3, poisson_ratio=0.3, core_radius=0.0, inner_boundary="SOLID")
    mesh = vr.Mesh(nodes_per_revolution=200)
    smooth, rough = (vr.solve(ball, load=500.0, angular_speed=2.5, friction=mu, mesh=mesh) for mu in (0.0, 0.3))
    assert rough.contact.sum() == pytest.approx(smooth.contact.sum(), rel=0.1)


def test_harmonics_that_exceed_the_memory_are_rejected_with_a_limit_of_max_order(paper_ball):
    mesh = vr.Mesh(nodes_per_revolution=400, max_order=200_000)
    with pytest.raises(
        ValueError,
        match=r"mesh\.max_order must be so small that .* at most .* values of harmonics and tables, got 200000",
    ):
        vr.solve(paper_ball, load=10.0, angular_speed=1.0, curvature="EXACT", mesh=mesh)


def test_results_of_a_model_do_not_depend_on_the_order_of_frictions():
    """A model computes the state of full stick once; each friction gives the same bits as a single solve."""
    given = {"load": 20.0, "angular_speed": 2.5}
    mesh = vr.Mesh(nodes_per_revolution=100)
    coefficients = [0.05, 0.3, 1.0]

    def on_a_model(order):
        model = vr.RollingModel(coated_ball(), angular_speed=given["angular_speed"], mesh=mesh)
        return {mu: model.solve(load=given["load"], friction=mu) for mu in order}

    upwards = on_a_model(coefficients)
    downwards = on_a_model(coefficients[::-1])
    for mu in coefficients:
        alone = vr.solve(coated_ball(), **given, friction=mu, mesh=mesh)
        for r in (upwards[mu], downwards[mu]):
            assert str(r.scalars()) == str(alone.scalars())
            np.testing.assert_array_equal(r.shear_traction, alone.shear_traction)


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # one node is a coarse mesh
@pytest.mark.parametrize("load", [1e-9, 1.12e-7])
def test_a_tiny_load_on_one_node(load):
    # At zero creepage, the tangential force on the sticking node is 6e5 times the load. One iteration removes it.
    # Iterations that changed forces by more than 1000 loads were once rejected, so that no state was found.
    ball = coated_ball(vr.Elastic(modulus=1.26e5), thickness=0.555e-3, poisson_ratio=0.5, core_radius=0.110145)
    mesh = vr.Mesh(nodes_per_revolution=93)
    r = vr.solve(ball, load=load, angular_speed=1.0, friction=0.366, compliance="VERTICAL", mesh=mesh)
    assert r.stick.sum() == r.contact.sum() == 1
    lag = 1.0 - np.sin(mesh.spacing) / mesh.spacing  # mean of 1 - cos(phi) over one spacing
    assert abs(r.driving_force) < 1e-8 * load
    assert r.creepage == pytest.approx(
        -lag, rel=1e-8
    )  # plus the ratio of penetration to radius, which is smaller than the tolerance
