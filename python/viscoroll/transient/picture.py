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

__all__ = ["plot_ground", "plot_history"]

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


def plot_ground(
    series: Series, units: Units, distance: NDArray[np.float64], ground: NDArray[np.float64], ax: Axes | None = None
) -> Picture | Axes:
    """Draw ground and path of the axle, load, torque and contact length over the distance.

    Parameters
    ----------
    series, units
        Same as in `plot_history`.
    distance, ground : ndarray
        Distance rolled, and height of the ground there [m].
    ax : matplotlib.axes.Axes, optional
        Axes for ground and path of the axle only.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        Four axes over the distance in a figure without a window; or `ax`.
    """

    def draw_path(axes: Axes) -> None:
        axes.plot(distance * _MILLI, ground * _MILLI, color="0.3", label="ground")
        axes.plot(distance * _MILLI, -series["penetration"] * _MILLI, label="axle, above $r_o$")
        axes.set_ylabel("height [mm]")
        axes.legend(fontsize="small")

    def compose(picture: Picture) -> None:
        axes = picture.subplots(4, 1, sharex=True)
        draw_path(axes[0])
        for one, name, label, factor in (
            (axes[1], "load", f"load [{units['load']}]", 1.0),
            (axes[2], "resisting_torque", f"$T_r$ [m{units['resisting_torque']}]", _MILLI),
            (axes[3], "contact_length", "contact length [mm]", _MILLI),
        ):
            one.plot(distance * _MILLI, series[name] * factor)
            one.set_ylabel(label)
        axes[3].set_xlabel("distance [mm]")

    return draw_picture(draw_path, ax, figsize=(9.0, 8.0), compose=compose)
