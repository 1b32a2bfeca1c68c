"""Steady cases with one number far too small or too large, which must be solved or rejected, without hangs or NaN.

The solution is not compared with other solutions, because the number often has no effect or dominates the solution.
"""

from __future__ import annotations

import math
import re
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np
import viscoroll as vr

from .cases import Case
from .cases import draw as draw_case
from .command import main
from .runner import Outcome

__all__ = ["Extreme", "draw", "run_case"]

#: Range of the change in decades, up or down: a third of the changes exceed the range of the library.
_DECADES = 60.0

Path = tuple[str | int, ...]


@dataclass(frozen=True, kw_only=True)
class Extreme:
    """A case and the number in it that is changed.

    Attributes
    ----------
    base : Case
        The case before the change.
    path : tuple of str or int
        Names and indices that lead to the number, the first of them "body" or the name of an argument.
    factor : float
        Factor by which the number is multiplied.
    """

    base: Case
    path: Path
    factor: float

    @property
    def name(self) -> str:
        """Return "SEED:NUMBER"."""
        return self.base.name

    def source(self) -> str:
        """Return the call before the change, and the change."""
        where = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in self.path)
        return f"{self.base.source()}  # {where[1:]} times {self.factor:.3g}"

    def arguments(self) -> dict[str, Any]:
        """Return the arguments of `solve`, including the body, with the changed number.

        Raises
        ------
        ValueError
            If a body or a material rejects the number.
        """
        return _changed({"body": self.base.body, **self.base.arguments}, self.path, self.factor)


def draw(seed: int, number: int) -> Extreme:
    """Return a random case."""
    base = draw_case(seed, number)
    rng = np.random.default_rng([seed, number, 7])
    given = {"body": base.body, **base.arguments}
    paths = list(_numbers(given))
    path = paths[rng.integers(len(paths))]
    return Extreme(base=base, path=path, factor=float(10.0 ** rng.uniform(-_DECADES, _DECADES)))


def _numbers(value: Any, path: Path = ()) -> Iterator[Path]:
    """Yield the paths to all nonzero finite floating-point numbers in a value."""
    if isinstance(value, float):
        if value != 0.0 and math.isfinite(value):
            yield path
    elif isinstance(value, dict):
        for key in value:
            yield from _numbers(value[key], (*path, key))
    elif isinstance(value, tuple | list):
        for index, item in enumerate(value):
            yield from _numbers(item, (*path, index))
    elif is_dataclass(value):
        for each in fields(value):
            if each.init:
                yield from _numbers(getattr(value, each.name), (*path, each.name))


def _changed(value: Any, path: Path, factor: float) -> Any:
    if not path:
        return value * factor
    first, rest = path[0], path[1:]
    if isinstance(value, dict):
        return {**value, first: _changed(value[first], rest, factor)}
    if isinstance(first, int):
        return [_changed(item, rest, factor) if index == first else item for index, item in enumerate(value)]
    return replace(value, **{first: _changed(getattr(value, first), rest, factor)})


def run_case(case: Extreme, before_each: Callable[[Outcome], object] = lambda _: None) -> Outcome:
    """Solve a case; a solution must be finite, and the message of a rejection must name a parameter."""
    outcome = Outcome(case=case.name, has_friction=case.base.has_friction, source=case.source())
    before_each(outcome)
    start = time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            arguments = case.arguments()
            result = vr.solve(arguments.pop("body"), **arguments)
    except vr.ConvergenceError as error:
        outcome.kind, outcome.message = "no convergence", str(error)
    except (ValueError, MemoryError) as error:
        outcome.message = str(error)
        is_proper = re.match(r"[a-z_]+[\w.\[\]]*( (and|or|at) [^ ]+( rad/s)?)* must ", outcome.message)
        outcome.kind = "rejected" if is_proper else "improper message"
    except Exception as error:
        outcome.kind, outcome.message = "error", repr(error)
    else:
        outcome.nodes = int(result.contact.sum())
        for name, number in result.scalars().items():
            if isinstance(number, float) and math.isnan(number):
                outcome.violations[f"{name} is NaN"] = math.inf
    outcome.seconds = time.process_time() - start
    return outcome


if __name__ == "__main__":
    sys.exit(main("python -m tests.campaign.extremes", __doc__, "build/campaign-extremes.jsonl", draw, run_case))
