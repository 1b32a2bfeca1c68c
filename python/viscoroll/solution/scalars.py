"""The scalar results, as the table of the core describes them."""

from __future__ import annotations

import inspect
import textwrap
from dataclasses import make_dataclass
from typing import TYPE_CHECKING, TypeVar

from .. import _core
from .._support.units import unit_in_contact

__all__ = ["SCALARS", "ScalarFields", "scalar_units", "with_scalars"]

#: Scalar results: name, unit, what it is.
SCALARS = {scalar.name: (scalar.unit, scalar.label) for scalar in _core.result_scalars()}


def scalar_units(*, line_contact: bool) -> dict[str, str]:
    """Return the unit of every scalar result."""
    return {name: unit_in_contact(unit, line_contact=line_contact) for name, (unit, _) in SCALARS.items()}


if TYPE_CHECKING:
    from .._core import ResultScalars as ScalarFields
else:
    #: A field of each name.
    ScalarFields = make_dataclass(
        "ScalarFields",
        [(scalar.name, scalar.type.replace(" or ", " | ")) for scalar in _core.result_scalars()],
        frozen=True,
        slots=True,
        kw_only=True,
        eq=False,
        repr=False,
    )

_Class = TypeVar("_Class", bound=type)


def with_scalars(described: _Class) -> _Class:
    """Fill the scalar results into the docstring of a class, where it says ``%(scalars)s`` among the attributes."""
    if described.__doc__:
        entries = "\n".join(map(_entry, _core.result_scalars()))
        described.__doc__ = inspect.cleandoc(described.__doc__).replace("%(scalars)s", entries)
    return described


def _entry(scalar: _core.ScalarDescription) -> str:
    """Return a scalar's entry in a section of attributes."""
    unit = "-" if scalar.unit == "1" else scalar.unit
    text = f"{scalar.label[0].upper()}{scalar.label[1:]} [{unit}]. {scalar.details}".rstrip()
    return f"{scalar.name} : {scalar.type}\n" + textwrap.indent(textwrap.fill(text, 112), "    ")
