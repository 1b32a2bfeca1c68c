"""A coated roller starts on a coated plane from a flat spot: python -m tests.reference.roller_start [nodes ...].

Both layers are 10 mm thick, and the core of the roller has a radius of 50 mm. The relaxation functions differ, so the
memory is one force per node and body. The gap is that of a parabola, as in flat theory, or that of the roller's circle
at its nodes, as in the library (docs/theory/transient-bodies.md). Loads and moments are per length.
"""

from __future__ import annotations

import itertools
import sys
from typing import NamedTuple

import numpy as np

from .one_layer import press
from .roller import coating

RADIUS, THICKNESS, LOAD = 60e-3, 10e-3, 5e3

#: Height above the plane [m] at an angle from the lowest point, and the moment arm of the pressure there.
GAPS = {
    "parabola": lambda angle: (0.5 * RADIUS * angle**2, RADIUS * angle),
    "circle": lambda angle: (RADIUS * (1.0 - np.cos(angle)), RADIUS * np.sin(angle)),
}


class Viscoelastic(NamedTuple):
    """Final displacements at offsets of whole nodes on a ring due to a constant unit force, and their creep."""

    table: np.ndarray
    at_once: float  # instantaneous fraction of the final displacement
    retardation_time: float

    def displacement(self, force):
        """Return the displacements of all nodes due to nodal forces."""
        return np.fft.irfft(np.fft.rfft(self.table) * np.fft.rfft(force), force.size)

    def weights(self, step):
        """Return the decay of a retarded force in a time step, and the weights of the old and the new force."""
        z = step / self.retardation_time
        mean = -np.expm1(-z) / z
        return np.exp(-z), mean - np.exp(-z), 1.0 - mean


def relaxed(omega):
    """Return the relaxed modulus [Pa] of the roller, which is elastic here (6 MPa instantaneous, 0.125 s)."""
    return np.full(np.shape(omega), 3e6)


def bonded_layer(nodes, modulus):
    """Return the table of an incompressible layer on a rigid plane, closed to a ring longer than its influence."""
    spacing, periods, images = 2.0 * np.pi * RADIUS / nodes, 64, 32
    count = periods * nodes
    k = 2.0 * np.pi / (count * spacing) * np.arange(1, images * count)
    depth = np.minimum(2.0 * k * THICKNESS, 60.0)
    compliance = (np.sinh(depth) - depth) / (np.cosh(depth) + 1.0 + 0.5 * depth**2) / (2.0 * k * modulus)
    on_patch = compliance * np.sinc(k * spacing / (2.0 * np.pi))
    folded = np.append(0.0, on_patch).reshape(images, count).sum(axis=0)
    table = 2.0 * np.fft.fft(folded).real / (count * spacing)
    offset = np.arange(nodes)
    return table[np.minimum(offset, nodes - offset)]


def start(nodes, gap, turn=1.5, angular_speed=1.0):
    """Return rotation angles and moments [N], the mean of four phase-shifted meshes, with four steps per spacing."""
    ring = Viscoelastic(coating(nodes).offsets(relaxed, 0.0)[:, 0], 0.5, 0.25)
    plane = Viscoelastic(bonded_layer(nodes, 1e6), 0.25, 0.08)
    spacing = 2.0 * np.pi / nodes
    angle = np.arange(0.0, turn, spacing / 4.0)
    moments = [_roll((ring, plane), angle + s, angular_speed, gap) for s in spacing / 4.0 * np.arange(4)]
    return angle, np.mean(moments, axis=0)


def _roll(bodies, angle, angular_speed, gap):
    nodes = bodies[0].table.size
    spacing, half = 2.0 * np.pi / nodes, round(0.05 * nodes)
    aside = np.abs(np.subtract.outer(np.arange(2 * half + 1), np.arange(2 * half + 1)))

    def contact(psi, shares, load, known):
        row = round(psi / spacing) + np.arange(-half, half + 1)
        height, lever = GAPS[gap](row * spacing - psi)
        compliance = sum(share * body.table for share, body in zip(shares, bodies, strict=True))[aside]
        pressed, _ = press(compliance, height + known[row % nodes], load)
        force = np.zeros(nodes)
        force[row % nodes] = pressed
        return force, lever @ pressed

    force, moment = contact(angle[0], (1.0, 1.0), LOAD, np.zeros(nodes))
    crept = [force] * 2
    moments = [moment]
    for before, psi in itertools.pairwise(angle):
        weights = [body.weights((psi - before) / angular_speed) for body in bodies]
        retarded = [fading * a + old * force for (fading, old, _), a in zip(weights, crept, strict=True)]
        shares = [b.at_once + (1.0 - b.at_once) * new for b, (_, _, new) in zip(bodies, weights, strict=True)]
        known = sum((1.0 - b.at_once) * b.displacement(a) for b, a in zip(bodies, retarded, strict=True))
        force, moment = contact(psi, shares, LOAD, known)
        crept = [a + new * force for (_, _, new), a in zip(weights, retarded, strict=True)]
        moments.append(moment)
    return np.array(moments)


def main(*meshes: int) -> None:
    """Print the largest moment and the steady one for both gaps."""
    for nodes in meshes or (500, 1000, 2000):
        for gap in GAPS:
            angle, moment = start(nodes, gap)
            print(f"{nodes} nodes, {gap}: {moment.max():.4f}, {moment[angle > 1.0].mean():.4f} N", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
