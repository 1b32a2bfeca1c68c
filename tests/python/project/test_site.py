"""The tests, files and tables that the documentation mentions exist; the site itself is checked where it is built."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import tomllib
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[3]
ROWS = tomllib.loads((ROOT / "docs" / "validation.toml").read_text(encoding="utf-8"))["row"]
OUTSIDE = tomllib.loads((ROOT / "docs" / "published-results.toml").read_text(encoding="utf-8"))
TESTS = {test for row in ROWS for test in row["tests"]} | {
    row["test"] for part in OUTSIDE.values() for row in part["row"]
}
README = (ROOT / "README.md").read_text(encoding="utf-8")
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def declaration(test: str) -> tuple[Path, str]:
    """Return the file of a test, and the pattern of its declaration."""
    file, name = test.split("::")
    if file.endswith(".cpp"):
        suite, case = name.split(".")
        return ROOT / "tests" / "cpp" / file, rf"^TEST(_P|_F)?\({suite}, {case}\)"
    return ROOT / "tests" / "python" / file, rf"^def {name}\("


@pytest.mark.parametrize("test", sorted(TESTS))
def test_every_cited_test_exists(test):
    path, pattern = declaration(test)
    assert re.search(pattern, path.read_text(encoding="utf-8"), re.MULTILINE)


def test_rows_of_the_readme_occur_in_the_validation_table():
    section = README.split("## How right is it?")[1].split("\n## ")[0]
    rows = re.findall(r"^\| (?!what|---)(.*) \| (.*) \| (.*) \|$", section, re.MULTILINE)
    assert len(rows) == 6
    assert set(rows) <= {(row["what"], row["against"], row["found"]) for row in ROWS}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_targets_of_links_exist(page):
    """The links must also work in a repository browser, which shows the sources."""
    targets = re.findall(r"\]\((?!https?:|#)([^)#\s]+)", page.read_text(encoding="utf-8"))
    missing = [t for t in targets if not t.startswith("api/generated/") and not (page.parent / t).exists()]
    assert missing == []


def test_sources_cite_chapters_and_headings_of_the_theory():
    """A source cites a chapter by its file, optionally with a heading: docs/theory/friction.md, "Limits"."""
    sources = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    cited = []
    for source in sources:
        if source.endswith((".py", ".hpp", ".cpp", ".md")) and (ROOT / source).exists():
            text = re.sub(r"\n\s*(?:///?|#)?\s*", " ", (ROOT / source).read_text(encoding="utf-8"))
            cited += [(source, *found) for found in re.findall(r'docs/theory/([\w-]+)\.md(?:, "([A-Z][^"]*)")?', text)]
    assert len(cited) > 100
    headings = {
        path.stem: re.findall(r"^#+ (.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
        for path in (ROOT / "docs" / "theory").glob("*.md")
    }
    wrong = [one for one in cited if one[1] not in headings or (one[2] and one[2] not in headings[one[1]])]
    assert wrong == []


def tables() -> ModuleType:
    """Return docs/tables.py, which belongs to no package."""
    spec = importlib.util.spec_from_file_location("tables", ROOT / "docs" / "tables.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_tables_of_pages_are_up_to_date():
    """`make tables` writes the tables; a repository browser shows them as they are in the sources."""
    written = tables().pages()
    assert {"validation.md", "performance.md", "signs.md", "bodies.md", "published-results.md"} <= {
        page.name for page in written
    }
    stale = [page.name for page, text in written.items() if page.read_text(encoding="utf-8") != text]
    assert stale == []


def test_every_table_is_on_a_page():
    made = tables().parts()
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    assert all(f"<!-- {name}: made by docs/tables.py -->\n\n" in text for name in made)
    assert "| `resisting_torque` | N m | N m/m |" in text
    assert "{include} _generated" not in text


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pages_with_matplotlib_figures_enable_inline_plots(page):
    """Plots of the library display themselves; other figures need `%matplotlib inline`."""
    text = page.read_text(encoding="utf-8")
    assert "from matplotlib.figure import Figure" not in text or "%matplotlib inline" in text
