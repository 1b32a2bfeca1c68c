"""BibTeX entries from CITATION.cff."""

from __future__ import annotations

from pathlib import Path

import pytest
from shared_cases import command
from viscoroll._support import citation

ROOT = Path(__file__).parents[3]


def test_the_command_prints_the_entries_of_the_readme():
    done = command("--cite")
    assert (done.returncode, done.stderr) == (0, "")
    assert f"```bibtex\n{done.stdout}```\n" in (ROOT / "README.md").read_text(encoding="utf-8")
    assert "{Zéhil, G.-P. and Gavin, H. P.}" in done.stdout


def test_an_article_with_a_journal_has_all_fields(tmp_path, monkeypatch):
    path = tmp_path / "CITATION.cff"
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    text += "    journal: A Journal\n    year: 2001\n    volume: 5\n    start: 10\n    end: 20\n    doi: 10.1/x\n"
    path.write_text(text, encoding="utf-8")
    monkeypatch.setattr(citation, "_PATHS", (path,))
    entry = citation.bibtex().partition("\n\n")[2]
    assert entry.startswith("@article{zehil_gavin_2001,\n")
    for field in ("journal = {A Journal}", "year    = {2001}", "pages   = {10--20}", "doi     = {10.1/x}"):
        assert f"  {field}" in entry


def test_a_package_without_the_file_says_so(tmp_path, monkeypatch):
    monkeypatch.setattr(citation, "_PATHS", (tmp_path / "CITATION.cff",))
    with pytest.raises(FileNotFoundError):
        citation.bibtex()
