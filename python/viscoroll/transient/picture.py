"""Pictures of histories, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Series = Mapping[str, NDArray[np.float64]]
    Units = Mapping[str, str]

__all__ = ["plot_history"]

_MILLI = 1e3


def plot_history(series: Series, units: Units, ax: Axes | None = None) -> Picture | Axes:
    """Draw torque, penetration and energies over time, and the torque over the angle.

    Parameters
    ----------
    series : mapping of str to ndarray
        Time series of a history by name, including the time.
    units : mapping of str to str
        Units of the time series by name.
    ax : matplotlib.axes.Axes, optional
        Axes for the torque over time only.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        Three axes over time beside the loop, in a figure without a window; or `ax`.
    """

    def compose(picture: Picture) -> None:
        axes = picture.subplot_mosaic([["torque", "loop"], ["penetration", "loop"], ["energy", "loop"]])
        _draw_torque(axes["torque"], series, units)
        _draw_others(axes, series, units)
        _draw_loop(axes["loop"], series, units)

    return draw_picture(lambda axes: _draw_torque(axes, series, units), ax, figsize=(12.0, 6.4), compose=compose)


def _draw_torque(axes: Axes, series: Series, units: Units) -> None:
    time, torque, error = (series[name] for name in ("time", "resisting_torque", "error_estimate"))
    axes.plot(time, torque * _MILLI)
    if np.isfinite(error).all():
        axes.fill_between(time, (torque - error) * _MILLI, (torque + error) * _MILLI, alpha=0.3)
    axes.set(xlabel="time [s]", ylabel=f"$T_r$ [m{units['resisting_torque']}]")


def _draw_others(axes: dict[str, Axes], series: Series, units: Units) -> None:
    time = series["time"]
    axes["penetration"].plot(time, series["penetration"] * _MILLI)
    axes["penetration"].set_ylabel("penetration [mm]")
    for name, label in (("stored_energy", "stored"), ("dissipated_energy", "dissipated"), ("work", "work")):
        axes["energy"].plot(time, series[name] * _MILLI, label=label)
    axes["energy"].set(xlabel="time [s]", ylabel=f"energy [m{units['work']}]")
    axes["energy"].legend(fontsize="small")
    for name in ("torque", "penetration"):
        axes[name].sharex(axes["energy"])
        axes[name].label_outer()


def _draw_loop(axes: Axes, series: Series, units: Units) -> None:
    axes.plot(np.degrees(series["angle"]), series["resisting_torque"] * _MILLI)
    axes.axhline(0.0, color="0.5", linewidth=0.8)
    torque, angle = series["resisting_torque"], series["angle"]
    work = 0.5 * float(np.sum((torque[1:] + torque[:-1]) * np.diff(angle))) * _MILLI  # NumPy 1 has no trapezoid
    axes.set(
        xlabel="angle turned [°]",
        ylabel=f"resisting torque $T_r$ [m{units['resisting_torque']}]",
        title=f"∫$T_r$ d$ψ$ = {work:.4g} m{units['work']}",
    )
