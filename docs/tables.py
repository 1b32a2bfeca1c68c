"""Tables of the pages that are written nowhere by hand: each is made of what tests, benchmarks or the library know.

`make tables` writes them into the pages, between comments with their names, so that whoever reads the sources on a host
of repositories sees them, too; `test_site.py` sees to it that they are as they would be made.
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
    """Return what is held against what, how far the two are apart, and the tests that say so."""
    rows = tomllib.loads(path.read_text(encoding="utf-8"))["row"]
    return table(
        ("what", "against", "found", "test"),
        [
            (row["what"], row["against"], row["found"], "<br>".join(f"`{test}`" for test in row["tests"]))
            for row in rows
        ],
    )


def outside_tables(path: Path) -> dict[str, str]:
    """Return a table for each benchmark of others: their number, ours, the difference, and the test that holds both."""

    def difference(row: dict[str, str]) -> str:
        return f"{100.0 * (float(row['ours']) / float(row['theirs']) - 1.0):+.2f} %"

    return {
        name: table(
            ("what", "theirs", "ours", "difference", "test"),
            [
                (row["what"], row["theirs"], row["ours"], difference(row), f"`{row['test']}`")
                for row in benchmark["row"]
            ],
        )
        for name, benchmark in tomllib.loads(path.read_text(encoding="utf-8")).items()
    }


def benchmark_table(path: Path) -> str:
    """Return the latest run of every benchmark."""
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
    """Return all scalar results with their units."""
    return table(
        ("name", "unit", "of a roller", "what"),
        [
            (f"`{name}`", shown(unit), shown(unit_in_contact(unit, line_contact=True)), label)
            for name, (unit, label) in SCALARS.items()
        ],
    )


def shown(unit: str) -> str:
    """Return a unit for people: a number has none."""
    return "-" if unit == "1" else unit.replace("^2", "²")


def of_the_readme(name: str) -> str:
    """Return what stands in the README between comments with a name."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return text.split(f"<!-- {name} -->\n")[1].split(f"<!-- end of {name} -->")[0]


def parts() -> dict[str, str]:
    """Return all that is made, by the names that pages call it."""
    return {
        "validation": validation_table(DOCS / "validation.toml"),
        "benchmarks": benchmark_table(ROOT / "bench" / "results.csv"),
        "scalars": scalar_table(),
        "covered": of_the_readme("covered"),
        "signs": of_the_readme("signs"),
        "verdicts": (DOCS / "recorded" / "verdicts.md").read_text(encoding="utf-8"),
        **{f"outside_{name}": text for name, text in outside_tables(DOCS / "judged-from-outside.toml").items()},
    }


def pages() -> dict[Path, str]:
    """Return the text of each page that holds some of it, as it should be."""
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
