"""Measured materials in TOML files, to which case files refer."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from .._core import Extrapolation
from .._support.arguments import as_count, as_float, as_floats, as_int, as_kelvin
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput, in_file
from .._support.files import ending_in, write_text
from .._support.text import one_line, shown
from .._support.toml import read_toml
from ..materials import Draws, MasterCurve, Prony
from .prony_fit import PronyFit, fit_prony
from .shift_laws import ShiftFactors
from .spectrum_fit import SpectrumFit
from .superposition import Superposition
from .tabulated import tabulated

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from .reading import Isotherm

__all__ = ["count_draws", "load_material", "material_summary", "save_material"]

Form = Literal["table", "prony"]

#: Meaning of a file without a table [table].
_NO_MATERIAL = "the file is not a material file of viscoroll"


def save_material(
    path: str | Path,
    curve: Superposition | SpectrumFit | Isotherm,
    *,
    fit: PronyFit | SpectrumFit | None = None,
    draws: Draws[Superposition] | Draws[SpectrumFit] | Draws[Prony] | None = None,
) -> None:
    """Write a measured material to a TOML file that `load_material` and case files read.

    Parameters
    ----------
    path : path-like
        Path of the file, ending in .toml.
    curve : Superposition, SpectrumFit or Isotherm
        Measured modulus. For data at several temperatures, the file also contains the shift factors.
    fit : PronyFit or SpectrumFit, optional
        Prony series of the same curve, stored in addition to the table.
    draws : Draws, optional
        Draws of the superposition or of the fit, stored in addition; draws at several temperatures with their own shift
        factors. Requires `fit`.

    Raises
    ------
    ValueError
        If the suffix is not .toml, or if draws are given without a fit.
    """
    path = ending_in([".toml"], path)
    shifted = curve if isinstance(curve, Superposition | SpectrumFit) else None
    if isinstance(curve, Superposition | SpectrumFit):
        table, reference = curve.curve, curve.reference
    else:
        table, reference = _table_of(curve), curve.temperature
    lines = ["# Measured shear moduli, written by viscoroll. Frequencies in rad/s, moduli in Pa, temperatures in K."]
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
            raise InvalidInput("fit", "must be given with draws, which are Prony series")
        lines += ["", "[draws]", *_rows_of_draws(draws)]
    if shifted is not None and shifted.factors is not None:
        lines += ["", f"# {shifted.law}", "[shift]", *_columns(shifted.factors, ("temperature", "log10_factor"))]
    write_text("\n".join(lines) + "\n", path)


def load_material(
    path: str | Path, *, temperature: float | None = None, form: Form = "table", draw: int | None = None
) -> MasterCurve | Prony:
    """Read a measured material from a TOML file.

    Parameters
    ----------
    path : path-like
        Path of a file written by `save_material` or by `viscoroll material`.
    temperature : float, optional
        Temperature [K], within the range of the measurement; by default the reference temperature of the file.
    form : {"table", "prony"}, default "table"
        The measured table with its end values held, or the Prony series that smooths it.
    draw : int, optional
        Index of one of the draws in the file, from 0, to be used in place of its Prony series. Requires
        ``form="prony"``.

    Returns
    -------
    MasterCurve or Prony
        Shear modulus at that temperature.

    Raises
    ------
    TypeError
        If `temperature` is not a real number or `draw` is not a whole number.
    ValueError
        If the file is not a material file, lacks the required series or shift factors, or does not cover the
        temperature.
    OSError
        If the file cannot be read.
    """
    path = Path(path)
    given = None if temperature is None else as_float("temperature", temperature)
    number = None if draw is None else as_int("draw", draw)
    with _errors_in(path):
        kelvin = None if given is None else as_kelvin("temperature", given)
        document = read_toml(path)
        return _material(document, kelvin, form) if number is None else _draw(document, kelvin, form, number)


def material_summary(path: Path) -> dict[str, str]:
    """Return what a material file states about its measurement, as texts by name; errors same as in `load_material`."""
    with _errors_in(path):
        document = read_toml(path)
        frequency = [
            w for w in _numbers("table.frequency", _part(document, "table", _NO_MATERIAL)["frequency"]) if w > 0
        ]
        found = {"measured data": str(document.get("source", "not stated in the file"))}
        found["frequencies of the table"] = (
            f"{min(frequency):.3g} to {max(frequency):.3g} rad/s" if frequency else "none"
        )
        if "reference_temperature" in document:
            found["reference temperature"] = kelvin_text(
                as_float("reference_temperature", document["reference_temperature"])
            )
        if "shift" in document:
            kelvin = _numbers("shift.temperature", _part(document, "shift", "")["temperature"])
            found["temperatures"] = kelvin_range(min(kelvin), max(kelvin)) if kelvin else "none"
        return found


def count_draws(path: Path) -> int:
    """Return the number of draws in a material file; errors are the same as in `load_material`."""
    with _errors_in(path):
        return len(_moduli_of_draws(_draws_of(read_toml(path))))


@contextmanager
def _errors_in(path: Path) -> Iterator[None]:
    """Convert an error about the content of a material file into a one-line ValueError that names the file."""
    try:
        yield
    except (TypeError, ValueError) as error:
        raise in_file(error, f"material {path}") from None


def _table_of(curve: Isotherm) -> MasterCurve:
    return tabulated(curve.frequency, curve.storage, curve.loss, relaxed=fit_prony(curve).relaxed_modulus)


def _material(document: dict[str, Any], temperature: float | None, form: Form) -> MasterCurve | Prony:
    decades = _shift(document, temperature)
    if form == "prony":
        series = _part(document, "prony", "save the material with a fit")
        return Prony(
            instantaneous_modulus=as_float("prony.instantaneous_modulus", series["instantaneous_modulus"]),
            weights=_numbers("prony.weights", series["weights"]),
            relaxation_times=_moved(_numbers("prony.relaxation_times", series["relaxation_times"]), decades),
        )
    if form != "table":
        raise InvalidInput("form", "must be 'table' or 'prony'", shown(form))
    table = _part(document, "table", _NO_MATERIAL)
    frequency, storage, loss = (_numbers(f"table.{name}", table[name]) for name in ("frequency", "storage", "loss"))
    return MasterCurve(_moved(frequency, -decades), storage, loss, extrapolation=Extrapolation.HOLD)


def _draw(document: dict[str, Any], temperature: float | None, form: Form, draw: int) -> Prony:
    draws = _draws_of(document)
    moduli = _moduli_of_draws(draws)
    if form != "prony":
        raise InvalidInput("form", "must be 'prony' if a draw is given", shown(form))
    as_count("draw", draw, 0, len(moduli) - 1)

    def row(name: str) -> tuple[float, ...]:
        rows = draws[name]
        if not isinstance(rows, list) or len(rows) != len(moduli):
            raise InvalidInput(f"draws.{name}", f"must be a list of {len(moduli)} lists, one for each draw")
        return _numbers(f"draws.{name}[{draw}]", rows[draw])

    factors = row("log10_factor") if "log10_factor" in draws else None
    return Prony(
        instantaneous_modulus=moduli[draw],
        weights=row("weights"),
        relaxation_times=_moved(row("relaxation_times"), _shift(document, temperature, factors)),
    )


def _draws_of(document: dict[str, Any]) -> dict[str, Any]:
    return _part(document, "draws", "save the material with draws")


def _moduli_of_draws(draws: dict[str, Any]) -> tuple[float, ...]:
    moduli = _numbers("draws.instantaneous_modulus", draws["instantaneous_modulus"])
    if not moduli:
        raise InvalidInput("draws.instantaneous_modulus", "must have one number for each draw", "none")
    return moduli


def _numbers(name: str, values: object) -> tuple[float, ...]:
    if not isinstance(values, list):
        raise InvalidInput(name, "must be a list of numbers", shown(values))
    return as_floats(name, values)


def _moved(values: Sequence[float], decades: float) -> list[float]:
    """Return times or frequencies after a shift. The constructor of the modulus checks their range."""
    with np.errstate(over="ignore", under="ignore"):
        moved: list[float] = (np.asarray(values) * 10.0**decades).tolist()
    return moved


def _rows_of_draws(draws: Draws[Superposition] | Draws[SpectrumFit] | Draws[Prony]) -> list[str]:
    """Return TOML lines with one row per draw: the series and, for superpositions, the shift factors."""
    series = [_series_of(draw) for draw in draws]
    lines = [f"instantaneous_modulus = {_list(s.instantaneous_modulus for s in series)}"]
    columns = {name: [getattr(s, name) for s in series] for name in ("weights", "relaxation_times")}
    shifts = [draw.factors for draw in draws if isinstance(draw, Superposition | SpectrumFit)]
    if factors := [one.log10_factor for one in shifts if one is not None]:
        columns["log10_factor"] = factors
    for name, rows in columns.items():
        lines += [f"{name} = [", *(f"    {_list(row)}," for row in rows), "]"]
    return lines


def _series_of(draw: Superposition | SpectrumFit | Prony) -> Prony:
    if isinstance(draw, Superposition):
        return draw.fit.series
    return draw.series if isinstance(draw, SpectrumFit) else draw


def _shift(document: dict[str, Any], temperature: float | None, factors: Sequence[float] | None = None) -> float:
    """Return log₁₀ a_T from the factors of the file or of a draw. Times are multiplied, frequencies divided by a_T."""
    reference = document.get("reference_temperature")
    if reference is not None:
        reference = as_kelvin("reference_temperature", reference)
    if temperature is None or temperature == reference:
        return 0.0
    shift = _part(document, "shift", "the temperature of this material cannot be changed")
    temperatures = _numbers("shift.temperature", shift["temperature"])
    known = _numbers("shift.log10_factor", shift["log10_factor"]) if factors is None else factors
    return ShiftFactors(temperature=temperatures, log10_factor=tuple(known))(temperature)


def _part(document: dict[str, Any], name: str, meaning: str) -> dict[str, Any]:
    part = document.get(name)
    if not isinstance(part, dict):
        raise ValueError(f"must have a table [{name}]: {meaning}")
    return _Named(name, part)


class _Named(dict[str, Any]):
    """Table that reports missing entries by name."""

    def __init__(self, name: str, entries: dict[str, Any]) -> None:
        super().__init__(entries)
        self._name = name

    def __missing__(self, key: str) -> Any:
        raise ValueError(f"table [{self._name}] must have the key {key}")


def _columns(holder: object, names: Iterable[str]) -> list[str]:
    return [f"{name} = {_list(getattr(holder, name))}" for name in names]


def _list(values: Iterable[float]) -> str:
    return f"[{', '.join(repr(float(value)) for value in values)}]"


def _quoted(text: str) -> str:
    return '"' + one_line(text).replace("\\", "\\\\").replace('"', '\\"') + '"'
