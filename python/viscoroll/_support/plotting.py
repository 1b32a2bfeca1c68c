"""Common type and common docstring sections of the methods `plot`."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol, cast, overload

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["plots"]

#: Sections that are appended to the docstrings.
_SECTIONS = """

Parameters
----------
ax : matplotlib.axes.Axes, optional
    Axes on which to draw {part}.

Returns
-------
matplotlib.figure.Figure or matplotlib.axes.Axes
    A new figure, which a notebook displays and ``savefig`` saves; or `ax`.

Raises
------
ImportError
    If the extra `viscoroll[plot]` is not installed.
"""


class _BoundPlot(Protocol):
    """Type of `obj.plot`."""

    @overload
    def __call__(self) -> Figure: ...

    @overload
    def __call__(self, ax: Axes) -> Axes: ...


class _PlotDescriptor(Protocol):
    """Type of `Class.plot`, whose `__get__` gives the bound method."""

    def __get__(self, instance: object, owner: type | None = None, /) -> _BoundPlot: ...


def plots(part: str) -> Callable[[Callable[[Any, Axes | None], Figure | Axes]], _PlotDescriptor]:
    """Return a decorator for a method `plot`, which draws into given axes or into a new figure.

    The decorator gives the method its overloaded type, and appends sections to its docstring.

    Parameters
    ----------
    part : str
        Noun phrase for the content that the method draws into given axes.
    """

    def with_sections(method: Callable[[Any, Axes | None], Figure | Axes]) -> _PlotDescriptor:
        if method.__doc__:  # None with python -OO
            method.__doc__ = inspect.cleandoc(method.__doc__) + _SECTIONS.format(part=part)
        return cast(_PlotDescriptor, method)

    return with_sections
