"""Output of the command line, and checks of output files before a long solve."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import ending_in
from .._support.progress import Report
from .._support.text import one_line, shown

with extra("cli"):
    from rich.console import Console

__all__ = [
    "MESSAGES",
    "OUTPUT",
    "PICTURES",
    "check_target",
    "progress_bar",
    "report_skipped",
    "with_nulls",
    "write_line",
    "write_message",
]

PICTURES = (".png", ".svg", ".pdf")
MESSAGES = Console(stderr=True)
OUTPUT = Console()


def write_line(line: str) -> None:
    """Write a line of results to the standard output, without markup."""
    OUTPUT.print(line, markup=False, emoji=False, highlight=False, soft_wrap=True)


def write_message(message: str) -> None:
    """Write a message to the standard error, on one line."""
    MESSAGES.print(one_line(message), markup=False, emoji=False, highlight=False, soft_wrap=True)


def with_nulls(scalars: Mapping[str, float | int | str | None]) -> dict[str, float | int | str | None]:
    """Return scalars for JSON text, with null for infinite and undefined values, for which JSON has no numbers."""
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in scalars.items()
    }


def check_target(option: str, path: Path | None, suffixes: tuple[str, ...]) -> None:
    """Raise a ValueError if the output file of an option cannot be written; called before a long solve."""
    if path is None:
        return
    ending_in(suffixes, path, name=option)
    if path.is_dir() or not path.parent.is_dir():
        raise InvalidInput(option, "must be a file in a folder that exists", shown(str(path)))


def report_skipped(path: Path, command: str) -> None:
    """Write which tables of a file a command such as "solve" does not use."""
    from ..case.tables import skipped_in

    if others := skipped_in(path, command=command):
        write_message(f"skipped in {path.name}: {others}")


@contextmanager
def progress_bar() -> Iterator[Report]:
    """Yield the function that receives a computation's progress, and show a bar if the terminal can redraw lines."""
    if not MESSAGES.is_interactive:  # a disabled bar writes an empty line before Rich 15
        yield lambda _stage, _fraction: None
        return
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn())
    with Progress(*columns, console=MESSAGES, transient=True) as bar:
        task = bar.add_task("starting", total=1.0)
        yield lambda stage, fraction: bar.update(task, description=stage, completed=fraction)
