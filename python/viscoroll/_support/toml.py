"""Reader of TOML files."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

__all__ = ["parse_toml", "read_toml"]


def parse_toml(text: str) -> dict[str, Any]:
    """Return the content of a text in TOML; raise a ValueError if it is not TOML."""
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise ValueError("not a TOML file: nested too deeply") from None
    except ValueError as error:  # TOMLDecodeError, or too many digits of an integer
        raise ValueError(f"not a TOML file: {error}") from None


def read_toml(path: Path) -> dict[str, Any]:
    """Return the content of a TOML file in UTF-8, with or without the byte-order mark that some editors write.

    Raises
    ------
    ValueError
        If the content is not TOML. The message does not give the name of the file, which the caller adds.
    OSError
        If the file cannot be read.
    """
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"not a TOML file: {error}") from None
    return parse_toml(text)
