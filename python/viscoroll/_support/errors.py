"""Errors about invalid input, with the parameter, the rule and the value as attributes."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isfinite
from typing import Any

from .text import one_line

__all__ = ["InvalidInput", "InvalidType", "Range", "in_file"]


@dataclass(frozen=True)
class Range:
    """Interval of the allowed values of a number.

    Attributes
    ----------
    minimum, maximum : float
        Ends in `unit`; infinite if there is none.
    unit : str
        SI unit, empty for a pure number.
    excludes_minimum, excludes_maximum : bool
        Whether the end itself is not allowed.
    """

    minimum: float = -inf
    maximum: float = inf
    unit: str = ""
    excludes_minimum: bool = False
    excludes_maximum: bool = False

    def __contains__(self, value: float) -> bool:
        """Return whether the range contains a number; no range contains an infinite number or not-a-number."""
        above = value > self.minimum if self.excludes_minimum else value >= self.minimum
        below = value < self.maximum if self.excludes_maximum else value <= self.maximum
        return isfinite(value) and above and below

    def __str__(self) -> str:
        """Return the text of the range, such as "> 0 m", "<= 4" or "in [0, 1)"."""
        after = f" {self.unit}" if self.unit else ""
        if isfinite(self.minimum) and isfinite(self.maximum):
            ends = f"{self.minimum:.12g}, {self.maximum:.12g}"
            return f"in {'(' if self.excludes_minimum else '['}{ends}{')' if self.excludes_maximum else ']'}{after}"
        if isfinite(self.minimum):
            return f"{'>' if self.excludes_minimum else '>='} {self.minimum:.12g}{after}"
        if isfinite(self.maximum):
            return f"{'<' if self.excludes_maximum else '<='} {self.maximum:.12g}{after}"
        return "finite"

    def error(self, parameter: object, value: object, reason: str = "") -> InvalidInput:
        """Return the error of a value outside of the range; `reason` continues the text of the range."""
        return InvalidInput(parameter, f"must be {self}{reason}", value, allowed=self)


class InvalidInput(ValueError):  # noqa: N818 - the name of the C++ exception
    """A parameter has an invalid value.

    The message is "<parameter> <rule>, got <value>", for example "ball.layers[0].thickness must be > 0 m, got -1".

    Attributes
    ----------
    parameter : str
        Path of the parameter, for example ``ball.layers[0].thickness``.
    rule : str
        Rule that the value violates, with range and unit, for example ``must be > 0 m``.
    value : str
        Given value, or an empty text.
    more : str
        Further errors of the same input, or an empty text.
    source : str
        File that contains the value, or an empty text.
    allowed : Range or None
        Unit and ends of the range that the value leaves, or None if the rule is not a range.
    """

    def __init__(
        self,
        parameter: object,
        rule: str,
        value: object = "",
        *,
        more: str = "",
        source: str = "",
        allowed: Range | None = None,
    ) -> None:
        self.parameter = str(parameter)
        self.rule = rule
        self.value = str(value)
        self.more = more
        self.source = source
        self.allowed = allowed
        got = f", got {self.value}" if self.value else ""
        super().__init__(one_line(f"{source and f'{source}: '}{self.parameter} {rule}{got}{more and f'; {more}'}"))

    def __reduce__(self) -> tuple[Any, ...]:
        """Return what pickle needs: studies send errors between processes."""
        return _restored, (type(self), self.parameter, self.rule, self.value, self.more, self.source, self.allowed)

    def inside(self, table: str) -> InvalidInput:
        """Return the same error for a parameter of a table.

        Parameters
        ----------
        table : str
            Path of the table, for example ``ball.layers[0]``. If the parameter begins with the last name of this path,
            the name is not repeated.
        """
        above, dot, last = table.rpartition(".")
        repeated = self.parameter == last or self.parameter.startswith((f"{last}.", f"{last}["))
        path = f"{above}{dot}{self.parameter}" if repeated else f"{table}.{self.parameter}"
        return type(self)(path, self.rule, self.value, more=self.more, source=self.source, allowed=self.allowed)

    def of_file(self, source: object) -> InvalidInput:
        """Return the same error with the name of the file that contains the value, or that names such a file."""
        path = f"{source}: {self.source}" if self.source else str(source)
        return type(self)(self.parameter, self.rule, self.value, more=self.more, source=path, allowed=self.allowed)

    def with_more(self, more: str) -> InvalidInput:
        """Return the same error with another text after its message."""
        text = "; ".join(filter(None, [self.more, more]))
        return type(self)(self.parameter, self.rule, self.value, more=text, source=self.source, allowed=self.allowed)


class InvalidType(InvalidInput, TypeError):  # noqa: N818 - as above
    """A parameter has a value of a wrong type."""


def in_file(error: Exception, source: object) -> ValueError:
    """Return an error about the content of a file as a ValueError whose message of one line names the file."""
    if isinstance(error, InvalidInput):
        return error.of_file(source)
    return ValueError(one_line(f"{source}: {error}"))


def _restored(
    kind: type[InvalidInput], parameter: str, rule: str, value: str, more: str, source: str, allowed: Range | None
) -> InvalidInput:
    return kind(parameter, rule, value, more=more, source=source, allowed=allowed)
