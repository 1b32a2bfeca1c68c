"""Parameter studies: what a dataset holds, where points are solved, and what survives an interruption."""

from __future__ import annotations

import multiprocessing
import pickle
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor

import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll import paper
from viscoroll.studies import run as running
from viscoroll.studies.cache import journal_path
from viscoroll.studies.plan import plan_sweep

MESH = vr.Mesh(nodes_per_revolution=100, max_order=50)
SPEED = {"angular_speed": 2.5, "mesh": MESH}
LOADS = [20.0, 50.0, 100.0]


def sweep(*arguments, **parameters):
    return vr.sweep(*arguments, **{"progress": False} | SPEED | parameters)


@pytest.fixture
def solves(monkeypatch):
    """Collect the loads of all points solved in this process."""
    loads = []

    def solve_point(solver, **case):
        loads.append(case["load"])
        return solver(**case)

    monkeypatch.setattr(running, "solve_point", solve_point)
    return loads


def same_numbers(one, other):
    xarray.testing.assert_identical(one.drop_attrs(deep=False), other.drop_attrs(deep=False))


def test_every_point_equals_a_direct_solve():
    study = sweep(paper.ball, thickness=[1e-3, 2e-3], friction=[0.0, 0.1], load=LOADS)
    assert study.resisting_torque.dims == ("thickness", "friction", "load")
    for h in (1e-3, 2e-3):
        for mu in (0.0, 0.1):
            for load in LOADS:
                expected = vr.solve(paper.ball(thickness=h), load=load, friction=mu, **SPEED).scalars()
                point = study.sel(thickness=h, friction=mu, load=load)
                for name, value in expected.items():
                    if isinstance(value, str) and name in study.data_vars:
                        assert point[name].item() == value
                    elif name in study.data_vars:
                        # A model's tables reach as far as its largest load asks for, which changes round-off.
                        value = np.nan if value is None else value
                        np.testing.assert_allclose(point[name].item(), value, rtol=1e-9, atol=1e-9, err_msg=name)
    assert set(expected) - set(study.variables) == {"compliance", "patch_load"}


def test_units_and_provenance(tmp_path):
    study = sweep(paper.ball, thickness=np.array([1e-3, 2e-3]), load=range(20, 60, 20), patch_load=vr.PatchLoad.FLAT)
    units = {name: study[name].attrs.get("units") for name in ("thickness", "load", "angular_speed", "max_pressure")}
    assert units == {"thickness": "m", "load": "N", "angular_speed": "rad/s", "max_pressure": "Pa"}
    assert study.angular_speed == 2.5
    assert study.attrs["version"] == vr.__version__
    assert study.attrs["commit"] == vr._core.__commit__
    assert study.attrs["mesh"] == "100 nodes per revolution, orders to 50"
    assert study.attrs["patch_load"] == "FLAT"
    assert study.attrs["material"] == repr(paper.ball().layers[0].shear_modulus)
    assert "thickness=0.002" in study.attrs["ball"]
    study.to_netcdf(tmp_path / "study.nc")
    xarray.testing.assert_identical(xarray.load_dataset(tmp_path / "study.nc"), study)


def test_objects_can_be_dimensions(rubber):
    def coated(stuff, shear_moduli):
        layers = [vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.5) for modulus in shear_moduli]
        return vr.CoatedSphere(core_radius=stuff, layers=layers)

    study = sweep(
        coated,
        stuff=[0.02],
        shear_moduli=[(rubber,), (rubber, lambda w: rubber.complex_modulus(w))],
        mesh=[MESH, vr.Mesh(nodes_per_revolution=120, max_order=60)],
        compliance=list(vr.Compliance),
        drive=[vr.Drive(force=0.0), vr.Drive(torque=0.0)],
        friction=0.2,
        load=50.0,
    )
    assert dict(study.sizes) == {"stuff": 1, "shear_moduli": 2, "mesh": 2, "compliance": 2, "drive": 2}
    assert study.mesh.values.tolist() == ["100 x 50", "120 x 60"]
    assert study.compliance.values.tolist() == ["VERTICAL", "RADIAL"]
    assert study.drive.values.tolist() == ["force=0", "torque=0"]
    assert study.shear_moduli.values.tolist() == ["shear_moduli[0]", "shear_moduli[1]"]
    assert "units" not in study.stuff.attrs
    assert study.nodes_per_revolution.sel(mesh="120 x 60").values.ravel().tolist() == [120.0] * 8
    assert (study.driving_torque.sel(drive="torque=0") == pytest.approx(0.0, abs=1e-9)).all()
    assert not study.resisting_torque.isnull().any()


def test_points_are_grouped_by_influence_table(paper_ball):
    parameters = {"load": LOADS, "friction": [0.0, 0.1], "angular_speed": [1.0, 2.5], "mesh": MESH}
    plan = plan_sweep(paper_ball, parameters, fields=())
    tasks = plan.tasks(range(12), largest=100)
    assert [(task.shared["angular_speed"], len(task.cases)) for task in tasks] == [(1.0, 6), (2.5, 6)]
    assert sorted(i for task in tasks for i in task.indices) == list(range(12))
    # Split where there would be fewer tasks than workers.
    assert [len(task.cases) for task in plan.tasks(range(12), largest=4)] == [3, 3, 3, 3]


def test_balls_are_made_once():
    made = []

    def coated(thickness):
        made.append(thickness)
        return paper.ball(thickness=thickness)

    sweep(coated, load=LOADS, thickness=[1e-3, 2e-3])
    assert made == [1e-3, 2e-3]


def test_fields_stand_in_the_middle_of_the_largest_window(paper_ball):
    study = sweep(paper_ball, load=LOADS, fields=["shear_traction", "pressure", "x"])
    results = [vr.solve(paper_ball, load=load, **SPEED) for load in LOADS]
    assert len({r.pressure.shape for r in results}) > 1
    assert study.pressure.dims == ("load", "phi", "theta")
    assert study.shear_traction.dims == ("load", "direction", "phi", "theta")
    for r in results:
        point = study.sel(load=r.load).dropna("phi", how="all", subset=["x"]).dropna("theta", how="all", subset=["x"])
        np.testing.assert_array_equal(point.pressure, r.pressure)
        np.testing.assert_array_equal(point.shear_traction, r.shear_traction)
        np.testing.assert_allclose(point.phi, r.to_xarray().phi, rtol=1e-15)
    lowest = study.sel(phi=np.pi / 2, theta=np.pi / 2, method="nearest")
    np.testing.assert_allclose(lowest.x, 0.0, atol=1e-15)
    meshes = [MESH, vr.Mesh(nodes_per_revolution=120, max_order=60)]
    mixed = sweep(paper_ball, load=50.0, mesh=meshes, fields="contact")
    np.testing.assert_array_equal(mixed.contact.sum(["phi", "theta"]), mixed.contact_nodes)
    assert mixed.phi.sel(phi=0) == 0
    assert mixed.phi.attrs["units"] == "1"


def test_process_pool(tmp_path):
    parameters = {"load": LOADS, "thickness": [1e-3, 2e-3], "fields": ["pressure"]}
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        study = sweep(paper.ball, **parameters, executor=pool, cache=tmp_path / "study.nc")
    same_numbers(study, sweep(paper.ball, **parameters))


def test_dask_cluster():
    from distributed import Client, LocalCluster

    parameters = {"load": LOADS, "thickness": [1e-3, 2e-3]}
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        study = sweep(paper.ball, **parameters, executor=client.get_executor())
    same_numbers(study, sweep(paper.ball, **parameters))


class PicklingExecutor(Executor):
    """Solves here, at once, but takes only what could be sent elsewhere."""

    def submit(self, function, *arguments):
        """Solve."""
        future = Future()
        try:
            future.set_result(function(*pickle.loads(pickle.dumps(arguments))))
        except Exception as error:
            future.set_exception(error)
        return future


def test_what_cannot_be_sent_is_raised_and_the_rest_is_kept(tmp_path, rubber, solves):
    def coated(function):
        modulus = (lambda w: rubber.complex_modulus(w)) if function else rubber
        layer = vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.5, density=1000.0)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    parameters = {"load": LOADS, "function": [True, False], "cache": tmp_path / "study.nc"}
    with pytest.raises((AttributeError, pickle.PicklingError), match="pickle"):
        sweep(coated, **parameters, executor=PicklingExecutor())
    assert solves == LOADS
    study = sweep(coated, **parameters)
    assert len(solves) == 6
    np.testing.assert_allclose(
        study.resisting_torque.sel(function="True"), study.resisting_torque.sel(function="False"), rtol=1e-12
    )


def test_failed_points_are_nan_with_their_message(tmp_path, solves):
    parameters = {"thickness": [-1.0, 1e-3], "load": [100.0, 1e9], "cache": tmp_path / "study.nc"}
    study = sweep(paper.ball, **parameters, fields=["pressure"])
    assert np.isnan(study.resisting_torque).values.tolist() == [[True, True], [False, True]]
    assert study.status.values.tolist() == [["FAILED", "FAILED"], ["CONVERGED", "FAILED"]]
    assert "load must be small enough for the coating, got 1e+09 N" in study.error.values[1, 1]
    assert study.error.values[0, 0] == "ValueError: thickness must be > 0 m, got -1"
    assert study.error.values[1, 0] == ""
    assert len(solves) == 2
    same_numbers(sweep(paper.ball, **parameters, fields=["pressure"]), study)
    assert len(solves) == 2


def test_an_error_of_the_machine_is_not_the_points(tmp_path, monkeypatch, paper_ball, solves):
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


def test_a_complete_cache_is_read(tmp_path, paper_ball, solves):
    path = tmp_path / "study.nc"
    study = sweep(paper_ball, load=LOADS, cache=path, fields=["pressure"])
    assert [file.name for file in tmp_path.iterdir()] == ["study.nc"]
    xarray.testing.assert_identical(sweep(paper_ball, load=LOADS, cache=str(path), fields=["pressure"]), study)
    assert sorted(solves) == LOADS


def test_a_journal_cut_anywhere_is_resumed(tmp_path, monkeypatch, paper_ball, solves):
    path = tmp_path / "study.nc"
    monkeypatch.setattr("viscoroll.studies.study.write_study", lambda *_: None)
    expected = sweep(paper_ball, load=LOADS, cache=path, fields=["pressure"])
    whole = journal_path(path).read_bytes()
    ends = [i + 1 for i, byte in enumerate(whole) if byte == ord("\n")]
    assert len(ends) == 4
    cuts = np.random.default_rng(1).integers(0, len(whole), 12)
    for cut in sorted({0, 1, *ends, *(end - 1 for end in ends), *cuts.tolist()}):
        journal_path(path).write_bytes(whole[:cut])
        solves.clear()
        same_numbers(sweep(paper_ball, load=LOADS, cache=path, fields=["pressure"]), expected)
        assert len(solves) == 3 - max(0, sum(end <= cut for end in ends) - 1)


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


def lines(path):
    return journal_path(path).read_bytes().count(b"\n") if journal_path(path).exists() else 0


def test_nothing_is_lost_on_kill(tmp_path, solves):
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
    _, code = run_until(program, lambda: lines(path) == 8, signal.SIGKILL)
    assert code == -signal.SIGKILL
    study = sweep(paper.ball, load=loads, thickness=1e-3, cache=path)
    assert len(solves) == len(loads) - 7
    same_numbers(study, sweep(paper.ball, load=loads, thickness=1e-3))


def test_ctrl_c_stops_and_keeps(tmp_path, solves):
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
    # The other points would take hours: that the program ends within the time limit of `run_until` shows that it stops.
    output, code = run_until(program, lambda: lines(path) == 4, signal.SIGINT)
    assert (output, code) == ("stopped\n", 0)
    assert lines(path) == 4


def test_ctrl_c_with_an_executor_cancels_what_waits(tmp_path, paper_ball, solves):
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


def test_a_cache_of_other_inputs_is_refused(tmp_path, monkeypatch, paper_ball, rubber, solves):
    def coated(scale):
        layer = vr.Layer(thickness=1e-3, shear_modulus=lambda w: scale * rubber.complex_modulus(w), poisson_ratio=0.5)
        return lambda: vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    complete, partial, functions = (tmp_path / name for name in ("complete.nc", "partial.nc", "functions.nc"))
    sweep(paper_ball, load=LOADS, cache=complete)
    with monkeypatch.context() as patch:
        patch.setattr("viscoroll.studies.study.write_study", lambda *_: None)
        sweep(paper_ball, load=LOADS, cache=partial)
        sweep(coated(1.0), load=LOADS, cache=functions)
    count = len(solves)
    for path in (complete, partial):
        before = {file: file.read_bytes() for file in tmp_path.iterdir()}
        message = r"was made with other inputs .* got load \(20.0, 50.0, 100.0\), not \(20.0, 50.0\)"
        with pytest.raises(ValueError, match=message):
            sweep(paper_ball, load=LOADS[:2], cache=path)
        with pytest.raises(ValueError, match=r"made with other inputs .*, got balls"):
            sweep(paper.ball(density=900.0), load=LOADS, cache=path)
        with pytest.raises(ValueError, match=r"made with other inputs .*, got friction not given, not 0.1"):
            sweep(paper_ball, load=LOADS, friction=0.1, cache=path)
        with monkeypatch.context() as patch:
            patch.setattr("viscoroll.studies.plan.__version__", "0.0.0")
            with pytest.raises(ValueError, match=r"made with other inputs .*, got viscoroll"):
                sweep(paper_ball, load=LOADS, cache=path)
        assert {file: file.read_bytes() for file in tmp_path.iterdir()} == before
    sweep(coated(1.0), load=LOADS, cache=functions)  # another function with the same values
    with pytest.raises(ValueError, match=r"made with other inputs .*, got balls"):
        sweep(coated(1.1), load=LOADS, cache=tmp_path / "functions.nc")
    assert len(solves) == count


def test_files_that_are_no_cache_are_left_alone(tmp_path, paper_ball):
    path = tmp_path / "study.nc"
    for content in (b"important", b"important\n", b'{"format": 3}\n'):
        journal_path(path).write_bytes(content)
        with pytest.raises(ValueError, match=r"study.nc.partial (must be|is damaged)"):
            sweep(paper_ball, load=LOADS, cache=path)
        assert journal_path(path).read_bytes() == content
    path.write_bytes(b"important")
    with pytest.raises(ValueError, match="must be a study of viscoroll, got another file"):
        sweep(paper_ball, load=LOADS, cache=path)
    assert path.read_bytes() == b"important"
    xarray.Dataset({"a": 1.0}).to_netcdf(path)
    with pytest.raises(ValueError, match="must be a study of viscoroll, got another dataset"):
        sweep(paper_ball, load=LOADS, cache=path)


def test_a_cache_belongs_to_one_process_at_a_time(tmp_path, paper_ball):
    path = tmp_path / "study.nc"
    program = f"""
from pathlib import Path
from viscoroll.studies.cache import Journal
journal = Journal(Path({str(journal_path(path))!r}), {{}})
print("open", flush=True)
input()
"""
    with subprocess.Popen(
        [sys.executable, "-c", program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout.readline() == "open\n"
        with pytest.raises(ValueError, match="is in use by another process"):
            sweep(paper_ball, load=LOADS, cache=path)
        process.communicate("\n")


def test_progress_has_an_estimate_of_the_time_left(capsys, paper_ball):
    sweep(paper_ball, load=LOADS, progress=True)
    shown = capsys.readouterr().err
    assert "3/3" in shown
    assert "point" in shown
    assert "<" in shown  # elapsed < left


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"load": []}, ValueError, "load must have at least one value, got none"),
        ({"load": [1.0, 2.0, 1.0]}, ValueError, "load must have different values, got 1.0 twice"),
        ({"load": [[1.0, 2.0]]}, TypeError, "load must be a real number, got list"),
        ({"load": np.ones((2, 2))}, ValueError, r"load must be a scalar or one-dimensional, got shape \(2, 2\)"),
        ({"load": ["heavy"]}, TypeError, "load must be a real number, got str 'heavy'"),
        ({"mesh": [100]}, TypeError, "mesh must be a viscoroll.Mesh, got 100"),
        ({"max_iterations": 1.5}, TypeError, "max_iterations must be a whole number"),
        ({"accuracy": 0.1}, ValueError, "accuracy must be left out where a mesh is given"),
        ({"thicknes": 1e-3}, TypeError, "ball, called with thicknes: got an unexpected keyword argument"),
        ({"penetration": 1e-3}, ValueError, "must have other names than results, got penetration"),
        (
            {"thickness": [-1.0, -2.0]},
            ValueError,
            "every point fails, the first with ValueError: thickness must be > 0",
        ),
        ({"fields": ["heat"]}, ValueError, "fields must be of x, z, pressure, .*, got 'heat'"),
        ({"executor": 4}, TypeError, "executor must be a concurrent.futures.Executor or None, got 4"),
        ({"cache": "study.json"}, ValueError, "cache must end in .nc, got 'study.json'"),
    ],
)
def test_bad_arguments(changes, error, message):
    with pytest.raises(error, match=message):
        sweep(paper.ball, **{"load": LOADS} | changes)


def test_bad_balls(paper_ball):
    with pytest.raises(TypeError, match="a ball has no parameter thickness; pass a function of thickness"):
        sweep(paper_ball, load=LOADS, thickness=[1e-3])
    with pytest.raises(TypeError, match=r"ball must be a viscoroll.CoatedSphere or a function that returns one, got 3"):
        sweep(3, load=LOADS)
    with pytest.raises(TypeError, match=r"ball must return a viscoroll.CoatedSphere, got 1.0"):
        sweep(lambda thickness: 1.0, load=LOADS, thickness=[1.0])
    with pytest.raises(TypeError, match="sweep needs angular_speed and load"):
        vr.sweep(paper_ball)
