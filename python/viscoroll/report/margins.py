"""Results of a case beside the limits of its table [design]."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .._support.celsius import kelvin_text
from .._support.quantities import percent_text
from ..case.limits import Outcome, limit_label, limit_text, outcome_at
from ..solution.scalars import SCALARS
from ..solution.text import relative_error, scalar_text

if TYPE_CHECKING:
    from ..case import Case
    from ..case.solved import SolvedCase

__all__ = ["Margin", "margins_of"]


@dataclass(frozen=True, slots=True)
class Margin:
    """A limited result.

    Attributes
    ----------
    label, value, limit : str
        Label, result with its error, and limit.
    margin : str
        Part of the limit that is left in percent, or by how much the limit is exceeded; of a temperature, in K.
    state : {"kept", "uncertain", "exceeded"}
        Whether the result satisfies the limit. "uncertain": the limit is within the error of the result.
    """

    label: str
    value: str
    limit: str
    margin: str
    state: str


def margins_of(case: Case, solved: SolvedCase, limits: Mapping[str, float]) -> list[Margin]:
    """Return the limited results of a solved case; `limits` are in SI units, by name.

    Raises
    ------
    ValueError
        If the case lacks a limited result.
    """
    if not limits:
        return []
    heated = solved.temperatures[0] if solved.temperatures else None
    outcome = outcome_at(case, limits, solved.result, heated, solved.heated)
    return [_margin(name, limit, outcome) for name, limit in limits.items()]


def _margin(name: str, limit: float, outcome: Outcome) -> Margin:
    value, unit, label = outcome.value(name), outcome.unit(name), limit_label(name, outcome.result.body)
    error = relative_error(outcome.result, name) if name in SCALARS else None
    is_kept, is_uncertain = value <= limit, abs(value - limit) <= abs((error or 0.0) * value)
    state = "uncertain" if is_uncertain else "kept" if is_kept else "exceeded"
    meaning = {"kept": "", "exceeded": ", exceeded", "uncertain": ", within the error of the result"}[state]
    largest = limit_text(name, limit, unit)
    if unit == "K":
        return Margin(label, kelvin_text(value), largest, f"{limit - value:.3g} K{meaning}", state)
    text = scalar_text(outcome.result, name) if name in SCALARS else limit_text(name, value, unit)
    left = percent_text(1.0 - value / limit) if is_kept else f"{value / limit:.3g} times the limit"
    return Margin(label, text, largest, left + meaning, state)
