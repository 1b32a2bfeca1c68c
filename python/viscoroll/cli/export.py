"""The commands `viscoroll export`, for particle codes, and `viscoroll impact`."""

from __future__ import annotations

import json
import sys
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import save_picture, write_csv
from .._support.quantities import quantity_text
from .._support.text import shown
from .._support.toml import read_toml
from .output import PICTURES, check_target, progress_bar, report_skipped, write_line, write_message

with extra("cli"):
    import typer

if TYPE_CHECKING:
    from .._support.arguments import Floats
    from ..bodies import Counterbody, RollingBody
    from ..case import Case
    from ..export import Impact
    from ..studies.plan import Plan

__all__ = ["export", "impact"]

_MASS = typer.Option(help="Mass of the ball, such as '50 g'; for two free balls m1 m2/(m1 + m2).")


class Code(StrEnum):
    """Particle codes for which `viscoroll export` writes."""

    LAMMPS = "lammps"
    LIGGGHTS = "liggghts"
    YADE = "yade"
    MERCURYDPM = "mercurydpm"
    CHRONO = "chrono"
    LETHE = "lethe"
    MUJOCO = "mujoco"
    KRATOS = "kratos"


def export(
    case: Annotated[Path, typer.Argument(help="Case file, optionally with a table \\[sweep] over load and speed.")],
    code: Annotated[Code, typer.Option("--for", help="Particle code that reads the input.")],
    style: Annotated[
        str | None,
        typer.Option(help="Rolling model of this code, such as viscous; an unknown name prints those of the code."),
    ] = None,
    mass: Annotated[str | None, _MASS] = None,
    impact_speed: Annotated[
        str | None,
        typer.Option(
            help="With --mass, speed of a normal impact, such as '0.5 m/s': adds its coefficient of restitution."
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option(help="File for the input lines; by default beside the case file.")
    ] = None,
    span: Annotated[
        float, typer.Option(help="Without \\[sweep]: factor by which load and speed vary up and down.")
    ] = 2.0,
) -> None:
    """Write rolling friction as a particle code defines it, a table of T(P, Ω) and, with --mass, the restitution."""
    from ..case.quantities import number_in_si
    from ..case.solved import recorded_warnings
    from ..export import dem
    from ..export import impact as normal_impact
    from ..export.balls import balls_of
    from ..export.dem import style_of
    from ..studies.study import run_plan, study_warnings, sweep

    if not 1.0 < span <= 100.0:
        raise ValueError(f"--span must be in (1, 100], got {span:g}")
    if (mass is None) != (impact_speed is None):
        raise ValueError("--mass and --impact-speed must be given together")
    path = case.with_suffix(f".{code.value}") if output is None else output
    if path.is_dir() or not path.parent.is_dir():
        raise ValueError(f"--output must be a file in a folder that exists, got {shown(str(path))}")
    report_skipped(case, "export")
    body, on, plan, loaded = _read(case)  # style and balls are checked before anything is solved
    style_of(code.value, style, balls_of(body, on))
    hit = None
    if mass is not None and impact_speed is not None:
        with progress_bar() as report, recorded_warnings() as issued:
            kilograms = number_in_si(mass, "kg", path="--mass")
            approaching = number_in_si(impact_speed, "m/s", path="--impact-speed")
            hit = normal_impact(body, on=on, mass=kilograms, speed=approaching, progress=report)
        for message in issued:
            write_message(f"warning: impact: {message}")
    at: dict[str, float] = {}
    if plan is not None:
        study = run_plan(plan, progress=sys.stderr.isatty())
    elif loaded is not None:
        varied, at = _around(loaded, span)
        study = sweep(**loaded.at(loaded.angular_speed).arguments() | varied, progress=sys.stderr.isatty())
    for message in study_warnings(study):
        write_message(f"warning: {message}")
    written = dem(study, code=code.value, style=style, impact=hit, **at)
    table = written.save(path)
    write_line(written.text.rstrip("\n"))
    write_line(f"written to {path}, torques to {table}")


def impact(
    case: Annotated[Path, typer.Argument(help="Case file with a ball; its load and speed of rolling are not used.")],
    mass: Annotated[str, _MASS],
    speed: Annotated[list[str], typer.Option(help="Speed of approach, such as '0.5 m/s'; may be repeated.")],
    as_json: Annotated[bool, typer.Option("--json", help="Print the results as JSON in SI units.")] = False,
    plot: Annotated[
        Path | None, typer.Option(help="Draw force over approach at the last speed to this picture (.png, .svg, .pdf).")
    ] = None,
    save: Annotated[Path | None, typer.Option(help="Write one row for each speed to this file (.csv).")] = None,
) -> None:
    """Compute the normal impact of a ball that does not rotate: restitution, force, duration and damping constants."""
    from ..case.quantities import number_in_si
    from ..case.solved import recorded_warnings
    from ..export import impact as normal_impact
    from ..export.impact import SCALARS

    check_target("--plot", plot, PICTURES)
    check_target("--save", save, (".csv",))
    report_skipped(case, "impact")
    body, on, *_ = _read(case)
    kilograms = number_in_si(mass, "kg", path="--mass")
    speeds = [number_in_si(one, "m/s", path="--speed") for one in speed]
    with progress_bar() as report, recorded_warnings() as issued:
        impacts = [normal_impact(body, on=on, mass=kilograms, speed=one, progress=report) for one in speeds]
    if as_json:
        typer.echo(json.dumps([one.scalars() for one in impacts], indent=2))
    else:
        write_line(repr(impacts[0]) if len(impacts) == 1 else _table(impacts))
    for message in dict.fromkeys(issued):
        write_message(f"warning: {message}")
    if plot is not None:
        save_picture(impacts[-1].plot(), plot)
    if save is not None:
        write_csv(
            {f"{name} [{unit}]": [one.scalars()[name] for one in impacts] for name, (_, unit) in SCALARS.items()}, save
        )


#: Scalars of the printed table, with their heads.
_COLUMNS = {
    "impact_speed": "speed",
    "restitution": "restitution",
    "lost_energy": "energy lost",
    "largest_force": "largest force",
    "largest_approach": "largest approach",
    "duration": "duration",
    "damping_ratio": "damping ratio",
}


def _table(impacts: list[Impact]) -> str:
    """Return a table with one line for each speed."""
    from ..export.impact import SCALARS

    rows = [[quantity_text(one.scalars()[name], SCALARS[name][1]) for name in _COLUMNS] for one in impacts]
    rows.insert(0, list(_COLUMNS.values()))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)) for row in rows)


def _read(path: Path) -> tuple[RollingBody, Counterbody | None, Plan | None, Case | None]:
    """Return the bodies of a case file, and its study, or its case without the table [sweep]."""
    from ..case import load_case
    from ..case.study import plan_study
    from ..case.tables import errors_in

    with errors_in(path):
        document = read_toml(path)
    if "sweep" not in document:
        case = load_case(path)
        return case.body, case.on, None, case
    from ..studies.kinds import ROLLING

    with errors_in(path):
        plan = plan_study({name: table for name, table in document.items() if name != "thermal"}, path.parent)
        if plan.kind is not ROLLING:
            raise InvalidInput("surface", "must be replaced by a ball for an export")
    first = next(one for one in plan.cases if not isinstance(one, str))
    return plan.bodies()[0], first.arguments.get("on"), plan, None


def _around(case: Case, span: float) -> tuple[dict[str, Floats], dict[str, float]]:
    """Return loads and speeds around those of a case, and the values of the case."""
    import numpy as np

    factors = np.geomspace(1.0 / span, span, 5)
    factors[2] = 1.0
    at = {"load": case.given_load(), "angular_speed": case.angular_speed}
    return {name: value * factors for name, value in at.items()}, at
