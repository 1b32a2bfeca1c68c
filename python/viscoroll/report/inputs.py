"""Inputs of a case file, as typed and in SI units."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from .._support.tables import few_texts, unit_text
from .._support.text import key_path_text
from ..case.case import CaseFile
from ..case.tables import skipped
from ..case.unit_texts import FileKeys, Key

__all__ = ["Input", "InputTable", "input_tables"]


@dataclass(frozen=True, slots=True)
class Input:
    """A key of a file with its value as typed, and in SI units if it is a number."""

    key: str
    typed: str
    si: str


@dataclass(frozen=True, slots=True)
class InputTable:
    """A table of a file; the title is its path."""

    title: str
    rows: tuple[Input, ...]


def input_tables(document: Mapping[str, Any]) -> list[InputTable]:
    """Return the tables of a case file in their order, without those for other commands and without empty ones.

    Parameters
    ----------
    document : mapping
        Content of a valid case file.
    """
    keys = CaseFile.keys_of(document)
    others = skipped(CaseFile, document)
    own = {name: value for name, value in document.items() if name not in others}
    return [table for table in _tables(keys, document, own, ()) if table.rows]


def _tables(
    keys: FileKeys, document: Mapping[str, Any], table: Mapping[str, Any], path: tuple[str | int, ...]
) -> Iterator[InputTable]:
    nested = {name: value for name, value in table.items() if _holds_tables(value)}
    rows = [
        # The entries of a list have the unit of its key.
        _input(name, value, keys.at(document, (*path, name, 0) if isinstance(value, list) else (*path, name)))
        for name, value in table.items()
        if name not in nested
    ]
    yield InputTable(key_path_text(path) or "file", tuple(rows))
    for name, value in nested.items():
        if isinstance(value, dict):
            yield from _tables(keys, document, value, (*path, name))
            continue
        for index, entry in enumerate(value):
            yield from _tables(keys, document, entry, (*path, name, index))


def _holds_tables(value: object) -> bool:
    return isinstance(value, dict) or (isinstance(value, list) and any(isinstance(one, dict) for one in value))


def _input(name: str, value: Any, key: Key | None) -> Input:
    return Input(name.replace("_", " "), _typed(value), "" if key is None else _in_si(name, value, key))


def _typed(value: Any) -> str:
    """Return a value as the file gives it, without quotation marks; of a long list, some of its entries."""
    if isinstance(value, list):
        return few_texts([_typed(one) for one in value])
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def _in_si(name: str, value: Any, key: Key) -> str:
    """Return numbers in SI units; an empty text for values without a unit, and for names of members."""
    values = value if isinstance(value, list) else [value]
    if key.unit == "1" and not any(isinstance(one, str) for one in values):
        return ""
    try:
        numbers = [_number(name, one, key) for one in values]
    except ValueError:
        return ""  # a text that this key takes in place of a number
    return f"{few_texts([f'{number:.9g}' for number in numbers])} {unit_text(key.unit)}".rstrip()


def _number(name: str, value: Any, key: Key) -> float:
    return key.number(value, name) if isinstance(value, str) else float(value)
