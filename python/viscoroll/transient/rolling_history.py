"""Transient rolling step by step, with saved states."""

from __future__ import annotations

import threading
from dataclasses import dataclass, fields
from enum import Enum
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np

from .. import _core
from .._core import Start
from .._support.arguments import as_float, as_float_array, as_member, require_type
from .._support.errors import InvalidInput
from .._support.files import ending_in
from .._support.progress import ProgressLike, reporting
from .._support.result_warnings import warn
from .._support.scalars import with_scalars
from ..bodies import Counterbody, Mesh, RollingBody, core_counterbody
from ..bodies.si_hints import si_hints, unit_doubt
from .distance import as_angle
from .history_warnings import rest_warnings
from .options import HistoryKeywords, HistoryOptions, with_options
from .series import HISTORY_SCALARS, InstantFields
from .state_file import SUFFIX, read_state, write_state

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Instant", "RollingHistory", "RollingState"]


@with_scalars(_core.history_scalars())
@dataclass(frozen=True, slots=True, kw_only=True)
class Instant(InstantFields):
    """State of a history at one instant: the time series of `History`, as numbers.

    Attributes
    ----------
    %(scalars)s
    """


@dataclass(frozen=True, slots=True, eq=False)
class RollingState:
    """Complete state of a history: forces, displacements and retarded displacements of every material node.

    On the same machine and build, a history that continues from a state is identical to the last bit to one that was
    not interrupted. A state is valid only for the bodies, the mesh and the options of the history that produced it.

    Attributes
    ----------
    numbers : ndarray
        Numbers of the state, in an internal order of the library.
    bodies : str
        Text that describes both bodies with their lengths; empty if unknown. A history of other bodies rejects the
        state.

    Examples
    --------
    >>> from viscoroll import Mesh, RollingHistory, paper
    >>> stepper = RollingHistory(paper.ball(), load=100.0, mesh=Mesh(nodes_per_revolution=100), averaged_meshes=1)
    >>> state = stepper.state
    >>> later = stepper.advance(time=0.1, angle=0.2, load=100.0)
    >>> again = RollingHistory(paper.ball(), load=100.0, mesh=stepper.mesh, averaged_meshes=1, start=state)
    >>> again.current.time
    0.0
    """

    numbers: NDArray[np.float64]
    bodies: str = ""

    def __post_init__(self) -> None:
        """Check shape and type; a history that starts from the state checks the numbers."""
        numbers = as_float_array("numbers", self.numbers)
        if numbers.ndim != 1:
            raise InvalidInput("numbers", "must be one-dimensional", f"shape {numbers.shape}")
        object.__setattr__(self, "numbers", numbers)

    def save(self, path: str | Path) -> None:
        """Write the state to a file (``.state``) with a checksum and the version of viscoroll.

        Raises
        ------
        ValueError
            If the suffix is another one.
        """
        write_state(ending_in([SUFFIX], path), self.numbers, self.bodies)

    @classmethod
    def load(cls, path: str | Path) -> RollingState:
        """Read a state that `save` wrote.

        Raises
        ------
        ValueError
            If the suffix is another one, or the file is not a state, is damaged, or was written by another version.
        OSError
            If the file cannot be read.
        """
        return cls(*read_state(ending_in([SUFFIX], path)))


@with_options
class RollingHistory:
    """Transient rolling step by step, for equations of motion: `advance` computes the next state.

    The history only steps forward, which suits integrators with fixed steps, such as Newmark's method. To try a step,
    take it on ``copy.copy(stepper)``, which copies the state. Integrators that reject steps and go back, such as
    `scipy.integrate.solve_ivp`, need a torque that depends only on the current instant: `RollingResistance`.

    A pickled history contains the bodies, the arguments of the constructor and the `state`; the copy computes the
    tables again.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rolling body, with layers or rigid.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        Counterbody, with layers or rigid, same as in `viscoroll.solve`; by default the rigid plane.
    load : float, optional
        Normal load P at the first instant [N], for rollers per length [N/m], > 0. With an axle, the external force on
        it. Exactly one of load and `axle_height` is given.
    axle_height : float, optional
        Height of the axle at the first instant [m], r_o minus the penetration; the load is then a result.
    start : Start or str or RollingState, default Start.RELAXED
        State before the first instant: the load has rested on the body until the material has fully relaxed (RELAXED),
        the load is applied instantaneously (UNDEFORMED), or the state of another history.
    **options
        Same as in `HistoryOptions`.
    shortest_time, longest_time : float
        Range of times in which moduli with a continuous spectrum are resolved [s].
    time, angle : float
        First instant [s] and angle at it [rad]; not with a saved state.
    distance : float, optional
        Distance rolled along the track at the first instant [m], in place of the angle; r_o times the angle.
    progress : bool or callable, optional
        True shows a progress bar for the computation of the tables; a callable is called as progress(stage, fraction)
        about every 20 ms.

    Raises
    ------
    ValueError
        If an argument is out of range, or the method does not apply to the coating. The message contains parameter,
        value and allowed range.
    TypeError
        If an argument has the wrong type.

    Examples
    --------
    >>> from viscoroll import Mesh, paper
    >>> stepper = RollingHistory(paper.ball(), load=100.0, mesh=Mesh(nodes_per_revolution=200), averaged_meshes=1)
    >>> state = stepper.advance(time=0.05, angle=0.1, load=100.0)
    >>> state.resisting_torque > 0.0
    True
    """

    def __init__(
        self,
        body: RollingBody,
        *,
        on: Counterbody | None = None,
        load: float | None = None,
        axle_height: float | None = None,
        start: Start | str | RollingState = Start.RELAXED,
        shortest_time: float = 1e-4,
        longest_time: float = 1e4,
        time: float = 0.0,
        angle: float | None = None,
        distance: float | None = None,
        progress: ProgressLike = None,
        **options: Unpack[HistoryKeywords],
    ) -> None:
        require_type("body", body, RollingBody)
        first = 0.0 if angle is None and distance is None else as_angle(body, angle, distance)
        chosen = HistoryOptions(**options)  # type: ignore[arg-type]  # also accepts names of enum members
        initial: dict[str, Any] = (
            {"state": start.numbers}
            if isinstance(start, RollingState)
            else {"start": as_member("start", start, Start), "time": as_float("time", time), "angle": first}
        )
        if isinstance(start, RollingState) and start.bodies not in ("", both := _bodies_text(body, on)):
            raise InvalidInput("start", f"must be a state of {both}", f"a state of {start.bodies}")
        self.body = body
        self.on = on
        times = {
            "shortest_time": as_float("shortest_time", shortest_time),
            "longest_time": as_float("longest_time", longest_time),
        }
        self._given = {**_support(load, axle_height), **times}
        self._options = chosen
        with reporting(progress) as report, si_hints(body, on):
            self._history = _core.RollingHistory(
                body._to_core(),
                core_counterbody(on),
                load=0.0 if load is None else self._given["load"],
                axle_height=self._given.get("axle_height"),
                options=chosen._to_core(**times),
                progress=report,
                **initial,
            )
        is_relaxed = not isinstance(start, RollingState) and initial["start"] is Start.RELAXED
        warn(filter(None, [unit_doubt(body, on), *(rest_warnings(body, on) if is_relaxed else [])]))
        self._lock = threading.Lock()

    def advance(
        self,
        *,
        time: float,
        angle: float | None = None,
        distance: float | None = None,
        load: float | None = None,
        axle_height: float | None = None,
        center_displacement: float | None = None,
    ) -> Instant:
        """Continue to a new instant, with angle and load linear in time, and return the state there.

        Parameters
        ----------
        time : float
            New time [s], ≥ the current time; equal to the current time for a jump.
        angle : float, optional
            New angle ψ [rad].
        distance : float, optional
            New distance rolled along the track [m], in place of the angle; r_o ψ.
        load : float, optional
            New normal load P [N], for rollers per length [N/m], ≥ 0; at 0 the body has lifted off. With an axle, the
            external force on it. Exactly one of load and `axle_height` is given.
        axle_height : float, optional
            New height of the axle [m], r_o minus the penetration; the load is then a result.
        center_displacement : float, optional
            New displacement of the center since the first instant [m]; requires friction. By default the forces
            determine it.

        Returns
        -------
        Instant
            State at the new instant.

        Raises
        ------
        ValueError
            If an argument is out of range, or friction cannot balance the drive; the history is then unchanged.
        ConvergenceError
            If the solver finds no contact; the history is then unchanged.
        """
        turned = as_angle(self.body, angle, distance)
        moved = None if center_displacement is None else as_float("center_displacement", center_displacement)
        support = _support(load, axle_height)
        with self._lock, si_hints(self.body, self.on):
            self._history.advance(
                time=as_float("time", time),
                angle=turned,
                center_displacement=moved,
                load=support.get("load", 0.0),
                axle_height=support.get("axle_height"),
            )
            return _instant(self._history.current())

    @property
    def current(self) -> Instant:
        """Forces, displacements and powers at the current instant."""
        with self._lock:
            return _instant(self._history.current())

    @property
    def state(self) -> RollingState:
        """State of the history at the current instant, from which another history can continue."""
        with self._lock:
            return RollingState(self._history.state(), _bodies_text(self.body, self.on))

    @property
    def contact(self) -> _core.ContactField:
        """Pressure around the contact on the first phase-shifted mesh, as `time`, `x`, `z` and `pressure`."""
        with self._lock:
            return self._history.contact()

    @property
    def mesh(self) -> Mesh:
        """Mesh of the history."""
        return Mesh._from_core(self._history.mesh)

    @property
    def spectrum_error(self) -> float:
        """Largest relative error of the compliance due to discrete retardation times [-]."""
        return self._history.spectrum_error

    @property
    def steps(self) -> int:
        """Number of time steps taken."""
        with self._lock:
            return self._history.steps

    def __copy__(self) -> RollingHistory:
        """Return an independent history that continues from the current state."""
        twin = object.__new__(type(self))
        twin.body, twin.on = self.body, self.on
        twin._given, twin._options = self._given, self._options
        twin._lock = threading.Lock()
        with self._lock:
            twin._history = self._history.copy()
        return twin

    def __deepcopy__(self, memo: dict[int, Any]) -> RollingHistory:
        """Return the same as `copy.copy`, which shares only immutable data."""
        return self.__copy__()

    def __reduce__(self) -> tuple[partial[RollingHistory], tuple[()]]:
        """Pickle through the constructor, which continues from the state on the same mesh."""
        given: dict[str, Any] = {option.name: getattr(self._options, option.name) for option in fields(self._options)}
        given |= {**self._given, "mesh": self.mesh}
        return partial(type(self), self.body, on=self.on, start=self.state, **given), ()

    def __repr__(self) -> str:
        """Return bodies, time, angle, load and mesh."""
        pair = f"{self.body!r}" if self.on is None else f"{self.body!r}, on={self.on!r}"
        instant = self.current
        values = f"time={instant.time:g}, angle={instant.angle:g}, load={instant.load:g}"
        return f"RollingHistory({pair}, {values}, {self.mesh})"


def _support(load: float | None, axle_height: float | None) -> dict[str, float]:
    """Return the load or the height of the axle, by name."""
    given = {"load": load, "axle_height": axle_height}
    values = {name: as_float(name, value) for name, value in given.items() if value is not None}
    if len(values) != 1:
        raise ValueError(f"exactly one of load and axle_height must be given, got {'both' if values else 'none'}")
    return values


def _bodies_text(body: RollingBody, on: Counterbody | None) -> str:
    """Return the types and lengths of both bodies as text; the core compares their layers."""
    return " on ".join("rigid plane" if one is None else _body_text(one) for one in (body, on))


def _body_text(body: RollingBody | Counterbody) -> str:
    values = {part.name: getattr(body, part.name) for part in fields(body) if part.name not in ("layers", "base")}
    texts = [f"{name}={value.name if isinstance(value, Enum) else repr(value)}" for name, value in values.items()]
    return f"{type(body).__name__}({', '.join(texts)})"


def _instant(instant: _core.RollingInstant) -> Instant:
    return Instant(**{name: getattr(instant, name) for name in HISTORY_SCALARS})
