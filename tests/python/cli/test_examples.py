"""Example files of all kinds: complete, valid and solvable; and tables that a command does not use."""

from __future__ import annotations

import re
import tomllib

import jsonschema
import pytest
from shared_cases import command
from viscoroll.case.examples import EXAMPLES, generated_example
from viscoroll.case.schema import json_schema

COARSE = ("--set", "numerics.accuracy=0.3")
SCHEMA = json_schema()


@pytest.fixture
def file(tmp_path):
    def write(text):
        path = tmp_path / "case.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_are_valid(file, name):
    printed = command("example", f"--{name}").stdout
    assert printed == generated_example(name)
    assert max(map(len, printed.splitlines())) <= 120
    jsonschema.Draft202012Validator(SCHEMA).validate(tomllib.loads(printed))
    assert command("check", file(printed)).returncode == 0


@pytest.mark.parametrize(
    "name", [*sorted(EXAMPLES.keys() - {"thermal"}), pytest.param("thermal", marks=pytest.mark.slow)]
)
def test_examples_are_solved_without_warnings(file, name):
    done = command("solve", file(generated_example(name)), *COARSE)
    assert (done.returncode, done.stderr) == (0, "")
    assert "resisting torque" in done.stdout


@pytest.mark.parametrize("options", [(), ("--sweep",), ("--design",), ("--motion",)])
def test_other_examples_are_valid(file, options):
    done = command("check", file(command("example", *options).stdout))
    assert done.returncode == 0, done.stderr


def test_the_thermal_example_has_every_key_of_its_table():
    text = generated_example("thermal")
    table = text[text.index("[thermal]") :]
    keys = set(re.findall(r"^(?:# )?(\w+) = ", table, re.MULTILINE)) | set(
        re.findall(r"^\[thermal\.(\w+)\]", table, re.MULTILINE)
    )
    assert keys >= SCHEMA["$defs"]["Thermal"]["properties"].keys()


def test_comments_are_those_of_the_schema():
    text = generated_example("wheel")
    assert "# Width of the tread from face to face [m], > 0, at most 1000 times the outer\n" in text
    assert '# compliance = "radial" ' in text  # the default
    assert re.search(r'^type = "prony" +# elastic, prony, standard_linear_solid,', text, re.MULTILINE)


def test_examples_are_given_alone():
    done = command("example", "--wheel", "--sweep")
    assert done.returncode == 2
    assert "must be given alone, got --sweep and --wheel" in done.stderr


def test_an_axis_without_effect_is_rejected(file):
    text = generated_example("wheel") + '[axle]\nmass = 1.0\n[sweep]\n"axle.mass" = [1.0, 2.0]\n'
    done = command("sweep", file(text))
    assert done.returncode == 2
    assert 'sweep."axle.mass" must change the case: `viscoroll sweep` does not use this key' in done.stderr


def test_commands_name_the_tables_that_they_do_not_use(file, tmp_path):
    text = generated_example("thermal").replace("accuracy = 0.05", "accuracy = 0.3")
    done = command("compare", file(text), "--points", "2", cwd=tmp_path)
    assert "skipped in case.toml: [thermal] is for `viscoroll solve`" in done.stderr
    path = file(generated_example("rollers") + '[sweep]\n"rolling.load" = ["5 N/mm", "6 N/mm"]\n')
    assert "skipped in case.toml: [sweep] is for `viscoroll sweep`" in command("solve", path, *COARSE).stderr
