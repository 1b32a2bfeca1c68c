"""Several files of one material, listed or matched by a pattern, with temperatures that may be in their names."""

from __future__ import annotations

import glob
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import TypeAlias, TypeVar

from .._support.arguments import as_kelvin
from .._support.celsius import ZERO_CELSIUS, celsius_text
from .._support.errors import InvalidInput, in_file
from .._support.text import shown

__all__ = ["Files", "file_set", "read_files", "temperatures_of"]

#: Path of a file, pattern of paths, or both with temperatures [K].
Files: TypeAlias = (
    str | Path | Mapping[str, float | None] | Mapping[Path, float | None] | Mapping[str | Path, float | None]
)

Data = TypeVar("Data")

#: Temperature in the name of a file. A letter C or K without a degree sign follows its number immediately: "test_1_C"
#: is the specimen C.
_TEMPERATURE = re.compile(
    r"(?P<word>[^\W\d_]*)(?P<sign>[-+\u2010-\u2015\u2212]?)(?<![\d.,])(?P<number>\d+(?:[.,]\d+)?)"
    r"(?:(?P<letter>[CK])|[ _]?(?:°|º|deg(?:rees?)?)[ _]?(?P<degrees>[cCkK]))(?![^\W_])"
)

#: Unicode's minus sign. The ASCII character may also be a hyphen between two words.
_MINUS = "\u2212"


def file_set(path: Files) -> Path | dict[Path, float | None]:
    """Return the path of one file, or the temperature [K] of each file of a mapping or a pattern, None unless given.

    Errors are those of `temperatures_of`.
    """
    if isinstance(path, Mapping):
        return temperatures_of(path.items())
    return temperatures_of([(path, None)]) if _is_pattern(path) else Path(path)


def temperatures_of(files: Iterable[tuple[str | Path, float | None]]) -> dict[Path, float | None]:
    """Return the temperature [K] of each file from pairs of path or pattern and temperature.

    A given temperature wins over a pattern without one that matches the same file.

    Raises
    ------
    ValueError
        If a pattern matches no file, or a file has two temperatures.
    """
    found: dict[Path, float | None] = {}
    for name, kelvin in files:
        for path in _matched(name) if _is_pattern(name) else [Path(name)]:
            other = found.get(path)
            if kelvin is not None and other is not None and kelvin != other:
                raise InvalidInput("path", f"must have one temperature for {path}", f"{other!r} and {kelvin!r} K")
            found[path] = other if kelvin is None else kelvin
    return found


def _is_pattern(path: str | Path) -> bool:
    """Return whether a path contains wildcards and is not that of a file."""
    return glob.has_magic(str(path)) and not Path(path).exists()


def _matched(pattern: str | Path) -> list[Path]:
    names = glob.glob(str(pattern))  # noqa: PTH207 - Path.glob rejects absolute patterns
    found = sorted(path for path in map(Path, names) if path.is_file())
    if not found:
        raise InvalidInput("path", "must match a file", shown(str(pattern)))
    return found


def read_files(
    files: Mapping[Path, float | None],
    read: Callable[[Path], Data],
    at: Callable[[Data, float, tuple[str, ...]], Data],
    lacks_temperature: Callable[[Data], bool],
) -> Iterator[Data]:
    """Yield the data of each file, with a temperature.

    Parameters
    ----------
    files : mapping of Path to float or None
        Temperature of each file [K]; None for the temperature in the file or, if it contains none, in its name.
    read : callable
        Function that reads a file.
    at : callable
        Function that returns the data of a file at a temperature [K], with remarks in addition.
    lacks_temperature : callable
        Function that returns whether data of a file have no temperature.

    Raises
    ------
    ValueError
        If a file has no temperature.
    """
    if not files:
        raise InvalidInput("path", "must contain a file", "none")
    for path, given in files.items():
        data = read(path)
        if given is not None:
            yield at(data, given, ())
        elif lacks_temperature(data):
            kelvin = _temperature_in_name(path)
            yield at(data, kelvin, (f"temperature {celsius_text(kelvin)} from the name of the file",))
        else:
            yield data


def _temperature_in_name(path: Path) -> float:
    """Return the temperature [K] in the name of a file, such as "a_-20C.csv", "b_296K.csv" or "c 40 degC.xlsx"."""
    found: dict[float, str] = {}
    for match in _TEMPERATURE.finditer(path.name):
        text, word, sign = match.group(), match["word"].lower(), match["sign"]
        before = path.name[: match.start()][-1:]
        if word and before.isdigit():  # 20p5C may mean 20.5 °C
            raise _not_in_name(path, f"{before + text!r}, which is not clearly a number")
        is_hyphen = sign not in ("", "+", _MINUS) and (word or before.isalnum())
        if is_hyphen or word in ("m", "n"):
            raise _not_in_name(path, f"{text!r}, whose sign is not clear")
        is_negative = sign not in ("", "+") or word in ("minus", "neg")
        value = float(match["number"].replace(",", ".")) * (-1.0 if is_negative else 1.0)
        is_kelvin = (match["letter"] or match["degrees"]).upper() == "K"
        found[value if is_kelvin else value + ZERO_CELSIUS] = text
    if len(found) != 1:
        raise _not_in_name(path, " and ".join(map(repr, found.values())) or "none")
    (kelvin,) = found
    try:
        return as_kelvin("temperature in the name", kelvin)
    except ValueError as error:
        raise in_file(error, path) from None


def _not_in_name(path: Path, got: str) -> InvalidInput:
    rule = (
        "must be given for each of several files, in the file, in its name as in 'a_-20C.csv' and 'b_296K.csv', "
        f"in the shell as {path.name}@20C, or in Python by a mapping from paths to kelvin"
    )
    return InvalidInput("temperature", rule, got, source=str(path))
