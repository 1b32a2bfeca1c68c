"""Arguments that the readers of sweeps, strain sweeps and tests over time share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

from .._support.arguments import as_count, as_poisson_ratio
from .._support.errors import InvalidInput, InvalidType, in_file
from .._support.text import shown
from .formats import read_text
from .tables import Table, listed
from .text import Names, find_tables

__all__ = ["Columns", "checked_conversion", "named_columns", "numbered", "tables_of", "unread_tables"]

#: Name of a column, or name and unit, by role.
Columns: TypeAlias = Mapping[str, "str | tuple[str, str]"]


def named_columns(columns: Columns | None, roles: Sequence[str]) -> dict[str, tuple[str, str | None]]:
    """Return names and units of the columns that the caller specifies, after a check of their roles.

    Raises
    ------
    ValueError, TypeError
        If a role is unknown, or a value is neither a name nor a pair of name and unit.
    """
    names: dict[str, tuple[str, str | None]] = {}
    for role, value in (columns or {}).items():
        if role not in roles:
            raise InvalidInput("columns", f"must have keys from {', '.join(roles)}", repr(role))
        pair = (value, None) if isinstance(value, str) else value
        if (
            not isinstance(pair, tuple | list)
            or len(pair) != 2
            or not isinstance(pair[0], str)
            or not isinstance(pair[1], str | None)
        ):
            raise InvalidType(f"columns[{role!r}]", "must be a name, or a name and a unit", shown(value))
        names[role] = (pair[0], pair[1])
    return names


def checked_conversion(tensile: bool | None, poisson_ratio: float) -> float:
    """Return Poisson's ratio [-] for the conversion of tension to shear, after a check of both arguments.

    Raises
    ------
    ValueError, TypeError
        If Poisson's ratio is not in (-1, 0.5], or `tensile` is not True, False or None.
    """
    nu = as_poisson_ratio("poisson_ratio", poisson_ratio)
    if tensile is not None and not isinstance(tensile, bool):
        raise InvalidType("tensile", "must be True, False or None", shown(tensile))
    return nu


def tables_of(path: Path, names: Names) -> list[Table]:
    """Return the data sets of a file; a ValueError names the file."""
    text = read_text(path)
    try:
        return find_tables(text, names)
    except ValueError as error:
        raise in_file(error, path) from None


def numbered(found: Sequence[Table], step: int) -> Table:
    """Return the data set with a number, from 1.

    Raises
    ------
    ValueError, TypeError
        If there is no such data set.
    """
    return found[as_count("step", step, 1, len(found)) - 1]


def unread_tables(found: Sequence[Table], read: Sequence[Table]) -> list[str]:
    """Return a remark that lists all data sets of a file and the numbers of those that are read, if not all are."""
    if len(read) == len(found):
        return []
    chosen = [str(number) for number, table in enumerate(found, 1) if any(table is one for one in read)]
    return [f"data sets of the file: {listed(found)}; read: {', '.join(chosen)}"]
