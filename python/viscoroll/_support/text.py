"""Values and messages as text of one line."""

from __future__ import annotations

import math

__all__ = ["one_line", "parsed_range", "shown"]

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
