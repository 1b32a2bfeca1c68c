"""What a user should know before relying on a result, as Python's own warnings."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

__all__ = ["ResultWarning", "warn"]


class ResultWarning(UserWarning):
    """A result that is less certain than a user might think: its mesh, its accuracy, or its strain.

    The same texts stand in `Result.warnings`; ``warnings.simplefilter("ignore", viscoroll.ResultWarning)`` silences
    them, ``"error"`` in place of ``"ignore"`` makes them exceptions.
    """


def warn(messages: Iterable[str], *, stacklevel: int) -> None:
    """Warn of every message, as seen from the function `stacklevel` calls above the caller of this one."""
    for message in messages:
        warnings.warn(message, ResultWarning, stacklevel=stacklevel + 2)
