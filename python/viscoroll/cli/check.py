"""The command `viscoroll check`, which validates files without solving them."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from .._support.errors import in_file
from .._support.extras import extra
from .._support.toml import read_toml
from .output import write_line, write_message

with extra("cli"):
    import typer

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..case import Case

__all__ = ["CHANGES", "check"]

#: Option of commands that read a case.
CHANGES = typer.Option(
    "--set", metavar="KEY=VALUE", help="Replace a value of the file, such as rolling.load='500 N'; may be repeated."
)


class _Valid(Exception):  # noqa: N818 - ends a solve whose input is valid
    """The solver has accepted its input and begins to compute."""


def check(
    files: Annotated[list[Path], typer.Argument(help="Case and motion files in TOML.")],
    changes: Annotated[list[str] | None, CHANGES] = None,
) -> None:
    """Check files without solving them, and list all errors. Exit code: 0 if all files are valid, 2 otherwise."""
    from ..case.case import with_changes
    from ..case.key_paths import parsed_change
    from ..case.tables import errors_in

    wanted = dict(map(parsed_change, changes or []))
    failed = False
    for path in files:
        with errors_in(path):
            document = with_changes(read_toml(path), wanted)
        found = [str(in_file(error, path)) for error in _errors(document, path)]
        failed |= bool(found)
        for message in found:
            write_message(f"viscoroll: {message}")
        if not found:
            write_line(f"{path}: valid for {', '.join(f'`viscoroll {name}`' for name in _commands(document))}")
    if failed:
        raise typer.Exit(2)


def _commands(document: dict[str, Any]) -> list[str]:
    """Return the commands that read a file."""
    commands = {"rolling": "solve", "motion": "roll", "sliding": "slide", "sweep": "sweep", "design": "design"}
    found = [command for table, command in commands.items() if table in document]
    return found if {"rolling", "motion", "sliding"} & document.keys() else ["solve", *found]


def _errors(document: dict[str, Any], path: Path) -> Iterator[Exception]:
    """Yield the errors of the content of a file."""
    from ..case.case import CaseFile, build_case
    from ..case.design import check_design
    from ..case.motion import MotionFile, build_motion
    from ..case.sliding import SlidingFile, build_sliding
    from ..case.study import plan_study
    from ..case.tables import problems

    checks: dict[str, Any] = {
        "solve": (CaseFile, lambda: _accepted(build_case(document, path.parent))),
        "roll": (MotionFile, lambda: build_motion(document, path.parent)),
        "slide": (SlidingFile, lambda: build_sliding(document, path.parent)),
        "sweep": (None, lambda: plan_study(dict(document), path.parent)),
        "design": (None, lambda: check_design(dict(document))),
    }
    for command in _commands(document):
        kind, build = checks[command]
        errors: list[Exception] = [] if kind is None else [*problems(kind, document, path.parent)]
        if not errors:
            try:
                build()
            except (TypeError, ValueError) as error:
                errors = [error]
        yield from errors


def _accepted(case: Case) -> None:
    """Start to solve a case, which checks the values that the core checks, and stop before the computation."""

    def stop(_stage: str, _fraction: float) -> None:
        raise _Valid

    with contextlib.suppress(_Valid):
        case.solve(progress=stop)
