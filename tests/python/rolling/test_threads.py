"""Concurrent calls return the results of a single thread. Run these tests also on a Python without the GIL."""

from __future__ import annotations

import copy
import random
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import paper

MESH = vr.Mesh(nodes_per_revolution=150)
CASE = {"load": 100.0, "angular_speed": 2.5, "mesh": MESH}
COARSE = vr.Mesh(nodes_per_revolution=64)


def _ball_with_python_modulus():
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = vr.Layer(thickness=1e-3, shear_modulus=lambda w: rubber.complex_modulus(w), poisson_ratio=0.5)
    return vr.CoatedSphere(core_radius=20e-3, layers=[layer])


def _reject_negative_load():
    with pytest.raises(ValueError, match="load must be"):
        vr.solve(paper.ball(), **CASE | {"load": -1.0})
    return "rejected"


def _stop_by_progress():
    def stop(*_):
        raise InterruptedError

    with pytest.raises(InterruptedError):
        vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=20000), progress=stop)
    return "stopped"


MODEL = vr.RollingModel(paper.ball(), angular_speed=2.5, mesh=MESH)

TASKS = {
    "solve": lambda: vr.solve(paper.ball(), **CASE).resisting_torque,
    "friction": lambda: vr.solve(paper.ball(), **CASE, friction=0.3).driving_torque,
    "vertical": lambda: vr.solve(paper.ball(), **CASE, compliance="vertical").resisting_torque,
    "python modulus": lambda: vr.solve(_ball_with_python_modulus(), **CASE).resisting_torque,
    "progress": lambda: vr.solve(paper.ball(), **CASE, progress=lambda *_: None).resisting_torque,
    "model": lambda: MODEL.solve(load=80.0).resisting_torque,
    "interior": lambda: float(MODEL.solve(load=80.0).interior(depth=[0.5e-3]).von_mises.max()),
    "roll": lambda: vr.roll(
        paper.ball(), time=[0.0, 0.1], angle=[0.0, 0.2], load=50.0, mesh=COARSE, averaged_meshes=1
    ).resisting_torque[-1],
    "rejected load": _reject_negative_load,
    "stop": _stop_by_progress,
}


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
def test_concurrent_calls_equal_single_thread():
    expected = {name: task() for name, task in TASKS.items()}
    names = list(TASKS) * 4
    random.Random(1).shuffle(names)
    start = threading.Barrier(8)

    def work(part):
        start.wait()
        return [(name, TASKS[name]()) for name in part]

    with ThreadPoolExecutor(8) as pool:
        done = [pair for pairs in pool.map(work, [names[i::8] for i in range(8)]) for pair in pairs]
    assert len(done) == len(names)
    for name, found in done:
        assert found == expected[name], name


def test_history_is_read_and_copied_while_it_advances():
    times = np.linspace(0.0, 0.2, 21)[1:]

    def make_history():
        return vr.RollingHistory(paper.ball(), load=50.0, mesh=COARSE, averaged_meshes=1, steps_per_spacing=None)

    alone, shared = make_history(), make_history()
    expected = [alone.advance(time=t, angle=2.0 * t, load=50.0).resisting_torque for t in times]
    ended, observed = threading.Event(), []

    def watch():
        while not ended.is_set():
            state, now, copied = shared.state, shared.current, copy.copy(shared)
            assert state.numbers.size
            assert shared.contact.pressure.max() > 0.0
            observed.append((now.time, copied.current.time))

    with ThreadPoolExecutor(3) as pool:
        watchers = [pool.submit(watch) for _ in range(3)]
        try:
            found = [shared.advance(time=t, angle=2.0 * t, load=50.0).resisting_torque for t in times]
        finally:
            ended.set()
        for watcher in watchers:
            watcher.result()
    assert found == expected
    assert all(before <= after for before, after in observed)
