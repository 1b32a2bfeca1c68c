"""BibTeX entries from CITATION.cff, the only place that states how to cite viscoroll."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path
from typing import Any

__all__ = ["bibtex"]

#: CITATION.cff of the installed package, and of its sources.
_PATHS = (Path(__file__).parents[1] / "CITATION.cff", Path(__file__).parents[3] / "CITATION.cff")

#: Fields of BibTeX, by the keys of references in the Citation File Format.
_FIELDS = {"journal": "journal", "year": "year", "volume": "volume", "issue": "number", "doi": "doi", "url": "url"}


def bibtex() -> str:
    """Return the BibTeX entries of viscoroll and of the references in CITATION.cff.

    Raises
    ------
    FileNotFoundError
        If the package was installed without CITATION.cff.
    """
    path = next((path for path in _PATHS if path.is_file()), _PATHS[0])
    cited = _read(path.read_text(encoding="utf-8"))
    return "\n".join(_entry(one) for one in (cited, *cited.get("references", [])))


def _entry(cited: dict[str, Any]) -> str:
    authors = [_author(author) for author in cited["authors"]]
    fields = {"author": " and ".join(authors), "title": f"{{{cited['title']}}}"}
    fields |= {field: cited[key] for key, field in _FIELDS.items() if key in cited}
    if "start" in cited:
        fields["pages"] = f"{cited['start']}--{cited['end']}" if "end" in cited else cited["start"]
    if cited["type"] == "software":
        fields["version"] = cited["version"]
    names = [_plain(author.get("family-names", author.get("name", ""))) for author in cited["authors"]]
    key = "viscoroll" if cited["type"] == "software" else "_".join([*names, *filter(None, [cited.get("year")])]).lower()
    # An article of BibTeX requires its journal.
    kind = "misc" if cited["type"] == "article" and "journal" not in cited else cited["type"]
    lines = [f"  {name:<7} = {{{value}}}" for name, value in fields.items()]
    return f"@{kind}{{{key},\n" + ",\n".join(lines) + "\n}\n"


def _author(author: dict[str, str]) -> str:
    if "name" in author:
        return f"{{{author['name']}}}"  # braces: the name of a group is not split
    return f"{author['family-names']}, {author['given-names']}"


def _plain(name: str) -> str:
    """Return the letters of a name without accents."""
    return re.sub(r"[^A-Za-z]", "", unicodedata.normalize("NFKD", name))


def _read(text: str) -> dict[str, Any]:
    """Return the content of a file in the subset of YAML that CITATION.cff uses: texts, lists and tables."""
    rows = [row for row in text.splitlines() if row.strip() and not row.lstrip().startswith("#")]
    found: dict[str, Any] = _table(rows, 0)[0]
    return found


def _table(rows: list[str], indent: int) -> tuple[dict[str, Any], list[str]]:
    """Return the table at the beginning of some rows, and the remaining rows."""
    found: dict[str, Any] = {}
    while rows and _indent(rows[0]) == indent and not rows[0].lstrip().startswith("- "):
        key, _, value = rows.pop(0).strip().partition(":")
        if value.strip():
            found[key] = value.strip().strip('"')
        else:
            found[key], rows = _list(rows, _indent(rows[0]))
    return found, rows


def _list(rows: list[str], indent: int) -> tuple[list[dict[str, Any]], list[str]]:
    """Return the list of tables at the beginning of some rows, and the remaining rows."""
    found = []
    while rows and _indent(rows[0]) == indent and rows[0].lstrip().startswith("- "):
        entry, rows = _table([rows[0].replace("- ", "  ", 1), *rows[1:]], indent + 2)
        found.append(entry)
    return found, rows


def _indent(row: str) -> int:
    return len(row) - len(row.lstrip())
