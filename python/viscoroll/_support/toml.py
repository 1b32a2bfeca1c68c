"""Reader of TOML files."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

__all__ = ["read_toml"]


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
        return tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except RecursionError:
        raise ValueError("not a TOML file: nested too deeply") from None
    except ValueError as error:  # TOMLDecodeError, UnicodeDecodeError, or too many digits of an integer
        raise ValueError(f"not a TOML file: {error}") from None
