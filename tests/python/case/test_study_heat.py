"""Studies of files with a table [thermal]: temperatures and tractions at bonds of each point."""

from __future__ import annotations

import pytest
from viscoroll.case import load_case
from viscoroll.case.solved import solve_case
from viscoroll.case.study import load_study
from viscoroll.studies.study import run_plan

FILE = """
[ball]
core_radius = 20e-3
[[ball.layers]]
thickness = 2e-3
poisson_ratio = 0.5
[ball.layers.shear_modulus]
type = "standard_linear_solid"
instantaneous_modulus = 6e6
relaxed_modulus = 3e6
relaxation_time = 1e-3
[rolling]
load = 50.0
angular_speed = 100.0
[numerics]
nodes_per_revolution = 100
[thermal]
conductivity = 0.2
convection = 10.0
ambient = 296.15
core = "insulated"
"""

SHIFT = """
shift = { type = "williams_landel_ferry", c1 = 8.86, c2 = 101.6, reference_temperature = 296.15 }
"""


@pytest.fixture
def file(tmp_path):
    def write(text):
        path = tmp_path / "study.toml"
        path.write_text(text)
        return path

    return write


def test_columns_equal_those_of_single_cases(file):
    study = run_plan(
        load_study(file(FILE + '[sweep]\n"thermal.convection" = [5.0, 10.0]\n"rolling.load" = [30.0, 50.0]\n')),
        progress=False,
    )
    assert study.temperature_rise.dims == ("convection", "load")
    case = solve_case(load_case(file(FILE)))
    (heated,) = case.temperatures
    point = study.sel(convection=10.0, load=50.0)
    assert float(point.temperature_rise) == pytest.approx(heated.maximum, rel=1e-9)
    assert float(point.heat_to_surroundings) == pytest.approx(heated.heat_to_surroundings, rel=1e-9)
    assert float(point.bond_shear) == pytest.approx(case.bonds["bond_shear"], rel=1e-9)
    assert study.bond_shear.attrs["units"] == "Pa"
    # Without a shift, the rise is proportional to 1/h where the core takes no heat, up to the resistance of the layer.
    assert float(study.temperature_rise.sel(convection=5.0, load=50.0)) > 1.5 * heated.maximum
    assert "temperature_rise" not in run_plan(
        load_study(file(FILE[: FILE.index("[thermal]")] + '[sweep]\n"rolling.load" = [30.0]\n')), progress=False
    )


@pytest.mark.slow
def test_a_shift_gives_the_steady_state_of_each_point(file):
    study = run_plan(load_study(file(FILE + SHIFT + '[sweep]\n"rolling.load" = [30.0, 50.0]\n')), progress=False)
    case = solve_case(load_case(file(FILE + SHIFT)))
    point = study.sel(load=50.0)
    assert case.heated is not None
    assert float(point.steady_states) == len(case.heated.states)
    assert float(point.resisting_torque) == pytest.approx(case.result.resisting_torque, rel=1e-6)
    assert float(point.mean_temperature_rise) == pytest.approx(case.temperatures[0].mean, rel=1e-6)


def test_cached_points_depend_on_the_cooling(file, tmp_path):
    pytest.importorskip("netCDF4")
    cache = tmp_path / "study.nc"
    rises = []
    for convection in ("10.0", "20.0", "10.0"):
        text = FILE.replace("convection = 10.0", f"convection = {convection}") + '[sweep]\n"rolling.load" = [30.0]\n'
        rises.append(float(run_plan(load_study(file(text)), cache=cache, progress=False).temperature_rise[0]))
    assert rises[0] == rises[2] > 1.3 * rises[1]
