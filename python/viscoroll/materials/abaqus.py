"""Constants of Abaqus: *ELASTIC or *HYPERELASTIC with *VISCOELASTIC and *TRS.

Conventions, from the Abaqus Keywords Reference Guide (*ELASTIC, *HYPERELASTIC, *VISCOELASTIC, *TRS) and the Abaqus
Analysis User's Guide ("Time domain viscoelasticity", "Frequency domain viscoelasticity"):

- Moduli are long-term ones unless MODULI=INSTANTANEOUS is given; in the frequency domain they are always long-term.
- The weights g_i and k_i are relative to the instantaneous moduli in either case: g_R(t) = 1 - Σ g_i (1 - e^{-t/τ_i}).
- A frequency table has the rows ωR(g*) = G''/G_∞, ωI(g*) = 1 - G'/G_∞, the same for K, and f in cycles per time.
- The shift is log₁₀ A = -C₁ (θ - θ₀) / (C₂ + θ - θ₀), by which relaxation times are multiplied.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

import numpy as np

from .._support.errors import InvalidInput
from .._support.text import shown
from .deck import Deck, Found, Line, UnitSystem, elastic_constants, moduli_of, series, unread
from .moduli import MasterCurve
from .shift import Arrhenius

__all__ = ["read", "write"]

#: Keywords below *MATERIAL that are read. A note lists other keywords of a material, such as *DAMPING.
_READ = ("DENSITY", "ELASTIC", "HYPERELASTIC", "VISCOELASTIC", "TRS")

#: First words of keywords that end a material.
_OUTSIDE = re.compile(
    "(AMPLITUDE|ASSEMBLY|BOUNDARY|COHESIVE|CONNECTOR|CONTACT|COUPLING|ELEMENT|ELSET|END|EQUATION|FRICTION|GAP|HEADING"
    "|INITIAL|INSTANCE|KINEMATIC|MEMBRANE|MPC|NODE|NSET|ORIENTATION|PART|PHYSICAL|PREPRINT|RIGID|SHELL|SOLID|STEP"
    r"|SURFACE|SYSTEM|TIE|TRANSFORM)\b"
)

#: Coefficients of the initial shear modulus of strain energies, and the number of the coefficient D₁ [1/stress].
_ENERGIES = {"NEO HOOKE": ((2.0,), 1), "MOONEY-RIVLIN": ((2.0, 2.0), 2), "YEOH": ((2.0,), 3)}


class _Option:
    """Keyword with its parameters and data lines."""

    def __init__(self, line: Line) -> None:
        self.line = line
        self.parameters = {}
        for cell in line.cells:
            name, _, value = cell.partition("=")
            self.parameters[" ".join(name.upper().split())] = " ".join(value.upper().split())
        self.name = line.keyword
        self.rows: list[Line] = []

    def only_row(self) -> Line:
        if len(self.rows) != 1:
            raise self.line.error("must have one data line, for one temperature", f"{len(self.rows)} lines")
        return self.rows[0]

    def moduli_are_long_term(self) -> bool:
        given = self.parameters.get("MODULI", "LONG TERM")
        if given not in ("LONG TERM", "INSTANTANEOUS"):
            raise self.line.error("must have MODULI=LONG TERM or MODULI=INSTANTANEOUS", given)
        return given == "LONG TERM"


@dataclass(slots=True)
class _Material:
    """Name of a material with its options, and the lines of other keywords below it."""

    name: str = ""
    options: dict[str, _Option] = field(default_factory=dict)
    unread: list[Line] = field(default_factory=list)


def read(text: str, units: UnitSystem) -> list[Found]:
    """Return the constants of all viscoelastic materials of a text."""
    return [_material(material, units) for material in _materials(text) if "VISCOELASTIC" in material.options]


def _materials(text: str) -> list[_Material]:
    """Return the materials of a text. Options outside of a material belong to one without name."""
    materials = [_Material()]
    option: _Option | None = None
    inside = True
    pending = ""
    for number, raw in enumerate(text.splitlines(), 1):
        line = raw.strip()
        if not line or line.startswith("**"):
            continue
        if line.startswith("*") or pending:
            line = pending + line
            pending = line if line.endswith(",") else ""
            if pending:
                continue
            keyword, *parameters = (cell.strip() for cell in line[1:].split(","))
            name = " ".join(keyword.upper().split())
            option = _Option(Line(number, f"*{name}", tuple(parameters)))
            if name == "MATERIAL":
                label = next((p.partition("=")[2].strip() for p in parameters if p.upper().startswith("NAME")), "")
                materials.append(_Material(label.strip('"')))
                inside = True
            elif name in _READ:
                if name in materials[-1].options:
                    raise option.line.error("must occur once in a material")
                materials[-1].options[name] = option
                inside = True
            elif _OUTSIDE.match(name):
                inside = False
            elif inside:
                materials[-1].unread.append(option.line)
            continue
        if option is not None:
            option.rows.append(Line(number, option.name, tuple(cell.strip() for cell in line.split(","))))
    return materials


def _material(material: _Material, units: UnitSystem) -> Found:
    name, options = material.name, material.options
    viscous = options["VISCOELASTIC"]
    domain = {key: viscous.parameters[key] for key in ("TIME", "FREQUENCY") if key in viscous.parameters}
    kind = next(iter(domain.items()), ("", ""))
    if kind not in (("TIME", "PRONY"), ("FREQUENCY", "PRONY"), ("FREQUENCY", "TABULAR")):
        raise viscous.line.error(
            "must have TIME=PRONY, FREQUENCY=PRONY or FREQUENCY=TABULAR; fit a series to other data first",
            shown("=".join(kind).strip("=")),
        )
    if "PRELOAD" in viscous.parameters:
        raise viscous.line.error("must be left without PRELOAD")
    elastic, shear, bulk = _elastic(name, options, units)
    notes = unread(material.unread)
    long_term = elastic.moduli_are_long_term()
    if kind[0] == "FREQUENCY" and not long_term:
        raise elastic.line.error("must have MODULI=LONG TERM in the frequency domain", "INSTANTANEOUS")
    if kind[1] == "TABULAR":
        found = _table(viscous, shear, bulk, units, notes)
    else:
        found = _prony(viscous, shear, bulk, long_term, units, notes)
    found.name = name
    if "DENSITY" in options:
        found.density = options["DENSITY"].only_row().floats(1, "a density")[0] * units.density
    if "TRS" in options:
        found.wlf, found.shift_line = _shift(options["TRS"]), options["TRS"].line
    return found


def _elastic(name: str, options: dict[str, _Option], units: UnitSystem) -> tuple[_Option, float, float]:
    """Return the option of the elastic constants, and shear and bulk modulus [Pa]."""
    given = [options[key] for key in ("ELASTIC", "HYPERELASTIC") if key in options]
    if len(given) != 1:
        got = " and ".join(option.name for option in given) or "neither"
        material = f"*MATERIAL, NAME={name}" if name else "the text"
        raise InvalidInput(material, "must have *ELASTIC or *HYPERELASTIC with *VISCOELASTIC", got)
    option = given[0]
    row = option.only_row()
    if option.name == "*ELASTIC":
        if option.parameters.get("TYPE", "ISOTROPIC") not in ("ISOTROPIC", "ISO"):
            raise option.line.error("must have TYPE=ISOTROPIC", option.parameters["TYPE"])
        young, ratio = [*row.floats(1, "Young's modulus and Poisson's ratio"), 0.0][:2]
        shear, bulk = moduli_of((young, ratio), row)
    else:
        energy = next((energy for energy in _ENERGIES if energy in option.parameters), None)
        if energy is None or "TEST DATA INPUT" in option.parameters:
            raise option.line.error(
                f"must have coefficients of one of {', '.join(_ENERGIES)}", shown(option.line.cells)
            )
        factors, place = _ENERGIES[energy]
        numbers = row.floats(len(factors), f"{place + 1} coefficients of {energy}") + [0.0] * 4
        shear = sum(factor * value for factor, value in zip(factors, numbers, strict=False))
        if not shear > 0.0 or numbers[place] < 0.0:
            raise row.error("must have a shear modulus > 0 and D1 >= 0", f"{shear:g} and {numbers[place]:g}")
        bulk = 2.0 / numbers[place] if numbers[place] > 0.0 else float("inf")
    return option, shear * units.stress, bulk * units.stress


def _prony(viscous: _Option, shear: float, bulk: float, long_term: bool, units: UnitSystem, notes: list[str]) -> Found:
    columns = [line.floats(3, "the columns g_i, k_i and tau_i") for line in viscous.rows]
    if not columns:
        raise viscous.line.error("must have data lines with g_i, k_i and tau_i", "none")
    if len({tuple(row[3:]) for row in columns}) > 1:
        raise viscous.line.error("must have constants of one temperature", "several")
    sums = [math.fsum(row[column] for row in columns) for column in (0, 1)]
    if long_term and not max(sums) < 1.0:
        raise viscous.line.error("must have sums of g_i and of k_i < 1 with MODULI=LONG TERM", f"{max(sums):g}")
    instantaneous = shear / (1.0 - sums[0]) if long_term else shear
    terms = [(line, row[0], row[2]) for line, row in zip(viscous.rows, columns, strict=True)]
    modulus = series(instantaneous, terms, units, notes)
    found = Found(modulus, notes=notes)
    _compressibility(found, bulk, shear, [row[0] for row in columns], [row[1] for row in columns])
    return found


def _table(viscous: _Option, shear: float, bulk: float, units: UnitSystem, notes: list[str]) -> Found:
    what = "the real and imaginary parts of omega g* and omega k*, and the frequency"
    rows = sorted((line.floats(5, what) for line in viscous.rows), key=lambda row: row[4])
    table = np.array(rows).reshape(-1, 5)
    if len(rows) < 2:
        raise viscous.line.error("must have at least two data lines", len(rows))
    frequency = 2.0 * np.pi * table[:, 4] / units.time
    modulus = MasterCurve(
        frequency=[0.0, *frequency.tolist()],
        storage=[shear, *(shear * (1.0 - table[:, 1])).tolist()],
        loss=[0.0, *(shear * table[:, 0]).tolist()],
    )
    found = Found(modulus, notes=notes)
    _compressibility(found, bulk, shear, table[:, :2].ravel().tolist(), table[:, 2:4].ravel().tolist())
    return found


def _compressibility(found: Found, bulk: float, shear: float, g: list[float], k: list[float]) -> None:
    """Set the bulk modulus if only the shear modulus relaxes, and Poisson's ratio if both relax equally."""
    if bulk == float("inf"):
        found.poisson_ratio = 0.5
    elif g == k:
        found.poisson_ratio = (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))
    else:
        found.bulk_modulus = bulk
        if any(k):
            found.notes.append("the relaxation of the bulk modulus is left out: a layer has a constant bulk modulus")


def _shift(option: _Option) -> tuple[float, float, float]:
    if option.parameters.get("DEFINITION", "WLF") != "WLF":
        raise option.line.error("must have DEFINITION=WLF", option.parameters["DEFINITION"])
    reference, c1, c2 = option.only_row().floats(3, "theta_0, C1 and C2")[:3]
    return c1, c2, reference


def write(deck: Deck) -> str:
    """Return the lines of a material."""
    if isinstance(deck.shift, Arrhenius):
        raise InvalidInput("shift", "must be WilliamsLandelFerry or None for Abaqus", shown(deck.shift))
    lines = [*(f"** {comment}" for comment in deck.comments), f"*MATERIAL, NAME={deck.name}"]
    if deck.density is not None:
        lines += ["*DENSITY", f"{deck.density!r},"]
    if deck.table:
        young, ratio = elastic_constants(deck.relaxed, deck)
        lines += ["*ELASTIC, MODULI=LONG TERM", f"{young!r}, {ratio!r}", "*VISCOELASTIC, FREQUENCY=TABULAR"]
        for omega, storage, loss in deck.table:
            g = (loss / deck.relaxed, 1.0 - storage / deck.relaxed)
            k = (0.0, 0.0) if deck.bulk_modulus is not None else g
            lines.append(", ".join(repr(value) for value in (*g, *k, omega / (2.0 * math.pi))))
    else:
        young, ratio = elastic_constants(deck.instantaneous, deck)
        lines += [
            "*ELASTIC, MODULI=INSTANTANEOUS",
            f"{young!r}, {ratio!r}",
            *["*VISCOELASTIC, TIME=PRONY"] * bool(deck.weights),
        ]
        for weight, time in zip(deck.weights, deck.times, strict=True):
            lines.append(f"{weight!r}, {0.0 if deck.bulk_modulus is not None else weight!r}, {time!r}")
    if deck.shift is not None:
        lines += ["*TRS", f"{deck.reference_temperature!r}, {deck.shift.c1!r}, {deck.shift.c2!r}"]
    return "\n".join(lines) + "\n"
