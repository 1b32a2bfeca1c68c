"""Stress relaxation and creep from files of rheometers and DMA instruments."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Literal

import numpy as np

from .._support.arguments import Floats, as_kelvin
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput, in_file
from .._support.text import shown
from .file_sets import Files, file_set, read_files
from .reader_arguments import Columns, checked_conversion, named_columns, numbered, tables_of, unread_tables
from .reading import SWEEP_ROLES
from .tables import CREEP, RAMP, RELAXATION, SWEEP, Table, listed

__all__ = ["TIME_ROLES", "TimeData", "TimeTest", "contains_time_tests", "read_time_tests"]

#: Columns of tests over time that the caller may specify.
TIME_ROLES = ("time", "relaxation", "compliance", "stress", "strain", "temperature")

#: Largest range of temperatures of an isothermal test [K].
_WIDEST_TEST = 2.0

Kind = Literal["relaxation", "creep"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class TimeTest:
    """Stress relaxation at a constant strain, or creep at a constant stress, at one temperature.

    Parameters
    ----------
    kind : {"relaxation", "creep"}
        Type of the test.
    time : array_like
        Time t since the step of strain or stress [s], > 0, at least three points, increasing.
    modulus : array_like
        Shear modulus [Pa], > 0: G(t) of a relaxation test, or 1/J(t) of a creep test with the compliance J(t).
    temperature : float, default nan
        Temperature [K]; NaN if it is unknown.

    Raises
    ------
    TypeError, ValueError
        If a value has the wrong type or is out of range.
    """

    kind: Kind
    time: Floats
    modulus: Floats
    temperature: float = math.nan

    def __post_init__(self) -> None:
        """Check the columns."""
        if self.kind not in ("relaxation", "creep"):
            raise InvalidInput("kind", "must be 'relaxation' or 'creep'", shown(self.kind))
        for name in ("time", "modulus"):
            column = np.asarray(getattr(self, name), dtype=np.float64)
            if column.ndim != 1 or column.size < 3:
                raise InvalidInput(name, "must be one-dimensional with at least 3 points", f"the shape {column.shape}")
            if not ((column > 0.0) & np.isfinite(column)).all():
                raise InvalidInput(name, f"must be > 0 {'s' if name == 'time' else 'Pa'} and finite")
            object.__setattr__(self, name, column)
        if self.time.shape != self.modulus.shape:
            raise InvalidInput("modulus", f"must have as many points as time, {self.time.size}", self.modulus.size)
        if not (np.diff(self.time) > 0.0).all():
            raise InvalidInput("time", "must increase from point to point")
        if not math.isnan(self.temperature):
            as_kelvin("temperature", self.temperature)

    def __repr__(self) -> str:
        """Return kind, number of points, temperature and range of times."""
        at = "" if math.isnan(self.temperature) else f" at {kelvin_text(self.temperature)}"
        name = "stress relaxation" if self.kind == "relaxation" else "creep"
        return f"TimeTest: {name}{at}, {self.time.size} points, {self.time[0]:.4g} to {self.time[-1]:.4g} s"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class TimeData:
    """Relaxation and creep tests of one file or of several.

    Attributes
    ----------
    tests : tuple of TimeTest
        Tests in the order of increasing temperature.
    source : str
        Name of the file.
    is_tensile : bool
        Whether the file contains moduli or compliances of tension, which were converted to those of shear.
    poisson_ratio : float
        Poisson's ratio ν of this conversion [-].
    dropped : int
        Number of points that were omitted because a time, a modulus or a compliance was not positive.
    remarks : tuple of str
        Other remarks about the file.
    """

    tests: tuple[TimeTest, ...]
    source: str
    is_tensile: bool
    poisson_ratio: float
    dropped: int
    remarks: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """Return file, tests and remarks."""
        kind = f"tension, converted with Poisson's ratio {self.poisson_ratio:g}" if self.is_tensile else "shear"
        end = "; ".join([f"{kind}; {self.dropped} points dropped", *self.remarks])
        tests = [repr(test).removeprefix("TimeTest: ") for test in self.tests]
        return "\n  ".join([f"TimeData of {self.source}: {len(self.tests)} tests, {end}", *tests])


def read_time_tests(
    path: Files,
    *,
    columns: Columns | None = None,
    tensile: bool | None = None,
    poisson_ratio: float = 0.5,
    step: int | None = None,
) -> TimeData:
    """Read stress relaxation and creep over time, in the formats of `read_rheology`.

    A relaxation test has columns of time and of the relaxation modulus G(t) or E(t), or of stress and strain. A creep
    test has columns of time and of the compliance J(t) or D(t), or of strain and stress.

    Parameters
    ----------
    path : path-like, or mapping of path-like to float
        Path of the file, several files with temperatures [K], or a path with wildcards, as in `read_rheology`.
    columns : mapping of str to str or (str, str), optional
        Name of the column, or name and unit, for "time", "relaxation", "compliance", "stress", "strain" or
        "temperature". Required only if a name is unknown or a unit is missing. Units are ms, s, min, h, d; Pa to GPa;
        1/Pa to 1/GPa, m2/N; % and 1; C, K, F.
    tensile : bool, optional
        Whether the tests are tension (or compression) or shear. Required if the names do not show it.
    poisson_ratio : float, default 0.5
        Poisson's ratio ν [-], in (-1, 0.5], for the conversion of tension to shear, G = E / (2 (1 + ν)).
    step : int, optional
        Number of the data set to be read, from 1. By default all relaxation and creep tests.

    Returns
    -------
    TimeData
        Tests with shear moduli, G(t) or 1/J(t). Points whose time, modulus or compliance is not positive are omitted
        and counted.

    Raises
    ------
    ValueError
        If the file has no such test, a column or its unit is missing, or the tests may be tension or shear.
    OSError
        If the file cannot be read.

    Notes
    -----
    The time counts from an instantaneous step. A real step takes a rise time: omit times below ten times the rise time.
    """
    files = file_set(path)
    if isinstance(files, dict):
        read_one = partial(read_time_tests, columns=columns, tensile=tensile, poisson_ratio=poisson_ratio, step=step)
        return _combined(list(read_files(files, read_one, _at, _lacks_temperature)))
    path = files
    names = named_columns(columns, TIME_ROLES)
    nu = checked_conversion(tensile, poisson_ratio)
    found = tables_of(path, names)
    tables = _chosen(found, step, path)
    is_tensile = _are_tensile(path, tables) if tensile is None else tensile
    divisor = 2.0 * (1.0 + nu) if is_tensile else 1.0
    tests, dropped = [], 0
    for table in tables:
        read, left_out = _tests(table, path, divisor)
        tests += read
        dropped += left_out
    if not tests:
        value = "compliance" if tables[0].kind == CREEP else "modulus"
        raise ValueError(
            f"{path}: {tables[0].kind} must have at least 3 points with time and {value} > 0, "
            f"got none: all {dropped} points were dropped because time or {value} is missing or not positive"
        )
    return TimeData(
        tests=_sorted(tests),
        source=path.name,
        is_tensile=is_tensile,
        poisson_ratio=nu,
        dropped=dropped,
        remarks=tuple(unread_tables(found, tables)),
    )


def contains_time_tests(path: str | Path, *, columns: Columns | None = None, step: int | None = None) -> bool:
    """Return whether a file contains relaxation or creep tests, but no sweeps, or whether its data set `step` is one.

    Errors are the same as in `read_time_tests`, but any file without a table is one without tests.
    """
    names = named_columns(columns, (*TIME_ROLES, *SWEEP_ROLES))
    kinds = [table.kind for table in tables_of(Path(path), names)]
    if step is not None:
        kinds = kinds[step - 1 : step]
    return not {SWEEP, RAMP} & set(kinds) and bool({CREEP, RELAXATION} & set(kinds))


def _sorted(tests: list[TimeTest]) -> tuple[TimeTest, ...]:
    return tuple(sorted(tests, key=lambda test: (math.isnan(test.temperature), test.temperature, test.time[0])))


def _chosen(found: list[Table], step: int | None, path: Path) -> list[Table]:
    """Return the data sets to be read: the one with a number, or all relaxation and creep tests."""
    chosen = found if step is None else [numbered(found, step)]
    tables = [table for table in chosen if table.kind in (CREEP, RELAXATION)]
    if not tables:
        other = f"got {listed(chosen)}; read_rheology reads sweeps" if chosen else "got no table that is understood"
        raise ValueError(
            f"{path}: must contain stress relaxation or creep over time, {other}; "
            'pass columns={"time": (name, unit), "relaxation": (name, unit)} if the names are unknown'
        )
    for table in tables:
        value = "compliance" if table.kind == CREEP else "relaxation"
        used = {"time", value} if value in table.columns else {"time", "stress", "strain"}
        if missing := sorted(used - table.columns.keys()):
            header = ", ".join(repr(cell) for cell in table.header if cell)
            raise ValueError(
                f"{path}: {table.kind} must have columns of time and {value}, or of time, stress and strain, "
                f"got no column of {' and '.join(missing)} among {header}; "
                f'pass columns={{"{missing[0]}": (name, unit)}}, in the shell --columns {missing[0]}=name:unit'
            )
        for column in table.repeated:
            if column.role in used:
                first = table.columns[column.role].name
                raise ValueError(
                    f"{path}: two columns contain {column.role}, {first!r} and {column.name!r}: select one by "
                    f'columns={{"{column.role}": name}}'
                )
    return tables


def _are_tensile(path: Path, tables: list[Table]) -> bool:
    """Return whether the column names denote tension; raise a ValueError if they do not show it."""
    roles = ("relaxation", "compliance", "stress", "strain")
    said = {
        next((kind for role in roles if role in table.columns and (kind := table.columns[role].is_tensile) is not None),
             None)
        for table in tables
    }  # fmt: skip
    if said in ({True}, {False}):
        return bool(said.pop())
    role = next(role for role in roles if role in tables[0].columns)
    raise ValueError(
        f"{path}: column {tables[0].columns[role].name!r} may be that of tension or shear: "
        "pass tensile=True or tensile=False, in the shell --tensile or --shear"
    )


def _tests(table: Table, path: Path, divisor: float) -> tuple[list[TimeTest], int]:
    """Return the tests of a table, one for each temperature, and the number of points that were omitted."""
    columns = table.columns
    is_creep = table.kind == CREEP
    value = "compliance" if is_creep else "relaxation"
    roles = ["time", *([value] if value in columns else ["stress", "strain"])]
    roles += ["temperature"] if "temperature" in columns else []
    rows = [row for row in table.rows if not any(math.isnan(row[role]) for role in roles)]
    incomplete = len([row for row in table.rows if not math.isnan(row["time"])]) - len(rows)
    if not rows:
        raise ValueError(f"{path}: {table.kind} must have rows with numbers of {', '.join(roles)}, got none")
    values = {role: columns[role].converted([row[role] for row in rows], path) for role in roles}
    with np.errstate(divide="ignore", invalid="ignore"):
        if value not in columns:
            modulus = values["stress"] / values["strain"]
        else:
            modulus = 1.0 / values[value] if is_creep else values[value]
    time = values["time"]
    valid = (time > 0.0) & (modulus > 0.0) & np.isfinite(modulus)
    temperature = values.get("temperature", np.full(time.size, math.nan))
    tests: list[TimeTest] = []
    for part in _parts(time, np.flatnonzero(valid)):
        mean = float(temperature[part].mean())
        if np.ptp(temperature[part]) > _WIDEST_TEST:
            between = kelvin_range(float(temperature[part].min()), float(temperature[part].max()))
            raise ValueError(f"{path}: {table.kind} must be isothermal within {_WIDEST_TEST:g} K, got {between}")
        try:
            tests.append(
                TimeTest(
                    kind="creep" if is_creep else "relaxation",
                    time=time[part],
                    modulus=modulus[part] / divisor,
                    temperature=mean,
                )
            )
        except ValueError as error:
            raise in_file(error, path) from None
    return tests, incomplete + int((~valid).sum())


def _parts(time: Floats, rows: np.ndarray) -> list[np.ndarray]:
    """Return the rows of each test: the next one begins where the time returns."""
    starts = np.flatnonzero(np.diff(time[rows]) < 0.0) + 1
    return [part for part in np.split(rows, starts) if part.size]


def _lacks_temperature(data: TimeData) -> bool:
    return any(math.isnan(test.temperature) for test in data.tests)


def _at(data: TimeData, temperature: float, remarks: tuple[str, ...]) -> TimeData:
    """Return tests at the temperature of their file."""
    kelvin = as_kelvin("temperature", temperature)
    for test in data.tests:
        if abs(test.temperature - kelvin) > _WIDEST_TEST:
            got = f"{kelvin_text(kelvin)} for a test at {kelvin_text(test.temperature)}"
            raise InvalidInput("temperature", f"must be that of the tests in {data.source}", got)
    tests = tuple(replace(test, temperature=kelvin) for test in data.tests)
    return replace(data, tests=tests, remarks=data.remarks + remarks)


def _combined(parts: list[TimeData]) -> TimeData:
    """Return the tests of several files as those of one."""
    return replace(
        parts[0],
        tests=_sorted([test for part in parts for test in part.tests]),
        source=", ".join(part.source for part in parts),
        is_tensile=any(part.is_tensile for part in parts),
        dropped=sum(part.dropped for part in parts),
        remarks=tuple(f"{part.source}: {remark}" for part in parts for remark in part.remarks),
    )
