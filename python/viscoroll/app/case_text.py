"""Case files that the page opens."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from .._support.errors import InvalidInput
from .._support.text import key_path_text, one_line
from .._support.toml import parse_toml
from ..case import build_case
from ..case.case import CaseFile
from .answer import OTHER_TABLES, tables_of_page

__all__ = ["opened", "page_case"]


def opened(text: object) -> dict[str, Any]:
    """Return the case that the text of a case file describes.

    Parameters
    ----------
    text : str
        Content of the file. It must not refer to other files.

    Returns
    -------
    dict
        ``{"tables", "skipped"}``: tables in SI units as the page reads them, and names of the tables that the page does
        not support; or ``{"error": {"message"}}``.
    """
    try:
        if not isinstance(text, str):
            raise InvalidInput("request", "must be the text of a case file")
        tables, skipped = page_case(parse_toml(text))
    except (ValueError, TypeError, RecursionError) as error:
        return {"error": {"message": one_line(str(error))}}
    return {"tables": tables, "skipped": skipped}


def page_case(document: dict[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """Return the tables of a case file as the page reads them, and the names of tables that the page does not support.

    Raises
    ------
    ValueError, TypeError
        If the tables are not valid, contain infinite numbers, or refer to a file.
    """
    others = [name for name in OTHER_TABLES if name in document]
    pair = {name: table for name, table in document.items() if name not in others}
    tables = tables_of_page(pair)
    if "thermal" in document:
        with_thermal = pair | {"thermal": document["thermal"]}
        build_case(with_thermal, None)  # checks the table
        tables["thermal"] = CaseFile.keys_of(with_thermal).in_si(with_thermal)["thermal"]
    for path, number in _numbers(tables, ()):
        if not math.isfinite(number):
            raise InvalidInput(key_path_text(path), "must be finite on the page", f"{number}")
    return tables, [name for name in others if name != "thermal"]


def _numbers(value: object, path: tuple[str | int, ...]) -> Iterator[tuple[tuple[str | int, ...], float]]:
    """Yield the paths and values of all numbers of tables and lists."""
    if isinstance(value, dict):
        for name, one in value.items():
            yield from _numbers(one, (*path, name))
    elif isinstance(value, list):
        for i, one in enumerate(value):
            yield from _numbers(one, (*path, i))
    elif isinstance(value, float):
        yield path, value
