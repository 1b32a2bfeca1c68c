"""The folders of the Python package form layers: none imports from a later layer, and no imports are circular.

Imports for annotations only and imports in functions count as well.
"""

from __future__ import annotations

import ast
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[3] / "python" / "viscoroll"

#: Layers in the order of the user's path; folders of the same layer do not import each other.
LAYERS = (
    {"_core"},
    {"_support"},
    {"materials"},
    {"bodies", "ground"},
    {"solution", "analytic", "modal", "paper", "transient", "rheology", "finite_strain"},
    {"thermal"},
    {"enums", "rolling", "sliding"},
    {"coupled"},
    {"studies"},
    {"export", "case", "reproduce"},
    {"app", "report"},
    {"cli"},
    {"__init__", "__main__"},
)

RANK = {package: rank for rank, packages in enumerate(LAYERS) for package in packages}
#: Sources, and the files that contain the imports of packages whose names are imported when they are first used.
PATHS = sorted(path.relative_to(PACKAGE) for pattern in ("*.py", "__init__.pyi") for path in PACKAGE.rglob(pattern))


def module_of(path):
    """Return a path within the package as the parts of its module name, empty for the package itself."""
    return path.parent.parts if path.stem == "__init__" else path.with_suffix("").parts


MODULES = {module_of(path) for path in PATHS} | {("_core",)}


def package_of(module):
    return module[0] if module else "__init__"


def may_import(module, other):
    return package_of(module) == package_of(other) or RANK[package_of(other)] < RANK[package_of(module)]


def imports(path, source):
    """Return the modules of the package that a source imports anywhere."""
    folder = path.parent.parts
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names = [tuple(alias.name.split(".")) for alias in node.names]
            found |= {name[1:] for name in names if name[0] == "viscoroll"}
        elif isinstance(node, ast.ImportFrom):
            named = tuple((node.module or "").split(".")) if node.module else ()
            if node.level:
                base = folder[: len(folder) + 1 - node.level] + named
            elif named[:1] == ("viscoroll",):
                base = named[1:]
            else:
                continue
            for alias in node.names:
                found.add((*base, alias.name) if (*base, alias.name) in MODULES else base)
    return found


def imports_of(path):
    return imports(path, (PACKAGE / path).read_text(encoding="utf-8"))


def test_every_folder_has_a_layer():
    assert {package_of(module) for module in MODULES} == set(RANK)


@pytest.mark.parametrize("path", PATHS, ids=str)
def test_no_package_imports_from_a_later_layer(path):
    found = imports_of(path)
    assert found <= MODULES
    later = {".".join(other) for other in found if not may_import(module_of(path), other)}
    assert not later, f"{path} imports {later}"


def test_no_imports_are_circular():
    graph: dict[tuple[str, ...], set[tuple[str, ...]]] = {}
    for path in PATHS:
        graph.setdefault(module_of(path), set()).update(imports_of(path))
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" -> ".join(".".join(module) for module in error.args[1]))


@pytest.mark.parametrize(
    ("path", "source", "found"),
    [
        ("bodies/layers.py", "from ..rolling import solve", ("rolling",)),
        ("bodies/layers.py", "from ..solution.text import x", ("solution", "text")),
        ("bodies/layers.py", "from ..solution import text", ("solution", "text")),
        ("bodies/layers.py", "from .. import paper", ("paper",)),
        ("bodies/layers.py", "from .. import solve", ()),
        ("bodies/layers.py", "from viscoroll.rolling import solve", ("rolling",)),
        ("bodies/layers.py", "import viscoroll.rolling", ("rolling",)),
        ("solution/text.py", "if TYPE_CHECKING:\n    from ..rolling import Result", ("rolling",)),
        ("solution/text.py", "def f():\n    from ..thermal.picture import g", ("thermal", "picture")),
        ("coupled/__init__.py", "from ..case.case import Case", ("case", "case")),
    ],
)
def test_a_reversed_import_is_found(path, source, found):
    assert imports(Path(path), source) == {found}
    assert not may_import(module_of(Path(path)), found)


def test_packages_of_one_layer_do_not_import_each_other():
    assert not may_import(("case", "case"), ("reproduce", "item"))
    assert may_import(("case", "compare"), ("analytic", "applicable"))
