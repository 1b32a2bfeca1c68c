"""Report of a result: the answer first, then how certain it is; and materials without loss."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.solution.scalars import PRECISION, SCALAR_GROUPS, SCALARS, label_of
from viscoroll.solution.text import ANSWER, LOSSLESS, result_sections, scalar_text

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
MESH = vr.Mesh(nodes_per_revolution=600)


def ball(shear_modulus=RUBBER):
    return vr.CoatedSphere(
        core_radius=20e-3, layers=[vr.Layer(thickness=1e-3, shear_modulus=shear_modulus, poisson_ratio=0.5)]
    )


def roller(shear_modulus=RUBBER):
    return vr.CoatedCylinder(
        core_radius=50e-3, layers=[vr.Layer(thickness=10e-3, shear_modulus=shear_modulus, poisson_ratio=0.5)]
    )


def test_every_scalar_has_a_group_and_known_error_estimates():
    assert set(SCALAR_GROUPS.values()) == {"answer", "friction", "certainty", "other"}
    for name, errors in PRECISION.items():
        assert all(error == "%" or SCALAR_GROUPS[error] == "certainty" for error in errors), name
    groups = [SCALAR_GROUPS[name] for name in SCALARS]
    assert groups == sorted(groups, key=["answer", "friction", "certainty", "other"].index)


def test_the_answer_comes_first():
    r = vr.solve(ball(), load=100.0, angular_speed=2.5, accuracy=0.05)
    sections = result_sections(r)
    assert [*sections] == ["answer", "how certain", "further results"]
    labels = [label for label, _ in sections[ANSWER]]
    assert labels == [
        "push force",
        "resisting torque at finite strain",  # nearer to reality than that of linear theory
        "drive torque of linear theory",
        "dissipated power",
        "rolling resistance coefficient",
        "contact length",
        "contact width",
        "penetration",
        "strain",
        "largest contact pressure",
    ]
    lines = repr(r).splitlines()
    assert lines[1].split() == ["push", "force", *scalar_text(r, "rolling_resistance_force").split()]
    assert "how certain:" in lines
    assert "nodes in contact, CONVERGED" in lines[-1]


def test_push_force_and_drive_torque_supply_the_dissipated_power():
    r = vr.solve(ball(), load=100.0, angular_speed=2.5, mesh=MESH, friction=0.3, drive=vr.Drive(torque=0.0))
    assert r.rolling_resistance_force == pytest.approx(r.dissipated_power / r.linear_speed, rel=1e-14)
    assert r.rolling_resistance_torque == pytest.approx(r.dissipated_power / 2.5, rel=1e-14)
    assert r.rolling_resistance_force == pytest.approx(r.rolling_resistance_coefficient * 100.0, rel=1e-14)
    # A towed body is driven by the force alone. The tolerance is the error of the power balance.
    assert r.rolling_resistance_force == pytest.approx(r.driving_force, rel=5e-3)


def test_errors_are_those_of_mesh_and_theory():
    r = vr.solve(ball(), load=100.0, angular_speed=2.5, accuracy=0.05)
    value, error = scalar_text(r, "rolling_resistance_torque").removesuffix(" mN m").split(" ± ")
    expected = (r.error_estimate + r.model_error) * r.rolling_resistance_torque * 1e3
    assert float(error) == pytest.approx(expected, rel=0.1)
    assert float(value) == pytest.approx(1e3 * r.rolling_resistance_torque, abs=0.1)
    assert scalar_text(r, "load") == "100 N"  # given


def test_a_roller_is_described_in_its_words():
    r = vr.solve(roller(), load=5e3, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=400))
    rows = dict(result_sections(r)[ANSWER])
    assert "nip length" in rows
    assert not {"contact width", "contact area"} & rows.keys()
    assert rows["drive torque of linear theory"].endswith(" N m/m")
    assert rows["push force"].endswith(" N/m")
    assert label_of("lateral_force", r.body) == "lateral force on the roller"
    assert "undetermined" not in repr(r)


def test_a_given_penetration_makes_the_load_a_result():
    r = vr.solve(ball(), penetration=1e-4, angular_speed=2.5, accuracy=0.05)
    rows = dict(result_sections(r)[ANSWER])
    assert " ± " in rows["normal load P"]
    assert "penetration" not in rows
    assert "penetration = 0.1 mm" in repr(r).splitlines()[0]


LOSSLESS_MODULI = {
    "number": 3e6,
    "Elastic": vr.Elastic(modulus=3e6),
    "Prony": vr.Prony(instantaneous_modulus=3e6, weights=[0.0, 0.0], relaxation_times=[0.1, 1.0]),
    "KelvinVoigt": vr.materials.KelvinVoigt(modulus=3e6, viscosity=0.0),
    "FractionalZener": vr.materials.FractionalZener(
        instantaneous_modulus=3e6, relaxed_modulus=3e6, relaxation_time=0.1, order=0.5
    ),
    "HavriliakNegami": vr.materials.HavriliakNegami(
        instantaneous_modulus=3e6, relaxed_modulus=3e6, relaxation_time=0.1, order=0.5, asymmetry=0.5
    ),
    "MasterCurve": vr.MasterCurve([0.0, 1e-3, 1e9], [3e6, 3e6, 4e6], [0.0, 0.0, 0.0]),
}

NONE = ("resisting_torque", "driving_torque", "driving_force", "bulk_power", "dissipated_power")


@pytest.mark.parametrize("name", LOSSLESS_MODULI)
def test_a_material_without_loss_dissipates_exactly_nothing(name):
    r = vr.solve(ball(LOSSLESS_MODULI[name]), load=50.0, angular_speed=2.5, mesh=MESH)
    for scalar in (*NONE, "rolling_resistance_force", "rolling_resistance_coefficient", "finite_strain_torque"):
        assert getattr(r, scalar) == 0.0, scalar
    assert r.energy_balance_error == 0.0
    assert LOSSLESS in repr(r)
    assert dict(result_sections(r)[ANSWER])["push force"] == "0 N"


@pytest.mark.parametrize(
    "on", [None, roller(2e6), vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=3e6, poisson_ratio=0.5))]
)
def test_pairs_without_loss_dissipate_exactly_nothing(on):
    r = vr.solve(roller(3e6), on=on, load=2e3, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=500))
    assert [getattr(r, name) for name in NONE] == [0.0] * len(NONE)


def test_one_lossy_body_is_enough_for_a_loss():
    r = vr.solve(roller(3e6), on=roller(), load=2e3, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=500))
    assert r.rolling_bulk_power == 0.0
    assert r.counterbody_bulk_power == r.dissipated_power > 0.0
    assert r.resisting_torque > 0.0
    assert LOSSLESS not in repr(r)


def test_friction_dissipates_power_also_between_elastic_bodies():
    r = vr.solve(ball(3e6), load=50.0, angular_speed=2.5, friction=0.3, drive=vr.Drive(torque=0.1), mesh=MESH)
    assert r.bulk_power == 0.0
    assert r.slip_power > 0.0
    assert r.rolling_resistance_force > 0.0
    assert LOSSLESS in repr(r)


def test_a_small_loss_is_not_rounded_to_zero():
    """A loss factor of 1e-9 gives a torque in proportion, which round-off of the solution does not change by 1 %."""
    moduli = [vr.MasterCurve([0.0, 1e-3, 1e9], [3e6] * 3, [0.0, loss * 3e6, loss * 3e6]) for loss in (1e-9, 1e-3)]
    powers = [vr.solve(ball(m), load=50.0, angular_speed=2.5, mesh=MESH).dissipated_power for m in moduli]
    assert np.isfinite(powers).all()
    assert powers[1] / powers[0] == pytest.approx(1e6, rel=0.01)


def test_a_report_with_friction_contains_creepage_and_speed():
    r = vr.solve(ball(), load=100.0, angular_speed=0.2, friction=0.3, drive=vr.Drive(creepage=-0.5), mesh=MESH)
    rows = dict(result_sections(r)[ANSWER])
    assert rows["creepage"] == "-50 %"
    assert rows["speed of the center V_s"] == "2.1 mm/s"  # half of Ω r_o


@pytest.mark.parametrize("on", [None, vr.CoatedCylinder(core_radius=0.1)])
def test_the_torque_at_finite_strain_answers_if_it_is_that_of_the_drive(on):
    sections = result_sections(vr.solve(roller(), on=on, load=5e3, angular_speed=9.0, accuracy=0.05))
    label = "resisting torque at finite strain"
    assert (label in dict(sections[ANSWER])) == (on is None)
    assert (label in dict(sections["further results"])) == (on is not None)
