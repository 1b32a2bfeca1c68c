"""Random filled rubbers: `python -m tests.campaign.softening --cases 100`.

Each is found from both sides, unstrained and all but broken, which must meet in one state. Told is what failed, how
many contacts it took at most, and how much processor time beside one contact of the same mesh.
"""

from __future__ import annotations

import argparse
import sys
import time
import warnings
from dataclasses import dataclass

import numpy as np
import viscoroll as vr
from viscoroll.interior.softening_search import SofteningSearch, softening_layers

#: Contacts that one search may take, and what both sides may differ by: slopes up to 0.62 of the tolerance's last step.
MOST_CONTACTS = 20
TOLERANCE = 1e-3
AGREEMENT = 4e-3


@dataclass(frozen=True)
class Case:
    """What rolls, on what, under which load [N] or [N/m], at which speed [rad/s], on which mesh."""

    ball: vr.CoatedSphere | vr.CoatedCylinder
    on: vr.CoatedPlane | None
    load: float
    angular_speed: float
    mesh: vr.Mesh

    def search(self):
        """Return a search that nothing is known to yet."""
        return SofteningSearch(
            ball=self.ball,
            on=self.on,
            layers=softening_layers(self.ball, self.on),
            load=self.load,
            angular_speed=self.angular_speed,
            options={"mesh": self.mesh},
            depths=3,
            report=None,
        )


def draw(seed, number):
    """Return a random case: rest by network in [0.1, 1], exponents to 0.6, critical strains 0.1 to 10 %."""
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
    network = vr.KrausNetwork(
        storage=storage,
        loss=storage * random.uniform(0.1, 0.2),
        critical_strain=spread(1e-3, 0.1),
        exponent=random.uniform(0.3, 0.6),
    )
    radius = spread(5e-3, 0.1)
    thickness = radius * spread(0.03, 0.5)
    layer = vr.Layer(
        thickness=thickness,
        shear_modulus=vr.SofteningModulus(matrix=matrix, network=network),
        poisson_ratio=float(random.choice([0.3, 0.45, 0.5])),
    )
    kind = vr.CoatedSphere if random.random() < 0.5 else vr.CoatedCylinder
    half_width = min(radius * spread(0.05, 0.25), 3.0 * thickness)
    # Hertz on the matrix alone, or the pressure that a strain of (half-width)²/2Rh makes: an order is enough
    strain = half_width**2 / (2.0 * radius * min(thickness, half_width))
    load = 3.0 * relaxed * strain * half_width * (half_width if kind is vr.CoatedSphere else 1.0)
    on_plane = random.random() < 0.4
    inner = radius if on_plane else radius - thickness
    return Case(
        ball=kind(core_radius=inner, layers=() if on_plane else [layer]),
        on=vr.CoatedPlane(layers=[layer]) if on_plane else None,
        load=load,
        angular_speed=spread(0.1, 100.0),
        mesh=vr.Mesh(nodes_per_revolution=2 * round(10.0 * np.pi * radius / half_width)),
    )


def run(case):
    """Return what is wrong with a case, contacts solved from either side, and processor time by that of a contact."""
    contacts, found, times = [], [], []
    for strain in (0.0, 1.0):
        search = case.search()
        start = time.process_time()
        first = search.at(np.array([strain]), np.ones(1))
        plain = time.process_time()
        search.solved(first.amplitudes, first.scales)
        single = time.process_time() - plain
        state, _ = search.converged(first, matched=False, tolerance=TOLERANCE)
        state, _ = search.converged(state, matched=True, tolerance=TOLERANCE)
        times.append((time.process_time() - start - single) / single)
        contacts.append(search.contacts - 1)
        found.append((state.amplitudes[0], state.result.resisting_torque))
    wrong = []
    if max(contacts) > MOST_CONTACTS:
        wrong.append(f"{max(contacts)} contacts")
    if not np.allclose(found[0], found[1], rtol=AGREEMENT, atol=0.0):
        wrong.append(f"two states: {found}")
    return wrong, max(contacts), max(times)


def main():
    """Run a campaign."""
    parser = argparse.ArgumentParser(prog="python -m tests.campaign.softening", description=__doc__)
    parser.add_argument("--cases", type=int, default=100, help="number of cases")
    parser.add_argument("--seed", type=int, default=1, help="of the campaign")
    arguments = parser.parse_args()
    warnings.simplefilter("ignore", vr.ResultWarning)
    failed, refused, contacts, times = 0, 0, [], []
    for number in range(arguments.cases):
        case = draw(arguments.seed, number)
        try:
            wrong, count, time_ratio = run(case)
        except ValueError as error:  # a load that the layer does not bear
            refused += 1
            print(f"{number}: refused, {error}", flush=True)
            continue
        except vr.ConvergenceError as error:
            wrong, count, time_ratio = [str(error)], MOST_CONTACTS, np.nan
        contacts.append(count)
        times.append(time_ratio)
        print(f"\r{number + 1} of {arguments.cases}, {failed} failed", end="", file=sys.stderr, flush=True)
        if wrong:
            failed += 1
            print(f"{number}: {', '.join(wrong)}; {case}", flush=True)
    print(file=sys.stderr)
    print(
        f"{arguments.cases} cases, {refused} refused, {failed} failed; at most {max(contacts)} contacts, median "
        f"{np.median(contacts):.0f}; time by that of one contact: median {np.nanmedian(times):.0f}, at most "
        f"{np.nanmax(times):.0f}"
    )
    return int(failed > 0)


if __name__ == "__main__":
    raise SystemExit(main())
