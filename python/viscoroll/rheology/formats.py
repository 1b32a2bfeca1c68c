"""Text of the files that instruments write: text files, Excel workbooks, and JSON of TRIOS.

Workbooks and JSON are converted to the text that an instrument would write with tabs, so that one parser reads all of
them. A sheet or a step becomes a section of the text with its name as the title.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from itertools import groupby
from pathlib import Path
from typing import Any

from .._support.encodings import OLE, UNKNOWN, ZIP, binary_format, decoded_utf16
from .._support.extras import extra
from .names import parse_header, role_of

__all__ = ["read_text"]

#: Projects that only the program of an instrument reads, by the ending of the file name.
_PROJECTS = {
    ".tri": "a TRIOS file",
    ".rwd": "a RheoWin file",
    ".rwj": "a RheoWin job",
    ".rslt": "a RheoCompass file",
    ".ngb-dm8": "a Proteus file",
}


def read_text(path: Path) -> str:
    """Return the content of a file as text.

    Text files may be encoded in UTF-8, UTF-16, or the Western or the Japanese Windows code page. Excel workbooks
    (.xlsx, .xlsm, .xlsb, .xls, .ods) and TRIOS JSON are converted to text.

    Raises
    ------
    ValueError
        If the file contains no text and is neither a workbook nor TRIOS JSON; the message names its format.
    ImportError
        If the file is a workbook and the extra `viscoroll[excel]` is missing.
    """
    content = path.read_bytes()
    if content.startswith((ZIP, OLE)) and (text := _workbook(path, content)) is not None:
        return text
    _require_text(path, content)
    text = _decoded(content)
    return _from_trios_json(path, text) if text.lstrip().startswith("{") else text


def _decoded(content: bytes) -> str:
    if (text := decoded_utf16(content)) is not None:
        return text
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        pass
    try:
        japanese = content.decode("cp932")
    except UnicodeDecodeError:
        japanese = ""
    names = (parse_header(cell)[0] for cell in re.split(r"[\t;,\r\n]", japanese))
    if any(role_of(name) and not name.isascii() for name in names):
        return japanese
    return content.decode("cp1252", errors="replace")


def _require_text(path: Path, content: bytes) -> None:
    """Raise a ValueError that names the format of a file without text."""
    found = binary_format(content)
    if found is None:
        return
    if found == UNKNOWN:
        found = _PROJECTS.get(path.suffix.lower(), found)
    raise ValueError(f"{path}: must be a text or CSV file, an Excel workbook or TRIOS JSON, got {found}")


def _workbook(path: Path, content: bytes) -> str | None:
    """Return the sheets of an Excel workbook as text, or None if the file is no workbook."""
    is_named = path.suffix.lower() in (".xlsx", ".xlsm", ".xlsb", ".xls", ".ods")
    is_marked = any(name in content for name in (b"xl/workbook", b"W\x00o\x00r\x00k\x00b\x00o\x00o\x00k\x00"))
    if not is_named and not is_marked:
        return None
    with extra("excel"):
        from python_calamine import CalamineError, load_workbook
    try:
        book = load_workbook(str(path))
        sheets = [(name, book.get_sheet_by_name(name).to_python()) for name in book.sheet_names]
    except CalamineError as error:
        raise ValueError(f"{path}: must be an Excel workbook, but cannot be read as one ({error})") from None
    return _joined((name, ["\t".join(map(_cell_text, row)) for row in rows]) for name, rows in sheets)


def _joined(sections: Iterable[tuple[str, list[str]]]) -> str:
    """Return sections with titles as one text, in which each begins as a step of an instrument."""
    return "\n".join(line for title, lines in sections for line in ("[step]", title, *lines))


def _cell_text(value: object) -> str:
    """Return the text of a cell: a number with all its digits, other values in one line."""
    if value is None:
        return ""
    if isinstance(value, float):
        return repr(value)
    return re.sub(r"\s+", " ", str(value)).strip()


def _from_trios_json(path: Path, text: str) -> str:
    """Return the steps of a TRIOS JSON export as text.

    Source: TA Instruments, TRIOS JSON Export Schema, https://software.tainstruments.com/schemas/TRIOSJSONExportSchema:
    ``Results`` has the data sets "Processed" and "Original" with ``ColumnHeaders`` (display name and unit by key),
    ``Rows`` (values by key) and ``ResultsSteps`` (name and identifier).
    """
    try:
        document = json.loads(text)
    except (json.JSONDecodeError, RecursionError) as error:
        raise ValueError(f"{path}: must be valid JSON, because it starts with a brace, got {error}") from None
    results = document.get("Results")
    data = next(
        (found for name in ("Processed", "Original") if isinstance(found := _member(results, name), dict)), None
    )
    headers, rows = _member(data, "ColumnHeaders"), _member(data, "Rows")
    if not isinstance(headers, dict) or not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
        raise ValueError(
            f"{path}: must have Results with ColumnHeaders and Rows, as JSON of TRIOS has, "
            f"got the members {', '.join(map(repr, document)) or 'none'}"
        )
    return _joined(_steps(document, data, headers, rows))


def _steps(document: Any, data: Any, headers: dict[str, Any], rows: list[dict[str, Any]]) -> Iterator[Any]:
    """Yield the title and the lines of each step."""
    listed = (_member(data, "ResultsSteps"), _member(_member(document, "Procedure"), "Steps"))
    steps = [step for found in listed if isinstance(found, list) for step in found if isinstance(step, dict)]
    titles = {step["Id"]: str(step.get("Name", "")) for step in steps if isinstance(step.get("Id"), str)}
    marks = {key for row in rows for key, value in row.items() if isinstance(value, str) and value in titles}
    for step, group in groupby(rows, lambda row: next((row[key] for key in marks if key in row), None)):
        members = list(group)
        keys = [key for key in headers if key not in marks and any(row.get(key) is not None for row in members)]
        names = "\t".join(_cell_text(_member(headers[key], "DisplayName") or key) for key in keys)
        units = "\t".join(_cell_text(_member(_member(headers[key], "Unit"), "Name")) for key in keys)
        lines = ["\t".join(_cell_text(_number_of(row.get(key))) for key in keys) for row in members]
        yield titles.get(step, "") if isinstance(step, str) else "", [names, units, *lines]


def _member(parent: Any, name: str) -> Any:
    return parent.get(name) if isinstance(parent, dict) else None


def _number_of(value: Any) -> Any:
    """Return the number of a quantity, which TRIOS writes as a number or as an object with a value."""
    return _member(value, "Value") if isinstance(value, dict) else value
