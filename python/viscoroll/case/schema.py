"""JSON Schema of case files, from which editors complete and check them (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from typing import Any

from .._support.extras import extra
from . import case, design, motion, sliding, study
from .case import BODIES, COUNTERBODIES
from .ground import AxleTable, ProfileTable
from .quantities import QUANTITY

with extra("cli"):
    from pydantic import create_model
    from pydantic.json_schema import GenerateJsonSchema

__all__ = ["json_schema"]


class _WithoutTitles(GenerateJsonSchema):
    """Generator that adds no titles, which would repeat the keys."""

    def field_title_should_be_set(self, schema: Any) -> bool:  # noqa: ARG002
        return False


def _with_texts(schema: Any) -> Any:
    """Return JSON Schema in which texts with units may replace all numbers that are not integers."""
    if isinstance(schema, list):
        return [_with_texts(one) for one in schema]
    if not isinstance(schema, dict):
        return schema
    found = {name: _with_texts(one) for name, one in schema.items()}
    return found | {"type": ["number", "string"], "pattern": QUANTITY} if found.get("type") == "number" else found


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of case files, with all tables that any command reads.

    Returns
    -------
    dict
        Schema that can be written as JSON. It contains names, types, units and ranges of all keys; the unit is also in
        an annotation of its own, `unit`. Rules that relate several keys are left to the commands.
    """
    numbers = list[float] | study.Range
    model = create_model(
        "CaseFile",
        __base__=case.PairTables,
        rolling=(case.Rolling | None, None),
        numerics=(case.Numerics | motion.Numerics, case.Numerics()),
        thermal=(case.Thermal | None, None),
        motion=(motion.Motion | None, None),
        ground=(ProfileTable | None, None),
        tread=(ProfileTable | None, None),
        axle=(AxleTable | None, None),
        surface=(sliding.Surface | None, None),
        sliding=(sliding.Sliding | None, None),
        sweep=(dict[str, numbers] | None, None),
        draws=(study.Draws | None, None),
        design=(design.Wanted | None, None),
    )
    schema = _with_texts(model.model_json_schema(schema_generator=_WithoutTitles))
    one_body = [{"required": [name]} for name in (*BODIES, "surface")]
    pairs = [{"required": [first, second]} for i, first in enumerate(COUNTERBODIES) for second in COUNTERBODIES[:i]]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **schema,
        "title": "Case file of viscoroll",
        "description": "Bodies, load case and studies for the commands of viscoroll. Numbers are in SI units; texts "
        "such as '10 mm' state their unit.",
        "oneOf": one_body,
        "not": {"anyOf": pairs},
    }
