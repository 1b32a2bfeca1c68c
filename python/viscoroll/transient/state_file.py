"""Files of saved states: one line of text that describes the numbers, followed by the numbers.

The line contains a mark, the version of the format, the version of viscoroll that wrote the file, both bodies, and the
SHA-256 of the rest of the line and of the numbers, which detects any change to the file.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._core import __commit__, __version__
from .._support.files import draft_of
from .._support.text import shown

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SUFFIX", "read_state", "write_state"]

SUFFIX = ".state"

_MARK, _SEPARATOR = b"viscoroll state", b"; "

#: Version of the file format.
_FORMAT = b"1"

_MADE_BY = f"{__version__}, commit {__commit__}"


def write_state(path: Path, numbers: NDArray[np.float64], bodies: str) -> None:
    """Write the numbers of a state and the text that describes its bodies."""
    content = np.asarray(numbers, dtype="<f8").tobytes()
    head = [_MARK, _FORMAT, _MADE_BY.encode(), bodies.encode()]
    with draft_of(path) as draft:
        draft.write_bytes(_SEPARATOR.join([*head, _checksum(head, content)]) + b"\n" + content)


def read_state(path: Path) -> tuple[NDArray[np.float64], str]:
    """Return the numbers and the text of a file that `write_state` wrote.

    Raises
    ------
    ValueError
        If the file is not a state, has another format, is damaged, or was written by another version of viscoroll.
    OSError
        If the file cannot be read.
    """
    line, _, content = path.read_bytes().partition(b"\n")
    mark, *rest = line.split(_SEPARATOR)
    if mark != _MARK or not rest:
        raise ValueError(f"{path} is not a saved state of viscoroll: roll from the start and save the state again")
    if rest[0] != _FORMAT:
        raise ValueError(f"{path} must be a state of format {_FORMAT.decode()}, got {shown(rest[0].decode('latin-1'))}")
    if len(rest) != 4 or rest[3] != _checksum([mark, *rest[:3]], content):
        raise ValueError(f"{path} is damaged: its checksum does not match its content; roll from the start")
    made_by, bodies = (part.decode() for part in rest[1:3])
    if made_by != _MADE_BY:
        raise ValueError(
            f"{path} must be written by viscoroll {_MADE_BY}, got a state written by {made_by}: roll from the start"
        )
    return np.frombuffer(content, dtype="<f8").astype(np.float64), bodies


def _checksum(head: list[bytes], content: bytes) -> bytes:
    return hashlib.sha256(_SEPARATOR.join([*head, content])).hexdigest().encode()
