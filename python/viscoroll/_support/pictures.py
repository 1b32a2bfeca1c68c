"""What all pictures share, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from os import PathLike, fspath

from .extras import extra
from .text import shown

with extra("plot"):
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Picture", "drawn"]


class Picture(Figure):
    """A figure that a notebook shows as the value of a cell, once: pyplot, which shows its own, knows nothing of it."""

    def _repr_png_(self) -> bytes:
        """Return the picture, for notebooks in which matplotlib has not been set up to do so."""
        file = BytesIO()
        self.savefig(file, format="png", bbox_inches="tight")
        return file.getvalue()


def drawn(
    draw: Callable[[Axes], object],
    ax: Axes | None,
    *,
    figsize: tuple[float, float],
    compose: Callable[[Picture], object] | None = None,
) -> Picture | Axes:
    """Draw into axes of the caller's, or a new picture.

    Parameters
    ----------
    draw : callable
        Called with the axes.
    ax : matplotlib.axes.Axes or None
        The caller's.
    figsize : (float, float)
        Of a new picture [inch].
    compose : callable, optional
        Called with a new picture, of which the axes that `draw` fills are one part; without it they are all.

    Returns
    -------
    Picture or matplotlib.axes.Axes
        What a notebook shows once: the new picture, or the axes, whose figure shows itself.

    Raises
    ------
    TypeError
        Where `ax` is something else.
    """
    if ax is None:
        picture = Picture(figsize=figsize, layout="constrained")
        if compose is None:
            draw(picture.subplots())
        else:
            compose(picture)
        return picture
    if not isinstance(ax, Axes):
        raise TypeError(f"ax must be a matplotlib.axes.Axes or None, got {shown(ax)}{_way_to_a_file(ax)}")
    draw(ax)
    return ax


def _way_to_a_file(target: object) -> str:
    """Say how a picture gets to the file that was given in place of axes."""
    if not isinstance(target, str | PathLike):
        return ""
    return f"; without ax there is a figure, whose savefig({shown(fspath(target))}) writes a file"
