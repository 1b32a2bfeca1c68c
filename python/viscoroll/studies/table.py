"""Table of a study, with one row for each point."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from .._support.files import ending_in, write_csv

if TYPE_CHECKING:
    import xarray

__all__ = ["save_table"]


def save_table(study: xarray.Dataset, path: str | Path) -> None:
    """Write a CSV file with one row for each point of a study: parameters, scalar results and intervals, with units.

    Parameters
    ----------
    study : xarray.Dataset
        Dataset from `viscoroll.sweep`, or a selection of it.
    path : path-like
        Path of a ``.csv`` file. The file has no columns for fields, nor for results that no point has;
        ``study.to_netcdf`` writes the complete study.

    Raises
    ------
    ValueError
        For another suffix.
    """
    path = ending_in([".csv"], path)
    scalars = study.drop_dims([name for name in ("phi", "theta", "direction") if name in study.dims])
    varied = list(scalars.status.dims)
    frame = scalars.to_dataframe().reset_index().dropna(axis="columns", how="all")
    names = [*varied, *(name for name in frame.columns if name not in varied)]
    columns = {_headed(study, name): frame[name].tolist() for name in names}
    write_csv(columns, path)


def _headed(study: xarray.Dataset, name: str) -> str:
    unit = study[name].attrs.get("units", "1")
    return name if unit == "1" else f"{name} [{unit}]"
