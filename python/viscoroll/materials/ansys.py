"""Constants of Ansys Mechanical APDL: MP or TB,HYPER with TB,PRONY and TB,SHIFT.

Conventions, from the Mechanical APDL Material Reference ("Viscoelasticity") and the Command Reference (TB, TBDATA, MP):

- MP,EX with MP,NUXY or MP,PRXY, TB,ELASTIC and TB,HYPER give the instantaneous moduli.
- TB,PRONY,,,,SHEAR holds pairs of relative moduli and times, G(t) = G₀ (α_∞ + Σ α_i e^{-t/τ_i}); the option BULK holds
  those of the bulk modulus, which without them does not relax.
- TB,SHIFT,,,,WLF holds T_r, C₁ and C₂ of log₁₀ A = C₁ (T - T_r) / (C₂ + T - T_r). Relaxation times are divided by A.
"""

from __future__ import annotations

import re

from .._support.errors import InvalidInput
from .._support.text import finite_number, shown
from .deck import Deck, Found, Line, UnitSystem, elastic_constants, moduli_of, number, series, unread
from .shift import Arrhenius

__all__ = ["read", "write"]

#: Options of TB,SHIFT that stand for the Williams-Landel-Ferry law.
_WLF = ("WLF", "1")

#: Tables that are read; a note lists others.
_TABLES = ("ELASTIC", "HYPER", "PRONY", "SHIFT")


class _Table:
    """Table that a TB command opens, with its option and the constants of TBDATA commands by their position from 1."""

    def __init__(self, line: Line, option: str) -> None:
        self.line = line
        self.option = option
        self.values: dict[int, tuple[Line, float]] = {}

    def value(self, place: int, what: str) -> float:
        if place not in self.values:
            raise self.line.error(f"must have {what} as constant {place} of TBDATA")
        return self.values[place][1]


class _Material:
    """Properties and tables of one material number."""

    def __init__(self) -> None:
        self.properties: dict[str, tuple[Line, float]] = {}
        self.tables: dict[tuple[str, str], _Table] = {}
        self.unread: list[Line] = []


def read(text: str, units: UnitSystem) -> list[Found]:
    """Return the constants of all viscoelastic materials of a text."""
    found = _materials(text)
    return [_material(name, m, units) for name, m in found.items() if ("PRONY", "SHEAR") in m.tables]


def _materials(text: str) -> dict[str, _Material]:
    materials: dict[str, _Material] = {}
    parameters: dict[str, str] = {}
    table: _Table | None = None
    for line in _commands(text):
        command, cells = line.keyword.upper(), [parameters.get(cell.upper(), cell) for cell in line.cells]
        resolved = Line(line.number, line.keyword, tuple(cells))
        cells += [""] * 5
        if "=" in line.keyword and not line.cells:
            name, _, value = (part.strip() for part in line.keyword.partition("="))
            parameters[name.upper()] = value
        elif command in ("MP", "MPDATA"):
            property_, material = cells[0].upper(), cells[1]
            values = [cell for cell in cells[(2 if command == "MP" else 3) :] if cell]
            if property_ not in ("EX", "NUXY", "PRXY", "DENS"):
                _of(materials, material).unread.append(Line(line.number, f"{command},{property_}", ()))
                continue
            if len(values) != 1:
                raise resolved.error("must have one constant: those of one temperature", shown(",".join(line.cells)))
            _of(materials, material).properties[property_] = (resolved, number(values[0], resolved))
        elif command == "TB":
            kind, material, option = cells[0].upper(), cells[1], cells[4].upper()
            if finite_number(cells[2] or "1") not in (0.0, 1.0):
                raise resolved.error("must have constants of one temperature", f"{cells[2]} temperatures")
            if kind == "PRONY" and option not in ("SHEAR", "BULK"):
                raise resolved.error("must have the option SHEAR or BULK", option or "none")
            if kind == "SHIFT" and option not in _WLF:
                raise resolved.error("must have the option WLF", option or "none")
            if kind not in _TABLES:
                _of(materials, material).unread.append(Line(line.number, f"TB,{kind}", ()))
            table = _Table(resolved, option)
            _of(materials, material).tables[kind, option if kind == "PRONY" else ""] = table
        elif command == "TBDATA" and table is not None:
            start = int(number(cells[0], resolved)) if cells[0] else max(table.values, default=0) + 1
            for offset, cell in enumerate(cells[1:]):
                if cell:
                    table.values[start + offset] = (resolved, number(cell, resolved))
        elif command.startswith("TB") and materials:
            list(materials.values())[-1].unread.append(Line(line.number, command, ()))
    return materials


def _commands(text: str) -> list[Line]:
    """Return the commands of a text, which end at a line break or at a dollar sign; ! begins a comment."""
    lines = []
    for place, raw in enumerate(text.splitlines(), 1):
        for command in re.split(r"\$", raw.partition("!")[0]):
            name, *cells = (cell.strip() for cell in command.split(","))
            if name:
                lines.append(Line(place, name, tuple(cells)))
    return lines


def _of(materials: dict[str, _Material], name: str) -> _Material:
    return materials.setdefault(name or "1", _Material())


def _material(name: str, material: _Material, units: UnitSystem) -> Found:
    shear, bulk = _moduli(material)
    notes = unread(material.unread)
    terms = _pairs(material.tables["PRONY", "SHEAR"])
    found = Found(series(shear * units.stress, terms, units, notes), name=name, notes=notes)
    of_bulk = _pairs(material.tables["PRONY", "BULK"]) if ("PRONY", "BULK") in material.tables else []
    if bulk == float("inf"):
        found.poisson_ratio = 0.5
    elif [term[1:] for term in terms] == [term[1:] for term in of_bulk]:
        found.poisson_ratio = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))
    else:
        found.bulk_modulus = bulk * units.stress
        if any(weight for _, weight, _ in of_bulk):
            notes.append("the relaxation of the bulk modulus is left out: a layer has a constant bulk modulus")
    if "DENS" in material.properties:
        found.density = material.properties["DENS"][1] * units.density
    if shift := material.tables.get(("SHIFT", "")):
        reference, c1, c2 = (shift.value(i, what) for i, what in enumerate(("T_r", "C1", "C2"), 1))
        found.wlf, found.shift_line = (c1, c2, reference), shift.line
    return found


def _moduli(material: _Material) -> tuple[float, float]:
    """Return the instantaneous shear and bulk modulus in the unit of the text."""
    if hyper := material.tables.get(("HYPER", "")):
        if hyper.option not in ("NEO", "MOONEY"):
            raise hyper.line.error("must have the option NEO or MOONEY", hyper.option or "none")
        count = 1 if hyper.option == "NEO" else 2
        constants = [hyper.value(i, "a coefficient") for i in range(1, count + 1)]
        shear = constants[0] if count == 1 else 2.0 * sum(constants)
        d = hyper.values.get(count + 1, (hyper.line, 0.0))[1]
        if not shear > 0.0 or d < 0.0:
            raise hyper.line.error("must have a shear modulus > 0 and d >= 0", f"{shear:g} and {d:g}")
        return shear, 2.0 / d if d > 0.0 else float("inf")
    if elastic := material.tables.get(("ELASTIC", "")):
        return moduli_of((elastic.value(1, "Young's modulus"), elastic.value(2, "Poisson's ratio")), elastic.line)
    ratio = material.properties.get("PRXY") or material.properties.get("NUXY")
    young = material.properties.get("EX")
    if young is None or ratio is None:
        line = material.tables["PRONY", "SHEAR"].line
        raise line.error("must have MP,EX and MP,NUXY, or TB,ELASTIC or TB,HYPER, for the same material")
    return moduli_of((young[1], ratio[1]), young[0])


def _pairs(table: _Table) -> list[tuple[Line, float, float]]:
    """Return the pairs of relative modulus and time. A pair of zeros, with which decks fill a table, is left out."""
    count = (max(table.values, default=0) + 1) // 2
    if count == 0:
        raise table.line.error("must have pairs of relative modulus and time in TBDATA", "none")
    pairs = []
    for i in range(count):
        weight, time = (table.value(2 * i + j, "a relative modulus and a time in pairs") for j in (1, 2))
        if weight != 0.0 or time != 0.0:
            pairs.append((table.values[2 * i + 1][0], weight, time))
    return pairs


def write(deck: Deck) -> str:
    """Return the commands of material 1."""
    if isinstance(deck.shift, Arrhenius):
        raise InvalidInput("shift", "must be WilliamsLandelFerry or None for Ansys", shown(deck.shift))
    young, ratio = elastic_constants(deck.instantaneous, deck)
    lines = [*(f"! {comment}" for comment in deck.comments), f"MP,EX,1,{young!r}", f"MP,NUXY,1,{ratio!r}"]
    if deck.density is not None:
        lines.append(f"MP,DENS,1,{deck.density!r}")
    relaxing = ("SHEAR",) if deck.bulk_modulus is not None else ("SHEAR", "BULK")
    for option in relaxing if deck.weights else ():
        lines.append(f"TB,PRONY,1,1,{len(deck.weights)},{option}")
        for i, (weight, time) in enumerate(zip(deck.weights, deck.times, strict=True)):
            lines.append(f"TBDATA,{2 * i + 1},{weight!r},{time!r}")
    if deck.shift is not None:
        values = (deck.reference_temperature, deck.shift.c1, deck.shift.c2)
        lines += ["TB,SHIFT,1,1,3,WLF", "TBDATA,1," + ",".join(repr(value) for value in values)]
    return "\n".join(lines) + "\n"
