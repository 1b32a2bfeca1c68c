"""The command `viscoroll app`, which serves an interactive page for cases."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from .._support.extras import extra
from .._support.toml import read_toml
from .output import write_line, write_message

with extra("cli"):
    import typer

__all__ = ["serve_page"]


def serve_page(
    case: Annotated[Path | None, typer.Argument(help="Case file in TOML with which the page starts.")] = None,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")] = True,
) -> None:
    """Edit and solve cases on a page in the browser; this machine solves them, and Ctrl-C stops the server."""
    from ..app import serve
    from ..app.case_text import page_case
    from ..case.tables import errors_in

    tables = None
    if case is not None:
        with errors_in(case):
            tables, skipped = page_case(read_toml(case))
        for name in skipped:
            write_message(f"skipped in {case.name}: the page does not support the table [{name}]")
    serve(tables, browser=browser, tell=write_line)
