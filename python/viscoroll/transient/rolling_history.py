"""A ball on its way: state in, state out."""

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
from .._support.cautions import warn
from .._support.files import ending_in
from .._support.progress import ProgressLike, reporting
from .._support.scalars import with_scalars
from ..bodies import Counterpart, Mesh, RollingBody, core_counterpart
from ..bodies.si_hints import si_hints, unit_doubt
from .options import HistoryKeywords, HistoryOptions, with_options
from .series import HISTORY_SCALARS, InstantFields
from .state_file import SUFFIX, read_state, write_state
from .way import as_angle

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Instant", "RollingHistory", "RollingState"]


@with_scalars(_core.history_scalars())
@dataclass(frozen=True, slots=True, kw_only=True)
class Instant(InstantFields):
    """A history at an instant: the time series of `History`, as numbers.

    Attributes
    ----------
    %(scalars)s
    """


@dataclass(frozen=True, slots=True, eq=False)
class RollingState:
    """Everything that a history remembers: forces and displacements, retarded ones too, of every material node.

    What goes on from it is the same to the last bit as what was not interrupted, on one machine and build.

    It belongs to a ball, a mesh and the options of the history that it is from.

    Attributes
    ----------
    numbers : ndarray
        In an order of the library's own.
    bodies : str
        Both bodies with their lengths; empty if unknown. A history of other bodies refuses the state.

    Examples
    --------
    >>> from viscoroll import Mesh, RollingHistory, paper
    >>> stepper = RollingHistory(paper.ball(), load=100.0, mesh=Mesh(nodes_per_revolution=100), lattices=1)
    >>> state = stepper.state
    >>> later = stepper.advance(time=0.1, angle=0.2, load=100.0)
    >>> again = RollingHistory(paper.ball(), load=100.0, mesh=stepper.mesh, lattices=1, start=state)
    >>> again.now.time
    0.0
    """

    numbers: NDArray[np.float64]
    bodies: str = ""

    def __post_init__(self) -> None:
        """Settle shape and type; a history that starts from them checks the numbers."""
        numbers = as_float_array("numbers", self.numbers)
        if numbers.ndim != 1:
            raise ValueError(f"numbers must be one-dimensional, got shape {numbers.shape}")
        object.__setattr__(self, "numbers", numbers)

    def save(self, path: str | Path) -> None:
        """Write the state to a file (``.state``) with a checksum and the version of viscoroll.

        Raises
        ------
        ValueError
            For another suffix.
        """
        write_state(ending_in([SUFFIX], path), self.numbers, self.bodies)

    @classmethod
    def load(cls, path: str | Path) -> RollingState:
        """Read a state that `save` wrote.

        Raises
        ------
        ValueError
            For another suffix, and for a file that is not a state, is damaged, or was written by another version.
        OSError
            If the file cannot be read.
        """
        return cls(*read_state(ending_in([SUFFIX], path)))


@with_options
class RollingHistory:
    """A body on its way, for equations of motion: `advance` takes it from one state to the next.

    Its steps are fixed-step steps, as of Newmark's rule: they go forward, each for good. ``copy.copy(stepper)`` is
    another history from here on, at the price of the memory's copy: to try a step and take it back. Integrators that
    choose steps, reject some and go back, as `scipy.integrate.solve_ivp`, need a torque of the instant alone:
    `RollingResistance`.

    A history pickles as its bodies, what it was told of how to compute, and its `state`; tables are made anew where
    it is read.

    Parameters
    ----------
    ball : CoatedSphere, CoatedCylinder or CoatedWheel
        What rolls, with layers or rigid.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        What it rolls on, as of `viscoroll.solve`, with layers likewise; without it the rigid plane.
    load : float
        P at the first instant [N], of a roller per length [N/m], > 0.
    start : Start or str or RollingState, default Start.RELAXED
        What was before: the body has borne the load for ever (RELAXED), is pressed on in no time (FRESH), or comes from
        another history.
    **options
        As of `HistoryOptions`.
    shortest_time, longest_time : float
        Between which moduli with a continuous spectrum are resolved [s].
    time, angle : float
        Of the first instant [s], [rad]; not with a state.
    way : float, optional
        Of the contact along the track at the first instant [m], in place of the angle: r_o times it.

    Raises
    ------
    ValueError
        For bad input, and for coatings that this method is not for; the message names parameter, value and range.
    TypeError
        For arguments of another type.

    Examples
    --------
    >>> from viscoroll import Mesh, paper
    >>> stepper = RollingHistory(paper.ball(), load=100.0, mesh=Mesh(nodes_per_revolution=200), lattices=1)
    >>> state = stepper.advance(time=0.05, angle=0.1, load=100.0)
    >>> state.resisting_torque > 0.0
    True
    """

    def __init__(
        self,
        ball: RollingBody,
        *,
        on: Counterpart | None = None,
        load: float,
        start: Start | str | RollingState = Start.RELAXED,
        shortest_time: float = 1e-4,
        longest_time: float = 1e4,
        time: float = 0.0,
        angle: float | None = None,
        way: float | None = None,
        progress: ProgressLike = None,
        **options: Unpack[HistoryKeywords],
    ) -> None:
        require_type("ball", ball, RollingBody)
        first = 0.0 if angle is None and way is None else as_angle(ball, angle, way)
        chosen = HistoryOptions(**options)  # type: ignore[arg-type]  # names of members, too
        before: dict[str, Any] = (
            {"state": start.numbers}
            if isinstance(start, RollingState)
            else {"start": as_member("start", start, Start), "time": as_float("time", time), "angle": first}
        )
        if isinstance(start, RollingState) and start.bodies not in ("", both := _bodies_text(ball, on)):
            raise ValueError(f"start must be a state of {both}, got one of {start.bodies}")
        self.ball = ball
        self.on = on
        times = {
            "shortest_time": as_float("shortest_time", shortest_time),
            "longest_time": as_float("longest_time", longest_time),
        }
        self._given = {"load": as_float("load", load), **times}
        self._options = chosen
        with reporting(progress) as report, si_hints(ball, on):
            self._history = _core.RollingHistory(
                ball._to_core(),
                core_counterpart(on),
                load=self._given["load"],
                options=chosen._to_core(**times),
                progress=report,
                **before,
            )
        warn(filter(None, [unit_doubt(ball, on)]))
        self._lock = threading.Lock()

    def advance(
        self,
        *,
        time: float,
        angle: float | None = None,
        way: float | None = None,
        load: float,
        center_way: float | None = None,
    ) -> Instant:
        """Turn and load linearly in time.

        Parameters
        ----------
        time : float
            [s], not before now; now for a jump.
        angle : float, optional
            ψ [rad].
        way : float, optional
            Of the contact along the track [m], in place of the angle: r_o ψ.
        load : float
            P [N], ≥ 0; at 0 the body has lifted off.
        center_way : float, optional
            Of the center since the first instant [m], with friction; left out, forces move it.

        Returns
        -------
        Instant
            The end.

        Raises
        ------
        ValueError
            For bad input, and for a drive that friction cannot balance; the history is then as it was before.
        ConvergenceError
            Where no contact was found; likewise.
        """
        turned = as_angle(self.ball, angle, way)
        moved = None if center_way is None else as_float("center_way", center_way)
        with self._lock, si_hints(self.ball, self.on):
            self._history.advance(
                time=as_float("time", time), angle=turned, load=as_float("load", load), center_way=moved
            )
            return _instant(self._history.now())

    @property
    def now(self) -> Instant:
        """The instant reached."""
        with self._lock:
            return _instant(self._history.now())

    @property
    def state(self) -> RollingState:
        """What is needed to go on from here."""
        with self._lock:
            return RollingState(self._history.state(), _bodies_text(self.ball, self.on))

    @property
    def contact(self) -> _core.ContactField:
        """Pressure on the nodes of the first lattice around the contact, by `time`, `x`, `z` and `pressure`."""
        with self._lock:
            return self._history.contact()

    @property
    def mesh(self) -> Mesh:
        """The mesh."""
        return Mesh._from_core(self._history.mesh)

    @property
    def spectrum_error(self) -> float:
        """Largest relative error of the compliance by discrete retardation times [-]."""
        return self._history.spectrum_error

    @property
    def steps(self) -> int:
        """Steps of time taken."""
        with self._lock:
            return self._history.steps

    def __copy__(self) -> RollingHistory:
        """Return a history that goes on from here by itself."""
        twin = object.__new__(type(self))
        twin.ball, twin.on = self.ball, self.on
        twin._given, twin._options = self._given, self._options
        twin._lock = threading.Lock()
        with self._lock:
            twin._history = self._history.copy()
        return twin

    def __deepcopy__(self, memo: dict[int, Any]) -> RollingHistory:
        """Return the same as of `copy.copy`: nothing that could change is shared."""
        return self.__copy__()

    def __reduce__(self) -> tuple[partial[RollingHistory], tuple[()]]:
        """Pickle by way of the constructor, which goes on from the state, on the mesh that was chosen."""
        given: dict[str, Any] = {option.name: getattr(self._options, option.name) for option in fields(self._options)}
        given |= {**self._given, "mesh": self.mesh}
        return partial(type(self), self.ball, on=self.on, start=self.state, **given), ()

    def __repr__(self) -> str:
        """Return where it is."""
        now = self.now
        pair = f"{self.ball!r}" if self.on is None else f"{self.ball!r}, on={self.on!r}"
        return f"RollingHistory({pair}, time={now.time:g}, angle={now.angle:g}, load={now.load:g}, {self.mesh})"


def _bodies_text(ball: RollingBody, on: Counterpart | None) -> str:
    """Return kinds and lengths of both bodies; the core compares their layers."""
    return " on ".join("rigid plane" if body is None else _body_text(body) for body in (ball, on))


def _body_text(body: RollingBody | Counterpart) -> str:
    values = {part.name: getattr(body, part.name) for part in fields(body) if part.name not in ("layers", "base")}
    texts = [f"{name}={value.name if isinstance(value, Enum) else repr(value)}" for name, value in values.items()]
    return f"{type(body).__name__}({', '.join(texts)})"


def _instant(now: _core.RollingInstant) -> Instant:
    return Instant(**{name: getattr(now, name) for name in HISTORY_SCALARS})
