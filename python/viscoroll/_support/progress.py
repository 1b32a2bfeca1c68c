"""Progress reports of long computations, to a function of the caller or a bar."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any, TypeAlias

from .errors import InvalidType
from .extras import extra
from .text import shown

__all__ = ["ProgressLike", "Report", "counted", "reporting"]

#: Function called with the current stage, in words, and the completed fraction of it [-].
Report: TypeAlias = Callable[[str, float], object]

#: True for a bar, a function of the caller, False or None for no reports.
ProgressLike: TypeAlias = bool | Report | None


@contextmanager
def reporting(progress: ProgressLike) -> Iterator[Report | None]:
    """Yield the function to which a computation reports, or None; the bar ends with the block.

    Parameters
    ----------
    progress : bool or callable or None
        Argument of the caller.

    Raises
    ------
    TypeError
        If `progress` has another type.
    ImportError
        For True, without the extra `viscoroll[studies]`.
    """
    if progress is None or progress is False:
        yield None
    elif progress is not True:
        if not callable(progress):
            raise InvalidType("progress", "must be True, False, callable or None", shown(progress))
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
    """Yield a function to call after each part of a computation; the bar ends with the block.

    Parameters
    ----------
    progress : bool or callable or None
        Argument of the caller. A function is called as progress("<unit>s", completed fraction).
    total, done : int
        Number of parts, and number of parts that are completed already (default 0).
    unit : str
        Noun for a part.

    Raises
    ------
    TypeError, ImportError
        Same as in `reporting`.
    """
    if progress is True:
        with _bars()(total=total, initial=done, unit=unit) as bar:
            yield lambda: bar.update() and None
        return
    with reporting(progress) as report:
        count = done

        def advance() -> None:
            nonlocal count
            count += 1
            if report is not None:
                report(f"{unit}s", count / total)

        yield advance


@cache
def _bars() -> Any:
    """Return the class of bars for this environment, a notebook or a terminal.

    The result is cached, because the import changes the warning filters, which apply to all threads.
    """
    with extra("studies"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # without ipywidgets, a notebook shows a text bar
        from tqdm.auto import tqdm
    return tqdm
