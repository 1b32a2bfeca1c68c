"""Behavior of the Python interface: reprs, copies, threads, Ctrl-C, and files."""

from __future__ import annotations

import copy
import csv
import dataclasses
import inspect
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import meshio
import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll import _core, enums, paper
from viscoroll.case import motion
from viscoroll.solution import FIELDS, VECTOR_FIELDS
from viscoroll.solution.scalars import SCALARS
from viscoroll.transient.options import HistoryKeywords, HistoryOptions

DOCS = Path(__file__).parents[3] / "docs"
MESH = vr.Mesh(nodes_per_revolution=300, max_order=300)


@pytest.fixture(scope="module")
def result():
    return vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=MESH)


MODULES = {name: value for name in vr.__all__ if inspect.ismodule(value := getattr(vr, name))}


def test_the_public_interface_is_small():
    assert len(vr.__all__) <= 47
    assert all(inspect.getdoc(module) for module in MODULES.values())


@pytest.mark.parametrize("name", ["viscoroll", *MODULES])
def test_every_public_name_is_documented_on_one_page(name):
    module = MODULES.get(name, vr)  # objects of the package are not documented again on the pages of modules
    names = [one for one in module.__all__ if module is vr or getattr(module, one) is not getattr(vr, one, None)]
    names = [one for one in names if one not in MODULES and one != "__version__"]
    page = (DOCS / f"api/{'python' if name == 'viscoroll' else name}.md").read_text(encoding="utf-8")
    listed = re.findall(r"^   (\w+)$", page, flags=re.MULTILINE)
    assert sorted({*listed, *re.findall(r"`([A-Z_0-9]+)`", page)}) == sorted(names)
    assert all(inspect.getdoc(getattr(MODULES.get(name, vr), one)) for one in listed)


def test_defaults_agree_with_the_core():
    defaults = {name: p.default for name, p in inspect.signature(vr.solve).parameters.items()}
    options = _core.Options()
    for name in ("compliance", "patch_load", "slip_kinematics", "finite_strain", "max_iterations", "threads"):
        assert defaults[name] == getattr(options, name)
    assert options.accuracy == 0.01


def test_options_of_histories_are_the_same_everywhere():
    options = {option.name: option.default for option in dataclasses.fields(HistoryOptions)}
    core = _core.HistoryOptions()
    in_core = options | {"driving_force": options["drive"].force, "driving_torque": options["drive"].torque}
    del in_core["drive"]
    assert {name: getattr(core, name) for name in in_core} == in_core
    assert list(HistoryKeywords.__annotations__) == list(options)
    for function in (vr.roll, vr.RollingHistory):
        parameters = inspect.signature(function).parameters
        assert {name: parameters[name].default for name in options} == options
        assert all(f"\n{name} : " in function.__doc__ for name in options)
        assert "options" not in function.__doc__
    numerics = motion.Numerics().arguments()
    tables = {"ground", "tread", "axle"}
    assert tables <= motion.MotionFile.model_fields.keys()
    in_files = set(motion.Motion.model_fields) | {"drive", *numerics, *tables}
    assert options.keys() - in_files == {"threads"}
    assert numerics == {name: options[name] for name in numerics}


@pytest.mark.parametrize(
    "value",
    [
        vr.Elastic(modulus=1.0),
        vr.Prony(instantaneous_modulus=1.0, weights=np.array([0.1]), relaxation_times=[1.0]),
        vr.MasterCurve([1.0, 2.0], [1.0, 2.0], [0.0, 0.1], extrapolation=enums.Extrapolation.HOLD),
        MESH,
        vr.Drive(torque=0.1),
        vr.Drive(creepage=0.01, lateral_creepage=-0.02),
        paper.ball(),
    ],
)
def test_inputs_are_immutable_and_equal_their_repr(value):
    assert pickle.loads(pickle.dumps(value)) == value
    assert copy.deepcopy(value) == value
    assert hash(copy.copy(value)) == hash(value)
    # Enumerations print themselves as <Name.MEMBER: number>.
    assert eval(re.sub(r"<([\w.]+): \d+>", r"\1", repr(value)), vars(vr) | vars(enums)) == value
    with pytest.raises(dataclasses.FrozenInstanceError):
        setattr(value, dataclasses.fields(value)[0].name, 1.0)


@pytest.mark.parametrize(
    ("value", "twin"),
    [
        (vr.Elastic(modulus=np.array(1.0)), vr.Elastic(modulus=1.0)),
        (
            vr.StandardLinearSolid(instantaneous_modulus=2, relaxed_modulus=np.float32(1), relaxation_time=np.array(1)),
            vr.StandardLinearSolid(instantaneous_modulus=2.0, relaxed_modulus=1.0, relaxation_time=1.0),
        ),
        (
            vr.Prony(instantaneous_modulus=np.int64(1), weights=np.array([0.5]), relaxation_times=[Fraction(1, 4)]),
            vr.Prony(instantaneous_modulus=1.0, weights=[0.5], relaxation_times=[0.25]),
        ),
        (vr.Mesh(nodes_per_revolution=np.int64(300), max_order=np.uint16(300)), MESH),
        (vr.Drive(force=np.array(0.5)), vr.Drive(force=0.5)),
        (
            vr.Drive(creepage=np.float64(0.5), lateral_creepage=np.array(0)),
            vr.Drive(creepage=0.5, lateral_creepage=0.0),
        ),
        (
            vr.Layer(
                thickness=np.array(1e-3),
                shear_modulus=vr.Elastic(modulus=1.0),
                bulk_modulus=np.array(3.0),
                density=np.int8(1),
            ),
            vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=1.0), bulk_modulus=3.0, density=1.0),
        ),
        (
            vr.CoatedSphere(core_radius=np.array(20e-3), layers=list(paper.ball().layers)),
            vr.CoatedSphere(core_radius=20e-3, layers=paper.ball().layers),
        ),
    ],
)
def test_inputs_store_python_numbers(value, twin):
    # Arrays would remain mutable and have no hash; NumPy scalars would appear in the repr.
    assert repr(value) == repr(twin)
    assert hash(value) == hash(twin)


def test_results_can_be_copied(result):
    for twin in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):
        assert twin.scalars() == result.scalars()
        assert twin.body == result.body
        assert twin.refinements == result.refinements
        for name in FIELDS:
            np.testing.assert_array_equal(getattr(twin, name), getattr(result, name))


@pytest.mark.parametrize("twin", [lambda r: pickle.loads(pickle.dumps(r)), copy.deepcopy, copy.copy])
def test_copies_of_results_are_read_only(result, twin):
    for name in (*FIELDS, *VECTOR_FIELDS):
        with pytest.raises(ValueError, match="read-only"):
            getattr(twin(result), name)[0, 0] = 1.0


def test_results_are_read_only(result):
    with pytest.raises(dataclasses.FrozenInstanceError):
        result.load = 1.0
    for name in (*FIELDS, *VECTOR_FIELDS):
        with pytest.raises(ValueError, match="read-only"):
            getattr(result, name)[0, 0] = 1.0


def test_fields_share_a_shape(result):
    assert {getattr(result, name).shape for name in FIELDS} == {result.pressure.shape}
    assert {getattr(result, name).shape for name in VECTOR_FIELDS} == {(2, *result.pressure.shape)}
    assert {result.contact.dtype, result.stick.dtype, result.slip.dtype} == {np.dtype(bool)}


def test_repr_fits_a_screen_and_has_units(result):
    """The answer fits the 24 lines of a terminal, and the whole summary a window."""
    lines = repr(result).splitlines()
    assert lines.index("how certain:") <= 24
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 100
    assert "N m" in repr(result)
    assert "CONVERGED" in repr(result)


def test_dataset_has_units_and_scalars(result):
    dataset = result.to_xarray()
    assert dataset.pressure.dims == ("phi", "theta")
    assert dataset.pressure.attrs["units"] == "Pa"
    assert dataset.attrs["resisting_torque"] == result.resisting_torque
    nearest = dataset.sel(phi=np.pi / 2, theta=np.pi / 2, method="nearest")
    assert float(nearest.x) == pytest.approx(0.0, abs=1e-15)
    assert float(nearest.z) == pytest.approx(0.0, abs=1e-15)


def test_fields_can_be_saved(result, tmp_path):
    result.save(tmp_path / "fields.nc")
    with xarray.open_dataset(tmp_path / "fields.nc") as dataset:
        np.testing.assert_array_equal(dataset.pressure, result.pressure)

    result.save(tmp_path / "fields.csv")
    with (tmp_path / "fields.csv").open() as file:
        rows = list(csv.DictReader(file))
    np.testing.assert_array_equal([float(row["pressure [Pa]"]) for row in rows], result.pressure.ravel())

    assert "-0.0," not in (tmp_path / "fields.csv").read_text()
    result.save(tmp_path / "fields.vtu")
    mesh = meshio.read(tmp_path / "fields.vtu")
    np.testing.assert_array_equal(mesh.point_data["pressure"], result.pressure.ravel())
    assert len(mesh.cells[0].data) == (result.x.shape[0] - 1) * (result.x.shape[1] - 1)

    result.save(tmp_path / "UPPER.CSV")
    assert (tmp_path / "UPPER.CSV").read_text() == (tmp_path / "fields.csv").read_text()

    with pytest.raises(ValueError, match=r"path must end in .csv, .nc, .vtu or .vtk, got 'fields.xls'"):
        result.save(tmp_path / "fields.xls")


def test_plot_draws_map_and_profile(result, tmp_path):
    figure = result.plot()
    assert len(figure.axes) >= 3
    figure.savefig(tmp_path / "contact.png")
    assert (tmp_path / "contact.png").stat().st_size > 10_000


def test_all_scalars_are_attributes(result):
    assert set(SCALARS) <= {field.name for field in dataclasses.fields(result)}
    undetermined = {name for name, value in result.scalars().items() if value is None}
    of_adhesion = {"adhesion_power", "opening_energy_ratio", "closing_energy_ratio", "cohesive_zone_nodes"}
    of_adhesion |= {"attracted_area", "clean_adhesion_increase"}
    assert undetermined == {"linear_speed", "creepage", "face_distance"} | of_adhesion  # a ball has no faces
    assert all(isinstance(value, (float, int, str, type(None))) for value in result.scalars().values())


def test_every_field_is_documented():
    """The core's table documents the scalars; no other text repeats them."""
    text = inspect.getdoc(vr.Result)  # from Python 3.13 on, the compiler removes the indentation
    names = set(re.findall(r"^(\w[\w, ]*?)(?: : .*)?$", text, flags=re.MULTILINE))
    documented = {name for entry in names for name in entry.split(", ")}
    assert {field.name for field in dataclasses.fields(vr.Result)} <= documented
    assert "linear_speed : float or None\n    Speed of the center V_s [m/s]. None without friction" in text


def test_a_model_gives_the_results_of_single_solves():
    model = vr.RollingModel(paper.ball(), angular_speed=0.5, mesh=MESH)
    cases = [
        {"load": 10.0},
        {"load": 200.0, "friction": 0.2},  # a wider window
        {"load": 50.0, "compliance": enums.Compliance.RADIAL, "patch_load": enums.PatchLoad.SPHERICAL},
        {"load": 50.0, "friction": 0.5, "drive": vr.Drive(torque=0.0)},
    ]
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda case: model.solve(**case), cases * 2))
    for case, result in zip(cases * 2, together, strict=True):
        alone = vr.solve(paper.ball(), angular_speed=0.5, mesh=MESH, **case)
        assert result.resisting_torque == pytest.approx(alone.resisting_torque, rel=1e-12)
        assert result.bulk_power == pytest.approx(alone.bulk_power, rel=1e-12)
    twin = pickle.loads(pickle.dumps(model))
    assert repr(twin) == repr(model)
    assert twin.solve(load=10.0).scalars() == together[0].scalars()
    with pytest.raises(TypeError, match=r"mesh must be a viscoroll\.Mesh"):
        vr.RollingModel(paper.ball(), angular_speed=0.5, mesh=None)


def test_eight_threads_give_the_serial_result(result, two_layer_ball):
    def torque(ball):
        return vr.solve(ball, load=100.0, angular_speed=2.5, mesh=MESH).resisting_torque

    expected = [result.resisting_torque, torque(two_layer_ball)] * 8
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(torque, [result.body, two_layer_ball] * 8)) == expected


def test_threads_with_a_python_modulus(rubber):
    layer = vr.Layer(thickness=1e-3, shear_modulus=lambda w: rubber.complex_modulus(w), poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    def torque(_):
        return vr.solve(ball, load=100.0, angular_speed=2.5, mesh=MESH).resisting_torque

    with ThreadPoolExecutor(4) as pool:
        assert len(set(pool.map(torque, range(12)))) == 1


def test_solve_releases_the_gil():
    mesh = vr.Mesh(nodes_per_revolution=6000)
    worker = threading.Thread(
        target=lambda: vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=mesh, threads=1)
    )
    worker.start()
    steps = 0
    while worker.is_alive():
        time.sleep(0.001)
        steps += 1
    assert steps > 50


def test_progress_is_reported():
    seen = []
    mesh = vr.Mesh(nodes_per_revolution=6000)  # some tenths of a second for each stage
    vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=mesh, progress=lambda *report: seen.append(report))
    assert {"summing orders", "solving the contact equations"} <= {stage for stage, _ in seen}
    assert all(0.0 <= fraction <= 1.0 for _, fraction in seen)


def test_an_exception_in_progress_ends_the_solve():
    def fails(stage, fraction):
        raise ZeroDivisionError(stage)

    with pytest.raises(ZeroDivisionError):
        vr.solve(
            paper.ball(),
            load=100.0,
            angular_speed=2.5,
            mesh=vr.Mesh(nodes_per_revolution=6000),
            progress=fails,
        )


def test_waiting_for_another_threads_tables_can_be_stopped(two_layer_ball):
    """One thread makes the tables of a shared model; the others report that they wait, and can be interrupted."""
    model = vr.RollingModel(two_layer_ball, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=500, max_order=6000))
    summing, waiting = threading.Event(), threading.Event()

    def first(stage, _fraction):
        if stage.startswith("summing"):
            summing.set()
            waiting.wait(timeout=20.0)

    def second(stage, _fraction):
        if stage.startswith("waiting"):
            waiting.set()
            raise KeyboardInterrupt

    worker = threading.Thread(target=lambda: model.solve(load=50.0, progress=first))
    worker.start()
    assert summing.wait(timeout=20.0)
    with pytest.raises(KeyboardInterrupt):
        model.solve(load=50.0, progress=second)
    worker.join()
    assert waiting.is_set()


SOLVE = "vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution={}, max_order={}){})"
ROLL = (
    "vr.roll(vr.CoatedSphere(core_radius=21e-3), on=vr.CoatedPlane(layers=paper.ball().layers), time=[0.0, 1e3],"
    " distance=[0.0, 100.0], load=100.0, mesh=vr.Mesh(nodes_per_revolution=400))"
)
# Calls, and a time after which each is in the stage of its name [s].
LONG_CALLS = {
    "tables": (SOLVE.format(20000, 30000, ""), 2.0),
    "many orders per node": (SOLVE.format(64, 200000, ""), 0.5),
    "contact": (SOLVE.format(24000, 12000, ""), 3.0),
    "friction": (SOLVE.format(16000, None, ", friction=0.1"), 2.0),
    "a history": (ROLL, 2.0),
    "single orders": ("vr.modal.surface_compliance(paper.ball(), 2.5, np.arange(4000)[:, None], np.arange(4000))", 0.5),
}


@pytest.mark.parametrize(("call", "seconds"), LONG_CALLS.values(), ids=LONG_CALLS)
def test_ctrl_c_stops_long_work(call, seconds):
    program = f"""
import numpy as np, viscoroll as vr
from viscoroll import paper
print("started", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("stopped", flush=True)
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "started\n"
        time.sleep(seconds)
        assert process.poll() is None, "the solve is too short for this test"
        process.send_signal(signal.SIGINT)
        # Stopping takes at most 0.3 s; the bound only keeps a failure from hanging, since no test depends on timing.
        try:
            output, _ = process.communicate(timeout=20)
        finally:
            process.kill()
        assert output == "stopped\n"
