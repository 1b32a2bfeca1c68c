"""A material that is not known exactly: what was found, and draws of what may be true instead."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar, overload

from .._support.text import shown

__all__ = ["Draws"]

T = TypeVar("T")
S = TypeVar("S")

#: The fewest that tell a scatter.
_FEWEST = 2


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Draws(Sequence[T], Generic[T]):
    """A material, or what one is made from, and equally likely draws of what may be true instead.

    `PronyFit.draws` and `Superposition.draws` return them, and `viscoroll.sweep` takes them in place of a material;
    so it does those of one's own, as specimens of several batches. It is a sequence of the draws.

    Parameters
    ----------
    middle : object
        What was found.
    members : iterable
        The draws, at least two.

    Examples
    --------
    >>> from viscoroll import Draws, Elastic
    >>> batches = Draws(3.0e6, [2.9e6, 3.2e6, 3.0e6])
    >>> batches.map(lambda modulus: Elastic(modulus=modulus))[1]
    Elastic(modulus=3200000.0)
    """

    middle: T
    members: Sequence[T]

    def __init__(self, middle: T, members: Iterable[T]) -> None:
        object.__setattr__(self, "middle", middle)
        object.__setattr__(self, "members", tuple(members))
        if len(self.members) < _FEWEST:
            raise ValueError(f"members must be at least {_FEWEST} draws, got {len(self.members)}")

    @overload
    def __getitem__(self, index: int) -> T: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[T]: ...

    def __getitem__(self, index: int | slice) -> T | Sequence[T]:
        """Return a draw, or several."""
        return self.members[index]

    def __len__(self) -> int:
        """Return the number of draws."""
        return len(self.members)

    def __iter__(self) -> Iterator[T]:
        """Iterate over the draws."""
        return iter(self.members)

    def map(self, function: Callable[[T], S]) -> Draws[S]:
        """Return what a function makes of the middle and of each draw: ``curves.map(lambda c: c.at(temperature=40))``.

        Parameters
        ----------
        function : callable
            Called with each.
        """
        return Draws(function(self.middle), map(function, self.members))

    def __repr__(self) -> str:
        """Return how many, of what."""
        return f"{len(self.members)} draws of {shown(self.middle)}"
