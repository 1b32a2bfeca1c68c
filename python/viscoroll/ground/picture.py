"""Pictures of profiles, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._support.pictures import Picture, draw_picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._support.arguments import Floats

__all__ = ["plot_profile"]

_MILLI = 1e3


def plot_profile(distance: Floats, height: Floats, ax: Axes | None = None) -> Picture | Axes:
    """Draw heights over distances [m], in millimeters."""

    def draw(axes: Axes) -> None:
        axes.plot(distance * _MILLI, height * _MILLI, color="0.3")
        axes.fill_between(distance * _MILLI, height * _MILLI, height.min() * _MILLI, color="0.85")
        axes.set(xlabel="distance [mm]", ylabel="height [mm]")

    return draw_picture(draw, ax, figsize=(8.0, 3.0))
