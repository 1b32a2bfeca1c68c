"""Columns of numbers from CSV files."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path

from .errors import in_file
from .text import finite_number, shown

__all__ = ["read_columns", "read_header"]


def read_header(what: str, path: Path) -> list[str]:
    """Return the names in the first row of a CSV file, none for an empty file. Parameters as in `read_columns`."""
    rows = _read_rows(what, path)
    return rows[0][1] if rows else []


def read_columns(what: str, path: Path, names: Sequence[str], maybe: Sequence[str] = ()) -> dict[str, list[float]]:
    """Return columns of numbers of a CSV file.

    Parameters
    ----------
    what : str
        Kind of content that the file should have, for messages.
    path : Path
        File in UTF-8 with a row of names, then rows of the same length, separated by commas.
    names, maybe : sequence of str
        Required columns, and optional columns. Other columns are skipped.

    Raises
    ------
    ValueError
        If the file cannot be read, a column is missing or occurs twice, rows differ in length, or a cell is not a
        finite number.
    """
    (_, header), *rows = _read_rows(what, path) or [(1, [])]
    wanted = ", ".join(names) + (f" and optionally {', '.join(maybe)}" if maybe else "")
    needs = f"{what} {path}: must have numbers in the columns {wanted}"
    found = [*names, *(name for name in maybe if name in header)]
    for name in found:
        if header.count(name) != 1:
            raise ValueError(f"{needs} (column {name} occurs {header.count(name)} times)")
    for line, cells in rows:
        if len(cells) != len(header):
            raise ValueError(f"{needs} (line {line} must have {len(header)} cells like the header, got {len(cells)})")
    return {name: [_number(cells[header.index(name)], name, line, needs) for line, cells in rows] for name in found}


def _read_rows(what: str, path: Path) -> list[tuple[int, list[str]]]:
    """Return the rows that are not empty, each with its line number."""
    try:
        with path.open(newline="", encoding="utf-8-sig") as file:
            reader = csv.reader(file, skipinitialspace=True)
            rows = [(reader.line_num, [cell.strip() for cell in row]) for row in reader]
    except OSError as error:
        raise ValueError(f"{what} {path}: {error.strerror}") from None
    except (ValueError, csv.Error) as error:  # UnicodeDecodeError, and names with a NUL character, are ValueErrors
        raise in_file(error, f"{what} {path}") from None
    return [(line, cells) for line, cells in rows if any(cells)]


def _number(cell: str, name: str, line: int, needs: str) -> float:
    number = finite_number(cell)
    if number is None:
        raise ValueError(f"{needs} (line {line}: {name} must be a finite number, got {shown(cell)})")
    return number
