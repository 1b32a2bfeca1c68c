"""Parameter studies: contents of the dataset, grouping of points, executors, progress and input checks."""

from __future__ import annotations

import multiprocessing
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll import _core, enums, paper
from viscoroll.studies.plan import plan_sweep

MESH = vr.Mesh(nodes_per_revolution=100, max_order=50)
SPEED = {"angular_speed": 2.5, "mesh": MESH}
LOADS = [20.0, 50.0, 100.0]


def sweep(*arguments, **parameters):
    return vr.sweep(*arguments, **{"progress": False} | SPEED | parameters)


def assert_equal_up_to_round_off(one, other):
    """Assert equality except for round-off, which depends on the loads that a model has already solved."""
    xarray.testing.assert_identical(*(xarray.Dataset(coords=study.coords) for study in (one, other)))
    assert {**one.attrs, "created": ""} == {**other.attrs, "created": ""}
    assert set(one.data_vars) == set(other.data_vars)
    for name in set(one.data_vars) - {"residual"}:
        if one[name].dtype.kind != "f":
            xarray.testing.assert_identical(one[name], other[name])
        else:
            size = np.nanmax(np.abs(one[name].values), initial=0.0)
            np.testing.assert_allclose(one[name], other[name], rtol=1e-8, atol=1e-9 * size)


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
                        # The largest load of a model determines the size of its tables, which changes round-off.
                        value = np.nan if value is None else value
                        # Values that are zero in exact arithmetic, such as frictionless forces and the residual,
                        # contain round-off of numbers near 1 and 100.
                        np.testing.assert_allclose(point[name].item(), value, rtol=1e-8, atol=1e-13, err_msg=name)
    assert set(expected) - set(study.variables) == {"compliance", "curvature", "patch_load"}


def test_units_and_provenance(tmp_path):
    study = sweep(paper.ball, thickness=np.array([1e-3, 2e-3]), load=range(20, 60, 20), patch_load=enums.PatchLoad.FLAT)
    units = {name: study[name].attrs.get("units") for name in ("thickness", "load", "angular_speed", "max_pressure")}
    assert units == {"thickness": "m", "load": "N", "angular_speed": "rad/s", "max_pressure": "Pa"}
    assert study.angular_speed == 2.5
    assert study.attrs["version"] == vr.__version__
    assert study.attrs["commit"] == _core.__commit__
    assert study.attrs["mesh"] == "100 nodes per revolution, orders to 50"
    assert study.attrs["patch_load"] == "FLAT"
    assert study.attrs["material"] == repr(paper.ball().layers[0].shear_modulus)
    assert "thickness=0.002" in study.attrs["body"]
    study.to_netcdf(tmp_path / "study.nc")
    xarray.testing.assert_identical(xarray.load_dataset(tmp_path / "study.nc"), study)


def test_objects_can_be_dimensions(rubber):
    def coated(arbitrary_name, shear_moduli):
        layers = [vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.5) for modulus in shear_moduli]
        return vr.CoatedSphere(core_radius=arbitrary_name, layers=layers)

    study = sweep(
        coated,
        arbitrary_name=[0.02],
        shear_moduli=[(rubber,), (rubber, lambda w: rubber.complex_modulus(w))],
        mesh=[MESH, vr.Mesh(nodes_per_revolution=120, max_order=60)],
        compliance=list(enums.Compliance),
        drive=[vr.Drive(force=0.0), vr.Drive(torque=0.0)],
        friction=0.2,
        load=50.0,
    )
    assert dict(study.sizes) == {"arbitrary_name": 1, "shear_moduli": 2, "mesh": 2, "compliance": 2, "drive": 2}
    assert study.mesh.values.tolist() == ["100 x 50", "120 x 60"]
    assert study.compliance.values.tolist() == ["RADIAL", "VERTICAL"]
    assert study.drive.values.tolist() == ["force=0", "torque=0"]
    assert study.shear_moduli.values.tolist() == ["shear_moduli[0]", "shear_moduli[1]"]
    assert "units" not in study.arbitrary_name.attrs
    assert study.nodes_per_revolution.sel(mesh="120 x 60").values.ravel().tolist() == [120.0] * 8
    assert (study.driving_torque.sel(drive="torque=0") == pytest.approx(0.0, abs=1e-9)).all()
    assert not study.resisting_torque.isnull().any()


def test_points_are_grouped_by_influence_table(paper_ball):
    parameters = {"load": LOADS, "friction": [0.0, 0.1], "angular_speed": [1.0, 2.5], "mesh": MESH}
    plan = plan_sweep(paper_ball, parameters, fields=())
    tasks = plan.tasks(range(12), largest=100)
    assert [(task.shared["angular_speed"], len(task.cases)) for task in tasks] == [(1.0, 6), (2.5, 6)]
    assert sorted(i for task in tasks for i in task.indices) == list(range(12))
    # Groups are split if there would be fewer tasks than workers.
    assert [len(task.cases) for task in plan.tasks(range(12), largest=4)] == [3, 3, 3, 3]


def test_each_body_is_created_once():
    thicknesses = []

    def coated(thickness):
        thicknesses.append(thickness)
        return paper.ball(thickness=thickness)

    sweep(coated, load=LOADS, thickness=[1e-3, 2e-3])
    assert thicknesses == [1e-3, 2e-3]


def test_fields_are_centered_in_the_largest_window(paper_ball):
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
    assert_equal_up_to_round_off(study, sweep(paper.ball, **parameters))


def test_dask_cluster():
    from distributed import Client, LocalCluster

    parameters = {"load": LOADS, "thickness": [1e-3, 2e-3]}
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        study = sweep(paper.ball, **parameters, executor=client.get_executor())
    assert_equal_up_to_round_off(study, sweep(paper.ball, **parameters))


def test_progress_shows_the_remaining_time(capsys, paper_ball):
    sweep(paper_ball, load=LOADS, progress=True)
    shown = capsys.readouterr().err
    assert "3/3" in shown
    assert "point" in shown
    assert "<" in shown  # separates the elapsed from the remaining time


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
        ({"accuracy": 0.1}, ValueError, "accuracy must be left out if a mesh is given"),
        ({"thicknes": 1e-3}, TypeError, "body, called with thicknes: got an unexpected keyword argument"),
        ({"strain": 1e-3}, ValueError, "must not have names of results, got strain"),
        (
            {"thickness": [-1.0, -2.0]},
            ValueError,
            "every point fails, the first with InvalidInput: thickness must be > 0",
        ),
        ({"fields": ["heat"]}, ValueError, "fields must be names from x, z, pressure, .*, got 'heat'"),
        ({"executor": 4}, TypeError, "executor must be a concurrent.futures.Executor or None, got 4"),
        ({"cache": "study.json"}, ValueError, "cache must end in .nc, got 'study.json'"),
    ],
)
def test_invalid_arguments(changes, error, message):
    with pytest.raises(error, match=message):
        sweep(paper.ball, **{"load": LOADS} | changes)


def test_invalid_bodies(paper_ball):
    with pytest.raises(TypeError, match="a rolling body has no parameter thickness; pass a function of thickness"):
        sweep(paper_ball, load=LOADS, thickness=[1e-3])
    with pytest.raises(TypeError, match=r"body must be a viscoroll.CoatedSphere or .* returns one, got 3"):
        sweep(3, load=LOADS)
    with pytest.raises(TypeError, match=r"body must return a viscoroll.CoatedSphere or .*, got 1.0"):
        sweep(lambda thickness: 1.0, load=LOADS, thickness=[1.0])
    with pytest.raises(TypeError, match="sweep requires angular_speed and load"):
        vr.sweep(paper_ball)
