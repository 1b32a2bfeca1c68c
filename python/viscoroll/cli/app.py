"""The command line, with typer and rich (the extra `viscoroll[cli]`)."""

from __future__ import annotations

import copy
import errno
import io
import json
import os
import sys
import warnings
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

from .._core import Compliance, ConvergenceError, Curvature, Status, __fft__, __version__
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import save_picture
from .._support.result_warnings import ResultWarning
from .check import CHANGES, check
from .cite import print_citation
from .commands import design, material, schema
from .example import example
from .export import export, impact
from .output import (
    MESSAGES,
    OUTPUT,
    PICTURES,
    check_target,
    progress_bar,
    report_skipped,
    with_nulls,
    write_line,
    write_message,
)
from .page import serve_page
from .report import write_report
from .slide import slide

with extra("cli"):
    import typer
    from rich.markup import escape
    from rich.table import Table

if TYPE_CHECKING:
    from ..case import Case
    from ..reproduce import Verdict
    from ..rolling import Result

__all__ = ["run"]

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    help="Rolling resistance of balls, rollers and wheels with soft viscoelastic layers, on a plane, in a groove or on "
    "another body, rigid or viscoelastic: steady rolling, and motions that start, stop and reverse. Numbers in "
    "files and options are in SI units; texts such as '10 mm' state their unit. Start with: viscoroll example > "
    "case.toml",
)

#: Exit codes: invalid input, failed solve, stopped by Ctrl-C.
_INVALID, _FAILED, _STOPPED = 2, 1, 130


def run() -> None:
    """Run the command line. Exit code: 2 for invalid input, 1 if the solver fails, 130 after Ctrl-C."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # "?" if the encoding lacks Ω; stderr writes escapes
    warnings.simplefilter("ignore", ResultWarning)  # warnings are printed below the results
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # pydantic would search all installed packages
    try:
        _app_for(sys.argv[1:2])()
    except OSError as error:
        output = "standard output" if error.errno == errno.ENOSPC else ""  # errors of files have a filename
        source = error.filename or output
        _fail(f"{source}: {error.strerror}" if source else str(error), _INVALID)
    except (ValueError, TypeError) as error:
        _fail(str(error), _INVALID)
    except ConvergenceError as error:
        _fail(str(error), _FAILED)
    except ImportError as error:
        _fail(str(error), _INVALID)
    except MemoryError:
        _fail("not enough memory for this case: use a coarser mesh, or a larger accuracy", _INVALID)


def _app_for(arguments: list[str]) -> typer.Typer:
    """Return the app with only the command that the first argument names: Typer evaluates the options of all commands.

    Without a known command, return the whole app.
    """
    commands = {one.name or getattr(one.callback, "__name__", ""): one for one in app.registered_commands}
    named = [commands[argument] for argument in arguments if argument in commands]
    if not named:
        return app
    smaller = copy.copy(app)
    smaller.registered_commands = named
    return smaller


def _fail(message: str, code: int) -> NoReturn:
    write_message(f"viscoroll: {message}")
    sys.exit(code)


def _print_version(wanted: bool) -> None:
    if wanted:
        OUTPUT.print(f"viscoroll {__version__} ({__fft__})", highlight=False)
        raise typer.Exit


@app.callback()
def _main(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and the FFT library."
        ),
    ] = False,
    cite: Annotated[
        bool,
        typer.Option("--cite", callback=print_citation, is_eager=True, help="Print how to cite viscoroll, in BibTeX."),
    ] = False,
) -> None:
    pass


@app.command()
def solve(
    case: Annotated[
        list[Path],
        typer.Argument(help="Case file in TOML; `viscoroll example` prints a commented one. Several are compared."),
    ],
    changes: Annotated[list[str] | None, CHANGES] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print all scalar results as JSON in SI units.")] = False,
    plot: Annotated[Path | None, typer.Option(help="Draw the contact to this picture (.png, .svg, .pdf).")] = None,
    save: Annotated[Path | None, typer.Option(help="Write the fields to this file (.csv, .nc, .vtu, .vtk).")] = None,
    section: Annotated[
        Path | None, typer.Option(help="Draw the stress in the section through the contact to this picture.")
    ] = None,
    finite_strain: Annotated[
        bool, typer.Option("--finite-strain", help="Solve a roller by finite elements at finite strain as well.")
    ] = False,
) -> None:
    """Solve the load case of a file and print torque, penetration, pressure and power balance."""
    from ..case import load_case
    from ..case.key_paths import parsed_change
    from ..case.solved import recorded_warnings, solve_case
    from ..solution.files import FORMATS
    from .result_tables import finite_strain_scalars, finite_strain_table, require_finite_strain, thermal_table

    check_target("--plot", plot, PICTURES)
    check_target("--section", section, PICTURES)
    check_target("--save", save, tuple(FORMATS))
    wanted = dict(map(parsed_change, changes or []))
    if len(case) > 1:
        from .several import print_several, solve_several

        for path in case:
            report_skipped(path, "solve")
        results = solve_several(
            case,
            wanted,
            plot=plot,
            others={"--save": save, "--section": section, "--finite-strain": finite_strain or None},
        )
        if as_json:
            typer.echo(json.dumps({name: json.loads(_json(one.scalars())) for name, one in results.items()}, indent=2))
        else:
            print_several(results)
        return
    loaded = load_case(case[0], wanted)
    if finite_strain:
        require_finite_strain(loaded)
    report_skipped(case[0], "solve")
    with progress_bar() as report:
        solved = solve_case(loaded, progress=report)
        with recorded_warnings() as issued:
            rows = finite_strain_scalars(solved.result, progress=report) if finite_strain else {}
    result, softened = solved.result, solved.softened
    if as_json:
        scalars = result.scalars()
        if solved.temperatures:
            scalars["thermal"] = solved.thermal_scalars()  # type: ignore[assignment]
            scalars["bonds"] = solved.bonds  # type: ignore[assignment]
        if softened is not None:
            scalars["softening"] = {name: value for name, value, _ in softened.rows()}  # type: ignore[assignment]
        if rows:
            scalars["finite_strain"] = {name: found for name, (_, found, *_) in rows.items()}  # type: ignore[assignment]
        typer.echo(_json(scalars))
    else:
        _print_result(result, thermal_table(solved) if solved.temperatures else None)
        if rows:
            OUTPUT.print(finite_strain_table(rows, result.body))
        if softened is not None:
            for line in repr(softened).splitlines():
                write_line(line)
    for message in dict.fromkeys([*solved.warnings, *issued]):
        write_message(f"warning: {message}")
    if plot is not None:
        save_picture(result.plot(), plot)
    if section is not None:
        save_picture(result.plot_section(), section)
    if save is not None:
        result.save(save)


@app.command()
def roll(
    case: Annotated[
        Path, typer.Argument(help="Case file with a table \\[motion]; `viscoroll example --motion` prints one.")
    ],
    as_json: Annotated[bool, typer.Option("--json", help="Print peaks and energies as JSON in SI units.")] = False,
    plot: Annotated[
        Path | None,
        typer.Option(
            help="Draw the history to this picture (.png, .svg, .pdf); over uneven ground, over the distance with it."
        ),
    ] = None,
    animate: Annotated[
        Path | None,
        typer.Option(help="Write an animation of the body on its ground to this file (.gif; .mp4 with ffmpeg)."),
    ] = None,
    save: Annotated[Path | None, typer.Option(help="Write the time series to this file (.csv, .nc).")] = None,
    checkpoint: Annotated[
        Path | None,
        typer.Option(help="File (.state) for the state of an interrupted run; resume from it if it exists."),
    ] = None,
) -> None:
    """Compute the history of a motion from a file: roll, stop, stand, reverse."""
    from ..bodies.si_hints import unit_doubt
    from ..case.motion import load_motion
    from ..transient.history import ANIMATIONS
    from ..transient.history import FORMATS as HISTORY_FORMATS
    from ..transient.rolling_history import RollingState
    from ..transient.state_file import SUFFIX

    check_target("--plot", plot, PICTURES)
    check_target("--animate", animate, ANIMATIONS)
    check_target("--save", save, tuple(HISTORY_FORMATS))
    check_target("--checkpoint", checkpoint, (SUFFIX,))
    loaded = load_motion(case)
    report_skipped(case, "roll")
    resumed = {"start": RollingState.load(checkpoint)} if checkpoint is not None and checkpoint.exists() else {}
    with progress_bar() as report:
        history = loaded.roll(progress=report, checkpoint=checkpoint, **resumed)
    if as_json:
        typer.echo(_json(history.scalars()))
    else:
        write_line(repr(history))
    if hint := unit_doubt(loaded.body, loaded.on):
        write_message(f"warning: {hint}")
    if plot is not None:
        is_uneven = history.ground is not None or history.tread is not None or history.axle is not None
        save_picture(history.plot_ground() if is_uneven else history.plot(), plot)
    if animate is not None:
        history.animate(animate)
    if save is not None:
        history.save(save)


@app.command()
def sweep(
    study: Annotated[Path, typer.Argument(help="Case file with a table \\[sweep]; see `viscoroll example --sweep`.")],
    output: Annotated[
        Path | None, typer.Option(help="Result (.nc), with its cache beside it; by default beside the case file.")
    ] = None,
    retry_failed: Annotated[
        bool, typer.Option("--retry-failed", help="Solve failed and damaged points again.")
    ] = False,
    table: Annotated[Path | None, typer.Option(help="Also write one row for each point to this file (.csv).")] = None,
) -> None:
    """Solve all combinations of the parameters that a file varies, except the points that the cache holds."""
    from ..case.study import load_study
    from ..studies.study import run_plan, study_warnings
    from ..studies.table import save_table

    check_target("--output", output, (".nc",))
    check_target("--table", table, (".csv",))
    path = study.with_suffix(".nc") if output is None else output
    report_skipped(study, "sweep")
    try:
        dataset = run_plan(load_study(study), cache=path, retry_failed=retry_failed, progress=MESSAGES.is_terminal)
    except KeyboardInterrupt:
        _fail(f"stopped; run the same command again to resume from {path}.points", _STOPPED)
    if table is not None:
        save_table(dataset, table)
    for message in sorted(set(dataset.error.values.ravel()) - {""}):
        write_message(f"warning: a point failed: {message}")
    for message in study_warnings(dataset):
        write_message(f"warning: {message}")
    sizes = " x ".join(f"{dataset.sizes[name]} {name}" for name in dataset.error.dims)
    summary = f"{dataset.error.size} points ({sizes}), {int((dataset.error != '').sum())} failed: {path}"
    write_line(summary)


@app.command()
def plot(
    study: Annotated[Path, typer.Argument(help="Result of `viscoroll sweep` (.nc).")],
    output: Annotated[
        Path | None, typer.Option(help="Picture (.png, .svg, .pdf); by default beside the study.")
    ] = None,
    variable: Annotated[
        str | None,
        typer.Option(help="Scalar result to draw; by default the torque, or the friction coefficient of a surface."),
    ] = None,
) -> None:
    """Draw a result of a study against its first dimension, one curve for each value of the others."""
    check_target("--output", output, PICTURES)
    if study.suffix != ".nc":
        raise InvalidInput("study", "must be a .nc file written by `viscoroll sweep`", repr(study.name))
    with extra("files"):
        import netCDF4  # noqa: F401  (xarray reads with it)
        import xarray  # noqa: F401

    from .._support.sealed import load_sealed
    from ..studies.picture import default_variable, plot_study

    path = study.with_suffix(".png") if output is None else output
    dataset = load_sealed(study)
    drawn = default_variable(dataset) if variable is None else variable
    save_picture(plot_study(dataset, variable=drawn), path)
    write_line(f"{drawn} drawn to {path}")


@app.command()
def reproduce(
    items: Annotated[
        list[str] | None, typer.Argument(metavar="[ITEM]...", help="Items such as table2 or figure12; by default all.")
    ] = None,
    output: Annotated[Path, typer.Option(help="Folder for pictures and numbers.")] = Path("reproduced"),
    coarse: Annotated[
        bool, typer.Option("--coarse", help="Use a coarse mesh and few points, which takes seconds instead of minutes.")
    ] = False,
) -> None:
    """Compute and draw tables and figures of the paper, and compare them with its numbers and statements."""
    with extra("studies"):
        import_module("scipy")  # some items need it: fail before the others are solved
    from ..reproduce import ITEMS, Runner, write_files, write_verdicts
    from .result_tables import verdict_table

    if unknown := sorted(set(items or ()) - set(ITEMS)):
        raise InvalidInput("item", f"must be one of {', '.join(ITEMS)}", f"{unknown[0]!r}")
    output.mkdir(parents=True, exist_ok=True)
    verdicts: dict[str, list[Verdict]] = {}
    with progress_bar() as report:
        runner = Runner(
            coarse=coarse, progress=lambda stage, fraction: report(f"{name}: {item.title}, {stage}", fraction)
        )
        for name in [name for name in ITEMS if not items or name in items]:
            item = ITEMS[name]
            outcome = item.compute(runner)
            write_files(item, outcome, output)
            verdicts[name] = runner.judge(outcome)
    write_verdicts(output / "verdicts.md", verdicts)
    OUTPUT.print(verdict_table(verdicts))
    write_line(f"pictures, numbers and verdicts.md in {output}")


@app.command()
def compare(
    case: Annotated[
        Path, typer.Argument(help="Case file in TOML; its friction and compliance are ignored without --measured.")
    ],
    speeds: Annotated[
        str | None,
        typer.Option(help="Range from..to in rad/s, such as 0.05..25; by default around the speed of the case."),
    ] = None,
    output: Annotated[Path, typer.Option(help="Picture (.png, .svg, .pdf), with a .csv beside it.")] = Path(
        "compare.png"
    ),
    points: Annotated[int, typer.Option(help="Number of speeds.", min=2)] = 25,
    measured: Annotated[
        Path | None,
        typer.Option(
            help="Measurements (.csv: angular_speed or load, a scalar result, its error) to compare the case with, "
            "instead of closed forms."
        ),
    ] = None,
) -> None:
    """Draw torque against speed, from the solver with the radial compliance and from all applicable closed forms.

    With --measured, draw measured and computed results with error bands instead.
    """
    from ..case import load_case
    from ..case.compare import compare_torques, parse_speeds

    check_target("--output", output, PICTURES)
    loaded = load_case(case)
    report_skipped(case, "compare")
    if measured is not None:
        if speeds is not None:
            raise ValueError("--speeds must be left out with --measured: the case is solved at the measured points")
        _compare_measured(loaded, measured, output)
        return
    with progress_bar() as report:
        wanted = None if speeds is None else parse_speeds(speeds)
        comparison = compare_torques(loaded, speeds=wanted, points=points, progress=report)
    save_picture(comparison.plot(), output)
    comparison.write_csv(output.with_suffix(".csv"))
    for status, count in comparison.unsettled().items():
        write_message(f"warning: {count} speeds: {_STATUS_TEXT[status]}")
    names = ", ".join(comparison.forms) or "no closed form applies to this body"
    write_line(f"torque of the solver compared with {names}: {output}, {output.with_suffix('.csv')}")


def _compare_measured(case: Case, path: Path, output: Path) -> None:
    """Draw measured and computed results of a case, and print the number of measurements that agree."""
    from ..case.measured import compare_measured, read_measurements

    measurements = read_measurements(path)
    with progress_bar() as report:
        trial = compare_measured(case, measurements, progress=report)
    save_picture(trial.plot(), output)
    trial.write_csv(output.with_suffix(".csv"))
    for status in sorted(set(trial.statuses) - {Status.CONVERGED}, key=str):
        write_message(f"warning: {trial.statuses.count(status)} solves: {_STATUS_TEXT[status]}")
    write_line(f"{trial.verdict()}: {output}, {output.with_suffix('.csv')}")


@app.command()
def demo(
    plot: Annotated[Path, typer.Option(help="Draw the contact pressure to this picture (.png, .svg, .pdf).")] = Path(
        "demo-contact.png"
    ),
) -> None:
    """Solve the example of Zéhil and Gavin (section 14) on all meshes of their table 2; compare with their torques."""
    from .. import paper
    from ..rolling import solve as solve_rolling
    from .result_tables import table_2

    check_target("--plot", plot, PICTURES)
    ball = paper.ball()
    torques: dict[tuple[int, int], float] = {}
    with progress_bar() as report:
        for key, mesh in paper.table_2_meshes().items():
            result = solve_rolling(
                ball,
                load=paper.LOAD,
                angular_speed=paper.ANGULAR_SPEED,
                mesh=mesh,
                compliance=Compliance.RADIAL,
                curvature=Curvature.PAPER,
            )
            torques[key] = result.resisting_torque
            if key == (500, 500):
                chosen = result
            report("table 2 of the paper", len(torques) / len(paper.TABLE_2))
    OUTPUT.print(table_2(torques))
    worst = max(abs(torques[key] / printed - 1.0) for key, printed in paper.TABLE_2.items())
    OUTPUT.print(f"largest deviation of the {len(torques)} entries: {worst:.2%}\n", highlight=False)
    _print_result(chosen)
    save_picture(chosen.plot(), plot)
    write_line(f"contact pressure drawn to {plot}")


_STATUS_TEXT = {
    Status.MAX_ITERATIONS: "the contact still changed at the largest number of iterations",
    Status.ACCURACY_NOT_REACHED: "the finest allowed mesh does not have the requested accuracy; see the error estimate",
}


def _json(scalars: dict[str, float | int | str | None]) -> str:
    return json.dumps(with_nulls(scalars), indent=2, allow_nan=False)


def _print_result(result: Result, temperatures: Table | None = None) -> None:
    """Print a title with the inputs, the answer, temperatures and further results in tables of at most 80 columns."""
    from ..case.plausible import speed_text
    from ..solution.text import ANSWER, mesh_text, result_sections, result_title

    sections = result_sections(result)
    write_line(result_title(result))
    write_line(speed_text(result.angular_speed, result.body.outer_radius))
    _print_rows({ANSWER: sections.pop(ANSWER)})
    if temperatures is not None:
        OUTPUT.print(temperatures)
    _print_rows(sections)
    write_line(mesh_text(result))


def _print_rows(sections: dict[str, list[tuple[str, str]]]) -> None:
    for title, rows in sections.items():
        table = Table(title=title, title_justify="left", show_header=False)
        for row in rows:
            table.add_row(*map(escape, row))
        OUTPUT.print(table)


for command in (check, example, slide, material, export, impact, design, schema):
    app.command()(command)
app.command("app")(serve_page)
app.command("report")(write_report)
