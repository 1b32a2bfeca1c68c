"""Pictures of histories, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._extras import extra

with extra("plot"):
    from matplotlib.figure import Figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .history import History

__all__ = ["plot_history"]

_MILLI = 1e3


def plot_history(history: History) -> Figure:
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
    figure = Figure(figsize=(12.0, 6.4), layout="constrained")
    axes = figure.subplot_mosaic([["torque", "loop"], ["penetration", "loop"], ["energy", "loop"]])
    _draw_series(axes, history)
    _draw_loop(axes["loop"], history)
    return figure


def _draw_series(axes: dict[str, Axes], history: History) -> None:
    time = history.time
    torque = history.resisting_torque * _MILLI
    axes["torque"].plot(time, torque)
    if np.isfinite(history.error_estimate).all():
        error = history.error_estimate * _MILLI
        axes["torque"].fill_between(time, torque - error, torque + error, alpha=0.3)
    axes["torque"].set_ylabel("$T_r$ [mN m]")
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
