"""Checksums of netCDF files, checked before the netCDF library reads a file, which may crash on a damaged one.

The checksum stands behind the content, where other programs do not read.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray

__all__ = ["load_sealed", "seal"]

_MARK = b"\nviscoroll sha256 "
_LENGTH = len(_MARK) + 64


def seal(draft: Path) -> None:
    """Append the checksum of its content to the draft of a file."""
    checksum = _checksum(draft.read_bytes())
    with draft.open("ab") as file:
        file.write(_MARK + checksum)


def load_sealed(path: Path) -> xarray.Dataset:
    """Return the dataset of a netCDF file that has its checksum.

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
        raise ValueError(
            f"{path} must be a study of viscoroll, got another file or a damaged one, without its checksum"
        )
    return xarray.load_dataset(path, engine="netcdf4")


def _checksum(content: bytes) -> bytes:
    return hashlib.sha256(content).hexdigest().encode()
