"""The first lines of a result: the coefficient, the torques, the creepage, the warnings, and the error estimate."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import enums

EXAMPLE = {"load": 100.0, "angular_speed": 0.2, "friction": 0.3, "mesh": vr.Mesh(nodes_per_revolution=200)}

DRIVES = [
    vr.Drive(force=0.0),
    vr.Drive(force=10.0),
    vr.Drive(torque=0.0),
    vr.Drive(creepage=0.0),
    vr.Drive(creepage=0.01, lateral_creepage=0.02),
]


def elastic_ball(core_radius, thickness):
    layer = vr.Layer(thickness=thickness, shear_modulus=vr.Elastic(modulus=1e6), poisson_ratio=0.5)
    return vr.CoatedSphere(core_radius=core_radius, layers=[layer])


@pytest.mark.parametrize("drive", DRIVES, ids=str)
def test_coefficient_is_dissipated_energy_per_load_and_distance(paper_ball, drive):
    r = vr.solve(paper_ball, drive=drive, **EXAMPLE)
    expected = (r.bulk_power + r.slip_power) / (r.load * r.linear_speed)
    assert r.rolling_resistance_coefficient == pytest.approx(expected, rel=1e-14)


def test_coefficient_of_a_towed_ball_is_its_drag_per_load(paper_ball):
    # Without a torque, the force alone supplies the dissipated power. The tolerance is the error of the power balance.
    r = vr.solve(paper_ball, drive=vr.Drive(torque=0.0), **EXAMPLE | {"mesh": vr.Mesh(nodes_per_revolution=500)})
    assert r.rolling_resistance_coefficient == pytest.approx(r.driving_force / r.load, rel=5e-3)


def test_coefficient_where_the_center_stands_still(paper_ball):
    r = vr.solve(paper_ball, drive=vr.Drive(creepage=-1.0), **EXAMPLE)
    assert r.rolling_resistance_coefficient == np.inf


@pytest.mark.parametrize("drive", DRIVES, ids=str)
def test_statics_hold_with_the_radial_compliance(paper_ball, drive):
    """Pressure acts at its offset and tractions at the height of the plane, so T = T_r - Q H."""
    r = vr.solve(paper_ball, drive=drive, **EXAMPLE)
    moment = r.resisting_torque - r.driving_force * r.center_height
    # The contact conditions have a residual of 1e-10 of the load, and H is its moment arm.
    assert r.driving_torque == pytest.approx(moment, abs=1e-9 * r.load * r.center_height)


@pytest.mark.parametrize(("core_radius", "thickness", "load"), [(15e-3, 6e-3, 3.0), (6.3e-3, 14.7e-3, 0.3)])
@pytest.mark.parametrize("friction", [0.05, 0.3, 3.0])
def test_creepage_of_free_elastic_rolling(core_radius, thickness, load, friction):
    """The compliances RADIAL and VERTICAL give the same creepage to the order (a/R)^2, because slip includes u_r.

    Without u_r, the creepages would differ by 0.3 (a/R)^2 on the nearly solid ball (+0.19 in place of -0.11), and by a
    factor of two on the other. The remaining differences are of the order (a/R)^3, about 0.01 (a/R)^2 from the
    tractions, and the error of the mesh.
    """
    ball = elastic_ball(core_radius, thickness)
    case = {"load": load, "angular_speed": 1.0, "friction": friction, "mesh": vr.Mesh(nodes_per_revolution=900)}
    radial = vr.solve(ball, **case)
    full = vr.solve(ball, compliance=enums.Compliance.VERTICAL, **case)
    share = (radial.semi_axis_x / ball.outer_radius) ** 2
    assert radial.creepage == pytest.approx(full.creepage, abs=0.02 * share)


def test_a_coarse_mesh_is_a_warning(paper_ball):
    with pytest.warns(
        vr.ResultWarning, match=r"mesh is too coarse: 3 nodes across the contact \(recommended: at least 10\)"
    ) as caught:
        r = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=60))
    assert caught[0].filename == __file__  # the warning points at the call, not into the package
    assert list(r.warnings) == [enums.WarningKind.COARSE_MESH]
    assert "warning" in repr(r)
    assert r.scalars()["warnings"] == "COARSE_MESH"


def test_a_large_error_of_the_power_balance_is_a_warning():
    """A ball dissipates almost nothing if it slips in a ring that contains no node of this mesh."""
    layer = vr.Layer(thickness=2e-3, shear_modulus=vr.Elastic(modulus=3e6), poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    with pytest.warns(vr.ResultWarning, match=r"power balance is 0\.\d+ \(recommended: at most 0.05\), for a rolling"):
        r = vr.solve(ball, load=50.0, angular_speed=2.5, friction=0.3, mesh=vr.Mesh(nodes_per_revolution=400))
    assert list(r.warnings) == [enums.WarningKind.POWER_BALANCE]
    assert r.energy_balance_error > 0.05


def test_a_large_strain_is_a_warning(paper_ball):
    with pytest.warns(
        vr.ResultWarning, match=r"penetration / coating thickness, is 0\.2\d+ \(recommended: at most 0.2\)"
    ):
        r = vr.solve(paper_ball, load=300.0, angular_speed=2.5, accuracy=0.1)
    assert r.strain == pytest.approx(r.penetration / 1e-3, rel=1e-12)


def test_a_model_warns_too(paper_ball):
    model = vr.RollingModel(paper_ball, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=60))
    with pytest.warns(vr.ResultWarning, match="too coarse") as caught:
        model.solve(load=100.0)
    assert caught[0].filename == __file__


def test_a_good_result_has_no_warning(paper_ball):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert vr.solve(paper_ball, load=100.0, angular_speed=2.5, accuracy=0.1).warnings == {}


def test_the_same_mesh_is_not_solved_twice():
    """A large contact on a solid ball may need fewer nodes than the minimum, on coarse and fine meshes alike."""
    layer = vr.Layer(
        thickness=20e-3, shear_modulus=vr.materials.KelvinVoigt(modulus=1e6, viscosity=1e5), poisson_ratio=0.5
    )
    ball = vr.CoatedSphere(layers=[layer], inner_boundary=enums.InnerBoundary.SOLID)
    r = vr.solve(ball, load=600.0, angular_speed=1.0, accuracy=0.4)
    nodes = [step.mesh.nodes_per_revolution for step in r.refinements]
    assert len(set(nodes)) == len(nodes) >= 2
    assert r.refinements[1].error_estimate > 0.0


def test_the_error_estimate_includes_the_force_at_a_given_creepage():
    """In this case, torque and penetration converge on a mesh on which the force has an error of 4 %."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = vr.Layer(thickness=5e-3, shear_modulus=rubber, poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    case = {"load": 100.0, "angular_speed": 1.0, "friction": 0.3, "drive": vr.Drive(creepage=0.01)}
    coarse = vr.solve(ball, accuracy=0.1, **case)
    fine = vr.solve(ball, mesh=vr.Mesh(nodes_per_revolution=1200), **case)
    scale = max(abs(fine.driving_force), fine.resisting_torque / ball.outer_radius)
    assert abs(coarse.driving_force - fine.driving_force) / scale <= coarse.error_estimate


def slow_ball(relaxed_modulus, relaxation_time):
    material = {"instantaneous_modulus": 6e6, "relaxed_modulus": relaxed_modulus, "relaxation_time": relaxation_time}
    layer = vr.Layer(thickness=1e-3, shear_modulus=vr.StandardLinearSolid(**material), poisson_ratio=0.5)
    return vr.CoatedSphere(core_radius=20e-3, layers=[layer])


def test_a_material_that_relaxes_almost_completely_is_rejected():
    message = r"layers\[0\]\.shear_modulus must be such that .* at least 1e-05 times .* 0\.6 Pa, which is 1e-07 times"
    with pytest.raises(ValueError, match=message):
        vr.solve(slow_ball(0.6, 1e4), load=100.0, angular_speed=2.5)


def test_mesh_of_slowly_relaxing_materials_uses_the_stiffness_during_rolling():
    """A hundredth of the modulus remains after a day: the mesh is chosen for the stiff coating during rolling."""
    r = vr.solve(slow_ball(6e4, 1e5), load=10.0, angular_speed=2.5, accuracy=0.05)
    across = np.count_nonzero(r.contact.any(axis=1))
    assert 20 <= across <= 100
    assert r.status is enums.Status.CONVERGED


def test_a_study_counts_warnings(paper_ball):
    mesh = vr.Mesh(nodes_per_revolution=60)
    message = r"among 2 points: 2 COARSE_MESH, 1 LARGE_STRAIN; see warnings"
    with pytest.warns(vr.ResultWarning, match=message) as caught:
        study = vr.sweep(paper_ball, load=[100.0, 300.0], angular_speed=2.5, mesh=mesh, progress=False)
    assert len(caught) == 1
    assert caught[0].filename == __file__
    assert study.warnings.values.tolist() == ["COARSE_MESH", "COARSE_MESH, LARGE_STRAIN"]
