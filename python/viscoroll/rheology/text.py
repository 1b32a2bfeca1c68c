"""Tables in the text files of rheometers and DMA instruments.

A table is a row of names with a frequency or strain and a modulus, a row of units unless they are beside the names, and
rows of numbers. All other text before, between and after tables (headers of TRIOS, intervals of RheoCompass) is
skipped, and so are labels in the first column ("Data point", point numbers).
"""

from __future__ import annotations

import codecs
import csv
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .._support.text import finite_number
from .names import Column, is_unit, normalized, parse_header, role_of

__all__ = ["Table", "find_tables", "read_text"]

_SEPARATORS = ("\t", ";", ",")

#: Largest relative difference of two columns of the same frequency: half of a unit in the third printed digit.
_SAME_FREQUENCY = 0.01


@dataclass(slots=True)
class Table:
    """Table of a file: columns by role, swept quantity, rows of numbers, number of unreadable rows, and a remark.

    `unknown` contains the names of columns without a known role.
    """

    columns: dict[str, Column]
    over: str = "frequency"
    unknown: tuple[str, ...] = ()
    rows: list[dict[str, float]] = field(default_factory=list)
    unreadable: int = 0
    remark: str = ""


def read_text(path: Path) -> str:
    """Return the text of a file encoded in UTF-8, UTF-16 or the Western Windows code page."""
    content = path.read_bytes()
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return content.decode("utf-16", errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


def find_tables(text: str, names: Mapping[str, tuple[str, str | None]], *, over: str = "frequency") -> list[Table]:
    """Return the tables of a text.

    Parameters
    ----------
    text : str
        Content of a file.
    names : mapping of str to (str, str or None)
        Column names that the caller specifies, by role, with the unit or None for the unit in the file.
    over : {"frequency", "strain", "temperature"}
        Swept quantity. Columns of strain are used in strain sweeps only.

    Raises
    ------
    ValueError
        If two columns of a table have the same role, except for frequencies in rad/s and Hz that agree.
    """
    tables: list[Table] = []
    separator = ","
    waiting_for_units = False
    for line in text.splitlines():
        if not line.strip():
            continue
        if header := _header(line, names, over):
            separator, columns, unknown = header
            tables.append(Table(columns, over, unknown))
            waiting_for_units = True
        elif tables:
            cells = _cells(line, separator)
            if waiting_for_units and _is_unit_row(cells):
                tables[-1].columns = _with_units(tables[-1].columns, cells, names)
                waiting_for_units = False
            else:
                waiting_for_units = not _add_row(tables[-1], cells, separator) and waiting_for_units
    filled = [table for table in tables if table.rows]
    for table in filled:
        _settle_frequency(table)
    return filled


def _settle_frequency(table: Table) -> None:
    """Keep one of two frequency columns that agree, as TRIOS writes them.

    Raises
    ------
    ValueError
        If the columns disagree.
    """
    second = table.columns.pop("second_frequency", None)
    if second is None:
        return
    both = [table.columns["frequency"], second]
    kept, other = sorted(both, key=lambda column: (not column.has_unit, not column.is_angular))
    table.remark = f"frequency from {kept.name!r}, because {other.name!r} has no unit"
    if other.has_unit:
        kept_values, other_values = (
            column.converted([row[column.role] for row in table.rows], "frequencies") for column in (kept, other)
        )
        apart = np.abs(other_values / np.where(kept_values == 0.0, np.nan, kept_values) - 1.0)
        worst = int(np.argmax(np.nan_to_num(apart)))
        if apart[worst] > _SAME_FREQUENCY:
            row = table.rows[worst]
            told = " and ".join(f"{row[column.role]:g} {column.unit}" for column in (kept, other))
            raise ValueError(
                f"columns {kept.name!r} and {other.name!r} must agree (1 Hz is 2 pi rad/s), got {told} in one row; "
                'select one by columns={"frequency": name}, in the shell --columns frequency=name:unit'
            )
        table.remark = f"frequency from {kept.name!r}, with which {other.name!r} agrees"
    for row in table.rows:
        row["frequency"] = row[kept.role]
    table.columns["frequency"] = Column(kept.index, kept.name, kept.unit, "frequency")


def _header(
    line: str, names: Mapping[str, tuple[str, str | None]], over: str
) -> tuple[str, dict[str, Column], tuple[str, ...]] | None:
    """Return separator, columns and unknown names of a row of names, or None for any other row."""
    for separator in _SEPARATORS:
        cells = _cells(line, separator)
        columns = _columns(cells, names, over)
        wanted = set(names) | {over} | ({"storage"} if "storage" not in names else set())
        if len(cells) > 2 and wanted <= columns.keys():
            taken = {column.index for column in columns.values()}
            return separator, columns, tuple(cell for i, cell in enumerate(cells) if cell and i not in taken)
    return None


def _columns(cells: list[str], names: Mapping[str, tuple[str, str | None]], over: str) -> dict[str, Column]:
    given = {normalized(name): role for role, (name, _) in names.items()}
    columns: dict[str, Column] = {}
    for index, cell in enumerate(cells):
        name, unit = parse_header(cell)
        role = given.get(normalized(cell)) or given.get(normalized(name)) or role_of(name)
        if role is None or (role == "strain" and over != "strain"):
            continue
        if role in names and normalized(name) not in given and normalized(cell) not in given:
            continue
        if role == "frequency" and role in columns and role not in names and "second_frequency" not in columns:
            role = "second_frequency"
        if role in columns:
            raise ValueError(
                f"two columns contain {role}, {columns[role].name!r} and {name!r}: select one by "
                f'columns={{"{role}": name}}'
            )
        if role in names:
            unit = names[role][1] or unit
        columns[role] = Column(index, name, unit, role)
    return columns


def _cells(line: str, separator: str) -> list[str]:
    if separator == "\t":  # exports with tabs contain E'' and G" without quotes
        return [cell.strip() for cell in line.split(separator)]
    try:
        return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True))]
    except csv.Error:  # not a text line
        return []


def _is_unit_row(cells: list[str]) -> bool:
    return any(is_unit(cell) for cell in cells) and all(
        math.isnan(_number(cell, "\t")) or cell == "1" for cell in cells
    )


def _with_units(
    columns: dict[str, Column], cells: list[str], names: Mapping[str, tuple[str, str | None]]
) -> dict[str, Column]:
    found = {}
    for role, column in columns.items():
        unit = cells[column.index].strip("[]") if column.index < len(cells) else ""
        given = names[role][1] if role in names else None
        if role == "temperature" and unit.lower() in ("s", "min", "h"):
            continue  # the column "t" is time
        found[role] = Column(column.index, column.name, given or column.unit or unit, role)
    return found


def _add_row(table: Table, cells: list[str], separator: str) -> bool:
    """Add a row of numbers to a table, or count a row with missing numbers; return whether it was one of these."""
    needed = [column for role, column in table.columns.items() if role not in ("sweep", "second_frequency")]
    numbers = {
        column.role: _number(cells[column.index], separator) if column.index < len(cells) else math.nan
        for column in table.columns.values()
    }
    readable = [not math.isnan(numbers[column.role]) for column in needed]
    if all(readable):
        table.rows.append(numbers)
    elif any(readable) and not math.isnan(numbers[table.over]):
        table.unreadable += 1
    else:
        return False
    return True


def _number(cell: str, separator: str) -> float:
    text = cell.strip()
    if separator != "," and re.fullmatch(r"[-+]?\d*,\d+([eE][-+]?\d+)?", text):
        text = text.replace(",", ".")
    number = finite_number(text)
    return math.nan if number is None else number
