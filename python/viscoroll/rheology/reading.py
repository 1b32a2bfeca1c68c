"""Measured moduli from files of rheometers and DMA instruments."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .._support.arguments import Floats, as_float, as_kelvin
from .._support.celsius import kelvin_range
from .._support.errors import InvalidInput, InvalidType, in_file
from .._support.text import shown
from .names import role_of
from .ramps import TemperatureRamp
from .text import Table, find_tables, read_text

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Columns", "Isotherm", "RheologyData", "moduli_are_tensile", "named_columns", "read_rheology"]

_ROLES = ("frequency", "storage", "loss", "tan_delta", "temperature", "sweep")

#: Gap between temperatures that separates sweeps without sweep numbers [K].
_TEMPERATURE_GAP = 1.0

#: Largest temperature range of an isothermal sweep [K]. Beyond it, the specimen was heated continuously.
_WIDEST_SWEEP = 2.0

#: Round-off of temperature differences [K].
_ROUND_OFF = 1e-9

#: Relative difference below which two frequencies count as equal: instruments do not hold them more accurately.
_ONE_FREQUENCY = 0.01

Columns: TypeAlias = Mapping[str, "str | tuple[str, str]"]


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
        if temperature.size < 2 or np.isnan(temperature).any() or np.ptp(frequency) > _ONE_FREQUENCY * frequency[0]:
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
        return (
            f"RheologyData of {self.source}: {points} points in {len(self.isotherms)} sweeps{at}, "
            f"{low:.4g} to {high:.4g} rad/s, {end}"
        )


def read_rheology(
    path: str | Path,
    *,
    columns: Columns | None = None,
    tensile: bool | None = None,
    poisson_ratio: float = 0.5,
    frequency: float | None = None,
) -> RheologyData:
    """Read frequency sweeps, or a temperature ramp at one frequency, from a text or CSV export.

    The reader accepts the names and units that TA's TRIOS ("LIMS" and "Plain Text"), Anton Paar's RheoCompass,
    Netzsch's Proteus, pyvisco and people write: separated by commas, semicolons or tabs; in UTF-8, UTF-16 or the
    Windows code page; with units in a row of their own or beside the names; with decimal points or commas. It guesses
    nothing. If the file lacks an item, an error names the argument that provides it.

    Parameters
    ----------
    path : path-like
        Path of the file.
    columns : mapping of str to str or (str, str), optional
        Name of the column, or name and unit, for "frequency", "storage", "loss", "tan_delta", "temperature" or "sweep".
        Required only if a name is unknown or a unit is missing. Units are mHz, Hz, kHz, rad/s; Pa, kPa, MPa, GPa; C, K,
        F. Temperatures are converted to K.
    tensile : bool, optional
        Whether the moduli are those of tension, E', E'', or of shear, G', G''. Required if the names do not show it.
    poisson_ratio : float, default 0.5
        Poisson's ratio ν [-], in (-1, 0.5], for the conversion of tensile moduli, G = E / (2 (1 + ν)).
    frequency : float, optional
        Angular frequency of a ramp [rad/s], 2π times the frequency in Hz. Required if the file has no frequency column.

    Returns
    -------
    RheologyData
        Shear moduli over angular frequency, sweep by sweep, at temperatures in K. Points with a modulus that is not
        positive are omitted and counted. If a file has frequency columns in rad/s and in Hz that agree, the one in
        rad/s is used. For a temperature ramp, the attribute `ramp` describes its use.

    Raises
    ------
    ValueError
        If the file has no table with frequency and moduli, a unit is missing or unknown, two frequency columns
        disagree, or the moduli may be tensile or shear; the message names the argument to pass.
    OSError
        If the file cannot be read.

    Examples
    --------
    >>> import viscoroll as vr
    >>> path = vr.rheology.example_data("pressure_sensitive_adhesive.txt")
    >>> vr.rheology.read_rheology(path, tensile=False)  # doctest: +NORMALIZE_WHITESPACE
    RheologyData of pressure_sensitive_adhesive.txt: 339 points in 20 sweeps at 233.15 to 423.14 K (-40 to 150 °C),
    0.6283 to 125.7 rad/s, moduli of shear; 1 points dropped
    """
    path = Path(path)
    names = named_columns(columns, _ROLES)
    nu = as_float("poisson_ratio", poisson_ratio)
    if not -1.0 < nu <= 0.5:
        raise InvalidInput("poisson_ratio", "must be in (-1, 0.5]", f"{nu!r}")
    if tensile is not None and not isinstance(tensile, bool):
        raise InvalidType("tensile", "must be True, False or None", shown(tensile))
    held = None if frequency is None else as_float("frequency", frequency)
    if held is not None and not 0.0 < held < math.inf:
        raise InvalidInput("frequency", "must be > 0 rad/s and finite", repr(held))
    text = read_text(path)
    try:
        tables = find_tables(text, names, over="frequency" if held is None else "temperature")
    except ValueError as error:
        raise in_file(error, path) from None
    if not tables:
        raise ValueError(_nothing_found(path, text, names))
    if held is not None and any("frequency" in table.columns for table in tables):
        raise ValueError(f"{path}: frequency must be left out if the file has a frequency column, got {held:g} rad/s")
    is_tensile = moduli_are_tensile(path, tables) if tensile is None else tensile
    divisor = 2.0 * (1.0 + nu) if is_tensile else 1.0
    isotherms: list[Isotherm] = []
    dropped = 0
    for table in tables:
        found, left_out = _isotherms(table, path, divisor, held)
        isotherms += found
        dropped += left_out + table.unreadable
    if not isotherms:
        raise ValueError(f"{path}: must have points with moduli > 0, got none among {dropped}")
    isotherms.sort(key=lambda isotherm: (isotherm.temperature, isotherm.frequency[0]))
    return RheologyData(
        isotherms=tuple(isotherms),
        source=path.name,
        is_tensile=is_tensile,
        poisson_ratio=nu,
        dropped=dropped,
        remarks=tuple(dict.fromkeys(table.remark for table in tables if table.remark)),
    )


def named_columns(columns: Columns | None, roles: Sequence[str]) -> dict[str, tuple[str, str | None]]:
    """Return names and units of the columns that the caller specifies, after a check of their roles.

    Raises
    ------
    ValueError, TypeError
        If a role is unknown, or a value is neither a name nor a pair of name and unit.
    """
    names: dict[str, tuple[str, str | None]] = {}
    for role, value in (columns or {}).items():
        if role not in roles:
            raise InvalidInput("columns", f"must have keys from {', '.join(roles)}", repr(role))
        pair = (value, None) if isinstance(value, str) else value
        if (
            not isinstance(pair, tuple | list)
            or len(pair) != 2
            or not isinstance(pair[0], str)
            or not isinstance(pair[1], str | None)
        ):
            raise InvalidType(f"columns[{role!r}]", "must be a name, or a name and a unit", shown(value))
        names[role] = (pair[0], pair[1])
    return names


def _nothing_found(path: Path, text: str, names: Mapping[str, tuple[str, str | None]]) -> str:
    if ramps := find_tables(text, names, over="temperature"):
        unknown = ", ".join(shown(name) for name in ramps[0].unknown)
        other = f'; or columns={{"frequency": (name, unit)}}, in the shell --columns, if it is one of {unknown}'
        return (
            f"{path}: has moduli over temperature without a frequency column, as in a ramp at one frequency: pass "
            f"frequency=... in rad/s (2 pi times the value in Hz), in the shell --frequency{other if unknown else ''}"
        )
    lines = [line for line in text.splitlines() if line.strip()]
    first = next((line for line in lines if any(role_of(cell) for cell in line.replace(";", ",").split(","))), None)
    line = first or (lines[0] if lines else "")
    return (
        f"{path}: must have a header with a frequency and a storage modulus, and rows of numbers below it, "
        f'got {shown(line[:80])}; pass columns={{"frequency": (name, unit), "storage": (name, unit), ...}}, '
        "in the shell --columns frequency=name:unit,storage=name:unit,..."
    )


def moduli_are_tensile(path: Path, tables: list[Table]) -> bool:
    """Return whether the column names denote tensile moduli; raise a ValueError if they do not show it."""
    said = {table.columns["storage"].is_tensile for table in tables}
    if said <= {True, False} and len(said) == 1:
        return bool(said.pop())
    name = tables[0].columns["storage"].name
    raise ValueError(
        f"{path}: column {name!r} may be a tensile or a shear modulus: "
        "pass tensile=True or tensile=False, in the shell --tensile or --shear"
    )


def _isotherms(table: Table, path: Path, divisor: float, held: float | None) -> tuple[list[Isotherm], int]:
    columns = table.columns
    values = {
        role: column.converted([row[role] for row in table.rows], path)
        for role, column in columns.items()
        if role not in ("sweep", "tan_delta") and not (role == "temperature" and not column.unit)
    }
    if "temperature" in columns and not columns["temperature"].unit:
        values["temperature"] = columns["temperature"].converted([], path)  # raises an error: the unit is missing
    if "loss" not in values:
        if "tan_delta" not in columns:
            raise ValueError(f"{path}: must have a column of the loss modulus or of tan δ besides the storage modulus")
        tan_delta = table.columns["tan_delta"].plain([row["tan_delta"] for row in table.rows], path)
        values["loss"] = values["storage"] * tan_delta
    if held is not None:
        values["frequency"] = np.full(values["storage"].size, held)
    valid = (values["frequency"] > 0.0) & (values["storage"] > 0.0) & (values["loss"] > 0.0)
    temperature = values.get("temperature", np.full(valid.size, np.nan))
    numbers = np.array([row.get("sweep", math.nan) for row in table.rows])
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
        if np.any(np.abs(frequency[since:place] / value - 1.0) <= _ONE_FREQUENCY):
            starts[place], since = True, place
    return starts
