"""Twins of a history, whose results follow from it: mirrored, in other units, elsewhere on the track, interrupted."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
import viscoroll as vr

from ..twins import LENGTH, STRESS, TIME, scaled_body
from .cases import HistoryCase
from .invariants import scales

__all__ = ["Twin", "twins"]

#: Products with powers of two are exact, so a larger difference indicates a constant with a unit in the solver.
SCALING_TOLERANCE = 1e-8

#: Tolerance of mirror images and other places, whose sums have other round-off; instants are solved to 1e-10 at least,
#: and later ones inherit the error.
TOLERANCE = 1e-6

#: Exponents of length, stress and time by which the series scale; forces per length have one power of length less.
SERIES = {
    "resisting_torque": (3, 1, 0),
    "driving_torque": (3, 1, 0),
    "driving_force": (2, 1, 0),
    "penetration": (1, 0, 0),
    "max_pressure": (0, 1, 0),
    "stored_energy": (3, 1, 0),
    "dissipated_energy": (3, 1, 0),
    "slip_energy": (3, 1, 0),
    "work": (3, 1, 0),
    "center_displacement": (1, 0, 0),
}
NEVER_PER_LENGTH = ("penetration", "max_pressure", "center_displacement")

#: Series that change sign with the sense of rolling.
ODD = ("resisting_torque", "driving_torque", "driving_force", "center_displacement")


@dataclass(frozen=True, kw_only=True)
class Twin:
    """A history that follows from another.

    Attributes
    ----------
    kind : str
        Name of the transformation.
    case : HistoryCase
        The transformed history.
    differences : callable
        Called with the history of the case and of the twin; returns those differences that exceed the tolerance, by
        name, in multiples of the tolerance.
    roll : callable
        Function that computes the history, by default `viscoroll.roll`.
    """

    kind: str
    case: HistoryCase
    differences: Callable[[vr.History, vr.History], dict[str, float]]
    roll: Callable[..., vr.History] = vr.roll


def twins(case: HistoryCase) -> Iterator[Twin]:
    """Yield all twins of a case."""
    yield Twin(kind="mirror", case=_mirrored(case), differences=partial(_differences, odd=-1.0, allowed=TOLERANCE))
    yield Twin(kind="scaling", case=_scaled(case), differences=_scaling_differences)
    yield Twin(kind="elsewhere", case=_elsewhere(case), differences=partial(_differences, allowed=TOLERANCE))
    yield Twin(kind="interrupted", case=case, differences=_last_bits, roll=_in_two)


def _changed(case: HistoryCase, **changes: Any) -> HistoryCase:
    return replace(case, arguments=case.arguments | changes)


def _mirrored(case: HistoryCase) -> HistoryCase:
    given = case.arguments
    changes: dict[str, Any] = {"angle": [-angle for angle in given["angle"]]}
    if "center_displacement" in given:
        changes["center_displacement"] = [-displacement for displacement in given["center_displacement"]]
    if "center_speed" in given:
        changes["center_speed"] = -given["center_speed"]
    if "drive" in given and given["drive"].force:
        changes["drive"] = vr.Drive(force=-given["drive"].force)
    return _changed(case, **changes)


def _scaled(case: HistoryCase) -> HistoryCase:
    given = case.arguments
    force = STRESS * LENGTH**2 / (LENGTH if case.body.line_contact else 1.0)
    units = {
        "time": TIME,
        "shortest_time": TIME,
        "longest_time": TIME,
        "load": force,
        "center_displacement": LENGTH,
        "center_speed": LENGTH / TIME,
        "mass": force * TIME**2 / LENGTH,
    }
    changes: dict[str, Any] = {
        name: (unit * np.asarray(given[name])).tolist() for name, unit in units.items() if name in given
    }
    if "drive" in given and given["drive"].force is not None:
        changes["drive"] = vr.Drive(force=force * given["drive"].force)
    if case.on is not None:
        changes["on"] = scaled_body(case.on)
    return replace(_changed(case, **changes), body=scaled_body(case.body))


def _elsewhere(case: HistoryCase) -> HistoryCase:
    """Return the same motion, started at a distant node."""
    on = 16.0 * case.arguments["mesh"].spacing
    return _changed(case, angle=[angle + on for angle in case.arguments["angle"]])


def _in_two(body: vr.bodies.RollingBody, **arguments: Any) -> vr.History:
    """Roll to a waypoint in the middle, and continue from its state; return the second part."""
    first = slice(len(arguments["time"]) // 2 + 1)
    waypoints = {
        name: arguments[name][first] for name in ("time", "angle", "load", "center_displacement") if name in arguments
    }
    return vr.roll(body, **(arguments | {"start": vr.roll(body, **(arguments | waypoints)).state}))


def _scaling_differences(one: vr.History, other: vr.History) -> dict[str, float]:
    return _differences(one, other, scaled=True, allowed=SCALING_TOLERANCE)


def _differences(
    one: vr.History, other: vr.History, *, odd: float = 1.0, scaled: bool = False, allowed: float
) -> dict[str, float]:
    if len(one.time) != len(other.time):
        return {"steps": float("inf")}
    sizes = scales(one)
    found: dict[str, float] = {}
    for name, powers in SERIES.items():
        length, stress, time = powers
        per_length = LENGTH if one.body.line_contact and name not in NEVER_PER_LENGTH else 1.0
        unit = LENGTH**length * STRESS**stress * TIME**time / per_length if scaled else 1.0
        sign = odd if name in ODD else 1.0
        # the approach may be undefined
        difference = np.nan_to_num(sign * getattr(other, name) / unit - getattr(one, name))
        found[name] = float(np.abs(difference).max()) / (allowed * sizes[name])
    return {name: value for name, value in found.items() if not value <= 1.0}


def _last_bits(one: vr.History, rest: vr.History) -> dict[str, float]:
    """Return the series that differ in any bit after the middle."""
    after = slice(len(one.time) - len(rest.time), None)
    series = rest._series()
    return {
        name: float("inf")
        for name, values in one._series().items()
        if not np.array_equal(values[after], series[name], equal_nan=True)
    }
