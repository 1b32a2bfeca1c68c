"""Values and messages as text of one line."""

from __future__ import annotations

import math

__all__ = ["finite_number", "one_line", "parsed_range", "shown"]

_LONGEST = 120


def shown(value: object) -> str:
    """Return what a message shows of a value: its repr, cut where it is long, and large integers rounded."""
    if isinstance(value, int) and abs(value) >= 10**30:
        exponent, fraction = divmod(math.log10(abs(value)), 1.0)
        return f"about {'-' if value < 0 else ''}{10.0**fraction:.2g}e{exponent:.0f}"
    try:
        text = repr(value)
    except Exception:  # a repr may fail in any way: this is on the way to another error
        text = f"<{type(value).__name__}>"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def finite_number(text: str) -> float | None:
    """Return the number that a text is, or None for other texts, infinities and NaN, and digits grouped by "_"."""
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) and "_" not in text else None


def parsed_range(text: str) -> tuple[float, float] | None:
    """Return the numbers of "from..to", or None for any other text."""
    low, dots, high = text.partition("..")
    try:
        return (float(low), float(high)) if dots else None
    except ValueError:
        return None


def one_line(message: str) -> str:
    """Return a message with line breaks and other characters that cannot be printed as escapes."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in message)
