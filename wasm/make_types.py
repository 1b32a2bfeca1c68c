"""Write the types of inputs in package/viscoroll.d.ts from the JSON Schema of case files; with --check, compare them.

`make stubs` runs this script, and a test compares the file. The types of the answer, below the marked lines, are
written by hand.
"""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path
from typing import Any

from viscoroll.case.schema import json_schema
from viscoroll.materials.moduli import MODULI

TYPES = Path(__file__).parent / "package" / "viscoroll.d.ts"
BEGIN = "// Written by wasm/make_types.py from the JSON Schema of case files:\n"
END = "// End of the types that are written by wasm/make_types.py\n"

#: Definitions of the schema, by the names of their types, in the order of the file.
INTERFACES = {
    "HalfSpace": "HalfSpace",
    "Layer": "Layer",
    "Ball": "CoatedSphere",
    "Cylinder": "CoatedCylinder",
    "Wheel": "CoatedWheel",
    "Plane": "CoatedPlane",
    "Groove": "Groove",
    "Drive": "Drive",
    "Rolling": "Rolling",
    "Numerics": "viscoroll__case__case__Numerics",
}
TYPE_OF = {f"#/$defs/{definition}": name for name, definition in INTERFACES.items()}

#: Tables of case files that the library in WebAssembly does not read.
OTHERS = ("thermal", "motion", "sweep", "draws", "design")


def input_types() -> str:
    """Return the types of a case and of its tables."""
    schema = json_schema()
    definitions = schema["$defs"]
    names = [kind.__name__ for kind in MODULI.values()]
    parts = [_interface(name, definitions[name]) for name in names]
    parts += [
        _comment("Modulus [Pa] as a function of angular frequency; a number is an elastic modulus.")
        + "export type ShearModulus =\n"
        + "".join(f"  | {name}\n" for name in ("number", *names)).rstrip("\n")
        + ";\n"
    ]
    parts += [_interface(name, definitions[definition]) for name, definition in INTERFACES.items()]
    tables = {name: table for name, table in schema["properties"].items() if name not in OTHERS}
    case = {"properties": tables, "required": ["rolling"], "description": "Tables and keys of a case file."}
    return "\n".join([*parts, _interface("Case", case)])


def _interface(name: str, schema: dict[str, Any]) -> str:
    required = {*schema.get("required", []), *(key for one in schema.get("oneOf", []) for key in one["required"])}
    lines = [_comment(schema["description"]) if "description" in schema else "", f"export interface {name} {{\n"]
    for key, found in schema["properties"].items():
        if key == "file":  # this library reads no files
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
    if key == "numerics":  # the table has other keys in files for histories
        return "Numerics"
    if "$ref" in schema:
        return TYPE_OF[schema["$ref"]]
    if "const" in schema:
        return f'"{schema["const"]}"'
    if "enum" in schema:
        return " | ".join(f'"{name}"' for name in schema["enum"])
    if schema["type"] == "array":
        return f"{_type('', schema['items'])}[]"
    return {"number": "number", "integer": "number", "boolean": "boolean"}[schema["type"]]


def _comment(text: str, indent: str = "") -> str:
    line = f"{indent}/** {text} */\n"
    if len(line) <= 120:
        return line
    rows = textwrap.wrap(text, 117 - len(indent))
    return f"{indent}/**\n" + "".join(f"{indent} * {row}\n" for row in rows) + f"{indent} */\n"


def main() -> int:
    """Write or check the types; return the exit code."""
    found = TYPES.read_text(encoding="utf-8")
    before, _, rest = found.partition(BEGIN)
    made = f"{before}{BEGIN}\n{input_types()}\n{END}{rest.partition(END)[2]}"
    if sys.argv[1:] == ["--check"]:
        if made != found:
            print(f"{TYPES} differs from the schema: run `make stubs`", file=sys.stderr)
        return int(made != found)
    TYPES.write_text(made, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
