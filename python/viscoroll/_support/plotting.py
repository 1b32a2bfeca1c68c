"""Methods `plot`: what type checkers know of them, and what their docstrings have in common."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, cast, overload

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["plots"]

_TOLD = """

Parameters
----------
ax : matplotlib.axes.Axes, optional
    Where to draw {part}.

Returns
-------
matplotlib.figure.Figure or matplotlib.axes.Axes
    A new figure, which shows itself in a notebook and is saved by ``savefig``; or `ax`.

Raises
------
ImportError
    Without the extra `viscoroll[plot]`.
"""


class _Plot(Protocol):
    """A method of an object."""

    @overload
    def __call__(self) -> Figure: ...

    @overload
    def __call__(self, ax: Axes) -> Axes: ...


class _Method(Protocol):
    """A method of a class."""

    def __get__(self, instance: object, owner: type | None = None, /) -> _Plot: ...


def plots(part: str) -> Callable[[Callable[[Any, Axes | None], Figure | Axes]], _Method]:
    """Tell type checkers, and readers of its docstring, that a method draws a new figure, or into axes of the caller's.

    Parameters
    ----------
    part : str
        What it draws into the caller's.
    """

    def told(method: Callable[[Any, Axes | None], Figure | Axes]) -> _Method:
        if method.__doc__:  # python -OO has none
            method.__doc__ = inspect.cleandoc(method.__doc__) + _TOLD.format(part=part)
        return cast(_Method, method)

    return told
