"""Pictures of histories, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture
from .._support.quantities import quantity_text
from .._support.scales import Scale

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Series = Mapping[str, NDArray[np.float64]]
    Units = Mapping[str, str]

__all__ = ["plot_ground", "plot_history"]


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


def _scale(series: Series, units: Units, *names: str) -> Scale:
    """Return the common scale of time series."""
    return Scale.of(np.concatenate([series[name] for name in names]), units[names[0]])


def _draw_torque(axes: Axes, series: Series, units: Units) -> None:
    scale = _scale(series, units, "resisting_torque")
    torque, error = (series[name] / scale.factor for name in ("resisting_torque", "error_estimate"))
    axes.plot(series["time"], torque)
    if np.isfinite(error).all():
        axes.fill_between(series["time"], torque - error, torque + error, alpha=0.3)
    axes.set(xlabel="time [s]", ylabel=scale.text("$T_r$"))


def _draw_others(axes: dict[str, Axes], series: Series, units: Units) -> None:
    time, scale = series["time"], _scale(series, units, "penetration")
    axes["penetration"].plot(time, series["penetration"] / scale.factor)
    axes["penetration"].set_ylabel(scale.text("penetration"))
    energies = {"work": "work", "stored_energy": "stored", "dissipated_energy": "dissipated"}
    scale = _scale(series, units, *energies)
    for name, label in energies.items():
        axes["energy"].plot(time, series[name] / scale.factor, label=label)
    axes["energy"].set(xlabel="time [s]", ylabel=scale.text("energy"))
    axes["energy"].legend(fontsize="small")
    for name in ("torque", "penetration"):
        axes[name].sharex(axes["energy"])
        axes[name].label_outer()


def _draw_loop(axes: Axes, series: Series, units: Units) -> None:
    torque, angle = series["resisting_torque"], series["angle"]
    scale = _scale(series, units, "resisting_torque")
    axes.plot(np.degrees(angle), torque / scale.factor)
    axes.axhline(0.0, color="0.5", linewidth=0.8)
    work = 0.5 * float(np.sum((torque[1:] + torque[:-1]) * np.diff(angle)))  # NumPy 1 has no trapezoid
    axes.set(
        xlabel="angle turned [°]",
        ylabel=scale.text("resisting torque $T_r$"),
        title=f"∫$T_r$ d$ψ$ = {quantity_text(work, units['work'])}",
    )


def plot_ground(
    series: Series, units: Units, distance: NDArray[np.float64], ground: NDArray[np.float64], ax: Axes | None = None
) -> Picture | Axes:
    """Draw ground and path of the axle, load, push force and contact length over the distance.

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
    along = Scale.of(distance, "m")

    def draw_path(axes: Axes) -> None:
        shown = ground if np.isnan(series["penetration"]).any() else np.concatenate([ground, series["penetration"]])
        scale = Scale.of(shown, "m")
        axes.plot(distance / along.factor, ground / scale.factor, color="0.3", label="ground")
        axes.plot(distance / along.factor, -series["penetration"] / scale.factor, label="axle, above $r_o$")
        axes.set(xlabel=along.text("distance"), ylabel=scale.text("height"))
        axes.legend(fontsize="small")

    def compose(picture: Picture) -> None:
        axes = picture.subplots(4, 1, sharex=True)
        draw_path(axes[0])
        for one, name, label in zip(
            axes[1:],
            ("load", "resisting_force", "contact_length"),
            ("load", "push force", "contact length"),
            strict=True,
        ):
            scale = _scale(series, units, name)
            one.plot(distance / along.factor, series[name] / scale.factor)
            one.set(xlabel=along.text("distance"), ylabel=scale.text(label))
        for one in axes:
            one.label_outer()

    return draw_picture(draw_path, ax, figsize=(9.0, 8.0), compose=compose)
