"""Names of a package that are imported when they are first used, so that a program imports only what it uses."""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable, Iterable
from importlib import import_module
from typing import Any

__all__ = ["lazy_names"]


def lazy_names(package: str, folders: Iterable[str]) -> tuple[Callable[[str], Any], Callable[[], list[str]], list[str]]:
    """Return `__getattr__`, `__dir__` and `__all__` of a package, whose file `__init__.pyi` imports its names.

    Type checkers read the same file. It contains only imports of the form ``from .module import name`` and `__all__`. A
    name must not be that of a module of the package, because the import of this module would replace it.

    Parameters
    ----------
    package : str
        Name of the package, `__name__`.
    folders : iterable of str
        Folder of the package, `__path__`.
    """
    (folder,) = folders
    with open(f"{folder}/__init__.pyi", encoding="utf-8") as file:  # noqa: PTH123  (pathlib takes longer to import)
        statements = ast.parse(file.read()).body
    modules = {
        alias.name: statement.module
        for statement in statements
        if isinstance(statement, ast.ImportFrom)
        for alias in statement.names
    }

    def __getattr__(name: str) -> Any:  # noqa: N807
        if name not in modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}", name=name, obj=sys.modules[package])
        module = modules[name]
        found = (
            import_module(f".{name}", package)
            if module is None
            else getattr(import_module(f".{module}", package), name)
        )
        setattr(sys.modules[package], name, found)  # Python calls __getattr__ only for names that are not set
        return found

    def __dir__() -> list[str]:  # noqa: N807
        return sorted({*vars(sys.modules[package]), *modules})

    return __getattr__, __dir__, sorted(modules)
