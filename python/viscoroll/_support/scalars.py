"""Classes whose attributes are the scalars in tables of the core."""

from __future__ import annotations

import inspect
import textwrap
from collections.abc import Callable, Iterable
from dataclasses import make_dataclass
from typing import TYPE_CHECKING, TypeVar

from .units import unit_in_contact

if TYPE_CHECKING:
    from .._core import ScalarDescription

__all__ = ["scalar_fields", "units_in_contact", "with_scalars"]

_Class = TypeVar("_Class", bound=type)


def units_in_contact(scalars: Iterable[ScalarDescription], *, line_contact: bool) -> dict[str, str]:
    """Return the unit of every scalar by name; in line contact, forces, torques and energies are per length."""
    return {scalar.name: unit_in_contact(scalar.unit, line_contact=line_contact) for scalar in scalars}


def scalar_fields(name: str, types: dict[str, str]) -> type:
    """Return a frozen dataclass with a keyword-only field for each scalar, given the types by name."""
    return make_dataclass(name, types.items(), frozen=True, slots=True, kw_only=True, eq=False, repr=False)


def with_scalars(scalars: Iterable[ScalarDescription], *, kind: str | None = None) -> Callable[[_Class], _Class]:
    """Return a decorator that replaces ``%(scalars)s`` in the docstring of a class by a description of each scalar.

    Parameters
    ----------
    scalars : iterable of ScalarDescription
        Table of the core.
    kind : str, optional
        Type of all attributes; by default, the type of each scalar in the table.
    """

    def described(owner: _Class) -> _Class:
        if owner.__doc__:
            entries = "\n".join(_entry(scalar, kind or scalar.type) for scalar in scalars)
            owner.__doc__ = inspect.cleandoc(owner.__doc__).replace("%(scalars)s", entries)
        return owner

    return described


def _entry(scalar: ScalarDescription, kind: str) -> str:
    """Return the entry of a scalar for the section Attributes of a docstring."""
    unit = "-" if scalar.unit == "1" else scalar.unit
    text = f"{scalar.label[0].upper()}{scalar.label[1:]} [{unit}]. {scalar.details}".rstrip()
    return f"{scalar.name} : {kind}\n" + textwrap.indent(textwrap.fill(text, 112), "    ")
