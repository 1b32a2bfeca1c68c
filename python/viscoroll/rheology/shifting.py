"""Time-temperature superposition of sweeps at several temperatures onto one master curve."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .._support.arguments import Floats, as_kelvin, require_type
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput
from ..materials.series import fit_series, time_grid
from ..materials.shift import Shift, shift_factor
from .alignment import shift_pairs, undetermined_pairs
from .reading import Isotherm, RheologyData
from .shift_laws import ShiftFactors
from .superposition import Superposition, aligned

__all__ = ["superpose"]


def superpose(
    data: RheologyData,
    *,
    reference: float,
    factors: ShiftFactors | Shift | None = None,
    vertical: bool = False,
) -> Superposition:
    """Shift sweeps at several temperatures onto one master curve.

    Each sweep is first shifted onto its neighbor. All sweeps are then moved together until one Prony series with
    nonnegative weights fits them best. Shifts that no passive material would have are thereby penalized.

    Parameters
    ----------
    data : RheologyData
        At least two sweeps with temperatures; with `factors` also a temperature ramp.
    reference : float
        Temperature of the master curve [K], between the coldest and the hottest sweep.
    factors : ShiftFactors, WilliamsLandelFerry, Arrhenius or callable, optional
        Known shift factors at temperatures that span the data, or a law as a function of temperature in kelvin. By
        default the shifts are fitted.
    vertical : bool, default False
        Whether to divide the moduli of each sweep by a fitted factor.

    Returns
    -------
    Superposition
        Master curve, shift factors, fitted laws with intervals, and a list of undetermined shifts.

    Raises
    ------
    ValueError
        If there are fewer than two sweeps, a temperature is missing, the reference is outside the temperatures, or the
        data are a ramp at one frequency and `factors` is not given.
    """
    require_type("data", data, RheologyData)
    kelvin = as_kelvin("reference", reference)
    sweeps = data.isotherms
    temperature = np.array([sweep.temperature for sweep in sweeps])
    if len(sweeps) < 2:
        raise InvalidInput("data", "must have at least 2 sweeps to be shifted", len(sweeps))
    if np.isnan(temperature).any():
        raise InvalidInput(
            "data", "must have a temperature for every sweep: pass columns={'temperature': (name, unit)}"
        )
    if not (np.diff(temperature) > 0.0).all():
        sweeps = _one_for_each_temperature(sweeps)
        return superpose(replace(data, isotherms=sweeps), reference=kelvin, factors=factors, vertical=vertical)
    low, high = float(temperature[0]), float(temperature[-1])
    if not low - 0.5 <= kelvin <= high + 0.5:
        raise InvalidInput(
            "reference", f"must be in the measured range, {kelvin_range(low, high)}", f"{kelvin_text(kelvin)}"
        )
    if factors is not None:
        known = factors if isinstance(factors, ShiftFactors) else _by_law(factors, temperature)
        return _by_hand(data, kelvin, temperature, known)
    if (ramp := data.ramp) is not None:
        raise InvalidInput(
            "data",
            "must have several frequencies to be shifted",
            f"a temperature ramp at {ramp.frequency:.4g} rad/s: pass a law of the shift, such as "
            "factors=vr.materials.WilliamsLandelFerry(...), "
            "or use data.ramp.at(temperature=...), the modulus and loss factor at that frequency",
        )
    anchor = int(np.argmin(np.abs(temperature - kelvin)))
    found = aligned(data, kelvin, shift_pairs(sweeps), anchor, vertical=vertical)
    return Superposition(data=data, reference=kelvin, undetermined=undetermined_pairs(sweeps), anchor=anchor, **found)


def _by_law(law: Shift, temperature: Floats) -> ShiftFactors:
    shifts = [shift_factor(law, kelvin, "factors") for kelvin in temperature.tolist()]
    return ShiftFactors(temperature=tuple(temperature), log10_factor=tuple(np.log10(shifts)))


def _by_hand(data: RheologyData, reference: float, temperature: Floats, factors: ShiftFactors) -> Superposition:
    chosen = ShiftFactors(
        temperature=tuple(temperature), log10_factor=tuple(factors(t) - factors(reference) for t in temperature)
    )
    given = Superposition(
        data=data,
        reference=reference,
        factors=chosen,
        vertical=(0.0,) * temperature.size,
        scatter=np.nan,
        undetermined=(),
        covariance=None,
        anchor=int(np.argmin(np.abs(temperature - reference))),
    )
    series = fit_series(given.frequency, given.storage, given.loss, time_grid(given.frequency, 2.0), floor=0.0)
    return replace(given, scatter=series.scatter)


def _one_for_each_temperature(sweeps: Sequence[Isotherm]) -> tuple[Isotherm, ...]:
    """Merge sweeps that were repeated at the same temperature."""
    joined = []
    for temperature in sorted({sweep.temperature for sweep in sweeps}):
        same = [sweep for sweep in sweeps if sweep.temperature == temperature]
        columns = [np.concatenate([getattr(s, name) for s in same]) for name in ("frequency", "storage", "loss")]
        order = np.argsort(columns[0], kind="stable")
        frequency, storage, loss = (column[order] for column in columns)
        joined.append(Isotherm(temperature=temperature, frequency=frequency, storage=storage, loss=loss))
    return tuple(joined)
