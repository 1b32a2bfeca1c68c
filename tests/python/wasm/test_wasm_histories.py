"""Histories in WebAssembly have the instants and messages of native ones, from the same tables."""

from __future__ import annotations

import json

import numpy as np
import pytest
from viscoroll import ConvergenceError
from viscoroll.app import history_scalars
from viscoroll.case.motion import build_motion
from viscoroll.transient.series import HISTORY_SCALARS
from wasm_package import BALL, CREEP, FRACTIONAL, NEEDS, TREAD, WHEEL, answers, layer

pytestmark = NEEDS

#: Tolerance relative to the size of a time series. Compilers and transforms differ, and so the round-off of sums.
EQUAL = 1e-12

BUMP = {"type": "half_sine", "height": 1e-4, "length": 6e-3, "at": 8e-3}


def motion(*, distance=0.015, speed=0.05, load=100.0, nodes=150, numerics=None, ground=BUMP, **others):
    tables = {
        "motion": {"time": [0.0, distance / speed], "distance": [0.0, distance], "load": load},
        "numerics": {"nodes_per_revolution": nodes, "averaged_meshes": 2, "steps_per_spacing": 2} | (numerics or {}),
        "ground": ground,
    }
    tables["motion"] |= {key: others.pop(key) for key in [*others] if key in MOTION_KEYS}
    return {key: table for key, table in (tables | others).items() if table is not None}


MOTION_KEYS = {"time", "angle", "start", "friction", "driving_torque", "driving_force", "mass", "center_speed"}

MOTIONS = {
    "bump": motion(ball=BALL),
    "step": motion(ball=BALL, ground={"type": "step", "height": 5e-5, "at": 8e-3}),
    "joint": motion(ball=BALL, ground={"type": "joint", "depth": 5e-5, "width": 2e-3, "at": 8e-3}),
    "corrugation": motion(ball=BALL, ground={"type": "corrugation", "amplitude": 2e-5, "period": 5e-3}),
    "points": motion(ball=BALL, ground={"type": "points", "distance": [0.0, 8e-3, 0.01], "height": [0.0, 0.0, 1e-4]}),
    "axle with a mass": motion(
        ball=BALL, axle={"mass": 2.0, "damping": 10.0}, distance=1e-3, ground=BUMP | {"at": 2e-3}
    ),
    "tread": motion(
        ball=BALL, ground=None, tread={"type": "corrugation", "amplitude": 2e-5, "period": 2.0 * np.pi * 21e-3 / 30}
    ),
    "continuous spectrum": motion(ball=BALL | {"layers": [layer(FRACTIONAL)]}, start="undeformed"),
    "friction": motion(ball=BALL, friction=0.3, driving_torque=0.0, nodes=100, ground=None),
    "wheel": motion(wheel=WHEEL, load=300.0, nodes=64, distance=0.02),
    "rigid roller on a soft plane": motion(
        cylinder={"core_radius": 50e-3},
        plane={"layers": [layer(CREEP, thickness=5e-3, poisson_ratio=0.45)]},
        load=2e3,
        nodes=400,
        distance=0.02,
    ),
    "oscillation": {
        "ball": BALL,
        "motion": {"amplitude": 0.05, "frequency": 1.0, "cycles": 0.5, "load": 100.0},
        "numerics": {"averaged_meshes": 1, "nodes_per_revolution": 150},
    },
    "height of the axle": {
        "ball": BALL,
        "motion": {"time": [0.0, 0.2, 0.2], "angle": [0.0, 0.2, 0.2], "axle_height": [20.9e-3, 20.8e-3, 20.85e-3]},
        "numerics": {"averaged_meshes": 1, "nodes_per_revolution": 150},
    },
    "lists of loads, default mesh": {
        "cylinder": {"core_radius": 50e-3, "layers": [TREAD]},
        "motion": {"time": [0.0, 0.1], "angle": [0.0, 0.02], "load": [5e3, 4e3]},
        "numerics": {"averaged_meshes": 1},
    },
}


def with_motion(**keys):
    return motion(ball=BALL) | {"motion": {"time": [0.0, 0.3], "distance": [0.0, 0.015], "load": 100.0} | keys}


BAD = {
    "a negative load": with_motion(load=-1.0),
    "lists of different lengths": with_motion(distance=[0.0, 0.1, 0.2]),
    "one waypoint": with_motion(time=[0.0], distance=[0.0]),
    "time that decreases": with_motion(time=[1.0, 0.0]),
    "angle and distance": with_motion(angle=[0.0, 1.0]),
    "load and height": with_motion(axle_height=0.02),
    "neither load nor height": with_motion(load=None),
    "a time that is no list": with_motion(time=3),
    "an unknown key": with_motion(velocity=1),
    "too much friction": with_motion(friction=5.0),
    "a mass without friction": with_motion(mass=1.0),
    "two drives": with_motion(friction=0.1, driving_force=1.0, driving_torque=1.0),
    "an oscillation without a load": motion(ball=BALL) | {"motion": {"amplitude": 0.1, "frequency": 1.0}},
    "an oscillation without cycles": motion(ball=BALL)
    | {"motion": {"amplitude": 0.1, "frequency": 1.0, "load": 100.0, "cycles": 0.0}},
    "an axle without parameters": motion(ball=BALL, axle={}),
    "an axle with a negative mass": motion(ball=BALL, axle={"mass": -1.0}),
    "a bump without a length": motion(ball=BALL, ground={"type": "half_sine", "height": 1e-4, "at": 0.0}),
    "a bump of negative length": motion(ball=BALL, ground=BUMP | {"length": -1e-3}),
    "a joint without depth": motion(ball=BALL, ground={"type": "joint", "depth": 0.0, "width": 1e-3, "at": 0.0}),
    "a key of another shape": motion(ball=BALL, ground=BUMP | {"width": 1e-3}),
    "a profile of one point": motion(ball=BALL, ground={"type": "points", "distance": [0.0], "height": [0.0]}),
    "too many meshes": motion(ball=BALL, numerics={"averaged_meshes": 17}),
    "a part of a mesh": {"ball": BALL, "motion": with_motion()["motion"], "numerics": {"max_order": 300}},
    "no motion": {"ball": BALL, "ground": BUMP},
    "no body": motion(),
}


@pytest.fixture(scope="module")
def of_wasm():
    tables = MOTIONS | BAD
    found = answers([{"history": {"case": one}} for one in tables.values()])
    assert found["historyScalars"] == history_scalars()
    return dict(zip(tables, found["answers"], strict=True))


def sizes_of_differences(history):
    """Return the sizes of the numbers whose difference is a time series, to which its round-off is relative."""
    step = np.diff(history.time)
    step = step[step > 0.0].min()
    height, work = np.nanmax(history.axle_height, initial=0.0), np.abs(history.work).max()
    torque = np.abs(history.resisting_torque).max()
    energies = ("axle_energy", "energy_balance_residual", "counterbody_dissipated_energy", "counterbody_stored_energy")
    return dict.fromkeys(energies, work) | {
        "axle_speed": height / step,
        "axle_acceleration": height / step**2,
        "driving_torque": torque,
        "error_estimate": torque,
    }


def joined(parts, name):
    return np.array([np.nan if one is None else one for part in parts for one in part[name]])


@pytest.mark.parametrize("name", MOTIONS)
def test_instants_are_the_native_ones(name, of_wasm):
    native = build_motion(json.loads(json.dumps(MOTIONS[name])), None).roll(threads=1)
    found = of_wasm[name]
    assert found["result"]["steps"] == len(native.time) - 1
    assert found["result"]["nodes_per_revolution"] == native.mesh.nodes_per_revolution
    assert len(found["parts"][0]["time"]) == 1
    assert all(len(part["time"]) <= 8 for part in found["parts"])
    sizes = sizes_of_differences(native)
    for series in ("distance", *HISTORY_SCALARS):
        expected = getattr(native, series)
        scale = max(np.nanmax(np.abs(expected), initial=0.0), sizes.get(series, 0.0))
        np.testing.assert_allclose(
            joined(found["parts"], series), expected, rtol=0.0, atol=EQUAL * scale, err_msg=series
        )


@pytest.mark.parametrize("name", BAD)
def test_errors_have_the_same_words(name, of_wasm):
    with pytest.raises((ValueError, TypeError, ConvergenceError)) as refused:
        build_motion(json.loads(json.dumps(BAD[name])), None).roll(threads=1)
    assert of_wasm[name]["error"]["message"] == str(refused.value)


@pytest.mark.parametrize(
    ("tables", "parameter"),
    [
        (with_motion(start="warm"), "motion.start"),
        (with_motion(distance=[0.0, "far"]), "motion.distance[1]"),
        (motion(ball=BALL, ground=BUMP | {"type": "file", "file": "floor.csv"}), "ground.type"),
        (motion(ball=BALL, numerics={"curvature": "exact"}), "numerics.curvature"),
        (with_motion() | {"rolling": {"load": 1.0}}, "rolling"),
        (with_motion(amplitude=1.0), "motion"),
    ],
)
def test_other_errors_name_the_parameter(tables, parameter):
    (found,) = answers([{"history": {"case": tables}}])["answers"]
    assert found["error"]["parameter"] == parameter


def test_a_worker_sends_the_same_parts(of_wasm):
    names = ["bump", "a negative load"]
    requests = [{"history": {"case": (MOTIONS | BAD)[name]}} for name in names]
    assert answers(requests, "worker")["answers"] == [of_wasm[name] for name in names]


def test_requests_that_are_none():
    requests = [{"history": 3}, {"history": {"case": []}}, {"history": {"case": {}, "fields": True}}]
    found = answers(requests)["answers"]
    assert [answer["error"]["parameter"] for answer in found] == ["request", "case", "request.fields"]
