"""Errors about invalid input, with the parameter, the rule and the value as attributes."""

from __future__ import annotations

from typing import Any

from .text import one_line

__all__ = ["InvalidInput", "InvalidType", "in_file"]


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
    """

    def __init__(self, parameter: object, rule: str, value: object = "", *, more: str = "", source: str = "") -> None:
        self.parameter = str(parameter)
        self.rule = rule
        self.value = str(value)
        self.more = more
        self.source = source
        got = f", got {self.value}" if self.value else ""
        super().__init__(one_line(f"{source and f'{source}: '}{self.parameter} {rule}{got}{more and f'; {more}'}"))

    def __reduce__(self) -> tuple[Any, ...]:
        """Return what pickle needs: studies send errors between processes."""
        return _restored, (type(self), self.parameter, self.rule, self.value, self.more, self.source)

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
        return type(self)(path, self.rule, self.value, more=self.more, source=self.source)

    def of_file(self, source: object) -> InvalidInput:
        """Return the same error with the name of the file that contains the value, or that names such a file."""
        path = f"{source}: {self.source}" if self.source else str(source)
        return type(self)(self.parameter, self.rule, self.value, more=self.more, source=path)

    def with_more(self, more: str) -> InvalidInput:
        """Return the same error with another text after its message."""
        text = "; ".join(filter(None, [self.more, more]))
        return type(self)(self.parameter, self.rule, self.value, more=text, source=self.source)


class InvalidType(InvalidInput, TypeError):  # noqa: N818 - as above
    """A parameter has a value of a wrong type."""


def in_file(error: Exception, source: object) -> ValueError:
    """Return an error about the content of a file as a ValueError whose message of one line names the file."""
    if isinstance(error, InvalidInput):
        return error.of_file(source)
    return ValueError(one_line(f"{source}: {error}"))


def _restored(kind: type[InvalidInput], *arguments: str) -> InvalidInput:
    parameter, rule, value, more, source = arguments
    return kind(parameter, rule, value, more=more, source=source)
