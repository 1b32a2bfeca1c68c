"""Sweeps of histories: all combinations of parameters, and the energy of obstacles beside flat ground."""

from __future__ import annotations

import inspect
import itertools
import math
import threading
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import __commit__, __version__, core_count
from .._support.arguments import require_callable
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.progress import ProgressLike, counted
from .._support.result_warnings import silenced, warn
from .._support.units import UNITS
from ..transient import roll
from .cache import DAMAGED, StudyCache, as_cache_path
from .dimensions import Dimension, require_feasible, split
from .factories import STUDY_ERRORS
from .identity import digest, sampled_text
from .run import Outcome, is_own_error
from .runner import run_all

if TYPE_CHECKING:
    import xarray

__all__ = ["sweep_histories"]

#: Arguments of `viscoroll.roll` that do not determine its result.
_WITHOUT_EFFECT = ("threads", "progress", "checkpoint", "contact_times")


def sweep_histories(
    motion: Callable[..., Mapping[str, Any]],
    *,
    cache: str | Path | None = None,
    progress: ProgressLike = True,
    **parameters: Any,
) -> xarray.Dataset:
    """Compute the histories of all combinations of parameters, such as speed and height of an obstacle.

    Every parameter given as a one-dimensional sequence, or as a mapping of labels to values, becomes a dimension of the
    result, in the order given. If a point has uneven ground, the same motion on flat ground is also computed, once for
    all points that share it. The same call with the same `cache` resumes an interrupted sweep; a call with additional
    values computes only the new histories.

    Parameters
    ----------
    motion : callable
        Function that is called as motion(name=value, ...) with the parameters of a point, and returns the arguments of
        `viscoroll.roll` as a mapping, including `body`.
    cache : path-like, optional
        Path of a .nc file, which is written when all points are computed. A second file, with the additional suffix
        .points, stores every history as soon as it is computed.
    progress : bool or callable, default True
        True shows a bar with an estimate of the time left. A function is called as progress(stage, fraction) after
        every history.
    **parameters : float, object, or sequence of them
        Parameters of `motion`.

    Returns
    -------
    xarray.Dataset
        The numbers of `History.scalars` with units, and `obstacle_energy`: the dissipated energy minus that of the same
        motion on flat ground (0 on flat ground). If a point failed, its results are NaN and `error` holds the message.

    Raises
    ------
    ValueError
        For repeated values, more than 1 000 000 points, and a cache that is in use, was made by another version, is
        damaged or is not a cache.
    TypeError
        If `motion` does not take the parameters.
    ImportError
        Without the extra `viscoroll[studies]`.

    Warns
    -----
    ResultWarning
        If points failed, with their number; and the warnings of the histories, each once.

    Examples
    --------
    >>> import viscoroll as vr
    >>> def over_cable(speed, height):
    ...     cable = vr.Profile.half_sine(height, length=4e-3, at=6e-3)
    ...     return dict(
    ...         body=vr.paper.ball(), time=[0.0, 12e-3 / speed], distance=[0.0, 12e-3], load=100.0, ground=cable,
    ...         mesh=vr.Mesh(nodes_per_revolution=260), averaged_meshes=1,
    ...     )
    >>> study = vr.studies.sweep_histories(over_cable, speed=[0.05, 0.1], height=[0.1e-3, 0.2e-3], progress=False)
    >>> study.largest_resisting_force.dims
    ('speed', 'height')
    """
    require_callable("motion", motion)
    given = {name: split(name, value) for name, value in parameters.items()}
    dimensions = [value for value in given.values() if isinstance(value, Dimension)]
    require_feasible({one.name: len(one.values) for one in dimensions})
    try:
        inspect.signature(motion).bind(**given)
    except TypeError as error:
        raise TypeError(f"motion, called with {', '.join(given) or 'no parameter'}: {error}") from None
    fixed = {name: value for name, value in given.items() if not isinstance(value, Dimension)}
    points = [
        fixed | dict(zip([one.name for one in dimensions], values, strict=True))
        for values in itertools.product(*(one.values for one in dimensions))
    ]
    path = None if cache is None else as_cache_path(cache)
    with ExitStack() as stack:
        store = None if path is None else stack.enter_context(StudyCache(path))
        if store is not None:
            store.study()  # checks that the file belongs to the cache
        histories = _Histories(store)
        rows = [histories.row(motion, point) for point in points]
        histories.compute(progress)
        outcomes = [histories.combined(row) for row in rows]
        dataset = _dataset(dimensions, fixed, outcomes)
        if store is not None:
            store.write(dataset)
    failed = sum(bool(outcome.error) for outcome in outcomes)
    warn([*([f"among {len(points)} points: {failed} FAILED; see error"] if failed else []), *histories.messages])
    return dataset


class _Histories:
    """Histories by the text of their inputs, each computed once or read from a cache."""

    def __init__(self, store: StudyCache | None) -> None:
        self.messages: dict[str, None] = {}  # an ordered set
        self._store = store
        self._outcomes: dict[str, Outcome] = {}
        self._missing: dict[str, Mapping[str, Any]] = {}
        self._lock = threading.Lock()

    def row(self, motion: Callable[..., Mapping[str, Any]], point: dict[str, Any]) -> tuple[str, str | None]:
        """Return the keys of the history of a point and, over uneven ground, of that on flat ground."""
        try:
            arguments = motion(**point)
        except STUDY_ERRORS:
            raise
        except Exception as error:
            key = digest(f"failed {point!r} {error!r}")
            self._outcomes[key] = Outcome(error=f"{type(error).__name__}: {error}")
            return key, None
        if not isinstance(arguments, Mapping):
            raise InvalidInput("motion", "must return a mapping of arguments of roll", repr(arguments))
        flat = {name: value for name, value in arguments.items() if name != "ground"}
        return self._added(arguments), self._added(flat) if arguments.get("ground") is not None else None

    def _added(self, arguments: Mapping[str, Any]) -> str:
        decisive = {
            name: value
            for name, value in sorted(arguments.items())
            if (value is not None or name == "steps_per_spacing") and name not in _WITHOUT_EFFECT
        }
        key = digest(f"history {', '.join(f'{name}={sampled_text(value)}' for name, value in decisive.items())}")
        if key in self._outcomes or key in self._missing:
            return key
        known = None if self._store is None else self._store.outcome(key)
        if known is DAMAGED or known is None:
            self._missing[key] = arguments
        else:
            self._outcomes[key] = known
        return key

    def compute(self, progress: ProgressLike) -> None:
        """Compute the missing histories on threads of this process."""
        threads = max(1, core_count() // max(1, len(self._missing)))
        with counted(progress, total=len(self._missing), unit="motion") as advance:

            def one(item: tuple[str, Mapping[str, Any]]) -> None:
                key, arguments = item
                with silenced() as messages:
                    outcome = _outcome({"threads": threads} | dict(arguments))
                with self._lock:
                    self.messages |= dict.fromkeys(messages)
                    self._outcomes[key] = outcome
                    if self._store is not None and outcome.lasting:
                        self._store.keep(key, outcome)
                    advance()

            run_all(one, self._missing.items())

    def combined(self, row: tuple[str, str | None]) -> Outcome:
        """Return the outcome of a point with the energy of its obstacles."""
        outcome, flat = self._outcomes[row[0]], None if row[1] is None else self._outcomes[row[1]]
        if outcome.error or (flat is not None and flat.error):
            return outcome if outcome.error or flat is None else Outcome(error=f"on flat ground: {flat.error}")
        smooth = outcome if flat is None else flat
        energy = outcome.scalars["dissipated_energy"] - smooth.scalars["dissipated_energy"]  # type: ignore[operator]
        return Outcome(scalars={**outcome.scalars, "obstacle_energy": energy})


def _outcome(arguments: dict[str, Any]) -> Outcome:
    try:
        history = roll(**arguments)
    except STUDY_ERRORS:
        raise
    except Exception as error:
        return Outcome(error=f"{type(error).__name__}: {error}", lasting=is_own_error(error))
    units = {f"unit {name}": unit for name, unit in history.scalar_units().items()}
    return Outcome(scalars=history.scalars() | units)


def _dataset(dimensions: list[Dimension], fixed: dict[str, Any], outcomes: list[Outcome]) -> xarray.Dataset:
    with extra("studies"):
        import xarray

    names = [one.name for one in dimensions]
    shape = [len(one.values) for one in dimensions]
    assert math.prod(shape) == len(outcomes)
    found = next((outcome.scalars for outcome in outcomes if not outcome.error), {})
    units = {name.removeprefix("unit "): unit for name, unit in found.items() if name.startswith("unit ")}
    units["obstacle_energy"] = units.get("dissipated_energy", "J")
    variables: dict[str, Any] = {}
    for name, unit in units.items():
        column = [outcome.scalars.get(name, np.nan) for outcome in outcomes]
        variables[name] = (names, np.array(column, dtype=np.float64).reshape(shape), {"units": str(unit)})
    errors = np.array([outcome.error for outcome in outcomes], dtype=object).reshape(shape)
    variables["error"] = (names, errors, {"long_name": "error of a failed point"})
    coordinates: dict[str, Any] = {
        one.name: ([one.name], one.labels(), {"units": one.unit or UNITS.get(one.name, "")}) for one in dimensions
    }
    coordinates |= {name: value for name, value in fixed.items() if isinstance(value, int | float)}
    attributes = {"source": f"viscoroll {__version__}", "version": __version__, "commit": __commit__}
    return xarray.Dataset(variables, coordinates, attrs=attributes)
