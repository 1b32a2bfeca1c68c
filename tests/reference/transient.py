"""Transient rolling of the ball of section 14, without friction: python -m tests.reference.transient.

The memory is one force per node: the solid acts as a spring with the instantaneous compliance J_0 in series with a
retarded spring J_1 (docs/theory/transient.md). The contact at each instant is solved with dense matrices, and a ring of
nodes rotates with the ball.
"""

from __future__ import annotations

import sys

import numpy as np

from .one_layer import Table, ball_equations, press, rubber, window

AT_ONCE, RETARDATION_TIME = 0.5, 0.25  # mu*(0)/mu* = 0.5 + 0.5 / (1 + 0.25 s): G_inf/G_0, and tau G_0/G_inf
RADIUS = 21e-3


class Ring:
    """The elastic ball with its relaxed modulus: compliance between nodes, and displacements of all nodes."""

    def __init__(self, nodes, half):
        """Tabulate all offsets of a ring as wide as the window."""
        self.nodes, self.half = nodes, half
        self.table = Table(ball_equations, 20e-3, RADIUS, nodes, 2 * half + 1).offsets(rubber, 0.0)
        both_sides = np.hstack([self.table, np.zeros((nodes, 2 * half)), self.table[:, :0:-1]])
        self.width = both_sides.shape[1]
        self.transform = np.fft.rfft2(both_sides)

    def displacement(self, force):
        """Return the displacement of all nodes [m], shape (nodes, 2 half + 1), due to forces [N]."""
        spread = np.fft.rfft2(force, s=(self.nodes, self.width))
        return np.fft.irfft2(self.transform * spread, s=(self.nodes, self.width))[:, : 2 * self.half + 1]

    def contact(self, angle, load, known):
        """Return forces of the ring, their moment and the depth at an angle; `known` is the given displacement."""
        spacing = 2.0 * np.pi / self.nodes
        first = round(-angle / spacing)
        row, column, x, height = window(RADIUS, self.nodes, self.half, self.half, start=angle + first * spacing)
        place = (row + first) % self.nodes, column + self.half
        compliance = self.table[(row[:, None] - row) % self.nodes, np.abs(column[:, None] - column)]
        pressed, depth = press(compliance, height + known[place], load)
        assert np.abs(row[pressed > 0.0]).max() < self.half, "the window is too short"
        force = np.zeros((self.nodes, 2 * self.half + 1))
        force[place] = pressed
        return force, x @ pressed, depth


def roll(time, angle, load, *, relaxed, ring):
    """Return torques [N m] and depths [m] at the instants; forces are linear between them, and equal times are a jump.

    At the first instant, the ball is pressed in zero time or, if `relaxed`, has supported the load permanently.
    """
    nothing = np.zeros((ring.nodes, 2 * ring.half + 1))
    share = 1.0 if relaxed else AT_ONCE
    scaled, torque, depth = ring.contact(angle[0], share * load[0], nothing)
    force, torques, depths = scaled / share, [torque / share], [depth]
    crept = force if relaxed else nothing
    for step, psi, bearing in zip(np.diff(time), angle[1:], load[1:], strict=True):
        z = step / RETARDATION_TIME
        fading = np.exp(-z)
        mean = -np.expm1(-z) / z if z > 0.0 else 1.0
        before = fading * crept + (mean - fading) * force
        share = AT_ONCE + (1.0 - AT_ONCE) * (1.0 - mean)
        known = (1.0 - AT_ONCE) * ring.displacement(before)
        scaled, torque, depth = ring.contact(psi, share * bearing, known)
        force = scaled / share
        crept = before + (1.0 - mean) * force
        torques.append(torque / share)
        depths.append(depth)
    return np.array(torques), np.array(depths)


def start(angular_speed, turn, relaxed, nodes):
    """Return angles and torques of rolling that starts at once, the mean of four phase-shifted meshes.

    Each mesh takes eight steps per spacing.
    """
    ring = Ring(nodes, round(0.030 * nodes))
    spacing = 2.0 * np.pi / nodes
    angle = np.arange(0.0, turn + spacing / 8.0, spacing / 8.0)
    shifts = spacing / 4.0 * np.arange(4)
    load = np.full(angle.size, 100.0)
    found = [roll(angle / angular_speed, angle + s, load, relaxed=relaxed, ring=ring)[0] for s in shifts]
    return angle, np.mean(found, axis=0)


def main(*meshes: int) -> None:
    """Print torques of the starts of docs/theory/transient.md, at 0.05, 0.1, 0.2 and 0.3 rad, and the largest."""
    for nodes in meshes or (300, 500):
        for angular_speed, relaxed in ((2.5, False), (2.5, True), (0.5, False), (0.5, True)):
            angle, torque = start(angular_speed, 0.35, relaxed, nodes)
            found = [*np.interp([0.05, 0.1, 0.2, 0.3], angle, torque), torque.max()]
            print(f"{nodes} nodes, {'relaxed' if relaxed else 'undeformed'}, {angular_speed} rad/s:", end=" ")
            print(", ".join(f"{1e3 * value:.2f}" for value in found), "mN m", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
