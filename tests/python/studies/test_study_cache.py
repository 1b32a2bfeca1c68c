"""Caches of studies: keys from all inputs, which points are stored, and recovery after an interruption."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import pickle
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool

import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll import enums, paper
from viscoroll.studies import run as running
from viscoroll.studies.cache import database_path
from viscoroll.studies.plan import plan_sweep

MESH = vr.Mesh(nodes_per_revolution=100, max_order=50)
SPEED = {"angular_speed": 2.5, "mesh": MESH}
LOADS = [20.0, 50.0, 100.0]


def sweep(*arguments, **parameters):
    return vr.sweep(*arguments, **{"progress": False} | SPEED | parameters)


def coated(modulus, thickness=1e-3):
    layer = vr.Layer(thickness=thickness, shear_modulus=modulus, poisson_ratio=0.5, density=1000.0)
    return vr.CoatedSphere(core_radius=20e-3, layers=[layer])


@pytest.fixture
def solves(monkeypatch):
    """Collect the loads of all points that this process solves."""
    loads = []

    def solve_point(solver, **case):
        loads.append(case["load"])
        return solver(**case)

    monkeypatch.setattr(running, "solve_point", solve_point)
    return loads


def same_numbers(one, other):
    one, other = one.copy(), other.copy()
    one.attrs, other.attrs = {}, {}
    xarray.testing.assert_identical(one, other)


def test_a_complete_cache_is_read(tmp_path, paper_ball, solves):
    path = tmp_path / "study.nc"
    study = sweep(paper_ball, load=LOADS, cache=path, fields=["pressure"])
    assert sorted(file.name for file in tmp_path.iterdir()) == ["study.nc", "study.nc.points"]
    xarray.testing.assert_identical(sweep(paper_ball, load=LOADS, cache=str(path), fields=["pressure"]), study)
    path.unlink()
    same_numbers(sweep(paper_ball, load=LOADS, cache=path, fields=["pressure"]), study)
    assert sorted(solves) == LOADS


def test_a_study_grows(tmp_path, solves):
    path = tmp_path / "study.nc"
    sweep(paper.ball, load=LOADS[:2], thickness=1e-3, cache=path)
    grown = {"load": [*LOADS, 30.0], "thickness": [2e-3, 1e-3], "friction": [0.0, 0.1]}
    sweep(paper.ball, **grown, cache=path)
    assert len(solves) == 2 + (16 - 2)
    study = sweep(paper.ball, **grown | {"angular_speed": [2.5, 1.0]}, cache=path)
    assert len(solves) == 16 + 16
    # Tables reach as far as the largest load of a task requires, which changes round-off.
    direct = sweep(paper.ball, **grown | {"angular_speed": [2.5, 1.0]})
    for name in ("resisting_torque", "slip_power", "penetration"):
        np.testing.assert_allclose(study[name], direct[name], rtol=1e-9, atol=1e-12)
    xarray.testing.assert_identical(xarray.load_dataset(path), study)
    # Part of the study is also in the cache; points with fields are different ones.
    solves.clear()
    part = sweep(paper.ball, load=[50.0], thickness=1e-3, cache=path)
    there = study.sel(load=50.0, thickness=1e-3, friction=0.0, angular_speed=2.5)
    assert part.resisting_torque.item() == there.resisting_torque.item()
    assert solves == []
    sweep(paper.ball, **grown, fields=["pressure"], cache=path)
    assert len(solves) == 16


def test_keys_of_points_depend_on_all_inputs(tmp_path, rubber, solves):
    """Another study with the same cache has other points; equivalent inputs give the same points."""

    def count(ball, **changes):
        solves.clear()
        case = {"load": [20.0], "compliance": enums.Compliance.VERTICAL, "cache": tmp_path / "study.nc"}
        sweep(ball, **case | changes)
        return len(solves)

    assert count(paper.ball()) == 1
    assert count(coated(rubber), friction=0.0, drive=vr.Drive(force=0.0), load=np.array([20])) == 0
    for changes in (
        {"friction": 0.1},
        {"friction": 0.1, "drive": vr.Drive(creepage=0.01)},
        {"compliance": enums.Compliance.RADIAL},
        {"mesh": vr.Mesh(nodes_per_revolution=102, max_order=51)},
        {"mesh": None, "accuracy": 0.1},
        {"mesh": None, "accuracy": 0.2},
        {"angular_speed": 2.4},
        {"max_iterations": 499},
        {"patch_load": enums.PatchLoad.SPHERICAL},
    ):
        assert [count(paper.ball(), **changes) for _ in range(2)] == [1, 0]
    for ball in (paper.ball(density=900.0), paper.ball(thickness=1.1e-3), coated(rubber.complex_modulus)):
        assert count(ball) == 1
    assert count(coated(lambda omega: rubber.complex_modulus(omega))) == 0  # another function with the same values
    assert count(coated(lambda omega: 1.1 * rubber.complex_modulus(omega))) == 1


def key_of(modulus, mesh):
    (key,) = plan_sweep(coated(modulus), {"load": 1.0, "angular_speed": 2.0, "mesh": mesh}, fields=()).keys
    return key


@pytest.mark.parametrize(
    ("mesh", "highest"),
    [
        (None, 2_000_000),
        (vr.Mesh(nodes_per_revolution=200_000), 400_000),
        (vr.Mesh(nodes_per_revolution=100, max_order=70), 70),
    ],
)
def test_keys_sample_functions_up_to_the_highest_frequency_of_the_mesh(mesh, highest):
    def softens_from(order):
        return lambda omega: np.where(np.asarray(omega) < 2.0 * order, 3e6, 1e6) + 0j

    # Sample frequencies have equal ratios, at most 1.17.
    assert len({key_of(softens_from(order), mesh) for order in (0.8 * highest, 0.5 * highest, 1e9)}) == 3
    assert key_of(softens_from(1.01 * highest), mesh) == key_of(softens_from(1e9), mesh)


def test_keys_of_functions_that_fail_at_some_frequencies():
    def known_to(end, modulus):
        def function(omega):
            if np.max(omega) > end:
                raise ValueError("no data")
            return np.full(np.shape(omega), modulus, dtype=complex)

        return function

    assert key_of(known_to(100.0, 3e6), None) != key_of(known_to(100.0, 2e6), None)
    assert key_of(known_to(100.0, 3e6), None) == key_of(known_to(100.0, 3e6), None)


class PicklingExecutor(Executor):
    """Executor that runs each task immediately in this process, but requires arguments that can be pickled."""

    def submit(self, function, *arguments):
        """Solve."""
        future = Future()
        try:
            future.set_result(function(*pickle.loads(pickle.dumps(arguments))))
        except Exception as error:
            future.set_exception(error)
        return future


def test_a_task_that_cannot_be_pickled_raises_and_solved_points_are_stored(tmp_path, rubber, solves):
    def coated(function):
        modulus = (lambda w: rubber.complex_modulus(w)) if function else rubber
        layer = vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.5, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    parameters = {"load": LOADS, "function": [True, False], "cache": tmp_path / "study.nc"}
    with pytest.raises((AttributeError, pickle.PicklingError), match=r"local object.*coated"):
        sweep(coated, **parameters, executor=PicklingExecutor())
    assert solves == LOADS
    study = sweep(coated, **parameters)
    assert len(solves) == 6
    np.testing.assert_allclose(
        study.resisting_torque.sel(function="True"), study.resisting_torque.sel(function="False"), rtol=1e-12
    )


def test_errors_of_the_system_are_not_stored(tmp_path, monkeypatch, paper_ball, solves):
    counting = running.solve_point

    def exhausted(solver, **case):
        if case["load"] == 50.0:
            raise MemoryError
        return counting(solver, **case)

    monkeypatch.setattr(running, "solve_point", exhausted)
    with pytest.raises(MemoryError):
        sweep(paper_ball, load=LOADS, cache=tmp_path / "study.nc")
    monkeypatch.setattr(running, "solve_point", counting)
    assert not sweep(paper_ball, load=LOADS, cache=tmp_path / "study.nc").resisting_torque.isnull().any()
    assert sorted(solves) == LOADS


def test_failed_points_are_nan_with_their_message(tmp_path, solves):
    parameters = {"thickness": [-1.0, 1e-3], "load": [100.0, 1e9], "cache": tmp_path / "study.nc"}
    with pytest.warns(
        vr.ResultWarning, match="^among 4 points: 1 COARSE_MESH, 3 FAILED; see status, warnings and error of the study$"
    ):
        study = sweep(paper.ball, **parameters, fields=["pressure"])
    assert np.isnan(study.resisting_torque).values.tolist() == [[True, True], [False, True]]
    assert study.status.values.tolist() == [["FAILED", "FAILED"], ["CONVERGED", "FAILED"]]
    assert study.attrs["statuses"] == "3 FAILED, 1 CONVERGED"
    assert "load must be small enough for the coating, got 1e+09 N" in study.error.values[1, 1]
    assert study.error.values[0, 0] == "InvalidInput: thickness must be > 0 m, got -1"
    assert study.error.values[1, 0] == ""
    assert len(solves) == 2
    for retry_failed, solved in ((False, 2), (True, 3)):
        with pytest.warns(vr.ResultWarning, match="3 FAILED"):
            same_numbers(sweep(paper.ball, **parameters, fields=["pressure"], retry_failed=retry_failed), study)
        assert len(solves) == solved
    assert solves[2] == 1e9


def test_points_that_miss_the_accuracy_are_stored_and_counted(tmp_path, solves):
    # The smaller contact is narrower than the spacing of any allowed mesh.
    parameters = {"load": [1e-13, 100.0], "mesh": None, "accuracy": 0.2, "cache": tmp_path / "study.nc"}
    message = "^among 2 points: 1 ACCURACY_NOT_REACHED; see warnings of the study$"
    for _ in range(2):
        with pytest.warns(vr.ResultWarning, match=message):
            study = sweep(paper.ball(density=0.0), **parameters)
        assert study.attrs["statuses"] == "1 ACCURACY_NOT_REACHED, 1 CONVERGED"
        assert study.resisting_torque.notnull().all()
    assert len(solves) == 2


def test_errors_of_a_corrected_function_of_the_ball_are_not_reused(tmp_path, solves):
    def with_a_bug(thickness):
        return paper.ball(thickness=thickness if thickness < 1.5e-3 else thicknes)  # noqa: F821

    parameters = {"thickness": [1e-3, 2e-3], "load": LOADS, "cache": tmp_path / "study.nc"}
    with pytest.warns(vr.ResultWarning, match="3 FAILED"):
        study = sweep(with_a_bug, **parameters)
    assert study.error.values[1, 0] == "NameError: name 'thicknes' is not defined"
    study = sweep(paper.ball, **parameters)
    assert (study.status == "CONVERGED").all()
    assert len(solves) == 6


def test_errors_of_a_corrected_modulus_are_not_reused(tmp_path, rubber):
    def fails_once_solved(error):
        """Return a ball whose modulus fails at a frequency that solves use and keys do not sample."""

        def modulus(omega):
            if error is not None and np.isclose(omega, 37 * SPEED["angular_speed"]).any():
                raise error
            return rubber.complex_modulus(omega)

        return coated(modulus)

    case = {"load": LOADS, "cache": tmp_path / "study.nc"}
    for error in (ZeroDivisionError("oops"), ValueError("oops")):
        with pytest.warns(vr.ResultWarning, match="3 FAILED"):
            study = sweep(fails_once_solved(error), **case)
        assert set(study.error.values.tolist()) == {f"{type(error).__name__}: oops"}
    for error in (MemoryError(), ImportError("no module")):
        with pytest.raises(type(error)):
            sweep(fails_once_solved(error), **case)
    assert (sweep(fails_once_solved(None), **case).status == "CONVERGED").all()


def test_import_errors_of_functions_are_raised():
    def needs_a_package(thickness):
        raise ImportError("no module")

    with pytest.raises(ImportError, match="no module"):
        sweep(needs_a_package, thickness=[1e-3, 2e-3], load=LOADS)


class EndsOtherProcesses:
    """Modulus that terminates any process except the one that created it."""

    def __init__(self):
        self.home = os.getpid()

    def __call__(self, omega):
        """Return an elastic modulus, or end the process."""
        if os.getpid() != self.home:
            os._exit(1)
        return np.full(np.shape(omega), 3e6, dtype=complex)


def test_a_broken_process_pool_raises_and_is_not_stored(tmp_path):
    modulus = EndsOtherProcesses()
    parameters = {"thickness": [1e-3, 2e-3], "load": LOADS, "cache": tmp_path / "study.nc"}
    pool = ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"))
    with pool, pytest.raises(BrokenProcessPool):
        sweep(lambda thickness: coated(modulus, thickness), **parameters, executor=pool)
    study = sweep(lambda thickness: coated(modulus, thickness), **parameters)
    assert (study.status == "CONVERGED").all()


def run_until(program, ready, sent):
    """Run a program, send it a signal when `ready()` holds, and return its output and exit code."""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        deadline = time.monotonic() + 60.0  # keeps a failure from hanging; no test depends on timing
        while not ready() and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.01)
        assert process.poll() is None, "the program ended too early"
        process.send_signal(sent)
        output, _ = process.communicate(timeout=60)
        return output, process.returncode


def stored_points(path):
    """Count the points that another process has stored, in a copy, because that process locks the file."""
    if not database_path(path).exists():
        return 0
    copied = shutil.copy(database_path(path), path.with_name("copy"))
    with contextlib.closing(sqlite3.connect(copied)) as database:
        try:
            return database.execute("SELECT count(*) FROM point").fetchone()[0]
        except sqlite3.DatabaseError:  # copied during a transaction
            return 0


def settled(path, count):
    """Return whether `count` points are stored, and still are after the time of another transaction."""
    if stored_points(path) != count:
        return False
    time.sleep(0.5)
    return stored_points(path) == count


def test_stored_points_survive_a_killed_process(tmp_path, solves):
    path = tmp_path / "study.nc"
    loads = [float(load) for load in range(10, 50, 2)]
    program = f"""
import threading, viscoroll as vr
from viscoroll import paper
from viscoroll.studies import run
left = iter(range(7))

def solve_point(solver, **case):
    if next(left, None) is None:
        threading.Event().wait()  # in the middle of a point, until killed
    return solver(**case)

run.solve_point = solve_point
mesh = vr.Mesh(nodes_per_revolution=100, max_order=50)
vr.sweep(paper.ball, load={loads}, thickness=1e-3, angular_speed=2.5, mesh=mesh, cache={str(path)!r}, progress=False)
"""
    _, code = run_until(program, lambda: settled(path, 7), signal.SIGKILL)
    assert code == -signal.SIGKILL
    study = sweep(paper.ball, load=loads, thickness=1e-3, cache=path)
    assert len(solves) == len(loads) - 7
    same_numbers(study, sweep(paper.ball, load=loads, thickness=1e-3))


def test_ctrl_c_stops_and_keeps_stored_points(tmp_path, solves):
    path = tmp_path / "study.nc"
    program = f"""
import viscoroll as vr
from viscoroll import paper
meshes = [vr.Mesh(nodes_per_revolution=100, max_order=n) for n in (50, 51, 52)]
meshes += [vr.Mesh(nodes_per_revolution=20000, max_order=30000 + n) for n in range(20)]
try:
    vr.sweep(paper.ball(), load=100.0, angular_speed=2.5, mesh=meshes, cache={str(path)!r}, progress=False)
except KeyboardInterrupt:
    print("stopped")
"""
    # The other points would take hours: if the program ends within the limit of `run_until`, it has stopped.
    output, code = run_until(program, lambda: stored_points(path) == 3, signal.SIGINT)
    assert (output, code) == ("stopped\n", 0)
    assert stored_points(path) == 3


def test_ctrl_c_with_an_executor_cancels_waiting_tasks(tmp_path, paper_ball, solves):
    class Stuck(PicklingExecutor):
        def submit(self, function, task):
            if len(solves) < 2:
                return super().submit(function, task)
            waiting.append(Future())
            return waiting[-1]

    waiting = []
    interrupt = threading.Timer(0.5, signal.pthread_kill, [threading.main_thread().ident, signal.SIGINT])
    interrupt.start()
    with pytest.raises(KeyboardInterrupt):
        sweep(paper_ball, load=[*LOADS, 30.0], cache=tmp_path / "study.nc", executor=Stuck())
    assert [future.cancelled() for future in waiting] == [True, True]
    sweep(paper_ball, load=[*LOADS, 30.0], cache=tmp_path / "study.nc")
    assert sorted(solves) == [20.0, 30.0, 50.0, 100.0]


def test_a_cache_of_another_version_is_rejected(tmp_path, monkeypatch, paper_ball):
    sweep(paper_ball, load=LOADS, cache=tmp_path / "study.nc")
    before = {file: file.read_bytes() for file in tmp_path.iterdir()}
    monkeypatch.setattr("viscoroll.studies.cache.__version__", "0.0.0")
    with pytest.raises(
        ValueError, match=rf"must be made by viscoroll 0.0.0, commit .*, got a cache made by {vr.__version__}, commit"
    ):
        sweep(paper_ball, load=LOADS, cache=tmp_path / "study.nc")
    assert {file: file.read_bytes() for file in tmp_path.iterdir()} == before


def test_files_that_are_not_a_cache_are_not_changed(tmp_path, paper_ball):
    path = tmp_path / "study.nc"
    points = database_path(path)

    def refused(file, error, message):
        content = file.read_bytes()
        with pytest.raises(error, match=message):
            sweep(paper_ball, load=LOADS, cache=path)
        assert file.read_bytes() == content

    for content in (b"important", b"important\n" * 1000):
        points.write_bytes(content)
        refused(points, ValueError, r"study.nc.points is damaged, or is not a file of viscoroll \(.*delete it")
    points.unlink()
    with contextlib.closing(sqlite3.connect(points)) as database:
        database.execute("CREATE TABLE point (key TEXT)")
    refused(points, ValueError, r"study.nc.points is damaged, or is not a file of viscoroll \(.*delete it")
    points.unlink()
    path.write_bytes(b"important")
    refused(path, ValueError, "study.nc is damaged, or does not belong .*: delete it")
    assert not points.exists()
    with pytest.raises(OSError, match=r"unable to open database file: .*absent.study\.nc\.points"):
        sweep(paper_ball, load=LOADS, cache=tmp_path / "absent" / "study.nc")


def test_a_cache_belongs_to_one_process_at_a_time(tmp_path, paper_ball):
    path = tmp_path / "study.nc"
    program = f"""
from pathlib import Path
from viscoroll.studies.cache import StudyCache
store = StudyCache(Path({str(path)!r}))
print("open", flush=True)
input()
"""
    with subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout.readline() == "open\n"
        with pytest.raises(ValueError, match=r"study.nc.points is in use by another study"):
            sweep(paper_ball, load=LOADS, cache=path)
        process.communicate("\n")
    assert (sweep(paper_ball, load=LOADS, cache=path).status == "CONVERGED").all()


def test_a_cache_belongs_to_one_thread_at_a_time(tmp_path, monkeypatch, paper_ball, solves):
    path, inside, done = tmp_path / "study.nc", threading.Event(), threading.Event()
    counting = running.solve_point

    def wait(solver, **case):
        inside.set()
        assert done.wait(timeout=60)
        return counting(solver, **case)

    monkeypatch.setattr(running, "solve_point", wait)
    with ThreadPoolExecutor(1) as thread:
        study = thread.submit(sweep, paper_ball, load=LOADS, cache=path)
        assert inside.wait(timeout=60)
        with pytest.raises(ValueError, match=r"study.nc.points is in use by another study"):
            sweep(paper_ball, load=LOADS, cache=path)
        done.set()
    same_numbers(sweep(paper_ball, load=LOADS, cache=path), study.result())
    assert sorted(solves) == LOADS
