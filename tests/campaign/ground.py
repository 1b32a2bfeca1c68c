"""Random histories over uneven ground, with treads and axles: python -m tests.campaign.ground --cases 200.

Bodies and motions are those of `campaign.histories`. A history passes if it is finite, if its energy balance closes up
to the error of the steps, if forces and torque have the same power as the resistance, and if a history that was
interrupted continues to the last bit.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from typing import Any

import numpy as np
import viscoroll as vr
from viscoroll.ground import Axle, Profile

from .bodies import curvature
from .histories.cases import HistoryCase, draw
from .histories.invariants import turnover

#: Residual of the energy balance relative to the energy that is exchanged. On these coarse meshes, of few nodes over a
#: feature, the errors of the steps are a few percent.
BALANCE = 0.15


def uneven(rng: np.random.Generator, case: HistoryCase) -> dict[str, Any]:
    """Return random options for ground, tread and axle, at least one of them."""
    given = case.arguments
    radius = case.body.outer_radius
    spacing = radius * given["mesh"].spacing
    angle = np.asarray(given["angle"])
    middle = radius * float(angle[0] + rng.uniform(0.0, 1.0) * np.ptp(angle))
    height = radius * 10.0 ** rng.uniform(-4.0, -2.0) * float(rng.choice([-1.0, 1.0]))
    length = spacing * rng.uniform(8.0, 30.0)
    shapes = {
        "step": lambda: Profile.step(height, at=middle),
        "bump": lambda: Profile.half_sine(height, length=length, at=middle),
        "joint": lambda: Profile.joint(abs(height), width=length, at=middle),
        "corrugation": lambda: Profile.corrugation(0.2 * height, period=length),
    }
    around = 2.0 * np.pi * radius / max(round(2.0 * np.pi * radius / length), 1)
    options: dict[str, Any] = {}
    if rng.random() < 0.8:
        options["ground"] = shapes[str(rng.choice(list(shapes)))]()
    if not options or rng.random() < 0.3:
        options["tread"] = Profile.corrugation(0.2 * height, period=around)
    if not case.has_friction and rng.random() < 0.4:
        duration = given["time"][-1] - given["time"][0]
        load = float(np.max(given["load"]))
        scale = load / (0.01 * radius)  # about the stiffness of the contact
        mass = scale * (duration * 10.0 ** rng.uniform(-2.5, -0.5)) ** 2
        options["axle"] = Axle(
            mass=mass, stiffness=scale * rng.uniform(0.0, 0.5), damping=rng.uniform(0.0, 0.5) * np.sqrt(scale * mass)
        )
    return options


def faults(case: HistoryCase, options: dict[str, Any]) -> list[str]:
    """Roll a case in one piece and in two, and return the conditions that it violates."""
    arguments = case.arguments | options
    whole = vr.roll(case.body, **arguments)
    found = []
    series = {name: values for name, values in whole._series().items() if name not in ("semi_axis_z", "error_estimate")}
    found += [f"{name} is not finite" for name, values in series.items() if not np.isfinite(values).all()]
    energy = turnover(whole) + float(np.abs(whole.stored_energy).max()) + float(np.abs(whole.axle_energy).max())
    energy += float(np.abs(np.diff(whole.work)).sum())
    imbalance = float(np.abs(whole.energy_balance_residual).max()) / energy
    if imbalance > BALANCE:
        found.append(f"energy balance open by {imbalance:.2g}")
    if not case.has_friction and curvature(case.on) == 0.0 and whole.compliance is vr.enums.Compliance.RADIAL:
        power = whole.driving_torque + case.body.outer_radius * whole.driving_force - whole.resisting_torque
        if np.abs(power).max() > 1e-7 * case.body.outer_radius * whole.load.max():
            found.append("torque and force do not have the power of the resistance")
    half = len(arguments["time"]) // 2 + 1
    names = [name for name in ("time", "angle", "load", "center_displacement") if name in arguments]
    state = vr.roll(case.body, **arguments | {name: arguments[name][:half] for name in names}).state
    rest = vr.roll(case.body, **arguments | {"start": state})._series()
    for name, values in whole._series().items():
        if not np.array_equal(values[len(values) - len(rest[name]) :], rest[name], equal_nan=True):
            found.append(f"{name} differs after an interruption")
    return found


def main() -> int:
    """Run the cases and print those that fail; return 1 if there are any."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    warnings.simplefilter("ignore", vr.ResultWarning)
    failed = rejected = unsolved = done = 0
    slowest = 0.0
    number = 0
    while done < given.cases:
        case = draw(given.seed, number)
        options = uneven(np.random.default_rng([given.seed, number, 49]), case)
        number += 1
        if case.unphysical_argument:
            continue
        done += 1
        began = time.process_time()
        try:
            found = faults(case, options)
        except vr.InvalidInput as error:
            rejected += 1
            print(f"{case.name}: rejected: {error}", flush=True)
            continue
        except vr.ConvergenceError as error:
            unsolved += 1
            print(f"{case.name}: {error}", flush=True)
            continue
        slowest = max(slowest, time.process_time() - began)
        failed += bool(found)
        for fault in found:
            print(f"{case.name}: {fault} {options}", flush=True)
    print(
        f"{done} cases: {failed} failed, {rejected} rejected, {unsolved} without convergence, slowest {slowest:.1f} s"
    )
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
