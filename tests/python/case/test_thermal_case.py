"""Case files with a table [thermal], and the results of the command line."""

from __future__ import annotations

import json

import pytest
import viscoroll as vr
from viscoroll import cli, enums
from viscoroll.case import example_text, load_case

COARSE = example_text().replace("accuracy = 0.01", "nodes_per_revolution = 200")
THERMAL = """
[thermal]
convection = 10.0
ambient = 293.15
conductivity = 0.2
"""
SHIFT = 'shift = { type = "arrhenius", activation_energy = 60e3, reference_temperature = 293.15 }\nlimit = 313.15\n'


def run(*arguments):
    cli.app([str(argument) for argument in arguments], standalone_mode=False)


@pytest.fixture
def case(tmp_path):
    def write(text):
        path = tmp_path / "case.toml"
        path.write_text(text)
        return path

    return write


def test_the_commented_table_is_valid(case):
    head, table = example_text().split("# [thermal]\n")
    lines = ["[thermal]", *(line.removeprefix("# ") for line in table.splitlines())]
    lines.remove(next(line for line in lines if "williams" in line))  # one of two shift laws
    thermal = load_case(case(head + "\n".join(lines))).thermal
    assert thermal.conductivity == 0.2
    assert thermal.core is enums.Core.INSULATED
    assert isinstance(thermal.shift, vr.materials.Arrhenius)
    assert load_case(case(example_text())).thermal is None


@pytest.mark.parametrize(
    ("table", "message"),
    [
        (THERMAL + 'core = "steel"', "thermal.core must be one of insulated, isothermal, got 'steel'"),
        (THERMAL + "shift = 3", "thermal.shift must be a valid dictionary"),
        (THERMAL + 'shift = { type = "eyring" }', "thermal.shift.type must be one of williams_landel_ferry, arrhenius"),
        (
            THERMAL + 'shift = { type = "arrhenius" }',
            "thermal.shift.activation_energy must be given for the type arrhenius",
        ),
        ("[thermal]\nambient = 300.0", "thermal.convection must be given"),
    ],
)
def test_messages_name_the_mistake(case, table, message):
    with pytest.raises(ValueError, match=message):
        load_case(case(COARSE + table))


def test_solve_reports_temperatures_and_draws_the_section(case, capsys, tmp_path):
    picture = tmp_path / "section.png"
    run("solve", case(COARSE + THERMAL), "--json", "--section", picture)
    (found,) = json.loads(capsys.readouterr().out)["thermal"]
    # Fine meshes give 1.90 K; the mesh here is π/100.
    assert found["maximum"] == pytest.approx(1.90, rel=0.1)
    assert found["heat_to_surroundings"] == pytest.approx(found["heat"], rel=1e-9)
    assert picture.stat().st_size > 10000


def test_solve_finds_steady_states(case, capsys):
    run("solve", case(COARSE + THERMAL + SHIFT))
    out = capsys.readouterr().out
    assert "mean temperature of the layers" in out
    assert "stable" in out
