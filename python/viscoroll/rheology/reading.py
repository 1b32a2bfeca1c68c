"""Measured moduli from files of rheometers and DMA instruments."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats, as_kelvin, as_positive
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput
from .._support.text import one_line, shown
from .file_sets import Files, file_set, read_files
from .formats import read_text
from .ramps import TemperatureRamp
from .reader_arguments import Columns, checked_conversion, named_columns, numbered, tables_of, unread_tables
from .tables import AMPLITUDE, CREEP, ONE_FREQUENCY, RAMP, RELAXATION, SWEEP, Table, listed
from .text import Names, closest_header

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "SWEEP_ROLES",
    "Isotherm",
    "RheologyData",
    "moduli_are_tensile",
    "read_rheology",
]

#: Columns of sweeps that the caller may specify.
SWEEP_ROLES = ("frequency", "storage", "loss", "complex", "tan_delta", "phase", "temperature", "sweep")

#: Gap between temperatures that separates sweeps without sweep numbers [K].
_TEMPERATURE_GAP = 1.0

#: Largest temperature range of an isothermal sweep [K]. Beyond it, the specimen was heated continuously.
_WIDEST_SWEEP = 2.0

#: Round-off of temperature differences [K].
_ROUND_OFF = 1e-9


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Isotherm:
    """Frequency sweep at one temperature.

    Attributes
    ----------
    temperature : float
        Mean temperature [K]; NaN if the file contains none.
    frequency : ndarray
        Angular frequency [rad/s], increasing.
    storage, loss : ndarray
        Shear moduli [Pa], > 0.
    """

    temperature: float
    frequency: Floats
    storage: Floats
    loss: Floats

    def __post_init__(self) -> None:
        """Check that the temperature is in kelvin."""
        if not math.isnan(self.temperature):
            as_kelvin("temperature", self.temperature)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class RheologyData:
    """Measured shear moduli of one file.

    Attributes
    ----------
    isotherms : tuple of Isotherm
        Sweeps in the order of increasing temperature.
    source : str
        Name of the file.
    is_tensile : bool
        Whether the file contains moduli of tension, which were divided by 2 (1 + ν).
    poisson_ratio : float
        Poisson's ratio ν of this conversion [-].
    dropped : int
        Number of points that were omitted because a modulus was not a positive number.
    remarks : tuple of str
        Other remarks about the file.
    """

    isotherms: tuple[Isotherm, ...]
    source: str
    is_tensile: bool
    poisson_ratio: float
    dropped: int
    remarks: tuple[str, ...] = ()

    @property
    def ramp(self) -> TemperatureRamp | None:
        """The measurement as a temperature ramp if all points have the same frequency; otherwise None."""
        frequency = np.concatenate([sweep.frequency for sweep in self.isotherms])
        temperature = np.array([sweep.temperature for sweep in self.isotherms])
        if temperature.size < 2 or np.isnan(temperature).any() or np.ptp(frequency) > ONE_FREQUENCY * frequency[0]:
            return None
        moduli = [
            np.array([np.exp(np.mean(np.log(getattr(sweep, name)))) for sweep in self.isotherms])
            for name in ("storage", "loss")
        ]
        return TemperatureRamp(
            frequency=float(frequency.mean()), temperature=temperature, storage=moduli[0], loss=moduli[1]
        )

    def between(self, lowest: float, highest: float) -> RheologyData:
        """Return the sweeps at temperatures from `lowest` to `highest` [K].

        Raises
        ------
        ValueError
            If there is no sweep in this range.
        """
        low, high = as_kelvin("lowest", lowest), as_kelvin("highest", highest)
        kept = tuple(isotherm for isotherm in self.isotherms if low <= isotherm.temperature <= high)
        if not kept:
            raise InvalidInput("temperatures", "must include a sweep", kelvin_range(low, high))
        return replace(self, isotherms=kept)

    def __repr__(self) -> str:
        """Return file, number of points and sweeps, and ranges."""
        kind = f"tension, divided by 2 (1 + {self.poisson_ratio:g})" if self.is_tensile else "shear"
        end = "; ".join([f"moduli of {kind}; {self.dropped} points dropped", *self.remarks])
        if (ramp := self.ramp) is not None:
            first, *others = repr(ramp).splitlines()
            return "\n".join([f"RheologyData of {self.source}: {first}, {end}", *others])
        points = sum(isotherm.frequency.size for isotherm in self.isotherms)
        low = min(isotherm.frequency[0] for isotherm in self.isotherms)
        high = max(isotherm.frequency[-1] for isotherm in self.isotherms)
        low_t, high_t = self.isotherms[0].temperature, self.isotherms[-1].temperature
        at = "" if math.isnan(low_t) else f" at {kelvin_range(low_t, high_t)}"
        count = len(self.isotherms)
        return (
            f"RheologyData of {self.source}: {points} points in {count} sweep{'s' if count > 1 else ''}{at}, "
            f"{low:.4g} to {high:.4g} rad/s, {end}"
        )


def read_rheology(
    path: Files,
    *,
    columns: Columns | None = None,
    tensile: bool | None = None,
    poisson_ratio: float = 0.5,
    frequency: float | None = None,
    step: int | None = None,
) -> RheologyData:
    """Read frequency sweeps, or temperature ramps, from a text, CSV, Excel or JSON export.

    The reader accepts the names and units that TA's TRIOS ("LIMS" and "Plain Text"), Anton Paar's RheoCompass,
    Netzsch's Proteus, pyvisco and people write, in English, German, French and Japanese: separated by commas,
    semicolons or tabs; in UTF-8, UTF-16, or the Western or Japanese Windows code page; with units in a row of their
    own, beside the names or behind an underscore; with decimal points or commas. It guesses nothing. If the file lacks
    an item, an error names the argument that provides it.

    A file may contain several data sets: steps, compared files, or columns at several frequencies. Frequency sweeps are
    read, or temperature ramps in a file without frequency sweeps. Data sets that are not read are listed in `remarks`.

    Parameters
    ----------
    path : path-like, or mapping of path-like to float
        Path of the file; or several files with the temperature of each [K], which is None if the file contains it, or
        else its name, as ``a_-20C.csv``, ``b_296K.csv`` or ``c 40 degC.xlsx``. A path with wildcards, such as
        ``dma_*C.csv``, means all files that match.
    columns : mapping of str to str or (str, str), optional
        Name of the column, or name and unit, for "frequency", "storage", "loss", "complex" (the absolute value of the
        modulus), "tan_delta", "phase", "temperature" or "sweep". Required only if a name is unknown or a unit is
        missing. Units are mHz, Hz, kHz, rad/s, and 1/s for an angular frequency; Pa, kPa, MPa, GPa; deg, rad; C, K, F.
        Temperatures are converted to K.
    tensile : bool, optional
        Whether the moduli are those of tension, E', E'', or of shear, G', G''. Required if the names do not show it.
    poisson_ratio : float, default 0.5
        Poisson's ratio ν [-], in (-1, 0.5], for the conversion of tensile moduli, G = E / (2 (1 + ν)).
    frequency : float, optional
        Angular frequency of a ramp [rad/s], 2π times the frequency in Hz. Required if the file does not contain the
        frequency.
    step : int, optional
        Number of the data set to be read, from 1. By default all data sets of the kind that is read; required if they
        are compared files or if moduli of several frequencies are given without that of each.

    Returns
    -------
    RheologyData
        Shear moduli over angular frequency, sweep by sweep, at temperatures in K. Points with a modulus that is not
        positive are omitted and counted. If a file has frequency columns in rad/s and in Hz that agree, the one in
        rad/s is used. For a temperature ramp, the attribute `ramp` describes its use.

    Raises
    ------
    ValueError
        If the file has no data set with frequency and moduli, a unit is missing or unknown, two frequency columns
        disagree, or the moduli may be tensile or shear; the message names the argument to pass, or the data sets of
        the file. If one of several files has no temperature, or its name is not clear about it, as ``dma-20C.csv``.
    OSError
        If the file cannot be read.

    Examples
    --------
    Sweeps in several files, at temperatures that only the user knows:

    >>> vr.rheology.read_rheology({"at0.csv": 273.15, "at20.csv": 293.15})  # doctest: +SKIP
    >>> vr.rheology.read_rheology("dma_*C.csv")  # doctest: +SKIP

    >>> import viscoroll as vr
    >>> path = vr.rheology.example_data("pressure_sensitive_adhesive.txt")
    >>> vr.rheology.read_rheology(path, tensile=False)  # doctest: +NORMALIZE_WHITESPACE
    RheologyData of pressure_sensitive_adhesive.txt: 339 points in 20 sweeps at 233.15 to 423.14 K (-40 to 150 °C),
    0.6283 to 125.7 rad/s, moduli of shear; 1 points dropped
    """
    files = file_set(path)
    if isinstance(files, dict):
        read_one = partial(
            read_rheology,
            columns=columns,
            tensile=tensile,
            poisson_ratio=poisson_ratio,
            frequency=frequency,
            step=step,
        )
        return _combined(list(read_files(files, read_one, _at, _lacks_temperature)))
    path = files
    names = named_columns(columns, SWEEP_ROLES)
    nu = checked_conversion(tensile, poisson_ratio)
    held = None if frequency is None else as_positive("frequency", frequency, "rad/s")
    found = tables_of(path, names)
    tables = _chosen(found, step, path)
    if not tables:
        raise ValueError(_nothing_found(path, names, found))
    kind = tables[0].kind
    knows_frequency = any("frequency" in table.columns or table.held_frequency for table in tables)
    if held is not None and knows_frequency:
        raise ValueError(f"{path}: frequency must be left out if the file contains the frequency, got {held:g} rad/s")
    if held is None and not knows_frequency:
        raise ValueError(_no_frequency(path, tables[0]))
    is_tensile = moduli_are_tensile(path, tables) if tensile is None else tensile
    divisor = 2.0 * (1.0 + nu) if is_tensile else 1.0
    isotherms: list[Isotherm] = []
    dropped = 0
    for table in tables:
        rows, incomplete = table.complete(kind)
        if rows:
            read, left_out = _isotherms(table, rows, path, divisor, held)
            isotherms += read
            dropped += left_out
        dropped += incomplete
    if not isotherms:
        raise ValueError(f"{path}: must have points with moduli > 0, got none among {dropped}")
    isotherms.sort(key=lambda isotherm: (isotherm.temperature, isotherm.frequency[0]))
    remarks = [table.remark for table in tables if table.remark]
    remarks += unread_tables(found, tables)
    return RheologyData(
        isotherms=_merged(isotherms),
        source=path.name,
        is_tensile=is_tensile,
        poisson_ratio=nu,
        dropped=dropped,
        remarks=tuple(dict.fromkeys(remarks)),
    )


def _lacks_temperature(data: RheologyData) -> bool:
    return any(math.isnan(sweep.temperature) for sweep in data.isotherms)


def _at(data: RheologyData, temperature: float, remarks: tuple[str, ...]) -> RheologyData:
    """Return a sweep at the temperature of its file."""
    kelvin = as_kelvin("temperature", temperature)
    (first, *others) = data.isotherms
    if others or not (math.isnan(first.temperature) or abs(first.temperature - kelvin) <= _WIDEST_SWEEP):
        low, high = first.temperature, data.isotherms[-1].temperature
        got = f"{kelvin_text(kelvin)} for {len(others) + 1} sweeps at {kelvin_range(low, high)}"
        raise InvalidInput("temperature", f"must be that of the sweep in {data.source}", got)
    return replace(data, isotherms=(replace(first, temperature=kelvin),), remarks=data.remarks + remarks)


def _combined(parts: list[RheologyData]) -> RheologyData:
    """Return the sweeps of several files as those of one."""
    if len({part.is_tensile for part in parts}) > 1:
        kinds = ", ".join(f"{part.source}: {'tension' if part.is_tensile else 'shear'}" for part in parts)
        raise InvalidInput("path", "must contain moduli of tension in all files or of shear in all files", kinds)
    return replace(
        parts[0],
        isotherms=tuple(sorted((one for part in parts for one in part.isotherms), key=lambda one: one.temperature)),
        source=", ".join(part.source for part in parts),
        dropped=sum(part.dropped for part in parts),
        remarks=tuple(f"{part.source}: {remark}" for part in parts for remark in part.remarks),
    )


def _chosen(found: Sequence[Table], step: int | None, path: Path) -> list[Table]:
    """Return the data sets to be read: the one with a number, or all frequency sweeps, or else all ramps."""
    if step is not None:
        table = numbered(found, step)
        if table.kind not in (SWEEP, RAMP):
            raise InvalidInput("step", f"must be a frequency sweep or a temperature ramp of {path}", listed(found))
        return [table]
    tables: list[Table] = next(
        (chosen for kind in (SWEEP, RAMP) if (chosen := [table for table in found if table.kind == kind])), []
    )
    compared = [table.held_frequency for table in tables if table.shares_rows]
    if len(compared) > len(set(compared)):
        raise InvalidInput("step", f"must be given for {path}, which contains several data sets", listed(found))
    return tables


def _merged(isotherms: list[Isotherm]) -> tuple[Isotherm, ...]:
    """Return sweeps in which those at one temperature from columns of different frequencies are joined."""
    joined: list[Isotherm] = []
    for isotherm in isotherms:
        last = joined[-1] if joined else None
        if last is not None and last.temperature == isotherm.temperature and _are_columns(last, isotherm):
            order = np.argsort(np.concatenate([last.frequency, isotherm.frequency]), kind="stable")
            frequency, storage, loss = (
                np.concatenate([getattr(last, name), getattr(isotherm, name)])[order]
                for name in ("frequency", "storage", "loss")
            )
            joined[-1] = replace(last, frequency=frequency, storage=storage, loss=loss)
        else:
            joined.append(isotherm)
    return tuple(joined)


def _are_columns(first: Isotherm, second: Isotherm) -> bool:
    """Return whether two sweeps are points of one ramp at different frequencies."""
    return second.frequency.size == 1 and not (first.frequency == second.frequency[0]).any()


def _nothing_found(path: Path, names: Names, found: Sequence[Table]) -> str:
    if found:
        readers = {
            "read_strain_sweep reads amplitude sweeps": {AMPLITUDE},
            "read_time_tests reads stress relaxation and creep": {CREEP, RELAXATION},
        }
        kinds = {one.kind for one in found}
        other = "".join(f"; {text}" for text, readable in readers.items() if kinds & readable)
        return f"{path}: must contain a frequency sweep or a temperature ramp, got {listed(found)}{other}"
    text = read_text(path)
    header = closest_header(text, names)
    lines = [line for line in text.splitlines() if line.strip()]
    got = f"the names {', '.join(map(repr, header))}" if len(header) > 1 else shown((lines or [""])[0][:80])
    rule = f"{path}: must have a header with a frequency and a storage modulus, and rows of numbers below it, "
    if re.match(r"\s*[-+.]?\d", (lines or [""])[0]):
        advice = "add names and units as a first line, such as Frequency (Hz),E' (MPa),E'' (MPa)"
    else:
        advice = (
            'pass columns={"frequency": (name, unit), "storage": (name, unit), ...}, '
            "in the shell --columns frequency=name:unit,storage=name:unit,..."
        )
    return f"{rule}got {one_line(got)}; {advice}"


def _no_frequency(path: Path, table: Table) -> str:
    unknown = ", ".join(shown(name) for name in table.unknown)
    other = f'; or columns={{"frequency": (name, unit)}}, in the shell --columns, if it is one of {unknown}'
    return (
        f"{path}: has moduli over temperature without a frequency column, as in a ramp at one frequency: pass "
        f"frequency=... in rad/s (2 pi times the value in Hz), in the shell --frequency{other if unknown else ''}"
    )


def moduli_are_tensile(path: Path, tables: list[Table]) -> bool:
    """Return whether the column names denote tensile moduli; raise a ValueError if they do not show it."""
    columns = [table.columns.get("storage") or table.columns["complex"] for table in tables]
    said = {column.is_tensile for column in columns}
    if said <= {True, False} and len(said) == 1:
        return bool(said.pop())
    name = columns[0].name
    raise ValueError(
        f"{path}: column {name!r} may be a tensile or a shear modulus: "
        "pass tensile=True or tensile=False, in the shell --tensile or --shear"
    )


def _isotherms(
    table: Table, rows: list[dict[str, float]], path: Path, divisor: float, held: float | None
) -> tuple[list[Isotherm], int]:
    columns = table.columns
    values: dict[str, Floats] = {}
    for role in ("frequency", "temperature"):
        if role in columns:
            values[role] = columns[role].converted([row[role] for row in rows], path)
    values["storage"], values["loss"] = moduli_of(table, rows, path)
    if "frequency" not in values:
        one = 2.0 * math.pi * table.held_frequency if table.held_frequency else held
        values["frequency"] = np.full(len(rows), one)
    valid = (values["frequency"] > 0.0) & (values["storage"] > 0.0) & (values["loss"] > 0.0)
    temperature = values.get("temperature", np.full(valid.size, np.nan))
    numbers = np.array([row.get("sweep", math.nan) for row in rows])
    sweeps = _grouped(numbers, temperature, values["frequency"])
    isotherms = []
    for sweep in np.unique(sweeps[valid]):
        chosen = np.flatnonzero(valid & (sweeps == sweep))
        order = chosen[np.argsort(values["frequency"][chosen], kind="stable")]
        mean = float(np.mean(temperature[order]))
        if not math.isnan(mean):
            column = columns["temperature"]
            as_kelvin(f"{path}: column {column.name!r} with the unit {column.unit!r}", mean)
        isotherms.append(
            Isotherm(
                temperature=mean,
                frequency=values["frequency"][order],
                storage=values["storage"][order] / divisor,
                loss=values["loss"][order] / divisor,
            )
        )
    return isotherms, int((~valid).sum())


def moduli_of(table: Table, rows: list[dict[str, float]], path: Path) -> tuple[Floats, Floats]:
    """Return the storage and the loss moduli of rows [Pa]: from two moduli, or from one and tan δ or the phase angle.

    Raises
    ------
    ValueError
        If the columns do not determine both, or a unit is missing or unknown.
    """
    if table.moduli is None:
        raise ValueError(f"{path}: must have a column of the loss modulus or of tan δ besides the storage modulus")
    modulus, other = table.moduli
    first = table.columns[modulus].converted([row[modulus] for row in rows], path)
    numbers = [row[other] for row in rows]
    if other == "loss":
        return first, table.columns[other].converted(numbers, path)
    if other == "tan_delta":
        tangent = table.columns[other].plain(numbers, path)
        storage = first / np.sqrt(1.0 + tangent**2) if modulus == "complex" else first
        return storage, storage * tangent
    phase = table.columns[other].converted(numbers, path)
    return first * np.cos(phase), first * np.sin(phase)


def _grouped(numbers: Floats, temperature: Floats, frequency: Floats) -> NDArray[np.int64]:
    """Return the sweep number of each row: from the sweep column, or from gaps between temperatures."""
    if not np.isnan(numbers).any():
        return np.unique(numbers, return_inverse=True)[1].astype(np.int64)
    order = np.argsort(temperature, kind="stable")
    steps = np.diff(temperature[order], prepend=temperature[order[0]] if order.size else np.nan)
    starts = steps > _TEMPERATURE_GAP + _ROUND_OFF
    for group in np.split(np.arange(order.size), np.flatnonzero(starts)):
        if group.size and temperature[order[group[-1]]] - temperature[order[group[0]]] > _WIDEST_SWEEP + _ROUND_OFF:
            starts[group] |= _returns(frequency[order[group]])
    groups = np.zeros(temperature.size, dtype=np.int64)
    groups[order] = np.cumsum(starts)
    return groups


def _returns(frequency: Floats) -> NDArray[np.bool_]:
    """Return where a frequency repeats one since the last such point, as during continuous heating."""
    starts = np.zeros(frequency.size, dtype=np.bool_)
    since = 0
    for place, value in enumerate(frequency):
        if np.any(np.abs(frequency[since:place] / value - 1.0) <= ONE_FREQUENCY):
            starts[place], since = True, place
    return starts
