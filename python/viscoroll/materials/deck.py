"""Lines, numbers and units of other programs' constants, for the readers and writers of all programs."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from .._support.errors import InvalidInput
from .._support.text import finite_number, shown
from .moduli import MasterCurve, Prony
from .shift import Arrhenius, WilliamsLandelFerry

__all__ = [
    "UNITS",
    "Deck",
    "Found",
    "Line",
    "UnitSystem",
    "elastic_constants",
    "moduli_of",
    "number",
    "series",
    "unread",
]


@dataclass(frozen=True, slots=True)
class UnitSystem:
    """Consistent units of the numbers in a text: stress [Pa], time [s] and density [kg/m³]."""

    stress: float
    time: float
    density: float


#: Inch [m] and pound-force [N].
_INCH, _POUND_FORCE = 0.0254, 4.4482216152605

#: Consistent systems of units, named by length, mass (or force) and time.
UNITS = {
    "m-kg-s": UnitSystem(1.0, 1.0, 1.0),
    "mm-t-s": UnitSystem(1e6, 1.0, 1e12),
    "mm-kg-ms": UnitSystem(1e9, 1e-3, 1e9),
    "mm-g-ms": UnitSystem(1e6, 1e-3, 1e6),
    "cm-g-us": UnitSystem(1e11, 1e-6, 1e3),
    "in-lbf-s": UnitSystem(_POUND_FORCE / _INCH**2, 1.0, _POUND_FORCE / _INCH**4),
}


@dataclass(frozen=True, slots=True)
class Line:
    """One line or command of a text, with its number from 1 and the keyword to which it belongs, for messages."""

    number: int
    keyword: str
    cells: tuple[str, ...]

    def error(self, rule: str, value: object = "") -> InvalidInput:
        """Return an error about this line."""
        return InvalidInput(f"line {self.number} ({self.keyword})", rule, value)

    def floats(self, least: int, what: str) -> list[float]:
        """Return the numbers of the line, 0 for empty cells; raise an error if there are fewer than `least`."""
        cells = list(self.cells)
        while cells and not cells[-1]:
            cells.pop()
        if len(cells) < least:
            raise self.error(f"must have {what}", shown(", ".join(self.cells)))
        return [number(cell, self) if cell else 0.0 for cell in cells]


def unread(lines: Sequence[Line]) -> list[str]:
    """Return a note that lists the keywords of lines that a reader left out, each once; empty without such lines."""
    if not lines:
        return []
    places = {line.keyword: line.number for line in reversed(lines)}
    listed = ", ".join(f"{keyword} (line {place})" for keyword, place in sorted(places.items(), key=lambda one: one[1]))
    return [f"not read: {listed}"]


def number(cell: str, line: Line) -> float:
    """Return a number in the notation of Fortran or C, such as 1.5e3, 1.5D3 or 1.5+3."""
    text = re.sub(r"(?<=[\d.])[dD](?=[+-]?\d)", "e", cell.strip())
    text = re.sub(r"(?<=[\d.])(?=[+-]\d)", "e", text)
    value = finite_number(text)
    if value is None:
        raise line.error("must have finite numbers", shown(cell.strip()))
    return value


@dataclass(slots=True)
class Found:
    """Constants of one material in SI units, apart from temperatures, as a reader collects them."""

    modulus: Prony | MasterCurve
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    density: float | None = None
    wlf: tuple[float, float, float] | None = None  #: C₁ [-], C₂ [K] and T_r in the unit of the text
    arrhenius: tuple[float, float] | None = None  #: activation energy [J/mol] and T_r in the unit of the text
    shift_line: Line | None = None  #: line with T_r
    name: str = ""
    notes: list[str] = field(default_factory=list)


@dataclass(frozen=True, slots=True, kw_only=True)
class Deck:
    """Constants to be written, in the units of the text."""

    name: str
    instantaneous: float
    weights: tuple[float, ...]
    times: tuple[float, ...]
    relaxed: float
    table: tuple[tuple[float, float, float], ...]  #: rows of angular frequency, storage and loss of a measured table
    poisson_ratio: float | None
    bulk_modulus: float | None
    density: float | None
    shift: WilliamsLandelFerry | Arrhenius | None
    reference_temperature: float
    comments: tuple[str, ...]


def series(
    instantaneous: float, terms: Sequence[tuple[Line, float, float]], units: UnitSystem, notes: list[str]
) -> Prony:
    """Return the series with an instantaneous modulus [Pa] and terms (line, weight [-], time in the unit of the text).

    A term with an infinite time, which is written as `inf`, becomes part of the relaxed modulus, with a note.
    """
    kept = []
    for line, weight, time in terms:
        if time == float("inf"):
            notes.append(f"line {line.number}: the term that never relaxes is part of the relaxed modulus")
        elif weight < 0.0 or not time > 0.0:
            rule = "must have a weight >= 0 and a relaxation time > 0"
            raise line.error(rule, f"{weight:g} and {time:g}")
        else:
            kept.append((weight, time * units.time))
    weights, times = zip(*kept, strict=True) if kept else ((), ())
    return Prony(instantaneous_modulus=instantaneous, weights=weights, relaxation_times=times)


def moduli_of(elastic: tuple[float, float], line: Line) -> tuple[float, float]:
    """Return the shear and bulk modulus that belong to Young's modulus and Poisson's ratio; K is infinite for 0.5."""
    young, ratio = elastic
    if not young > 0.0 or not -1.0 < ratio <= 0.5:
        raise line.error("must have Young's modulus > 0 and Poisson's ratio in (-1, 0.5]", f"{young:g} and {ratio:g}")
    return young / (2.0 * (1.0 + ratio)), young / (3.0 * (1.0 - 2.0 * ratio)) if ratio < 0.5 else float("inf")


def elastic_constants(shear: float, deck: Deck) -> tuple[float, float]:
    """Return Young's modulus and Poisson's ratio that belong to a shear modulus and the compressibility of a deck."""
    if deck.bulk_modulus is not None:
        ratio = (3.0 * deck.bulk_modulus - 2.0 * shear) / (2.0 * (3.0 * deck.bulk_modulus + shear))
    elif deck.poisson_ratio is not None:
        ratio = deck.poisson_ratio
    else:
        raise InvalidInput("poisson_ratio", "or bulk_modulus must be given for this program")
    return 2.0 * shear * (1.0 + ratio), ratio
