"""Rows of docs/published-results.toml: published number, number computed by the library, and allowed difference."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

TABLE = Path(__file__).parents[2] / "docs" / "published-results.toml"


@dataclass(frozen=True)
class Row:
    """A published number and the number computed by the library.

    Attributes
    ----------
    what : str
        Description with the unit.
    theirs, ours : str
        The published number as printed, and the library's number with the digits of the page.
    within : float
        Largest difference [-], relative to theirs; the page gives the reason for its size.
    test : str
        Test of the row, as `file::test` below tests/python.
    """

    what: str
    theirs: str
    ours: str
    within: float
    test: str

    def judge(self, found: float) -> None:
        """Compare a number with both; with `ours` to one unit of the last digit, since processors round differently."""
        digits = len(self.ours.partition(".")[2])
        assert found == pytest.approx(float(self.ours), rel=0.0, abs=1.01 * 10.0**-digits), self.what
        assert found == pytest.approx(float(self.theirs), rel=self.within, abs=0.0), self.what


def benchmarks() -> dict[str, list[Row]]:
    """Return the rows of all benchmarks."""
    tables = tomllib.loads(TABLE.read_text(encoding="utf-8"))
    return {name: [Row(**row) for row in table["row"]] for name, table in tables.items()}


def judge(test: str, found: Mapping[str, float]) -> None:
    """Compare named numbers with exactly the rows that name a test."""
    rows = {row.what: row for table in benchmarks().values() for row in table if row.test == test}
    assert rows.keys() == found.keys()
    for what, value in found.items():
        rows[what].judge(value)
