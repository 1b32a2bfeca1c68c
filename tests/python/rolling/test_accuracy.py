"""Solves to a prescribed accuracy, which choose their own mesh."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import coated_ball
from viscoroll import enums, paper

PAPER = enums.Curvature.PAPER


@pytest.mark.parametrize("accuracy", [0.1, 0.03, 0.01])
@pytest.mark.parametrize("compliance", [enums.Compliance.RADIAL, enums.Compliance.VERTICAL])
def test_error_is_within_the_prescribed_accuracy(paper_ball, accuracy, compliance):
    r = vr.solve(paper_ball, load=100.0, angular_speed=2.5, accuracy=accuracy, compliance=compliance, curvature=PAPER)
    assert r.status is enums.Status.CONVERGED
    assert r.error_estimate <= accuracy
    # Converged on fine meshes (docs/theory/reference-values.md): 11.38 mN m, with the vertical compliance 11.19 mN m.
    converged = {enums.Compliance.RADIAL: 11.38e-3, enums.Compliance.VERTICAL: 11.19e-3}[compliance]
    assert r.resisting_torque == pytest.approx(converged, rel=accuracy)


def test_default_accuracy_is_one_percent(paper_ball):
    r = vr.solve(paper_ball, load=100.0, angular_speed=2.5)
    assert r.error_estimate <= 0.01
    assert r.error_estimate == r.refinements[-1].error_estimate
    nodes = [step.mesh.nodes_per_revolution for step in r.refinements]
    assert nodes == sorted(set(nodes))
    assert r.mesh == r.refinements[-1].mesh
    # The second mesh settles all results except the contact length, for which a third one follows.
    assert [step.error_estimate > 0.01 for step in r.refinements] == [True, False, False]
    assert r.contact_length_error <= 0.01


def test_accuracy_of_a_thousandth(paper_ball):
    """Compare with continuum limits from meshes up to pi/6600: 11.3867 mN m, and 11.1854 mN m with VERTICAL."""
    for compliance, limit in ((enums.Compliance.RADIAL, 11.3867e-3), (enums.Compliance.VERTICAL, 11.1854e-3)):
        r = vr.solve(paper_ball, load=100.0, angular_speed=2.5, accuracy=1e-3, compliance=compliance, curvature=PAPER)
        assert r.resisting_torque == pytest.approx(limit, rel=1e-4)
        assert r.error_estimate < 1e-3


def test_torque_is_a_smooth_function_of_load(paper_ball):
    """Nodes that join the contact one by one cause no steps: the exponent of the power law decreases steadily."""
    loads = np.geomspace(50.0, 60.0, 17)  # steps of 1.15 %, as for 200 loads over a decade
    torques = [
        vr.solve(paper_ball, load=load, angular_speed=2.5, accuracy=1e-3, compliance=enums.Compliance.RADIAL)
        for load in loads
    ]
    exponents = np.diff(np.log([r.resisting_torque for r in torques])) / np.diff(np.log(loads))
    assert (exponents <= np.minimum.accumulate(exponents) * 1.005).all()


def test_status_says_that_the_accuracy_was_not_reached():
    # The contact is narrower than the spacing of the finest allowed mesh.
    r = vr.solve(paper.ball(density=0.0), load=1e-13, angular_speed=2.5, accuracy=0.02)
    assert r.status is enums.Status.ACCURACY_NOT_REACHED
    assert r.error_estimate > 0.02


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")  # the accuracy may not be reached
@pytest.mark.parametrize("load", np.geomspace(1e-8, 1e-6, 9))
def test_error_estimates_compare_meshes_that_differ_enough(load):
    """A last mesh that is limited to 1e6 nodes is at least 1.5 times finer, else its change would say little."""
    meshes = vr.solve(paper.ball(density=0.0), load=load, angular_speed=2.5, accuracy=0.01).refinements
    nodes = np.array([step.mesh.nodes_per_revolution for step in meshes])
    assert (nodes[1:] >= 1.5 * nodes[:-1]).all()
    torques = np.array([step.resisting_torque for step in meshes])
    change = np.abs(np.diff(torques)) / np.maximum(torques[1:], torques[:-1])
    estimates = np.array([step.error_estimate for step in meshes[1:]])
    assert (estimates >= 0.999 * change * 0.5 / (1.0 - nodes[:-1] / nodes[1:])).all()


@pytest.mark.parametrize("load", [1.0, 30.0, 1000.0])
@pytest.mark.parametrize("thickness", [0.5e-3, 5e-3])
def test_any_size_of_contact(load, thickness):
    stiff = vr.StandardLinearSolid(instantaneous_modulus=60e6, relaxed_modulus=30e6, relaxation_time=0.125)
    ball = coated_ball(stiff, thickness=thickness, poisson_ratio=0.45)
    r = vr.solve(ball, load=load, angular_speed=5.0, accuracy=0.1)
    assert r.status is enums.Status.CONVERGED
    assert r.contact.sum() > 20


def test_lossless_coating_converges_in_penetration():
    r = vr.solve(coated_ball(vr.Elastic(modulus=3e6)), load=100.0, angular_speed=2.5)
    assert r.status is enums.Status.CONVERGED
    assert len(r.refinements) >= 2
