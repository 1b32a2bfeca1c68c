"""Tables of materials from data sheets and laboratories, for the web page that runs without Python.

The C++ library contains neither the formulas for hardness and rebound nor the published materials. This module
tabulates their moduli at the resolution of data sheets, and `page/tabulated.js` looks them up.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import fields
from enum import Enum
from typing import Any

from .._support.celsius import ZERO_CELSIUS
from ..materials import LossFactor, MasterCurve, Prony
from ..rheology import example_material, hardness_to_modulus, rebound_to_loss_factor
from ..rheology.published import EXAMPLES

__all__ = ["tabulated_materials"]

#: Tabulated values: hardness by Shore scale; rebound [%]; loss factor [%]; temperature [K].
_HARDNESS = {"A": range(20, 91), "D": range(30, 86)}
_REBOUNDS = range(2, 100)
_LOSS_FACTORS = range(1, 101)
_TEMPERATURES = [ZERO_CELSIUS + celsius for celsius in range(-10, 60, 10)]

#: Decades on either side of the reference frequency over which the loss factor is constant. A material from a hardness
#: needs more, because its reference frequency is far below the contact frequency. Same as in `page/materials.js`.
_DECADES = 3.0
_HARDNESS_DECADES = 4.5


def tabulated_materials() -> dict[str, Any]:
    """Return the tables in a form that can be written as JSON.

    Returns
    -------
    dict
        ``hardness`` contains shear moduli [Pa] by scale and hardness. ``rebound`` and ``loss_factor`` contain
        `decades`, `relaxation_times` [s] and `series`: for each percentage, a Prony series with the modulus 1 Pa at
        1 rad/s. The weights of a series between the first and the last are geometric, so that five numbers determine
        it: instantaneous modulus, first weight, second weight, ratio, last weight. ``published`` contains tables of a
        case file by name and temperature [K], such as "293.15".
    """
    return {
        "hardness": {
            scale: {str(shore): hardness_to_modulus(float(shore), scale=scale).value for shore in values}
            for scale, values in _HARDNESS.items()
        },
        "rebound": _all_series(
            {percent: rebound_to_loss_factor(percent / 100).value for percent in _REBOUNDS}, _HARDNESS_DECADES
        ),
        "loss_factor": _all_series({percent: percent / 100 for percent in _LOSS_FACTORS}, _DECADES),
        "published": {
            name: {str(kelvin): _table(example_material(name).at(temperature=kelvin)) for kelvin in _TEMPERATURES}
            for name in EXAMPLES
        },
    }


def _all_series(loss_factors: dict[int, float], decades: float) -> dict[str, Any]:
    by_percent = {
        percent: LossFactor(modulus=1.0, loss_factor=loss_factor, reference_frequency=1.0, decades=decades).prony()
        for percent, loss_factor in loss_factors.items()
    }
    times = next(iter(by_percent.values())).relaxation_times  # the same for all series
    series = {str(percent): _five_numbers(prony) for percent, prony in by_percent.items()}
    return {"decades": decades, "relaxation_times": list(times), "series": series}


def _five_numbers(series: Prony) -> list[float]:
    """Return the five numbers that determine a series. With all weights, the download of the page would double."""
    first, second, third, *_, last = series.weights
    return [series.instantaneous_modulus, first, second, third / second, last]


def _table(modulus: MasterCurve | Prony | LossFactor) -> dict[str, Any]:
    """Return the table of a case file for a measured modulus, as a material that the C++ library supports."""
    core = modulus.prony() if hasattr(modulus, "prony") else modulus
    kind = "master_curve" if hasattr(core, "extrapolation") else "prony"
    return {"type": kind, **{field.name: _plain(getattr(core, field.name)) for field in fields(core)}}


def _plain(value: object) -> object:
    """Return an enum member as its name in case files, and a sequence as a list of floats."""
    if isinstance(value, Enum):
        return value.name.lower()
    return list(map(float, value)) if isinstance(value, Iterable) else value
