"""Studies of rough surfaces: dimensions, caches, executors, temperatures and case files."""

from __future__ import annotations

import csv
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll.case import example_text
from viscoroll.studies import run as running
from viscoroll.studies.picture import plot_study

from tests.shared_cases import command

SIDE = 1e-3
LAW = vr.materials.WilliamsLandelFerry(c1=8.86, c2=101.6, reference_temperature=293.15)


def rough(cutoff=SIDE / 8):
    return vr.RoughSurface.self_affine(64, SIDE, hurst=0.8, rolloff=SIDE / 4, cutoff=cutoff, rms_slope=0.1, seed=1)


def block(temperature=293.15):
    time = 0.01 * LAW(temperature)
    rubber = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=time)
    return vr.HalfSpace(shear_modulus=rubber, poisson_ratio=0.5)


@pytest.fixture
def solves(monkeypatch):
    """List of the points that were solved."""
    solved, before = [], running.solve_point

    def counting(solver, **case):
        solved.append(case)
        return before(solver, **case)

    monkeypatch.setattr(running, "solve_point", counting)
    return solved


def test_points_are_those_of_slide():
    study = vr.sweep(rough(), on=block(), pressure=[1e4, 2e4], speed=[1e-4, 1e-3], progress=False)
    r = vr.slide(rough(), on=block(), pressure=2e4, speed=1e-4)
    point = study.sel(pressure=2e4, speed=1e-4)
    assert study.friction_coefficient.dims == ("pressure", "speed")
    assert study.friction_coefficient.attrs["long_name"] == "friction coefficient due to losses in the layers"
    assert study.max_pressure.attrs["units"] == "Pa"
    assert study.speed.attrs["units"] == "m/s"
    numbers = {name: value for name, value in r.scalars().items() if isinstance(value, float) and name in study}
    assert {name: point[name].item() for name in numbers} == pytest.approx(numbers, rel=1e-12)
    assert (study.status == "CONVERGED").all()
    assert study.attrs["mesh"] == "64 x 64"
    assert study.attrs["surface"] == repr(rough())


def test_temperature_shifts_the_speed():
    # Without inertia, friction depends on the product of speed and shift factor only.
    temperatures = [283.15, 293.15, 303.15]
    study = vr.sweep(rough(), on=block, temperature=temperatures, pressure=2e4, speed=1e-3, progress=False)
    for temperature in temperatures:
        r = vr.slide(rough(), on=block(), pressure=2e4, speed=1e-3 * LAW(temperature))
        found = study.sel(temperature=temperature)
        assert found.friction_coefficient.item() == pytest.approx(r.friction_coefficient, rel=1e-9)
    assert np.ptp(study.friction_coefficient.values) > 0.01


def test_a_function_makes_the_surfaces():
    study = vr.sweep(rough, cutoff=[SIDE / 4, SIDE / 8], on=block(), pressure=2e4, speed=1e-3, progress=False)
    r = vr.slide(rough(SIDE / 4), on=block(), pressure=2e4, speed=1e-3)
    assert study.friction_coefficient.sel(cutoff=SIDE / 4).item() == pytest.approx(r.friction_coefficient, rel=1e-12)


def test_the_cache_holds_points(tmp_path, solves):
    path, calls = tmp_path / "study.nc", []

    def study(speeds, **options):
        given = {"on": block(), "pressure": 2e4, "speed": speeds, "progress": False}
        return vr.sweep(rough(), **given | options, cache=path)

    first = study([1e-4, 1e-3], progress=lambda _, fraction: calls.append(fraction))
    assert calls[-1] == 1.0
    assert len(solves) == 2
    assert study([1e-4, 1e-3]).equals(first)
    study([1e-4, 1e-3, 1e-2])
    assert len(solves) == 3
    # Another surface, tolerance or material is another point.
    for options in ({"tolerance": 1e-8}, {"on": block(303.15)}):
        study([1e-4], **options)
    vr.sweep(rough(SIDE / 4), on=block(), pressure=2e4, speed=[1e-4], progress=False, cache=path)
    assert len(solves) == 6


def test_an_executor_gives_the_same_results():
    given = {"on": block(), "pressure": [1e4, 2e4], "speed": [1e-4, 1e-3], "progress": False}
    with ProcessPoolExecutor(2) as pool:
        found = vr.sweep(rough(), **given, executor=pool)
    assert found.friction_coefficient.equals(vr.sweep(rough(), **given).friction_coefficient)


def test_pictures_and_tables():
    study = vr.sweep(rough(), on=block(), pressure=2e4, speed=np.geomspace(1e-5, 1e-1, 3), progress=False)
    (axes,) = plot_study(study).axes
    assert axes.get_xscale() == "log"
    assert axes.get_ylabel() == "friction coefficient due to losses in the layers"


def test_friction_at_the_interface_is_a_parameter():
    study = vr.sweep(rough(), on=block(), pressure=2e4, speed=1e-3, friction=[0.0, 0.5], progress=False)
    assert study.total_friction_coefficient.values == pytest.approx(
        [study.friction_coefficient.values[0], 0.5 + study.friction_coefficient.values[0]], rel=1e-6
    )


def test_a_failed_point_has_its_message():
    study = vr.sweep(rough(), on=block(), pressure=[-1.0, 2e4], speed=1e-3, progress=False)
    assert study.error.values[0] == "InvalidInput: pressure must be > 0 Pa, got -1"
    assert study.status.values.tolist() == ["FAILED", "CONVERGED"]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"speed": 1e-3}, "requires exactly one of pressure and load"),
        ({"pressure": 1e4, "load": 1.0, "speed": 1e-3}, "requires exactly one of pressure and load"),
        ({"pressure": 1e4}, "sweep of a rough surface requires speed"),
        ({"pressure": 1e4, "speed": 1.0, "fields": "pressure"}, "fields must be left out for a rough surface"),
        (
            {"pressure": 1e4, "speed": 1.0, "accuracy": 0.1},
            "a rough surface has no parameter accuracy; pass a function",
        ),
        ({"pressure": 1e4, "speed": 1.0, "on": vr.CoatedSphere(core_radius=1.0)}, "on must be a viscoroll.CoatedPlane"),
    ],
)
def test_messages(given, message):
    with pytest.raises((TypeError, ValueError), match=message):
        vr.sweep(rough(), **{"on": block(), "progress": False} | given)


def test_profiles_and_maps_are_not_mixed():
    profile = vr.RoughSurface.of(lambda x, z: 1e-6 * np.cos(2e3 * np.pi * x), nodes=(64, 1), side=SIDE)
    with pytest.raises(vr.InvalidInput, match="surface must be a profile at all points or at none"):
        vr.sweep(lambda wavy: profile if wavy else rough(), wavy=[0, 1], on=block(), pressure=1e4, speed=1e-3)


FILE = example_text("sliding").replace("nodes = 256", "nodes = 64").replace("0.03125e-3", "0.125e-3")
SHIFT = '{ type = "williams_landel_ferry", c1 = 8.86, c2 = 101.6, reference_temperature = 293.15 }'
STUDY = f"""{FILE.replace("speed = [1e-4, 1e-3, 1e-2]", "speed = 1e-3")}
temperature = "20 °C"
shift = {SHIFT}

[sweep]
"sliding.temperature" = ["10 °C", "20 °C"]
"sliding.speed" = [1e-4, 1e-3]
"surface.cutoff" = ["125 µm", "250 µm"]
"""


def test_the_shell_solves_and_draws_a_study(tmp_path):
    path = tmp_path / "road.toml"
    path.write_text(STUDY, encoding="utf-8")
    assert "valid for `viscoroll slide`, `viscoroll sweep`" in command("check", path).stdout
    done = command("sweep", path, "--table", tmp_path / "road.csv")
    assert "8 points (2 temperature x 2 speed x 2 cutoff), 0 failed" in done.stdout
    study = xarray.load_dataset(tmp_path / "road.nc")
    on = block(283.15)
    r = vr.slide(rough(), on=on, pressure=20e3, speed=1e-3)
    found = study.sel(temperature=283.15, speed=1e-3, cutoff=125e-6, method="nearest")
    assert found.friction_coefficient.item() == pytest.approx(r.friction_coefficient, rel=1e-9)
    rows = list(csv.DictReader((tmp_path / "road.csv").read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 8
    assert list(rows[0])[:3] == ["temperature [K]", "speed [m/s]", "cutoff [m]"]
    assert "friction_coefficient drawn to" in command("plot", tmp_path / "road.nc").stdout
    # `viscoroll slide` solves the file itself at its temperature.
    assert "Sliding at 0.001 m/s" in command("slide", path).stdout


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        ('temperature = "20 °C"', "", "sliding must have both temperature and shift, or neither"),
        ("speed = 1e-3", "speed = [1e-3, 1e-2]", "sliding.speed must be one number; several speeds belong to"),
        ('"sliding.speed" = [1e-4, 1e-3]', '"thermal.ambient" = [1.0, 2.0]', 'sweep."thermal.ambient" must change'),
        (
            "\n[sweep]\n",
            '\n[draws]\nof = ["plane.base.shear_modulus"]\n[sweep]\n',
            "draws must be left out with a table surface",
        ),
    ],
)
def test_messages_about_files(tmp_path, before, after, message):
    path = tmp_path / "road.toml"
    text = STUDY.replace(before, after)
    if "speed = [1e-3, 1e-2]" in text:
        text = text.replace('"sliding.speed" = [1e-4, 1e-3]\n', "")
    if "\ntemperature" not in text:
        text = text.replace('"sliding.temperature" = ["10 °C", "20 °C"]\n', "")
    path.write_text(text, encoding="utf-8")
    done = command("sweep", path)
    assert done.returncode == 2
    assert message in done.stderr
