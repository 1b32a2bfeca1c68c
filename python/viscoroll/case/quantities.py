"""Units of case files, and conversion of texts such as "10 mm" to SI units by pint (the extra `viscoroll[cli]`)."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from functools import cache
from importlib import resources
from tokenize import TokenError
from typing import TYPE_CHECKING, Any

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.text import shown

if TYPE_CHECKING:
    from pint import UnitRegistry

__all__ = [
    "CENTER_SPEED",
    "DISPLAYED",
    "QUANTITY",
    "SPELLINGS",
    "as_quantity",
    "in_si",
    "offset_of",
    "same_dimension",
    "scale_of",
]

#: SI unit of each quantity of the page, and the units that the page offers; the first one is its default. The page
#: also accepts speeds of the center in place of an angular speed, and converts them with the radius of the body.
DISPLAYED = {
    "length": ("m", ("mm", "cm", "m", "in")),
    "modulus": ("Pa", ("MPa", "kPa", "GPa", "Pa", "psi")),
    "force": ("N", ("N", "kN", "kgf", "lbf")),
    "line_force": ("N/m", ("N/mm", "N/m", "kN/m", "lbf/in")),
    "torque": ("N m", ("N m", "mN m", "lbf in")),
    "line_torque": ("N m/m", ("N m/m", "N mm/mm")),
    "power": ("W", ("W", "kW", "mW", "hp")),
    "line_power": ("W/m", ("W/m", "kW/m")),
    "speed": ("rad/s", ("km/h", "m/s", "mph", "rpm", "rad/s")),
    "time": ("s", ("s", "ms", "µs")),
    "frequency": ("rad/s", ("rad/s", "Hz")),
    "density": ("kg/m³", ("kg/m³", "g/cm³")),
    "temperature": ("K", ("°C", "K")),
    "percent": ("1", ("%",)),
}

#: SI unit of the speed of the center.
CENTER_SPEED = "m/s"

#: Other spellings of units, in lower case. Each one is used only where a unit of this kind is expected.
SPELLINGS = {
    "kg": "kgf",
    "lb": "lbf",
    "inch": "in",
    '"': "in",
    "nm": "N m",
    "mnm": "mN m",
    "kg/m3": "kg/m³",
    "g/cm3": "g/cm³",
    "us": "µs",
    "kmh": "km/h",
    "kph": "km/h",
    "c": "°C",
}

#: Names of quantities in messages, by their SI unit.
_NAMES = {
    "m": "a length",
    "Pa": "a stress or modulus",
    "N": "a force",
    "N/m": "a force per length",
    "N m": "a torque",
    "N m/m": "a torque per length",
    "W": "a power",
    "W/m": "a power per length",
    "rad/s": "an angular speed or angular frequency",
    "m/s": "a speed",
    "Hz": "a frequency",
    "s": "a time",
    "rad": "an angle",
    "kg": "a mass",
    "kg/m^3": "a density",
    "kg/m³": "a density",
    "K": "a temperature",
}

#: Pattern of a number with a unit, for JSON Schema.
QUANTITY = r"^\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d{1,3})?\s*[^\s\d.].*$"

#: Text of a number with a unit. Exponents have at most three digits, and a text that begins as the name of a file may
#: begin ("60A.toml") is a number only if a unit can follow.
_TEXT = re.compile(r"\s*(?P<number>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?)(?P<space>\s*)(?P<unit>\S.*?)?\s*")

#: Signs that pint does not read, and what it reads in their place.
_SIGNS = {"·": "*", "°C": "degC", "°F": "degF", "°": "deg"}
_SIGN = re.compile("|".join(_SIGNS))

#: Characters of a unit, whose exponents have one digit: pint would compute m^999999.
_UNIT = re.compile(r"(?:[^\W\d]|[°%\"'²³ *·/()\^.-]|(?:\^|\*\*|[^\W\d])-?\d(?!\d)|(?<![\d.])1(?=/)){1,60}")


#: Number of a temperature whose unit is "C", which is the coulomb elsewhere.
_CELSIUS = re.compile(r"\s*([-+]?\d+\.?\d*)\s*C\s*")


def as_quantity(text: str) -> tuple[str, str] | None:
    """Return number and unit of a text such as "10 mm" as two texts, or None for other texts, such as names of files.

    A text that starts with a number and a space is a quantity, also if its unit is unknown, unless it ends in a suffix
    of files.

    Examples
    --------
    >>> as_quantity("1.2 MPa"), as_quantity("10mm"), as_quantity("60A.toml"), as_quantity("insulated")
    (('1.2', 'MPa'), ('10', 'mm'), None, None)
    """
    found = _TEXT.fullmatch(text.replace("\N{MINUS SIGN}", "-"))
    if found is None or re.search(r"\.[a-zA-Z]\w*$", text):
        return None
    unit = found["unit"] or ""
    return (found["number"], unit) if found["space"] or not unit or _parsed(unit) is not None else None


def in_si(text: str, unit: str, *, path: str, difference: bool = False) -> float:
    """Return the number in SI units that a text such as "10 mm" states, correctly rounded.

    Parameters
    ----------
    text : str
        Number and unit.
    unit : str
        SI unit of the key; "1" for numbers without a unit.
    path : str
        Path of the key, for messages.
    difference : bool, default False
        Whether a value in K is a difference of temperatures, which has no zero of its own.

    Raises
    ------
    InvalidInput
        If the text is not a number with a unit of the same dimension.

    Examples
    --------
    >>> in_si("10 mm", "m", path="ball.core_radius"), in_si("23 degC", "K", path="thermal.ambient")
    (0.01, 296.15)
    """
    rule = f"must be {_expected(unit, difference=difference)}"
    parts = as_quantity(text)
    if parts is None:
        raise InvalidInput(path, rule, shown(text), more="write a decimal point" if "," in text else "")
    number, given = parts
    if not math.isfinite(float(number)):
        raise InvalidInput(path, "must be a finite number", shown(text))
    if not given:
        raise InvalidInput(path, f"{rule}, with its unit or without quotes", shown(text))
    name = _spelled(given, unit)
    parsed = _parsed(name)
    if parsed is None:
        raise InvalidInput(path, rule, shown(text), more=_unknown(number, given, unit))
    if not same_dimension(name, unit):
        raise InvalidInput(path, rule, shown(text), more=_advice(name, unit))
    offset = offset_of(name)
    if difference and offset:
        raise InvalidInput(path, rule, shown(text), more="a difference has the same number in K as in °C")
    value = Fraction(number) * scale_of(name, unit) + (offset if unit == "K" else 0)
    try:
        return float(value)
    except OverflowError:
        raise InvalidInput(path, "must be a finite number", shown(text)) from None


@cache
def number_in_si(text: str, unit: str, *, path: str) -> float:
    """Return a plain number, or the number in SI units of a text such as "10 mm".

    The unit of a temperature may also be "C", as in "20C".

    Examples
    --------
    >>> number_in_si("0.01", "m", path="--width"), number_in_si("20C", "K", path="--reference")
    (0.01, 293.15)
    """
    try:
        return float(text)
    except ValueError:
        return in_si(_with_degrees(text, unit), unit, path=path)


def _with_degrees(text: str, unit: str) -> str:
    """Return a text in which "degC" replaces the unit "C" of a temperature."""
    celsius = _CELSIUS.fullmatch(text) if unit == "K" else None
    return f"{celsius[1]} degC" if celsius else text


def range_in_si(text: str, unit: str, *, path: str, rule: str = "must have the form from..to") -> tuple[float, float]:
    """Return the ends in SI units of a range such as "0.05..25" or "10..1000 rpm".

    Parameters
    ----------
    text : str
        Range.
    unit : str
        SI unit.
    path : str
        Option or key, for messages.
    rule : str, optional
        Rule that a message about any other text states.

    Raises
    ------
    InvalidInput
        If the text does not have the form "from..to", or an end is not a number with a unit of the same dimension.

    Examples
    --------
    >>> range_in_si("10..30 mm", "m", path="--width")
    (0.01, 0.03)
    """
    low, _, high = text.partition("..")
    low, high = _with_degrees(low, unit), _with_degrees(high, unit)
    begin, end = as_quantity(low), as_quantity(high)
    if begin is None or end is None:
        raise InvalidInput(path, rule, shown(text))
    if not begin[1]:
        low = f"{begin[0]} {end[1]}".strip()
    return number_in_si(low, unit, path=path), number_in_si(high, unit, path=path)


def scale_of(unit: str, si: str) -> Fraction:
    """Return the SI value of a unit; for degrees, of a difference of one degree."""
    registry = _registry()
    one, zero = (registry.convert(Fraction(n), _parsed(unit), _parsed(si)) for n in (1, 0))
    return Fraction(one - zero)


def same_dimension(unit: str, other: str) -> bool:
    """Return whether two units measure the same quantity."""
    return bool(_parsed(unit).dimensionality == _parsed(other).dimensionality)


@cache
def offset_of(unit: str) -> Fraction:
    """Return the temperature [K] of the zero of a unit, 0 for units that have the zero of the SI unit."""
    return Fraction(_registry().convert(Fraction(0), _parsed(unit), _parsed("K")) if same_dimension(unit, "K") else 0)


@cache
def _registry() -> UnitRegistry[Any]:
    with extra("cli"):
        from pint import UnitRegistry

    lines = resources.files("viscoroll").joinpath("case/units.txt").read_text(encoding="utf-8").splitlines()
    return UnitRegistry(lines, non_int_type=Fraction)  # fractions, so that 10 mm are exactly 0.01 m


@cache
def _parsed(unit: str) -> Any:
    """Return the unit of pint, or None if the text is not a unit."""
    if unit == "1":
        return _registry().Unit("")
    if not _UNIT.fullmatch(unit):
        return None
    with extra("cli"):
        from pint.errors import PintError
    try:
        return _registry().parse_units(_SIGN.sub(lambda found: _SIGNS[found[0]], unit))
    except (
        PintError,
        ValueError,
        TypeError,
        AttributeError,
        SyntaxError,
        AssertionError,
        ZeroDivisionError,
        TokenError,
    ):
        return None  # pint raises these for texts such as "mm)" or "*"


@cache
def _spelled(given: str, unit: str) -> str:
    """Return the unit that was meant, if the given one is unknown or has another dimension than expected."""
    if _parsed(given) is not None and same_dimension(given, unit):
        return given
    usual = SPELLINGS.get(given.lower(), given).lower()
    for _, units in DISPLAYED.values():
        for one in units:
            if one.lower() == usual and same_dimension(one, unit):
                return one
    return given


def _expected(unit: str, *, difference: bool) -> str:
    """Return the name of a quantity with its SI unit."""
    if unit == "1":
        return "a number without unit, or in percent"
    if difference:
        return f"a difference of temperatures [{unit}]"
    return f"{_NAMES.get(unit, 'a quantity')} [{unit}]"


def _unknown(number: str, given: str, unit: str) -> str:
    """Return a message about an unknown unit, with usual units of the same dimension."""
    if "shore" in given.lower():
        scale = ', scale = "D"' if given.strip().upper().endswith("D") else ""
        table = f'{{ type = "hardness", hardness = {number}{scale} }}'
        return f"a hardness is a table: {table}, whose loss follows from rebound = 0.5, reference_frequency = 1.0"
    usual = [names for _, names in DISPLAYED.values() if same_dimension(names[0], unit) and unit != "1"]
    known = f"; use for example {', '.join(usual[0])}" if usual else ""
    return f"the unit {shown(given)} is not known{known}"


def _advice(given: str, unit: str) -> str:
    """Return how a quantity of another dimension may have been meant."""
    dimension = _parsed(given).dimensionality
    if unit == "K" and same_dimension(given, "rad"):
        return 'write "degC" for degrees Celsius'
    if unit == "rad/s" and dimension == _parsed(CENTER_SPEED).dimensionality:
        return "give the speed of the ground as speed"
    if unit == CENTER_SPEED and dimension == _parsed("rad/s").dimensionality:
        return "give the angular speed as angular_speed"
    if unit in ("N/m", "W/m", "N m/m") and dimension == (_parsed(unit) * _parsed("m")).dimensionality:
        return "values of rollers are per length: divide by the width"
    if unit in ("N", "W", "N m") and dimension == (_parsed(unit) / _parsed("m")).dimensionality:
        return "only values of rollers are per length: multiply by the width"
    return ""
