"""Random filled rubbers: `python -m tests.campaign.softening --cases 100`.

Each case is solved from both sides, unstrained and nearly broken, which must lead to the same state. The command prints
failures, the largest number of contact solutions, the processor time relative to `solve` with the final moduli, and the
differences of torque and amplitude from those with twice the depths and a thousandth of the tolerance.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from dataclasses import dataclass

import numpy as np
import viscoroll as vr
from viscoroll.coupled.softening_search import SofteningSearch, softening_layers

#: Largest number of contact solutions in one search.
MOST_CONTACTS = 20
TOLERANCE = 1e-3
#: Allowed relative difference between both searches, for slopes of the iteration up to 0.62.
AGREEMENT = 4e-3


@dataclass(frozen=True)
class Case:
    """Rolling body, counterbody, load [N] or [N/m], speed [rad/s] and mesh."""

    body: vr.CoatedSphere | vr.CoatedCylinder
    on: vr.CoatedPlane | None
    load: float
    angular_speed: float
    mesh: vr.Mesh

    def search(self):
        """Return a new search."""
        return SofteningSearch(
            body=self.body,
            on=self.on,
            layers=softening_layers(self.body, self.on),
            load=self.load,
            angular_speed=self.angular_speed,
            options={"mesh": self.mesh},
            depths=4,
            report=None,
        )


def draw(seed, number):
    """Return a random case: relaxed share in [0.1, 1], exponents up to 0.6, critical strains of 0.1 to 10 %."""
    random = np.random.default_rng([seed, number])

    def spread(low, high):
        return float(np.exp(random.uniform(np.log(low), np.log(high))))

    relaxed, ratio = spread(3e5, 1e7), random.uniform(0.1, 0.999)
    storage = relaxed * (1.0 / ratio - 1.0)
    matrix = vr.StandardLinearSolid(
        instantaneous_modulus=relaxed * random.uniform(1.0, 2.0),
        relaxed_modulus=relaxed,
        relaxation_time=spread(1e-3, 1.0),
    )
    network = vr.materials.KrausNetwork(
        storage=storage,
        loss=storage * random.uniform(0.1, 0.2),
        critical_strain=spread(1e-3, 0.1),
        exponent=random.uniform(0.3, 0.6),
    )
    radius = spread(5e-3, 0.1)
    thickness = radius * spread(0.03, 0.5)
    layer = vr.Layer(
        thickness=thickness,
        shear_modulus=vr.materials.SofteningModulus(matrix=matrix, network=network),
        poisson_ratio=float(random.choice([0.3, 0.45, 0.5])),
    )
    kind = vr.CoatedSphere if random.random() < 0.5 else vr.CoatedCylinder
    half_width = min(radius * spread(0.05, 0.25), 3.0 * thickness)
    # The order of magnitude of the load follows from Hertz for the matrix alone, or from the strain (half-width)²/2Rh.
    strain = half_width**2 / (2.0 * radius * min(thickness, half_width))
    load = 3.0 * relaxed * strain * half_width * (half_width if kind is vr.CoatedSphere else 1.0)
    on_plane = random.random() < 0.4
    inner = radius if on_plane else radius - thickness
    return Case(
        body=kind(core_radius=inner, layers=() if on_plane else [layer]),
        on=vr.CoatedPlane(layers=[layer]) if on_plane else None,
        load=load,
        angular_speed=spread(0.1, 100.0),
        mesh=vr.Mesh(nodes_per_revolution=2 * round(10.0 * np.pi * radius / half_width)),
    )


def run(case):
    """Return failures, contact solutions from either side, time relative to that of `solve`, and errors."""
    given = {"on": case.on, "load": case.load, "angular_speed": case.angular_speed, "mesh": case.mesh}
    start = time.process_time()
    found = vr.strain_softening(case.body, **given)
    taken = time.process_time() - start
    amplitude, torque = found.layer_amplitudes[0], found.torque_bounds[1]

    search = case.search()
    plain = time.process_time()
    search.solved(
        np.array([1.001 * amplitude]),
        np.array(found.loss_scales),
        # slightly different moduli, so that no stored solution applies
    )
    plain = time.process_time() - plain
    state = search.converged(search.at(np.ones(1), np.ones(1)), matched=True, tolerance=TOLERANCE)
    contacts = max(found.iterations, search.contacts - 1)

    fine = vr.strain_softening(case.body, **given, depths=8, tolerance=1e-3 * TOLERANCE)
    errors = (amplitude / fine.layer_amplitudes[0] - 1.0, torque / fine.torque_bounds[1] - 1.0)
    wrong = []
    if contacts > MOST_CONTACTS:
        wrong.append(f"{contacts} contacts solved")
    other = (state.amplitudes[0], state.result.resisting_torque)
    if not np.allclose((amplitude, torque), other, rtol=AGREEMENT, atol=0.0):
        wrong.append(f"two states: {amplitude, torque} and {other}")
    return wrong, contacts, taken / plain, np.abs(errors)


def main():
    """Run the tests."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.softening", description=__doc__)
    parser.add_argument("--cases", type=int, default=100, help="number of cases")
    parser.add_argument("--seed", type=int, default=1, help="seed of the random cases")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore", vr.ResultWarning)
    failed, rejected, contacts, times, errors = 0, 0, [], [], []
    for number in range(arguments.cases):
        case = draw(arguments.seed, number)
        try:
            wrong, count, time_ratio, error = run(case)
        except ValueError as rejection:  # the layer does not support the load
            rejected += 1
            print(f"{number}: rejected, {rejection}", flush=True)
            continue
        except vr.ConvergenceError as stuck:
            wrong, count, time_ratio, error = [str(stuck)], MOST_CONTACTS, np.nan, np.full(2, np.nan)
        contacts.append(count)
        times.append(time_ratio)
        errors.append(error)
        print(f"\r{number + 1} of {arguments.cases}, {failed} failed", end="", file=sys.stderr, flush=True)
        if wrong:
            failed += 1
            print(f"{number}: {', '.join(wrong)}; {case}", flush=True)
    print(file=sys.stderr)
    middle, most = np.nanmedian(errors, axis=0), np.nanmax(errors, axis=0)
    print(
        f"{arguments.cases} cases, {rejected} rejected, {failed} failed; contacts solved: median "
        f"{np.median(contacts):.0f}, largest {max(contacts)}; time divided by that of one contact: median "
        f"{np.nanmedian(times):.1f}, largest {np.nanmax(times):.1f}; error of the amplitude: median {middle[0]:.1g}, "
        f"largest {most[0]:.1g}; error of the torque: median {middle[1]:.1g}, largest {most[1]:.1g}"
    )
    return int(failed > 0)


if __name__ == "__main__":
    raise SystemExit(main())
