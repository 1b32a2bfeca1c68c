"""Solution of the tasks of a study on threads of this process, or with any executor."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import CancelledError, Executor, Future, ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from .._core import ConvergenceError, core_count
from .._support.progress import Report
from .._support.result_warnings import silenced
from ..bodies import RollingBody
from ..coupled import StrainSoftening, strain_softening
from ..coupled.softening_search import softens
from ..rolling import Result, RollingModel, solve
from ..rolling.propagation import Pair
from ..sliding import RoughSurface, SlidingResult, slide
from .draws import DrawMethod, drawn_scalars
from .factories import STUDY_ERRORS
from .plan import Addition, Plan, Task

__all__ = ["Outcome", "is_own_error", "run", "solve_group", "solve_point"]

#: Largest number of points of a task for an executor: the points that each worker loses if this process is killed.
_LARGEST_TASK = 8

#: Smallest number of tasks: for each core, and in total for an executor, whose workers cannot be counted. With more
#: tasks the workers finish closer together, but fewer points share influence tables.
_TASKS_PER_CORE = 2
_TASKS_OF_AN_EXECUTOR = 32

#: Result of a point.
Solved: TypeAlias = Result | StrainSoftening | SlidingResult

#: Name of the warning for a point whose draws failed.
NO_INTERVAL = "NO_INTERVAL"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Outcome:
    """Results of one point of a study, or the reason for its failure.

    Attributes
    ----------
    scalars : dict
        Scalar results by name, in SI units; empty if the point failed.
    fields : dict
        Arrays by name, of shape (..., nodes in φ, nodes in θ).
    draws : dict
        Scalar results for each draw of a material, by name, of shape (draws,).
    error : str
        Message of the exception if the point or its draws failed, else empty.
    lasting : bool
        Whether the same inputs always give this outcome. False if the user's own function or the machine failed.
    """

    scalars: Mapping[str, float | int | str | None] = field(default_factory=dict)
    fields: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    draws: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)
    error: str = ""
    lasting: bool = True


def solve_group(
    body: RollingBody | RoughSurface,
    shared: Mapping[str, Any],
    cases: Sequence[Mapping[str, Any]],
    *,
    fields: Sequence[str] = (),
    draws: Sequence[Pair] = (),
    method: DrawMethod = "linear",
    additions: Sequence[Addition | None] = (),
    threads: int = 1,
    progress: Report | None = None,
    record: Callable[[int, Outcome], object] | None = None,
) -> list[Outcome]:
    """Solve points that share their body, one after the other; with a common mesh with one `RollingModel`.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder, CoatedWheel or RoughSurface
        Rolling body or rough surface of all points.
    shared : mapping
        Arguments of the solver that are the same for all points, those of `StudyKind.shared`.
    cases : sequence of mapping
        The other arguments of each point.
    fields : sequence of str, default ()
        Names of the fields to store.
    draws : sequence of pairs, default ()
        Body and counterbody with each draw of their materials.
    method : "linear" or "solve", default "linear"
        Method for the results of the draws, as in `viscoroll.sweep`.
    additions : sequence of Addition or None, default ()
        Further results of each of `cases`; none if empty.
    threads : int, default 1
        Number of threads of each solve.
    progress : callable, optional
        Called as progress(stage, fraction) about every 20 ms. An exception that it raises ends the solve.
    record : callable, optional
        Called as record(position, outcome) after each point.

    Returns
    -------
    list of Outcome
        One outcome for each of `cases`, with the message of the exception if the point failed.

    Raises
    ------
    MemoryError, ImportError, CancelledError
        These are not tied to one point and end the group.
    """
    solver: Callable[..., Solved] | None = None
    outcomes = []
    for position, case in enumerate(cases):
        try:
            solver = solver or _solver(body, shared, cases, threads=threads, progress=progress)
            addition = additions[position] if additions else None
            added: dict[str, float]
            if addition is None:
                solved, added = solve_point(solver, **case), {}
            else:
                rolling: Callable[..., Any] = partial(solver, **case)
                arguments = {"body": body, **shared, **case}
                with silenced():
                    solved, added = addition.solve(rolling, arguments, threads=threads, progress=progress)
        except STUDY_ERRORS:
            raise
        except Exception as error:
            outcome = Outcome(error=f"{type(error).__name__}: {error}", lasting=is_own_error(error))
        else:
            result, bounds = (solved.result, solved.bounds) if isinstance(solved, StrainSoftening) else (solved, {})
            kept = {name: np.asarray(getattr(result, name), dtype=np.float64) for name in fields}
            outcome = Outcome(scalars={**result.scalars(), **bounds, **added}, fields=kept)
            if draws and isinstance(result, Result):
                given = {**shared, **case}
                outcome = _with_draws(outcome, result, draws, method, given, threads=threads, progress=progress)
        outcomes.append(outcome)
        if record is not None:
            record(position, outcome)
    return outcomes


def _with_draws(
    outcome: Outcome, result: Result, draws: Sequence[Pair], method: DrawMethod, case: Mapping[str, Any], **options: Any
) -> Outcome:
    """Return the outcome with results of draws, or with the warning `NO_INTERVAL` if the draws failed."""
    try:
        return replace(outcome, draws=drawn_scalars(result, draws, method, case, **options))
    except STUDY_ERRORS:
        raise
    except Exception as error:
        warnings = ", ".join(filter(None, [str(outcome.scalars.get("warnings", "")), NO_INTERVAL]))
        text = f"draws: {type(error).__name__}: {error}"
        scalars = {**outcome.scalars, "warnings": warnings}
        return replace(outcome, scalars=scalars, error=text, lasting=is_own_error(error))


def is_own_error(error: Exception) -> bool:
    """Return whether this package itself rejected the point; False if a user's function or a library failed."""
    frame = error.__traceback__
    while frame is not None and frame.tb_next is not None:
        frame = frame.tb_next
    raised_in = "" if frame is None else str(frame.tb_frame.f_globals.get("__name__", ""))
    is_ours = raised_in.partition(".")[0] == __name__.partition(".")[0]
    return is_ours and isinstance(error, ValueError | ConvergenceError)


def solve_point(solver: Callable[..., Solved], **case: Any) -> Solved:
    """Solve one point: `solver` holds the arguments shared with other points, `case` the remaining ones."""
    with silenced():
        return solver(**case)


def _solver(
    body: RollingBody | RoughSurface, shared: Mapping[str, Any], cases: Sequence[Mapping[str, Any]], **options: Any
) -> Callable[..., Solved]:
    """Return a model with shared influence tables, or, without a fixed mesh, a solver with the shared arguments."""
    if isinstance(body, RoughSurface):
        return partial(slide, body, **shared, **options)
    if softens(body, shared.get("on")):
        return partial(strain_softening, body, **shared, **options)  # the moduli depend on the strain of each point
    if "mesh" not in shared or any("accuracy" in case for case in cases):
        return partial(solve, body, **shared, **options)
    of_model = {
        name: value for name, value in shared.items() if name in ("on", "angular_speed", "speed", "mesh", "curvature")
    }
    model = RollingModel(body, **of_model, **options)
    rest = {name: value for name, value in shared.items() if name not in of_model}
    return partial(model.solve, **rest, **options)


def run(
    plan: Plan, indices: Sequence[int], *, record: Callable[[int, Outcome], object], executor: Executor | None = None
) -> None:
    """Solve points of a plan.

    Parameters
    ----------
    plan : Plan
        All points of the study.
    indices : sequence of int
        Indices of the points to solve.
    record : callable
        Called as record(index, outcome), from any thread of this process, as soon as an outcome is available.
    executor : Executor, optional
        Executor that solves the tasks; by default, threads of this process.

    Raises
    ------
    Exception
        First exception of `record` or of a worker, after all other tasks have ended: for example a broken pool, or an
        argument that cannot be pickled.
    KeyboardInterrupt
        On Ctrl-C, after waiting tasks have been canceled.
    """
    if executor is None:
        _run_on_threads(plan, indices, record)
        return
    tasks = plan.tasks(indices, largest=min(_LARGEST_TASK, -(-len(indices) // _TASKS_OF_AN_EXECUTOR)))

    def record_all(task: Task, outcomes: Sequence[Outcome]) -> None:
        for index, outcome in zip(task.indices, outcomes, strict=True):
            record(index, outcome)

    _collect({executor.submit(_solve_task, task): task for task in tasks}, record_all)


def _run_on_threads(plan: Plan, indices: Sequence[int], record: Callable[[int, Outcome], object]) -> None:
    stop = threading.Event()

    def check(*_: object) -> None:
        if stop.is_set():
            raise CancelledError

    def work(task: Task) -> None:
        def keep(position: int, outcome: Outcome) -> None:
            record(task.indices[position], outcome)
            check()

        _solve_task(task, threads=threads, progress=check, record=keep)

    tasks = plan.tasks(indices, largest=-(-len(indices) // (_TASKS_PER_CORE * core_count())))
    threads = max(1, core_count() // max(1, len(tasks)))
    with ThreadPoolExecutor(core_count()) as pool:
        try:
            _collect({pool.submit(work, task): task for task in tasks}, lambda *_: None)
        finally:
            stop.set()


def _solve_task(task: Task, **options: Any) -> list[Outcome]:
    given = (task.body, task.shared, task.cases)
    return solve_group(
        *given, fields=task.fields, draws=task.draws, method=task.method, additions=task.additions, **options
    )


def _collect(futures: dict[Future[Any], Task], record: Callable[[Task, Any], None]) -> None:
    """Record the results of the tasks as they end; after the last one, raise the first exception of a task."""
    errors: list[BaseException] = []
    waiting = dict(futures)
    try:
        for future in as_completed(futures):
            if (error := future.exception()) is None:
                record(futures[future], future.result())
            else:
                errors.append(error)
            del waiting[future]
    except BaseException:
        for future in waiting:
            future.cancel()
        for future, task in waiting.items():
            if future.done() and not future.cancelled() and future.exception() is None:
                record(task, future.result())
        raise
    if errors:
        raise errors[0]
