"""Random balls and rollers with adhesion: every case ends in a state, or in a message that says what to do.

Modulus ratios are 1.5 to 100, the ratio of adhesion to load √(2πE*aw)/P (a roller) or √(8πE*a³w)/P (a ball) is 0.01 to
50, and the distance rolled in a relaxation time 0.003 to 50 half-widths, with the half-width a of JKR. Every eighth
load is zero and every eighth is a tension. A state passes if its power balance closes, if both energy release rates lie
between their limits, if adhesion does not reduce the torque, and if it scales with load, moduli and work.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import viscoroll as vr

from .command import main
from .runner import Outcome, attempt

__all__ = ["AdhesiveCase", "draw", "run_case"]

#: Largest error of the power balance, relative to the power, and to that of the moment of one edge. The moments of both
#: edges almost cancel in fast rolling, and a contact that ends at nodes shifts each of them.
_BALANCE, _BALANCE_OF_EDGES = 2e-3, 2e-4

#: Relative error of the mesh that cases request.
_ACCURACY = 0.05


@dataclass(frozen=True, kw_only=True)
class AdhesiveCase:
    """A rigid body that rolls on a viscoelastic plane with adhesion.

    Attributes
    ----------
    name : str
        "SEED:NUMBER".
    body : CoatedSphere or CoatedCylinder
        The rigid body.
    ratio : float
        G₀/G_∞ of the plane.
    arguments : dict
        Further arguments of `solve`.
    """

    name: str
    body: vr.CoatedSphere | vr.CoatedCylinder
    ratio: float
    arguments: dict[str, Any]

    has_friction = False

    def source(self) -> str:
        """Return the call."""
        given = "".join(f", {name}={value!r}" for name, value in self.arguments.items())
        return f"solve({self.body!r}{given})"

    def without_adhesion(self) -> AdhesiveCase:
        """Return the same case without adhesion."""
        return replace(self, arguments={k: v for k, v in self.arguments.items() if k != "adhesion"})

    def scaled(self, factor: float) -> AdhesiveCase:
        """Return the case with load, moduli, work and strength multiplied by a factor."""
        plane, adhesion = self.arguments["on"], self.arguments["adhesion"]

        def stiffer(part: Any) -> Any:
            solid = part.shear_modulus
            return replace(
                part,
                shear_modulus=replace(
                    solid,
                    instantaneous_modulus=solid.instantaneous_modulus * factor,
                    relaxed_modulus=solid.relaxed_modulus * factor,
                ),
            )

        on = vr.CoatedPlane(
            layers=[stiffer(layer) for layer in plane.layers], base=None if plane.base is None else stiffer(plane.base)
        )
        scaled = replace(
            adhesion,
            work=adhesion.work * factor,
            strength=None if adhesion.strength is None else adhesion.strength * factor,
        )
        load = self.arguments["load"] * factor
        return replace(self, arguments={**self.arguments, "on": on, "adhesion": scaled, "load": load})


def draw(seed: int, number: int) -> AdhesiveCase:
    """Return a random case."""
    rng = np.random.default_rng([seed, number, 51])

    def between(low: float, high: float) -> float:
        return float(np.exp(rng.uniform(np.log(low), np.log(high))))

    line = bool(rng.integers(2))
    radius, relaxed, ratio = between(1e-3, 0.1), between(1e5, 1e7), between(1.5, 100.0)
    poisson = float(rng.choice([0.3, 0.45, 0.5]))
    modulus = 2.0 * relaxed / (1.0 - poisson)
    a = radius * between(0.005, 0.1)
    share = between(0.01, 50.0)
    if line:
        load = 0.25 * math.pi * modulus * a**2 / radius / (1.0 + share)
        work = (share * load) ** 2 / (2.0 * math.pi * modulus * a)
        pull_off = 0.75 * (4.0 * math.pi * modulus * work**2 * radius) ** (1.0 / 3.0)
    else:
        load = 4.0 / 3.0 * modulus * a**3 / radius / (1.0 + share)
        work = (share * load) ** 2 / (8.0 * math.pi * modulus * a**3)
        pull_off = 1.5 * math.pi * work * radius
    time_constant = between(1e-4, 10.0)
    speed = a * between(0.003, 50.0) / time_constant
    solid = vr.StandardLinearSolid(
        instantaneous_modulus=ratio * relaxed, relaxed_modulus=relaxed, relaxation_time=time_constant
    )
    if rng.integers(2):
        on = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=solid, poisson_ratio=poisson))
    else:
        layer = vr.Layer(thickness=a * between(0.5, 20.0), shear_modulus=solid, poisson_ratio=poisson)
        on = vr.CoatedPlane(layers=[layer])
    kind = int(rng.integers(8))
    if kind == 0:
        load = 0.0
    elif kind == 1:
        load = -0.5 * pull_off
    length = a * between(1e-4, 0.1)
    strength = math.sqrt(modulus * work / length) if rng.integers(3) == 0 else None
    return AdhesiveCase(
        name=f"{seed}:{number}",
        body=vr.CoatedCylinder(core_radius=radius) if line else vr.CoatedSphere(core_radius=radius),
        ratio=ratio,
        arguments={
            "on": on,
            "load": load,
            "angular_speed": speed / radius,
            "adhesion": vr.Adhesion(work=work, strength=strength),
            "accuracy": _ACCURACY,
        },
    )


def run_case(case: AdhesiveCase, before_each: Callable[[Outcome], object] = lambda _: None) -> Outcome:
    """Solve a case, the case without adhesion, and a scaled one, and check the solutions."""
    outcome = Outcome(case=case.name, source=case.source())
    before_each(outcome)
    start = time.process_time()
    result = attempt(vr.solve, case, outcome)
    outcome.seconds = time.process_time() - start
    if result is None:
        return outcome
    outcome.nodes = int(result.contact.sum())
    _check(case, result, outcome)
    outcome.stage = "scaled"
    before_each(outcome)
    scaled = attempt(vr.solve, case.scaled(3.7), outcome)
    if scaled is None:
        return outcome
    # Round-off may decide whether another mesh is cheap enough, so that only meshes of both solutions are compared.
    steps = zip(result.refinements, scaled.refinements, strict=False)
    difference = max(abs(other.resisting_torque / (3.7 * own.resisting_torque) - 1.0) for own, other in steps)
    _require(outcome, "scaling of the torque", difference, 1e-6)
    if case.arguments["load"] > 0.0:
        outcome.stage = "without adhesion"
        before_each(outcome)
        plain = attempt(vr.solve, case.without_adhesion(), outcome)
        if plain is None:
            return outcome
        deficit = 1.0 - result.rolling_resistance_torque / plain.rolling_resistance_torque
        _require(outcome, "torque below that without adhesion", deficit, 2.0 * _ACCURACY)
    outcome.stage = "case"
    return outcome


def _check(case: AdhesiveCase, result: vr.Result, outcome: Outcome) -> None:
    """Record the conditions that a solution violates."""
    for name, number in result.scalars().items():
        if isinstance(number, float) and math.isnan(number):
            outcome.violations[f"{name} is NaN"] = math.inf
    edge = _edge_moment(case, result) / result.rolling_resistance_torque
    _require(outcome, "power balance", result.energy_balance_error, _BALANCE + _BALANCE_OF_EDGES * edge)
    if not result.opening_energy_ratio or not result.closing_energy_ratio:
        outcome.violations["no energy release rates"] = math.inf
        return
    _require(outcome, "opening above the ratio of the moduli", result.opening_energy_ratio / case.ratio - 1.0, 1e-6)
    _require(outcome, "opening below 1", 1.0 - result.opening_energy_ratio, 1e-6)
    _require(outcome, "closing above 1", result.closing_energy_ratio - 1.0, 1e-6)
    _require(outcome, "closing below the ratio", 1.0 - result.closing_energy_ratio * case.ratio, 1e-6)


def _edge_moment(case: AdhesiveCase, result: vr.Result) -> float:
    """Return the order of the moment of the tension at one edge."""
    plane = case.arguments["on"]
    material = plane.base or plane.layers[-1]
    modulus = 2.0 * material.shear_modulus.instantaneous_modulus / (1.0 - material.poisson_ratio)
    a = 0.5 * result.contact_length
    tension = math.sqrt(2.0 * math.pi * modulus * a * case.arguments["adhesion"].work)
    return 0.5 * a * tension * (1.0 if result.contact_width is None else 2.0 * a)


def _require(outcome: Outcome, name: str, error: float, tolerance: float) -> None:
    if not error <= tolerance:
        outcome.violations[name] = error / tolerance


if __name__ == "__main__":
    sys.exit(main("python -m tests.campaign.adhesion", __doc__, "build/campaign-adhesion.jsonl", draw, run_case))
