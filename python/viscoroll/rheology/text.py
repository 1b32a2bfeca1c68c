"""Tables in the text files of rheometers and DMA instruments.

A table is a row of names, a row of units unless they are beside the names, and rows of numbers. All other text before,
between and after tables (headers of TRIOS, intervals of RheoCompass) is skipped, and so are labels in the first column
("Data point", point numbers). The next row of names, or a line that starts a step, ends a table.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping

import numpy as np

from .._support.text import finite_number
from .names import Column, header_column, is_unit, is_unit_of, normalized, parse_header
from .tables import Table, data_sets

__all__ = ["closest_header", "find_tables"]

_SEPARATORS = ("\t", ";", ",")

#: Largest relative difference of two columns of the same frequency: half of a unit in the third printed digit.
_SAME_FREQUENCY = 0.01

#: Lines that end a table: steps of TRIOS, intervals and results of RheoCompass.
_STEP = re.compile(
    r"\s*(\[step\]|(result|test|project|interval( and data points)?|区間とデータ点数)\s*:)", re.IGNORECASE
)

#: Names of columns and units, as the caller gives them by role.
Names = Mapping[str, "tuple[str, str | None]"]


def find_tables(text: str, names: Names) -> list[Table]:
    """Return the data sets of a text, in its order.

    Parameters
    ----------
    text : str
        Content of a file.
    names : mapping of str to (str, str or None)
        Column names that the caller specifies, by role, with the unit or None for the unit in the file.

    Raises
    ------
    ValueError
        If two columns of a table have the same role, except for frequencies in rad/s and Hz that agree.
    """
    tables: list[Table] = []
    current: Table | None = None
    separator, title = ",", ""
    waiting_for_units = False
    for line in text.splitlines():
        if not line.strip():
            continue
        if _STEP.match(line) and not _header(line, names):
            current, title = None, ""
        elif header := _header(line, names):
            separator, current = header
            current.title = title
            tables.append(current)
            waiting_for_units = True
        elif current is None:
            title = _title(line)
        else:
            cells = _cells(line, separator)
            if waiting_for_units and _is_unit_row(cells):
                _add_units(current, cells, names)
                waiting_for_units = False
            elif _add_row(current, cells, separator):
                waiting_for_units = False
            elif _is_row_of_names(cells) and not _is_unit_row(cells):  # of a table in which no column is known
                current = None
    parts = [part for table in tables if table.rows for part in data_sets(table)]
    for part in parts:
        _settle_frequency(part)
    return parts


def closest_header(text: str, names: Names) -> tuple[str, ...]:
    """Return the cells of the row of names with most known columns; empty if no row has one."""
    best: tuple[str, ...] = ()
    most = 0
    for line in text.splitlines():
        for separator in _SEPARATORS:
            cells = _cells(line, separator)
            known = len(_columns(cells, names)[0])
            if known > most:
                best, most = tuple(cell for cell in cells if cell), known
    return best


def _title(line: str) -> str:
    """Return a line as the title of the table below it; empty for pairs of a name and a value."""
    text = line.strip()
    return "" if re.search(r"[\t;,:]", text) or len(text) > 60 else text


def _settle_frequency(table: Table) -> None:
    """Keep one of two frequency columns that agree, as TRIOS writes them.

    Raises
    ------
    ValueError
        If the columns disagree, or if any other role is repeated.
    """
    second = table.columns.pop("second_frequency", None)
    if second is None:
        return
    both = [table.columns["frequency"], second]
    kept, other = sorted(both, key=lambda column: (not column.has_unit, not column.is_angular))
    table.remark = f"frequency from {kept.name!r}, because {other.name!r} has no unit"
    if other.has_unit:
        rows = [row for row in table.rows if not math.isnan(row[kept.role] + row[other.role])]
        kept_values, other_values = (
            column.converted([row[column.role] for row in rows], "frequencies") for column in (kept, other)
        )
        apart = np.abs(other_values / np.where(kept_values == 0.0, np.nan, kept_values) - 1.0)
        worst = int(np.argmax(np.nan_to_num(apart)))
        if apart[worst] > _SAME_FREQUENCY:
            row = rows[worst]
            told = " and ".join(f"{row[column.role]:g} {column.unit}" for column in (kept, other))
            raise ValueError(
                f"columns {kept.name!r} and {other.name!r} must agree (1 Hz is 2 pi rad/s), got {told} in one row; "
                'select one by columns={"frequency": name}, in the shell --columns frequency=name:unit'
            )
        table.remark = f"frequency from {kept.name!r}, with which {other.name!r} agrees"
    for row in table.rows:
        row["frequency"] = row[kept.role]
    table.columns["frequency"] = Column(kept.index, kept.name, kept.unit, "frequency")


def _header(line: str, names: Names) -> tuple[str, Table] | None:
    """Return the separator and the empty table of a row of names, or None for any other row."""
    for separator in _SEPARATORS:
        cells = _cells(line, separator)
        if not _is_row_of_names(cells):
            continue
        columns, repeated = _columns(cells, names)
        if len(columns) >= 2 and set(names) <= columns.keys():
            return separator, Table(columns, tuple(cells), repeated=repeated)
    return None


def _is_row_of_names(cells: list[str]) -> bool:
    texts = [cell for cell in cells if cell]
    return len(texts) >= 2 and all(math.isnan(_number(cell, "\t")) for cell in texts)


def _columns(cells: list[str], names: Names) -> tuple[dict[str, Column], list[Column]]:
    """Return the columns by role, and those whose role another column has already."""
    given = {normalized(name): role for role, (name, _) in names.items()}
    columns: dict[str, Column] = {}
    repeated: list[Column] = []
    for index, cell in enumerate(cells):
        name, unit = parse_header(cell)
        wanted = given.get(normalized(cell)) or given.get(normalized(name))
        column = header_column(index, cell, wanted)
        if column is None or (column.role in names and not wanted):
            continue
        role = column.role
        if wanted:
            column = Column(index, name, names[role][1] or unit, role, column.frequency)
        if role not in columns:
            columns[role] = column
        elif role == "frequency" and "second_frequency" not in columns:
            columns["second_frequency"] = Column(index, column.name, column.unit, "second_frequency")
        else:
            repeated.append(column)
    return columns, repeated


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


def _add_units(table: Table, cells: list[str], names: Names) -> None:
    """Give the columns of a table the units of the row below its names."""

    def with_unit(column: Column) -> Column:
        unit = cells[column.index].strip("[]") if column.index < len(cells) else ""
        given = names[column.role][1] if column.role in names else None
        role = column.role
        if role == "temperature" and normalized(column.name) == "t" and is_unit_of("time", unit):
            role = "time"
        return Column(column.index, column.name, given or column.unit or unit, role, column.frequency)

    columns = [with_unit(column) for column in [*table.columns.values(), *table.repeated]]
    table.columns, table.repeated = {}, []
    for column in columns:
        if table.columns.setdefault(column.role, column) is not column:
            table.repeated.append(column)


def _add_row(table: Table, cells: list[str], separator: str) -> bool:
    """Add a row of numbers to a table; return whether it contains one in a known column."""
    everything = [*table.columns.values(), *table.repeated]
    numbers = {
        column.index: _number(cells[column.index], separator) if column.index < len(cells) else math.nan
        for column in everything
    }
    if all(map(math.isnan, numbers.values())):
        return False
    row = {role: numbers[column.index] for role, column in table.columns.items()}
    if table.repeated:
        row |= {f"column {index}": number for index, number in numbers.items()}
    table.rows.append(row)
    return True


def _number(cell: str, separator: str) -> float:
    text = cell.strip()
    if separator != "," and re.fullmatch(r"[-+]?\d*,\d+([eE][-+]?\d+)?", text):
        text = text.replace(",", ".")
    number = finite_number(text)
    return math.nan if number is None else number
