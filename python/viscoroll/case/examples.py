"""Complete example files, whose comments are the descriptions of the JSON Schema (the extra `viscoroll[cli]`)."""

from __future__ import annotations

import json
import re
import textwrap
from collections.abc import Iterator, Mapping
from typing import Any

from .schema import json_schema
from .unit_texts import FileKeys

__all__ = ["EXAMPLES", "generated_example"]

#: Width of the files [characters].
_WIDTH = 120

#: Largest length of a description, except that it has at least one sentence [characters].
_LONGEST = 130

_RUBBER = {
    "type": "prony",
    "instantaneous_modulus": "3 MPa",
    "weights": [0.25, 0.15, 0.1],
    "relaxation_times": ["1 ms", "10 ms", "100 ms"],
}
_TREAD = {"thickness": "8 mm", "poisson_ratio": 0.5, "density": "1.1 g/cm^3", "shear_modulus": _RUBBER}
_COVER = {"thickness": "10 mm", "poisson_ratio": 0.5, "density": "1.1 g/cm^3", "shear_modulus": _RUBBER}
_WHEEL = {"outer_diameter": "125 mm", "width": "32 mm", "layers": [_TREAD]}

#: Title and content of each example.
EXAMPLES: dict[str, tuple[str, dict[str, Any]]] = {
    "wheel": (
        "A wheel with a rubber tread that rolls on a rigid plane, for `viscoroll solve`.",
        {"wheel": _WHEEL, "rolling": {"load": "60 kgf", "speed": "4 km/h"}, "numerics": {"accuracy": 0.05}},
    ),
    "rollers": (
        "A rubber-covered roller on a steel roller, for `viscoroll solve`. Loads, forces and torques are per length.",
        {
            "cylinder": {"outer_diameter": "120 mm", "layers": [_COVER]},
            "other_cylinder": {"outer_diameter": "200 mm", "layers": []},
            "rolling": {"load": "5 N/mm", "angular_speed": "90 rpm"},
            "numerics": {"accuracy": 0.05},
        },
    ),
    "half-space": (
        "A rigid ball that rolls on a half-space of rubber, for `viscoroll solve`.",
        {
            "ball": {"core_radius": "10 mm", "layers": []},
            "plane": {"base": {name: value for name, value in _TREAD.items() if name != "thickness"}},
            "rolling": {"load": "5 N", "angular_speed": "60 rpm"},
            "numerics": {"accuracy": 0.05},
        },
    ),
    "thermal": (
        "A wheel whose tread heats itself, for `viscoroll solve`, which computes temperatures and all steady states.",
        {
            "wheel": _WHEEL | {"layers": [_TREAD | {"conductivity": "0.25 W/(m K)"}]},
            "rolling": {"load": "60 kgf", "speed": "10 km/h"},
            "numerics": {"accuracy": 0.05},
            "thermal": {
                "convection": "20 W/(m^2 K)",
                "ambient": "23 degC",
                "core": "isothermal",
                "core_temperature": "30 degC",
                "side_convection": "15 W/(m^2 K)",
                "limit": "120 degC",
                "shift": {
                    "type": "williams_landel_ferry",
                    "c1": 8.86,
                    "c2": "101.6 K",
                    "reference_temperature": "23 degC",
                },
            },
        },
    ),
}


def generated_example(name: str) -> str:
    """Return one of `EXAMPLES` as the text of a file; all other keys of its tables are comments."""
    title, document = EXAMPLES[name]
    keys = FileKeys(json_schema(), line_contact="cylinder" in document)
    head = [
        f"# {title}",
        "# Texts state their unit; numbers without a text are in SI units. Lines with # are optional keys.",
    ]
    return "\n".join([*head, *_table(keys, document, keys.schema, ())]) + "\n"


def _table(keys: FileKeys, table: Mapping[str, Any], node: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[str]:
    """Yield the lines of a table: its keys, its optional keys as comments, then its tables."""
    nested = {name: value for name, value in table.items() if _is_table(value)}
    if path:
        for name, value in table.items():
            if name not in nested:
                schema = {"description": keys.kinds_text(node)} if name == "type" else keys.child(node, table, name)
                yield from _entry(schema, name, _text(value))
        for name, schema in keys.properties(node, table).items():
            if name not in table and not keys.holds_tables(schema):
                yield from _entry(schema, f"# {name}", _default(schema))
    for name, value in nested.items():
        child = keys.child(node, table, name) or {}
        for entry in value if isinstance(value, list) else [value]:
            header = ".".join((*path, name))
            yield ""
            yield f"[[{header}]]" if isinstance(value, list) else f"[{header}]"
            inner = keys.child(child, value, 0) or {} if isinstance(value, list) else child
            yield from _table(keys, entry, inner, (*path, name))


def _is_table(value: object) -> bool:
    return isinstance(value, dict) or (isinstance(value, list) and any(isinstance(one, dict) for one in value))


def _entry(schema: Mapping[str, Any] | None, name: str, value: str) -> Iterator[str]:
    """Yield a key with its value and its description, which continues on lines of its own if it is long."""
    line = f"{name} = {value}".rstrip()
    text = _meaning(schema or {})
    column = max(40, len(line) + 2)
    first, *more = textwrap.wrap(text, max(_WIDTH - column - 2, 40)) or [""]
    yield f"{line:<{column}}# {first}" if first else line
    for row in more:
        yield f"{'#' if name.startswith('#') else '':<{column}}# {row}"


def _meaning(schema: Mapping[str, Any]) -> str:
    """Return the meaning of a key with its unit, range and choices."""
    text, *others = re.split(r"(?<=[.])\s+(?=[A-Z])", schema.get("description", ""))
    for sentence in others:
        if len(text) + len(sentence) > _LONGEST:
            break
        text = f"{text} {sentence}"
    text = text.replace("`", "").replace("viscoroll.", "")
    choices = schema.get("enum") or [one["const"] for one in schema.get("anyOf", []) if "const" in one]
    return f"{text.rstrip('.')}: {', '.join(map(str, choices))}" if choices else text


def _default(schema: Mapping[str, Any]) -> str:
    return _text(schema["default"]) if schema.get("default") is not None else "..."


def _text(value: Any) -> str:
    """Return a value in TOML, which JSON is for texts, numbers and lists."""
    return json.dumps(value, ensure_ascii=False)
