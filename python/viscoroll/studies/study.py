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

from .._support.errors import InvalidInput, InvalidType
from .._support.intervals import as_confidence
from .._support.progress import ProgressLike, counted
from .._support.result_warnings import warn
from .._support.suggestions import suggestion
from .._support.text import shown
from ..bodies import RollingBody
from ..materials import Draws
from ..sliding import RoughSurface
from ..solution import FIELDS, VECTOR_FIELDS
from .cache import DAMAGED, StudyCache, as_cache_path
from .dataset import RESERVED, RESERVED_BY_SLIDING, build_dataset
from .draws import DrawMethod, as_draw_method
from .kinds import ROLLING, SLIDING
from .plan import LoadCase, Plan, plan_sweep
from .run import Outcome, run

if TYPE_CHECKING:
    import xarray

__all__ = ["run_plan", "study_warnings", "sweep"]


def sweep(
    body: RollingBody | RoughSurface | Callable[..., RollingBody | RoughSurface],
    *,
    executor: Executor | None = None,
    cache: str | Path | None = None,
    retry_failed: bool = False,
    progress: ProgressLike = True,
    fields: Iterable[str] = (),
    draws: DrawMethod = "linear",
    confidence: float = 0.95,
    **parameters: Any,
) -> xarray.Dataset:
    """Solve all combinations of parameters.

    Every parameter given as a one-dimensional sequence, or as a mapping of labels to values, becomes a dimension of the
    result, in the order given. The other parameters are the same for all points. The same call with the same `cache`
    resumes an interrupted study; a call with additional values solves only the new points.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder, CoatedWheel, RoughSurface or callable
        Rolling body of all points, or a function that returns it. The function is called as body(name=value, ...) with
        those parameters below that are not arguments of `viscoroll.solve`. With a rough surface, or with a function
        and the parameter pressure, the points are those of `viscoroll.slide`.
    executor : concurrent.futures.Executor, optional
        Executor that solves the points: a process pool, dask's ``Client.get_executor()``, mpi4py's ``MPIPoolExecutor``.
        By default, threads of this process, with one solve on each core. The results do not depend on the executor.
    cache : path-like, optional
        Path of a .nc file, which is written when all points are solved. A second file, with the additional suffix
        .points, stores every point as soon as it is solved, and identifies it by its inputs, so that every study with
        the same cache can use it. With an executor, the points of a task (at most eight) are stored together.
    retry_failed : bool, default False
        Whether to solve failed points again, and points whose data in the cache is damaged.
    progress : bool or callable, default True
        True shows a bar with an estimate of the time left. A function is called as progress(stage, fraction) after
        every point.
    fields : iterable of str, default ()
        Names of the fields of `Result` to store for each point, on the largest window of the study, centered at the
        lowest point of the body, with NaN outside a point's own window.
    draws : {"linear", "solve"}, default "linear"
        Method for results of `Draws`. "linear" propagates the draws to first order in the moduli with a frozen contact,
        and needs one solve for each independent direction in which the draws differ. "solve" solves each draw
        completely, on the mesh of the point. Linear draws give no intervals for the dimensions of the contact, nor for
        a largest pressure at the edge of the contact.
    confidence : float, default 0.95
        Probability that an interval contains the true value, as far as the draws represent the uncertainty [-],
        in (0, 1).
    **parameters : float, object, or sequence of them
        Arguments of `viscoroll.solve`: load [N] or penetration [m], angular_speed [rad/s], on, friction [-], drive,
        mesh, accuracy [-], compliance, curvature, patch_load, slip_kinematics, max_iterations. For rough surfaces,
        arguments of `viscoroll.slide`: pressure [Pa] or load [N], speed [m/s], on, friction [-], tolerance [-],
        max_iterations. The counterbody `on` can also be given by a function. All other names are parameters of these
        two functions; each function receives the parameters that it takes. `Draws` of a material, or of a quantity from
        which a function makes a material, count as one value of a parameter and give the results intervals, for the
        body as well as for the counterbody.

    Returns
    -------
    xarray.Dataset
        All scalar results with units, and the selected fields. With draws, the physical results also have the variables
        ``_mean``, ``_lower`` and ``_upper``: the mean over the draws, and the interval around the result from their
        scatter. If a point failed, its results are NaN, its `status` is "FAILED" and `error` holds the message. If only
        the draws failed, their `_mean` and interval are NaN, and the point has the warning NO_INTERVAL. Attributes hold
        version, commit, mesh, body and materials, and the number of points by status.

    Warns
    -----
    ResultWarning
        If points failed or did not reach the accuracy, with the number of such points.

    Raises
    ------
    ValueError
        For a cache that is in use by another study, was made by another version, is damaged or is not a cache; for
        repeated values, unknown fields, and more than 1 000 000 points.
    TypeError
        For missing or unknown parameters, and for values of a wrong type.
    OSError
        If a file of the cache cannot be read or written, for example on a full disk. The cache keeps the points that
        were stored before.
    ImportError
        Without the extra `viscoroll[studies]`.
    KeyboardInterrupt
        On Ctrl-C. The cache keeps the points solved so far.

    Notes
    -----
    The cache identifies a Python function of frequency as material by its values at zero frequency and at 96 multiples
    of the point's speed, up to the highest order that the mesh can evaluate. If viscoroll itself rejects a point, the
    cache stores the message as its result. If something else fails at a point (the function `body`, a material, a
    library), the dataset contains the message, but the cache does not. Failures that are not tied to one point are
    raised: lack of memory or a missing package at once; a broken pool, or an object that cannot be sent to another
    process, after the other points are solved.

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
    is_sliding = isinstance(body, RoughSurface) or ("pressure" in parameters and "angular_speed" not in parameters)
    kept = _checked_fields(fields)
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InvalidType("executor", "must be a concurrent.futures.Executor or None", repr(executor))
    how: dict[str, Any] = {"method": as_draw_method(draws), "confidence": as_confidence(confidence)}
    if is_sliding:
        _check_sliding(parameters, kept)
        plan = plan_sweep(body, parameters, kind=SLIDING, **how)
    else:
        _check_names(parameters)
        plan = plan_sweep(body, parameters, fields=kept, **how)
    study = run_plan(plan, executor=executor, cache=cache, retry_failed=retry_failed, progress=progress)
    warn(study_warnings(study))
    return study


def study_warnings(study: xarray.Dataset) -> list[str]:
    """Return a text that counts failed points and warnings by kind, and a hint at implausible units, if any."""
    found = Counter(kind for text in study.warnings.values.ravel() for kind in str(text).split(", ") if kind)
    if failed := int((study.status == "FAILED").sum()):
        found["FAILED"] = failed
    counted = ", ".join(f"{count} {kind}" for kind, count in found.items())
    others = len(found) > bool(failed)
    where = "status, warnings and error" if failed and others else "status and error" if failed else "warnings"
    texts = [f"among {study.status.size} points: {counted}; see {where} of the study"] if found else []
    return [*texts, *filter(None, [study.attrs.get("unit_hint")])]


def run_plan(
    plan: Plan,
    *,
    executor: Executor | None = None,
    cache: str | Path | None = None,
    retry_failed: bool = False,
    progress: ProgressLike = True,
) -> xarray.Dataset:
    """Solve all points of a plan that the cache does not hold, and return the dataset; parameters as in `sweep`."""
    path = None if cache is None else as_cache_path(cache)
    with ExitStack() as stack:
        store = None if path is None else stack.enter_context(StudyCache(path))
        before = None if store is None else store.study()
        recorder = _Recorder(plan, store, retry_failed=retry_failed)
        missing = [i for i in range(len(plan.cases)) if i not in recorder.outcomes]
        if before is not None and not missing and json.loads(before.attrs["inputs"]) == plan.identity():
            return before
        done = len(recorder.outcomes)
        recorder.advance = stack.enter_context(counted(progress, total=len(plan.cases), unit="point", done=done))
        run(plan, missing, record=recorder, executor=executor)
        dataset = build_dataset(plan, recorder.outcomes)
        if store is not None:
            store.write(dataset)
    return dataset


class _Recorder:
    """Receiver of the outcome of each point, from any thread: updates memory, cache and progress bar."""

    def __init__(self, plan: Plan, store: StudyCache | None, *, retry_failed: bool) -> None:
        self.outcomes = {i: Outcome(error=case) for i, case in enumerate(plan.cases) if not isinstance(case, LoadCase)}
        self.advance: Callable[[], None] = lambda: None
        self._keys, self._store = plan.keys, store
        self._lock = threading.Lock()
        for i, key in enumerate(plan.keys):
            known = None if store is None or key is None else store.outcome(key)
            if store is None or known is None or (retry_failed and known.error):
                continue
            if known is DAMAGED:
                raise ValueError(
                    f"cache {store.database_path} is damaged at point {i + 1} of {len(plan.keys)}: solve its damaged "
                    "points again with retry_failed=True (viscoroll sweep --retry-failed), or delete it and "
                    f"{store.path.name} to start again"
                )
            self.outcomes[i] = known

    def __call__(self, index: int, outcome: Outcome) -> None:
        with self._lock:
            if self._store is not None and outcome.lasting and (key := self._keys[index]) is not None:
                self._store.keep(key, outcome)
            self.outcomes[index] = outcome
            self.advance()


def _checked_fields(fields: Iterable[str]) -> tuple[str, ...]:
    known = (*FIELDS, *VECTOR_FIELDS)
    kept = (fields,) if isinstance(fields, str) else tuple(fields)
    for name in kept:
        if name not in known:
            raise InvalidInput("fields", f"must be names from {', '.join(known)}", repr(name))
    return tuple(name for name in known if name in kept)


def _check_names(parameters: dict[str, Any]) -> None:
    wanted = {
        name for name, other in (("load", "penetration"), ("angular_speed", "speed")) if parameters.get(other) is None
    }
    if missing := sorted(wanted - parameters.keys()):
        guesses = [guess for name in parameters if (guess := suggestion(name, missing))]
        hint = f"; did you mean {', '.join(guesses)}?" if guesses else ""
        raise TypeError(f"sweep requires {' and '.join(missing)}{hint}")
    if parameters.get("load") is not None and parameters.get("penetration") is not None:
        raise InvalidInput("penetration", "must be left out if the load is given", shown(parameters["penetration"]))
    if parameters.get("angular_speed") is not None and parameters.get("speed") is not None:
        raise InvalidInput("speed", "must be left out if the angular speed is given", shown(parameters["speed"]))
    if parameters.get("mesh") is not None and parameters.get("accuracy") is not None:
        raise InvalidInput("accuracy", "must be left out if a mesh is given", f"{parameters['accuracy']!r}")
    if taken := sorted(parameters.keys() & RESERVED - ROLLING.arguments):
        raise InvalidInput("parameters", "must not have names of results", f"{', '.join(taken)}")


def _check_sliding(parameters: dict[str, Any], fields: tuple[str, ...]) -> None:
    if missing := sorted({"on", "speed"} - parameters.keys()):
        raise TypeError(f"sweep of a rough surface requires {' and '.join(missing)}")
    if (parameters.get("pressure") is None) == (parameters.get("load") is None):
        raise TypeError("sweep of a rough surface requires exactly one of pressure and load")
    if fields:
        raise InvalidInput("fields", "must be left out for a rough surface", ", ".join(fields))
    if drawn := [name for name, value in parameters.items() if isinstance(value, Draws)]:
        raise InvalidInput(drawn[0], "must be a single material for a rough surface", "draws")
    if taken := sorted(parameters.keys() & RESERVED_BY_SLIDING - SLIDING.arguments):
        raise InvalidInput("parameters", "must not have names of results", f"{', '.join(taken)}")
