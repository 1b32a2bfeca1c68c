"""Random rough surfaces that slide on random layers: `python -m tests.campaign.sliding --cases 200`.

Surfaces are maps and profiles, periodic and of finite size, with and without friction at the interface. A solution
passes if it converged and satisfies the contact conditions, supports its load, dissipates no negative power, and
balances its power: work of the tractions and losses agree up to the error of the contact edges, and to 1e-6 in full
contact; the force against the sliding direction has the power that layers and interface dissipate. Under a periodic
surface, the loss in the volume is the power of the result, and every depth carries the mean pressure and friction.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import viscoroll as vr

from .command import main
from .runner import Outcome, attempt

__all__ = ["SlidingCase", "draw", "run_case", "violations"]

#: Accuracy of sums [relative].
TOLERANCE = 1e-6

#: Largest difference of friction from tractions and from losses, relative to the rms slope, times the square root of
#: the number of nodes in contact: 2.1 among 600 cases, in a rubber whose modulus falls by a factor of 78.
LARGEST_EDGE_ERROR = 2.0

#: Largest ratio of this difference on a mesh of half the spacing, 1/4 in theory.
FINER = 0.5

#: Largest residual, relative to the penetration.
LARGEST_RESIDUAL = 1e-5


@dataclass(frozen=True)
class SlidingCase:
    """A surface that slides on layers.

    Attributes
    ----------
    name : str
        "SEED:NUMBER".
    body : RoughSurface
        Rough surface.
    arguments : dict
        Other arguments of `viscoroll.slide`.
    heights : str
        Call that makes the surface.
    """

    name: str
    body: vr.RoughSurface
    arguments: dict[str, Any]
    heights: str

    @property
    def has_friction(self) -> bool:
        """Return whether there is friction at the interface."""
        return bool(self.arguments["friction"] > 0.0)

    def source(self) -> str:
        """Return the call that repeats the case."""
        given = ", ".join(f"{name}={value!r}" for name, value in self.arguments.items() if name != "threads")
        return f"slide({self.heights}, {given})"


def draw(seed: int, number: int) -> SlidingCase:
    """Return a random case."""
    rng = np.random.default_rng([seed, number, 50])
    side = 10.0 ** rng.uniform(-4.0, -1.0)
    periodic = bool(rng.random() < 0.75)
    surface = _profile(rng, side, periodic) if rng.random() < 0.25 else _map(rng, side, periodic)
    relaxed, ratio, duration = 10.0 ** rng.uniform(5.0, 8.0), 10.0 ** rng.uniform(0.05, 3.0), 10.0 ** rng.uniform(-4, 1)
    instantaneous = ratio * relaxed
    materials: list[Callable[[], Any]] = [
        lambda: vr.Elastic(modulus=relaxed),
        lambda: vr.StandardLinearSolid(
            instantaneous_modulus=instantaneous, relaxed_modulus=relaxed, relaxation_time=duration
        ),
        lambda: vr.materials.FractionalZener(
            instantaneous_modulus=instantaneous,
            relaxed_modulus=relaxed,
            relaxation_time=duration,
            order=float(rng.uniform(0.3, 1.0)),
        ),
    ]
    material = materials[int(rng.integers(len(materials)))]()
    nu = float(rng.choice([0.5, 0.45, 0.3]))
    layer = vr.Layer(thickness=side * 10.0 ** rng.uniform(-1.5, 0.5), shear_modulus=material, poisson_ratio=nu)
    half_space = vr.HalfSpace(shear_modulus=material, poisson_ratio=nu)
    kinds = [
        vr.CoatedPlane(base=half_space),
        vr.CoatedPlane(layers=[layer]),
        vr.CoatedPlane(layers=[layer], base=vr.HalfSpace(shear_modulus=vr.Elastic(modulus=relaxed), poisson_ratio=0.3)),
    ]
    slides = rng.random() < 0.85
    # The pressure of full contact is about that of the rms slope.
    pressure = surface[0].rms_slope * 2.0 * relaxed / (1.0 - nu) * 10.0 ** rng.uniform(-2.5, 0.5)
    arguments = {
        "on": kinds[int(rng.integers(len(kinds)))],
        "pressure": pressure * (1.0 if periodic else 0.1),
        "speed": side / duration * 10.0 ** rng.uniform(-3.0, 2.0) if slides else 0.0,
        "friction": float(rng.uniform(0.05, 1.0)) if slides and rng.random() < 0.3 else 0.0,
        "threads": 1,
    }
    return SlidingCase(name=f"{seed}:{number}", body=surface[0], arguments=arguments, heights=surface[1])


def _profile(rng: np.random.Generator, side: float, periodic: bool) -> tuple[vr.RoughSurface, str]:
    nodes = int(rng.choice([64, 81, 128, 500]))
    waves = rng.normal(size=nodes // 8), rng.random(nodes // 8)
    x = np.arange(nodes) / nodes
    heights = sum(a * np.cos(2 * np.pi * (k * x + t)) / k**1.8 for k, (a, t) in enumerate(zip(*waves, strict=True), 1))
    return _scaled(rng, heights, side / nodes, periodic)


def _map(rng: np.random.Generator, side: float, periodic: bool) -> tuple[vr.RoughSurface, str]:
    nodes = int(rng.choice([64, 81, 96, 128] if periodic else [49, 64]))
    rough = vr.RoughSurface.self_affine(
        nodes,
        side,
        hurst=float(rng.uniform(0.3, 1.0)),
        rolloff=side / 2,
        cutoff=8 * side / nodes,
        rms_slope=0.1,
        seed=int(rng.integers(1_000_000)),
    )
    return _scaled(rng, rough.heights, side / nodes, periodic)


def _scaled(rng: np.random.Generator, heights: np.ndarray, spacing: float, periodic: bool) -> tuple[Any, str]:
    """Return a surface with a random slope, and a call that makes it; a finite one is a bowl, free at its rim."""
    if not periodic:
        place = np.meshgrid(*(np.linspace(-1.0, 1.0, count) for count in heights.shape), indexing="ij")
        heights = heights - 3.0 * np.ptp(heights) * sum(grid**2 for grid in place)
    surface = vr.RoughSurface(heights, spacing, periodic=periodic)
    surface = surface.scaled(10.0 ** rng.uniform(-2.0, -0.5) / surface.rms_slope)
    return surface, f"RoughSurface({surface.heights.tolist()!r}, {spacing!r}, periodic={periodic!r})"


def violations(case: SlidingCase, result: vr.SlidingResult) -> dict[str, float]:
    """Return the conditions that a result violates, each with its error relative to the tolerance."""
    numbers = [value for name, value in result.scalars().items() if not name.startswith("persson")]
    if not all(math.isfinite(value) for value in numbers if isinstance(value, float)):
        return {"not finite": math.inf}
    return {name: error for name, error in _errors(case, result) if not error <= 1.0}


def _errors(case: SlidingCase, result: vr.SlidingResult) -> Iterator[tuple[str, float]]:
    pressure, speed = case.arguments["pressure"], case.arguments["speed"]
    yield "not converged", 0.0 if result.converged else math.inf
    yield "residual", result.residual / LARGEST_RESIDUAL
    yield "load", abs(result.pressure.mean() / pressure - 1.0) / TOLERANCE
    yield "pressure < 0", -float(result.pressure.min()) / (TOLERANCE * pressure)
    yield "power < 0", -result.friction_coefficient / (TOLERANCE * case.body.rms_slope)
    given = speed * pressure * result.total_friction_coefficient
    dissipated = result.power_density + result.interface_power_density
    yield "force and power", abs(given - dissipated) / (TOLERANCE * max(abs(given), 1e-300))
    if speed == 0.0 or isinstance(_modulus(case), vr.Elastic):
        # Elastic layers dissipate nothing; the tractions have the error of the mesh.
        yield "power of elastic layers", result.friction_coefficient / (TOLERANCE * case.body.rms_slope)
    # Pressure and gap overlap at the edges of the contacts, see
    # test_the_power_balance_has_the_error_of_the_edges_of_contacts: the error falls with the number of nodes.
    # Full contact of a periodic surface has no edges.
    if case.body.periodic:
        yield from _errors_inside(case, result)
    nodes = int(result.contact.sum())
    largest = TOLERANCE if case.body.periodic and nodes == result.contact.size else LARGEST_EDGE_ERROR / nodes**0.5
    yield "tractions and losses", result.friction_error / (largest * case.body.rms_slope)


def _errors_inside(case: SlidingCase, result: vr.SlidingResult) -> Iterator[tuple[str, float]]:
    pressure, friction = case.arguments["pressure"], case.arguments["friction"]
    lost = result.loss(threads=1).attrs
    # The power of an elastic layer is round-off.
    least = TOLERANCE * case.body.rms_slope * pressure * case.arguments["speed"] * math.prod(case.body.sides)
    power = max(lost["bulk_power"], least, 1e-300)
    yield "loss in the volume", abs(lost["power"] - lost["bulk_power"]) / (TOLERANCE * power)
    on = case.arguments["on"]
    depth = 0.4 * (on.layers[0].thickness if on.layers else case.body.sides[0])
    means = result.interior(depth=[depth], threads=1).stress.mean(("x", "z")).isel(depth=0)
    expected = {"rr": -pressure, "rphi": -friction * pressure, "rtheta": 0.0}
    error = max(abs(float(means.sel(component=name)) - value) for name, value in expected.items())
    yield "mean stress", error / (TOLERANCE * pressure)


def _modulus(case: SlidingCase) -> object:
    on = case.arguments["on"]
    return on.layers[0].shear_modulus if on.layers else on.base.shear_modulus


def run_case(case: SlidingCase, before_each: Callable[[Outcome], object] = lambda _: None) -> Outcome:
    """Solve a case and check it; parameters as in `runner.run_case`."""
    outcome = Outcome(case=case.name, has_friction=case.has_friction, source=case.source())
    before_each(outcome)
    start = time.process_time()
    result = attempt(vr.slide, case, outcome)
    outcome.seconds = time.process_time() - start
    if result is None:
        return outcome
    outcome.nodes = int(result.contact.sum())
    outcome.violations |= violations(case, result)
    if case.body.periodic and "tractions and losses" in outcome.violations:
        # The error of the mesh is proportional to the square of the spacing, so that a fine mesh must reduce it.
        outcome.stage = "finer mesh"
        before_each(outcome)
        rows, columns = case.body.heights.shape
        finer = case.body.resampled((2 * rows, 2 * columns if columns > 1 else 1))
        fine = attempt(vr.slide, replace(case, body=finer), outcome)
        if fine is not None and fine.friction_error < FINER * result.friction_error:
            del outcome.violations["tractions and losses"]
        outcome.stage = "case"
    return outcome


if __name__ == "__main__":
    sys.exit(main("python -m tests.campaign.sliding", __doc__, "build/campaign-sliding.jsonl", draw, run_case))
