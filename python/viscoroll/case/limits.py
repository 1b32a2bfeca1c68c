"""Quantities that a design can limit: scalar results, and quantities inside the layers of body and counterbody."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .._support.celsius import kelvin_text
from .._support.errors import InvalidInput
from .._support.progress import Report
from .._support.quantities import percent_text, quantity_text
from ..bodies import RollingBody
from ..rolling import Result
from ..solution.inside import Inside, inside_of
from ..solution.scalars import PRECISION, SCALARS, label_of, scalar_units

if TYPE_CHECKING:
    from ..coupled import SelfHeating
    from ..thermal import Temperature
    from .case import Case

__all__ = [
    "BOND_QUANTITIES",
    "LIMITS",
    "Outcome",
    "at_bonds",
    "bond_tractions",
    "deformable_bodies",
    "limit_label",
    "limit_text",
    "limit_units",
    "outcome_at",
    "outcome_of",
    "require_thermal",
]

#: Unit and description of tractions at bonded interfaces, by name.
BOND_QUANTITIES = {
    "bond_shear": ("Pa", "largest shear traction at bonded interfaces"),
    "bond_tension": ("Pa", "largest tension at bonded interfaces"),
}

#: Quantities inside the layers: name, unit, description.
_INSIDE = {
    "temperature": ("K", "largest temperature of the layers"),
    **BOND_QUANTITIES,
    "load_to_fold": ("1", "ratio of the load to the load at which the cold state ends"),
}

#: Limited quantities that depend on the cooling.
_THERMAL = frozenset({"temperature", "load_to_fold"})

#: Names that limits may have.
LIMITS = (*SCALARS, *_INSIDE)


def limit_units(*, line_contact: bool) -> dict[str, str]:
    """Return the unit of every quantity that a design can limit."""
    return scalar_units(line_contact=line_contact) | {name: unit for name, (unit, _) in _INSIDE.items()}


def limit_label(name: str, body: RollingBody) -> str:
    """Return the label of a quantity that a design can limit, in the words for the rolling body."""
    return _INSIDE[name][1] if name in _INSIDE else label_of(name, body)


def limit_text(name: str, value: float, unit: str) -> str:
    """Return a limited quantity with a readable unit: temperatures also in °C, ratios in percent."""
    if unit == "K":
        return kelvin_text(value)
    return percent_text(value) if PRECISION.get(name) == ("%",) else quantity_text(value, unit)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Outcome:
    """Results of a case, with the limited quantities inside its layers.

    Attributes
    ----------
    result : Result
        Result of the case. If a thermal quantity is limited and heat changes the moduli, the coldest steady state.
    inside : mapping of str to float
        Values of the limited quantities among "temperature" [K], "bond_shear", "bond_tension" [Pa], "load_to_fold" [-].
    """

    result: Result
    inside: Mapping[str, float]

    def value(self, name: str) -> float:
        """Return a scalar result, or a quantity inside the layers, by its name.

        Raises
        ------
        ValueError
            If the case lacks this result.
        """
        found = self.inside[name] if name in self.inside else getattr(self.result, name)
        if found is None:
            raise InvalidInput(f"design.limits.{name}", "must be left out: this case does not have this result")
        return float(found)

    def unit(self, name: str) -> str:
        """Return the unit of a limit."""
        return _INSIDE[name][0] if name in _INSIDE else self.result.unit(name)

    def violation(self, limits: Mapping[str, float]) -> float:
        """Return the largest relative excess over a limit [-]; negative if all limits are satisfied."""
        return max((self.value(name) / limit - 1.0 for name, limit in limits.items()), default=-1.0)


def outcome_of(case: Case, names: Collection[str], report: Report | None) -> Outcome:
    """Solve a case and compute the limited quantities inside its layers.

    Parameters
    ----------
    case : Case
        Case to solve.
    names : collection of str
        Names of the limited quantities, from `LIMITS`.
    report : callable or None
        Called as report(stage, fraction).

    Raises
    ------
    ValueError
        If the case lacks a limited quantity, or cannot be solved.
    """
    require_thermal(case, names)
    is_thermal = not _THERMAL.isdisjoint(names)
    if is_thermal and case.thermal is not None and case.thermal.shift is not None:
        hot = case.self_heating(progress=report)
        return outcome_at(case, names, hot.states[0].result, hot.states[0].temperature, hot)
    result = case.solve(progress=report)
    heated = case.thermal.temperature(result) if "temperature" in names and case.thermal is not None else None
    return outcome_at(case, names, result, heated, None)


def require_thermal(case: Case, names: Collection[str]) -> None:
    """Raise an InvalidInput if thermal quantities are limited and the case does not describe its cooling."""
    if (heat := _THERMAL.intersection(names)) and case.thermal is None:
        raise InvalidInput(
            f"design.limits.{min(heat)}",
            "must be used with a table [thermal], which describes the cooling of the layers",
        )
    if "load_to_fold" in names and (case.thermal is None or case.thermal.shift is None):
        raise InvalidInput(
            "design.limits.load_to_fold",
            "must be used with thermal.shift: otherwise the cold state has no largest load",
        )


def outcome_at(
    case: Case, names: Collection[str], result: Result, heated: Temperature | None, hot: SelfHeating | None
) -> Outcome:
    """Return the results of a solved case with the limited quantities inside its layers.

    Parameters
    ----------
    case : Case
        The case.
    names : collection of str
        Names of the limited quantities, from `LIMITS`.
    result : Result
        Its result.
    heated : Temperature or None
        Temperature of its layers, if that is limited.
    hot : SelfHeating or None
        Its steady states, if "load_to_fold" is limited.

    Raises
    ------
    ValueError
        If the case has no bonded interfaces, although tractions at them are limited.
    """
    inside: dict[str, float] = {}
    if "load_to_fold" in names and hot is not None:
        fold = hot.largest_load()
        inside["load_to_fold"] = 0.0 if fold is None else case.given_load() / fold.load
    if "temperature" in names and heated is not None:
        inside["temperature"] = heated.ambient + heated.maximum
    return Outcome(result=result, inside=inside | at_bonds(result, names))


def at_bonds(result: Result, names: Collection[str]) -> dict[str, float]:
    """Return the largest tractions at the bonds of both bodies, by name."""
    fields = {"bond_shear": "shear_traction", "bond_tension": "opening_traction"}
    wanted = {name: field for name, field in fields.items() if name in names}
    if not wanted:
        return {}
    bonded = [body.of for body in deformable_bodies(result) if body.bonded().size]
    if not bonded:
        raise InvalidInput(f"design.limits.{min(wanted)}", "must be left out: this case has no bonded interfaces")
    tractions = [result.bonds(of=of) for of in bonded]
    return {name: max(float(bonds[field].max()) for bonds in tractions) for name, field in wanted.items()}


def bond_tractions(result: Result) -> dict[str, float]:
    """Return the largest tractions at bonded interfaces [Pa] by name; empty if there are none."""
    if not any(body.bonded().size for body in deformable_bodies(result)):
        return {}
    return at_bonds(result, BOND_QUANTITIES)


def deformable_bodies(result: Result) -> list[Inside]:
    """Return the deformable bodies of a result."""
    on = result.on
    deforms = on is not None and bool(on.layers or getattr(on, "base", None) is not None)
    return [
        *([inside_of(result, "body")] if result.body.layers else []),
        *([inside_of(result, "counterbody")] if deforms else []),
    ]
