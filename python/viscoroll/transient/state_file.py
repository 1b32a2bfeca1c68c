"""Read and write the files of saved states: a header line of text, followed by the numbers as binary float64.

The header contains the file signature, the version of the file format, the version of viscoroll that wrote the file, a
description of both bodies, and a checksum (SHA-256 of the other header fields and the numbers).
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._core import __commit__, __version__
from .._support.errors import InvalidInput
from .._support.files import draft_of
from .._support.text import shown

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SUFFIX", "read_state", "write_state"]

SUFFIX = ".state"

#: File signature, and separator of the header fields.
_SIGNATURE, _SEPARATOR = b"viscoroll state", b"; "

#: Version of the file format.
_FORMAT = b"1"

#: Version of viscoroll that is running.
_MADE_BY = f"{__version__}, commit {__commit__}"


def write_state(path: Path, numbers: NDArray[np.float64], bodies: str) -> None:
    """Write the numbers of a state and the description of its bodies."""
    content = np.asarray(numbers, dtype="<f8").tobytes()
    head = [_SIGNATURE, _FORMAT, _MADE_BY.encode(), bodies.encode()]
    with draft_of(path) as draft:
        draft.write_bytes(_SEPARATOR.join([*head, _checksum(head, content)]) + b"\n" + content)


def read_state(path: Path) -> tuple[NDArray[np.float64], str]:
    """Read a file that `write_state` wrote, and return the numbers and the description of the bodies.

    Raises
    ------
    ValueError
        If the file is not a saved state, has another format version, is damaged, or was written by another version of
        viscoroll.
    OSError
        If the file cannot be read.
    """
    line, _, content = path.read_bytes().partition(b"\n")
    signature, *fields = line.split(_SEPARATOR)
    if signature != _SIGNATURE or not fields:
        raise ValueError(f"{path} is not a saved state of viscoroll: roll from the start and save the state again")
    if fields[0] != _FORMAT:
        raise InvalidInput(path, f"must be a state of format {_FORMAT.decode()}", shown(fields[0].decode("latin-1")))
    if len(fields) != 4 or fields[3] != _checksum([signature, *fields[:3]], content):
        raise ValueError(f"{path} is damaged: its checksum does not match its content; roll from the start")
    made_by, bodies = (part.decode() for part in fields[1:3])
    if made_by != _MADE_BY:
        raise InvalidInput(
            path, f"must be written by viscoroll {_MADE_BY}", f"a state written by {made_by}: roll from the start"
        )
    return np.frombuffer(content, dtype="<f8").astype(np.float64), bodies


def _checksum(head: list[bytes], content: bytes) -> bytes:
    return hashlib.sha256(_SEPARATOR.join([*head, content])).hexdigest().encode()
