"""Tables of materials from data sheets and laboratories, for the page that runs without this package.

The C++ library has no hardness, no rebound and no published materials: only Python has their formulas and data. Their
moduli are tabulated at the resolution of data sheets, and `page/tabulated.js` looks them up.
"""

from __future__ import annotations

from typing import Any

from ..materials import LossFactor, MasterCurve, Prony
from ..rheology import example_material, hardness_to_modulus, rebound_to_loss_factor
from ..rheology.published import EXAMPLES

__all__ = ["tabulated_materials"]

#: Tabulated values: hardness by scale [Shore]; rebound [%]; loss factor [0.01]; temperature [°C].
_HARDNESS = {"A": range(20, 91), "D": range(30, 86)}
_REBOUNDS = range(2, 100)
_LOSS_FACTORS = range(1, 101)
_TEMPERATURES = range(-10, 60, 10)

#: Decades above and below its frequency over which a loss factor is constant; more for a hardness, whose frequency is
#: far below that of a contact. Same as in `page/materials.js`.
_DECADES = 3.0
_DECADES_OF_HARDNESS = 4.5


def tabulated_materials() -> dict[str, Any]:
    """Return the tables in a form that can be written as JSON.

    Returns
    -------
    dict
        ``hardness`` holds shear moduli [Pa] by scale and hardness. ``rebound`` and ``loss_factor`` hold `decades`,
        `relaxation_times` [s], and by percent the Prony `series` of a material with the modulus 1 Pa at 1 rad/s, whose
        weights between the first and the last are geometric: instantaneous modulus, first weight, second weight, ratio,
        last weight. ``published`` holds tables of a case file by name and temperature [°C].
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
    times = next(iter(unit.values())).relaxation_times  # the same for all series
    series = {str(percent): _numbers(one) for percent, one in unit.items()}
    return {"decades": decades, "relaxation_times": list(times), "series": series}


def _numbers(series: Prony) -> list[float]:
    """Return five numbers that define a series; all its weights would double the download of the page."""
    first, second, third, *_, last = series.weights
    return [series.instantaneous_modulus, first, second, third / second, last]


def _table(modulus: MasterCurve | Prony | LossFactor) -> dict[str, Any]:
    """Return the table of a case file for a measured modulus, with a type that the C++ library has."""
    if isinstance(modulus, LossFactor):
        series = modulus.prony()
        terms = {name: list(map(float, getattr(series, name))) for name in ("weights", "relaxation_times")}
        return {"type": "prony", "instantaneous_modulus": series.instantaneous_modulus, **terms}
    assert isinstance(modulus, MasterCurve)
    columns = {name: list(map(float, getattr(modulus, name))) for name in ("frequency", "storage", "loss")}
    return {"type": "master_curve", **columns, "extrapolation": modulus.extrapolation.name.lower()}
