"""Largest pressure and zigzag of thirty cases: `python -m tests.campaign.pressure --accuracy 0.01`.

Each case is solved to an accuracy, and on a mesh four times as fine in every direction. The command prints the error of
the largest pressure, its estimate and the zigzag, as shares of the accuracy, and the processor time of the solve. A
case fails if the error of the pressure or the zigzag exceeds the accuracy without a warning.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from dataclasses import dataclass, replace

import numpy as np
import viscoroll as vr
from viscoroll import enums

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
STEEP = vr.StandardLinearSolid(instantaneous_modulus=60e6, relaxed_modulus=3e6, relaxation_time=0.01)
SPECTRUM = vr.Prony(
    instantaneous_modulus=100e6,
    weights=[0.5, 0.25, 0.12, 0.06, 0.03, 0.02],
    relaxation_times=[1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1],
)
ELASTIC = vr.Elastic(modulus=5e6)


@dataclass(frozen=True)
class Case:
    """The rolling body, and the arguments of `viscoroll.solve`."""

    name: str
    body: vr.CoatedSphere | vr.CoatedCylinder | vr.CoatedWheel
    arguments: dict[str, object]

    def solve(self, **others):
        """Return the result, and the processor time [s]."""
        start = time.process_time()
        result = vr.solve(self.body, **self.arguments, **others, threads=1)
        return result, time.process_time() - start


@dataclass(frozen=True)
class Outcome:
    """Relative errors [-] of a case, and the processor time [s] of the solve to the accuracy."""

    case: Case
    result: vr.Result
    error: float
    zigzag: float
    seconds: float

    @property
    def warned(self):
        """Return whether the result warns of its largest pressure."""
        return enums.WarningKind.PRESSURE_PEAK in self.result.warnings

    def failed(self, accuracy):
        """Return whether an error exceeds the accuracy without a warning."""
        return max(self.error, self.zigzag) > accuracy and not self.warned


def fractional(order, *, relaxed=1.5e6, instantaneous=300e6, time=1e-6):
    """Return a fractional Zener solid with the moduli of the idler and another order."""
    return vr.materials.FractionalZener(
        instantaneous_modulus=instantaneous, relaxed_modulus=relaxed, relaxation_time=time, order=order
    )


def viscous(viscosity):
    """Return a Kelvin-Voigt solid of 3 MPa."""
    return vr.materials.KelvinVoigt(modulus=3e6, viscosity=viscosity)


def layer(thickness, modulus, poisson_ratio=0.5):
    """Return a layer."""
    return vr.Layer(thickness=thickness, shear_modulus=modulus, poisson_ratio=poisson_ratio)


def cases():
    """Return the thirty cases: line contacts, point contacts, wheels."""
    return [*_idlers(), *_rollers(), *_balls(), *_wheels()]


def _idlers():
    def idler(name, modulus, *, poisson_ratio=0.5, angular_speed=62.9):
        plane = vr.CoatedPlane(layers=[layer(6e-3, modulus, poisson_ratio)])
        return Case(name, vr.CoatedCylinder(core_radius=79.5e-3), _given(2e3, angular_speed, on=plane))

    return [
        idler("idler, order 1/2", fractional(0.5)),
        idler("idler, order 1/2, nu 0.4", fractional(0.5), poisson_ratio=0.4),
        idler("idler, order 0.3", fractional(0.3, instantaneous=30e6)),
        idler("idler, order 0.4", fractional(0.4)),
        idler("idler, order 0.7", fractional(0.7)),
        idler("idler, Prony", SPECTRUM),
        idler("idler, Prony, slow", SPECTRUM, angular_speed=0.5),
    ]


def _rollers():
    def roller(name, layers, *, load=5e3, angular_speed=30.0, **others):
        return Case(name, vr.CoatedCylinder(core_radius=50e-3, layers=layers), _given(load, angular_speed, **others))

    def on_half_plane(name, modulus, angular_speed):
        plane = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=modulus, poisson_ratio=0.5))
        return roller(name, [], angular_speed=angular_speed, on=plane)

    def on_layer(name, modulus, angular_speed):
        return roller(name, [], angular_speed=angular_speed, on=vr.CoatedPlane(layers=[layer(6e-3, modulus)]))

    return [
        on_half_plane("half-plane", RUBBER, 1.0),
        on_half_plane("half-plane, steep, slow", STEEP, 0.05),
        on_half_plane("half-plane, steep, fast", STEEP, 10.0),
        on_layer("Kelvin-Voigt, weak", viscous(3e3), 1.0),
        on_layer("Kelvin-Voigt, strong", viscous(1e5), 4.0),
        roller("roller, Prony", [layer(10e-3, SPECTRUM)]),
        roller("roller, order 1/2", [layer(10e-3, fractional(0.5))]),
        roller("roller, two layers", [layer(5e-3, ELASTIC), layer(3e-3, fractional(0.5), 0.45)]),
        roller("roller, thin, elastic", [layer(1e-3, ELASTIC)]),
        roller("roller, friction", [layer(10e-3, SPECTRUM)], friction=0.3),
    ]


def _balls():
    def ball(name, layers, *, load=50.0, angular_speed=30.0, **others):
        return Case(name, vr.CoatedSphere(core_radius=20e-3, layers=layers), _given(load, angular_speed, **others))

    half_space = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=0.5))
    mat = vr.CoatedPlane(layers=[layer(3e-3, fractional(0.5))])
    return [
        ball("ball", [layer(1e-3, RUBBER)], angular_speed=1.0),
        ball("ball, fast", [layer(1e-3, RUBBER)]),
        ball("ball, order 1/2", [layer(2e-3, fractional(0.5))]),
        ball("ball, Prony", [layer(2e-3, SPECTRUM)]),
        ball("ball, Kelvin-Voigt", [layer(1e-3, viscous(3e4))], angular_speed=4.0),
        ball("ball, two layers", [layer(2e-3, RUBBER), layer(0.5e-3, fractional(0.4), 0.45)], angular_speed=10.0),
        ball("ball, friction", [layer(1e-3, RUBBER)], angular_speed=1.0, friction=0.3),
        ball("half-space", [], load=20.0, angular_speed=10.0, on=half_space),
        ball("mat, order 1/2", [], load=20.0, angular_speed=60.0, on=mat),
    ]


def _wheels():
    def wheel(name, modulus, angular_speed=30.0, **others):
        body = vr.CoatedWheel(core_radius=40e-3, layers=[layer(6e-3, modulus)], width=20e-3, **others)
        return Case(name, body, _given(100.0, angular_speed))

    return [
        wheel("wheel, order 1/2", fractional(0.5), crown_radius=60e-3),
        wheel("wheel", RUBBER, 1.0, crown_radius=60e-3),
        wheel("wheel, flat, Prony", SPECTRUM),
        wheel("wheel, unbounded, Prony", SPECTRUM, crown_radius=60e-3, sides=enums.Sides.UNBOUNDED),
    ]


def _given(load, angular_speed, **others):
    return {"load": load, "angular_speed": angular_speed, **others}


def zigzag(result):
    """Return the alternation of pressures along a row, relative to the largest pressure.

    The difference of a node from a weighted mean with its neighbors is p - (¼ ½ ¼) p. If its signs alternate at three
    successive nodes inside the contact, the smallest of the three differences counts; return the largest.
    """
    columns = (result.pressure.shape[0], -1)
    pressure, touching = result.pressure.reshape(columns), result.contact.reshape(columns).astype(bool)
    off = 0.25 * np.diff(pressure, n=2, axis=0)
    inside = touching[:-2] & touching[1:-1] & touching[2:]
    three = np.stack([np.where(inside, off, 0.0)[i : len(off) - 2 + i] for i in range(3)])
    alternates = (three[0] * three[1] < 0.0) & (three[1] * three[2] < 0.0)
    return float(np.where(alternates, abs(three).min(axis=0), 0.0).max(initial=0.0) / result.max_pressure)


def four_times_as_fine(mesh):
    """Return the reference mesh."""
    across = mesh.theta_nodes_per_revolution
    return replace(
        mesh,
        nodes_per_revolution=4 * mesh.nodes_per_revolution,
        theta_nodes_per_revolution=across and 4 * across,
    )


def judge(case, accuracy):
    """Solve a case with the accuracy and on the reference mesh."""
    result, seconds = case.solve(accuracy=accuracy)
    fine, _ = case.solve(mesh=four_times_as_fine(result.mesh))
    error = abs(result.max_pressure / fine.max_pressure - 1.0)
    return Outcome(case, result, error, zigzag(result), seconds)


def main() -> int:
    """Judge all cases, and print the largest errors."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.pressure", description=__doc__)
    parser.add_argument("--accuracy", type=float, default=0.01, help="requested accuracy")
    accuracy = parser.parse_args().accuracy
    outcomes = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)  # the results contain the warnings
        for case in cases():
            outcome = judge(case, accuracy)
            outcomes.append(outcome)
            print(_line(outcome, accuracy), flush=True)
    quiet = [outcome for outcome in outcomes if not outcome.warned]
    failed = [outcome.case.name for outcome in outcomes if outcome.failed(accuracy)]
    print(
        f"{len(quiet)} of {len(outcomes)} cases without a warning: error of the largest pressure up to "
        f"{max(outcome.error for outcome in quiet):.2g}, zigzag up to {max(outcome.zigzag for outcome in quiet):.2g}; "
        f"failed: {', '.join(failed) or 'none'}"
    )
    return int(bool(failed))


def _line(outcome, accuracy):
    result = outcome.result
    shares = [outcome.error, result.max_pressure_error, outcome.zigzag]
    told = "  ".join(f"{share / accuracy:6.2f}" for share in shares)
    nodes = result.refinements[-1].contact_nodes
    warned = "  warned" if outcome.warned else ""
    return f"{outcome.case.name:26s} {told}  {nodes:6d} nodes, {outcome.seconds:.2f} s{warned}"


if __name__ == "__main__":
    sys.exit(main())
