"""Generate the tables of the documentation from tests, benchmarks, the README and the library.

`make tables` writes each table into its page, between two comments with its name, so that the tables also appear where
a host of repositories displays the sources. `test_site.py` checks that they are up to date.
"""

from __future__ import annotations

import csv
import re
import tomllib
from collections.abc import Iterable, Sequence
from pathlib import Path

from viscoroll._support.units import unit_in_contact
from viscoroll.solution.scalars import SCALARS

DOCS = Path(__file__).parent
ROOT = DOCS.parent

_PLACE = re.compile(r"(<!-- (?P<name>\w+): made by docs/tables.py -->\n).*?(?=<!-- end of (?P=name) -->)", re.DOTALL)


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def validation_table(path: Path) -> str:
    """Return the table of validation: quantity, reference, deviation and tests."""
    rows = tomllib.loads(path.read_text(encoding="utf-8"))["row"]
    return table(
        ("what is compared", "reference", "deviation", "test"),
        [
            (row["what"], row["against"], row["found"], "<br>".join(f"`{test}`" for test in row["tests"]))
            for row in rows
        ],
    )


def published_tables(path: Path) -> dict[str, str]:
    """Return a table for each published benchmark: published number, number of viscoroll, difference, test."""

    def difference(row: dict[str, str]) -> str:
        return f"{100.0 * (float(row['ours']) / float(row['theirs']) - 1.0):+.2f} %"

    return {
        name: table(
            ("quantity", "published", "viscoroll", "difference", "test"),
            [
                (row["what"], row["theirs"], row["ours"], difference(row), f"`{row['test']}`")
                for row in benchmark["row"]
            ],
        )
        for name, benchmark in tomllib.loads(path.read_text(encoding="utf-8")).items()
    }


def benchmark_table(path: Path) -> str:
    """Return the table of the latest run of every benchmark."""
    with path.open(encoding="utf-8", newline="") as file:
        latest = {row["case"]: row for row in csv.DictReader(file)}
    return table(
        ("case", "median [s]", "from .. to [s]", "clock", "threads", "error", "memory [MB]", "day, commit, processor"),
        [
            (
                f"`{case}`",
                row["median_s"],
                f"{row['min_s']} .. {row['max_s']}",
                row["clock"],
                row["threads"],
                row["error"],
                row["peak_mb"],
                f"{row['date']}, {row['commit']}, {row['cpu']}",
            )
            for case, row in sorted(latest.items())
        ],
    )


def scalar_table() -> str:
    """Return the table of all scalar results with their units."""
    return table(
        ("name", "unit", "unit (roller)", "description"),
        [
            (f"`{name}`", shown(unit), shown(unit_in_contact(unit, line_contact=True)), label)
            for name, (unit, label) in SCALARS.items()
        ],
    )


def shown(unit: str) -> str:
    """Return a unit as displayed in tables, `-` for a dimensionless number."""
    return "-" if unit == "1" else unit.replace("^2", "²")


def of_the_readme(name: str) -> str:
    """Return the text of the README between the two comments with a name."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return text.split(f"<!-- {name} -->\n")[1].split(f"<!-- end of {name} -->")[0]


def parts() -> dict[str, str]:
    """Return all generated texts, by the names that the pages use."""
    return {
        "validation": validation_table(DOCS / "validation.toml"),
        "benchmarks": benchmark_table(ROOT / "bench" / "results.csv"),
        "scalars": scalar_table(),
        "covered": of_the_readme("covered"),
        "signs": of_the_readme("signs"),
        "verdicts": (DOCS / "recorded" / "verdicts.md").read_text(encoding="utf-8"),
        **{f"published_{name}": text for name, text in published_tables(DOCS / "published-results.toml").items()},
    }


def pages() -> dict[Path, str]:
    """Return the up-to-date text of each page that contains generated texts."""
    made = parts()
    texts = {path: path.read_text(encoding="utf-8") for path in sorted(DOCS.glob("*.md"))}
    return {
        path: _PLACE.sub(lambda place: f"{place[1]}\n{made[place['name']].strip()}\n\n", text)
        for path, text in texts.items()
        if _PLACE.search(text)
    }


if __name__ == "__main__":
    for page, text in pages().items():
        page.write_text(text, encoding="utf-8")
