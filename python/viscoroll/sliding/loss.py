"""Energy dissipated inside the layers under a sliding rough surface."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import as_int, as_positive
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.progress import ProgressLike, reporting
from ..solution.interior_fields import place_coordinates
from ..solution.loss import ROUND_OFF, layer_powers, require_balance
from ..solution.solution import described
from .inside import LayersBelow, layers_below
from .solution import SlidingSolution

if TYPE_CHECKING:
    import xarray
    from numpy.typing import ArrayLike

__all__ = ["loss"]

#: Largest number of waves along the longer side of a finite surface by default.
_WAVES_PER_SIDE = 4000


def loss(
    result: SlidingSolution,
    *,
    depth: ArrayLike | None = None,
    shortest_wave: float | None = None,
    threads: int = 0,
    progress: ProgressLike = None,
) -> xarray.Dataset:
    """Return the energy dissipated inside the layers, per volume and passage of the surface.

    Parameters
    ----------
    depth : array_like, optional
        Depths of the densities [m]; by default the nodes of the volume integral.
    shortest_wave : float, optional
        Shortest wavelength of the sums under a surface of finite size [m], at most four times its longer side.
        The default is the node spacing, which is the smaller one of both directions, but at least 1/4000 of the longer
        side. A periodic surface has all waves of its mesh, and this argument must be left out.
    threads : int, default 0
        Number of threads; 0 for all cores.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    xarray.Dataset
        `loss_density` w [J/m³ per passage] over (depth, z), the same at all x; under a periodic surface, a passage is
        that of one period, and `power_density` [W/m³] is the mean over it. `layer_power` [W] by `layer`, and
        `relaxation_power` [W] by `layer` and `term` for layers with a Prony series. Attributes: `power`, the volume
        integral [W], `surface_power`, the power of the tractions in the same waves, and `bulk_power`, that of the
        result, `power_density` times the area of the surface. Under a profile, powers are per length [W/m].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid.
    ImportError
        If the extra `viscoroll[files]` is missing.
    ConvergenceError
        If the volume integral differs from the power of the tractions in the same waves by more than a relative 1e-7.

    Notes
    -----
    Under a periodic surface, `power` is `bulk_power`. Under a finite surface, the sums end at the shortest wave, so
    that `power` is less than `bulk_power`. They also assume parallel tracks at a distance of four times the longer
    side, attribute `track_distance` [m]. Heat from slip at the interface is not part of the loss.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
    >>> wavy = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2e3 * np.pi * x), nodes=(512, 1), side=1e-3)
    >>> mat = vr.CoatedPlane(layers=[vr.Layer(thickness=2e-4, shear_modulus=rubber, poisson_ratio=0.5)])
    >>> r = vr.slide(wavy, on=mat, pressure=6e4, speed=0.01)
    >>> loss = r.loss()
    >>> print(f"{loss.attrs['power'] / loss.attrs['bulk_power']:.6f}")
    1.000000
    """
    with extra("files"):
        import xarray

    inside = layers_below(result)
    positions, layers = (np.empty(0), np.empty(0, np.int32)) if depth is None else inside.places(depth)
    with reporting(progress) as report:
        lost = _core.sliding_loss(
            result.on._to_core(),
            inside.tractions(),
            position=positions,
            layer=layers,
            speed=result.speed,
            shortest_wave=_shortest_wave(inside, shortest_wave),
            threads=as_int("threads", threads),
            progress=report,
        )
    length, across = result.surface.sides
    load = result.mean_pressure * length * (1.0 if inside.line_contact else across)
    require_balance(lost.volume_power, lost.surface_power, ROUND_OFF * load * result.speed)
    positions, layers = lost.places
    density = np.maximum(lost.density, 0.0)
    where = ("depth", "z")
    densities = {"loss_density": (where, density, described("J m-3", "energy dissipated per volume and passage"))}
    if result.surface.periodic:
        mean = described("W m-3", "power dissipated per volume, mean along the sliding direction")
        densities["power_density"] = (where, density * (result.speed / length), mean)
    wave_power = lost.wave_power.reshape(len(inside.layers), -1)
    return xarray.Dataset(
        densities | layer_powers(inside.layers, lost.frequency, wave_power, inside.line_contact),
        {
            **place_coordinates(inside, positions),
            "place_layer": ("depth", layers, {"long_name": "number of the layer, from the base outwards"}),
            "z": ("z", lost.z, {"units": "m", "long_name": "position across the sliding direction"}),
        },
        attrs=inside.attributes()
        | {"power": lost.volume_power, "surface_power": lost.surface_power, "bulk_power": inside.bulk_power}
        | ({} if inside.line_contact else {"track_distance": lost.track_distance}),
    )


def _shortest_wave(inside: LayersBelow, given: float | None) -> float:
    """Return the shortest wavelength of the sums under a surface of finite size [m]."""
    surface = inside.result.surface
    if surface.periodic:
        if given is not None:
            raise InvalidInput("shortest_wave", "must be left out under a periodic surface")
        return surface.spacing[0]
    if given is not None:
        return as_positive("shortest_wave", given, "m")
    smallest = surface.spacing[0] if inside.line_contact else min(surface.spacing)
    return max(smallest, max(surface.sides) / _WAVES_PER_SIDE)
