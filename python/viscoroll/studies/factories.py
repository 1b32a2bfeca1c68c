"""Bodies of a study: one for all points, or made by a function from the parameters of each point."""

from __future__ import annotations

import inspect
from collections.abc import Hashable, Mapping, Sequence
from concurrent.futures import CancelledError
from dataclasses import dataclass, field
from typing import Any

from .._support.arguments import kind_names
from .._support.errors import InvalidType
from .._support.suggestions import suggestion
from .._support.text import shown
from .kinds import StudyKind

__all__ = ["STUDY_ERRORS", "Bodies"]

#: Exceptions that end the whole study, because they do not depend on the point at which they are raised.
STUDY_ERRORS = (MemoryError, ImportError, CancelledError)


@dataclass(frozen=True, slots=True)
class Bodies:
    """Body or counterbody at each point, made once for all points with the same parameters."""

    source: Any  # a body, or a function that returns one
    noun: str  # name of the argument in messages
    kind: Any  # type of the bodies
    study: StudyKind
    made: dict[tuple[Hashable, ...], Any] = field(default_factory=dict)  # by the indices of the parameters' values

    @property
    def is_made(self) -> bool:
        """Whether a function makes the body."""
        return callable(self.source) and not isinstance(self.source, self.kind)

    def taken(self, names: Sequence[str]) -> list[str]:
        """Return the names of the parameters that the function takes; none if there is no function."""
        if not self.is_made:
            return []
        parameters = inspect.signature(self.source).parameters
        takes_all = any(parameter.kind is parameter.VAR_KEYWORD for parameter in parameters.values())
        return [name for name in names if takes_all or name in parameters]

    def check(self, names: Sequence[str]) -> None:
        """Reject parameters that the source does not take, and a function that needs other parameters."""
        if isinstance(self.source, self.kind):
            if names:
                guesses = [guess for name in names if (guess := suggestion(name, self.study.arguments))]
                raise TypeError(
                    f"a {self.study.described} has no parameter {', '.join(names)}; pass a function of "
                    f"{', '.join(names)} that returns the {self.study.described}, or as on= the counterbody"
                    f"{f'; or did you mean {guesses[0]}?' if guesses else ''}"
                )
            return
        if not self.is_made:
            if self.noun == "on":  # `split` has checked the counterbodies or None
                return
            wanted = f"a {kind_names(self.kind)}, or a function that returns one"
            raise InvalidType(self.noun, f"must be {wanted}", shown(self.source))
        try:
            inspect.signature(self.source).bind(**dict.fromkeys(names))
        except TypeError as error:
            raise TypeError(f"{self.noun}, called with {', '.join(names) or 'no parameter'}: {error}") from None

    def __call__(self, numbers: Mapping[str, Hashable], parameters: dict[str, Any]) -> Any:
        """Return the body, or the message of the exception that its parameters raise.

        Parameters
        ----------
        numbers : mapping of str to hashable
            For each parameter that varies, the index of its value, or the indices of value and draw if it has draws.
        parameters : dict
            Arguments of the function.
        """
        if isinstance(self.source, self.kind):
            return self.source
        key = tuple(numbers[name] for name in parameters if name in numbers)
        if key not in self.made:
            try:
                body = self.source(**parameters)
            except STUDY_ERRORS:
                raise
            except Exception as error:
                self.made[key] = f"{type(error).__name__}: {error}"
            else:
                if not isinstance(body, self.kind):
                    raise InvalidType(self.noun, f"must return a {kind_names(self.kind)}", shown(body))
                self.made[key] = body
        return self.made[key]
