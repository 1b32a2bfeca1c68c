"""JSON Schema of case files, from which editors complete and check them (the extra `viscoroll[cli]`)."""

from __future__ import annotations

from typing import Any

from .._support.extras import extra
from . import case, design, motion, study
from .case import BODIES, COUNTERBODIES
from .ground import AxleTable, ProfileTable

with extra("cli"):
    from pydantic import create_model
    from pydantic.json_schema import GenerateJsonSchema

__all__ = ["json_schema"]


class _WithoutTitles(GenerateJsonSchema):
    """Generator that adds no titles, which would repeat the keys."""

    def field_title_should_be_set(self, schema: Any) -> bool:  # noqa: ARG002
        return False


def json_schema() -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of case files, with all tables that any command reads.

    Returns
    -------
    dict
        Schema that can be written as JSON. It contains names, types, units and ranges of all keys. Rules that relate
        several keys are left to the commands.
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
        sweep=(dict[str, numbers] | None, None),
        draws=(study.Draws | None, None),
        design=(design.Wanted | None, None),
    )
    schema = model.model_json_schema(schema_generator=_WithoutTitles)
    one_body = [{"required": [name]} for name in BODIES]
    pairs = [{"required": [first, second]} for i, first in enumerate(COUNTERBODIES) for second in COUNTERBODIES[:i]]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        **schema,
        "title": "Case file of viscoroll",
        "description": "Bodies, load case and studies for the commands of viscoroll, in SI units.",
        "oneOf": one_body,
        "not": {"anyOf": pairs},
    }
