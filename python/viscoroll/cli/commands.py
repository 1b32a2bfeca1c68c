"""Further commands: materials from measurements, design, schema."""

from __future__ import annotations

import json
import re
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypedDict

from .._support.celsius import ZERO_CELSIUS, kelvin_range, kelvin_text
from .._support.extras import extra
from .._support.files import save_picture
from .._support.quantities import quantity_text
from .output import PICTURES, check_target, progress_bar, report_skipped, write_line

with extra("cli"):
    import typer

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..materials import Draws, Prony, WilliamsLandelFerry
    from ..materials.shear_modulus import ShearModulus
    from ..rheology import (
        Check,
        Isotherm,
        PronyFit,
        RheologyData,
        ShiftFactors,
        Superposition,
        TemperatureRamp,
        TimeData,
    )

__all__ = ["design", "material", "schema"]


class TemperatureUnit(StrEnum):
    """Units of the temperatures of an input file."""

    K = "K"
    C = "C"


def material(
    context: typer.Context,
    data: Annotated[
        list[str],
        typer.Argument(
            help="Text, CSV, Excel or JSON exports of a rheometer or DMA instrument; a file without temperatures as "
            "FILE@20C or FILE@293.15K, with the temperature in its name, such as a_-20C.csv, or matched by a pattern "
            "such as 'a_*C.csv'. Or one input file of Abaqus, Ansys or LS-DYNA, whose constants are printed."
        ),
    ],
    reference: Annotated[
        str | None, typer.Option(help="Temperature of the master curve, such as 20C or 293.15 (in K).")
    ] = None,
    at: Annotated[
        str | None, typer.Option(help="Also print the modulus at this temperature, such as 40C or 313.15 (in K).")
    ] = None,
    tensile: Annotated[
        bool | None, typer.Option("--tensile/--shear", help="Type of the moduli, if the column names do not give it.")
    ] = None,
    poisson_ratio: Annotated[float, typer.Option(help="Poisson's ratio that converts tensile to shear moduli.")] = 0.5,
    columns: Annotated[
        str | None,
        typer.Option(help="Names and units of the columns, such as 'frequency=f:Hz,storage=A:MPa,loss=B:MPa'."),
    ] = None,
    between: Annotated[
        str | None, typer.Option(help="Use only the sweeps from..to, such as -35C..160C or 238..433 (in K).")
    ] = None,
    frequency: Annotated[
        str | None,
        typer.Option(help="Frequency of a temperature ramp without a column of it, such as 1Hz or 6.28 (in rad/s)."),
    ] = None,
    step: Annotated[
        int | None, typer.Option(help="Number of the data set to read, if the file contains several.")
    ] = None,
    factors: Annotated[
        Path | None, typer.Option(help="Shift factors to use (.csv: T, log_aT) instead of fitted ones.")
    ] = None,
    wlf: Annotated[
        str | None, typer.Option(help="WLF law of the shift: C1, C2 in K, T_r in K, such as 17.44,51.6,208.")
    ] = None,
    vertical: Annotated[bool, typer.Option("--vertical", help="Also shift the moduli vertically.")] = False,
    units: Annotated[
        str, typer.Option(help="Units of an input file of Abaqus, Ansys or LS-DYNA, such as mm-t-s.")
    ] = "m-kg-s",
    temperature_unit: Annotated[
        TemperatureUnit, typer.Option(help="Unit of the temperatures of such an input file.")
    ] = TemperatureUnit.K,
    terms_per_decade: Annotated[float, typer.Option(help="Terms of the Prony series per decade.")] = 2.0,
    draws: Annotated[
        int, typer.Option(help="Number of draws to save for confidence intervals (table \\[draws] of a study).", min=0)
    ] = 0,
    accept: Annotated[
        bool, typer.Option("--accept", help="Accept data that fail a check, which is otherwise an error.")
    ] = False,
    plot: Annotated[Path | None, typer.Option(help="Draw data, fit and residual (.png, .svg, .pdf).")] = None,
    save: Annotated[
        Path | None, typer.Option(help="Write the material to this file (.toml), to which case files can refer.")
    ] = None,
) -> None:
    """Make a material from measured moduli, relaxation or creep: read, shift to one temperature, check, fit, save."""
    from ..case.quantities import number_in_si, range_in_si
    from ..rheology import check_modulus, fit_prony, read_rheology, read_time_tests, save_material, superpose
    from ..rheology.reading import SWEEP_ROLES
    from ..rheology.time_tests import TIME_ROLES, contains_time_tests

    files = _files(data)
    is_deck = len(data) == 1 and _holds_constants(Path(data[0]))
    if is_deck or isinstance(files, dict) or files.is_file():  # the reader of measurements reports a missing file
        _require_options_of(context, data[0], is_deck=is_deck)
    if is_deck:
        _write_constants(Path(data[0]), units, temperature_unit)
        return
    check_target("--plot", plot, PICTURES)
    check_target("--save", save, (".toml",))
    if draws == 1:
        raise ValueError("--draws must be 0 or at least 2, got 1")
    if draws and save is None:
        raise ValueError("--save must be given with --draws, because draws are saved with the material")
    at_reference, at_kelvin = (
        None if text is None else number_in_si(text, "K", path=option)
        for option, text in (("--reference", reference), ("--at", at))
    )
    named = _columns(columns)
    own = _own_shift(factors, wlf)
    listed = files if isinstance(files, dict) else {files: None}
    if over_time := [path for path in listed if contains_time_tests(path, columns=named, step=step)]:
        if plot is not None or between is not None or frequency is not None or vertical:
            raise ValueError(
                "--plot, --between, --frequency and --vertical must be left out with relaxation or creep, "
                f"which {over_time[0]} contains"
            )
        options: _ReadingOptions = {"tensile": tensile, "poisson_ratio": poisson_ratio, "step": step}
        tests = {path: listed[path] for path in over_time} if isinstance(files, dict) else files
        parts: list[TimeData | RheologyData] = [read_time_tests(tests, columns=_only(named, TIME_ROLES), **options)]
        if rest := {path: kelvin for path, kelvin in listed.items() if path not in over_time}:
            parts.append(read_rheology(rest, columns=_only(named, SWEEP_ROLES), **options))
        _fit_over_time(parts, at_reference, own, at=at_kelvin, draws=draws, accept=accept, save=save)
        return
    measured = read_rheology(
        files,
        columns=named,
        tensile=tensile,
        poisson_ratio=poisson_ratio,
        frequency=None if frequency is None else number_in_si(frequency, "rad/s", path="--frequency"),
        step=step,
    )
    if between is not None:
        measured = measured.between(*range_in_si(between, "K", path="--between"))
    for line in repr(measured).splitlines():
        write_line(line)
    curve: Superposition | Isotherm
    if measured.ramp is not None and own is None:
        _write_ramp(measured.ramp, at_kelvin, wanted=plot or save)
        return
    if len(measured.isotherms) > 1:
        curve = superpose(measured, reference=_reference(measured, at_reference), factors=own, vertical=vertical)
        for line in repr(curve).splitlines():
            write_line(line)
    else:
        if reference is not None:
            raise ValueError("--reference must be left out with sweeps at one temperature, which the material then has")
        curve = measured.isotherms[0]
    checks = check_modulus(curve)
    for check in checks:
        write_line(str(check))
    fit = fit_prony(curve, terms_per_decade=terms_per_decade)
    write_line(repr(fit))
    if at_kelvin is not None:
        _write_modulus(curve, at_kelvin)
    if plot is not None:
        save_picture(fit.plot(), plot)
        write_line(f"data, fit and residual drawn to {plot}")
    _require_consistent(measured.source, checks, accept=accept)
    if save is not None:
        save_material(save, curve, fit=fit, draws=_draws(curve, fit, draws))
        _write_saved(save)


class _ReadingOptions(TypedDict):
    """Options of both readers."""

    tensile: bool | None
    poisson_ratio: float
    step: int | None


def _only(columns: dict[str, str | tuple[str, str]] | None, roles: tuple[str, ...]) -> Any:
    """Return the named columns that a reader knows."""
    return columns and {role: name for role, name in columns.items() if role in roles}


def _fit_over_time(
    parts: list[TimeData | RheologyData],
    reference: float | None,
    own: ShiftFactors | WilliamsLandelFerry | None,
    *,
    at: float | None,
    draws: int,
    accept: bool,
    save: Path | None,
) -> None:
    """Fit relaxation and creep, and sweeps of the same material, and print and save the fit."""
    from ..rheology import fit_spectrum, save_material

    for part in parts:
        for line in repr(part).splitlines():
            write_line(line)
    fit = fit_spectrum(parts, reference=reference, factors=own)
    for line in repr(fit).splitlines():
        write_line(line)
    write_line(str(fit.check))
    if at is not None:
        _write_moduli(fit.series_at(temperature=at), at, *fit.range_at(temperature=at))
    _require_consistent(", ".join(part.source for part in parts), [fit.check], accept=accept)
    if save is not None:
        save_material(save, fit, fit=fit, draws=fit.draws(draws) if draws else None)
        _write_saved(save)


def _require_consistent(source: str, checks: Iterable[Check], *, accept: bool) -> None:
    """Raise a ValueError with the messages of the failed checks, unless the user accepts them."""
    failed = [check.message for check in checks if not check.passed]
    if failed and not accept:
        raise ValueError(
            f"{source}: must be consistent with one passive material, got {'; '.join(failed)}; check columns, units "
            "and temperatures, leave out bad tests, give the shift if it is known (--wlf, --factors), or give --accept "
            "to use the data anyway"
        )


def _holds_constants(path: Path) -> bool:
    """Return whether a file is input of a finite-element program. The reader of measurements reports missing files."""
    from ..materials.constants import holds_constants

    return path.is_file() and holds_constants(path)


def _require_options_of(context: typer.Context, file: str, *, is_deck: bool) -> None:
    """Raise an error that lists the given options that do not apply to an input file, or only to such a file."""
    given = [
        parameter
        for parameter in context.command.params
        if (source := context.get_parameter_source(str(parameter.name))) is not None
        and source.name != "DEFAULT"
        and parameter.param_type_name == "option"
        and (parameter.name in ("units", "temperature_unit")) != is_deck
    ]
    if given:
        names = ", ".join("/".join([*parameter.opts, *parameter.secondary_opts]) for parameter in given)
        condition = f"with constants, which {file} contains" if is_deck else "without one input file of another program"
        raise ValueError(f"{names} must be left out {condition}")


def _write_constants(path: Path, units: str, temperature_unit: TemperatureUnit) -> None:
    """Print the constants of an input file, and how a case file refers to it."""
    from ..materials import read_constants

    for line in repr(read_constants(path, units=units, temperature_unit=temperature_unit.value)).splitlines():
        write_line(line)
    of_temperature = "" if temperature_unit is TemperatureUnit.K else f", temperature_unit = '{temperature_unit}'"
    table = f"type = 'constants', file = '{path.name}', units = '{units}'{of_temperature}"
    write_line(f"in a case file, shear_modulus = {{ {table} }}")


def _files(arguments: list[str]) -> Path | dict[Path, float | None]:
    """Return the path of a single file, or the temperature [K] of each, from arguments such as "a.csv@20C"."""
    from ..rheology.file_sets import file_set, temperatures_of

    files: list[tuple[str, float | None]] = []
    for argument in arguments:
        found = re.fullmatch(r"(.+)@(-?\d+(?:\.\d+)?) ?(C|degC|K)", argument)
        if found is None:
            files.append((argument, None))
        else:
            files.append((found[1], float(found[2]) + (0.0 if found[3] == "K" else ZERO_CELSIUS)))
    return file_set(arguments[0]) if files == [(arguments[0], None)] else temperatures_of(files)


def design(
    case: Annotated[Path, typer.Argument(help="Case file with a table \\[design]; see `viscoroll example --design`.")],
    plot: Annotated[Path | None, typer.Option(help="Draw power and limits (.png, .svg, .pdf).")] = None,
) -> None:
    """Find the value of a number, such as a thickness, with the least power loss, or the largest one within limits."""
    from ..case.design import design_case
    from ..case.limits import limit_label, limit_text

    check_target("--plot", plot, PICTURES)
    report_skipped(case, "design")
    with progress_bar() as report:
        found = design_case(case, progress=report)
    best = quantity_text(found.best, found.unit, digits=6)  # to copy: with fewer digits it may exceed a limit
    power = quantity_text(found.result.dissipated_power, found.result.unit("dissipated_power"))
    write_line(f"{found.variable} = {best}: power dissipated {power}")
    for name, limit in found.limits.items():
        reached = ", reached" if name in found.active else ""
        unit = found.outcome.unit(name)
        value, largest = (limit_text(name, number, unit) for number in (found.outcome.value(name), limit))
        write_line(f"  {limit_label(name, found.result.body)}: {value}, limit {largest}{reached}")
    if plot is not None:
        save_picture(found.plot(), plot)
        write_line(f"power and limits drawn to {plot}")


def schema() -> None:
    """Print the JSON Schema of case files, for editors: viscoroll schema > viscoroll.schema.json."""
    from ..case.schema import json_schema

    write_line(json.dumps(json_schema(), indent=2, ensure_ascii=False))


def _write_saved(path: Path) -> None:
    """Print how case files use a saved material, also without an editor."""
    table = f"{{ type = 'measured', file = '{path.name}' }}"
    write_line(f"material: {path}; in a case file, shear_modulus = {table}")
    write_line(f'or: viscoroll solve case.toml --set "ball.layers[0].shear_modulus={table}" (or cylinder, or wheel)')


def _draws(curve: Superposition | Isotherm, fit: PronyFit, count: int) -> Draws[Superposition] | Draws[Prony] | None:
    """Return draws of shift factors and series, or only of the series; None for a count of 0."""
    from ..rheology import Superposition

    if count == 0:
        return None
    return curve.draws(count) if isinstance(curve, Superposition) else fit.draws(count)


def _columns(text: str | None) -> dict[str, str | tuple[str, str]] | None:
    if text is None:
        return None
    columns: dict[str, str | tuple[str, str]] = {}
    for entry in text.split(","):
        role, equals, name = entry.partition("=")
        if not equals:
            raise ValueError(f"--columns must have the form 'frequency=f:Hz,storage=A:MPa', got {entry!r}")
        name, colon, unit = name.rpartition(":")
        columns[role.strip()] = (name, unit) if colon else unit
    return columns


def _reference(data: RheologyData, reference: float | None) -> float:
    if reference is None:
        low, high = data.isotherms[0].temperature, data.isotherms[-1].temperature
        raise ValueError(
            f"--reference must be given for sweeps at several temperatures, from {kelvin_range(low, high)}"
        )
    return reference


def _own_shift(factors: Path | None, wlf: str | None) -> ShiftFactors | WilliamsLandelFerry | None:
    from ..materials import WilliamsLandelFerry
    from ..rheology import ShiftFactors

    if factors is not None and wlf is not None:
        raise ValueError("--wlf must be left out with --factors")
    if wlf is None:
        return None if factors is None else ShiftFactors.read(factors)
    try:
        c1, c2, kelvin = (float(part) for part in wlf.split(","))
    except ValueError:
        raise ValueError(f"--wlf must have the form C1,C2,T_r, such as 17.44,51.6,208, got {wlf!r}") from None
    return WilliamsLandelFerry(c1=c1, c2=c2, reference_temperature=kelvin)


def _write_ramp(ramp: TemperatureRamp, at: float | None, *, wanted: Path | None) -> None:
    """Print the modulus of a temperature ramp at one temperature, for case files, or how to obtain it."""
    if wanted is not None:
        raise ValueError(
            f"{wanted.name} requires a master curve; a temperature ramp at one frequency has one only with a law "
            "of the shift: give --factors or --wlf"
        )
    if at is None:
        write_line(
            "--at gives the modulus for a case file; --factors or --wlf give a master curve with your law of the shift"
        )
        return
    found = ramp.at(temperature=at)
    write_line(
        f"at {kelvin_text(at)}, in a case file: "
        f"shear_modulus = {{ type = 'loss_factor', modulus = {found.modulus:.6g}, "
        f"loss_factor = {found.loss_factor:.6g}, reference_frequency = {found.reference_frequency:.6g} }}"
    )


def _write_modulus(curve: Superposition | Isotherm, temperature: float) -> None:
    from ..rheology import Superposition

    if not isinstance(curve, Superposition):
        raise ValueError("--at must be left out without sweeps at several temperatures")
    table = curve.at(temperature=temperature)
    _write_moduli(table, temperature, table.frequency[1], table.frequency[-1])


def _write_moduli(modulus: ShearModulus, temperature: float, low: float, high: float) -> None:
    """Print a modulus at frequencies of rolling, and which of them are measured, from `low` to `high`."""
    import numpy as np

    omega = np.logspace(-2, 4, 7)
    write_line(f"at {kelvin_text(temperature)}, measured from {low:.3g} to {high:.3g} rad/s:")
    for w, value in zip(omega, modulus.complex_modulus(omega), strict=True):
        held = "" if low <= w <= high else "  (extrapolated)"
        write_line(f"  {w:8g} rad/s  storage {value.real:.4g} Pa  loss {value.imag:.4g} Pa{held}")
