"""Files that results are written to: by the suffix of the path, as a table or as netCDF."""

from __future__ import annotations

import csv
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from .extras import extra
from .text import shown

if TYPE_CHECKING:
    import xarray

__all__ = ["ending_in", "save", "write_csv", "write_netcdf"]

_Saved = TypeVar("_Saved")


def ending_in(suffixes: Collection[str], path: str | Path, *, name: str = "path") -> Path:
    """Return a path that ends in one of some suffixes, in capitals or not; refuse others."""
    path = Path(path)
    if path.suffix.lower() not in suffixes:
        *others, last = suffixes
        allowed = " or ".join(filter(None, [", ".join(others), last]))
        raise ValueError(f"{name} must end in {allowed}, got {shown(path.name)}")
    return path


def save(saved: _Saved, path: str | Path, formats: Mapping[str, Callable[[_Saved, Path], object]]) -> None:
    """Write a file by that one of some functions, by suffix, which the path names; refuse other suffixes."""
    path = ending_in(formats, path)
    formats[path.suffix.lower()](saved, path)


def write_csv(columns: Mapping[str, Sequence[Any]], path: Path) -> None:
    """Write columns of equal lengths, below their names, which hold the units."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))


def write_netcdf(dataset: xarray.Dataset, path: Path) -> None:
    """Write a dataset as netCDF."""
    with extra("files"):
        import netCDF4  # noqa: F401  (what xarray writes with)
    dataset.to_netcdf(path, engine="netcdf4")
