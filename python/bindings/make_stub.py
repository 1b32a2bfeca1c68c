"""Write python/viscoroll/_core.pyi from the compiled module (`make stubs`); with --check, compare it (`make lint`)."""

from __future__ import annotations

import difflib
import importlib
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

from pybind11_stubgen import CLIArgs, arg_parser, stub_parser_from_args
from pybind11_stubgen.printer import Printer
from pybind11_stubgen.structs import Attribute, Class, Module, QualifiedName

MODULE = "viscoroll._core"
STUB = Path(__file__).parents[1] / "viscoroll" / "_core.pyi"
HEADER = "# Made by python/bindings/make_stub.py from the compiled module: `make stubs` renews it.\n# ruff: noqa\n"


class StubPrinter(Printer):
    """Printer of stubs with native enums for type checkers, and without values, which change with every commit."""

    def print_module(self, module: Module) -> list[str]:
        """Omit `__all__`, which the module itself does not have."""
        kept = [attribute for attribute in module.attributes if attribute.name != "__all__"]
        return super().print_module(replace(module, attributes=kept))

    def print_attribute(self, attr: Attribute) -> list[str]:
        """Print name and type of an attribute."""
        return super().print_attribute(replace(attr, value=None))

    def print_class(self, class_: Class) -> list[str]:
        """Print the members of an enum as values, not as annotated class variables."""
        if not any(str(base) == "enum.Enum" for base in class_.bases):
            return super().print_class(class_)
        members = [f"    {field.attribute.name} = ..." for field in class_.fields]
        return [f"class {class_.name}(enum.Enum):", f'    """{class_.doc}"""', *members]


def made_stub() -> str:
    """Return the formatted stub of the installed module."""
    arguments = arg_parser().parse_args([MODULE], namespace=CLIArgs())
    parser = stub_parser_from_args(arguments)
    module = parser.handle_module(QualifiedName.from_str(MODULE), importlib.import_module(MODULE))
    parser.finalize()
    if module is None:
        raise RuntimeError(f"no stub of {MODULE}")
    lines = StubPrinter(invalid_expr_as_ellipses=False).print_module(module)
    formatter = [sys.executable, "-m", "ruff", "format", "--stdin-filename", str(STUB), "-"]
    return subprocess.run(
        formatter, input=HEADER + "\n".join(lines) + "\n", capture_output=True, check=True, text=True
    ).stdout


def main() -> int:
    """Write or check the stub; return the exit code."""
    made = made_stub()
    if sys.argv[1:] != ["--check"]:
        STUB.write_text(made)
        return 0
    found = STUB.read_text()
    sys.stdout.writelines(
        difflib.unified_diff(found.splitlines(True), made.splitlines(True), str(STUB), "as made (make stubs)")
    )
    return int(made != found)


if __name__ == "__main__":
    sys.exit(main())
