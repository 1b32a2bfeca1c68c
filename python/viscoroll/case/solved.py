"""Solution of a case with its temperatures and its softening, as the command line reports it."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .._support.progress import ProgressLike
from .._support.quantities import quantity_text, quantity_texts
from .._support.result_warnings import ResultWarning
from ..solution.scalars import label_of
from ..solution.text import relative_error, result_warnings
from ..thermal.temperature import QUANTITIES
from .limits import BOND_QUANTITIES, bond_tractions
from .plausible import speed_warning

if TYPE_CHECKING:
    from ..coupled import SelfHeating, StrainSoftening
    from ..rolling import Result
    from ..thermal import Temperature
    from .case import Case

__all__ = ["SolvedCase", "recorded_warnings", "solve_case"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class SolvedCase:
    """Solution of a case.

    Attributes
    ----------
    result : Result
        Result of the case; with self-heating, that of the state which a cold start reaches.
    temperatures : tuple of Temperature
        Temperature, or with self-heating that of every steady state; empty without a table [thermal].
    heated : SelfHeating or None
        Steady states, if the table [thermal] has a shift.
    softened : StrainSoftening or None
        Strain and moduli of the layers, if some of them soften with strain.
    bonds : dict
        Largest tractions at bonded interfaces [Pa], "bond_shear" and "bond_tension", with a table [thermal].
    warnings : tuple of str
        Texts of all warnings.
    """

    result: Result
    temperatures: tuple[Temperature, ...]
    heated: SelfHeating | None
    softened: StrainSoftening | None
    bonds: dict[str, float]
    warnings: tuple[str, ...]

    def thermal_scalars(self) -> list[dict[str, float | str]]:
        """Return the reported numbers of every temperature, in SI units."""
        scalars: list[dict[str, float | str]] = []
        for number, found in enumerate(self.temperatures):
            row: dict[str, float | str] = {name: getattr(found, name) for name in QUANTITIES}
            if self.heated is not None:
                state = self.heated.states[number]
                row |= {
                    "mean_temperature": state.mean_temperature,
                    "resisting_torque": state.result.resisting_torque,
                    "stability": "stable" if state.stable else "unstable",
                }
            scalars.append(row)
        return scalars

    def thermal_rows(self) -> list[tuple[str, Sequence[str]]]:
        """Return the label of each reported number of a temperature, and its text for every state.

        Without self-heating, rises and heat flows are proportional to the dissipated power and have its relative error.
        """
        scalars = self.thermal_scalars()
        quantities = {
            name: (found.unit(name), label)
            for found in self.temperatures[:1]
            for name, (_, label) in QUANTITIES.items()
        }
        if self.heated is not None:
            result = self.heated.states[0].result
            quantities["mean_temperature"] = ("K", "mean temperature of the layers")
            quantities["resisting_torque"] = (
                result.unit("resisting_torque"),
                label_of("resisting_torque", result.body),
            )
        rows: list[tuple[str, Sequence[str]]] = []
        for name, (unit, label) in quantities.items():
            error = relative_error(self.result, "dissipated_power") if self.heated is None else None
            texts, readable = quantity_texts([float(row[name]) for row in scalars], unit, [error] * len(scalars))
            rows.append((label, [f"{text} {readable}" for text in texts]))
        if self.heated is not None:
            rows.append(("steady state", [str(row["stability"]) for row in scalars]))
        for name, (unit, label) in BOND_QUANTITIES.items():
            if name in self.bonds:
                rows.append((label, [quantity_text(self.bonds[name], unit), *[""] * (len(scalars) - 1)]))
        return rows


@contextmanager
def recorded_warnings() -> Iterator[list[str]]:
    """Open a block that records warnings about results; the list has their texts when the block ends."""
    texts: list[str] = []
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", ResultWarning)
        yield texts
    texts += [str(warning.message) for warning in caught if issubclass(warning.category, ResultWarning)]


def solve_case(case: Case, *, progress: ProgressLike = None) -> SolvedCase:
    """Solve a case, and compute the temperature if it has a table [thermal].

    Parameters
    ----------
    case : Case
        Case to solve. If heat or strain changes its moduli, the result is that with the moduli found.
    progress : bool or callable, optional
        True shows a bar. A function is called as progress(stage, fraction).

    Raises
    ------
    ValueError, ConvergenceError
        Same as in `viscoroll.solve`, `viscoroll.self_heating` and `viscoroll.strain_softening`.
    """
    heated: SelfHeating | None = None
    softened: StrainSoftening | None = None
    with recorded_warnings() as issued:
        if case.thermal is not None and case.thermal.shift is not None:
            heated = case.self_heating(progress=progress)
            result, softened = heated.states[0].result, heated.states[0].softening  # reached from a cold start
        elif case.softens:
            softened = case.strain_softening(progress=progress)
            result = softened.result
        else:
            result = case.solve(progress=progress)
        temperatures = [] if heated is None else [state.temperature for state in heated.states]
        if case.thermal is not None and heated is None:
            temperatures = [case.thermal.temperature(result, progress=progress)]
    fast = speed_warning(result.angular_speed, result.body.outer_radius)
    found = [*filter(None, [fast]), *result_warnings(result), *issued]
    return SolvedCase(
        result=result,
        temperatures=tuple(temperatures),
        heated=heated,
        softened=softened,
        bonds={} if case.thermal is None else bond_tractions(result),
        warnings=tuple(dict.fromkeys(found)),
    )
