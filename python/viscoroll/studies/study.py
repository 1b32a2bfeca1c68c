"""Parameter studies."""

from __future__ import annotations

import json
import threading
from collections import Counter
from collections.abc import Callable, Iterable
from concurrent.futures import Executor
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._support.cautions import warn
from .._support.intervals import as_confidence
from .._support.keywords import meant
from .._support.progress import ProgressLike, counted
from ..bodies import RollingBody
from ..solution import FIELDS, VECTOR_FIELDS
from .cache import DAMAGED, StudyCache, as_cache_path
from .dataset import RESERVED, build_dataset
from .dimensions import LOAD_CASE
from .draws import Way, as_way
from .plan import LoadCase, Plan, plan_sweep
from .run import Outcome, run

if TYPE_CHECKING:
    import xarray

__all__ = ["doubts", "run_plan", "sweep"]


def sweep(
    ball: RollingBody | Callable[..., RollingBody],
    *,
    executor: Executor | None = None,
    cache: str | Path | None = None,
    retry_failed: bool = False,
    progress: ProgressLike = True,
    fields: Iterable[str] = (),
    draws: Way = "linear",
    confidence: float = 0.95,
    **parameters: Any,
) -> xarray.Dataset:
    """Solve all combinations of parameters.

    Every parameter given as a one-dimensional sequence, or as a mapping of labels to values, becomes a dimension of the
    result, in the order given; the others are the same for all points. A study that was interrupted goes on where it
    stopped if it is called again with the same `cache`, and one that has grown by some values solves what is new.

    Parameters
    ----------
    ball : CoatedSphere, CoatedCylinder, CoatedWheel or callable
        The ball of all points, or a function that returns it, called as ball(name=value, ...) with all parameters that
        are not of `viscoroll.solve`.
    executor : concurrent.futures.Executor, optional
        Where to solve: a process pool, dask's ``Client.get_executor()``, mpi4py's ``MPIPoolExecutor``. By default on
        threads of this process, one solve on each core. The result does not depend on it.
    cache : path-like, optional
        A file .nc, written when all points are solved. Beside it, in a file with the suffix .points, every point is
        kept as soon as it is solved, and found again by its own inputs in this and any other study with the same cache.
        With an executor, the points of a task (at most eight) are kept together.
    retry_failed : bool, default False
        Solve points again that failed before, and those whose data in the cache is damaged.
    progress : bool or callable, default True
        Show a bar with an estimate of the time left; or called as progress(stage, fraction) after every point.
    fields : iterable of str, default ()
        Fields of `Result` to keep for each point, on the largest window, centered at the lowest point, with NaN outside
        a point's own window.
    draws : {"linear", "solve"}
        How results of `Draws` are found: to first order in the moduli, with who touches as it is, of as few solves as
        there are ways in which the draws differ, or each by a solve of its own, on the point's mesh. Linear ones
        have no interval of the contact's outline, nor of a largest pressure at its edge.
    confidence : float, default 0.95
        Probability that an interval holds the true value, as far as the draws know [-].
    **parameters : float, object, or sequence of them
        Arguments of `viscoroll.solve`: load [N], angular_speed [rad/s], on, friction [-], drive, mesh, accuracy [-],
        compliance, curvature, patch_load, slip_kinematics, max_iterations. What the ball rolls on, `on`, may be a
        function, too. All other names are of these two functions, of each what it takes. `Draws` of a material, or of
        what one is made from, are one value of a function's, and make intervals; so do those of `on`.

    Returns
    -------
    xarray.Dataset
        All scalar results with units, and the fields asked for. With draws also, of what the contact does, ``_mean``,
        ``_lower`` and ``_upper``: the mean of the draws, and the interval around the result by their scatter. Where a
        point failed its results are NaN, its `status` is "FAILED" and `error` holds the message; where its draws did,
        their `_mean` and interval are, with a warning NO_INTERVAL. Attributes hold version, commit, mesh, ball and
        materials, and how many points ended in which way.

    Warns
    -----
    ResultWarning
        Where points failed or were not solved as accurately as wanted: how many.

    Raises
    ------
    ValueError
        For a cache that another study uses, that another version made, or that is damaged or something else; for
        repeated values, unknown fields, and more than 1 000 000 points.
    TypeError
        For missing or unknown parameters, and for values of another type.
    OSError
        If a file of the cache cannot be read or written, as on a full disk; the cache keeps the points before.
    ImportError
        Without the extra `viscoroll[studies]`.
    KeyboardInterrupt
        On Ctrl-C; the cache keeps what was solved.

    Notes
    -----
    A Python function of frequency as material is recognized in a cache by its values at some hundred harmonics of the
    point's speed, up to the highest that a mesh can ask for. What viscoroll refuses a point with is kept as its result.
    What else fails at a point (the function `ball`, a material, a library) is in the dataset and not in the cache. What
    is not of a point is raised: lack of memory or of a package at once, a broken pool or something that cannot be sent
    to another process when the other points are solved.

    Examples
    --------
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> def coated(thickness):
    ...     layer = vr.Layer(thickness=thickness, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    ...     return vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    >>> mesh = vr.Mesh(nodes_per_revolution=100, max_order=150)
    >>> study = vr.sweep(
    ...     coated, thickness=[1e-3, 2e-3], load=[50.0, 100.0], angular_speed=2.5, mesh=mesh, progress=False
    ... )
    >>> study.resisting_torque.dims
    ('thickness', 'load')
    """
    kept = _checked_fields(fields)
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise TypeError(f"executor must be a concurrent.futures.Executor or None, got {executor!r}")
    _check_names(parameters)
    plan = plan_sweep(ball, parameters, fields=kept, way=as_way(draws), confidence=as_confidence(confidence))
    study = run_plan(plan, executor=executor, cache=cache, retry_failed=retry_failed, progress=progress)
    warn(doubts(study))
    return study


def doubts(study: xarray.Dataset) -> list[str]:
    """Say in one line how many points failed or carry a warning, and of which kind, and in one how odd units read."""
    found = Counter(kind for text in study.warnings.values.ravel() for kind in str(text).split(", ") if kind)
    if failed := int((study.status == "FAILED").sum()):
        found["FAILED"] = failed
    counted = ", ".join(f"{count} {kind}" for kind, count in found.items())
    others = len(found) > bool(failed)
    where = "status, warnings and error" if failed and others else "status and error" if failed else "warnings"
    told = [f"of {study.status.size} points: {counted}; see {where}"] if found else []
    return [*told, *filter(None, [study.attrs.get("caution")])]


def run_plan(
    plan: Plan,
    *,
    executor: Executor | None = None,
    cache: str | Path | None = None,
    retry_failed: bool = False,
    progress: ProgressLike = True,
) -> xarray.Dataset:
    """Solve all points of a plan that the cache does not hold. Parameters as of `sweep`."""
    path = None if cache is None else as_cache_path(cache)
    with ExitStack() as stack:
        store = None if path is None else stack.enter_context(StudyCache(path))
        before = None if store is None else store.study()
        recorder = _Recorder(plan, store, retry_failed=retry_failed)
        missing = [i for i in range(len(plan.cases)) if i not in recorder.outcomes]
        if before is not None and not missing and json.loads(before.attrs["inputs"]) == plan.identity():
            return before
        done = len(recorder.outcomes)
        recorder.one_more = stack.enter_context(counted(progress, total=len(plan.cases), unit="point", done=done))
        run(plan, missing, record=recorder, executor=executor)
        dataset = build_dataset(plan, recorder.outcomes)
        if store is not None:
            store.write(dataset)
    return dataset


class _Recorder:
    """Takes the outcome of each point, from any thread, into memory, store and progress bar."""

    def __init__(self, plan: Plan, store: StudyCache | None, *, retry_failed: bool) -> None:
        self.outcomes = {i: Outcome(error=case) for i, case in enumerate(plan.cases) if not isinstance(case, LoadCase)}
        self.one_more: Callable[[], None] = lambda: None
        self._keys, self._store = plan.keys, store
        self._lock = threading.Lock()
        for i, key in enumerate(plan.keys):
            known = None if store is None or key is None else store.outcome(key)
            if store is None or known is None or (retry_failed and known.error):
                continue
            if known is DAMAGED:
                raise ValueError(
                    f"cache {store.points} is damaged at point {i + 1} of {len(plan.keys)}: solve its damaged points "
                    "again with retry_failed=True (viscoroll sweep --retry-failed), or delete it and "
                    f"{store.path.name} to start again"
                )
            self.outcomes[i] = known

    def __call__(self, index: int, outcome: Outcome) -> None:
        with self._lock:
            if self._store is not None and outcome.lasting and (key := self._keys[index]) is not None:
                self._store.keep(key, outcome)
            self.outcomes[index] = outcome
            self.one_more()


def _checked_fields(fields: Iterable[str]) -> tuple[str, ...]:
    known = (*FIELDS, *VECTOR_FIELDS)
    kept = (fields,) if isinstance(fields, str) else tuple(fields)
    for name in kept:
        if name not in known:
            raise ValueError(f"fields must be of {', '.join(known)}, got {name!r}")
    return tuple(name for name in known if name in kept)


def _check_names(parameters: dict[str, Any]) -> None:
    if missing := sorted({"load", "angular_speed"} - parameters.keys()):
        guesses = [guess for name in parameters if (guess := meant(name, missing))]
        told = f"; did you mean {', '.join(guesses)}?" if guesses else ""
        raise TypeError(f"sweep needs {' and '.join(missing)}{told}")
    if parameters.get("mesh") is not None and parameters.get("accuracy") is not None:
        raise ValueError(f"accuracy must be left out where a mesh is given, got {parameters['accuracy']!r}")
    if taken := sorted(parameters.keys() & RESERVED - LOAD_CASE):
        raise ValueError(f"parameters must have other names than results, got {', '.join(taken)}")
