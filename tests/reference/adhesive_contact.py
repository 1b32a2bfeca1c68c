"""Contact with adhesion in plain NumPy: traction law, influence coefficients in closed form, and a dense Newton method.

The coordinate ξ points against the rolling direction, so that material enters the contact at its smallest ξ. Pressure
is positive, attraction negative. Influence coefficients are displacements by a uniform pressure on one cell.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy import special

__all__ = ["Contact", "Law", "NoStateError", "cells", "press", "ring_influence", "solve", "strip_influence"]


class NoStateError(Exception):
    """Newton's method found no state."""


@dataclass
class Law:
    """Cubic potential at each node: σ = σ₀ (1 - g/δ)² up to the gap δ = 3w/σ₀."""

    strength: float | np.ndarray
    work: float | np.ndarray

    @property
    def range(self):
        """Return the gap at which the attraction ends."""
        return 3.0 * self.work / self.strength

    def attraction(self, gap):
        """Return σ."""
        return self.strength * np.clip(1.0 - np.maximum(gap, 0.0) / self.range, 0.0, None) ** 2

    def slope(self, gap):
        """Return -dσ/dg."""
        inside = np.clip(1.0 - np.maximum(gap, 0.0) / self.range, 0.0, None)
        return 2.0 * self.strength / self.range * inside


@dataclass
class Contact:
    """State of a contact: pressure, approach and gap, with the nodes and the operator."""

    x: np.ndarray
    weights: np.ndarray
    influence: np.ndarray
    profile: np.ndarray
    pressure: np.ndarray
    approach: float
    steps: int = 0
    gap: np.ndarray = field(default=None)

    @property
    def load(self):
        """Return the integral of the pressure."""
        return float(self.weights @ self.pressure)

    @property
    def moment(self):
        """Return M = -Σ ξ p."""
        return -float((self.x * self.weights) @ self.pressure)

    @property
    def touching(self):
        """Return which nodes have no gap."""
        return self.gap <= 0.0

    @property
    def half_width(self):
        """Return half of the extent of the cells in contact."""
        touched = self.x[self.touching]
        return 0.5 * (touched[-1] - touched[0] + self.x[1] - self.x[0])

    def second_moment(self):
        """Return the second moment of the pressure about its center."""
        center = float((self.x * self.weights) @ self.pressure) / self.load if self.load else 0.0
        return float(((self.x - center) ** 2 * self.weights) @ self.pressure)


def solve(contact, law, *, load=None, approach=None, most=80):
    """Solve contact and zone at a given load or approach, from a state that is changed in place.

    N = p + σ(g) is the pressure of the hard wall. Each node satisfies min(N, g/k) = 0; k only weights the two.
    """
    influence, weights = contact.influence, contact.weights
    count = contact.x.size
    k = np.abs(np.diag(influence) - influence[0, 1])[0]

    def residual(p, d):
        gap = contact.profile - d + influence @ p
        wall = p + (law.attraction(gap) if law else 0.0)
        touching = wall - gap / k > 0.0
        rows = np.where(touching, gap / k, wall)
        last = 0.0 if load is None else (load - weights @ p) / weights.min()
        return gap, touching, rows, last

    p, d = contact.pressure.copy(), contact.approach if approach is None else approach
    gap, touching, rows, last = residual(p, d)
    scale = max(np.abs(p).max(), np.max(law.strength) if law else 0.0, 1e-300)
    for step in range(most):
        norm = np.hypot(np.linalg.norm(rows), last)
        if norm <= 1e-11 * scale * np.sqrt(count):
            contact.pressure, contact.approach, contact.gap, contact.steps = p, d, np.where(touching, 0.0, gap), step
            return contact
        slope = law.slope(gap) if law else np.zeros(count)
        factor = np.where(touching, 1.0 / k, -slope)
        matrix = np.zeros((count + 1, count + 1))
        matrix[:count, :count] = factor[:, np.newaxis] * influence
        matrix[np.arange(count), np.arange(count)] += np.where(touching, 0.0, 1.0)
        if load is None:
            matrix[count, count] = 1.0
        else:
            matrix[:count, count] = -factor
            matrix[count, :count] = weights / weights.min()
        change = np.linalg.solve(matrix, np.append(-rows, last))
        length = 1.0
        while True:
            trial = residual(p + length * change[:count], d + length * change[count])
            if np.hypot(np.linalg.norm(trial[2]), trial[3]) < norm * (1.0 - 1e-4 * length) or length < 1e-3:
                break
            length *= 0.5
        p, d = p + length * change[:count], d + length * change[count]
        gap, touching, rows, last = trial
    raise NoStateError


def press(contact, load, half_width):
    """Solve the contact without adhesion, from a uniform pressure on the given half-width."""
    inside = np.abs(contact.x) <= half_width
    contact.pressure = np.where(inside, load / contact.weights[inside].sum(), 0.0)
    contact.approach = float(np.mean((contact.profile + contact.influence @ contact.pressure)[inside]))
    return solve(contact, None, load=load)


def cells(start, end, spacing):
    """Return the centers of cells between two ends."""
    count = int(np.ceil((end - start) / spacing))
    return start + spacing * (np.arange(count) + 0.5)


def _scaled_ei(y):
    """Return exp(-y) Ei(y); by its asymptotic series beyond |y| = 40."""
    far = np.abs(y) > 40.0
    near = np.where(far, 1.0, y)
    near = np.where(near == 0.0, 1.0, near)
    terms = 1.0 / np.where(far, y, 1.0)
    series = terms * sum(special.factorial(n) * terms**n for n in range(25))
    return np.where(far, series, np.exp(-near) * special.expi(near))


def _delayed_integral(y):
    """Return the integral over y of ∫ exp(-s) ln|y - s| ds, which is y ln|y| - y - ln|y| + exp(-y) Ei(y)."""
    safe = np.where(y == 0.0, 1.0, np.abs(y))
    return np.where(y == 0.0, np.euler_gamma, y * np.log(safe) - y - np.log(safe) + _scaled_ei(y))


def strip_influence(offsets, width, instantaneous, delayed):
    """Return displacements of a half-plane by a unit pressure on a strip that moves along -ξ.

    Parameters
    ----------
    offsets : ndarray
        Distance ξ - s of the point from the middle of the strip.
    width : float
        Width of the strip.
    instantaneous : float
        J₀.
    delayed : list of (compliance, length)
        Jⱼ, and distance V λⱼ in a retardation time.
    """

    def over_strip(function):
        return function(offsets + 0.5 * width) - function(offsets - 0.5 * width)

    def elastic(y):
        return y * np.log(np.where(y == 0.0, 1.0, np.abs(y))) - y

    value = instantaneous * over_strip(elastic)
    for compliance, length in delayed:
        # ln|x| = ln(length) + ln|y|
        part = length * over_strip(lambda x, length=length: _delayed_integral(x / length))
        value = value + compliance * (part + width * np.log(length))
    return -2.0 / np.pi * value


def ring_influence(radii, edges, modulus):
    """Return displacements of an elastic half-space by unit pressures on rings, as differences of disks."""
    r, c = radii[:, np.newaxis], edges[np.newaxis, :]
    inside = r < c
    small, large = np.where(inside, r, c), np.where(inside, c, r)
    m = np.divide(small, large, out=np.zeros_like(small * large), where=large > 0.0) ** 2
    full, first = special.ellipe(m), special.ellipk(m)
    disk = 4.0 / (np.pi * modulus) * large * np.where(inside, full, full - (1.0 - m) * first)
    return np.diff(disk, axis=1)
