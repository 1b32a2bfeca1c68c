"""Values with units as text, with the digits that their error estimates support."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .units import suitable_unit

__all__ = ["percent_text", "plain_number", "quantity_text", "quantity_texts", "with_error"]

#: Significant digits of a value without error estimate, and the most digits of a value with one.
_DIGITS, _MOST_DIGITS = 4, 6

#: Leading digits of an error below which a second digit is printed, so that rounding changes it by less than a fifth.
_TWO_DIGITS = 3.0


def plain_number(value: float, digits: int = _DIGITS) -> str:
    """Return a number with significant digits, with an exponent only if it is very large or very small."""
    text = f"{value:.{digits}g}"
    return f"{float(text):.15g}" if 1e-4 <= abs(value) < 1e6 else text


def percent_text(ratio: float, digits: int = 3) -> str:
    """Return a ratio in percent."""
    return f"{plain_number(1e2 * ratio, digits)} %"


def with_error(value: float, error: float | None, digits: int = _DIGITS) -> str:
    """Return a number with as many digits as its error supports, and the error.

    Parameters
    ----------
    value : float
        Number.
    error : float or None
        Estimate of its absolute error.
    digits : int, default 4
        Significant digits of a number without an error.

    Examples
    --------
    >>> with_error(35.97214, 0.28)
    '35.97 ± 0.28'
    >>> with_error(35.97214, 0.32)
    '36.0 ± 0.3'
    >>> with_error(466.43, 74.2)
    '470 ± 70'
    >>> with_error(0.0, 0.0)
    '0'
    """
    if error is None or value == 0.0 or not (math.isfinite(value) and math.isfinite(error)):
        return plain_number(value, digits)
    finest = math.floor(math.log10(abs(value))) - _MOST_DIGITS + 1
    if abs(error) < 0.5 * 10.0**finest:  # no printed digit is uncertain
        return plain_number(value, _MOST_DIGITS)
    place = math.floor(math.log10(abs(error)))
    place = max(place - (abs(error) < _TWO_DIGITS * 10.0**place), finest)
    return " ± ".join(f"{round(number, -place):.{max(-place, 0)}f}" for number in (value, abs(error)))


def quantity_text(value: float | None, unit: str, relative_error: float | None = None, *, digits: int = _DIGITS) -> str:
    """Return a value with a readable unit and, if its relative error is given, the error; "undetermined" for None.

    Examples
    --------
    >>> quantity_text(0.035972, "N", 0.009)
    '36.0 ± 0.3 mN'
    >>> quantity_text(8.461538e6, "Pa")
    '8.462 MPa'
    """
    (text,), name = quantity_texts([value], unit, [relative_error], digits=digits)
    return f"{text} {name}".rstrip()


def quantity_texts(
    values: Sequence[float | None], unit: str, relative_errors: Sequence[float | None], *, digits: int = _DIGITS
) -> tuple[list[str], str]:
    """Return values with their errors, and the unit that suits the largest value."""
    name, scale = suitable_unit(max((abs(value) for value in values if value is not None), default=0.0), unit)
    texts = [
        "undetermined"
        if value is None
        else str(value)
        if isinstance(value, int)
        else with_error(value / scale, None if error is None else error * value / scale, digits)
        for value, error in zip(values, relative_errors, strict=True)
    ]
    return texts, name if any(value is not None for value in values) else ""
