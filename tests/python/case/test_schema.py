"""The JSON Schema of case files accepts the files of the documentation, and rejects wrong ones at the same place."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import jsonschema
import pytest
import viscoroll as vr
from shared_cases import command
from viscoroll._support.units import UNITS
from viscoroll.case import build_case, example_text, motion
from viscoroll.case.descriptions import parameter_schemas
from viscoroll.case.schema import json_schema
from viscoroll.materials.moduli import MODULI

ROOT = Path(__file__).parents[3]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
BODIES = {"ball", "cylinder", "wheel", "surface"}
SCHEMA = json_schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def documented() -> Iterator[tuple[str, str]]:
    for page in PAGES:
        blocks = re.findall(r"^```toml\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
        for number, block in enumerate(blocks):
            whole = BODIES & tomllib.loads(block).keys()
            yield f"{page.stem} {number}", block if whole else f"{example_text()}\n{block}"


EXAMPLES = dict(documented()) | {
    "case": example_text(),
    "study": example_text() + example_text("sweep"),
    "design": example_text() + example_text("design"),
    "motion": example_text("motion"),
    "sliding": example_text("sliding"),
}


def test_the_schema_is_valid():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


def test_the_command_prints_the_schema():
    assert json.loads(command("schema").stdout) == json.loads(json.dumps(SCHEMA))


def test_types_of_the_npm_package_and_lists_of_the_page_follow_from_the_schema():
    script = ROOT / "wasm" / "make_types.py"
    subprocess.run([sys.executable, script, "--check"], check=True)


def test_units_of_parameters_are_those_of_their_descriptions():
    spelled = {"kg/m³": "kg/m^3", "-": "1"}
    for kind in (*MODULI.values(), vr.CoatedSphere, vr.CoatedWheel, vr.Groove, vr.Layer, vr.Drive):
        for name, found in parameter_schemas(kind).items():
            unit = re.search(r"\[(.*?)\]", found["description"])
            if name in UNITS and unit and "[" in found["description"].split(",")[0]:
                assert spelled.get(unit[1], unit[1]) == UNITS[name], (kind, name)


@pytest.mark.parametrize("name", EXAMPLES)
def test_documented_files_are_valid(name):
    VALIDATOR.validate(tomllib.loads(EXAMPLES[name]))


def test_every_key_has_a_description():
    missing = [
        f"{table}.{key}"
        for table, schema in SCHEMA["$defs"].items()
        for key, found in schema.get("properties", {}).items()
        if "description" not in found and key != "type"
    ]
    assert missing == []


def test_ranges_and_units_are_those_of_the_docstrings():
    layer = SCHEMA["$defs"]["Layer"]["properties"]
    assert (layer["thickness"]["exclusiveMinimum"], layer["density"]["minimum"]) == (0, 0)
    assert "[m]" in layer["thickness"]["description"]
    assert SCHEMA["$defs"]["Rolling"]["properties"]["load"]["exclusiveMinimum"] == 0


def places(error: jsonschema.ValidationError) -> Iterator[str]:
    """Yield the paths that an error and its alternatives name."""
    path = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in error.absolute_path).lstrip(".")
    within = path and f"{path}."
    yield path
    if error.validator == "required":
        yield from (within + name for name in error.validator_value if name not in error.instance)
    if error.validator == "additionalProperties":
        yield from (within + name for name in error.instance if name not in error.schema["properties"])
    for cause in error.context or []:
        yield from places(cause)


def changed(path: str, value: object) -> dict:
    """Return the example case with `value` at `path`; None deletes the key."""
    case = tomllib.loads(example_text("motion" if path.startswith("motion") else "case"))
    *above, last = [int(part) if part.isdigit() else part for part in re.findall(r"\w+", path)]
    table = case
    for part in above:
        table = table.setdefault(part, {}) if isinstance(table, dict) else table[part]
    if value is None:
        del table[last]
    else:
        table[last] = value
    return case


LAYER = "ball.layers[0]"
MODULUS = f"{LAYER}.shear_modulus"
PRONY = {"type": "prony", "instantaneous_modulus": 1e6, "weights": [0.5], "relaxation_times": [1.0]}
WRONG = [
    ("ball.core_radius", -1.0),
    ("ball.core_radius", "large"),
    ("ball.colour", "red"),
    ("ball.inner_boundary", "loose"),
    ("ball.layers", 3),
    (f"{LAYER}.thickness", None),
    (f"{LAYER}.thickness", 0.0),
    (f"{LAYER}.thickness", "thin"),
    (f"{LAYER}.density", -1.0),
    (f"{LAYER}.density", [1.0]),
    (f"{LAYER}.thicknes", 1e-3),
    (f"{MODULUS}.type", "elastik"),
    (f"{MODULUS}.modulus", 1e6),
    (f"{MODULUS}.relaxation_time", None),
    (f"{MODULUS}.instantaneous_modulus", 0.0),
    (f"{MODULUS}.weights[0]", PRONY | {"weights": [-0.5]}),
    (f"{MODULUS}.relaxation_times[0]", PRONY | {"relaxation_times": [0.0]}),
    (f"{MODULUS}.relaxation_times", {name: value for name, value in PRONY.items() if name != "relaxation_times"}),
    ("rolling.load", None),
    ("rolling.load", "much"),
    ("rolling.velocity", 1.0),
    ("rolling.angular_speed", None),
    ("rolling.friction", "high"),
    ("rolling.drive.push", 1.0),
    ("rolling.drive.force", "strong"),
    ("numerics.compliance", "diagonal"),
    ("numerics.nodes_per_revolution", 250.5),
    ("numerics.acuracy", 1e-3),
    ("thermal.convection", None),
    ("thermal.core", "steel"),
    ("plane.layers", "soft"),
    ("plane.base.poisson_ratio", "half"),
    ("groove.radius", "wide"),
    ("motion.load", "heavy"),
    ("motion.speed", 1.0),
    ("motion.start", "cold"),
    ("balll", {}),
]


@pytest.mark.parametrize(("path", "value"), WRONG, ids=[f"{path} = {value}" for path, value in WRONG])
def test_wrong_files_are_rejected_at_the_same_place(path, value):
    place = path
    if isinstance(value, dict) and path.startswith(f"{MODULUS}."):
        place = MODULUS
    if path == "thermal.convection":
        case = changed("thermal", {"ambient": 300.0})
    elif path == "thermal.core":
        case = changed("thermal", {"ambient": 300.0, "convection": 10.0, "core": value})
    elif path == "plane.base.poisson_ratio":
        case = changed("plane", {"base": {"shear_modulus": 1e6, "poisson_ratio": value}})
    else:
        case = changed(place, value)
    with pytest.raises(vr.InvalidInput) as raised:
        motion.build_motion(case, None) if path.startswith("motion") else build_case(case, None)
    assert raised.value.parameter == path
    assert path in {place for error in VALIDATOR.iter_errors(case) for place in places(error)}
