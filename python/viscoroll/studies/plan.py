"""Points of a study, grouped into tasks that share bodies and influence tables."""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from .._support.errors import InvalidInput
from ..bodies import RollingBody, is_body
from ..coupled import StrainSoftening
from ..coupled.softening_search import softens
from ..materials import Draws
from ..rolling import Result
from ..rolling.propagation import Pair
from ..sliding import RoughSurface
from ..sliding.slide import as_plane
from .dimensions import Dimension, label, require_feasible, split
from .draws import DrawMethod, drawn_parameters
from .factories import Bodies
from .identity import PointKeys, digest
from .kinds import ROLLING, SLIDING, StudyKind

__all__ = ["Addition", "LoadCase", "Plan", "Task", "plan_sweep"]

#: Longest text that the identity of a study contains in full [characters].
_LONGEST_TEXT = 160


class Addition(ABC):
    """Further results of a point of a study, such as temperatures; a dataclass whose text determines them."""

    __slots__ = ()

    @property
    @abstractmethod
    def columns(self) -> dict[str, tuple[str, str]]:
        """Unit and description of each further result, by name."""

    @abstractmethod
    def solve(
        self, solver: Callable[..., Result | StrainSoftening], arguments: Mapping[str, Any], **options: Any
    ) -> tuple[Result | StrainSoftening, dict[str, float]]:
        """Return the result of a point and its further results.

        Parameters
        ----------
        solver : callable
            Function that solves the point.
        arguments : mapping
            Arguments of `viscoroll.solve` for the point.
        **options
            Number of threads and function for the progress.
        """


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadCase:
    """One point: body or rough surface, arguments of its solver, bodies with each draw of materials, additions."""

    body: RollingBody | RoughSurface
    arguments: dict[str, Any]
    draws: tuple[Pair, ...] = ()
    addition: Addition | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """Points for one worker, with the same body and the same influence table."""

    indices: tuple[int, ...]
    body: RollingBody | RoughSurface
    shared: dict[str, Any]
    cases: tuple[dict[str, Any], ...]
    fields: tuple[str, ...]
    draws: tuple[Pair, ...]
    method: DrawMethod
    additions: tuple[Addition | None, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """All points of a study; the last dimension varies fastest.

    Attributes
    ----------
    kind : StudyKind
        Kind of the study.
    dimensions : tuple of Dimension
        Parameters that vary.
    fixed : dict
        Parameters that are the same for all points.
    cases : tuple of LoadCase or str
        For each point, the case to solve, or the message of the exception that its inputs raised.
    fields : tuple of str, default ()
        Names of the fields to store for each point.
    method : "linear" or "solve", default "linear"
        Method for the results of draws, same as in `viscoroll.sweep`.
    confidence : float, default 0.95
        Probability that an interval from draws contains the true value [-].
    keys : tuple of str or None
        For each point, a key that is equal for equal inputs, or None if there is no case to solve.

    Raises
    ------
    ValueError
        If no point can be solved, with the message of the first point; if rollers, whose results are per length, are
        mixed with other bodies, or profiles with maps; and for linear draws of layers that soften.
    """

    kind: StudyKind = ROLLING
    dimensions: tuple[Dimension, ...]
    fixed: dict[str, Any]
    cases: tuple[LoadCase | str, ...]
    fields: tuple[str, ...] = ()
    method: DrawMethod = "linear"
    confidence: float = 0.95
    keys: tuple[str | None, ...] = field(init=False)

    def __post_init__(self) -> None:
        """Reject plans that cannot be solved, and compute the keys."""
        if all(isinstance(case, str) for case in self.cases):
            raise ValueError(f"every point fails, the first with {self.cases[0]}")
        if len({getattr(body, self.kind.line_contact) for body in self.bodies()}) > 1:
            line = "a roller" if self.kind is ROLLING else "a profile"
            rule = f"must be {line} at all points or at none, because results in line contact are per length"
            raise InvalidInput(self.kind.noun, rule, "both")
        solved = [case for case in self.cases if isinstance(case, LoadCase)]
        if self.method == "linear" and any(
            case.draws and not isinstance(case.body, RoughSurface) and softens(case.body, case.arguments.get("on"))
            for case in solved
        ):
            raise InvalidInput("draws", "must be 'solve' if layers soften with strain", "'linear'")
        known = PointKeys()
        keys = [
            known.key(case.body, case.arguments, self.fields, case.draws, self.method, case.addition)
            if isinstance(case, LoadCase)
            else None
            for case in self.cases
        ]
        object.__setattr__(self, "keys", tuple(keys))

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each dimension."""
        return tuple(len(dimension.values) for dimension in self.dimensions)

    def bodies(self) -> list[Any]:
        """Return every rolling body or rough surface once."""
        return list({id(case.body): case.body for case in self.cases if isinstance(case, LoadCase)}.values())

    @property
    def line_contact(self) -> bool:
        """Whether the contacts are lines, with loads and results per length."""
        return bool(getattr(self.bodies()[0], self.kind.line_contact))

    @property
    def added_columns(self) -> dict[str, tuple[str, str]]:
        """Unit and description of the further results of all points, by name."""
        columns: dict[str, tuple[str, str]] = {}
        for case in self.cases:
            if isinstance(case, LoadCase) and case.addition is not None:
                columns |= case.addition.columns
        return columns

    def tasks(self, indices: Sequence[int], *, largest: int) -> list[Task]:
        """Return tasks of at most `largest` points that solve the points of `indices`."""
        groups: dict[Any, list[int]] = {}
        for i in indices:
            case = self.cases[i]
            if isinstance(case, LoadCase):
                key = (id(case.body), *(_hashable(case.arguments.get(name)) for name in self.kind.shared))
                groups.setdefault(key, []).append(i)
        # Each task takes every n-th point, not consecutive ones: points tend to become harder along a dimension.
        parts = {key: -(-len(group) // largest) for key, group in groups.items()}
        return [self._task(group[k :: parts[key]]) for key, group in groups.items() for k in range(parts[key])]

    def _task(self, indices: Sequence[int]) -> Task:
        cases = [case for i in indices if isinstance(case := self.cases[i], LoadCase)]
        first = cases[0]
        return Task(
            indices=tuple(indices),
            body=first.body,
            shared={name: first.arguments[name] for name in self.kind.shared if first.arguments.get(name) is not None},
            cases=tuple(
                {k: v for k, v in case.arguments.items() if k not in self.kind.shared and v is not None}
                for case in cases
            ),
            fields=self.fields,
            draws=first.draws,
            method=self.method,
            additions=tuple(case.addition for case in cases),
        )

    def identity(self) -> dict[str, str]:
        """Return the inputs that determine the dataset, as texts: parameters with their values, and all points."""
        points = [key or case for key, case in zip(self.keys, self.cases, strict=True)]
        return {
            **{dimension.name: _shortened(str(dimension.labels().tolist())) for dimension in self.dimensions},
            **{name: _shortened(text) for name, value in self.fixed.items() if " at 0x" not in (text := label(value))},
            "points": digest(repr(points)),
            "confidence": repr(self.confidence),
        }


def _hashable(argument: object) -> object:
    """Return a hashable object for an argument: the identity of a body, whose layers may hold lists, else the value."""
    return id(argument) if is_body(argument) else argument


def plan_sweep(
    body: RollingBody | RoughSurface | Callable[..., RollingBody | RoughSurface],
    parameters: dict[str, object],
    *,
    kind: StudyKind = ROLLING,
    fields: tuple[str, ...] = (),
    method: DrawMethod = "linear",
    confidence: float = 0.95,
) -> Plan:
    """Return the plan of a study over the product of all one-dimensional `parameters`.

    The parameters are the same as in `viscoroll.sweep`.

    Raises
    ------
    TypeError
        For missing parameters, and parameters that neither the solver nor a function of a body takes.
    ValueError
        For too many points.
    """
    counterbody = Bodies(parameters.get("on"), noun="on", kind=kind.counterbody, study=kind)
    divided = {
        name: value if name == "on" and counterbody.is_made else split(name, value, kind)
        for name, value in parameters.items()
    }
    dimensions = tuple(value for value in divided.values() if isinstance(value, Dimension))
    require_feasible({dimension.name: len(dimension.values) for dimension in dimensions})
    fixed = {name: value for name, value in divided.items() if not isinstance(value, Dimension)}
    source = Bodies(body, noun=kind.noun, kind=kind.source, study=kind)
    pairs = _Pairs(source, counterbody, sorted(parameters.keys() - kind.arguments))
    cases = []
    for point in itertools.product(*(enumerate(dimension.values) for dimension in dimensions)):
        chosen = {dimension.name: item for dimension, item in zip(dimensions, point, strict=True)}
        varied = {name: value for name, (_, value) in chosen.items()}
        numbers = {name: number for name, (number, _) in chosen.items()}
        cases.append(_case(kind, pairs, numbers, fixed | varied))
    return Plan(
        kind=kind,
        dimensions=dimensions,
        fixed=fixed,
        cases=tuple(cases),
        fields=fields,
        method=method,
        confidence=confidence,
    )


class _Pairs:
    """Body and counterbody at each point.

    Raises
    ------
    TypeError
        For parameters that the function of neither body takes.
    """

    def __init__(self, body: Bodies, counterbody: Bodies, names: Sequence[str]) -> None:
        self._body = body
        self._counterbody = counterbody
        self._counterbody_names = counterbody.taken(names)
        self._body_names = [name for name in names if name not in self._counterbody_names or body.taken([name])]
        body.check(self._body_names)
        counterbody.check(self._counterbody_names)

    def __call__(self, numbers: Mapping[str, Hashable], given: Mapping[str, Any]) -> Pair | str:
        """Return body and counterbody, or the message of the exception that one of them raises."""
        body = self._body(numbers, {name: given[name] for name in self._body_names})
        on = given.get("on")
        if self._counterbody.is_made:
            on = self._counterbody(numbers, {name: given[name] for name in self._counterbody_names})
        return next((text for text in (body, on) if isinstance(text, str)), (body, on))


def _case(kind: StudyKind, pairs: _Pairs, numbers: Mapping[str, int], parameters: dict[str, Any]) -> LoadCase | str:
    """Return the case of a point, or the message of the exception that one of its bodies raises."""
    best, drawn = drawn_parameters(parameters)
    uncertain = [name for name, value in parameters.items() if isinstance(value, Draws)]
    solved = pairs(numbers, best)
    draws = []
    for i, given in enumerate(drawn):
        pair = pairs({**numbers, **{name: (numbers.get(name), i) for name in uncertain}}, given)
        if isinstance(pair, str):
            return pair
        draws.append(pair)
    if isinstance(solved, str):
        return solved
    body, on = solved
    arguments = {name: value for name, value in best.items() if name in kind.arguments}
    if on is not None:
        arguments["on"] = as_plane(on) if kind is SLIDING else on
    return LoadCase(body=body, arguments=arguments, draws=tuple(draws))


def _shortened(text: str) -> str:
    if len(text) <= _LONGEST_TEXT:
        return text
    return f"{text[:60]}... {digest(text)}"
