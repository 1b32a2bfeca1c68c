"""The rows of docs/judged-from-outside.toml: their number, ours, and how far apart the two may be."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

TABLE = Path(__file__).parents[2] / "docs" / "judged-from-outside.toml"


@dataclass(frozen=True)
class Row:
    """A number that others printed, beside ours.

    Attributes
    ----------
    what : str
        With its unit.
    theirs, ours : str
        As printed, and with as many digits as the page shows.
    within : float
        Largest difference [-], relative to theirs; the page says why it is no smaller.
    test : str
        What holds it, as `file::test` below tests/python.
    """

    what: str
    theirs: str
    ours: str
    within: float
    test: str

    def judge(self, found: float) -> None:
        """Hold a number against both: ours to one unit of its last digit, as other processors round otherwise."""
        digits = len(self.ours.partition(".")[2])
        assert found == pytest.approx(float(self.ours), rel=0.0, abs=1.01 * 10.0**-digits), self.what
        assert found == pytest.approx(float(self.theirs), rel=self.within, abs=0.0), self.what


def benchmarks() -> dict[str, list[Row]]:
    """Return the rows of all benchmarks."""
    tables = tomllib.loads(TABLE.read_text(encoding="utf-8"))
    return {name: [Row(**row) for row in table["row"]] for name, table in tables.items()}


def judge(test: str, found: Mapping[str, float]) -> None:
    """Hold numbers, by what they are, against all rows that name a test, and no others."""
    rows = {row.what: row for table in benchmarks().values() for row in table if row.test == test}
    assert rows.keys() == found.keys()
    for what, value in found.items():
        rows[what].judge(value)
