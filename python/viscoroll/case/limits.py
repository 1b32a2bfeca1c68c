"""What a case may be limited by: scalar results, and what happens inside the layers of what rolls and is rolled on."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .._support.progress import Report
from ..rolling import Result
from ..solution.inside import Inside, inside_of
from ..solution.scalars import SCALARS

if TYPE_CHECKING:
    from ..interior import Temperature
    from .case import Case

__all__ = ["LIMITS", "Outcome", "outcome_of"]

#: Limits of the inside: name, unit, what it is.
_INSIDE = {
    "temperature": ("K", "largest temperature of the layers"),
    "bond_shear": ("Pa", "largest shear traction where layers are bonded"),
    "bond_tension": ("Pa", "largest tension there"),
    "load_to_fold": ("1", "load, of that at which the cold state ends"),
}

#: Names that limits may have.
LIMITS = (*SCALARS, *_INSIDE)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Outcome:
    """What came of a case.

    Attributes
    ----------
    result : Result
        The solved case; where heat is limited and changes the moduli, its coldest steady state.
    inside : mapping of str to float
        Of "temperature" [K], "bond_shear" and "bond_tension" [Pa] and "load_to_fold" [-] those that are limited.
    """

    result: Result
    inside: Mapping[str, float]

    def value(self, name: str) -> float:
        """Return a scalar result, or one of the inside, by its name.

        Raises
        ------
        ValueError
            For a result that this case has not.
        """
        found = self.inside[name] if name in self.inside else getattr(self.result, name)
        if found is None:
            raise ValueError(f"design.limits.{name} must be left out: this case has none")
        return float(found)

    def unit(self, name: str) -> str:
        """Return the unit of a limit."""
        return _INSIDE[name][0] if name in _INSIDE else self.result.unit(name)

    def violation(self, limits: Mapping[str, float]) -> float:
        """Return by how much the worst limit is exceeded, relative; negative where all are kept."""
        return max((self.value(name) / limit - 1.0 for name, limit in limits.items()), default=-1.0)


def outcome_of(case: Case, names: Collection[str], report: Report | None) -> Outcome:
    """Solve a case and find what is limited in it.

    Parameters
    ----------
    names : collection of str
        Of `LIMITS`.
    report : callable or None
        Called as report(stage, fraction).

    Raises
    ------
    ValueError
        Where the case has not what is limited, or no answer.
    """
    heat = {"temperature", "load_to_fold"}.intersection(names)
    if heat and case.thermal is None:
        raise ValueError(f"design.limits.{min(heat)} needs a table [thermal] that says how the layers are cooled")
    if "load_to_fold" in names and (case.thermal is None or case.thermal.shift is None):
        raise ValueError("design.limits.load_to_fold needs a thermal.shift, without which no state ends")
    inside: dict[str, float] = {}
    heated: Temperature | None = None
    if heat and case.thermal is not None and case.thermal.shift is not None:
        hot = case.self_heating(progress=report)
        result, heated = hot.states[0].result, hot.states[0].temperature
        if "load_to_fold" in names:
            fold = hot.largest_load()
            inside["load_to_fold"] = 0.0 if fold is None else case.load / fold.load
    else:
        result = case.solve(progress=report)
        if "temperature" in names and case.thermal is not None:
            heated = case.thermal.temperature(result)
    if "temperature" in names and heated is not None:
        inside["temperature"] = heated.ambient + heated.maximum
    return Outcome(result=result, inside=inside | _at_bonds(result, names))


def _at_bonds(result: Result, names: Collection[str]) -> dict[str, float]:
    """Largest tractions at the bonds of both bodies."""
    fields = {"bond_shear": "shear_traction", "bond_tension": "opening_traction"}
    wanted = {name: field for name, field in fields.items() if name in names}
    if not wanted:
        return {}
    bonded = [body.of for body in _layered(result) if body.bonded().size]
    if not bonded:
        raise ValueError(f"design.limits.{min(wanted)} needs layers that are bonded to something, got none")
    tractions = [result.bonds(of=of) for of in bonded]
    return {name: max(float(bonds[field].max()) for bonds in tractions) for name, field in wanted.items()}


def _layered(result: Result) -> list[Inside]:
    """Return the bodies that deform."""
    on = result.on
    deforms = on is not None and bool(on.layers or getattr(on, "base", None) is not None)
    return [
        *([inside_of(result, "ball")] if result.ball.layers else []),
        *([inside_of(result, "counterpart")] if deforms else []),
    ]
