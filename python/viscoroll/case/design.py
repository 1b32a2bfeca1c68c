"""Choice of one number of a case under limits on results: for the least power loss, or as large as possible."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

import numpy as np

from .._core import ConvergenceError
from .._support.arguments import as_kelvin
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.plotting import plots
from .._support.progress import ProgressLike, Report, reporting
from .._support.result_warnings import silenced
from .._support.scales import Scale
from .._support.toml import read_toml
from ..rolling import Result
from .case import CaseFile, build_case, with_values
from .key_paths import key_path_of
from .limits import LIMITS, Outcome, limit_units, outcome_of
from .tables import StrictTable, checked, errors_in
from .unit_texts import Key, has_quantities

with extra("cli"):
    from pydantic import Field

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Design", "check_design", "design_case", "limits_of"]

#: What the number is chosen for.
Goal: TypeAlias = Literal["least_power", "largest_value"]

#: Number of values of the first, geometric search.
_POINTS = 15


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Design:
    """Number of a case that is best under limits on results.

    Attributes
    ----------
    variable : str
        Path of the number in the case file, such as "ball.layers[0].thickness".
    goal : {"least_power", "largest_value"}
        What the number was chosen for.
    unit : str
        SI unit of the number; "1" if it has none or if it is unknown.
    best : float
        Best value of the number, in SI units.
    outcome : Outcome
        Results at the best value.
    limits : mapping of str to float
        Largest allowed values, by the names of scalar results and of quantities inside the layers [SI units].
    values : tuple of float
        All values that were tried, in increasing order.
    outcomes : tuple of Outcome or None
        Results at each of `values`; None if the case was rejected or could not be solved.
    active : tuple of str
        Names of the limits that the best value reaches within 1 %.
    """

    variable: str
    goal: Goal
    unit: str
    best: float
    outcome: Outcome
    limits: Mapping[str, float]
    values: tuple[float, ...]
    outcomes: tuple[Outcome | None, ...]
    active: tuple[str, ...]

    @property
    def result(self) -> Result:
        """Result of the case at the best value."""
        return self.outcome.result

    @plots("only the power")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the power loss against the number, and the ratio of each limited result to its limit."""
        from .._support.pictures import draw_picture

        return draw_picture(self._draw_power, ax, figsize=(7.0, 5.0), compose=self._compose)

    def _compose(self, figure: Figure) -> None:
        above, below = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
        self._draw_power(above)
        above.label_outer()
        for name, limit in self.limits.items():
            x, values = _column(self._solved(), name)
            below.plot(x, np.array(values) / limit, label=name.replace("_", " "))
        below.axhline(1.0, color="gray", linewidth=0.8)
        below.set(xlabel=self.variable, ylabel="result / limit")
        below.legend()

    def _solved(self) -> list[tuple[float, Outcome]]:
        return [(v, r) for v, r in zip(self.values, self.outcomes, strict=True) if r is not None]

    def _draw_power(self, axes: Axes) -> None:
        solved = self._solved()
        powers = np.array([outcome.result.dissipated_power for _, outcome in solved])
        is_allowed = np.array([outcome.violation(self.limits) <= 0.0 for _, outcome in solved], dtype=bool)
        scale = Scale.of(powers, self.result.unit("dissipated_power"))
        values, shown = np.array([value for value, _ in solved]), powers / scale.factor
        axes.plot(values, shown, "k-", linewidth=1)
        axes.plot(values[is_allowed], shown[is_allowed], "go", label="allowed")
        axes.plot(values[~is_allowed], shown[~is_allowed], "rx", label="not allowed")
        axes.plot(self.best, self.result.dissipated_power / scale.factor, "b*", markersize=14, label="best")
        axes.set(xlabel=self.variable, ylabel=scale.text("power dissipated"))
        axes.legend()


def _column(solved: list[tuple[float, Outcome]], name: str) -> tuple[list[float], list[float]]:
    """Return the values of the number, and one result at each of them."""
    return [value for value, _ in solved], [outcome.value(name) for _, outcome in solved]


@dataclass(slots=True)
class _Search:
    """Results by value of the number; each value is solved once."""

    solve: Callable[[float, Report | None], Outcome]
    report: Report | None
    found: dict[float, Outcome | None] = field(default_factory=dict)
    reasons: list[str] = field(default_factory=list)

    def __call__(self, value: float) -> Outcome | None:
        if value not in self.found:
            try:
                self.found[value] = self.solve(value, self._report_of_case)
            except (ValueError, ConvergenceError) as error:
                self.found[value] = None
                self.reasons.append(str(error))
        return self.found[value]

    def _report_of_case(self, stage: str, fraction: float) -> None:
        if self.report is not None:
            self.report(f"case {len(self.found) + 1}: {stage}", fraction)


def design_case(path: str | Path, *, progress: ProgressLike = None) -> Design:
    """Find the value of one number of a case file with the least power loss, or the largest value, within limits.

    The file is a case file with one more table::

        [design]
        vary = "ball.layers[0].thickness"
        from = 0.5e-3
        to = 5e-3
        limits = { max_pressure = 2e6, strain = 0.2 }

    With ``goal = "largest_value"`` it finds the largest value that satisfies the limits, for example the largest load
    (``vary = "rolling.load"``) or speed (``vary = "rolling.angular_speed"``).

    Limits are upper bounds of scalar results, by their names, and of quantities inside the layers of the rolling body
    and of the counterbody:

    - `bond_shear` and `bond_tension` [Pa], the largest tractions where layers are bonded to a core, a base or each
      other;
    - `temperature` [K], the largest temperature, if the file has a table [thermal];
    - `load_to_fold` [-], if [thermal] has a shift: the ratio of the load to the load at which the cold state ends.

    With a shift and a thermal limit, the results are those of the coldest steady state. The search first solves values
    that are spaced geometrically, to find the ranges that satisfy the limits; then SciPy finds the ends of these ranges
    and, for the least power, the minimum within them.

    Parameters
    ----------
    path : path-like
        Path of the file.
    progress : bool or callable, optional
        True shows a bar. A function is called as progress(stage, fraction) about every 20 ms, with the completed
        fraction of the current case.

    Returns
    -------
    Design
        Best value, its result, and all values that were tried.

    Raises
    ------
    ValueError
        If the file is not valid, or if no value satisfies all limits. The message then gives the smallest excess.
    """
    path = Path(path)
    with errors_in(path):
        document = read_toml(path)
        wanted = _checked(document.pop("design", None), document)
        key_path = key_path_of(wanted.vary)
        varied = CaseFile.keys_of(document).at(document, key_path)

        def solve(value: float, report: Report | None = None) -> Outcome:
            return outcome_of(build_case(with_values(document, {key_path: value}), path.parent), wanted.limits, report)

        with silenced(), reporting(progress) as report:
            search = _Search(solve, report)
            solve(float(np.sqrt(wanted.low * wanted.high)))  # raises the errors of the file, if there are any
            return _best(wanted, search, varied.unit if varied is not None else "1")


def check_design(document: dict[str, Any]) -> None:
    """Raise the error of the table `design` of a file, if there is one."""
    _checked(document.pop("design", None), document)


def limits_of(document: Mapping[str, Any]) -> dict[str, float]:
    """Return the limits of the table `design` of a file in SI units, none without this table; raise its error."""
    if "design" not in document:
        return {}
    others = {name: table for name, table in document.items() if name != "design"}
    return _checked(document["design"], others).limits


class Wanted(StrictTable):
    """The table `design`: the number to choose, and the limits of the results.

    Parameters
    ----------
    vary : str
        Path of the number in the file, for example ball.layers[0].thickness.
    from, to : float
        Smallest and largest value of the number, in the unit of the file.
    limits : table
        Largest allowed values, by names of scalar results and of quantities inside the layers.
    goal : {"least_power", "largest_value"}, optional
        Whether to find the value with the least power loss, or the largest value that satisfies the limits.
    """

    vary: str
    low: float = Field(alias="from", gt=0.0)
    high: float = Field(alias="to")
    limits: dict[str, Annotated[float, Field(gt=0.0)]] = Field(default_factory=dict)
    goal: Goal = "least_power"


class _File(StrictTable):
    design: Wanted


def _in_si(table: dict[str, Any], document: dict[str, Any]) -> dict[str, Any]:
    """Return the table `design` with numbers in SI units in place of texts with units."""
    keys = CaseFile.keys_of(document)
    vary = table.get("vary")
    varied = keys.at(document, key_path_of(vary)) if isinstance(vary, str) else None
    found = {name: varied for name in ("from", "to") if varied is not None}
    ends = {
        name: key.number(table[name], f"design.{name}")
        for name, key in found.items()
        if isinstance(table.get(name), str)
    }
    units = limit_units(line_contact=keys.line_contact)
    in_si = {
        name: Key(units[name]).number(limit, f"design.limits.{name}") if isinstance(limit, str) else limit
        for name, limit in _limits_in(table).items()
    }
    return table | ends | ({"limits": in_si} if in_si else {})


def _limits_in(table: dict[str, Any]) -> dict[str, Any]:
    """Return the table of the limits as written in the file, empty if it is not a table."""
    limits = table.get("limits")
    return limits if isinstance(limits, dict) else {}


def _checked(table: object, document: dict[str, Any]) -> Wanted:
    if not isinstance(table, dict):
        raise InvalidInput("design", 'must be a table, such as vary = "ball.layers[0].thickness", from = ..., to = ...')
    if unknown := [name for name in _limits_in(table) if name not in LIMITS]:
        meant = get_close_matches(unknown[0], LIMITS, n=1)
        more = f"did you mean {meant[0]}?" if meant else ""
        raise InvalidInput("design.limits", f"must be named {', '.join(LIMITS)}", f"{unknown[0]!r}", more=more)
    if has_quantities(table):
        table = _in_si(table, document)
    wanted = checked(_File, {"design": table}).design
    if not wanted.low < wanted.high:
        raise ValueError(f"design.from and design.to must be 0 < from < to, got {wanted.low!r} and {wanted.high!r}")
    if "temperature" in wanted.limits:
        as_kelvin("design.limits.temperature", wanted.limits["temperature"])
    return wanted


def _best(wanted: Wanted, search: _Search, unit: str) -> Design:
    limits = wanted.limits
    grid = [float(value) for value in np.geomspace(wanted.low, wanted.high, _POINTS)]
    excess = [_excess(search, value, limits) for value in grid]
    if min(excess) > 0.0:
        nearest = int(np.argmin(excess))
        why = (
            f"the smallest excess over a limit is {excess[nearest]:.1%}, at {grid[nearest]:g}"
            if np.isfinite(min(excess))
            else (search.reasons[-1] if search.reasons else "no value could be solved")
        )
        allowed = f"must allow a value of {wanted.vary} in [{wanted.low:g}, {wanted.high:g}]: {why}"
        raise InvalidInput("design.limits", allowed)
    ranges = _ranges(grid, excess)
    if wanted.goal == "largest_value":
        best = _edge(search, limits, grid, ranges[-1][1], +1)
    else:
        ends = (
            (_edge(search, limits, grid, first, -1), _edge(search, limits, grid, last, +1)) for first, last in ranges
        )
        candidates = [pair for start, stop in ends for pair in _candidates(search, limits, start, stop)]
        best = min(candidates, key=lambda pair: pair[1].value("dissipated_power"))[0]
    outcome = search(best)
    assert outcome is not None
    values = sorted(search.found)
    return Design(
        variable=wanted.vary,
        goal=wanted.goal,
        unit=unit,
        best=best,
        outcome=outcome,
        limits=limits,
        values=tuple(values),
        outcomes=tuple(search.found[value] for value in values),
        active=tuple(name for name, limit in limits.items() if outcome.value(name) > 0.99 * limit),
    )


def _excess(search: _Search, value: float, limits: Mapping[str, float]) -> float:
    outcome = search(value)
    return np.inf if outcome is None else outcome.violation(limits)


def _ranges(grid: list[float], excess: list[float]) -> list[tuple[int, int]]:
    """Return first and last index of each run of values that satisfy the limits."""
    allowed = [False, *(value <= 0.0 for value in excess), False]
    starts = [i for i in range(len(grid)) if allowed[i + 1] and not allowed[i]]
    stops = [i for i in range(len(grid)) if allowed[i + 1] and not allowed[i + 2]]
    return list(zip(starts, stops, strict=True))


def _edge(search: _Search, limits: Mapping[str, float], grid: list[float], index: int, step: int) -> float:
    """Return the end of an allowed range between an allowed value of the grid and its neighbor, on the allowed side."""
    with extra("studies"):
        from scipy.optimize import brentq

    neighbor = index + step
    if not 0 <= neighbor < len(grid):
        return grid[index]
    if search(grid[neighbor]) is None:
        return grid[index]
    inside, outside = grid[index], grid[neighbor]
    if _excess(search, inside, limits) == 0.0:
        return inside
    edge = float(brentq(lambda value: min(_excess(search, value, limits), 1e3), inside, outside, rtol=1e-4))
    # The root is accurate to its tolerance: step back to the side that satisfies the limits.
    return edge + 2e-4 * (inside - edge) if _excess(search, edge, limits) > 0.0 else edge


def _candidates(search: _Search, limits: Mapping[str, float], start: float, stop: float) -> list[tuple[float, Outcome]]:
    """Return candidates of an allowed range: its ends, the minimum between them, and all values solved within it."""
    with extra("studies"):
        from scipy.optimize import minimize_scalar

    found = [start, stop]
    if stop > start * (1.0 + 1e-9):

        def power(x: float) -> float:
            outcome = search(float(np.exp(x)))
            return np.inf if outcome is None else outcome.value("dissipated_power")

        inner = minimize_scalar(power, bounds=(np.log(start), np.log(stop)), method="bounded", options={"xatol": 1e-3})
        found.append(float(np.exp(inner.x)))
    found += [value for value in search.found if start <= value <= stop]
    pairs = [(value, outcome) for value in found if (outcome := search(value)) is not None]
    return [(value, outcome) for value, outcome in pairs if outcome.violation(limits) <= 1e-9] or pairs[:1]
