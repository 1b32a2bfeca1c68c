"""Small HTML tables with units, for notebooks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from html import escape
from typing import Any

from .text import shown
from .units import UNITS, suitable_unit

__all__ = ["ParameterTable", "few_texts", "handy", "html_table", "number_text", "unit_text"]

#: Number of entries that are displayed at the beginning of a long sequence, in addition to the last entry.
_SHOWN = 4

#: HTML attribute for text cells: by default, notebooks align them to the right.
_LEFT = ' style="text-align: left"'


def html_table(title: str, rows: Iterable[Sequence[str]], *, head: Sequence[str] = ()) -> str:
    """Return a table in HTML; all texts are escaped.

    Parameters
    ----------
    title : str
        Caption above the table.
    rows : iterable of sequence of str
        Texts of the cells.
    head : sequence of str, optional
        Names of the columns.
    """
    above = f"<thead><tr>{''.join(f'<th{_LEFT}>{escape(text)}</th>' for text in head)}</tr></thead>" if head else ""
    return _framed(title, above + "".join(_row([escape(text) for text in row]) for row in rows))


def number_text(value: object) -> str:
    """Return a number with six digits, or "undetermined" for None."""
    return "undetermined" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)


def few_texts(texts: Sequence[str]) -> str:
    """Return texts in a row; of many, some of them and their number."""
    if len(texts) <= _SHOWN + 1:
        return ", ".join(texts) or "none"
    return f"{', '.join(texts[:_SHOWN])}, …, {texts[-1]} ({len(texts)})"


def unit_text(unit: str) -> str:
    """Return a unit as text; empty for a dimensionless quantity."""
    return "" if unit == "1" else unit


def handy(values: Sequence[float | None], unit: str) -> tuple[list[str], str]:
    """Return numbers with five digits, and their common unit with the prefix that suits the largest number.

    Examples
    --------
    >>> handy([8.461538e6], "Pa")
    (['8.4615'], 'MPa')
    >>> handy([2.27419e-5, None], "m^2")
    (['22.742', 'undetermined'], 'mm²')
    """
    name, scale = suitable_unit(max((abs(value) for value in values if value is not None), default=0.0), unit)
    return ["undetermined" if value is None else f"{value / scale:.5g}" for value in values], name


class ParameterTable:
    """Base of inputs whose parameters a notebook displays as a table, with nested tables for nested inputs."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        """Return a table of the parameters with units, as HTML."""
        rows = [_row([escape(name.replace("_", " ")), *_cells(name, value)]) for name, value in _given(self)]
        return _framed(type(self).__name__, "".join(rows))


def _given(holder: Any) -> list[tuple[str, Any]]:
    """Return names and values of the parameters that are not None, and the outer radius if there is one."""
    pairs = [(field.name, getattr(holder, field.name)) for field in fields(holder)]
    if hasattr(holder, "outer_radius"):
        pairs.append(("outer_radius", holder.outer_radius))
    return [(name, value) for name, value in pairs if value is not None]


def _cells(name: str, value: Any) -> tuple[str, str]:
    """Return value and unit of a parameter, as HTML."""
    unit = escape(unit_text(UNITS.get(name, "1")))
    match value:
        case ParameterTable():
            return value._repr_html_(), ""
        case Enum():
            return escape(value.name), ""
        case float() | int():
            return number_text(value), unit
        case tuple() if value and all(isinstance(entry, ParameterTable) for entry in value):
            return "".join(entry._repr_html_() for entry in value), ""
        case tuple() if all(isinstance(entry, float) for entry in value):
            return few_texts([*map(number_text, value)]), unit
        case _:
            return escape(f"{value}" if is_dataclass(value) else shown(value)), ""


def _row(cells: Sequence[str]) -> str:
    return f"<tr>{''.join(f'<td{_LEFT}>{cell}</td>' for cell in cells)}</tr>"


def _framed(title: str, rows: str) -> str:
    return f"<table><caption{_LEFT}>{escape(title)}</caption>{rows}</table>"
