"""The library in WebAssembly gives the same numbers and messages as the native one, from the same tables."""

from __future__ import annotations

import dataclasses
import functools
import gzip
import json
import re
import shutil
import subprocess
from importlib.metadata import version

import numpy as np
import pytest
from viscoroll import ConvergenceError, Profile, _core, paper, roll, solve
from viscoroll.app import scalars
from viscoroll.case import build_case
from wasm_package import (
    BALL,
    CREEP,
    CURVE,
    FRACTIONAL,
    HARD,
    LOSS,
    NEEDS,
    NEGAMI,
    PACKAGE,
    PRONY,
    RUBBER,
    SHEET,
    TREAD,
    WHEEL,
    answers,
    layer,
)

pytestmark = NEEDS

#: Relative tolerance. Compilers and transforms differ, and so the round-off of sums: 3e-13 in these cases.
EQUAL = 1e-9

#: Largest size of the script as servers send it [B]. The library itself has 815 kB when compressed, 651 kB without
#: histories; wasm-opt -Oz saves only 3 kB.
MOST_TO_DOWNLOAD = 850e3


def case(
    nodes=400, numerics=None, *, load=100.0, angular_speed=2.5, friction=None, drive=None, penetration=None, **bodies
):
    rolling = {"load": load if penetration is None else None, "penetration": penetration}
    rolling |= {"angular_speed": angular_speed, "friction": friction, "drive": drive}
    return {
        **bodies,
        "rolling": {key: value for key, value in rolling.items() if value is not None},
        "numerics": {"nodes_per_revolution": nodes, **(numerics or {})},
    }


CASES = {
    "ball to an accuracy": {
        "ball": BALL,
        "rolling": {"load": 100, "angular_speed": 2.5},
        "numerics": {"accuracy": 0.05},
    },
    "ball with friction": case(
        ball=BALL, friction=0.2, drive={"creepage": 1e-3, "lateral_creepage": 5e-4, "spin": 0.1}
    ),
    "towed ball": case(ball=BALL, friction=0.5, drive={"torque": 0.0}),
    "ball at a penetration": case(ball=BALL, penetration=1e-4, friction=0.2),
    "ball with a power": case(ball=BALL, friction=0.5, drive={"power": 0.1}),
    "as the paper": case(
        nodes=300,
        numerics={"max_order": 300, "compliance": "vertical", "curvature": "paper", "patch_load": "spherical"},
        ball=BALL,
    ),
    "dissimilar layers": case(
        ball={
            "core_radius": 20e-3,
            "layers": [
                layer(FRACTIONAL, thickness=2e-3, poisson_ratio=0.45, density=1000.0),
                layer({"type": "kelvin_voigt", "modulus": 2e6, "viscosity": 300.0}, bulk_modulus=1e9, density=1500.0),
            ],
        },
        angular_speed=50.0,
    ),
    "asymmetric dispersion": case(ball={"core_radius": 20e-3, "layers": [layer(NEGAMI)]}),
    "values of data sheets": case(
        ball={"core_radius": 20e-3, "layers": [layer(HARD), layer(SHEET)]}, plane={"layers": [layer(LOSS)]}
    ),
    "exact solid ball": case(
        nodes=300,
        numerics={"curvature": "exact"},
        ball={"inner_boundary": "solid", "layers": [layer(thickness=20e-3, poisson_ratio=0.4)]},
    ),
    "exact hollow ball with friction": case(
        nodes=250,
        numerics={"curvature": "exact"},
        ball={"core_radius": 10e-3, "inner_boundary": "hollow", "layers": [layer(PRONY, thickness=8e-3)]},
        friction=0.3,
        load=20.0,
    ),
    "roller": case(nodes=3000, cylinder={"core_radius": 50e-3, "layers": [TREAD]}, load=5e3, angular_speed=20.0),
    "roller with friction on a soft plane": case(
        nodes=2000,
        cylinder={"core_radius": 50e-3, "layers": [layer(3e6, thickness=5e-3, poisson_ratio=0.45)]},
        plane={"layers": [layer(PRONY, thickness=5e-3)]},
        load=2e3,
        friction=0.3,
    ),
    "wheel": case(nodes=200, wheel=WHEEL, load=300.0, angular_speed=20.0),
    "crowned hub, unbounded sides": case(wheel=WHEEL | {"hub": "crowned", "sides": "unbounded"}, load=300.0),
    "ball on a coated plane": case(
        ball={"core_radius": 20e-3},
        plane={"layers": [layer(thickness=3e-3)], "base": {"shear_modulus": 5e7, "poisson_ratio": 0.3}},
    ),
    "ball in a groove": case(ball=BALL | {"layers": [layer(CURVE)]}, groove={"radius": 30e-3, "path_radius": -0.2}),
    "ball on a ball": case(ball=BALL, other_ball={"core_radius": 15e-3, "layers": [layer(CREEP)]}),
}

#: Faults of cases.
BAD = {
    "a load that is none": case(ball=BALL, load=-100.0),
    "a load too large": case(ball=BALL, load=1e5),
    "a penetration too large": case(ball=BALL, penetration=2e-3),
    "load and penetration": {"ball": BALL, "rolling": {"load": 1.0, "penetration": 1e-4, "angular_speed": 1.0}},
    "neither load nor penetration": {"ball": BALL, "rolling": {"angular_speed": 1.0}},
    **{f"a load of {load}": case(ball=BALL, load=load) for load in (-1.2e6, -1e-4, -0.1 - 0.2, -1 / 3, -(2.0**70))},
    "a speed too high": case(ball={"core_radius": 20e-3, "layers": [layer(2e3, density=1e3)]}, angular_speed=90.0),
    "a layer without thickness": case(ball=BALL | {"layers": [layer(thickness=0.0)]}),
    "a modulus that rises at rest": case(
        ball=BALL | {"layers": [layer(RUBBER | {"relaxed_modulus": 7e6})]},
    ),
    "a number that is negative": case(ball=BALL | {"layers": [layer(-3e6)]}),
    "a loss factor too large": case(ball=BALL | {"layers": [layer(LOSS | {"loss_factor": 3.0})]}),
    "a hardness too large": case(ball=BALL | {"layers": [layer(SHEET | {"hardness": 95.0})]}),
    "a rebound in percent": case(ball=BALL | {"layers": [layer(SHEET | {"rebound": 55.0})]}),
    "decades without a rebound": case(ball=BALL | {"layers": [layer(HARD | {"decades": 2.0})]}),
    "a rebound without a frequency": case(ball=BALL | {"layers": [layer(HARD | {"rebound": 0.5})]}),
    "a base that is not passive": case(ball=BALL, plane={"base": {"shear_modulus": 1e6, "poisson_ratio": 0.6}}),
    "an unknown key": case(ball=BALL | {"radius": 0.02}),
    "an unknown parameter": case(ball=BALL | {"layers": [layer(RUBBER | {"E": "3 MPa"})]}),
    "a missing key": {"ball": BALL, "rolling": {"load": 100.0}},
    "a missing parameter": case(ball=BALL | {"layers": [layer({"type": "elastic"})]}),
    "a text": case(ball=BALL, load="heavy"),
    "a mesh too coarse": case(nodes=8, ball=BALL),
    "a mesh of half a node": case(nodes=300.5, ball=BALL),
    "a mesh and an accuracy": case(ball=BALL, numerics={"accuracy": 0.1}),
    "a part of a mesh": {"ball": BALL, "rolling": {"load": 1.0, "angular_speed": 1.0}, "numerics": {"max_order": 300}},
    "two bodies": case(ball=BALL, wheel=WHEEL),
    "no body": case(),
    "a power without friction": case(ball=BALL, drive={"power": 1.0}),
    "two drives": case(ball=BALL, friction=0.1, drive={"force": 0.0, "torque": 0.0}),
    "spin without creepage": case(ball=BALL, friction=0.1, drive={"force": 0.0, "spin": 0.1}),
    "a ball that slides": case(ball=BALL, friction=0.1, drive={"force": 50.0}),
    "a boundary of another name": case(ball=BALL | {"inner_boundary": "soft"}),
    "two rigid bodies": case(ball={"core_radius": 20e-3}),
    "a wheel on a ball": case(wheel=WHEEL, other_ball=BALL),
}


@pytest.fixture(scope="module")
def of_wasm():
    """Return all answers by name, from one process that takes some seconds: the module is compiled while it solves."""
    requests = {name: {"case": tables, "fields": True} for name, tables in CASES.items()}
    requests |= {name: {"case": tables} for name, tables in BAD.items()}
    return dict(zip(requests, answers(list(requests.values()))["answers"], strict=True))


#: Scalars that are differences of numbers of the size of 1.
DIFFERENCES = {"energy_balance_error", "error_estimate", "residual", "creepage"}


def size_of(scalar, native):
    """Return the size to which the round-off of a scalar that may vanish is relative, or 0 for other scalars."""
    torque = native.load * native.semi_axis_x
    sizes = {"N": native.load, "N m": torque, "W": torque * native.angular_speed}
    return 1.0 if scalar.name in DIFFERENCES else sizes.get(scalar.unit, 0.0)


@functools.cache
def native_result(name):
    return build_case(CASES[name], None).solve(threads=1)


@pytest.mark.parametrize("name", CASES)
def test_results_are_the_native_ones(name, of_wasm):
    native = native_result(name)
    found = of_wasm[name]["result"]
    assert found["state"] == native.status.name.lower()
    assert found["warnings"] == [
        {"kind": kind.name.lower(), "message": message} for kind, message in native.warnings.items()
    ]
    scalars = dict(found["scalars"])
    for scalar in _core.result_scalars():
        value, wanted = scalars.pop(scalar.name), getattr(native, scalar.name)
        assert (value is None) == (wanted is None), scalar.name
        if value is not None and scalar.type != "int":
            tolerance = EQUAL * max(abs(wanted), size_of(scalar, native))
            assert abs(value - wanted) <= tolerance, (scalar.name, value, wanted)
    assert scalars == {key: native.scalars()[key] for key in ("contact_nodes", "nodes_per_revolution", "max_order")}


@pytest.mark.parametrize("name", CASES)
def test_fields_are_the_native_ones(name, of_wasm):
    native = native_result(name)
    fields = of_wasm[name]["result"]["fields"]
    middle = native.x.shape[1] // 2

    def assert_close(values, wanted):
        np.testing.assert_allclose(np.array(values), wanted, rtol=0.0, atol=EQUAL * np.abs(wanted).max())

    assert_close(fields["x"], native.x[:, middle])
    assert_close(fields["z"], native.z[0])
    assert_close(fields["pressure"], native.pressure)
    profile = fields["profile"]
    assert profile["x"] == fields["x"]
    assert_close(profile["surface"], native.gap[:, middle])
    assert_close(profile["rigid"], native.gap[:, middle] - native.displacement[:, middle])
    if native.friction == 0.0:
        assert fields["stick"] is None
    else:
        np.testing.assert_array_equal(fields["stick"], np.where(native.stick, 1, np.where(native.slip, 2, 0)))


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_told_in_the_same_words(name, of_wasm):
    with pytest.raises((ValueError, TypeError, ConvergenceError)) as refused:
        build_case(json.loads(json.dumps(BAD[name])), None).solve(threads=1)
    assert of_wasm[name]["error"]["message"] == str(refused.value)


@pytest.mark.parametrize(
    ("name", "parameter"),
    [
        ("a load that is none", "load"),
        ("a layer without thickness", "ball.layers[0].thickness"),
        ("a number that is negative", "ball.layers[0].shear_modulus.modulus"),
        ("an unknown key", "ball.radius"),
        ("a missing key", "rolling.angular_speed"),
        ("a text", "rolling.load"),
        ("no body", None),
    ],
)
def test_what_is_wrong_is_told_by_its_place(name, parameter, of_wasm):
    assert of_wasm[name]["error"]["parameter"] == parameter


@pytest.mark.parametrize("entry", ["module", "script", "worker"])
def test_pages_and_workers_get_the_same(entry, of_wasm):
    names = ["towed ball", "a load that is none"]
    found = answers([{"case": (CASES | BAD)[name], "fields": name in CASES} for name in names], entry)
    assert found["answers"] == [of_wasm[name] for name in names]
    assert found["scalars"] == scalars()


def test_what_json_cannot_say():
    """JavaScript's Infinity is sent as the text of case files."""
    stuck = case(600, ball=BALL, friction=float("inf"))
    told = case(600, ball=BALL, friction="inf")
    found, refused = answers([{"case": told}, {"case": case(ball=BALL, load="nan")}])["answers"]
    assert found["result"]["scalars"]["creepage"] == pytest.approx(
        build_case(stuck, None).solve(threads=1).creepage, rel=0.0, abs=EQUAL
    )
    assert "fields" not in found["result"]
    assert refused["error"]["message"] == "load must be > 0 N, got nan"


def test_requests_that_are_none():
    roller, deep = {"case": CASES["roller"]}, functools.reduce(lambda inner, _: [inner], range(900), 0)
    requests = [3, {}, {"case": []}, roller | {"fields": 1}, roller | {"field": True}, {"case": {"ball": deep}}]
    assert [answer["error"]["parameter"] for answer in answers(requests)["answers"]] == [
        "request",
        "request.case",
        "case",
        "request.fields",
        "request.field",
        "request",
    ]


def test_what_is_downloaded():
    script = (PACKAGE / "viscoroll.single.js").read_bytes()
    assert len(gzip.compress(script)) < MOST_TO_DOWNLOAD


@pytest.mark.skipif(shutil.which("npm") is None, reason="needs npm")
def test_package_of_npm(tmp_path):
    def run(*words):
        return subprocess.run(words, cwd=tmp_path, capture_output=True, encoding="utf-8", check=True).stdout

    (tmp_path / "package.json").write_text("{}", encoding="utf-8")
    (archive,) = json.loads(run("npm", "pack", "--json", str(PACKAGE)))
    assert archive["name"] == "viscoroll"
    assert archive["version"] == version("viscoroll")
    run("npm", "install", "--offline", "--no-audit", "--no-fund", archive["filename"])
    examples = re.findall(r"```js\n(.*?)```", (PACKAGE / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    solved, rolled = (run("node", "--input-type=module", "--eval", example).splitlines() for example in examples)
    torque, *table = solved
    assert float(torque.removesuffix(" N m")) == pytest.approx(
        solve(paper.ball(), load=100.0, angular_speed=2.5).resisting_torque, rel=EQUAL
    )
    assert table == [f"{one.name} {one.unit} {one.label}" for one in _core.result_scalars()]
    bump = Profile.half_sine(0.1e-3, length=6e-3, at=10e-3)
    layers = [dataclasses.replace(paper.ball().layers[0], density=0.0)]
    history = roll(
        dataclasses.replace(paper.ball(), layers=layers),
        time=[0.0, 0.4],
        distance=[0.0, 20e-3],
        load=100.0,
        ground=bump,
    )
    force, *words = rolled[0].split(" ", 1)
    assert float(force) == pytest.approx(history.resisting_force.max(), rel=EQUAL)
    assert words == [f"N after {len(history.time) - 1} steps"]
