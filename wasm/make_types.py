"""Write JavaScript files from the JSON Schema of case files; with --check, compare them.

The files are the types of inputs in package/viscoroll.d.ts, and the lists for the page, schema.js and unit_table.js in
python/viscoroll/app/page. `make stubs` runs this script, and a test compares the files. The types of the answer in
viscoroll.d.ts, below the marked lines, are written by hand.
"""

from __future__ import annotations

import json
import sys
import textwrap
from dataclasses import fields
from pathlib import Path
from typing import Any

import viscoroll
from viscoroll._support.units import DISPLAY_UNITS, PER_LENGTH
from viscoroll.app.answer import OTHER_TABLES
from viscoroll.case.case import BODIES, COUNTERBODIES
from viscoroll.case.quantities import CENTER_SPEED, DISPLAYED, SPELLINGS, offset_of, same_dimension, scale_of
from viscoroll.case.schema import json_schema
from viscoroll.materials.moduli import MODULI
from viscoroll.solution.scalars import words_for

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "python" / "viscoroll" / "app" / "page" / "schema.js"
UNITS = PAGE.with_name("unit_table.js")
TYPES = ROOT / "wasm" / "package" / "viscoroll.d.ts"
BEGIN = "// Written by wasm/make_types.py from the JSON Schema of case files:\n"
END = "// End of the types that are written by wasm/make_types.py\n"

SCHEMA = json_schema()

#: Classes of bodies, by their tables in case files.
CLASSES = {name: SCHEMA["properties"][name]["$ref"].rpartition("/")[2] for name in (*BODIES, *COUNTERBODIES)}

#: Definitions of the schema, by the names of their types, in the order of the file.
INTERFACES = {
    "HalfSpace": "HalfSpace",
    "Layer": "Layer",
    **{name.capitalize(): kind for name, kind in CLASSES.items() if not name.startswith("other_")},
    "Drive": "Drive",
    "Adhesion": "Adhesion",
    "Rolling": "Rolling",
    "Numerics": "viscoroll__case__case__Numerics",
}
#: The same for tables that only histories have.
HISTORY_INTERFACES = {
    "Points": "points",
    "Step": "step",
    "HalfSine": "half_sine",
    "Joint": "joint",
    "Corrugation": "corrugation",
    "Axle": "Axle",
    "Motion": "Motion",
    "HistoryNumerics": "viscoroll__case__motion__Numerics",
}
#: Types of profiles of ground and tread, which `HISTORY_INTERFACES` begins with.
PROFILES = ("Points", "Step", "HalfSine", "Joint", "Corrugation")
TYPE_OF = {f"#/$defs/{definition}": name for name, definition in (INTERFACES | HISTORY_INTERFACES).items()}

#: Keys of case files that the library in WebAssembly does not read.
FILE_ONLY = {"allow_large", "file", "outer_diameter"}

#: Tables of motion files besides those of bodies, and tables that the library in WebAssembly does not read.
HISTORY_TABLES = ("motion", "ground", "tread", "axle")
OTHERS = ("thermal", "surface", "sliding", "sweep", "draws", "design")


def input_types() -> str:
    """Return the types of a case and of its tables."""
    definitions = SCHEMA["$defs"]
    moduli = {kind.__name__: kind.__name__ for kind in MODULI.values()} | {"Hardness": "of_data_sheet"}
    parts = [_interface(name, definitions[definition]) for name, definition in moduli.items()]
    parts += [
        _comment("Modulus [Pa] as a function of angular frequency; a number is an elastic modulus.")
        + "export type ShearModulus =\n"
        + "".join(f"  | {name}\n" for name in ("number", *moduli)).rstrip("\n")
        + ";\n"
    ]
    parts += [_interface(name, definitions[definition]) for name, definition in INTERFACES.items()]
    parts += [_interface(name, definitions[definition]) for name, definition in HISTORY_INTERFACES.items()]
    parts += [
        _comment("Height over the distance, of the ground along the track or of the tread around the body.")
        + f"export type Profile = {' | '.join(PROFILES)};\n"
    ]
    tables = {name: table for name, table in SCHEMA["properties"].items() if name not in OTHERS}
    of_case = {name: table for name, table in tables.items() if name not in HISTORY_TABLES}
    case = {"properties": of_case, "required": ["rolling"], "description": "Tables and keys of a case file."}
    of_motion = {name: table for name, table in tables.items() if name != "rolling"}
    of_motion["numerics"] = {"$ref": f"#/$defs/{HISTORY_INTERFACES['HistoryNumerics']}"}
    motion = {"properties": of_motion, "required": ["motion"], "description": "Tables and keys of a motion file."}
    return "\n".join([*parts, _interface("Case", case), _interface("MotionCase", motion)])


def page_lists() -> str:
    """Return the module of the page with the tables of bodies and the keys of whole numbers."""
    kinds = {name: getattr(viscoroll, CLASSES[name]) for name in BODIES}
    bodies = {
        name: {"noun": kind.noun, "line": kind.line_contact, "words": words_for(kind)} for name, kind in kinds.items()
    }
    tables = [SCHEMA["$defs"][definition]["properties"] for definition in INTERFACES.values()]
    integers = [key for table in tables for key, found in table.items() if found.get("type") == "integer"]
    lists = {
        "BODIES": (
            "Rolling bodies by their tables in case files: noun, whether values are per length, and words of labels.",
            bodies,
        ),
        "CLASSES": ("Classes of bodies in Python, by their tables in case files.", CLASSES),
        "COMMON_MODULI": (
            "Classes of moduli that are names of the Python package; the others are names of its module `materials`.",
            sorted({*viscoroll.__all__} & {*viscoroll.materials.__all__}),
        ),
        "INTEGERS": ("Keys of case files whose values are whole numbers.", integers),
        "MESH": (
            "Keys of the table `numerics` that describe a mesh.",
            [field.name for field in fields(viscoroll.Mesh)],
        ),
        "KEY_UNITS": ("SI units of keys of case files, in point contact.", key_units()),
        "OTHER_TABLES": ("Tables of case files that the page does not support.", list(OTHER_TABLES)),
    }
    exports = [f"/** {text} */\nexport const {name} = {_literal(value)};\n" for name, (text, value) in lists.items()]
    return "\n".join(
        ["// Written by wasm/make_types.py from the package and the JSON Schema of case files.\n", *exports]
    )


def key_units() -> dict[str, str]:
    """Return the SI units of the keys of bodies, materials and motion that are in a unit of the page."""
    displayed = {unit for unit, _ in DISPLAYED.values()} | {CENTER_SPEED}
    names = [*INTERFACES.values(), *(kind.__name__ for kind in MODULI.values()), "of_data_sheet", "published"]
    keys = [
        (key, found["unit"])
        for name in names
        for key, found in SCHEMA["$defs"][name]["properties"].items()
        if "unit" in found
    ]
    units = {key: unit for key, unit in keys if unit in displayed}
    if any(units.get(key, unit) != unit for key, unit in keys):
        raise ValueError("a key must have the same unit in all tables")
    return units


def page_units() -> str:
    """Return the module of the page with the SI values of units, which pint computes as in case files."""
    units: dict[str, dict[str, float | None]] = {}
    for quantity, (si, names) in DISPLAYED.items():
        speeds = [name for name in names if same_dimension(name, CENTER_SPEED) and si != CENTER_SPEED]
        units[quantity] = {name: None if name in speeds else float(scale_of(name, si)) for name in names}
    displayed = {name for names in units.values() for name in names}
    lists = {
        "UNITS": (
            "SI values of the units, by quantity; the first unit is the default. `CENTER_SPEEDS` has those of null.",
            units,
        ),
        "OFFSETS": (
            "SI value of 0 in a unit, for units whose zero is not that of the SI unit.",
            {name: float(offset_of(name)) for name in sorted(displayed) if offset_of(name)},
        ),
        "ALIASES": ("Other spellings of units that users may type, in lower case.", SPELLINGS),
        "CENTER_SPEEDS": (
            "SI values [m/s] of units for the speed of the center: the angular speed times the outer radius.",
            {name: float(scale_of(name, CENTER_SPEED)) for name, scale in units["speed"].items() if scale is None},
        ),
        "DISPLAY_UNITS": (
            "Units in which results are displayed, by SI unit: SI value, and smallest value displayed in the unit.",
            {unit: {name: list(pair) for name, pair in names.items()} for unit, names in DISPLAY_UNITS.items()},
        ),
        "PER_LENGTH": ("Units in line contact of results that are per length there.", PER_LENGTH),
    }
    exports = [f"/** {text} */\nexport const {name} = {_literal(value)};\n" for name, (text, value) in lists.items()]
    return "\n".join(
        ["// Written by wasm/make_types.py from case/units.txt and _support/units.py in python/viscoroll.\n", *exports]
    )


def _literal(value: Any) -> str:
    """Return a list in one line, or an object with one line for each key."""
    if not isinstance(value, dict):
        return json.dumps(value)
    return "{\n" + "".join(f"  {_name(key)}: {_inline(one)},\n" for key, one in value.items()) + "}"


def _inline(value: Any) -> str:
    """Return an object or a text in one line, with keys as JavaScript usually spells them."""
    if isinstance(value, list):
        return f"[{', '.join(map(_inline, value))}]"
    if not isinstance(value, dict):
        whole = isinstance(value, float) and value.is_integer()
        return json.dumps(int(value) if whole else value, ensure_ascii=False).replace("e-0", "e-")
    return "{ " + ", ".join(f"{_name(key)}: {_inline(one)}" for key, one in value.items()) + " }"


def _name(key: str) -> str:
    """Return a key as JavaScript usually spells it."""
    return key if key.isidentifier() else json.dumps(key, ensure_ascii=False)


def _interface(name: str, schema: dict[str, Any]) -> str:
    choices = [schema.get("oneOf", []), *(group["oneOf"] for group in schema.get("allOf", []))]
    left = [[one["required"] for one in choice if not {*one["required"]} & FILE_ONLY] for choice in choices]
    required = {*schema.get("required", []), *(key for choice in left if len(choice) == 1 for key in choice[0])}
    summary = schema.get("description", "").partition("\n\n")[0]
    lines = [_comment(summary) if summary else "", f"export interface {name} {{\n"]
    for key, found in schema["properties"].items():
        if key in FILE_ONLY:
            continue
        if "description" in found and key != "shear_modulus":  # described at `ShearModulus`, which is no function here
            lines.append(_comment(found["description"], "  "))
        lines.append(
            f"  {key}: {_type(key, found)};\n" if key in required else f"  {key}?: {_type(key, found)} | null;\n"
        )
    return "".join([*lines, "}\n"])


def _type(key: str, schema: dict[str, Any]) -> str:
    """Return the type of a key in TypeScript."""
    if key == "shear_modulus":
        return "ShearModulus"
    if "$ref" in schema:
        return TYPE_OF[schema["$ref"]]
    if key == "numerics":  # the table has other keys in files for histories
        return "Numerics"
    if key in ("ground", "tread"):
        return "Profile"
    if "anyOf" in schema:
        return " | ".join(_type("", one) for one in schema["anyOf"])
    if "const" in schema:
        return f'"{schema["const"]}"'
    if "enum" in schema:
        return " | ".join(f'"{name}"' for name in schema["enum"])
    if schema["type"] == "array":
        return f"{_type('', schema['items'])}[]"
    kind = schema["type"][0] if isinstance(schema["type"], list) else schema["type"]  # texts with units are for files
    return {"number": "number", "integer": "number", "boolean": "boolean"}[kind]


def _comment(text: str, indent: str = "") -> str:
    line = f"{indent}/** {text} */\n"
    if len(line) <= 120:
        return line
    rows = textwrap.wrap(text, 117 - len(indent))
    return f"{indent}/**\n" + "".join(f"{indent} * {row}\n" for row in rows) + f"{indent} */\n"


def main() -> int:
    """Write or check the files; return the exit code."""
    found = TYPES.read_text(encoding="utf-8")
    before, _, rest = found.partition(BEGIN)
    files = {
        TYPES: f"{before}{BEGIN}\n{input_types()}\n{END}{rest.partition(END)[2]}",
        PAGE: page_lists(),
        UNITS: page_units(),
    }
    if sys.argv[1:] == ["--check"]:
        wrong = [path for path, text in files.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
        for path in wrong:
            print(f"{path} differs from the schema: run `make stubs`", file=sys.stderr)
        return int(bool(wrong))
    for path, text in files.items():
        path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
