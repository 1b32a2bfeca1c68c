"""The reference programs do not use the core that they check."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
import reference
from viscoroll.reproduce import plain

#: These programs compare the package with a reference program, so they import the package.
COMPARISONS = ("finite_strain_slow.py", "finite_strain_table.py")
FILES = [Path(plain.__file__), *sorted(Path(reference.__file__).parent.glob("*.py"))]


@pytest.mark.parametrize("path", [path for path in FILES if path.name not in COMPARISONS], ids=lambda path: path.name)
def test_the_reference_is_independent_of_the_core(path):
    """The file imports only libraries, its own modules and the plain product."""
    allowed = {"viscoroll.reproduce.plain"}
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [node.module or ""]
            assert node.level == 0 or path.parent == Path(reference.__file__).parent, ast.unparse(node)
        for name in names:
            assert name in allowed or not name.startswith("viscoroll"), ast.unparse(node)
