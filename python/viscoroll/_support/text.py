"""Conversion between values and text of one line."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

__all__ = ["finite_number", "key_path_text", "one_line", "shown", "snake_case"]

#: Longest text of a value in messages [characters].
_LONGEST = 120


def shown(value: object) -> str:
    """Return the text of a value for messages: its repr, shortened if it is long; large integers are rounded."""
    if isinstance(value, int) and abs(value) >= 10**30:
        exponent, fraction = divmod(math.log10(abs(value)), 1.0)
        return f"about {'-' if value < 0 else ''}{10.0**fraction:.2g}e{exponent:.0f}"
    try:
        text = repr(value)
    except Exception:  # a repr can raise anything, and must not replace the error to be reported
        text = f"<{type(value).__name__}>"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def finite_number(text: str) -> float | None:
    """Return the finite number that a text represents, or None for any other text and for digits grouped by "_"."""
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) and "_" not in text else None


def key_path_text(path: Sequence[str | int]) -> str:
    """Return the text of a path of keys and indices, such as "ball.layers[0].thickness"."""
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path).lstrip(".")


def one_line(message: str) -> str:
    """Return a message in which escapes replace line breaks and other characters that are not printable."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in message)


def snake_case(name: str) -> str:
    """Return the name of a class with underscores between its words, in lower case."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()
