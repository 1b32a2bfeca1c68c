"""How a caller sees how far a long computation is: by a function of its own, or by a bar."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any, TypeAlias

from .extras import extra
from .text import shown

__all__ = ["ProgressLike", "Report", "counted", "reporting"]

#: Called with what is being done, in words, and the share of it that is done.
Report: TypeAlias = Callable[[str, float], object]

#: True for a bar, a function for one's own, False or None for nothing.
ProgressLike: TypeAlias = bool | Report | None


@contextmanager
def reporting(progress: ProgressLike) -> Iterator[Report | None]:
    """Hand out what a computation reports to, and end the bar with the block.

    Parameters
    ----------
    progress : bool or callable or None
        As the caller gave it.

    Raises
    ------
    TypeError
        Where it is something else.
    ImportError
        For True, without the extra `viscoroll[studies]`.
    """
    if progress is None or progress is False:
        yield None
    elif progress is not True:
        if not callable(progress):
            raise TypeError(f"progress must be True, False, callable or None, got {shown(progress)}")
        yield progress
    else:
        layout = "{desc} {percentage:3.0f}%|{bar}| {elapsed}"
        with _bars()(total=1.0, leave=False, miniters=0, bar_format=layout) as bar:

            def report(stage: str, fraction: float) -> None:
                if bar.desc != stage:
                    bar.set_description_str(stage, refresh=False)
                bar.update(fraction - bar.n)

            yield report


@contextmanager
def counted(progress: ProgressLike, *, total: int, unit: str, done: int = 0) -> Iterator[Callable[[], None]]:
    """Hand out what is to be called after each of so many parts, and end the bar with the block.

    Parameters
    ----------
    progress : bool or callable or None
        As the caller gave it; a function is called as progress("<unit>s", share of them that is done).
    total, done : int
        Number of parts, and of those done before.
    unit : str
        What a part is.

    Raises
    ------
    TypeError, ImportError
        As of `reporting`.
    """
    if progress is True:
        with _bars()(total=total, initial=done, unit=unit) as bar:
            yield lambda: bar.update() and None
        return
    with reporting(progress) as report:
        count = done

        def one_more() -> None:
            nonlocal count
            count += 1
            if report is not None:
                report(f"{unit}s", count / total)

        yield one_more


@cache
def _bars() -> Any:
    """Return the kind of bar for where this runs, of a notebook or of a terminal.

    Found once: filters of warnings belong to all threads.
    """
    with extra("studies"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # without ipywidgets a notebook shows the bar of a terminal, which will do
        from tqdm.auto import tqdm
    return tqdm
