"""Materials of data sheets and laboratories as tables, for the page where this package is not there to read them.

The library of C++ knows neither hardness nor rebound, and no published material: their formulas and data are in Python
alone. What they come to is tabulated as finely as data sheets tell, and `page/tabulated.js` looks it up.
"""

from __future__ import annotations

from typing import Any

from ..materials import LossFactor, MasterCurve, Prony
from ..rheology import example_material, hardness_to_modulus, rebound_to_loss_factor
from ..rheology.published import EXAMPLES

__all__ = ["tabulated_materials"]

#: Whole degrees of a durometer, by scale; whole percents of rebound; hundredths of loss factors; degrees Celsius.
_HARDNESS = {"A": range(20, 91), "D": range(30, 86)}
_REBOUNDS = range(2, 100)
_LOSS_FACTORS = range(1, 101)
_TEMPERATURES = range(-10, 60, 10)

#: How far loss factors hold above and below their frequency, which of a hardness is far below that of a contact: as
#: `page/materials.js` asks for.
_DECADES = 3.0
_DECADES_OF_HARDNESS = 4.5


def tabulated_materials() -> dict[str, Any]:
    """Return the tables as JSON has them.

    Returns
    -------
    dict
        ``hardness``: by scale and hardness, shear modulus [Pa]; ``rebound`` and ``loss_factor``: for so many `decades`,
        with `relaxation_times` [s], by percent of either the Prony `series` of a modulus of 1 Pa that holds at 1 rad/s,
        whose weights between the first and the last are geometric: instantaneous modulus, first weight, second, ratio,
        and last; ``published``: by name and temperature [°C], the table of a case file.
    """
    return {
        "hardness": {
            scale: {str(shore): hardness_to_modulus(float(shore), scale=scale).value for shore in values}
            for scale, values in _HARDNESS.items()
        },
        "rebound": _all_series(
            {percent: rebound_to_loss_factor(percent / 100).value for percent in _REBOUNDS}, _DECADES_OF_HARDNESS
        ),
        "loss_factor": _all_series({percent: percent / 100 for percent in _LOSS_FACTORS}, _DECADES),
        "published": {
            name: {str(degrees): _table(example_material(name).at(temperature=degrees)) for degrees in _TEMPERATURES}
            for name in EXAMPLES
        },
    }


def _all_series(loss_factors: dict[int, float], decades: float) -> dict[str, Any]:
    unit = {
        percent: LossFactor(modulus=1.0, loss_factor=loss_factor, reference_frequency=1.0, decades=decades).prony()
        for percent, loss_factor in loss_factors.items()
    }
    times = next(iter(unit.values())).relaxation_times  # of all of them
    series = {str(percent): _numbers(one) for percent, one in unit.items()}
    return {"decades": decades, "relaxation_times": list(times), "series": series}


def _numbers(series: Prony) -> list[float]:
    """Return what a series is made of; all its weights would be as much to download as the rest of the page."""
    first, second, third, *_, last = series.weights
    return [series.instantaneous_modulus, first, second, third / second, last]


def _table(modulus: MasterCurve | Prony | LossFactor) -> dict[str, Any]:
    """Return the table of a case file for a modulus that was measured, of a type that C++ knows."""
    if isinstance(modulus, LossFactor):
        series = modulus.prony()
        terms = {name: list(map(float, getattr(series, name))) for name in ("weights", "relaxation_times")}
        return {"type": "prony", "instantaneous_modulus": series.instantaneous_modulus, **terms}
    assert isinstance(modulus, MasterCurve)
    columns = {name: list(map(float, getattr(modulus, name))) for name in ("frequency", "storage", "loss")}
    return {"type": "master_curve", **columns, "extrapolation": modulus.extrapolation.name.lower()}
