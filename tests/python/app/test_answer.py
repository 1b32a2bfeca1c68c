"""Answers to the page: the numbers of `viscoroll solve`, and messages that name the wrong parameter."""

from __future__ import annotations

import json
import tomllib

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll.app import answer, scalars
from viscoroll.case import example_text


def example(**rolling):
    tables = tomllib.loads(example_text())
    tables["rolling"] |= rolling
    return tables


def test_numbers_are_those_of_solve(tmp_path):
    (tmp_path / "case.toml").write_text(example_text(), encoding="utf-8")
    solved = json.loads(command("solve", tmp_path / "case.toml", "--json").stdout)
    found = answer({"case": example()})["result"]
    assert found["scalars"] == solved
    assert found["state"] == "converged"
    assert "fields" not in found


def test_the_table_of_scalars_agrees_with_that_of_results():
    table = scalars()
    assert {one["name"] for one in table} <= set(answer({"case": example()})["result"]["scalars"])
    torque = next(one for one in table if one["name"] == "resisting_torque")
    assert torque == {
        "name": "resisting_torque",
        "unit": "N m",
        "description": "resisting torque T_r, offset of the pressure times P",
        "group": "other",
        "precision": "error_estimate model_error",
    }


def test_fields_agree_with_the_result():
    tables = example(friction=0.3)
    fields = answer({"case": tables, "fields": True})["result"]["fields"]
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    r = vr.solve(vr.CoatedSphere(core_radius=20e-3, layers=[layer]), load=100.0, angular_speed=2.5, friction=0.3)
    assert np.array_equal(fields["pressure"], r.pressure)
    assert np.array_equal(fields["x"], r.x[:, r.x.shape[1] // 2])
    assert np.array_equal(fields["z"], r.z[r.z.shape[0] // 2])
    stick = np.array(fields["stick"])
    assert np.array_equal(stick == 1, r.stick)
    assert np.array_equal(stick == 2, r.slip)
    # The lowest point of the undeformed body lies below the plane by the penetration, and the gap is zero in contact.
    # The displacement of a node is reported at its undeformed position.
    profile = {name: np.array(values) for name, values in fields["profile"].items()}
    assert profile["rigid"].min() == pytest.approx(-r.penetration, rel=1e-9)
    assert np.abs(profile["surface"][r.contact[:, r.x.shape[1] // 2]]).max() < 1e-6 * r.penetration


def test_without_friction_nothing_sticks():
    assert answer({"case": example(), "fields": True})["result"]["fields"]["stick"] is None


def test_warnings_have_kinds():
    tables = example()
    tables["numerics"] = {"nodes_per_revolution": 100}
    (warning,) = answer({"case": tables})["result"]["warnings"]
    assert warning["kind"] == "coarse_mesh"
    assert "nodes" in warning["message"]


def test_answers_are_valid_json():
    tables = example(friction=0.3, drive={"torque": 0.0})
    json.dumps(answer({"case": tables, "fields": True}), allow_nan=False)


def with_layer(**changes):
    tables = example()
    tables["ball"]["layers"][0] |= changes
    return tables


@pytest.mark.parametrize(
    ("tables", "parameter", "message"),
    [
        (example(load=-1.0), "load", "load must be > 0 N, got -1"),
        (example(load=1e5), "load", "load must be small enough for the coating"),
        (example(load="much"), "rolling.load", "rolling.load must be a valid number"),
        (example(angular_speed=1e6), "angular_speed", "angular_speed must be below the critical speed"),
        (example(friction=0.1, drive={"force": 50.0}), "drive.force", "drive.force must be smaller than"),
        (example(friction=0.1, drive={"power": 50.0}), "drive.power", "drive.power must be between"),
        (with_layer(thickness=0.0), "ball.layers[0].thickness", "ball.layers[0].thickness must be > 0 m"),
        (with_layer(poisson_ratio=0.7), "ball.layers[0].poisson_ratio", "poisson_ratio must be in"),
        (
            with_layer(shear_modulus={"type": "hardness", "hardness": 95.0}),
            "ball.layers[0].shear_modulus.hardness",
            "hardness must be in",
        ),
        (
            with_layer(shear_modulus={"type": "measured", "file": "/etc/passwd"}),
            "ball.layers[0].shear_modulus.file",
            "file must be left out here: write the values into the table",
        ),
        (
            with_layer(shear_modulus="/etc/passwd"),
            "ball.layers[0].shear_modulus.file",
            "file must be left out here: write the values into the table",
        ),
        (example() | {"thermal": {}}, "thermal", "thermal must be left out"),
        ("case.toml", "case", "case must be an object"),
    ],
)
def test_errors_name_the_parameter(tables, parameter, message):
    error = answer({"case": tables})["error"]
    assert message in error["message"]
    assert error["parameter"] == parameter


@pytest.mark.parametrize("request_", [None, [], {}, {"case": {}, "other": 1}])
def test_requests_of_another_kind_are_rejected(request_):
    assert "request must be an object" in answer(request_)["error"]["message"]


def test_a_case_that_is_not_a_table_is_rejected():
    assert "rolling" in answer({"case": {}})["error"]["message"]


def test_progress_can_end_a_solve():
    def end(_stage, _fraction):
        raise EOFError

    tables = example(friction=0.3)
    tables["numerics"] = {"accuracy": 1e-3}
    with pytest.raises(EOFError):
        answer({"case": tables}, progress=end)
