"""The bodies of a study: one for all points, or what a function makes of each point's parameters."""

from __future__ import annotations

import inspect
from collections.abc import Hashable, Mapping, Sequence
from concurrent.futures import CancelledError
from dataclasses import dataclass, field
from typing import Any

from .._support.arguments import kind_names
from .._support.keywords import meant
from .._support.text import shown
from .dimensions import LOAD_CASE

__all__ = ["NOT_OF_A_POINT", "Bodies"]

#: Exceptions that say nothing of the point at which they are raised.
NOT_OF_A_POINT = (MemoryError, ImportError, CancelledError)


@dataclass(frozen=True, slots=True)
class Bodies:
    """What rolls, or what it rolls on, at each point: made once for all points that share its parameters."""

    source: Any  # a body, or what should return one
    noun: str
    kind: Any
    made: dict[tuple[Hashable, ...], Any] = field(default_factory=dict)

    @property
    def is_made(self) -> bool:
        """Whether a function makes it."""
        return callable(self.source) and not isinstance(self.source, self.kind)

    def taken(self, names: Sequence[str]) -> list[str]:
        """Return which parameters a function takes."""
        if not self.is_made:
            return []
        parameters = inspect.signature(self.source).parameters
        takes_all = any(parameter.kind is parameter.VAR_KEYWORD for parameter in parameters.values())
        return [name for name in names if takes_all or name in parameters]

    def check(self, names: Sequence[str]) -> None:
        """Refuse parameters that nothing takes, and a function that needs more."""
        if isinstance(self.source, self.kind):
            if names:
                guesses = [guess for name in names if (guess := meant(name, LOAD_CASE))]
                raise TypeError(
                    f"a ball has no parameter {', '.join(names)}; pass a function of {', '.join(names)} that returns "
                    f"the ball, or as on= what it rolls on{f'; or did you mean {guesses[0]}?' if guesses else ''}"
                )
            return
        if not self.is_made:
            if self.noun == "on":  # one, several or none, which `split` has checked
                return
            wanted = f"a {kind_names(self.kind)}, or a function that returns one"
            raise TypeError(f"{self.noun} must be {wanted}, got {shown(self.source)}")
        try:
            inspect.signature(self.source).bind(**dict.fromkeys(names))
        except TypeError as error:
            raise TypeError(f"{self.noun}, called with {', '.join(names) or 'no parameter'}: {error}") from None

    def __call__(self, numbers: Mapping[str, Hashable], parameters: dict[str, Any]) -> Any:
        """Return the body, or the message of the exception that its parameters raise.

        Those that vary have the numbers of their values, and of their draws.
        """
        if isinstance(self.source, self.kind):
            return self.source
        key = tuple(numbers[name] for name in parameters if name in numbers)
        if key not in self.made:
            try:
                body = self.source(**parameters)
            except NOT_OF_A_POINT:
                raise
            except Exception as error:
                self.made[key] = f"{type(error).__name__}: {error}"
            else:
                if not isinstance(body, self.kind):
                    raise TypeError(f"{self.noun} must return a {kind_names(self.kind)}, got {shown(body)}")
                self.made[key] = body
        return self.made[key]
