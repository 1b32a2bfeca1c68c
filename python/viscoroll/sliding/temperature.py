"""Temperature of the layers under a sliding rough surface, from the loss averaged along the sliding direction."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_kelvin, as_member, as_positive
from .._support.errors import InvalidInput
from .._support.progress import ProgressLike
from ..thermal.heated_body import heated_plane
from ..thermal.surroundings import Core, Surroundings
from ..thermal.temperature import Temperature, temperature_of
from .inside import LayersBelow, layers_below
from .loss import loss
from .solution import SlidingSolution

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["temperature"]

#: Number of waves of the temperature across the width of a surface: the source of wave j causes a rise in proportion to
#: 1/j². The second limit is the largest number of e-folds of the highest wave across the layers, on which the memory
#: depends.
_WAVES = 16
_FOLDS = 400.0


def temperature(
    result: SlidingSolution,
    *,
    conductivity: float | Sequence[float] | None = None,
    convection: float,
    ambient: float,
    core: Core | str = Core.INSULATED,
    core_temperature: float | None = None,
    base_convection: float | None = None,
    period: float | None = None,
    time: ArrayLike | None = None,
    start: Temperature | None = None,
    heat_capacity: float = 2e6,
    progress: ProgressLike = None,
) -> Temperature:
    """Return the steady temperature of the layers, without flash temperatures.

    The source is the loss in the layers, averaged along the sliding direction. Hot spots under single asperities and
    heat from slip at the interface (`interface_power_density`) are not included.

    Parameters
    ----------
    conductivity : float or sequence of float, optional
        Conductivity of all layers or of each layer [W/(m K)], > 0; by default that of each `Layer`.
    convection : float
        Coefficient of convection at the surface [W/(m² K)], ≥ 0.
    ambient : float
        Temperature of the surroundings [K], ≥ 100.
    core : Core or str, default Core.INSULATED
        Thermal condition at the base: "insulated" or "isothermal".
    core_temperature : float, optional
        Temperature of an isothermal base [K]; by default that of the surroundings.
    base_convection : float, optional
        Coefficient of convection below the layers, such as at the other face of a belt [W/(m² K)], ≥ 0.
    period : float, optional
        Time from one passage of a surface of finite size to the next [s], > 0; required for it. A periodic surface
        slides without pause, and the argument must be left out.
    time, start, heat_capacity
        Same as in `viscoroll.Result.temperature`.
    progress : bool or callable, optional
        Same as in `loss`.

    Returns
    -------
    viscoroll.thermal.Temperature
        Temperature rise over (depth, z) and heat flows, per length of the path [W/m]; under a profile per area [W/m²].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid, if no surface takes the heat, or if the layers lie on a half-space.
    ImportError
        If the extra `viscoroll[files]` is missing.

    Warns
    -----
    ResultWarning
        If the temperature of a point varies over a passage by more than a fifth of the largest rise, or if it rises by
        more than 200 K.

    Notes
    -----
    The temperature across the path has waves down to 1/16 of the width of the surface; if the layers are thicker than
    four times this width, down to 1/64 of the thickness. A finite surface has parallel tracks, at the distance of those
    of `loss`.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
    >>> wavy = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2e3 * np.pi * x), nodes=(512, 1), side=1e-3)
    >>> mat = vr.CoatedPlane(layers=[vr.Layer(thickness=2e-4, shear_modulus=rubber, poisson_ratio=0.5)])
    >>> r = vr.slide(wavy, on=mat, pressure=6e4, speed=0.01)
    >>> t = r.temperature(conductivity=0.2, convection=10.0, ambient=293.15)
    >>> print(f"{t.maximum:.2f} K, {t.heat:.1f} {t.heat_unit}")
    0.55 K, 5.5 W/m²
    """
    given = Surroundings(
        convection=convection,
        ambient=as_kelvin("ambient", ambient),
        core=as_member("core", core, Core) if isinstance(core, str) else core,
        core_temperature=core_temperature,
        base_convection=base_convection,
        period=period,
    )
    inside = layers_below(result)
    passage = _time_of_passage(inside, period)
    lost = loss(result, progress=progress)
    # Energy of one passage per length of the path, and under a profile also per width
    energy = inside.bulk_power / result.speed if result.speed > 0.0 else 0.0
    body = heated_plane(
        inside,
        given,
        conductivity,
        track_distance=lost.attrs.get("track_distance"),
        waves=_waves(inside, lost.attrs.get("track_distance", 0.0)),
        period=passage,
        power=energy / passage,
    )
    return temperature_of(body, lambda: lost, given.ambient, time=time, start=start, heat_capacity=heat_capacity)


def _waves(inside: LayersBelow, track_distance: float) -> int:
    """Return the number of waves across: at most those of the mesh under a periodic surface."""
    surface = inside.result.surface
    most = [_WAVES * track_distance / surface.sides[1], _FOLDS * track_distance / (2.0 * np.pi * inside.thickness)]
    if surface.periodic:
        most.append((surface.heights.shape[1] - 1) // 2)
    return max(1, int(min(most)))


def _time_of_passage(inside: LayersBelow, period: float | None) -> float:
    """Return the time from one passage to the next [s]."""
    result = inside.result
    if not result.surface.periodic:
        if period is None:
            raise InvalidInput(
                "period", "must be given under a surface of finite size: the time from one passage to the next [s]"
            )
        return as_positive("period", period, "s")
    if period is not None:
        raise InvalidInput("period", "must be left out under a periodic surface, which slides without pause")
    if result.speed == 0.0:
        raise InvalidInput("result.speed", "must be > 0 m/s for a temperature", "0")
    return result.surface.sides[0] / result.speed
