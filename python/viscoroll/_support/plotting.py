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


class _Plot(Protocol):
    """Type of the method `plot` of an object."""

    @overload
    def __call__(self) -> Figure: ...

    @overload
    def __call__(self, ax: Axes) -> Axes: ...


class _Method(Protocol):
    """Type of the method `plot` of a class."""

    def __get__(self, instance: object, owner: type | None = None, /) -> _Plot: ...


def plots(part: str) -> Callable[[Callable[[Any, Axes | None], Figure | Axes]], _Method]:
    """Return a decorator for a method that draws a new figure or into given axes: it adds type and docstring sections.

    Parameters
    ----------
    part : str
        Noun phrase for the content that the method draws into given axes.
    """

    def with_sections(method: Callable[[Any, Axes | None], Figure | Axes]) -> _Method:
        if method.__doc__:  # None with python -OO
            method.__doc__ = inspect.cleandoc(method.__doc__) + _SECTIONS.format(part=part)
        return cast(_Method, method)

    return with_sections
