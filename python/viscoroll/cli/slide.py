"""The command `viscoroll slide`, for rough surfaces that slide."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from .._support.extras import extra
from .._support.files import save_picture, write_csv
from .output import PICTURES, check_target, progress_bar, report_skipped, with_nulls, write_line, write_message

with extra("cli"):
    import typer

if TYPE_CHECKING:
    from ..sliding import SlidingResult

__all__ = ["slide"]


def slide(
    case: Annotated[
        Path,
        typer.Argument(
            help="File with the tables \\[surface], \\[plane] and \\[sliding]; see `viscoroll example --sliding`."
        ),
    ],
    as_json: Annotated[bool, typer.Option("--json", help="Print the results as JSON in SI units.")] = False,
    plot: Annotated[
        Path | None, typer.Option(help="Draw the pressure at the last speed to this picture (.png, .svg, .pdf).")
    ] = None,
    save: Annotated[Path | None, typer.Option(help="Write one row for each speed to this file (.csv).")] = None,
) -> None:
    """Compute contact area and friction of a rough surface that slides, at one speed or several."""
    from ..case.sliding import load_sliding

    check_target("--plot", plot, PICTURES)
    check_target("--save", save, (".csv",))
    loaded = load_sliding(case)
    report_skipped(case, "slide")
    with progress_bar() as report:
        results = loaded.slide(progress=report)
    if as_json:
        typer.echo(json.dumps([with_nulls(result.scalars()) for result in results], indent=2, allow_nan=False))
    else:
        write_line(repr(results[0]) if len(results) == 1 else _table(results))
    for result in results:
        for message in result.warnings.values():
            write_message(f"warning: at {result.speed:g} m/s {message}")
    if plot is not None:
        save_picture(results[-1].plot(), plot)
    if save is not None:
        units = results[0].units
        write_csv({f"{name} [{unit}]": [r.scalars()[name] for r in results] for name, unit in units.items()}, save)


#: Heads of the printed table, and names of its scalars.
_COLUMNS = {
    "speed [m/s]": "speed",
    "friction": "friction_coefficient",
    "error": "friction_error",
    "contact": "corrected_contact_share",
    "mean gap [m]": "mean_gap",
    "Persson's friction": "persson_friction",
    "Persson's contact": "persson_contact_share",
}


def _table(results: list[SlidingResult]) -> str:
    """Return a table with one line for each speed."""
    rows = [[f"{scalars[name]:.4g}" for name in _COLUMNS.values()] for scalars in (r.scalars() for r in results)]
    widths = [max(len(row[i]) for row in [list(_COLUMNS), *rows]) for i in range(len(_COLUMNS))]
    lines = [
        "  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)) for row in [list(_COLUMNS), *rows]
    ]
    return "\n".join([f"Sliding under a mean pressure of {results[0].mean_pressure:g} Pa", *lines])
