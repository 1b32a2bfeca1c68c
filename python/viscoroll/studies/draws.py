"""Results for draws of a material, and their means and intervals in a study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from .._support.arguments import Floats
from .._support.errors import InvalidInput
from .._support.intervals import interval_half_width
from .._support.result_warnings import silenced
from .._support.text import shown
from ..coupled import strain_softening
from ..coupled.softening_search import softens
from ..materials import Draws
from ..rolling import Result, solve
from ..rolling.frozen import NOT_FROZEN
from ..rolling.propagation import Pair, propagated
from ..solution.scalars import SCALARS

if TYPE_CHECKING:
    from .._support.progress import Report

__all__ = ["DrawMethod", "as_draw_method", "drawn_parameters", "drawn_scalars", "interval_variables"]

#: Method for the results of draws: to first order with a frozen contact, or by complete solves.
DrawMethod: TypeAlias = Literal["linear", "solve"]

#: Suffixes of variables: the mean of the draws, and the ends of the interval around the result.
_BOUNDS = ("mean", "lower", "upper")

#: Scalars that describe the computation, and dimensions of the contact. Linear draws do not change the latter.
_OF_THE_SOLVER = {"energy_balance_error", "error_estimate", "iterations", "operator_applications", "residual"}
_OF_THE_CONTACT = (
    {name for name in SCALARS if name.startswith(("contact_", "semi_axis_"))} | {"face_distance"} | NOT_FROZEN
)

#: Largest relative change of the penetration for linear draws [-]. The penetration varies approximately as the power
#: -0.4 of all moduli. At this limit, the moduli differ by about 60 %, and the neglected terms are half of the
#: first-order term.
_LARGEST_CHANGE = 0.25

#: Number of nodes in contact that the largest pressure must have before and behind it for linear draws. Closer to the
#: edge, linear draws overestimate its variation: intervals were up to five times as wide as those of complete solves.
_NODES_FROM_EDGE = 2


def as_draw_method(method: object) -> DrawMethod:
    """Return the method for the results of draws, or raise a ValueError."""
    if method == "linear" or method == "solve":
        return method
    raise InvalidInput("draws", "must be 'linear' or 'solve'", shown(method))


def drawn_parameters(parameters: Mapping[str, Any]) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Return the parameters with the best estimate of each set of draws, and the parameters with each draw in turn.

    Raises
    ------
    ValueError
        If the sets differ in size: the i-th draws of all parameters belong together.
    """
    sets = {name: value for name, value in parameters.items() if isinstance(value, Draws)}
    if len({len(value) for value in sets.values()}) > 1:
        counts = ", ".join(f"{len(value)} for {name}" for name, value in sets.items())
        raise InvalidInput("draws", "must be equally many for each parameter", counts)
    best = {**parameters, **{name: value.best_estimate for name, value in sets.items()}}
    drawn = zip(*sets.values(), strict=True)
    return best, [{**parameters, **dict(zip(sets, members, strict=True))} for members in drawn]


def drawn_scalars(
    result: Result,
    draws: Sequence[Pair],
    method: DrawMethod,
    case: Mapping[str, Any],
    *,
    threads: int = 1,
    progress: Report | None = None,
) -> dict[str, Floats]:
    """Return scalar results for draws of the materials, by name, each of shape (draws,).

    Parameters
    ----------
    result : Result
        Result for the best estimates.
    draws : sequence of pairs
        Body and counterbody of each draw.
    method : "linear" or "solve"
        "linear": to first order with a frozen contact. "solve": a complete solve of each draw on the mesh of the
        result.
    case : mapping
        The other arguments of `viscoroll.solve` that gave the result.
    threads, progress
        Same as in `viscoroll.solve`.

    Raises
    ------
    ValueError, ConvergenceError
        If a draw is rejected or has no solution: an interval from the remaining draws would be wrong.
    """
    left_out = _OF_THE_SOLVER | {result.prescribed} | (_OF_THE_CONTACT if method == "linear" else set())
    answers = [name for name in SCALARS if name not in left_out and isinstance(getattr(result, name), float)]
    if method == "linear":
        values = propagated(result, draws, answers, threads=threads, progress=progress)
        free = result.unprescribed
        _require_near(free, values[:, answers.index(free)] if free in answers else (), result)
        if not _peaks_inside(result):
            values[:, answers.index("max_pressure")] = np.nan
    else:
        options = {"mesh": result.mesh, "threads": threads, "progress": progress}
        given = {name: value for name, value in case.items() if name not in ("on", "accuracy")} | options
        with silenced():
            values = np.array([_solved_scalars(body, on, given, answers) for body, on in draws])
    return dict(zip(answers, values.T, strict=True))


def _require_near(name: str, values: Floats | tuple[()], result: Result) -> None:
    """Raise a ValueError if a draw is too far from the best estimate for a first-order result."""
    largest = max((abs(value / getattr(result, name) - 1.0) for value in values), default=0.0)
    if largest > _LARGEST_CHANGE:
        raise InvalidInput(
            "draws",
            f"must change the {name} by at most {_LARGEST_CHANGE:.0%} for draws='linear'",
            f"{largest:.0%}; use draws='solve' to solve each draw",
        )


def _peaks_inside(result: Result) -> bool:
    """Return whether the largest pressure is inside the contact, away from its leading and trailing edge."""
    row, column = np.unravel_index(np.argmax(result.pressure), result.pressure.shape)
    around = result.contact[max(row - _NODES_FROM_EDGE, 0) : row + _NODES_FROM_EDGE + 1, column]
    return bool(around.all()) and around.size == 2 * _NODES_FROM_EDGE + 1


def _solved_scalars(body: Any, on: Any, given: dict[str, Any], answers: Sequence[str]) -> list[float]:
    """Return scalars of a complete solve; NaN if a scalar is undetermined."""
    result = strain_softening(body, on=on, **given).result if softens(body, on) else solve(body, on=on, **given)
    return [np.nan if (value := getattr(result, name)) is None else value for name in answers]


def interval_variables(
    table: Sequence[Mapping[str, Floats]], best_estimates: Mapping[str, Floats], confidence: float
) -> dict[str, tuple[str, Floats, str]]:
    """Return mean and interval of each result that has draws, over all points.

    Parameters
    ----------
    table : sequence of mapping
        For each point, the results of its draws by name; empty if it has none.
    best_estimates : mapping of str to ndarray, shape (points,)
        Results for the best estimates.
    confidence : float
        Probability that an interval contains the true value [-].

    Returns
    -------
    dict
        For each variable, which is named like a result with the suffix "_mean", "_lower" or "_upper": the name of the
        result, the values of shape (points,), and their description.
    """
    found = {}
    for name in dict.fromkeys(name for answers in table for name in answers):
        none = np.full(2, np.nan)
        drawn = [answers.get(name, none) for answers in table]
        mean = np.array([values.mean() for values in drawn])
        half = np.array([interval_half_width(values, confidence) for values in drawn])
        count = max(len(answers.get(name, ())) for answers in table)
        for bound, values, description in zip(
            _BOUNDS,
            (mean, best_estimates[name] - half, best_estimates[name] + half),
            (
                f"mean of {count} draws",
                f"lower end of the {confidence:.4g} interval",
                f"upper end of the {confidence:.4g} interval",
            ),
            strict=True,
        ):
            found[f"{name}_{bound}"] = (name, values, description)
    return found
