"""The command `viscoroll report`, which writes the report of a case as an HTML file."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from .._support.extras import extra
from .._support.files import write_text
from .check import CHANGES
from .output import check_target, progress_bar, report_skipped, write_line

with extra("cli"):
    import typer

__all__ = ["write_report"]


def write_report(
    case: Annotated[Path, typer.Argument(help="Case file in TOML.")],
    changes: Annotated[list[str] | None, CHANGES] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Report (.html); by default beside the case file.")
    ] = None,
) -> None:
    """Solve a case and write a report for printing: inputs, results, pictures, curves and margins in one HTML file."""
    from ..case.key_paths import parsed_change
    from ..report import report_of

    path = case.with_suffix(".html") if output is None else output
    check_target("--output", path, (".html",))
    wanted = dict(map(parsed_change, changes or []))
    with progress_bar() as progress:
        text = report_of(case, wanted, progress)
    report_skipped(case, "report")
    write_text(text, path)
    write_line(f"report written to {path}")
