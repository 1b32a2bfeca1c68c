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


def plot_temperature(rise: xarray.DataArray, title: str, ax: Axes | None = None) -> Picture | Axes:
    """Draw the temperature rise over the cross-section of the layers."""
    return draw_picture(lambda axes: _draw(axes, rise, title), ax, figsize=(7.0, 6.0))


def _draw(axes: Axes, rise: xarray.DataArray, title: str) -> None:
    normal, across = rise.dims
    rise = rise.drop_duplicates(normal)
    below = "from the axis [mm]" if normal == "radius" else "depth [mm]"
    if normal == "depth":
        axes.invert_yaxis()
    if rise.sizes[across] == 1:
        axes.plot(rise[:, 0], rise[normal] * _MM, color="tab:red")
        axes.set(xlabel="temperature rise [K]", ylabel=below)
        axes.set_title(title, fontsize="medium")
        return
    place, along = np.meshgrid(rise[normal], rise[across], indexing="ij")
    if across == "theta":
        place, along = place * np.sin(along), place * np.cos(along)
    image = axes.contourf(along * _MM, place * _MM, rise.to_numpy(), levels=24, cmap="inferno")
    axes.set(xlabel="along the axis [mm]", ylabel=below)
    if normal == "radius":
        axes.set(aspect="equal")
    axes.set_title(title, fontsize="medium")
    axes.figure.colorbar(image, ax=axes, label="temperature rise [K]")
