"""Constants of LS-DYNA: *MAT_GENERAL_VISCOELASTIC (*MAT_076) and *MAT_VISCOELASTIC (*MAT_006).

Conventions, from the LS-DYNA Keyword User's Manual, volume II, of these materials, and volume I, "General card format":

- Moduli are shear moduli, G(t) = Σ G_i e^{-β_i t} in material 76, where a term with β = 0 is the relaxed modulus, and
  G(t) = GI + (G0 - GI) e^{-βt} in material 6. β is a decay rate, the inverse of a relaxation time.
- BULK is the elastic bulk modulus. The terms KI and BETAKI replace it by K(t) = Σ K_i e^{-β_ki t}.
- The shift of material 76 scales time, t' = ∫Φ dt, with Φ = exp(-A (T - T_R) / (B + T - T_R)), or
  Φ = exp(-A (1/T - 1/T_R)) for B = 0. The exponential is natural, so |A| = C₁ ln 10 and B = C₂. With t' = ∫Φ dt, A is
  negative for polymers, which relax faster at higher temperature.
- A card has eight fields of ten characters, of twenty with the suffix "+" or LONG=Y, or fields between commas.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from .._support.errors import InvalidInput
from .deck import Deck, Found, Line, UnitSystem, series, unread
from .shift import Arrhenius, WilliamsLandelFerry

__all__ = ["MOST_TERMS", "read", "write"]

#: Largest number of terms of material 76 besides the relaxed modulus, which is a term itself.
MOST_TERMS = 17

_GENERAL = ("GENERAL_VISCOELASTIC", "076", "76")
_SIMPLE = ("VISCOELASTIC", "006", "6")

_GAS_CONSTANT = 8.314462618  # [J/(mol K)], CODATA 2018


def read(text: str, units: UnitSystem) -> list[Found]:
    """Return the constants of all materials 76 and 6 of a text."""
    found = []
    added: list[Line] = []
    for line, cards in _blocks(text):
        keyword = line.keyword
        kind = keyword.removeprefix("*MAT_").removesuffix("_TITLE")
        if keyword.startswith("*MAT_ADD_"):
            added.append(line)
        if kind not in (*_GENERAL, *_SIMPLE):
            continue
        name = ""
        if keyword.endswith("_TITLE"):
            name = cards[0].cells[0] if cards else ""
            cards = cards[1:]
        if not cards:
            raise InvalidInput(keyword, "must have cards", "none")
        read_material = _general if kind in _GENERAL else _simple
        found.append(read_material(name, cards, units))
    for one in found:
        one.notes += unread(added)
    return found


def _blocks(text: str) -> Iterator[tuple[Line, list[Line]]]:
    """Iterate over the keywords of a text with their cards. A blank card is one of zeros, unless it ends the text."""
    keyword, start, width, default = "", 0, 10, 10
    cards: list[Line] = []
    for place, raw in enumerate(text.rstrip().splitlines(), 1):
        if raw.startswith("$"):
            continue
        if raw.startswith("*"):
            if keyword:
                yield Line(start, keyword, ()), cards
            words = raw.upper().split()
            if words[0] == "*KEYWORD" and "LONG=Y" in words:
                default = 20
            suffix = words[0][-1] if words[0][-1] in "+-%" else next((w for w in words[1:] if w in "+-%"), "")
            width = {"+": 20, "-": 10, "%": 10}.get(suffix, default)
            keyword, start, cards = words[0].rstrip("+-%"), place, []
            continue
        if keyword.endswith("_TITLE") and not cards:
            cut = [raw]
        elif "," in raw:
            cut = raw.split(",")
        else:
            cut = [raw[i : i + width] for i in range(0, len(raw.rstrip()), width)]
        cards.append(Line(place, keyword, tuple(cell.strip() for cell in cut)))
    if keyword:
        yield Line(start, keyword, ()), cards


def _general(name: str, cards: list[Line], units: UnitSystem) -> Found:
    head = cards[0].floats(3, "the fields MID, RO and BULK") + [0.0] * 8
    fit = (cards[1].floats(0, "") if len(cards) > 1 else []) + [0.0] * 8
    if fit[0] != 0.0 or fit[4] != 0.0:
        raise cards[1].error("must be blank, because only constants are read, not load curves", f"{fit[0]:g}")
    rows = [(card, (card.floats(0, "") + [0.0] * 4)[:4]) for card in cards[2:]]
    rows = [(card, row) for card, row in rows if any(row)]
    notes: list[str] = []
    total = math.fsum(row[0] for _, row in rows)
    if not total > 0.0:
        raise cards[0].error("must have cards with GI and BETAI whose moduli add up to more than 0", f"{total:g}")
    terms = []
    for card, (shear, decay, _, _) in rows:
        if decay < 0.0:
            raise card.error("must have BETAI >= 0", f"{decay:g}")
        terms.append((card, shear / total, 1.0 / decay if decay > 0.0 else math.inf))
    found = Found(series(total * units.stress, terms, units, notes), name=name or f"{head[0]:g}", notes=notes)
    _bulk(found, head[2], rows, units)
    found.density = head[1] * units.density if head[1] > 0.0 else None
    _shift(found, cards[0], head[5:8])
    return found


def _bulk(found: Found, bulk: float, rows: list[tuple[Line, list[float]]], units: UnitSystem) -> None:
    """Set Poisson's ratio if shear and bulk modulus relax in proportion, and the bulk modulus otherwise."""
    if not any(row[2] for _, row in rows):
        if bulk > 0.0:
            found.bulk_modulus = bulk * units.stress
        return
    ratio = rows[0][1][2] / rows[0][1][0] if rows[0][1][0] else math.inf
    if all(row[1] == row[3] and math.isclose(row[2], ratio * row[0], rel_tol=1e-6) for _, row in rows):
        found.poisson_ratio = (3.0 * ratio - 2.0) / (2.0 * (3.0 * ratio + 1.0))
    else:
        found.bulk_modulus = math.fsum(row[2] for _, row in rows) * units.stress
        found.notes.append("the relaxation of the bulk modulus is left out: a layer has a constant bulk modulus")


def _shift(found: Found, card: Line, values: list[float]) -> None:
    reference, a, b = values
    if a == 0.0 or reference == 0.0:
        return
    found.shift_line = card
    if b == 0.0:
        found.arrhenius = (abs(a) * _GAS_CONSTANT, reference)
    else:
        found.wlf = (abs(a) / math.log(10.0), b, reference)
    if (a > 0.0) == (b != 0.0):
        law = "(T - T_R) / (B + T - T_R)" if b else "(1/T - 1/T_R)"
        found.notes.append(
            f"line {card.number}: A = {a:g} slows relaxation at higher temperature if time is scaled by exp(-A {law}); "
            "its magnitude is used, with relaxation that is faster at higher temperature"
        )


def _simple(name: str, cards: list[Line], units: UnitSystem) -> Found:
    head = cards[0].floats(6, "the fields MID, RO, BULK, G0, GI and BETA")
    _, density, bulk, short, long, decay = head[:6]
    if not (short > 0.0 and 0.0 <= long <= short and decay > 0.0):
        raise cards[0].error("must have 0 <= GI <= G0, G0 > 0 and BETA > 0", f"{long:g}, {short:g} and {decay:g}")
    terms = [(cards[0], 1.0 - long / short, 1.0 / decay)]
    return Found(
        series(short * units.stress, terms, units, []),
        name=name or f"{head[0]:g}",
        bulk_modulus=bulk * units.stress if bulk > 0.0 else None,
        density=density * units.density if density > 0.0 else None,
    )


def write(deck: Deck) -> str:
    """Return the cards of material 76 with fields of twenty characters, which hold 14 digits."""
    if deck.density is None:
        raise InvalidInput("density", "must be given for LS-DYNA")
    if len(deck.weights) > MOST_TERMS:
        rule = f"must be <= {MOST_TERMS} for LS-DYNA: give terms= and tolerance="
        raise InvalidInput("terms", rule, len(deck.weights))
    per_shear = _bulk_per_shear(deck)
    bulk = deck.bulk_modulus if deck.bulk_modulus is not None else per_shear * deck.instantaneous
    lines = [
        *(f"$ {comment}" for comment in deck.comments),
        "*MAT_GENERAL_VISCOELASTIC_TITLE+",
        deck.name,
        "1".rjust(20) + _card(deck.density, bulk, 0.0, 0.0, *_shift_fields(deck)),
        "0".rjust(20),
    ]
    moduli = [(deck.relaxed, 0.0)] if deck.relaxed > 0.0 else []
    moduli += [(deck.instantaneous * w, 1.0 / t) for w, t in zip(deck.weights, deck.times, strict=True)]
    for modulus, decay in moduli:
        of_bulk = () if deck.bulk_modulus is not None else (per_shear * modulus, decay)
        lines.append(_card(modulus, decay, *of_bulk))
    return "\n".join(lines) + "\n"


def _bulk_per_shear(deck: Deck) -> float:
    if deck.bulk_modulus is not None:
        return 0.0
    if deck.poisson_ratio is None or deck.poisson_ratio >= 0.5:
        raise InvalidInput("bulk_modulus", "must be given for LS-DYNA if Poisson's ratio is 0.5 or not given")
    return 2.0 * (1.0 + deck.poisson_ratio) / (3.0 * (1.0 - 2.0 * deck.poisson_ratio))


def _shift_fields(deck: Deck) -> tuple[float, float, float]:
    if isinstance(deck.shift, WilliamsLandelFerry):
        return deck.reference_temperature, -deck.shift.c1 * math.log(10.0), deck.shift.c2
    if isinstance(deck.shift, Arrhenius):
        return deck.reference_temperature, deck.shift.activation_energy / _GAS_CONSTANT, 0.0
    return 0.0, 0.0, 0.0


def _card(*values: float) -> str:
    return "".join(f"{value:.13e}".rjust(20) for value in values)
