"""Checksums of netCDF files, verified before the netCDF library reads a file, because it may crash on damaged files.

The checksum is appended to the content of the file. Other programs ignore it.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import InvalidInput

if TYPE_CHECKING:
    import xarray

__all__ = ["load_sealed", "seal"]

_MARK = b"\nviscoroll sha256 "
_LENGTH = len(_MARK) + 64


def seal(draft: Path) -> None:
    """Append to a draft of a file the checksum of its content."""
    checksum = _checksum(draft.read_bytes())
    with draft.open("ab") as file:
        file.write(_MARK + checksum)


def load_sealed(path: Path) -> xarray.Dataset:
    """Return the dataset of a netCDF file, after verifying its checksum.

    Raises
    ------
    ValueError
        If the file does not end with the checksum of its content.
    OSError
        If the file cannot be read.
    """
    import xarray

    content = path.read_bytes()
    if content[-_LENGTH:] != _MARK + _checksum(content[:-_LENGTH]):
        raise InvalidInput(
            path, "must be a study file of viscoroll", "a file without a valid checksum: damaged or of other origin"
        )
    return xarray.load_dataset(path, engine="netcdf4")


def _checksum(content: bytes) -> bytes:
    return hashlib.sha256(content).hexdigest().encode()
