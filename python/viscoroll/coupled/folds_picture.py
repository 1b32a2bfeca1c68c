"""Picture of the folds of self-heating: mean temperatures of the steady states over load and over speed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

import numpy as np

from .._core import ConvergenceError
from .._support.pictures import Picture
from .._support.scales import Scale
from .steady_states import SteadyState

__all__ = ["plot_folds"]

#: Function that returns the load or the speed at which a steady state has a mean temperature.
FoundAt: TypeAlias = Callable[[float], float]


def plot_folds(states: Sequence[SteadyState], limit: float, points: int, loads: FoundAt, speeds: FoundAt) -> Picture:
    """Draw the mean temperatures of the steady states over load and over speed.

    Parameters
    ----------
    states : sequence of SteadyState
        Steady states of the given case.
    limit : float
        Highest mean temperature [K].
    points : int
        Number of points of each curve.
    loads, speeds : callable
        Functions that return the load or the speed [rad/s] at which a steady state has a mean temperature [K].
    """
    first = states[0].temperature.ambient
    result = states[0].result
    rises = (limit - first) * np.geomspace(0.02, 0.98, points)
    figure = Picture(figsize=(10.0, 4.0), layout="constrained")
    panels = (
        ("load", result.load, Scale.of(2.5 * result.load, result.unit("load")), loads),
        ("angular speed", result.angular_speed, Scale.of(result.angular_speed, "rad/s"), speeds),
    )
    for axes, (name, at, scale, found_at) in zip(figure.subplots(1, 2, sharey=True), panels, strict=True):
        here = at / scale.factor
        curve = []
        for rise in rises.tolist():
            try:
                curve.append((found_at(first + rise) / scale.factor, first + rise))
            except (ValueError, ConvergenceError):  # the load exceeds what the layers support, or no speed is found
                break
        axes.plot([value for value, _ in curve], [mean for _, mean in curve], color="tab:red")
        for state in states:
            axes.plot(here, state.mean_temperature, "o", color="k", markerfacecolor="k" if state.stable else "none")
        axes.set(xlabel=scale.text(name), xlim=(0.0, 2.5 * here))
    figure.axes[0].set(ylabel="mean temperature [K]")
    return figure
