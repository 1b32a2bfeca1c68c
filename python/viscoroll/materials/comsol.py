"""Constants of the generalized Maxwell model of COMSOL Multiphysics: a table of branches.

Conventions, from the Structural Mechanics Module User's Guide ("Viscoelasticity", "Linear Viscoelasticity"):

- The parent material gives the long-term moduli. Each branch adds a shear modulus G_m and a relaxation time τ_m.
- "Load from file" reads a text of three columns: number of the branch, shear modulus and relaxation time.
- The shift multiplies relaxation times by a_T, log₁₀ a_T = -C₁ (T - T_ref) / (C₂ + T - T_ref), temperatures in K.

The constants of the parent material and of the shift are not part of the table. They are written as comments above it,
as `% name = value`, and read from there: G, nu or K, rho, T_ref, C1, C2.
"""

from __future__ import annotations

import math
import re

from .._support.errors import InvalidInput
from .._support.text import shown
from .deck import Deck, Found, Line, UnitSystem, number, series, unread
from .shift import Arrhenius

__all__ = ["read", "write"]

#: Names of constants in the comments.
_NAMES = ("G", "nu", "K", "rho", "T_ref", "C1", "C2")


def read(text: str, units: UnitSystem, relaxed_modulus: float | None) -> list[Found]:
    """Return the constants of a table, whose relaxed modulus [Pa] is given unless the comments contain it."""
    constants: dict[str, float] = {}
    lines: dict[str, Line] = {}
    others: list[Line] = []
    rows: list[tuple[Line, list[float]]] = []
    for place, raw in enumerate(text.splitlines(), 1):
        if named := re.match(r"\s*[%#]\s*(\w+)\s*=\s*(\S+)", raw):
            if named[1] in _NAMES:
                lines[named[1]] = Line(place, named[1], (named[2],))
                constants[named[1]] = number(named[2], lines[named[1]])
            else:
                others.append(Line(place, named[1], ()))
            continue
        cells = tuple(re.split(r"[,;\s]+", re.split(r"[%#]", raw)[0].strip(" \t,;")))
        if cells == ("",):
            continue
        line = Line(place, "branch", cells)
        if len(cells) not in (2, 3):
            raise line.error("must have a shear modulus and a relaxation time, after the number of the branch or alone")
        time = cells[-1].lower()
        infinite = time in ("inf", "infinity")
        rows.append((line, [number(cells[-2], line), math.inf if infinite else number(time, line)]))
    relaxed = constants["G"] * units.stress if "G" in constants else relaxed_modulus
    notes = unread(others)
    never_relaxes = any(time == math.inf for _, (_, time) in rows)
    if relaxed is None and not never_relaxes:
        raise InvalidInput(
            "relaxed_modulus", "must be given with a table of branches: the long-term shear modulus [Pa]"
        )
    if not rows:
        raise InvalidInput("text", "must have rows with a shear modulus and a relaxation time", "none")
    total = (relaxed or 0.0) + math.fsum(modulus for _, (modulus, _) in rows) * units.stress
    if not total > 0.0:
        raise InvalidInput("text", "must have moduli that add up to more than 0 Pa", f"{total:g}")
    terms = [(line, modulus * units.stress / total, time) for line, (modulus, time) in rows]
    found = Found(series(total, terms, units, notes), notes=notes)
    found.poisson_ratio = constants.get("nu")
    found.bulk_modulus = constants["K"] * units.stress if "K" in constants else None
    found.density = constants["rho"] * units.density if "rho" in constants else None
    if "T_ref" in constants:
        found.wlf = (constants.get("C1", 0.0), constants.get("C2", 0.0), constants["T_ref"])
        found.shift_line = lines["T_ref"]
    return [found]


def write(deck: Deck) -> str:
    """Return the table of branches below the constants of the parent material."""
    if isinstance(deck.shift, Arrhenius):
        raise InvalidInput("shift", "must be WilliamsLandelFerry or None for COMSOL", shown(deck.shift))
    constants = {"G": deck.relaxed, "nu": deck.poisson_ratio, "K": deck.bulk_modulus, "rho": deck.density}
    if deck.shift is not None:
        constants |= {"T_ref": deck.reference_temperature, "C1": deck.shift.c1, "C2": deck.shift.c2}
    lines = [*(f"% {comment}" for comment in deck.comments)]
    lines += [f"% {name} = {value!r}" for name, value in constants.items() if value is not None]
    for branch, (weight, time) in enumerate(zip(deck.weights, deck.times, strict=True), 1):
        lines.append(f"{branch} {deck.instantaneous * weight!r} {time!r}")
    return "\n".join(lines) + "\n"
