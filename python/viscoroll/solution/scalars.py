"""Scalar results, as described by the table of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import _core
from .._support.scalars import scalar_fields, units_in_contact

__all__ = ["SCALARS", "ScalarFields", "scalar_units"]

#: Unit and label of each scalar result, by name.
SCALARS = {scalar.name: (scalar.unit, scalar.label) for scalar in _core.result_scalars()}


def scalar_units(*, line_contact: bool) -> dict[str, str]:
    """Return the unit of every scalar result."""
    return units_in_contact(_core.result_scalars(), line_contact=line_contact)


if TYPE_CHECKING:
    from .._core import ResultScalars as ScalarFields
else:
    #: Dataclass with one field per scalar result.
    ScalarFields = scalar_fields(
        "ScalarFields", {scalar.name: scalar.type.replace(" or ", " | ") for scalar in _core.result_scalars()}
    )
