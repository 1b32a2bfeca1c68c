"""Base of all pictures, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from os import PathLike, fspath

from .errors import InvalidType
from .extras import extra
from .text import shown

with extra("plot"):
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Picture", "draw_picture"]


class Picture(Figure):
    """Figure that a notebook displays as the value of a cell.

    The figure is not registered with pyplot, which would display it a second time.
    """

    def _repr_png_(self) -> bytes:
        """Return the picture as PNG, for notebooks in which matplotlib has not registered a formatter."""
        file = BytesIO()
        self.savefig(file, format="png", bbox_inches="tight")
        return file.getvalue()


def draw_picture(
    draw: Callable[[Axes], object],
    ax: Axes | None,
    *,
    figsize: tuple[float, float],
    compose: Callable[[Picture], object] | None = None,
) -> Picture | Axes:
    """Draw into the caller's axes, or into a new picture.

    Parameters
    ----------
    draw : callable
        Called with the axes.
    ax : matplotlib.axes.Axes or None
        Axes of the caller; None for a new picture.
    figsize : (float, float)
        Size of a new picture [inch].
    compose : callable, optional
        Called with a new picture that has more than the axes for `draw`. By default, the picture has only these axes.

    Returns
    -------
    Picture or matplotlib.axes.Axes
        The new picture, which a notebook displays once, or `ax`.

    Raises
    ------
    TypeError
        If `ax` is neither axes nor None.
    """
    if ax is None:
        picture = Picture(figsize=figsize, layout="constrained")
        if compose is None:
            draw(picture.subplots())
        else:
            compose(picture)
        return picture
    if not isinstance(ax, Axes):
        raise InvalidType("ax", "must be a matplotlib.axes.Axes or None", f"{shown(ax)}{_hint_for_a_file(ax)}")
    draw(ax)
    return ax


def _hint_for_a_file(target: object) -> str:
    """Return a hint how to save a figure if a file was given instead of axes, else an empty text."""
    if not isinstance(target, str | PathLike):
        return ""
    return f"; to write a file, omit ax and call savefig({shown(fspath(target))}) on the returned figure"
