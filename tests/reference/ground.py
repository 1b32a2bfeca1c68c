"""A coated roller rolls over uneven ground, with treads and with an axle: python -m tests.reference.ground [nodes].

The roller is that of `roller_start`. The height of the ground belongs to the rows of the track, that of a tread to the
rows of the roller (docs/theory/ground.md). Contacts are solved with dense matrices, all meshes in one program, in plain
NumPy. Loads, moments, masses and energies are per length.
"""

from __future__ import annotations

import itertools
import sys
from typing import NamedTuple

import numpy as np

from .roller import coating
from .roller_start import LOAD, RADIUS, Viscoelastic, relaxed

MESHES = 4  # phase-shifted meshes


class Rolled(NamedTuple):
    """Mean over the meshes at every step: position and moments, penetration, load, and energies."""

    distance: np.ndarray
    moment: np.ndarray
    penetration: np.ndarray
    load: np.ndarray
    dissipated: np.ndarray
    stored: np.ndarray


def half_sine(height, length, at):
    """Return a bump of half a sine period as a function of the distance."""
    return lambda s: np.where(np.abs(s - at) < 0.5 * length, height * np.cos(np.pi * (s - at) / length), 0.0)


def step(height, at):
    """Return a step."""
    return lambda s: np.where(s >= at, height, 0.0)


def joint(depth, width, at):
    """Return a joint with vertical walls."""
    return lambda s: np.where((s >= at - 0.5 * width) & (s < at + 0.5 * width), -depth, 0.0)


def corrugation(amplitude, period):
    """Return a sinusoidal ground."""
    return lambda s: amplitude * np.sin(2.0 * np.pi * s / period)


def contact(compliance, gap, on_force, on_penetration, value):
    """Return forces >= 0 and the penetration with on_force * (sum of forces) + on_penetration * penetration = value.

    Nodes with forces are pressed together, the others do not overlap. A step drops all pulling nodes and adds the
    overlapping ones.
    """
    count = gap.size
    if on_penetration > 0.0 and value / on_penetration <= gap.min():
        return np.zeros(count), value / on_penetration
    touching = np.arange(count) == gap.argmin()
    if on_penetration > 0.0:
        touching = gap < value / on_penetration
    for _ in range(500):
        nodes = np.flatnonzero(touching)
        size = nodes.size
        system = np.zeros((size + 1, size + 1))
        system[:size, :size] = compliance[np.ix_(nodes, nodes)]
        system[:size, size], system[size, :size] = -1.0, on_force
        system[size, size] = on_penetration
        solution = np.linalg.solve(system, np.append(-gap[nodes], value))
        force, penetration = np.zeros(count), solution[-1]
        force[nodes] = solution[:-1]
        overlap = gap + compliance[:, nodes] @ solution[:-1] - penetration
        pulls, overlaps = force < 0.0, (overlap < -1e-15) & ~touching
        if not pulls.any() and not overlaps.any():
            return force, penetration
        touching = touching & ~pulls if pulls.any() else touching | overlaps
    raise RuntimeError("the contact did not settle")


def roll(ground, *, nodes=1000, speed, end, tread=None, fixed=False, mass=0.0, load=LOAD, steps=4):
    """Roll from rest at the distance 0, relaxed, to a distance; results are means over the phase-shifted meshes.

    Parameters
    ----------
    ground, tread : callable or None
        Height over the distance along the track, and around the roller [m].
    fixed : bool
        Whether the axle stays at the height of the start.
    mass : float
        Mass on the axle [kg/m].
    steps : int
        Time steps per spacing.
    """
    ring = Viscoelastic(coating(nodes).offsets(relaxed, 0.0)[:, 0], 0.5, 0.25)
    spacing = 2.0 * np.pi / nodes
    angle = spacing / steps * np.arange(round(end / RADIUS / spacing * steps) + 1)
    meshes = [_roll(ring, angle, k / MESHES, speed, ground, tread, fixed, mass, load) for k in range(MESHES)]
    return Rolled(RADIUS * angle, *np.mean(meshes, axis=0))


def _roll(ring, angle, shift, speed, ground, tread, fixed, mass, load):
    nodes = ring.table.size
    spacing = 2.0 * np.pi / nodes
    half = round(0.09 * nodes)
    aside = np.abs(np.subtract.outer(np.arange(2 * half + 1), np.arange(2 * half + 1)))
    table = ring.table[aside]
    weight = 1.0 - ring.at_once

    def press(psi, share, known, condition):
        row = round(-psi / spacing - shift) + np.arange(-half, half + 1)
        place = (row + shift) * spacing + psi
        track = -(row + shift) * spacing * RADIUS
        gap = RADIUS * (1.0 - np.cos(place)) - ground(track) + known[row % nodes]
        if tread is not None:
            gap -= tread(track % (2.0 * np.pi * RADIUS))
        pressed, penetration = contact(share * table, gap, *condition)
        force = np.zeros(nodes)
        force[row % nodes] = pressed
        return force, -RADIUS * np.sin(place) @ pressed, penetration

    force, moment, penetration = press(angle[0], 1.0, np.zeros(nodes), (1.0, 0.0, load))
    crept, dissipated, rate, acceleration = force, 0.0, 0.0, 0.0
    start = penetration
    rows = []

    def note():
        stored = 0.5 * ring.at_once * force @ ring.displacement(force)
        stored += 0.5 * weight * crept @ ring.displacement(crept)
        rows.append((moment, penetration, force.sum(), dissipated, stored))

    note()
    for before, psi in itertools.pairwise(angle):
        duration = (psi - before) * RADIUS / speed
        fading, old, new = ring.weights(duration)
        retarded = fading * crept + old * force
        condition = (1.0, 0.0, load)
        if fixed:
            condition = (0.0, 1.0, start)
        elif mass > 0.0:
            inertia = 4.0 * mass / duration**2  # trapezoidal rule, which conserves energy
            condition = (1.0, inertia, load + mass * acceleration + inertia * (penetration + rate * duration))
        known = weight * ring.displacement(retarded)
        last, last_penetration = force, penetration
        force, moment, penetration = press(psi, ring.at_once + weight * new, known, condition)
        if mass > 0.0:
            earlier = acceleration
            acceleration = 4.0 * ((penetration - last_penetration) / duration - rate) / duration - earlier
            rate += 0.5 * duration * (acceleration + earlier)
        dissipated += weight * _loss(duration / ring.retardation_time, force - last, last - crept, ring)
        crept = retarded + new * force
        note()
    return np.array(rows).T


def _loss(z, change, behind, ring):
    """Return the dissipation of a unit weight in a step, divided by it (docs/theory/transient.md, "Energy balance")."""
    q0, q1 = -0.5 * np.expm1(-2.0 * z), np.expm1(-z) ** 2
    q2 = z + 2.0 * np.expm1(-z) + q0
    moved, lagging = ring.displacement(change), ring.displacement(behind)
    return q2 / z**2 * change @ moved + q1 / z * change @ lagging + q0 * behind @ lagging


def main(nodes: int = 1000) -> None:
    """Print the table of docs/theory/ground.md."""
    bump = half_sine(1e-3, 20e-3, 40e-3)
    for speed in (6e-3, 60e-3):
        flat = roll(lambda s: 0.0 * s, nodes=nodes, speed=speed, end=80e-3)
        r = roll(bump, nodes=nodes, speed=speed, end=80e-3)
        there = np.interp([30e-3, 35e-3, 40e-3, 45e-3, 50e-3], r.distance, r.moment)
        print(
            f"bump, {speed * 1e3:g} mm/s: M {np.round(there, 4)}, {r.moment.max():.3f}, {r.moment.min():.3f} N;",
            end=" ",
        )
        print(f"min d {r.penetration.min() * 1e3:.5f} mm; D {r.dissipated[-1]:.4f}, flat {flat.dissipated[-1]:.4f} J/m")
    for speed in (6e-3, 60e-3):
        r = roll(half_sine(0.5e-3, 20e-3, 40e-3), nodes=nodes, speed=speed, end=80e-3, fixed=True)
        top = r.load.argmax()
        print(
            f"fixed height, {speed * 1e3:g} mm/s: P {r.load[top]:.0f} N/m at {r.distance[top] * 1e3:.1f} mm;", end=" "
        )
        print(f"M {r.moment.max():.2f} N")
    for speed in (0.3, 0.6):
        r = roll(bump, nodes=nodes, speed=speed, end=80e-3, mass=500.0)
        top = r.load.argmax()
        print(f"500 kg/m, {speed:g} m/s: P {r.load[top]:.0f} N/m at {r.distance[top] * 1e3:.1f} mm;", end=" ")
        print(f"M/R {r.moment.max() / RADIUS:.0f} N/m; smallest P {r.load.min():.1f} N/m")
    r = roll(step(0.5e-3, 40e-3), nodes=nodes, speed=60e-3, end=80e-3)
    print(f"step: M {r.moment.max():.3f} N, final d {r.penetration[-1] * 1e3:.4f} mm")
    r = roll(joint(1e-3, 6e-3, 40e-3), nodes=nodes, speed=60e-3, end=80e-3)
    print(f"joint: M {r.moment.max():.3f} N, D {r.dissipated[-1]:.4f} J/m")
    r = roll(half_sine(3e-3, 20e-3, 40e-3), nodes=nodes, speed=60e-3, end=60e-3)
    print(f"bump of 3 mm: M {r.moment.max():.2f} N at {r.distance[r.moment.argmax()] * 1e3:.1f} mm")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
