"""Files that results are written to: by the suffix of the path, as a table or as netCDF."""

from __future__ import annotations

import csv
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from .extras import extra

if TYPE_CHECKING:
    import xarray

__all__ = ["save", "write_csv", "write_netcdf"]

_Saved = TypeVar("_Saved")


def save(saved: _Saved, path: str | Path, formats: Mapping[str, Callable[[_Saved, Path], object]]) -> None:
    """Write a file by that one of some functions, by suffix, which the path names; refuse other suffixes."""
    path = Path(path)
    if (write := formats.get(path.suffix.lower())) is None:
        *others, last = formats
        raise ValueError(f"path must end in {', '.join(others)} or {last}, got {path.name!r}")
    write(saved, path)


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
