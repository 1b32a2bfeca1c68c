"""Uncertain materials: a best estimate together with equally likely alternatives."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar, overload

from .._support.errors import InvalidInput
from .._support.text import shown

__all__ = ["Draws"]

T = TypeVar("T")
S = TypeVar("S")

#: Smallest number of draws for which a scatter can be estimated.
_FEWEST = 2


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Draws(Sequence[T], Generic[T]):
    """Best estimate of a material, or of the data that define one, with equally likely alternatives.

    `PronyFit.draws` and `Superposition.draws` return such sets, and `viscoroll.sweep` accepts one in place of a
    material. A set may also be built by hand, for example from samples of several batches. The object is a sequence
    of the draws.

    Parameters
    ----------
    best_estimate : object
        Best estimate.
    members : iterable
        The draws, at least two.

    Examples
    --------
    >>> from viscoroll import Elastic
    >>> from viscoroll.materials import Draws
    >>> batches = Draws(3.0e6, [2.9e6, 3.2e6, 3.0e6])
    >>> batches.map(lambda modulus: Elastic(modulus=modulus))[1]
    Elastic(modulus=3200000.0)
    """

    best_estimate: T
    members: Sequence[T]

    def __init__(self, best_estimate: T, members: Iterable[T]) -> None:
        object.__setattr__(self, "best_estimate", best_estimate)
        object.__setattr__(self, "members", tuple(members))
        if len(self.members) < _FEWEST:
            raise InvalidInput("members", f"must be at least {_FEWEST} draws", len(self.members))

    @overload
    def __getitem__(self, index: int) -> T: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[T]: ...

    def __getitem__(self, index: int | slice) -> T | Sequence[T]:
        """Return one draw, or a slice of the draws."""
        return self.members[index]

    def __len__(self) -> int:
        """Return the number of draws."""
        return len(self.members)

    def __iter__(self) -> Iterator[T]:
        """Iterate over the draws."""
        return iter(self.members)

    def map(self, function: Callable[[T], S]) -> Draws[S]:
        """Return the draws that result from applying a function: ``curves.map(lambda c: c.at(temperature=40))``.

        Parameters
        ----------
        function : callable
            Function of one draw. It is applied to the best estimate and to every draw.

        Returns
        -------
        Draws
            Values of the function for the best estimate and for every draw.
        """
        return Draws(function(self.best_estimate), map(function, self.members))

    def __repr__(self) -> str:
        """Return the number of draws and a short description of the best estimate."""
        return f"{len(self.members)} draws of {shown(self.best_estimate)}"
