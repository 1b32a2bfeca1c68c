"""Names that packages import when they are first used, and modules that a start of Python must not import."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest
import viscoroll as vr

PACKAGE = Path(vr.__file__).parent

#: Packages whose names are imported when they are first used.
LAZY = sorted(
    ".".join(("viscoroll", *path.parent.relative_to(PACKAGE).parts)) for path in PACKAGE.rglob("__init__.pyi")
)

#: Packages of the extras that take long to import.
OPTIONAL = ("dask", "jinja2", "matplotlib", "netCDF4", "pandas", "pint", "scipy", "tqdm", "xarray")

#: Modules of viscoroll with the solver and with readers of files.
OWN = ("analytic", "case.tables", "coupled", "export", "finite_strain", "rheology", "studies", "transient")


def imported_by(*words: str) -> set[str]:
    """Return the names of all modules that a new interpreter has imported after it ran with these arguments."""
    report = "import atexit, sys; atexit.register(lambda: print(*sys.modules, sep='\\n', file=sys.stderr)); "
    program = f"{report}sys.argv = {list(words)!r}; from viscoroll.__main__ import main; main()"
    command = [sys.executable, "-c", program if words else f"{report}import viscoroll"]
    return set(subprocess.run(command, capture_output=True, text=True, check=True).stderr.split())


def unused(names: tuple[str, ...], found: set[str]) -> bool:
    """Return whether none of some modules has been imported. All must exist, so that no name is outdated."""
    assert all(find_spec(name) for name in names)
    return found.isdisjoint(names)


def own(*names: str) -> tuple[str, ...]:
    return tuple(f"viscoroll.{name}" for name in names)


def test_import_of_the_package_imports_nothing_else():
    assert unused((*OPTIONAL, "numpy", "pydantic", "typer", *own("_core", "bodies", "rolling", *OWN)), imported_by())


@pytest.mark.parametrize("option", ["--version", "--cite", "--help"])
def test_options_of_the_command_line_import_no_solver(option):
    found = imported_by("viscoroll", option)
    assert unused((*OPTIONAL, "numpy", "pydantic", *own("bodies", "rolling", *OWN)), found)


def test_solve_imports_only_what_its_case_needs(tmp_path):
    case = tmp_path / "case.toml"
    case.write_text("[ball]\ncore_radius = 0.02\n[rolling]\nload = 1.0\nangular_speed = 1.0\n", encoding="utf-8")
    with pytest.raises(subprocess.CalledProcessError) as error:  # a rigid ball is rejected after the file has been read
        imported_by("viscoroll", "solve", str(case))
    found = set(error.value.stderr.split())
    assert "viscoroll.case.tables" in found
    unneeded = ("analytic", "export", "finite_strain", "materials.deck", "rheology", "studies", "transient")
    assert unused((*OPTIONAL, "rich.progress", *own(*unneeded)), found)


def test_lazy_packages():
    assert {"viscoroll", "viscoroll.case", "viscoroll.materials"} <= set(LAZY)


@pytest.mark.parametrize("name", LAZY)
def test_lazy_names_are_complete(name):
    package = importlib.import_module(name)
    assert set(package.__all__) <= set(dir(package))
    for one in package.__all__:
        value = getattr(package, one)
        assert value is getattr(package, one)
        # The import of a module sets the attribute of the package with this name, and would replace another object.
        assert find_spec(f"{name}.{one}") is None or value is sys.modules[f"{name}.{one}"]


@pytest.mark.parametrize("name", LAZY)
def test_lazy_names_are_those_of_type_checkers(name):
    package = importlib.import_module(name)
    text = Path(package.__file__).with_suffix(".pyi").read_text(encoding="utf-8")
    assert ast.literal_eval(text.partition("__all__ = ")[2]) == package.__all__


def test_unknown_names_are_errors():
    with pytest.raises(AttributeError, match=r"^module 'viscoroll' has no attribute 'spin'") as error:
        vr.spin  # noqa: B018
    assert error.value.name == "spin"
    with pytest.raises(ImportError, match="cannot import name 'spin' from 'viscoroll'"):
        from viscoroll import spin  # noqa: F401
