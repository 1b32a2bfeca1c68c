"""Pictures of histories, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, drawn

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .history import History

__all__ = ["draw_torque", "plot_history"]

_MILLI = 1e3


def plot_history(history: History) -> Picture:
    """Draw torque, penetration and energies over time, and the torque over the angle.

    Parameters
    ----------
    history : History
        What was computed.

    Returns
    -------
    matplotlib.figure.Figure
        Three axes over time beside the loop; the figure belongs to no window.
    """
    figure = Picture(figsize=(12.0, 6.4), layout="constrained")
    axes = figure.subplot_mosaic([["torque", "loop"], ["penetration", "loop"], ["energy", "loop"]])
    _draw_series(axes, history)
    _draw_loop(axes["loop"], history)
    return figure


def draw_torque(history: History, ax: Axes) -> Axes:
    """Draw the torque over time alone into axes of the caller's."""
    drawn(lambda axes: _draw_torque(axes, history), ax, figsize=(7.0, 4.0))
    ax.set_xlabel("time [s]")
    return ax


def _draw_torque(axes: Axes, history: History) -> None:
    torque = history.resisting_torque * _MILLI
    axes.plot(history.time, torque)
    if np.isfinite(history.error_estimate).all():
        error = history.error_estimate * _MILLI
        axes.fill_between(history.time, torque - error, torque + error, alpha=0.3)
    axes.set_ylabel("$T_r$ [mN m]")


def _draw_series(axes: dict[str, Axes], history: History) -> None:
    time = history.time
    _draw_torque(axes["torque"], history)
    axes["penetration"].plot(time, history.penetration * _MILLI)
    axes["penetration"].set_ylabel("penetration [mm]")
    for name, label in (("stored_energy", "stored"), ("dissipated_energy", "lost"), ("work", "work")):
        axes["energy"].plot(time, getattr(history, name) * _MILLI, label=label)
    axes["energy"].set(xlabel="time [s]", ylabel="energy [mJ]")
    axes["energy"].legend(fontsize="small")
    for name in ("torque", "penetration"):
        axes[name].sharex(axes["energy"])
        axes[name].tick_params(labelbottom=False)


def _draw_loop(axes: Axes, history: History) -> None:
    angle = np.degrees(history.angle)
    axes.plot(angle, history.driving_torque * _MILLI)
    axes.axhline(0.0, color="0.5", linewidth=0.8)
    work = float(np.trapezoid(history.driving_torque, history.angle)) * _MILLI
    axes.set(xlabel="angle turned [°]", ylabel="driving torque $T$ [mN m]", title=f"∫$T$ d$ψ$ = {work:.4g} mJ")
