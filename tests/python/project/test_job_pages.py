"""Pages of the applications: required parts, output of the pages about measurements, and search words.

The build of the site runs all pages, and `test_page_commands.py` runs their commands.
"""

from __future__ import annotations

import importlib.util
import json
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

DOCS = Path(__file__).parents[3] / "docs"
JOBS = sorted((DOCS / "jobs").glob("*.md"))


def check_search() -> ModuleType:
    """Return docs/check_search.py, which belongs to no package and checks the built site."""
    spec = importlib.util.spec_from_file_location("check_search", DOCS / "check_search.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SEARCH = check_search()


def text_of(name: str) -> str:
    return (DOCS / "jobs" / f"{name}.md").read_text(encoding="utf-8")


def blocks(page: str, language: str = "{code-cell}") -> list[str]:
    """Return the blocks of a language, without the cell that configures plots in a notebook.

    A cell whose printed warnings the page hides may warn.
    """
    found = re.findall(rf"```{re.escape(language)}\n(.*?)```", page, re.DOTALL)
    may_warn = 'import warnings\nwarnings.simplefilter("default")\n{}\nwarnings.simplefilter("error")\n'
    hidden = ":tags: [remove-stderr]\n"
    return [
        may_warn.format(block.removeprefix(hidden)) if block.startswith(hidden) else block
        for block in found
        if "%matplotlib" not in block
    ]


def run(name: str, folder: Path) -> str:
    """Run the Python of a page in a folder, as a script whose warnings are errors; return its output."""
    (folder / "page.py").write_text("\n".join(blocks(text_of(name))), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-W", "error", "page.py"], cwd=folder, capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("page", JOBS, ids=lambda page: page.stem)
def test_every_application_has_a_plot_and_states_its_limits(page):
    text = page.read_text(encoding="utf-8")
    assert re.search(r"^## (Plot of .+|Sliders)$", text, re.MULTILINE)
    assert "## Limits of the result" in text
    assert "model_error" in text


def test_all_applications_are_listed_and_have_a_card():
    names = {page.stem for page in JOBS}
    listed = (DOCS / "jobs.md").read_text(encoding="utf-8")
    home = (DOCS / "index.md").read_text(encoding="utf-8").split("## Applications")[1].split("\n## ")[0]
    assert set(re.findall(r"^jobs/(\S+)$", listed, re.MULTILINE)) == names
    assert set(re.findall(r"^\* \[\*\*.*\]\(jobs/(\S+)\.md\)$", home, re.MULTILINE)) == names


@pytest.mark.parametrize("query", SEARCH.SEARCHED)
def test_words_of_a_query_occur_on_its_page(query):
    page = (DOCS / f"{SEARCH.SEARCHED[query]}.md").read_text(encoding="utf-8")
    prose = re.sub(r"```.*?```", "", page, flags=re.DOTALL).lower()
    assert all(re.search(rf"\b{word}", prose) for word in query.lower().split())


def test_all_words_of_a_query_except_stop_words_are_searched(tmp_path):
    index = {"docnames": ["a", "b"], "terms": {"lammp": [0, 1], "pair": 1}, "titleterms": {"shore": 0}}
    (tmp_path / "searchindex.js").write_text(f"Search.setIndex({json.dumps(index)})", encoding="utf-8")
    read = SEARCH.read_index(tmp_path / "searchindex.js")
    assert SEARCH.words_of("DIN 22123") == ["din"]
    assert SEARCH.words_of("Shore D") == ["shore"]
    assert SEARCH.pages_with(read, "lammp") == {"a", "b"}
    assert SEARCH.pages_with(read, "pair") == {"b"}
    assert SEARCH.pages_with(read, "shore") == {"a"}
    assert SEARCH.pages_with(read, "idler") == set()


@pytest.mark.slow
def test_measurements_give_a_torque_with_an_interval(tmp_path):
    printed = run("dma", tmp_path)
    assert "339 points in 20 sweeps" in printed
    assert "undetermined              233.15 to 243.16 K (-40 to -29.99 °C)" in printed
    # The intervals have a confidence of 95 %. With this noise, all nine contain the exact value.
    held = re.search(r"the interval contains the exact value at (\d) of 9 temperatures", printed)
    assert held
    assert int(held[1]) >= 8


def test_particles_page_exports_a_wall_and_a_pair(tmp_path):
    printed = run("particles", tmp_path)
    assert "fix floor all wall/gran granular hertz" in printed
    assert "pair_style granular\npair_coeff 1 1 hertz" in printed
    assert (tmp_path / "wall.lammps").read_text(encoding="utf-8").count("\n") == 7
    assert len((tmp_path / "wall.csv").read_text(encoding="utf-8").splitlines()) == 29  # 4 loads by 7 speeds


def test_table_of_codes_is_complete():
    from viscoroll.export.dem import CODES

    rows = re.findall(r"^\| (?:`(\w+)`)? ?\| ((?:`\w+`(?:, )?)+) \|", text_of("particles"), re.MULTILINE)
    listed, code = set(), ""
    for name, styles in rows:
        code = name or code
        listed |= {(code, style) for style in re.findall(r"`(\w+)`", styles)}
    assert listed == {(code, style) for code, styles in CODES.items() for style in styles}
