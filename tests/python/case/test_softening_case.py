"""Case files with filled rubber give the same results in Python, on the command line and in a study."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll.case import load_case
from viscoroll.studies.identity import PointKeys

CASE = """
[cylinder]
core_radius = 50e-3
[[cylinder.layers]]
thickness = 10e-3
poisson_ratio = 0.5
[cylinder.layers.shear_modulus]
type = "softening"
matrix = { type = "standard_linear_solid", instantaneous_modulus = 3e6, relaxed_modulus = 2.5e6, relaxation_time = 0.1 }
network = NETWORK
[rolling]
load = 2e3
angular_speed = 2.5
[numerics]
nodes_per_revolution = 800
"""
SWEEP = '{ type = "strain_sweep", file = "sweep.csv", kind = "double_shear", frequency = 60.0 }'
TABLE = {"strain": [0.001, 0.01, 0.1, 0.5], "storage": [9.5e6, 7e6, 4.2e6, 3.5e6], "loss": [6e5, 12e5, 9e5, 7e5]}
MATRIX = vr.StandardLinearSolid(instantaneous_modulus=3e6, relaxed_modulus=2.5e6, relaxation_time=0.1)


@pytest.fixture
def write(tmp_path):
    rows = [",".join(TABLE), *(",".join(map(str, row)) for row in zip(*TABLE.values(), strict=True))]
    (tmp_path / "sweep.csv").write_text("\n".join(rows), encoding="utf-8")

    def write_case(network, extra=""):
        path = tmp_path / "case.toml"
        path.write_text(CASE.replace("NETWORK", network) + extra, encoding="utf-8")
        return path

    return write_case


def test_networks_of_a_case_file(write):
    sweep = vr.materials.StrainSweep(**TABLE, kind="double_shear", matrix=MATRIX, frequency=60.0)
    kraus = '{ type = "kraus", storage = 8e6, loss = 8e5, critical_strain = 0.01 }'
    masing = '{ type = "masing", storage = 6e6, critical_strain = 0.01 }'
    for text, network in (
        (SWEEP, sweep),
        (kraus, vr.materials.KrausNetwork(storage=8e6, loss=8e5, critical_strain=0.01)),
        (
            masing,
            vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01),
        ),
    ):
        modulus = load_case(write(text)).body.layers[0].shear_modulus
        assert modulus == vr.materials.SofteningModulus(matrix=MATRIX, network=network)


def test_command_line_reports_both_torques(write):
    case = write(SWEEP)
    found = load_case(case).strain_softening()
    printed = json.loads(command("solve", case, "--json").stdout)
    assert printed["resisting_torque"] == found.torque_bounds[1]
    assert printed["softening"]["harmonic_torque"] == found.torque_bounds[0]
    assert f"{1e3 * found.torque_bounds[0]:.5g} (harmonic sum)" in command("solve", case).stdout


def test_study_of_filled_rubber(write):
    case = load_case(write(SWEEP))
    study = vr.sweep(**case.arguments() | {"load": [1e3, 2e3]})
    # A study solves each point on one thread. The number of threads does not affect the result.
    assert study.resisting_torque[1].item() == case.strain_softening().result.resisting_torque


def test_studies_distinguish_networks(write):
    """Cache keys depend on the network and the matrix; for a matrix that is a function, on its values."""
    case = load_case(write(SWEEP))
    arguments = {"load": 1e3, "angular_speed": 2.5}

    def key(matrix, **changed):
        network = vr.materials.KrausNetwork(**{"storage": 8e6, "loss": 8e5, "critical_strain": 0.01} | changed)
        layer = replace(
            case.body.layers[0], shear_modulus=vr.materials.SofteningModulus(matrix=matrix, network=network)
        )
        return PointKeys().key(replace(case.body, layers=[layer]), arguments, ())

    assert key(lambda _: 1e6) == key(lambda _: 1e6)
    assert len({key(lambda _: 1e6), key(lambda _: 2e6), key(MATRIX), key(MATRIX, loss=7e5)}) == 4


@pytest.mark.parametrize(
    ("network", "message"),
    [
        ('{ type = "kraus", storage = 8e6, loss = 8e5 }', "network.critical_strain must be given for the type kraus"),
        ('{ type = "payne" }', "network.type must be one of kraus, masing, strain_sweep, got 'payne'"),
        ('{ type = "strain_sweep", file = "no.csv" }', "strain sweep .*no.csv: No such file"),
    ],
)
def test_rejected_networks(write, network, message):
    with pytest.raises(ValueError, match=message):
        load_case(write(network))


def test_self_heating_of_filled_rubber(write):
    """The command line reports the coldest state of `self_heating`, with its temperature and both torques."""
    thermal = """
[thermal]
convection = 10.0
ambient = 293.15
conductivity = 0.2
softening = "harmonic"
limit = 313.15
shift = { type = "arrhenius", activation_energy = 60e3, reference_temperature = 293.15 }
"""
    masing = '{ type = "masing", storage = 6e6, critical_strain = 0.01 }'
    path = write(masing, thermal)
    path.write_text(path.read_text(encoding="utf-8").replace("= 800", "= 200"), encoding="utf-8")
    printed = json.loads(command("solve", path, "--json").stdout)
    state = load_case(path).self_heating().states[0]
    assert state.softening.loss == "harmonic"
    assert printed["resisting_torque"] == state.softening.torque_bounds[0] == printed["softening"]["harmonic_torque"]
    assert printed["softening"]["network_torque"] == state.softening.torque_bounds[1]
    assert printed["thermal"][0]["mean_temperature"] == pytest.approx(state.mean_temperature)
