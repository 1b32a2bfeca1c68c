"""Picture of the temperature rise over the cross-section."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

__all__ = ["plot_temperature"]

_MM = 1e3

#: Ratio of width to height of a section above which its axes are scaled independently.
_SLENDER = 3.0


def plot_temperature(rise: xarray.DataArray, title: str, ax: Axes | None = None) -> Picture | Axes:
    """Draw the temperature rise over the cross-section of the layers."""
    return draw_picture(lambda axes: _draw(axes, rise, title), ax, figsize=(7.0, 6.0))


def _draw(axes: Axes, rise: xarray.DataArray, title: str) -> None:
    normal_name, across_name = rise.dims
    rise = rise.drop_duplicates(normal_name)
    normal_label = "from the axis [mm]" if normal_name == "radius" else "depth [mm]"
    if normal_name == "depth":
        axes.invert_yaxis()
    if rise.sizes[across_name] == 1:
        axes.plot(rise[:, 0], rise[normal_name] * _MM, color="tab:red")
        axes.set(xlabel="temperature rise [K]", ylabel=normal_label)
        axes.set_title(title, fontsize="medium")
        return
    vertical, horizontal = np.meshgrid(rise[normal_name], rise[across_name], indexing="ij")
    if across_name == "theta":
        radius, theta = vertical, horizontal
        vertical, horizontal = radius * np.sin(theta), radius * np.cos(theta)
    image = axes.contourf(horizontal * _MM, vertical * _MM, rise.to_numpy(), levels=24, cmap="inferno")
    axes.set(xlabel="along the axis [mm]", ylabel=normal_label)
    if normal_name == "radius" and np.ptp(horizontal) < _SLENDER * np.ptp(vertical):
        axes.set(aspect="equal")
    axes.set_title(title, fontsize="medium")
    axes.figure.colorbar(image, ax=axes, label="temperature rise [K]")
