"""What the documentation says of tests, files and tables is there: the site itself is checked where it is built."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
ROWS = tomllib.loads((ROOT / "docs" / "validation.toml").read_text(encoding="utf-8"))["row"]
OUTSIDE = tomllib.loads((ROOT / "docs" / "judged-from-outside.toml").read_text(encoding="utf-8"))
TESTS = {test for row in ROWS for test in row["tests"]} | {
    row["test"] for part in OUTSIDE.values() for row in part["row"]
}
README = (ROOT / "README.md").read_text(encoding="utf-8")
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def declaration(test: str) -> tuple[Path, str]:
    """Return the file of a test, and how its declaration is written there."""
    file, name = test.split("::")
    if file.endswith(".cpp"):
        suite, case = name.split(".")
        return ROOT / "tests" / "cpp" / file, rf"^TEST(_P|_F)?\({suite}, {case}\)"
    return ROOT / "tests" / "python" / file, rf"^def {name}\("


@pytest.mark.parametrize("test", sorted(TESTS))
def test_what_is_said_to_be_tested_is(test):
    path, pattern = declaration(test)
    assert re.search(pattern, path.read_text(encoding="utf-8"), re.MULTILINE)


def test_rows_of_the_readme_are_rows_of_the_table():
    section = README.split("## How right is it?")[1].split("\n## ")[0]
    rows = re.findall(r"^\| (?!what|---)(.*) \| (.*) \| (.*) \|$", section, re.MULTILINE)
    assert len(rows) == 6
    assert set(rows) <= {(row["what"], row["against"], row["found"]) for row in ROWS}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_between_files_lead_somewhere(page):
    """As on the pages of a host of repositories, where the sources are read as they are."""
    targets = re.findall(r"\]\((?!https?:|#)([^)#\s]+)", page.read_text(encoding="utf-8"))
    built = ("api/generated/", "_generated/")
    missing = [t for t in targets if not t.startswith(built) and not (page.parent / t).exists()]
    assert missing == []
