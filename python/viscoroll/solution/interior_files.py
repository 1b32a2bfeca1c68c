"""Files of the interior fields: a volume for ParaView, and netCDF."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import draft_of, save, write_netcdf
from ..solution.interior_fields import COMPONENTS

if TYPE_CHECKING:
    import xarray
    from numpy.typing import NDArray

__all__ = ["save_interior"]


def save_interior(inside: xarray.Dataset, path: str | Path) -> None:
    """Write fields inside the layers to a file, in the format of its suffix.

    Parameters
    ----------
    inside : xarray.Dataset
        Dataset of `Result.interior`, or of `SlidingResult.interior`. A volume needs at least two depths, φ and θ each;
        in line contact, with one θ, two depths and φ give a section.
    path : path-like
        ``.nc`` (netCDF) or ``.vtu`` (for ParaView: hexahedra of the undeformed body, or quadrilaterals of a section,
        with x forward, y sideways and z up from the center of the body, or from the middle of the contact in a plane;
        displacements and tensors have components in these directions).

    Raises
    ------
    ValueError
        If the suffix is another one, or there are too few places for a volume.
    ImportError
        If the extra `viscoroll[files]` is missing.
    """
    save(inside, path, {".nc": write_netcdf, ".vtu": _write_volume})


def _write_volume(inside: xarray.Dataset, path: Path) -> None:
    with extra("files"):
        import meshio

    shape = inside.von_mises.shape
    section = shape[2] == 1
    if min(shape[:2]) < 2:
        raise InvalidInput(
            "inside", "must have at least two depths, two phi and, for a volume, two theta", f"shape {shape}"
        )
    axes, points = _frame(inside)
    displacement = inside.displacement.to_numpy().reshape(3, -1)
    stress = inside.stress.to_numpy().reshape(len(COMPONENTS), -1)
    rr, pp, tt, rp, rt, pt = stress
    tensor = np.array([[rr, rp, rt], [rp, pp, pt], [rt, pt, tt]])
    turned = np.einsum("ian,ijn,jbn->nab", axes, tensor, axes)
    number = np.arange(np.prod(shape)).reshape(shape)
    # At a boundary between layers, two places have the same depth: no cells between them.
    first = np.nonzero(np.diff(inside.depth.to_numpy()) != 0.0)[0]
    near, far = number[first], number[first + 1]
    if section:
        cells = (
            "quad",
            np.stack([near[:, :-1, 0], near[:, 1:, 0], far[:, 1:, 0], far[:, :-1, 0]], axis=-1).reshape(-1, 4),
        )
    else:
        corners = [
            part[:, i : shape[1] - 1 + i, j : shape[2] - 1 + j]
            for part in (near, far)
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))
        ]
        cells = "hexahedron", np.stack(corners, axis=-1).reshape(-1, 8)
    mesh = meshio.Mesh(
        points.T,
        [cells],
        point_data={
            "displacement [m]": np.einsum("ian,in->na", axes, displacement),
            "stress [Pa]": turned.reshape(-1, 9),
            **{
                f"{name} [Pa]": inside[name].to_numpy().ravel()
                for name in ("von_mises", "hydrostatic_pressure", "opening_traction", "shear_traction")
            },
        },
    )
    with draft_of(path) as draft:
        mesh.write(draft)


def _frame(inside: xarray.Dataset) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the unit vectors of r, φ and θ (forward, sideways, up), (3, 3, points), and the points, (3, points)."""
    depth, x, z = np.meshgrid(inside.depth, inside.x, inside.z, indexing="ij")
    zero, one = np.zeros_like(x), np.ones_like(x)
    if "radius" not in inside.coords:
        axes = [[zero, zero, one], [-one, zero, zero], [zero, -one, zero]]
        return np.array(axes).reshape(3, 3, -1), np.array([x, z, -depth]).reshape(3, -1)
    _, phi, theta = np.meshgrid(inside.depth, inside.phi, inside.theta, indexing="ij")
    is_straight = inside.attrs["body"] == "CoatedWheel"
    if inside.sizes["theta"] == 1 or is_straight:
        theta = np.full_like(theta, 0.5 * np.pi)
    # The counterbody lies below: the contact is at its highest point, and its material also moves backward there.
    up = 1.0 if inside.attrs["of"] == "counterbody" else -1.0
    axes = [
        [np.sin(theta) * np.cos(phi), np.cos(theta), up * np.sin(theta) * np.sin(phi)],
        [-np.sin(phi), zero, up * np.cos(phi)],
        [np.cos(theta) * np.cos(phi), -np.sin(theta), up * np.cos(theta) * np.sin(phi)],
    ]
    frame = np.array(axes).reshape(3, 3, -1)
    points = (inside.radius.to_numpy()[:, None, None] * one).ravel() * frame[0]
    if is_straight:
        points[1] = z.ravel()
    return frame, points
