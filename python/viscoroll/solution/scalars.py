"""Scalar results, as described by the table of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

from .. import _core
from .._support.scalars import scalar_fields, units_in_contact
from ..bodies import RollingBody

__all__ = ["PRECISION", "SCALARS", "SCALAR_GROUPS", "ScalarFields", "label_of", "scalar_units", "words_for"]

#: Unit and label of each scalar result, by name.
SCALARS = {scalar.name: (scalar.unit, scalar.label) for scalar in _core.result_scalars()}

#: Part of a report to which each scalar belongs: "answer", "friction" (of the answer, with friction), "certainty" or
#: "other".
SCALAR_GROUPS = {scalar.name: scalar.group for scalar in _core.result_scalars()}

#: Names of the relative error estimates of each scalar, whose sum limits its printed digits; ("%",) for a ratio that is
#: printed in percent.
PRECISION = {scalar.name: tuple(scalar.precision.split()) for scalar in _core.result_scalars()}

_RollingBody: TypeAlias = "RollingBody | type[RollingBody]"


def scalar_units(*, line_contact: bool) -> dict[str, str]:
    """Return the unit of every scalar result."""
    return units_in_contact(_core.result_scalars(), line_contact=line_contact)


def label_of(name: str, body: _RollingBody) -> str:
    """Return the label of a scalar result in the words for a rolling body, without the explanation after a comma.

    Examples
    --------
    >>> from viscoroll import CoatedCylinder
    >>> label_of("lateral_force", CoatedCylinder)
    'lateral force on the roller'
    >>> label_of("contact_length", CoatedCylinder)
    'nip length'
    """
    label = SCALARS[name][1].partition(",")[0]
    for generic, word in words_for(body).items():
        label = label.replace(generic, word)
    return label


def words_for(body: _RollingBody) -> dict[str, str]:
    """Return the words that replace those of the labels for a rolling body."""
    return {"rolling body": body.noun} | ({"contact length": "nip length"} if body.line_contact else {})


if TYPE_CHECKING:
    from .._core import ResultScalars as ScalarFields
else:
    #: Dataclass with one field per scalar result.
    ScalarFields = scalar_fields(
        "ScalarFields", {scalar.name: scalar.type.replace(" or ", " | ") for scalar in _core.result_scalars()}
    )
