"""What a user should know before relying on a result, as Python's own warnings."""

from __future__ import annotations

import sys
import warnings
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

__all__ = ["ResultWarning", "kept_in_results", "warn"]

#: Python's own filters belong to all threads at once; studies solve on many.
_SILENT: ContextVar[bool] = ContextVar("silent", default=False)


class ResultWarning(UserWarning):
    """A result that is less certain than a user might think: its mesh, its accuracy, or its strain.

    The same texts stand in `Result.warnings`; ``warnings.simplefilter("ignore", viscoroll.ResultWarning)`` silences
    them, ``"error"`` in place of ``"ignore"`` makes them exceptions.
    """


def warn(messages: Iterable[str]) -> None:
    """Warn of every message, as seen from the call into this package."""
    if _SILENT.get():
        return
    for message in messages:
        warnings.warn(message, ResultWarning, stacklevel=1 + _calls_within())


def _calls_within() -> int:
    """Return how many calls the caller of this function is away from code outside of this package."""
    package = __name__.partition(".")[0]
    frame, calls = sys._getframe(1), 0
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, calls = frame.f_back, calls + 1
    return calls


@contextmanager
def kept_in_results() -> Iterator[None]:
    """Leave what there is to warn of to the results, for those who count it over many of them."""
    token = _SILENT.set(True)
    try:
        yield
    finally:
        _SILENT.reset(token)
