"""Evaluation of a function at many points, on threads of this process."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import TypeVar

from .._core import core_count
from .._support.progress import ProgressLike, counted

__all__ = ["run_all"]

S = TypeVar("S")
T = TypeVar("T")


def run_all(
    function: Callable[[S], T], points: Iterable[S], *, workers: int | None = None, progress: ProgressLike = None
) -> list[T]:
    """Call a function with every point, on threads, and return the values in the order of the points.

    Parameters
    ----------
    function : callable
        Function of one point; usually one solve on one thread.
    points : iterable
        Arguments of the calls.
    workers : int, optional
        Number of threads; by default one for each core.
    progress : bool or callable, optional
        True shows a bar. A function is called as progress(stage, fraction) after every point.

    Returns
    -------
    list
        Values of the function, in the order of the points.
    """
    points = list(points)
    executor = ThreadPoolExecutor(workers or core_count())
    try:
        futures = [executor.submit(function, point) for point in points]
        with counted(progress, total=len(points), unit="solve") as advance:
            for _ in as_completed(futures):
                advance()
        return [future.result() for future in futures]
    finally:
        executor.shutdown(cancel_futures=True)
