"""Files of a result: a table, netCDF, and the deformed surface for ParaView."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._support.extras import extra
from ..rolling import Result
from ..rolling.result import FIELDS, VECTOR_FIELDS

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["SUFFIXES", "save_result"]

#: Of the files that `save_result` writes.
SUFFIXES = (".csv", ".nc", ".vtu", ".vtk")


def save_result(result: Result, path: Path) -> None:
    """Write the fields of a result to a file, see `viscoroll.Result.save`."""
    match path.suffix.lower():
        case ".csv":
            _write_csv(result, path)
        case ".nc":
            with extra("files"):
                import netCDF4  # noqa: F401  (what xarray writes with)
            result.to_xarray().to_netcdf(path, engine="netcdf4")
        case ".vtu" | ".vtk":
            _write_vtk(result, path)
        case _:
            raise ValueError(f"path must end in .csv, .nc, .vtu or .vtk, got {path.name!r}")


def _write_csv(result: Result, path: Path) -> None:
    columns = {f"{name} [{unit}]": getattr(result, name) for name, (unit, _) in FIELDS.items()}
    for name, (unit, _) in VECTOR_FIELDS.items():
        for direction, values in zip("xz", getattr(result, name), strict=True):
            columns[f"{name}_{direction} [{unit}]"] = values
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*map(_entries, columns.values()), strict=True))


def _entries(field: NDArray[Any]) -> list[Any]:
    """Return the values of a field one after the other; zeros lose their sign."""
    return (field if field.dtype == bool else field + 0.0).ravel().tolist()


def _write_vtk(result: Result, path: Path) -> None:
    with extra("files"):
        import meshio

    # The plane is at height 0; VTK readers expect the third axis to point up.
    points = np.stack([result.x, result.z, result.gap], axis=-1).reshape(-1, 3)
    meshio.Mesh(
        points,
        [_cells(*result.x.shape)],
        point_data={
            "pressure": result.pressure.ravel(),
            "displacement": result.displacement.ravel(),
            "contact": result.contact.ravel().astype(np.int32),
            "stick": result.stick.ravel().astype(np.int32),
            "shear_traction": _vectors(result.shear_traction),
            "slip_velocity": _vectors(result.slip_velocity),
        },
    ).write(path)


def _cells(rows: int, columns: int) -> tuple[str, NDArray[Any]]:
    """Return quadrilaterals between the nodes of a window, or lines where it is one node wide."""
    node = np.arange(rows * columns).reshape(rows, columns)
    if columns == 1:
        return "line", np.stack([node[:-1, 0], node[1:, 0]], axis=-1)
    corners = [node[:-1, :-1], node[1:, :-1], node[1:, 1:], node[:-1, 1:]]
    return "quad", np.stack(corners, axis=-1).reshape(-1, 4)


def _vectors(field: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([*(part.ravel() for part in field), np.zeros(field[0].size)], axis=-1)
