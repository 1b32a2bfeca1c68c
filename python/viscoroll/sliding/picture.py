"""Pictures of rough surfaces and of the pressure on them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.pictures import Picture, draw_picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

__all__ = ["draw_field"]

_MILLI = 1e3


def draw_field(
    values: NDArray[np.float64], sides: tuple[float, float], label: str, *, colors: str, ax: Axes | None
) -> Picture | Axes:
    """Draw a field of a surface: a map with x to the right, or a line if it has one column.

    Parameters
    ----------
    values : ndarray, shape (nodes along x, nodes along z)
        Field; undefined values are white in a map.
    sides : tuple of two floats
        Length and width of the surface [m].
    label : str
        Quantity and unit.
    colors : str
        Name of the colors of a map.
    ax : matplotlib.axes.Axes or None
        Axes of the caller; None for a new picture.
    """
    along, across = (side * _MILLI for side in sides)

    def draw(axes: Axes) -> None:
        axes.set_xlabel("x, sliding direction [mm]")
        if values.shape[1] == 1:
            axes.plot(np.arange(len(values)) * along / len(values), values[:, 0])
            axes.set_ylabel(label)
            return
        image = axes.imshow(values.T, origin="lower", extent=(0.0, along, 0.0, across), cmap=colors)
        axes.figure.colorbar(image, ax=axes, label=label)
        axes.set_ylabel("z [mm]")

    return draw_picture(draw, ax, figsize=(6.4, 5.2))
