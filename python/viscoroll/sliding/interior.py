"""Displacement, strain and stress inside the layers under a sliding rough surface."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import as_int
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.progress import ProgressLike, reporting
from ..solution.inside import finite_line
from ..solution.interior_fields import fields_in_layers, place_coordinates, warn_of_shallow_places
from .inside import layers_below
from .solution import SlidingSolution

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

__all__ = ["bonds", "interior"]


def interior(
    result: SlidingSolution,
    *,
    depth: ArrayLike,
    x: ArrayLike | None = None,
    z: ArrayLike | None = None,
    threads: int = 0,
    progress: ProgressLike = None,
) -> xarray.Dataset:
    """Return displacement, strain and stress inside the layers.

    Parameters
    ----------
    depth : array_like
        Depth below the surface [m], within the layers. At a boundary between layers, strains and stresses along the
        surface are discontinuous. Such a depth appears twice, first for the outer layer; see the coordinate `layer`.
    x, z : array_like, optional
        Positions along and across the sliding direction [m], by default those of the nodes, which begin at 0. Under a
        surface of finite size, they must lie within 4/3 of the longer side from its middle. Under a profile, z is 0.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    xarray.Dataset
        Variables of `viscoroll.Result.interior` over (depth, x, z): `displacement` [m] by `direction`, `stress` [Pa]
        (tension positive) and `strain` [-] by `component`; from these `von_mises`, `principal_stress` (largest first),
        `hydrostatic_pressure`, and the traction on planes of equal depth: its tension `opening_traction`, 0 under
        compression, and its shear `shear_traction` [Pa]. In the names of the components, r points out of the layers, φ
        against the sliding direction x, and θ against z.

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid.
    ImportError
        If the extra `viscoroll[files]` is missing.

    Warns
    -----
    ResultWarning
        If a depth under a surface of finite size is too small for the mesh: less than a quarter of a node spacing, or
        half of one between nodes.

    Notes
    -----
    Fields under a periodic surface are sums over all waves of the pressure, without an error of their own. The mean
    pressure compresses layers that cannot expand along the surface, which adds a stress ν/(1 - ν) times the mean
    pressure there. A half-space sinks infinitely deep under the mean pressure; its displacement is relative to the mean
    displacement of the surface. Under a finite surface, each node presses on a square patch, as in
    `viscoroll.Result.interior`; the displacement of a half-space under a finite profile is infinite, and NaN is
    returned.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
    >>> wavy = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2e3 * np.pi * x), nodes=(512, 1), side=1e-3)
    >>> mat = vr.CoatedPlane(layers=[vr.Layer(thickness=2e-4, shear_modulus=rubber, poisson_ratio=0.5)])
    >>> r = vr.slide(wavy, on=mat, pressure=6e4, speed=0.01)
    >>> inside = r.interior(depth=[5e-5, 2e-4])
    >>> print(f"{inside.von_mises.max().item() / 1e6:.2f} MPa")
    0.33 MPa
    """
    with extra("files"):
        import xarray

    inside = layers_below(result)
    positions, layers = inside.places(depth)
    on_nodes = x is None and z is None
    rows, columns = (
        nodes if given is None else finite_line(name, given)
        for name, given, nodes in zip(("x", "z"), (x, z), inside.nodes(), strict=True)
    )
    if inside.line_contact and columns.any():
        raise InvalidInput("z", "must be 0 m under a profile", f"{columns[columns != 0.0][0]:g} m")
    finite = not result.surface.periodic
    depths = inside.depth(positions)
    if finite and depths.size and depths.min() <= 0.0:
        raise InvalidInput("depth", "must be > 0 m under a surface of finite size", "0 m")
    with reporting(progress) as report:
        values = _core.sliding_fields(
            result.on._to_core(),
            inside.tractions(),
            position=positions,
            layer=layers,
            x=rows,
            z=columns,
            speed=result.speed,
            threads=as_int("threads", threads),
            progress=report,
        )
    if finite:
        spacing = result.surface.spacing[0] if inside.line_contact else max(result.surface.spacing)
        warn_of_shallow_places(spacing, depths, on_nodes)
        if inside.line_contact and not np.isfinite(inside.thickness):
            values[:, :3] = np.nan
    coordinates = {
        **place_coordinates(inside, positions),
        "layer": ("depth", layers, {"long_name": "number of the layer, from the base outwards"}),
        "x": ("x", rows, {"units": "m", "long_name": "position along the sliding direction"}),
        "z": ("z", columns, {"units": "m", "long_name": "position across the sliding direction"}),
    }
    return fields_in_layers(xarray.Dataset, values, ("depth", "x", "z"), coordinates, inside.attributes())


def bonds(result: SlidingSolution, *, threads: int = 0, progress: ProgressLike = None) -> xarray.Dataset:
    """Return the fields at all bonds, between layers and to a rigid base, where debonding may occur.

    Parameters
    ----------
    threads, progress
        Same as in `interior`.

    Returns
    -------
    xarray.Dataset
        Same as in `interior`, at the rigid base if there is one, and on both sides of every boundary between layers.

    Raises
    ------
    ValueError
        If there is no bond.
    """
    inside = layers_below(result)
    depths = inside.depth(inside.bonded())
    if not depths.size:
        raise InvalidInput("result.on", "must have a rigid base or several layers to have bonds")
    return interior(result, depth=depths, threads=threads, progress=progress)
