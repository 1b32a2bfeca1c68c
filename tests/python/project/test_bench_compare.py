"""Comparison of benchmarks with the last recorded ones: which rows are compared, and the judgments."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

PATH = Path(__file__).parents[3] / "bench" / "compare.py"


@pytest.fixture(scope="module")
def compare():
    spec = importlib.util.spec_from_file_location("bench_compare", PATH)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def row(commit, seconds, error=1e-4, **changes):
    given = {"commit": commit, "median_s": str(seconds), "error": str(error), "cpu": "A", "threads": "2"}
    return given | {"clock": "wall", "case": "table_2"} | changes


@pytest.mark.parametrize(
    ("seconds", "error", "judgment"),
    [(1.2, 1e-4, ""), (1.3, 1e-4, "slower"), (0.7, 1e-4, "faster"), (0.7, 2e-4, "less accurate"), (1.0, 0.9e-4, "")],
)
def test_changes_beyond_the_tolerance_are_reported(compare, seconds, error, judgment):
    (change,) = compare.changes([row("a", 9.0), row("b", 1.0), row("c", seconds, error)])
    assert change.commits == ("b", "c")
    assert change.judgment(0.25) == judgment


def test_only_rows_of_the_same_case_and_machine_are_compared(compare):
    before = [row("a", 1.0, cpu="B"), row("a", 1.0, clock="cpu"), row("a", 1.0, threads="1"), row("a", 1.0, case="x")]
    assert compare.changes([*before, row("b", 2.0)]) == []
    assert compare.changes([row("b", 1.0), row("b", 2.0)]) == []  # the same sources


def test_a_worse_row_sets_the_exit_code(compare, tmp_path, monkeypatch, capsys):
    path = tmp_path / "results.csv"
    rows = [row("a", 1.0), row("b", 2.0)]
    path.write_text("\n".join([",".join(rows[0]), *(",".join(r.values()) for r in rows)]))
    monkeypatch.setattr(sys, "argv", ["compare.py", str(path)])
    assert compare.main() == 1
    assert "slower" in capsys.readouterr().out
    monkeypatch.setattr(sys, "argv", ["compare.py", "--tolerance", "1.5", str(path)])
    assert compare.main() == 0
