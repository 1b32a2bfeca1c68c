"""Histories for the page: parts of the time series as they are computed, and errors."""

from __future__ import annotations

import http.client
import json
from contextlib import closing

import numpy as np
import pytest
import viscoroll as vr
from viscoroll.app import history_answer, history_scalars
from viscoroll.transient.series import HISTORY_SCALARS

TABLES = {
    "ball": {
        "core_radius": 20e-3,
        "layers": [
            {
                "thickness": 1e-3,
                "poisson_ratio": 0.5,
                "shear_modulus": {
                    "type": "standard_linear_solid",
                    "instantaneous_modulus": 6e6,
                    "relaxed_modulus": 3e6,
                    "relaxation_time": 0.125,
                },
            }
        ],
    },
    "motion": {"time": [0.0, 0.3], "distance": [0.0, 15e-3], "load": 100.0},
    "ground": {"type": "half_sine", "height": 0.1e-3, "length": 6e-3, "at": 8e-3},
    "numerics": {"nodes_per_revolution": 150, "averaged_meshes": 2, "steps_per_spacing": 2},
}


@pytest.fixture(scope="module")
def native():
    ball = vr.CoatedSphere(
        core_radius=20e-3,
        layers=[
            vr.Layer(
                thickness=1e-3,
                poisson_ratio=0.5,
                shear_modulus=vr.StandardLinearSolid(
                    instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125
                ),
            )
        ],
    )
    return vr.roll(
        ball,
        time=[0.0, 0.3],
        distance=[0.0, 15e-3],
        load=100.0,
        ground=vr.Profile.half_sine(0.1e-3, length=6e-3, at=8e-3),
        mesh=vr.Mesh(nodes_per_revolution=150),
        averaged_meshes=2,
        steps_per_spacing=2,
    )


def assert_history(answer, parts, native):
    assert answer == {
        "result": {"steps": len(native.time) - 1, "nodes_per_revolution": 150, "spectrum_error": native.spectrum_error}
    }
    assert len(parts) > 5
    for name in ("distance", *HISTORY_SCALARS):
        np.testing.assert_array_equal([one for part in parts for one in part[name]], getattr(native, name), name)


def test_parts_are_the_instants_of_roll(native):
    parts = []
    assert_history(history_answer({"case": TABLES}, receive=parts.append), parts, native)


def test_undetermined_values_are_none():
    parts = []
    history_answer({"case": TABLES | {"numerics": {"averaged_meshes": 1}}}, receive=parts.append)
    assert parts[0]["error_estimate"] == [None]


def test_the_table_of_time_series_has_their_units():
    table = {one["name"]: one["unit"] for one in history_scalars()}
    assert table == {"distance": "m"} | {name: unit for name, (unit, _) in HISTORY_SCALARS.items()}


@pytest.mark.parametrize(
    ("request_", "parameter"),
    [
        (3, "request"),
        ({"case": TABLES, "fields": True}, "request"),
        ({"case": 3}, "case"),
        ({"case": TABLES | {"ground": {"type": "file", "file": "/etc/passwd"}}}, "ground.file"),
        ({"case": TABLES | {"ground": {"type": "step", "height": 1e-4}}}, "ground.at"),
        ({"case": TABLES | {"axle": {"mass": -1.0}}}, "axle.mass"),
        ({"case": TABLES | {"motion": {"file": "/etc/passwd"}}}, "motion.file"),
    ],
)
def test_errors_name_the_parameter(request_, parameter):
    assert history_answer(request_, receive=pytest.fail)["error"]["parameter"] == parameter


def test_a_receiver_can_end_a_history():
    parts = []

    def receive(part):
        parts.append(part)
        if len(parts) == 3:
            raise InterruptedError

    with pytest.raises(InterruptedError):
        history_answer({"case": TABLES}, receive=receive)
    assert len(parts) == 3


def test_the_server_sends_parts_as_they_are_computed(server, native):
    with closing(http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=60)) as connection:
        connection.request("POST", f"/{server.token}/roll", json.dumps({"case": TABLES}))
        response = connection.getresponse()
        assert response.headers["Content-Type"] == "application/x-ndjson; charset=utf-8"
        lines = [json.loads(line) for line in response]
    *parts, last = lines
    assert_history(last["answer"], [line["part"] for line in parts], native)


def test_the_server_has_the_table_of_time_series(server):
    with closing(http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=60)) as connection:
        connection.request("POST", f"/{server.token}/history_scalars")
        assert json.loads(connection.getresponse().read()) == history_scalars()
