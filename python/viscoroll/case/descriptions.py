"""Descriptions of parameters as JSON Schema, from the docstrings of classes and functions."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable
from enum import Enum
from typing import Any

from .. import enums

__all__ = ["parameter_schemas"]

_SECTION = re.compile(r"^Parameters\n-+\n(?P<entries>.*?)(?=^\w[\w ]*\n-+$|\Z)", re.DOTALL | re.MULTILINE)
_ENTRY = re.compile(r"^(?P<names>\w+(?:, \w+)*) : (?P<kind>.*)\n(?P<text>(?:(?: {4}.*)?\n?)+?)(?=^\w|\Z)", re.MULTILINE)

#: Types of docstrings, and JSON Schema for them.
_KINDS: dict[str, dict[str, Any]] = {
    "float": {"type": "number"},
    "int": {"type": "integer"},
    "array_like": {"type": "array", "items": {"type": "number"}},
    "str": {"type": "string"},
}

#: Ranges that follow a unit in docstrings, as in "[m], > 0", and JSON Schema for them.
_RANGES = {
    "> 0": {"exclusiveMinimum": 0},
    "≥ 0": {"minimum": 0},
    "in [0, 1]": {"minimum": 0, "maximum": 1},
    "in (0, 1]": {"exclusiveMinimum": 0, "maximum": 1},
}

#: Unit in a docstring, the first text in brackets that is no interval.
_UNIT = re.compile(r"\[(?P<unit>[^\d\W][^\]\d]*[²³]?[^\]\d]*|1/[^\]]+|-)\]")

_RANGE = re.compile(r"\], (?:each )?(?P<range>" + "|".join(map(re.escape, _RANGES)) + r")(?!\d|\.\d)")


def parameter_schemas(make: Callable[..., Any]) -> dict[str, dict[str, Any]]:
    """Return JSON Schema of each parameter of a class or function: its description, type, unit, range and default.

    The unit is an annotation of this package, ``unit``, with "1" for numbers without unit.
    """
    section = _SECTION.search(f"{inspect.getdoc(make) or ''}\n")
    found: dict[str, dict[str, Any]] = {}
    for entry in _ENTRY.finditer(section["entries"] if section else ""):
        text = " ".join(entry["text"].split())
        for name in entry["names"].split(", "):
            found[name] = {"description": text, **_of_kind(entry["kind"], text)}
            if unit := _UNIT.search(text):
                found[name]["unit"] = "1" if unit["unit"] == "-" else unit["unit"]
    for name, parameter in inspect.signature(make).parameters.items():
        if name in found and (default := _as_json(parameter.default)) is not None:
            found[name]["default"] = default
    return found


def _of_kind(kind: str, text: str) -> dict[str, Any]:
    name = kind.partition(",")[0]
    member = getattr(enums, name.removesuffix(" or str"), None)
    if isinstance(member, type) and issubclass(member, Enum):
        return {"enum": [one.name.lower() for one in member]}
    schema = dict(_KINDS.get(name, {}))
    limits = _RANGES[found["range"]] if (found := _RANGE.search(text)) else {}
    if schema.get("type") == "array":
        schema["items"] = schema["items"] | limits
        return schema
    return schema | (limits if schema else {})


def _as_json(default: object) -> object:
    if isinstance(default, Enum):
        return default.name.lower()
    known = isinstance(default, bool | int | str) or (isinstance(default, float) and math.isfinite(default))
    return default if known else None
