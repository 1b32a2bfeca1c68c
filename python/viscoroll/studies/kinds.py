"""Kinds of studies: of rolling bodies, and of rough surfaces that slide."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from ..bodies import CoatedPlane, Counterbody, HalfSpace, RollingBody
from ..rolling import solve
from ..sliding import RoughSurface, slide
from ..sliding.scalars import SLIDING_RESULTS
from ..solution.scalars import SCALARS, scalar_units

__all__ = ["ROLLING", "SLIDING", "StudyKind"]

#: Unit and description of the numbers that a rolling body has in addition to `SCALARS`, by name.
_COUNTS = {
    "contact_nodes": ("1", "nodes in contact"),
    "nodes_per_revolution": ("1", "nodes per revolution along phi"),
    "theta_nodes_per_revolution": ("1", "nodes per revolution along theta"),
    "max_order": ("1", "truncation order N_t; NaN if all orders are summed"),
}


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class StudyKind:
    """Properties of the studies of one function.

    Attributes
    ----------
    solve : callable
        Function that solves a point.
    noun : str
        Name of its first argument.
    described : str
        Noun for the first argument in messages.
    source : type or union of types
        Types of the first argument.
    counterbody : type or union of types
        Types of the argument `on`.
    line_contact : str
        Name of the attribute of the first argument that is True in line contact.
    shared : tuple of str
        Arguments that determine an influence table that points can share, in addition to the first one.
    results : mapping
        Unit and description of each scalar result, by name.
    units : callable
        Returns the unit of every scalar of the solver; called as units(line_contact=...).
    arguments : frozenset of str
        Arguments that a study may fix or vary. All other parameters are passed to functions of the bodies.
    defaults : dict
        Defaults of these arguments.
    """

    solve: Callable[..., Any]
    noun: str
    described: str
    source: Any
    counterbody: Any
    line_contact: str
    shared: tuple[str, ...]
    results: Mapping[str, tuple[str, str]]
    units: Callable[..., dict[str, str]]
    arguments: frozenset[str] = field(init=False)
    defaults: dict[str, Any] = field(init=False)

    def __post_init__(self) -> None:
        """Read the arguments from the signature."""
        parameters = inspect.signature(self.solve).parameters
        arguments = frozenset(parameters) - {self.noun, "threads", "progress"}
        defaults = {name: parameters[name].default for name in parameters if name in arguments}
        object.__setattr__(self, "arguments", arguments)
        object.__setattr__(
            self, "defaults", {name: value for name, value in defaults.items() if value is not inspect.Parameter.empty}
        )

    @property
    def optional(self) -> frozenset[str]:
        """Arguments that are left out if they are None."""
        return frozenset(name for name, value in self.defaults.items() if value is None)


#: Studies of `viscoroll.solve`.
ROLLING = StudyKind(
    solve=solve,
    noun="body",
    described="rolling body",
    source=RollingBody,
    counterbody=Counterbody,
    line_contact="line_contact",
    shared=("on", "angular_speed", "speed", "mesh", "compliance", "curvature", "patch_load"),
    results=SCALARS | _COUNTS,
    units=scalar_units,
)

#: Studies of `viscoroll.slide`.
SLIDING = StudyKind(
    solve=slide,
    noun="surface",
    described="rough surface",
    source=RoughSurface,
    counterbody=CoatedPlane | HalfSpace,
    line_contact="is_profile",
    shared=(),
    results=SLIDING_RESULTS,
    units=lambda *, line_contact: {name: unit for name, (unit, _) in SLIDING_RESULTS.items()},  # noqa: ARG005
)
