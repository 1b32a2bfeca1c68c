"""Files of the inside: a volume for ParaView, and netCDF."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._support.extras import extra
from .._support.files import save, write_netcdf
from ..solution.interior_fields import COMPONENTS

if TYPE_CHECKING:
    import xarray

__all__ = ["save_interior"]


def save_interior(inside: xarray.Dataset, path: str | Path) -> None:
    """Write fields inside the coating to a file, in the format of its suffix.

    Parameters
    ----------
    inside : xarray.Dataset
        From `Result.interior`, with at least two depths, φ and θ each for a volume.
    path : path-like
        ``.nc`` (netCDF) or ``.vtu`` (a volume of hexahedra for ParaView: x forward, y sideways, z up from the ball's
        center, undeformed, with displacements and tensors in these directions).

    Raises
    ------
    ValueError
        For another suffix, and where there is no volume.
    ImportError
        Without the extra `viscoroll[files]`.
    """
    save(inside, path, {".nc": write_netcdf, ".vtu": _write_volume})


def _write_volume(inside: xarray.Dataset, path: Path) -> None:
    with extra("files"):
        import meshio

    shape = tuple(inside.sizes[name] for name in ("depth", "phi", "theta"))
    if min(shape) < 2:
        raise ValueError(f"inside must have at least two depths, phi and theta each for a volume, got {shape}")
    radius, phi, theta = np.meshgrid(inside.radius, inside.phi, inside.theta, indexing="ij")
    zero = np.zeros_like(phi)
    # Rows: the directions r, phi and theta by their components forward, sideways and up.
    axes = np.array(
        [
            [np.sin(theta) * np.cos(phi), np.cos(theta), -np.sin(theta) * np.sin(phi)],
            [-np.sin(phi), zero, -np.cos(phi)],
            [np.cos(theta) * np.cos(phi), -np.sin(theta), -np.cos(theta) * np.sin(phi)],
        ]
    ).reshape(3, 3, -1)
    points = radius.ravel() * axes[0]
    displacement = inside.displacement.to_numpy().reshape(3, -1)
    stress = inside.stress.to_numpy().reshape(len(COMPONENTS), -1)
    rr, pp, tt, rp, rt, pt = stress
    tensor = np.array([[rr, rp, rt], [rp, pp, pt], [rt, pt, tt]])
    turned = np.einsum("ian,ijn,jbn->nab", axes, tensor, axes)
    number = np.arange(phi.size).reshape(shape)
    # Where layers meet, two places lie on one surface: no cells between them.
    first = np.nonzero(np.diff(inside.radius.to_numpy()) != 0.0)[0]
    near, far = number[first], number[first + 1]
    corners = [
        part[:, i : shape[1] - 1 + i, j : shape[2] - 1 + j]
        for part in (near, far)
        for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
    ]
    meshio.Mesh(
        points.T,
        [("hexahedron", np.stack(corners, axis=-1).reshape(-1, 8))],
        point_data={
            "displacement [m]": np.einsum("ian,in->na", axes, displacement),
            "stress [Pa]": turned.reshape(-1, 9),
            **{
                f"{name} [Pa]": inside[name].to_numpy().ravel()
                for name in ("von_mises", "hydrostatic_pressure", "opening_traction", "shear_traction")
            },
        },
    ).write(path)
