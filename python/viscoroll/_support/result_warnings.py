"""Warnings about results, as Python warnings."""

from __future__ import annotations

import sys
import warnings
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

__all__ = ["ResultWarning", "silenced", "warn"]

#: List that collects the messages of `warn` in this context, or None where `warn` warns. Python's warning filters apply
#: to all threads, and studies use many.
_SILENCED: ContextVar[list[str] | None] = ContextVar("silenced", default=None)


class ResultWarning(UserWarning):
    """Warning that a result is less certain than it seems, because of its mesh, its accuracy or its strain.

    `Result.warnings` contains the same texts. ``warnings.simplefilter("ignore", viscoroll.ResultWarning)`` silences
    these warnings; ``"error"`` instead of ``"ignore"`` turns them into exceptions.
    """


def warn(messages: Iterable[str]) -> None:
    """Issue a `ResultWarning` for every message, attributed to the call into this package."""
    if (silenced_messages := _SILENCED.get()) is not None:
        silenced_messages.extend(messages)
        return
    for message in messages:
        warnings.warn(message, ResultWarning, stacklevel=1 + _calls_within())


def _calls_within() -> int:
    """Return the number of calls between the caller of this function and code outside of this package."""
    package = __name__.partition(".")[0]
    frame, calls = sys._getframe(1), 0
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == package:
        frame, calls = frame.f_back, calls + 1
    return calls


@contextmanager
def silenced() -> Iterator[list[str]]:
    """Suppress `warn` in a block, and yield the list that collects its messages."""
    messages: list[str] = []
    token = _SILENCED.set(messages)
    try:
        yield messages
    finally:
        _SILENCED.reset(token)
