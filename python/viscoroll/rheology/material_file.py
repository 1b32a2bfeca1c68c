"""Measured materials in TOML files, which case files name."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .._core import Extrapolation
from .._support.text import one_line, shown
from ..materials import MasterCurve, Prony
from .prony_fit import PronyFit, fit_prony
from .shift_laws import ShiftFactors
from .superposition import Superposition, tabulated

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .reading import Isotherm

__all__ = ["load_material", "save_material"]

Form = Literal["table", "prony"]


def save_material(path: str | Path, curve: Superposition | Isotherm, *, fit: PronyFit | None = None) -> None:
    """Write a measured material to a TOML file that `load_material` and case files read.

    Parameters
    ----------
    path : path-like
        The file, ending in .toml.
    curve : Superposition or Isotherm
        The modulus; of a superposition the shift factors are kept, too, for other temperatures.
    fit : PronyFit, optional
        A Prony series of the same curve, to be kept beside the table.

    Raises
    ------
    ValueError
        For another suffix.
    """
    path = Path(path)
    if path.suffix != ".toml":
        raise ValueError(f"path must end in .toml, got {path.name!r}")
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
    if isinstance(curve, Superposition):
        lines += ["", f"# {curve.law}", "[shift]", *_columns(curve.factors, ("temperature", "log10_factor"))]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def load_material(path: str | Path, *, temperature: float | None = None, form: Form = "table") -> MasterCurve | Prony:
    """Read a measured material.

    Parameters
    ----------
    path : path-like
        A file written by `save_material`, or by `viscoroll material`.
    temperature : float, optional
        [°C], among those that were measured; by default that of the file's curve.
    form : {"table", "prony"}
        The measured table itself, with its end values held, or the Prony series that smooths it.

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
        return _material(document, temperature, form)
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


def _shift(document: dict[str, Any], temperature: float | None) -> float:
    """Return log₁₀ a_T; by it times grow and frequencies shrink."""
    if temperature is None or temperature == document.get("reference_temperature"):
        return 0.0
    shift = _part(document, "shift", "its temperature cannot be changed")
    return ShiftFactors(temperature=shift["temperature"], log10_factor=shift["log10_factor"])(float(temperature))


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
    return [f"{name} = [{', '.join(repr(float(value)) for value in getattr(holder, name))}]" for name in names]


def _quoted(text: str) -> str:
    return '"' + one_line(text).replace("\\", "\\\\").replace('"', '\\"') + '"'
