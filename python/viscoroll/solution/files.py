"""Files of a solution: CSV table, netCDF, and the deformed surface for ParaView."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._support.extras import extra
from .._support.files import draft_of, write_csv, write_netcdf
from .solution import FIELDS, VECTOR_FIELDS, Solution

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["FORMATS"]


def _write_table(result: Solution, path: Path) -> None:
    fields = {f"{name} [{unit}]": getattr(result, name) for name, (unit, _) in FIELDS.items()}
    for name, (unit, _) in VECTOR_FIELDS.items():
        for direction, values in zip("xz", getattr(result, name), strict=True):
            fields[f"{name}_{direction} [{unit}]"] = values
    write_csv({head: _entries(values) for head, values in fields.items()}, path)


def _entries(field: NDArray[Any]) -> list[Any]:
    """Return the values of a field as a flat list; negative zeros become positive."""
    entries: list[Any] = (field if field.dtype == bool else field + 0.0).ravel().tolist()
    return entries


def _write_vtk(result: Solution, path: Path) -> None:
    with extra("files"):
        import meshio

    # The plane is at height 0; VTK readers expect the third axis to point up.
    points = np.stack([result.x, result.z, result.gap], axis=-1).reshape(-1, 3)
    mesh = meshio.Mesh(
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
    )
    with draft_of(path) as draft:
        mesh.write(draft)


def _cells(rows: int, columns: int) -> tuple[str, NDArray[Any]]:
    """Return quadrilaterals between the nodes of a window, or lines if it is one node wide."""
    node = np.arange(rows * columns).reshape(rows, columns)
    if columns == 1:
        return "line", np.stack([node[:-1, 0], node[1:, 0]], axis=-1)
    corners = [node[:-1, :-1], node[1:, :-1], node[1:, 1:], node[:-1, 1:]]
    return "quad", np.stack(corners, axis=-1).reshape(-1, 4)


def _vectors(field: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([*(part.ravel() for part in field), np.zeros(field[0].size)], axis=-1)


#: Functions that write the fields of a solution, by suffix; see `Result.save`.
FORMATS = {
    ".csv": _write_table,
    ".nc": lambda result, path: write_netcdf(result.to_xarray(), path),
    ".vtu": _write_vtk,
    ".vtk": _write_vtk,
}
