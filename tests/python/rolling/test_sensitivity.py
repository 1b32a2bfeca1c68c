"""Derivatives of results by the inputs, compared with difference quotients, scaling laws, and a scaled modulus."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import enums
from viscoroll.rolling.sensitivity_picture import measured_range

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.05)
STIFF = vr.Prony(instantaneous_modulus=2e7, weights=[0.3, 0.2], relaxation_times=[0.02, 0.4])
SOFT = vr.Layer(thickness=1e-3, shear_modulus=RUBBER, poisson_ratio=0.5)
HARD = vr.Layer(thickness=0.5e-3, shear_modulus=STIFF, poisson_ratio=0.45)
BALL = vr.CoatedSphere(core_radius=20e-3, layers=[SOFT])
MESH = vr.Mesh(nodes_per_revolution=250)
LINE = vr.Mesh(nodes_per_revolution=2000)
WHEEL = vr.CoatedWheel(core_radius=20e-3, layers=[SOFT], width=3e-3, sides=enums.Sides.FREE)

CASES = {
    "ball": (BALL, {"load": 50.0}),
    "two layers": (replace(BALL, layers=[HARD, SOFT]), {"load": 50.0}),
    "vertical": (BALL, {"load": 50.0, "compliance": enums.Compliance.VERTICAL}),
    "exact": (BALL, {"load": 50.0, "curvature": enums.Curvature.EXACT}),
    "friction": (BALL, {"load": 50.0, "friction": 0.3}),
    "creepage": (BALL, {"load": 50.0, "friction": 0.3, "drive": vr.Drive(creepage=2e-3, lateral_creepage=1e-3)}),
    "full stick": (BALL, {"load": 50.0, "friction": math.inf}),
    "roller": (vr.CoatedCylinder(core_radius=20e-3, layers=[HARD, SOFT]), {"load": 2e3, "mesh": LINE}),
    "roller with friction": (
        vr.CoatedCylinder(core_radius=20e-3, layers=[SOFT]),
        {"load": 2e3, "mesh": LINE, "friction": 0.5, "drive": vr.Drive(torque=2.0)},
    ),
    "ball on a mat": (vr.CoatedSphere(core_radius=20e-3), {"load": 50.0, "on": vr.CoatedPlane(layers=[HARD])}),
    "two balls": (BALL, {"load": 50.0, "on": vr.CoatedSphere(core_radius=30e-3, layers=[HARD])}),
    "wheel": (WHEEL, {"load": 50.0}),
}

#: Relative step, so small that hardly any node joins the contact.
STEP = 1e-5


@pytest.fixture(scope="module", params=CASES)
def solved(request):
    body, given = CASES[request.param]
    given = {"angular_speed": 5.0, "mesh": MESH} | given
    result = vr.solve(body, **given)
    return body, given, result, result.sensitivity()


def difference_quotients(result, body, given, change):
    """Return central difference quotients of separate solves, relative to the result."""
    answers = ("resisting_torque", "penetration", "max_pressure")
    more, less = (vr.solve(b, **g) for b, g in (change(body, given, STEP), change(body, given, -STEP)))
    return np.array([(getattr(more, a) - getattr(less, a)) / (2.0 * STEP * getattr(result, a)) for a in answers])


def more_load(body, given, share):
    return body, given | {"load": given["load"] * (1.0 + share)}


def more_speed(body, given, share):
    return body, given | {"angular_speed": given["angular_speed"] * (1.0 + share)}


def thicker(body, given, share):
    layered = body if body.layers else given["on"]
    layers = [*layered.layers[:-1], replace(layered.layers[-1], thickness=layered.layers[-1].thickness * (1.0 + share))]
    changed = replace(layered, layers=layers)
    return (changed, given) if body.layers else (body, given | {"on": changed})


@pytest.mark.parametrize("change", [more_load, more_speed, thicker])
def test_derivatives_agree_with_difference_quotients(solved, change):
    body, given, result, found = solved
    layered, prefix = (body, "") if body.layers else (given["on"], "on.")
    name = {
        more_load: "load",
        more_speed: "angular_speed",
        thicker: f"{prefix}layers[{len(layered.layers) - 1}].thickness",
    }[change]
    np.testing.assert_allclose(list(found[name].values()), difference_quotients(result, body, given, change), atol=1e-3)


def test_results_are_homogeneous_in_load_and_moduli(solved):
    """Torque and pressure are homogeneous of degree 1 in load and all moduli, and the penetration of degree 0."""
    _, _, _, found = solved
    loads = [name for name in found.parameters if name in ("load", "drive.torque", "drive.force")]
    total = np.sum([list(found[name].values()) for name in loads], axis=0)
    for modulus in found.moduli:
        total += np.array(list(found[modulus.name].values()))
    np.testing.assert_allclose(total, [1.0, 0.0, 1.0], atol=2e-5)


def test_derivative_by_a_scaled_modulus_is_the_sum_over_its_bands():
    def torque(share):
        modulus = replace(RUBBER, instantaneous_modulus=6e6 * (1.0 + share), relaxed_modulus=3e6 * (1.0 + share))
        ball = replace(BALL, layers=[replace(SOFT, shear_modulus=modulus)])
        return vr.solve(ball, load=50.0, angular_speed=5.0, mesh=MESH).resisting_torque

    result = vr.solve(BALL, load=50.0, angular_speed=5.0, mesh=MESH)
    coarse, fine = result.sensitivity(), result.sensitivity(bands_per_decade=3)
    expected = (torque(STEP) - torque(-STEP)) / (2.0 * STEP * torque(0.0))
    for found in (coarse, fine):
        assert found["layers[0].shear_modulus"]["resisting_torque"] == pytest.approx(expected, abs=1e-3)
    assert fine.moduli[0].loss[0].sum() == pytest.approx(coarse.moduli[0].loss[0].sum(), abs=1e-4)


def test_torque_is_proportional_to_a_small_loss():
    """For a small loss, the torque is proportional to the loss at all frequencies."""
    modulus = replace(RUBBER, instantaneous_modulus=3.003e6)
    ball = replace(BALL, layers=[replace(SOFT, shear_modulus=modulus)])
    found = vr.solve(ball, load=50.0, angular_speed=5.0, mesh=MESH).sensitivity()
    assert found.moduli[0].loss[0].sum() == pytest.approx(1.0, abs=2e-3)


def test_summary_and_files(tmp_path):
    result = vr.solve(BALL, load=50.0, angular_speed=5.0, mesh=MESH)
    calls = []
    found = result.sensitivity(answers=["dissipated_power"], progress=lambda stage, share: calls.append((stage, share)))
    assert calls[-1] == ("parameters", 1.0)
    assert repr(found).splitlines()[1].split() == ["dissipated_power"]
    assert repr(found).splitlines()[2].startswith("layers[0].poisson_ratio")
    found.save(tmp_path / "s.csv")
    rows = (tmp_path / "s.csv").read_text().splitlines()
    assert rows[0] == "parameter,frequency [rad/s],dissipated_power"
    assert len(rows) == 1 + len(found.parameters) + 2 * found.moduli[0].frequency.size
    found.save(tmp_path / "s.nc")
    dataset = found.to_xarray()
    assert dataset["loss_0"].sizes == {"frequency_0": found.moduli[0].frequency.size, "answer": 1}


def test_one_picture_of_loss_and_sensitivity():
    """The loss per decade integrates to the total, and unmeasured frequencies are gray."""
    roller, mat = vr.CoatedCylinder(core_radius=20e-3, layers=[SOFT]), vr.CoatedPlane(layers=[HARD])
    found = vr.solve(roller, on=mat, load=2e3, angular_speed=5.0, mesh=LINE).sensitivity()
    assert not found.plot().axes[1].patches
    above, below = found.plot(measured=(20.0, 50.0)).axes
    assert (above.get_ylabel(), below.get_xlabel()) == ("power dissipated\n[% per decade]", "frequency [rad/s]")
    assert [line.get_label() for line in above.get_lines()] == ["loss in rolling body", "loss in counterbody"]
    for line in above.get_lines():
        decades = np.diff(np.log10(line.get_xdata()))
        assert (line.get_ydata() * decades[0]).sum() == pytest.approx(100.0, abs=1e-6)
    low, high = below.patches
    assert (low.get_x() + low.get_width(), high.get_x()) == pytest.approx((20.0, 50.0))
    with pytest.raises(ValueError, match=r"measured must be two increasing frequencies > 0 rad/s, got \(5, 1\)"):
        found.plot(measured=(5, 1))


def test_measured_range_is_that_of_the_tables():
    table = vr.MasterCurve([0.0, 10.0, 100.0], [2e6, 3e6, 4e6], [0.0, 3e5, 4e5], extrapolation="hold")
    ball = replace(BALL, layers=[HARD, replace(SOFT, shear_modulus=table)])
    assert measured_range(vr.solve(ball, load=20.0, angular_speed=5.0, mesh=MESH)) == (10.0, 100.0)
    assert measured_range(vr.solve(BALL, load=20.0, angular_speed=5.0, mesh=MESH)) is None


def test_only_solutions_have_derivatives():
    given = {"load": 50.0, "angular_speed": 5.0, "mesh": MESH, "friction": 0.3, "drive": vr.Drive(creepage=1e-3)}
    flat = vr.solve(BALL, **given, slip_kinematics=enums.SlipKinematics.FLAT)
    with pytest.raises(vr.ConvergenceError, match=r"max_pressure changes by .* when the same contact is solved again"):
        flat.sensitivity()


def test_bad_arguments():
    result = vr.solve(BALL, load=50.0, angular_speed=5.0, mesh=MESH)
    with pytest.raises(ValueError, match="answers must be names of scalars of this result, got 'status'"):
        result.sensitivity(answers=["status"])
    with pytest.raises(ValueError, match="answers must be names of scalars of this result, got 'load'"):
        result.sensitivity(answers=["load"])
    with pytest.raises(ValueError, match="bands_per_decade must be >= 1, got 0"):
        result.sensitivity(bands_per_decade=0)
    with pytest.raises(ValueError, match="answer must be one of resisting_torque, penetration, max_pressure"):
        result.sensitivity().plot(answer="load")
