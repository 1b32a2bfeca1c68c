"""Transient rolling along a given motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Unpack

import numpy as np

from .. import _core
from .._core import Start
from .._support.arguments import as_float_array, as_member, require_type
from .._support.errors import InvalidInput, Range
from .._support.files import ending_in
from .._support.progress import ProgressLike, Report, reporting
from .._support.result_warnings import warn
from ..bodies import Counterbody, RollingBody
from ..bodies.si_hints import si_hints
from .distance import as_angles
from .history import ContactInstant, History
from .history_warnings import ground_warnings, local_height, strain_warnings, time_warnings
from .options import HistoryKeywords, HistoryOptions, with_options
from .rolling_history import RollingHistory, RollingState, require_one_support
from .series import HISTORY_SCALARS
from .state_file import SUFFIX

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from numpy.typing import ArrayLike, NDArray

__all__ = ["roll"]


@with_options
def roll(
    body: RollingBody,
    *,
    on: Counterbody | None = None,
    time: ArrayLike,
    angle: ArrayLike | None = None,
    distance: ArrayLike | None = None,
    load: ArrayLike | None = None,
    axle_height: ArrayLike | None = None,
    center_displacement: ArrayLike | None = None,
    start: Start | str | RollingState = Start.RELAXED,
    shortest_time: float | None = None,
    longest_time: float | None = None,
    contact_times: ArrayLike = (),
    checkpoint: str | Path | None = None,
    receive: Callable[[dict[str, NDArray[np.float64]]], object] | None = None,
    progress: ProgressLike = None,
    **options: Unpack[HistoryKeywords],
) -> History:
    """Compute transient rolling along a motion that is linear in time between waypoints.

    The motion may contain starts, stops, rests, reversals, jumps and changes of load.
    The call releases the GIL and stops on Ctrl-C. Torques and forces are those of linear theory. In steady rolling,
    the ratio of `Result.finite_strain_torque` to `Result.resisting_torque` is the correction for finite strain.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rolling body, with layers or rigid.
    on : CoatedPlane, Groove, CoatedSphere, CoatedCylinder or CoatedWheel, optional
        Counterbody, with layers or rigid, same as in `viscoroll.solve`; by default the rigid plane. The material of a
        plane or a groove stays in place and recovers with time: on its way back, the body rolls over the remaining dent
        of its earlier passage.
    time : array_like
        Times of the waypoints [s], not decreasing. Two equal times are a jump, which requires a coating with an
        instantaneous compliance.
    angle : array_like, optional
        Angle ψ turned at the waypoints [rad]; the body rolls forward if it increases.
    distance : array_like, optional
        Distance rolled along the track at the waypoints [m], in place of the angle: r_o ψ, the displacement of the
        contact without slip.
    load : array_like or float, optional
        Normal load P at the waypoints [N], for rollers per length [N/m], ≥ 0, and > 0 at the first one; a number for
        all waypoints. At 0 the body has lifted off. With an axle, the external force on it. Exactly one of load and
        `axle_height` is given.
    axle_height : array_like or float, optional
        Height of the axle at the waypoints [m], r_o minus the penetration; the load is then a result. At the first
        waypoint, the height is smaller than r_o. Not with an axle.
    center_displacement : array_like, optional
        Displacement of the center at the waypoints [m], starting from 0; requires friction. By default the forces
        determine it.
    start : Start or str or RollingState, default Start.RELAXED
        State before the first waypoint: the load has rested on the body until the material has fully relaxed (RELAXED),
        the load is applied instantaneously (UNDEFORMED), or the state of another history, at a time between the
        waypoints, from which the motion continues.
    **options
        Same as in `HistoryOptions`.
    shortest_time, longest_time : float, optional
        Range of times in which moduli with a continuous spectrum are resolved [s]. By default from a tenth of a step
        while the body rolls to ten times the duration of the motion.
    contact_times : array_like, optional
        Times at which the pressure is recorded [s], between the first and the last waypoint.
    checkpoint : path-like, optional
        File (``.state``) for the state of a run that is interrupted or fails. Continue the run with
        ``start=RollingState.load(checkpoint)``.
    receive : callable, optional
        Function that is called with the first instant, and then every few steps with the new instants, as a dictionary
        of the time series of `History`. An exception that it raises ends the computation and propagates.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    History
        Time series of torque, penetration and energies at every step.

    Raises
    ------
    ValueError
        If an argument is out of range, the method does not apply to the coating, or friction cannot balance the drive.
        The message contains parameter, value and allowed range.
    TypeError
        If an argument has the wrong type.
    ConvergenceError
        If the solver finds no contact.
    KeyboardInterrupt
        On Ctrl-C, within 0.3 s.

    Warns
    -----
    ResultWarning
        If the motion lasts longer than the times for which a material is measured or defined, if the state at rest of a
        loss factor is an extrapolation, or if the strain is above 0.2.

    Examples
    --------
    >>> from viscoroll import Mesh, paper
    >>> h = roll(paper.ball(), time=[0.0, 0.2], angle=[0.0, 0.5], load=100.0, mesh=Mesh(nodes_per_revolution=100))
    >>> f"{h.resisting_torque.max() * 1e3:.0f} mN m to break away"
    '53 mN m to break away'

    A steel ball on a rubber mat:

    >>> from viscoroll import CoatedPlane, CoatedSphere
    >>> mat, ball = CoatedPlane(layers=paper.ball().layers), CoatedSphere(core_radius=21e-3)
    >>> h = roll(ball, on=mat, time=[0.0, 0.2], distance=[0.0, 0.0105], load=100.0, mesh=Mesh(nodes_per_revolution=100))
    >>> f"{h.driving_force.max():.1f} N to break away"
    '2.5 N to break away'
    """
    require_type("body", body, RollingBody)
    chosen = HistoryOptions(**options)  # type: ignore[arg-type]  # also accepts names of enum members
    start = start if isinstance(start, RollingState) else as_member("start", start, Start)
    if checkpoint is not None:
        checkpoint = ending_in([SUFFIX], checkpoint, name="checkpoint")
        if not checkpoint.parent.is_dir():
            raise InvalidInput("checkpoint", "must be in a folder that exists", repr(str(checkpoint)))
    _require_length("distance", distance, time)
    motion = _motion(
        time=time,
        angle=as_angles(body, angle, distance),
        load=load,
        axle_height=axle_height,
        center_displacement=center_displacement,
    )
    waypoints, angles = motion["time"], motion["angle"]
    shortest, longest = _core.time_range(
        _core_motion(motion), None if chosen.mesh is None else chosen.mesh._to_core(), chosen.steps_per_spacing
    )
    with reporting(progress) as report:
        stepper = RollingHistory(
            body,
            on=on,
            **{name: float(motion[name][0]) for name in ("load", "axle_height") if name in motion},
            start=start,
            shortest_time=shortest if shortest_time is None else shortest_time,
            longest_time=longest if longest_time is None else longest_time,
            time=float(waypoints[0]),
            angle=float(angles[0]),
            progress=report,
            **options,
        )
        pieces, contacts = _follow(stepper, motion, contact_times, checkpoint, receive, report)
    rows = {name: _joined([piece[name] for piece in pieces]) for name in HISTORY_SCALARS}
    duration = float(waypoints[-1] - waypoints[0])
    messages = [*time_warnings(body, on, duration=duration)]
    passed, penetration = body.outer_radius * np.asarray(rows["angle"]), np.asarray(rows["penetration"])
    messages += ground_warnings(body, stepper.mesh, chosen, passed)
    if chosen.ground is not None or chosen.tread is not None:
        penetration = penetration + local_height(body, chosen, passed, np.asarray(rows["contact_length"]))
    messages += strain_warnings(body, on, penetration)
    warn(messages)
    return History(
        body=body,
        on=on,
        mesh=stepper.mesh,
        start=start if isinstance(start, Start) else None,
        compliance=chosen.compliance,
        curvature=chosen.curvature,
        friction=chosen.friction,
        drive=chosen.drive,
        mass=chosen.mass,
        ground=chosen.ground,
        tread=chosen.tread,
        axle=chosen.axle,
        averaged_meshes=chosen.averaged_meshes,
        spectrum_error=stepper.spectrum_error,
        contacts=tuple(contacts),
        state=stepper.state,
        **rows,
    )


def _follow(
    stepper: RollingHistory,
    motion: dict[str, NDArray[np.float64]],
    contact_times: ArrayLike,
    checkpoint: str | Path | None,
    receive: Callable[[dict[str, NDArray[np.float64]]], object] | None,
    report: Report | None,
) -> tuple[list[dict[str, NDArray[np.float64]]], list[ContactInstant]]:
    """Return the time series up to each stop, and the contacts at `contact_times`; on failure, save the state."""
    core = stepper._history
    pieces: list[dict[str, NDArray[np.float64]]] = []
    contacts: list[ContactInstant] = []
    if receive is not None:
        first = core.current()
        receive({name: np.array([getattr(first, name)]) for name in HISTORY_SCALARS})
    try:
        for stop in _stops(motion["time"], contact_times):
            if stop < core.current().time:
                continue
            with si_hints(stepper.body, stepper.on):
                piece = core.roll(_until(stop, motion), receive=receive and _receiver(receive), progress=report)
            pieces.append(_series_of(piece))
            if stop in np.asarray(contact_times):
                contacts.append(ContactInstant._from_core(stepper.contact))
    except BaseException:
        if checkpoint is not None:
            stepper.state.save(checkpoint)
        raise
    return pieces, contacts


def _receiver(receive: Callable[[dict[str, NDArray[np.float64]]], object]) -> Callable[[_core.InstantSeries], None]:
    def received(instants: _core.InstantSeries) -> None:
        receive(_series_of(instants))

    return received


def _series_of(instants: _core.InstantSeries) -> dict[str, NDArray[np.float64]]:
    return {name: getattr(instants, name) for name in HISTORY_SCALARS}


def _joined(pieces: list[NDArray[np.float64]]) -> NDArray[np.float64]:
    """Return one time series; each piece except the first repeats the last instant of the previous piece."""
    return np.concatenate([pieces[0], *(piece[1:] for piece in pieces[1:])])


def _motion(**waypoints: ArrayLike | None) -> dict[str, NDArray[np.float64]]:
    """Return the given quantities at the waypoints as arrays of equal length; the core checks their values."""
    require_one_support(waypoints["load"], waypoints["axle_height"])
    arrays = {name: as_float_array(name, values) for name, values in waypoints.items() if values is not None}
    support = "load" if "load" in arrays else "axle_height"
    if arrays[support].ndim == 0:
        arrays[support] = np.full_like(arrays["time"], arrays[support])
    for name, values in arrays.items():
        if values.ndim != 1:
            raise InvalidInput(name, "must be one-dimensional", f"shape {values.shape}")
        _require_length(name, values, arrays["time"])
    if len(arrays["time"]) < 2:
        raise InvalidInput("time", "must have at least two waypoints", f"{len(arrays['time'])}")
    _core.check_motion(_core_motion(arrays))
    return arrays


def _require_length(name: str, values: ArrayLike | None, time: ArrayLike) -> None:
    if values is not None and np.size(values) != np.size(time):
        raise InvalidInput(name, f"must be as long as time ({np.size(time)})", f"{np.size(values)}")


def _core_motion(motion: dict[str, NDArray[np.float64]]) -> _core.Motion:
    return _core.Motion(**{name: values.tolist() for name, values in motion.items()})


def _stops(time: NDArray[np.float64], contact_times: ArrayLike) -> list[float]:
    """Return the instants at which the computation stops: the contact times and the end of the motion."""
    instants = as_float_array("contact_times", contact_times).ravel()
    motion = Range(float(time[0]), float(time[-1]), "s")
    for instant in instants:
        if instant not in motion:
            raise motion.error("contact_times", f"{instant:g}")
    return sorted({*instants.tolist(), float(time[-1])})


def _until(stop: float, motion: dict[str, NDArray[np.float64]]) -> _core.Motion:
    """Return the waypoints up to an instant, with the interpolated motion at that instant."""
    before = motion["time"] <= stop
    waypoints = {name: values[before] for name, values in motion.items()}
    if waypoints["time"][-1] < stop:
        there = {name: np.interp(stop, motion["time"], values) for name, values in motion.items()}
        waypoints = {name: np.append(values, there[name]) for name, values in waypoints.items()}
    return _core_motion(waypoints)
