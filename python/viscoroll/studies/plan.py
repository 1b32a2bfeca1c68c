"""The points of a study, and how they are grouped into tasks that share what they can."""

from __future__ import annotations

import inspect
import itertools
from collections.abc import Callable, Sequence
from concurrent.futures import CancelledError
from dataclasses import dataclass, field
from typing import Any

from .._support.arguments import kind_names
from .._support.keywords import meant
from .._support.text import shown
from ..bodies import Counterpart, RollingBody
from .dimensions import LOAD_CASE, Dimension, label, split
from .identity import PointKeys, digest

__all__ = ["NOT_OF_A_POINT", "LoadCase", "Plan", "Task", "plan_sweep"]

#: What points with one influence table have in common, besides the ball.
_SHARED = ("on", "angular_speed", "mesh", "compliance", "curvature", "patch_load")

#: Exceptions that say nothing of the point at which they are raised.
NOT_OF_A_POINT = (MemoryError, ImportError, CancelledError)

#: Longest text that the identity of a study holds in full.
_LONGEST_TEXT = 160


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadCase:
    """One point: a ball, and arguments of `viscoroll.solve`."""

    ball: RollingBody
    arguments: dict[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """Points that share a ball and all that decides the influence table, for one worker."""

    indices: tuple[int, ...]
    ball: RollingBody
    shared: dict[str, Any]
    cases: tuple[dict[str, Any], ...]
    fields: tuple[str, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """All points of a study, the last dimension fastest.

    Attributes
    ----------
    dimensions : tuple of Dimension
        What varies.
    fixed : dict
        Parameters that do not.
    cases : tuple of LoadCase or str
        For each point what to solve, or why there is nothing to solve.
    fields : tuple of str
        Fields that are kept for each point.
    keys : tuple of str or None
        For each point what is the same where all its inputs are, or None where there is nothing to solve.

    Raises
    ------
    ValueError
        Where no point can be solved, with the reason of the first, and where rollers, whose results are per length,
        are mixed with others.
    """

    dimensions: tuple[Dimension, ...]
    fixed: dict[str, Any]
    cases: tuple[LoadCase | str, ...]
    fields: tuple[str, ...] = ()
    keys: tuple[str | None, ...] = field(init=False)

    def __post_init__(self) -> None:
        """Refuse plans without anything to solve, and find the keys."""
        if all(isinstance(case, str) for case in self.cases):
            raise ValueError(f"every point fails, the first with {self.cases[0]}")
        if len({ball.line_contact for ball in self.balls()}) > 1:
            raise ValueError("ball must be a roller at all points or at none, for its results are per length, got both")
        known = PointKeys()
        keys = [
            known.key(case.ball, case.arguments, self.fields) if isinstance(case, LoadCase) else None
            for case in self.cases
        ]
        object.__setattr__(self, "keys", tuple(keys))

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each dimension."""
        return tuple(len(dimension.values) for dimension in self.dimensions)

    def balls(self) -> list[RollingBody]:
        """Return every ball once."""
        return list({id(case.ball): case.ball for case in self.cases if isinstance(case, LoadCase)}.values())

    @property
    def line_contact(self) -> bool:
        """Whether rollers roll, whose loads and results are per length."""
        return self.balls()[0].line_contact

    def tasks(self, indices: Sequence[int], *, largest: int) -> list[Task]:
        """Return tasks of at most `largest` points that solve the points of `indices`."""
        groups: dict[Any, list[int]] = {}
        for i in indices:
            case = self.cases[i]
            if isinstance(case, LoadCase):
                key = (id(case.ball), *(_mark(case.arguments.get(name)) for name in _SHARED))
                groups.setdefault(key, []).append(i)
        # Every so many points to a task, and not a run of them: they tend to become harder along a dimension.
        parts = {key: -(-len(group) // largest) for key, group in groups.items()}
        return [self._task(group[k :: parts[key]]) for key, group in groups.items() for k in range(parts[key])]

    def _task(self, indices: Sequence[int]) -> Task:
        cases = [case for i in indices if isinstance(case := self.cases[i], LoadCase)]
        first = cases[0]
        return Task(
            indices=tuple(indices),
            ball=first.ball,
            shared={name: first.arguments[name] for name in _SHARED if first.arguments.get(name) is not None},
            cases=tuple(
                {k: v for k, v in case.arguments.items() if k not in _SHARED and v is not None} for case in cases
            ),
            fields=self.fields,
        )

    def identity(self) -> dict[str, str]:
        """Return what decides the dataset, as text: names, values, and all points."""
        points = [key or case for key, case in zip(self.keys, self.cases, strict=True)]
        return {
            **{dimension.name: _shortened(str(dimension.labels().tolist())) for dimension in self.dimensions},
            **{name: _shortened(text) for name, value in self.fixed.items() if " at 0x" not in (text := label(value))},
            "points": digest(repr(points)),
        }


def _mark(argument: object) -> object:
    """Return what tells arguments apart: bodies by what they are, for their layers may hold lists."""
    return id(argument) if isinstance(argument, Counterpart) else argument


def plan_sweep(
    ball: RollingBody | Callable[..., RollingBody], parameters: dict[str, object], *, fields: tuple[str, ...]
) -> Plan:
    """Plan a study of the product of all one-dimensional `parameters`.

    Raises
    ------
    TypeError
        For parameters that neither `viscoroll.solve` nor the factory has, and for missing ones.
    """
    divided = {name: split(name, value) for name, value in parameters.items()}
    dimensions = tuple(value for value in divided.values() if isinstance(value, Dimension))
    fixed = {name: value for name, value in divided.items() if not isinstance(value, Dimension)}
    build = _Balls(ball)
    build.check(sorted(parameters.keys() - LOAD_CASE))
    cases = []
    for point in itertools.product(*(enumerate(dimension.values) for dimension in dimensions)):
        chosen = {dimension.name: item for dimension, item in zip(dimensions, point, strict=True)}
        varied = {name: value for name, (_, value) in chosen.items()}
        key = tuple(i for name, (i, _) in chosen.items() if name not in LOAD_CASE)
        made = build(key, {k: v for k, v in (fixed | varied).items() if k not in LOAD_CASE})
        arguments = {k: v for k, v in (fixed | varied).items() if k in LOAD_CASE}
        cases.append(made if isinstance(made, str) else LoadCase(ball=made, arguments=arguments))
    return Plan(dimensions=dimensions, fixed=fixed, cases=tuple(cases), fields=fields)


@dataclass(frozen=True, slots=True)
class _Balls:
    """The ball of each point, made once for all points that share its parameters."""

    source: Any  # a ball, or what should return one
    made: dict[tuple[int, ...], RollingBody | str] = field(default_factory=dict)

    def check(self, names: Sequence[str]) -> None:
        if isinstance(self.source, RollingBody):
            if names:
                guesses = [guess for name in names if (guess := meant(name, LOAD_CASE))]
                raise TypeError(
                    f"a ball has no parameter {', '.join(names)}; pass a function of {', '.join(names)} that returns "
                    f"the ball{f'; or did you mean {guesses[0]}?' if guesses else ''}"
                )
            return
        if not callable(self.source):
            wanted = f"a {kind_names(RollingBody)}, or a function that returns one"
            raise TypeError(f"ball must be {wanted}, got {shown(self.source)}")
        try:
            inspect.signature(self.source).bind(**dict.fromkeys(names))
        except TypeError as error:
            raise TypeError(f"ball, called with {', '.join(names) or 'no parameter'}: {error}") from None

    def __call__(self, key: tuple[int, ...], parameters: dict[str, Any]) -> RollingBody | str:
        """Return the ball, or the message of the exception that its parameters raise."""
        if isinstance(self.source, RollingBody):
            return self.source
        if key not in self.made:
            try:
                ball = self.source(**parameters)
            except NOT_OF_A_POINT:
                raise
            except Exception as error:
                self.made[key] = f"{type(error).__name__}: {error}"
            else:
                if not isinstance(ball, RollingBody):
                    raise TypeError(f"ball must return a {kind_names(RollingBody)}, got {shown(ball)}")
                self.made[key] = ball
        return self.made[key]


def _shortened(text: str) -> str:
    if len(text) <= _LONGEST_TEXT:
        return text
    return f"{text[:60]}... {digest(text)}"
