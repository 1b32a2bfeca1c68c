"""Relations that hold in any history."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import viscoroll as vr
from numpy.typing import NDArray
from viscoroll import enums

from ..bodies import curvature, deforms
from .cases import HistoryCase

__all__ = ["is_finite", "is_without_datum", "nodes_of", "scales", "step_error", "turnover", "violations"]

#: Tolerance relative to the size of a series. Instants are solved to residuals of 1e-12, or 1e-10 if the solver stalls;
#: sums of forces and moments, and sums over hundreds of instants, are allowed more.
TOLERANCE = 1e-7

#: Relative energy that friction may supply where a node reverses within a step, since the mean traction then differs
#: from that weighted by the work: up to 1.5e-3 of all energy in 100 histories with two to eight steps per spacing on
#: coarse meshes. For a body that slides as a whole, `_turned_back` bounds an additional part.
TURNED_BACK = 3e-3

#: Series that may be undefined: approach and height of the axle on a half-plane, width of a line contact, error
#: estimate of a single mesh.
UNTOLD = ("penetration", "axle_height", "semi_axis_z", "error_estimate")


def violations(case: HistoryCase, history: vr.History) -> dict[str, float]:
    """Return the conditions that a history violates, each with its error relative to the tolerance."""
    if not is_finite(history):
        return {"not finite": math.inf}
    checks = (_motion, _lifted, _energies, _balance, _forces, *((_friction,) if case.has_friction else ()))
    errors = {name: error for check in checks for name, error in check(case, history)}
    return {name: error for name, error in errors.items() if not error <= 1.0}


def is_finite(history: vr.History) -> bool:
    """Return whether all series are finite, except those that are undefined for its pair."""
    series = {name: values for name, values in history._series().items() if name not in UNTOLD}
    told = {
        "penetration": not is_without_datum(history),
        "axle_height": not is_without_datum(history),
        "semi_axis_z": not history.body.line_contact,
        "error_estimate": history.averaged_meshes > 1,
    }
    series |= {name: getattr(history, name) for name, is_told in told.items() if is_told}
    return all(np.isfinite(values).all() for values in series.values())


def is_without_datum(history: vr.History) -> bool:
    """Return whether it is a line contact on a half-plane, which has no reference height."""
    return history.body.line_contact and getattr(history.on, "base", None) is not None


def scales(history: vr.History) -> dict[str, float]:
    """Return the size of each series where no terms cancel."""
    radius = history.body.outer_radius
    load = float(history.load.max())
    torque = load * max(float(history.semi_axis_x.max()), history.mesh.spacing * radius)
    force = max(torque / radius, min(history.friction, 1.0) * load)
    energy = turnover(history) + float(np.abs(history.stored_energy).max())
    distance = radius * float(np.ptp(history.angle)) + float(np.ptp(history.center_displacement))
    depth = np.abs(history.penetration)
    return {
        "resisting_torque": torque,
        "driving_torque": max(torque, force * radius),
        "driving_force": force,
        "penetration": 1.0 if np.isnan(depth).any() else float(depth.max()),
        "max_pressure": float(history.max_pressure.max()),
        "stored_energy": energy,
        "dissipated_energy": energy,
        "slip_energy": energy,
        "work": energy,
        "center_displacement": max(distance, 1e-3 * torque / load),
    }


def turnover(history: vr.History) -> float:
    """Return the energy that is exchanged: stored and released, and dissipated [J].

    With friction, the counterbody may dissipate less than zero, and so may the total.
    """
    return float(sum(np.abs(np.diff(series)).sum() for series in (history.stored_energy, history.dissipated_energy)))


def _motion(case: HistoryCase, history: vr.History) -> Iterator[tuple[str, float]]:
    given = case.arguments
    ends = (history.time[-1], history.angle[-1], history.load[-1])
    wanted = (given["time"][-1], given["angle"][-1], given["load"][-1])
    yield "time decreases", float((np.diff(history.time) < 0.0).any()) * 2.0
    yield "end differs from the last waypoint", float(ends != wanted) * 2.0
    # relative to the default tolerance
    yield "spectrum", history.spectrum_error / 0.01


def _lifted(case: HistoryCase, history: vr.History) -> Iterator[tuple[str, float]]:
    """Check that there is contact with load, and no contact without."""
    lifted = history.load == 0.0
    for name in ("resisting_torque", "driving_torque", "driving_force", "contact_area", "max_pressure"):
        # the driving force includes the inertia of the center
        if name == "driving_force" and history.mass > 0.0:
            continue
        yield f"{name} without load", 2.0 * float(np.any(getattr(history, name)[lifted] != 0.0))
    yield "no contact under load", 2.0 * float(np.any(history.contact_area[~lifted] <= 0.0))
    # A patch supports at most the largest pressure.
    borne = history.max_pressure * history.contact_area
    short = (history.load - borne)[~lifted] / history.load.max()
    # The patches of a ball on a rigid body are smaller away from the middle.
    slack = 1.0 if _is_ball_on_rigid(case) else 0.0
    yield "load > largest pressure times area", float(short.max(initial=0.0)) / TOLERANCE * (1.0 - slack)


def _is_ball_on_rigid(case: HistoryCase) -> bool:
    return isinstance(case.body, vr.CoatedSphere) and not deforms(case.on)


def _energies(case: HistoryCase, history: vr.History) -> Iterator[tuple[str, float]]:
    """Check that dissipation never decreases, and that stored energy is not negative if the approach has a datum.

    With friction, the dissipation of the counterbody includes the work of a center that moves more or less than the
    body rolls, which may be negative: docs/theory/transient-friction.md, "Energy balance".
    """
    energy = turnover(history) + float(np.abs(history.stored_energy).max())
    others = history.counterbody_dissipated_energy
    lost = {"body": history.dissipated_energy - history.slip_energy - others}
    if not case.has_friction:
        lost["counterbody"] = others
    for name, series in lost.items():
        yield f"energy gained in the {name}", -float(np.diff(series).min()) / (TOLERANCE * energy)
        if all(isinstance(modulus, vr.Elastic) for modulus in case.moduli):
            yield f"energy dissipated in the elastic {name}", float(np.abs(series).max()) / (TOLERANCE * energy)
    gained = -np.diff(history.slip_energy) - _turned_back(case, history)
    yield "energy gained by slip", float(gained.max()) / (TURNED_BACK * energy)
    if not is_without_datum(history):
        yield "stored energy < 0", -float(history.stored_energy.min()) / (TOLERANCE * energy)
        yield (
            "stored energy of the counterbody < 0",
            -float(history.counterbody_stored_energy.min()) / (TOLERANCE * energy),
        )


def _turned_back(case: HistoryCase, history: vr.History) -> NDArray[np.float64]:
    """Return the work that friction may seem to supply in a step in which the sliding of the body reverses [J].

    The step uses the mean of the traction before and after it. If both are at the limit of friction, in opposite
    directions, this mean falls short of the sliding traction by the limit, over the sliding distance.
    """
    if not case.has_friction:
        return np.zeros(history.time.size - 1)
    slid = np.diff(history.center_displacement) - case.body.outer_radius * np.diff(history.angle)
    turns = np.append(False, slid[1:] * slid[:-1] < 0.0)
    load = 0.5 * (history.load[1:] + history.load[:-1])
    return np.where(turns, min(history.friction, 2.0) * load * np.abs(slid), 0.0)


def _balance(case: HistoryCase, history: vr.History) -> Iterator[tuple[str, float]]:
    """Check that work equals stored plus dissipated energy, except for the error of the steps."""
    # the approach is undefined
    if is_without_datum(history):
        return
    allowed = step_error(case, history) + TOLERANCE * (turnover(history) + float(np.abs(history.stored_energy).max()))
    yield "energy balance", float(np.abs(history.energy_balance_residual).max()) / allowed


def step_error(case: HistoryCase, history: vr.History) -> float:
    """Return a bound of the imbalance of energy that the steps leave [J].

    Over a step, the forces F of the nodes are linear in time, but their displacements u are not: the error of the
    trapezoidal rule is at most ½ Σ|ΔF| |Δu|. A turn by Δψ moves a node of the contact by x/R_x r_o Δψ and transfers the
    forces within r_o Δψ of an end: at most P r_o²/R_x Δψ². A load that changes by ΔP leaves ½ ΔP Δd, and one that sinks
    in by Δd transfers the share Δd/d of itself, which leaves P Δd²/d. Sliding by s relative to the track leaves μ s
    times the transferred force, P r_o Δψ/a and ½ ΔP. Jumps leave nothing. Half of 40 histories with friction leave less
    than a hundredth of this bound; those whose load passes from node to node, up to 0.9 of it.
    """
    steps = np.diff(history.time) > 0.0
    radius = case.body.outer_radius
    load = np.maximum(history.load[1:], history.load[:-1])
    turn = np.diff(history.angle)
    sunk = np.abs(np.diff(history.penetration))
    deeper = np.maximum(history.penetration[1:], history.penetration[:-1])
    share = np.divide(sunk, deeper, out=np.ones_like(sunk), where=deeper > sunk)
    left = load * radius * (1.0 + radius * curvature(case.on)) * turn**2
    left = left + (0.5 * np.abs(np.diff(history.load)) + share * load) * sunk
    if case.has_friction:
        half_length = np.maximum(history.semi_axis_x[1:], history.semi_axis_x[:-1])
        passed = radius * np.abs(turn) / np.maximum(half_length, history.mesh.spacing * radius)
        handed_on = load * np.minimum(passed, 1.0) + 0.5 * np.abs(np.diff(history.load))
        slid = np.abs(np.diff(history.center_displacement) - radius * turn)
        left = left + min(history.friction, 1.0) * handed_on * slid
    return float(left[steps].sum())


def _forces(case: HistoryCase, history: vr.History) -> Iterator[tuple[str, float]]:
    """Check that torque and force together equal the resistance, and vanish for a rigid body or on a rigid plane."""
    if case.has_friction:
        return
    size = scales(history)["resisting_torque"] * TOLERANCE
    radius = case.body.outer_radius
    if history.compliance is enums.Compliance.RADIAL:
        sum_of_both = history.driving_torque + radius * history.driving_force
        yield "torque and force", float(np.abs(sum_of_both - history.resisting_torque).max()) / size
    if not case.body.layers:
        yield "torque of a rigid body", float(np.abs(history.driving_torque).max()) / size
    if case.on is None:
        yield "force on a rigid plane", radius * float(np.abs(history.driving_force).max()) / size


def _friction(case: HistoryCase, history: vr.History) -> Iterator[tuple[str, float]]:
    given = case.arguments
    drive = history.drive
    bound = min(history.friction, 1.0) * history.load.max()
    pressed = history.load > 0.0
    yield "stick share outside [0, 1]", 2.0 * float(np.any((history.stick_share < 0.0) | (history.stick_share > 1.0)))
    if case.on is None and history.mass == 0.0:
        excess = np.abs(history.driving_force) - history.friction * history.load
        yield "force > friction", float(excess.max()) / (TOLERANCE * bound)
    if "center_displacement" in given:
        deviation = np.interp(given["time"], history.time, history.center_displacement) - np.array(
            given["center_displacement"]
        )
        is_jump = np.isin(given["time"], history.time[:-1][np.diff(history.time) == 0.0])
        yield (
            "prescribed center displacement",
            float(np.abs(deviation[~is_jump]).max(initial=0.0)) / (TOLERANCE * scales(history)["center_displacement"]),
        )
    elif history.mass == 0.0 and drive.force is not None:
        # excluding the instant of the first contact, at which no force acts yet
        off = (history.driving_force - drive.force)[1:][pressed[1:]]
        yield "force balance", float(np.abs(off).max(initial=0.0)) / (TOLERANCE * bound)
    elif drive.torque is not None:
        off = (history.driving_torque - drive.torque)[1:][pressed[1:]]
        yield "torque balance", float(np.abs(off).max(initial=0.0)) / (TOLERANCE * bound * case.body.outer_radius)


def nodes_of(history: vr.History) -> int:
    """Return the approximate largest number of nodes in contact on one mesh."""
    radius = history.body.outer_radius
    across = 1.0 if history.body.line_contact else radius * history.mesh.theta_spacing
    areas: NDArray[np.float64] = history.contact_area
    return round(float(areas.max()) / (radius * history.mesh.spacing * across))
