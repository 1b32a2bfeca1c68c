"""Tables of an instrument's file: their columns, their rows of numbers, and the kind of test that they contain."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from .._support.arguments import Floats
from .names import Column

__all__ = ["CREEP", "ONE_FREQUENCY", "RAMP", "RELAXATION", "SWEEP", "Table", "data_sets", "listed"]

#: Relative difference below which two frequencies count as equal: instruments do not hold them more accurately.
ONE_FREQUENCY = 0.01

#: Ratio of the largest to the smallest strain from which on a test at one frequency is an amplitude sweep.
_VARYING_STRAIN = 1.5

#: Range of temperatures from which on a test at one frequency is a temperature ramp [K].
_VARYING_TEMPERATURE = 2.0

#: Relative range within which an instrument holds the strain of a relaxation test or the stress of a creep test.
_HELD_WITHIN = 0.02

#: Kinds of tests.
SWEEP, RAMP, AMPLITUDE = "frequency sweep", "temperature ramp", "amplitude sweep"
CREEP, RELAXATION, FLOW, OTHER = "creep", "stress relaxation", "flow", "unknown test"
AT_REST = "test at one frequency and temperature"

#: Largest number of points of a frequency sweep in which all frequencies are equal. More are another test.
_POINTS_OF_ONE_FREQUENCY = 2

#: Varied column of each kind of test, and the other columns that are read.
_COLUMNS = {
    SWEEP: ("frequency", "temperature"),
    RAMP: ("temperature", "frequency"),
    AMPLITUDE: ("strain", "frequency"),
}

#: Columns that must not be repeated within a data set. Repeated columns of time and strain are not used.
_USED = ("frequency", "temperature", "sweep", "storage", "loss", "tan_delta", "complex", "phase")

#: Pairs of columns that determine the complex modulus.
_MODULI = (("storage", "loss"), ("storage", "tan_delta"), ("complex", "phase"), ("complex", "tan_delta"))


@dataclass(slots=True)
class Table:
    """One data set of a file.

    Attributes
    ----------
    columns : dict of str to Column
        Columns by role.
    header : tuple of str
        Cells of the row of names.
    title : str
        Text in the line above the row of names, such as the name of a step.
    repeated : list of Column
        Columns whose role another column has already.
    rows : list of dict
        Numbers by role; NaN where there is none.
    remark : str
        Remark on the use of the columns.
    shares_rows : bool
        Whether other data sets are in the same rows of the file.
    """

    columns: dict[str, Column]
    header: tuple[str, ...]
    title: str = ""
    repeated: list[Column] = field(default_factory=list)
    rows: list[dict[str, float]] = field(default_factory=list)
    remark: str = ""
    shares_rows: bool = False

    def numbers(self, role: str) -> Floats:
        """Return the numbers of a column as the file contains them; NaN where there is none."""
        return np.array([row.get(role, math.nan) for row in self.rows])

    @property
    def unknown(self) -> tuple[str, ...]:
        """Names of columns without a known role."""
        taken = {column.index for column in [*self.columns.values(), *self.repeated]}
        return tuple(cell for index, cell in enumerate(self.header) if cell and index not in taken)

    @property
    def held_frequency(self) -> float | None:
        """Frequency that the names of the moduli state [Hz]; None without one."""
        return next((column.frequency for column in self.columns.values() if column.frequency), None)

    @property
    def moduli(self) -> tuple[str, str] | None:
        """Roles of the two columns that determine the complex modulus, or None if one is missing."""
        return next((pair for pair in _MODULI if set(pair) <= self.columns.keys()), None)

    @property
    def kind(self) -> str:
        """Kind of test: one of the constants of this module."""
        have = self.columns.keys()
        if not have & {"storage", "complex"}:
            return _kind_over_time(self)
        frequency, strain, temperature = (self._range(role) for role in ("frequency", "strain", "temperature"))
        if frequency[1] > frequency[0] * (1.0 + ONE_FREQUENCY):
            return SWEEP
        is_strain_varied = "strain" in have and strain[1] > _VARYING_STRAIN * strain[0] > 0.0
        is_heated = "temperature" in have and temperature[1] - temperature[0] > _VARYING_TEMPERATURE
        if is_strain_varied and not is_heated:
            return AMPLITUDE
        if "frequency" not in have and self.held_frequency is None:
            return RAMP if "temperature" in have else AMPLITUDE if "strain" in have else OTHER
        if is_heated:
            return RAMP
        return AT_REST if "frequency" in have and len(self.rows) > _POINTS_OF_ONE_FREQUENCY else SWEEP

    def needed(self, kind: str) -> list[str]:
        """Return the roles of the columns in which a row of a test must have numbers."""
        others = [role for role in _COLUMNS[kind] if role in self.columns]
        return [*others, *(self.moduli or ("storage",))]

    def complete(self, kind: str) -> tuple[list[dict[str, float]], int]:
        """Return the rows with all numbers that a test needs, and how many rows lack one."""
        needed = self.needed(kind)
        varied = _COLUMNS[kind][0] if _COLUMNS[kind][0] in self.columns else needed[0]
        rows, incomplete = [], 0
        for row in self.rows:
            missing = [math.isnan(row[role]) for role in needed]
            if not any(missing):
                rows.append(row)
            elif not all(missing) and not math.isnan(row[varied]):
                incomplete += 1
        return rows, incomplete

    def _range(self, role: str) -> tuple[float, float]:
        numbers = self.numbers(role)
        numbers = numbers[np.isfinite(numbers)]
        return (float(numbers.min()), float(numbers.max())) if numbers.size else (math.nan, math.nan)


def _kind_over_time(table: Table) -> str:
    have = table.columns.keys()
    if "compliance" in have:
        return CREEP
    if "relaxation" in have:
        return RELAXATION
    if {"time", "strain", "stress"} <= have:
        return RELAXATION if _is_held(table, "strain") and not _is_held(table, "stress") else CREEP
    if {"time", "stress"} <= have:
        return RELAXATION
    if {"time", "strain"} <= have:
        return CREEP
    return FLOW if "viscosity" in have else OTHER


def _is_held(table: Table, role: str) -> bool:
    """Return whether the quantity of a column is constant, except for the beginning of the test."""
    numbers = np.abs(table.numbers(role))
    numbers = numbers[np.isfinite(numbers)]
    later = numbers[numbers.size // 4 :]
    return bool(later.size > 1 and np.ptp(later) <= _HELD_WITHIN * later.mean())


def data_sets(table: Table) -> list[Table]:
    """Return the data sets of a table that compares several, or has moduli at several frequencies.

    Netzsch's Proteus writes one modulus per frequency, and all columns again for each compared file.

    Raises
    ------
    ValueError
        If columns are repeated that do not form complete data sets.
    """
    moduli = {role for pair in _MODULI for role in pair}
    if not any(column.role in moduli for column in table.repeated):
        _require_single(table)
        return [table]
    everything = sorted([*table.columns.values(), *table.repeated], key=lambda column: column.index)
    everything = [
        replace(column, role="frequency") if column.role == "second_frequency" else column for column in everything
    ]
    shared: dict[str, Column] = {}
    found: list[dict[str, Column]] = []
    for column in everything:
        if column.role not in moduli:
            if found and column.role in shared:  # the next compared file
                shared = {}
            shared[column.role] = column
            continue
        last = found[-1] if found else {}
        same = {c.frequency for c in last.values() if c.role in moduli} == {column.frequency}
        if not same or column.role in last or any(last.get(role) is not one for role, one in shared.items()):
            found.append(dict(shared))
        found[-1][column.role] = column
    if len({frozenset(columns) for columns in found}) > 1 or (
        "storage" in found[0] and len(moduli & found[0].keys()) < 2
    ):
        _require_single(table)
    return [_part(table, columns) for columns in found]


def _require_single(table: Table) -> None:
    """Raise a ValueError if a role that the readers use has two columns."""
    for column in table.repeated:
        if column.role in _USED:
            first = table.columns[column.role]
            raise ValueError(
                f"two columns contain {column.role}, {first.name!r} and {column.name!r}: select one by "
                f'columns={{"{column.role}": name}}'
            )


def _part(table: Table, columns: dict[str, Column]) -> Table:
    names = {column.index: role for role, column in columns.items()}
    rows = [{role: row[f"column {index}"] for index, role in names.items()} for row in table.rows]
    header = tuple(cell if index in names else "" for index, cell in enumerate(table.header))
    return replace(table, columns=columns, header=header, repeated=[], rows=rows, shares_rows=True)


def listed(tables: Sequence[Table]) -> str:
    """Return a list of tables with their numbers, kinds and numbers of points."""
    texts = []
    for number, table in enumerate(tables, 1):
        at = f" at {table.held_frequency:g} Hz" if table.held_frequency else ""
        name = f" ({table.title})" if table.title else ""
        texts.append(f"{number}: {table.kind}{at}{name}, {len(table.rows)} points")
    return "; ".join(texts)
