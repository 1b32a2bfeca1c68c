"""Temperature and tractions at bonds of a solved case: rows of reports and columns of studies."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..coupled import StrainSoftening
from ..studies.plan import Addition
from .limits import BOND_QUANTITIES, bond_tractions

if TYPE_CHECKING:
    from typing import Any

    from ..rolling import Result
    from ..thermal import Temperature
    from .case import Thermal

__all__ = ["Heating"]

#: Columns of a study with a table [thermal]: attribute of `Temperature`, unit and description, by name.
_RISES = {
    "temperature_rise": ("maximum", "K", "largest temperature rise"),
    "surface_temperature_rise": ("surface_maximum", "K", "largest temperature rise on the surface"),
    "mean_temperature_rise": ("mean", "K", "mean temperature rise, weighted by the loss"),
    "heat_to_core": ("heat_to_core", "W", "heat flow to the core, the hub or the base"),
    "heat_to_surroundings": ("heat_to_surroundings", "W", "heat flow to the surroundings"),
}


@dataclass(frozen=True, slots=True)
class Heating(Addition):
    """Temperatures and tractions at bonds of each point of a study whose file has a table [thermal].

    Attributes
    ----------
    thermal : Thermal
        Cooling. With a shift, a point is the steady state that a cold start reaches.
    """

    thermal: Thermal

    @property
    def columns(self) -> dict[str, tuple[str, str]]:
        """Unit and description of each column."""
        states = {"steady_states": ("1", "number of steady states")} if self.thermal.shift is not None else {}
        return {name: (unit, text) for name, (_, unit, text) in _RISES.items()} | BOND_QUANTITIES | states

    def solve(
        self, solver: Callable[..., Result | StrainSoftening], arguments: Mapping[str, Any], **options: Any
    ) -> tuple[Result | StrainSoftening, dict[str, float]]:
        """Solve a point and return its result with the columns."""
        if self.thermal.shift is None:
            solved = solver()
            result = solved.result if isinstance(solved, StrainSoftening) else solved
            heated = self.thermal.temperature(result)
            return solved, _columns(heated, result)
        found = self.thermal.self_heating(arguments, **options)
        first = found.states[0]  # reached from a cold start
        columns = _columns(first.temperature, first.result) | {"steady_states": float(len(found.states))}
        return first.softening or first.result, columns


def _columns(heated: Temperature, result: Result) -> dict[str, float]:
    return {name: float(getattr(heated, of)) for name, (of, _, _) in _RISES.items()} | bond_tractions(result)
