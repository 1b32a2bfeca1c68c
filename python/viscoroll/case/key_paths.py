"""Paths of keys in files, such as "ball.layers[0].thickness", and files with other values at some of them."""

from __future__ import annotations

import copy
import re
import tomllib
from collections.abc import Iterable, Mapping
from typing import Any, TypeAlias

from .._support.errors import InvalidInput
from .._support.text import key_path_text

__all__ = ["KeyPath", "key_path_of", "parsed_change", "substituted"]

#: Pattern of the path of a key in the file.
_KEY_PATH = re.compile(r"\w+(\[\d+\])*(\.\w+(\[\d+\])*)*")

#: Path of a key: names of tables and keys, and indices in lists.
KeyPath: TypeAlias = tuple[str | int, ...]


def key_path_of(key: str, where: str = "sweep") -> KeyPath:
    """Return the parts of a path such as "ball.layers[0].thickness"; `where` names its place in messages."""
    if not _KEY_PATH.fullmatch(key):
        raise ValueError(f'{where}: keys must be paths like "ball.layers[0].thickness", got {key!r}')
    return tuple(int(part) if part.isdigit() else part for part in re.findall(r"\w+", key))


def substituted(
    document: Mapping[str, Any],
    chosen: Mapping[KeyPath, Any],
    exclusive: Iterable[tuple[str, ...]] = (),
    where: str = "sweep",
) -> dict[str, Any]:
    """Return the document with other values for some keys; tables above a key that are missing are created.

    Parameters
    ----------
    document : mapping
        Content of a file.
    chosen : mapping
        Values by the paths of keys.
    exclusive : iterable of tuple of str, optional
        Groups of keys of which a table may have only one. A value replaces the others of its group.
    where : str, optional
        Place of the keys in messages.
    """
    new: dict[str, Any] = copy.deepcopy(dict(document))
    for key_path, value in chosen.items():
        target: Any = new
        last: Any = key_path[-1]
        try:
            for part in key_path[:-1]:
                target = target.setdefault(part, {}) if isinstance(target, dict) else target[part]
            if isinstance(target, list):
                target[last]  # raises an IndexError instead of adding an entry
            target[last] = value
        except (IndexError, KeyError, TypeError):
            raise ValueError(f'{where}: the file has no key "{key_path_text(key_path)}"') from None
        for name in {name for group in exclusive if last in group for name in group} - {last}:
            target.pop(name, None)
    return new


def parsed_change(text: str) -> tuple[str, Any]:
    """Return path and value of a text such as "rolling.load=500 N"; a value that is not TOML is a text.

    Examples
    --------
    >>> parsed_change("rolling.load=500 N"), parsed_change("numerics.accuracy=0.1")
    (('rolling.load', '500 N'), ('numerics.accuracy', 0.1))
    """
    key, equals, value = (part.strip() for part in text.partition("="))
    if not equals or not value:
        raise InvalidInput("--set", "must have the form KEY=VALUE, such as rolling.load=500", repr(text))
    key_path_of(key, "--set")
    try:
        return key, tomllib.loads(f"value = {value}")["value"]
    except ValueError:
        return key, value
