"""Measured materials in TOML files, which case files name."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .._core import Extrapolation
from .._support.files import ending_in
from .._support.text import one_line, shown
from ..materials import Draws, MasterCurve, Prony
from .prony_fit import PronyFit, fit_prony
from .shift_laws import ShiftFactors
from .superposition import Superposition
from .tabulated import tabulated

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .reading import Isotherm

__all__ = ["load_material", "save_material"]

Form = Literal["table", "prony"]


def save_material(
    path: str | Path,
    curve: Superposition | Isotherm,
    *,
    fit: PronyFit | None = None,
    draws: Draws[Superposition] | Draws[Prony] | None = None,
) -> None:
    """Write a measured material to a TOML file that `load_material` and case files read.

    Parameters
    ----------
    path : path-like
        The file, ending in .toml.
    curve : Superposition or Isotherm
        The modulus; of a superposition the shift factors are kept, too, for other temperatures.
    fit : PronyFit, optional
        A Prony series of the same curve, to be kept beside the table.
    draws : Draws, optional
        Of the superposition or of the fit, to be kept beside it; of a superposition with their own shift factors.

    Raises
    ------
    ValueError
        For another suffix, and for draws without a fit.
    """
    path = ending_in([".toml"], path)
    table = curve.curve if isinstance(curve, Superposition) else _table_of(curve)
    reference = curve.reference if isinstance(curve, Superposition) else curve.temperature
    lines = [
        "# Shear moduli measured, as viscoroll reads them. Frequencies in rad/s, moduli in Pa, temperatures in °C."
    ]
    if isinstance(curve, Superposition):
        lines.append(f"source = {_quoted(curve.data.source)}")
    if not np.isnan(reference):
        lines.append(f"reference_temperature = {reference!r}")
    lines += ["", "[table]", *_columns(table, ("frequency", "storage", "loss"))]
    if fit is not None:
        lines += ["", "[prony]", f"instantaneous_modulus = {fit.series.instantaneous_modulus!r}"]
        lines += _columns(fit.series, ("weights", "relaxation_times"))
    if draws is not None:
        if fit is None:
            raise ValueError("fit must be given with draws: they are series")
        lines += ["", "[draws]", *_rows_of_draws(draws)]
    if isinstance(curve, Superposition):
        lines += ["", f"# {curve.law}", "[shift]", *_columns(curve.factors, ("temperature", "log10_factor"))]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def load_material(
    path: str | Path, *, temperature: float | None = None, form: Form = "table", draw: int | None = None
) -> MasterCurve | Prony:
    """Read a measured material.

    Parameters
    ----------
    path : path-like
        A file written by `save_material`, or by `viscoroll material`.
    temperature : float, optional
        [°C], among those that were measured; by default that of the file's curve.
    form : {"table", "prony"}
        The measured table itself, with its end values held, or the Prony series that smooths it.
    draw : int, optional
        Number of one of the draws that the file keeps, from 0, in place of its Prony series.

    Returns
    -------
    MasterCurve or Prony
        The shear modulus at that temperature.

    Raises
    ------
    ValueError
        Where the file is no material, has no series or no shift factors, or was not measured at that temperature.
    OSError
        Where it cannot be read.
    """
    path = Path(path)
    try:
        document = tomllib.loads(path.read_text(encoding="utf-8-sig"))
        return _material(document, temperature, form) if draw is None else _draw(document, temperature, form, draw)
    except (TypeError, ValueError) as error:
        raise ValueError(one_line(f"material {path}: {error}")) from None


def _table_of(curve: Isotherm) -> MasterCurve:
    return tabulated(curve.frequency, curve.storage, curve.loss, relaxed=fit_prony(curve).relaxed_modulus)


def _material(document: dict[str, Any], temperature: float | None, form: Form) -> MasterCurve | Prony:
    scale = 10.0 ** _shift(document, temperature)
    if form == "prony":
        series = _part(document, "prony", "save it with a fit")
        times = np.asarray(series["relaxation_times"], dtype=float) * scale
        return Prony(
            instantaneous_modulus=series["instantaneous_modulus"], weights=series["weights"], relaxation_times=times
        )
    if form != "table":
        raise ValueError(f"form must be 'table' or 'prony', got {shown(form)}")
    table = _part(document, "table", "it is no material of viscoroll")
    frequency = np.asarray(table["frequency"], dtype=float) / scale
    return MasterCurve(frequency, table["storage"], table["loss"], extrapolation=Extrapolation.HOLD)


def _draw(document: dict[str, Any], temperature: float | None, form: Form, draw: int) -> Prony:
    draws = _part(document, "draws", "save it with draws")
    count = len(draws["instantaneous_modulus"])
    if form != "prony":
        raise ValueError(f"form must be 'prony' where a draw is taken, got {shown(form)}")
    if not 0 <= draw < count:
        raise ValueError(f"draw must be in [0, {count - 1}], got {draw}")
    factors = draws["log10_factor"][draw] if "log10_factor" in draws else None
    times = np.asarray(draws["relaxation_times"][draw], dtype=float)
    return Prony(
        instantaneous_modulus=draws["instantaneous_modulus"][draw],
        weights=draws["weights"][draw],
        relaxation_times=times * 10.0 ** _shift(document, temperature, factors),
    )


def _rows_of_draws(draws: Draws[Superposition] | Draws[Prony]) -> list[str]:
    """Return series, and of superpositions shift factors, a row for each draw."""
    series = [draw.fit.series if isinstance(draw, Superposition) else draw for draw in draws]
    lines = [f"instantaneous_modulus = {_list(s.instantaneous_modulus for s in series)}"]
    columns = {name: [getattr(s, name) for s in series] for name in ("weights", "relaxation_times")}
    if factors := [draw.factors.log10_factor for draw in draws if isinstance(draw, Superposition)]:
        columns["log10_factor"] = factors
    for name, rows in columns.items():
        lines += [f"{name} = [", *(f"    {_list(row)}," for row in rows), "]"]
    return lines


def _shift(document: dict[str, Any], temperature: float | None, factors: Iterable[float] | None = None) -> float:
    """Return log₁₀ a_T, of the file or of a draw; by it times grow and frequencies shrink."""
    if temperature is None or temperature == document.get("reference_temperature"):
        return 0.0
    shift = _part(document, "shift", "its temperature cannot be changed")
    known = shift["log10_factor"] if factors is None else tuple(factors)
    return ShiftFactors(temperature=shift["temperature"], log10_factor=known)(float(temperature))


def _part(document: dict[str, Any], name: str, meaning: str) -> dict[str, Any]:
    part = document.get(name)
    if not isinstance(part, dict):
        raise ValueError(f"needs a table [{name}]: {meaning}")
    return _Named(name, part)


class _Named(dict[str, Any]):
    """A table whose missing entries are named."""

    def __init__(self, name: str, entries: dict[str, Any]) -> None:
        super().__init__(entries)
        self._name = name

    def __missing__(self, key: str) -> Any:
        raise ValueError(f"table [{self._name}] needs {key}")


def _columns(holder: object, names: Iterable[str]) -> list[str]:
    return [f"{name} = {_list(getattr(holder, name))}" for name in names]


def _list(values: Iterable[float]) -> str:
    return f"[{', '.join(repr(float(value)) for value in values)}]"


def _quoted(text: str) -> str:
    return '"' + one_line(text).replace("\\", "\\\\").replace('"', '\\"') + '"'
