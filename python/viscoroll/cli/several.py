"""Several cases side by side: a table of their results, and one figure of their pressures."""

from __future__ import annotations

import warnings
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import save_picture
from .._support.result_warnings import ResultWarning
from ..case import load_case
from ..case.plausible import speed_warning
from ..solution.scalars import SCALAR_GROUPS, SCALARS, label_of
from ..solution.text import result_warnings, scalar_texts
from .output import OUTPUT, progress_bar, write_message

with extra("cli"):
    from rich.markup import escape
    from rich.table import Table

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..rolling import Result

__all__ = ["print_several", "solve_several"]


def solve_several(
    paths: list[Path], changes: Mapping[str, Any], *, plot: Path | None, others: dict[str, object]
) -> dict[str, Result]:
    """Solve the cases of several files, draw their pressures, and return the results by the names of the files.

    Parameters
    ----------
    paths : list of Path
        Files.
    changes : mapping
        Values that replace those of all files.
    plot : Path or None
        Picture of the pressures along the path.
    others : dict
        Options that apply to a single case only, None if they are not given.
    """
    for option, value in others.items():
        if value is not None:
            raise InvalidInput(option, "must be left out with several case files")
    names = _names(paths)
    cases = {name: load_case(path, changes) for name, path in zip(names, paths, strict=True)}
    results: dict[str, Result] = {}
    with progress_bar() as report, warnings.catch_warnings():
        warnings.simplefilter("ignore", ResultWarning)  # printed below the table, with the names of the files
        for name, case in cases.items():
            if case.thermal is not None:
                write_message(f"skipped in {name}: [thermal] is for a single case file")
            results[name] = case.solve(progress=lambda stage, part, name=name: report(f"{name}: {stage}", part))
    for name, result in results.items():
        fast = speed_warning(result.angular_speed, result.body.outer_radius)
        for message in filter(None, [fast, *result_warnings(result)]):
            write_message(f"warning: {name}: {message}")
    if plot is not None:
        from .._support.pictures import draw_picture

        picture = draw_picture(lambda axes: _draw(axes, results), None, figsize=(7.0, 4.5))
        save_picture(cast("Figure", picture), plot)
    return results


def print_several(results: Mapping[str, Result]) -> None:
    """Print a table with a column for each result."""
    table = Table()
    table.add_column("")
    for name in results:
        table.add_column(escape(name), justify="right")
    solved = list(results.values())
    kinds = {type(result.body) for result in solved}
    for group, names in groupby(SCALARS, SCALAR_GROUPS.__getitem__):
        omitted = (None, 0) if group in ("friction", "other") else (None,)
        for name in names:
            if any(getattr(result, name) not in omitted for result in solved):
                label = label_of(name, solved[0].body) if len(kinds) == 1 else SCALARS[name][1].partition(",")[0]
                table.add_row(escape(label), *scalar_texts(solved, name))
        table.add_section()
    OUTPUT.print(table)


def _draw(axes: Axes, results: Mapping[str, Result]) -> None:
    """Draw the pressure in the middle of each contact along the path."""
    for name, result in results.items():
        middle = result.x.shape[1] // 2
        axes.plot(1e3 * result.x[:, middle], 1e-6 * result.pressure[:, middle], label=name)
    axes.set(xlabel="position along the path [mm]", ylabel="pressure [MPa]")
    axes.legend()


def _names(paths: list[Path]) -> list[str]:
    """Return the names of the files without suffix, or the whole paths if names occur twice."""
    stems = [path.stem for path in paths]
    texts = stems if len(set(stems)) == len(stems) else [str(path) for path in paths]
    if len(set(texts)) < len(texts):
        raise InvalidInput("case", "must be different files")
    return texts
