"""Laws of adhesion for edges finer than the mesh, with a piecewise linear traction in the cohesive zone.

The solver uses polynomials in the square root of the distance, and Newton's method for the traction alone.
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np

__all__ = ["ELASTIC_ZONE", "Creep", "edge", "edge_factors", "edge_laws"]

#: Length of the cubic zone of an elastic edge, relative to the cohesive length E* w / σ₀².
ELASTIC_ZONE = 2.495


class Creep:
    """Creep compliance J₀ + Σ Jⱼ (1 - exp(-t/λⱼ))."""

    def __init__(self, instantaneous, delayed):
        self.instantaneous, self.delayed = instantaneous, delayed

    @property
    def relaxed(self):
        """Return J(∞)."""
        return self.instantaneous + sum(compliance for compliance, _ in self.delayed)

    def __call__(self, time):
        """Return J(t)."""
        return self.instantaneous - sum(compliance * np.expm1(-time / delay) for compliance, delay in self.delayed)


class _Zone:
    """Matrices for a traction that is linear between points 0 <= s <= 1."""

    def __init__(self, count):
        # √s has even steps at the contact, and decreasing ones at the end of the zone.
        self.s = s = (1.0 - (1.0 - np.linspace(0.0, 1.0, count + 1)) ** 1.5) ** 2
        x, t = s[:, np.newaxis], s[np.newaxis, :]
        with np.errstate(divide="ignore", invalid="ignore"):
            log = np.where(x == t, 0.0, np.log((np.sqrt(x) + np.sqrt(t)) / np.abs(np.sqrt(x) - np.sqrt(t))))
        zeroth = (t - x) * log + 2.0 * np.sqrt(x * t)  # integral of the logarithm over t
        first = 0.5 * (t**2 - x**2) * log + np.sqrt(x) * (t**1.5 / 3.0 + x * np.sqrt(t))  # of t times the logarithm
        self.intensity = np.sqrt(2.0 / np.pi) * self._linear(2.0 * np.sqrt(s), 2.0 / 3.0 * s**1.5)
        self.moment = self._linear(2.0 / 3.0 * s**1.5, 0.4 * s**2.5)
        self.elastic = 4.0 * np.sqrt(x / (2.0 * np.pi)) * self.intensity - 2.0 / np.pi * self._linear(zeroth, first)

    def _linear(self, zeroth, first):
        """Return the weights of the values at the points, from antiderivatives of a kernel and of t times it."""
        weights = np.zeros_like(zeroth)
        whole = np.diff(zeroth)
        upper = (np.diff(first) - self.s[:-1] * whole) / np.diff(self.s)
        weights[..., 1:] += upper
        weights[..., :-1] += whole - upper
        return weights

    def creep(self, creep, time, *, opens):
        """Return the convolution of J with a function of the time; material enters at s = 0 if the edge opens."""
        count = self.s.size
        total = creep.relaxed * np.eye(count)
        order = np.arange(count) if opens else np.arange(count)[::-1]
        for compliance, delay in creep.delayed:
            rest = np.zeros((count, count))
            for before, after in pairwise(order):
                step = abs(self.s[after] - self.s[before]) * time / delay
                rest[after] = np.exp(-step) * rest[before]
                rest[after, after] += -np.expm1(-step) / step
                rest[after, before] += np.expm1(-step) / step
            rest[:, order[0]] = 0.0  # gap and traction begin at zero
            total = total - compliance * rest
        return total


_zone = cache(_Zone)


def edge(creep, time, *, opens, regular=0.0, count=100):
    """Return w and K (opening) or K_c (closing) of a cubic zone of unit length and unit peak.

    Parameters
    ----------
    creep : Creep
        Creep compliance.
    time : float
        Time in which material passes the zone.
    opens : bool
        Whether the edge opens.
    regular : float
        B l/K: the next term of the pressure ahead of the edge, B √r.
    count : int
        Number of elements.
    """
    zone = _zone(count)
    s, unit = zone.s, np.eye(zone.s.size)
    convolution = zone.creep(creep, time, opens=opens)
    force, gap_of = (unit, convolution) if opens else (convolution, unit)
    elastic = gap_of @ zone.elastic @ force
    hertz = regular * gap_of @ (4.0 / 3.0 * s**1.5)
    intensity, moment = zone.intensity @ force, 2.0 * regular * zone.moment @ force
    traction, inverse_range = (1.0 - s) ** 2, None
    for _ in range(100):
        shift, root = moment @ traction, np.hypot(moment @ traction, intensity @ traction)
        total = shift + root
        slope = moment + (shift * moment + (intensity @ traction) * intensity) / root
        gap, gap_slope = elastic @ traction + total * hertz, elastic + np.outer(hertz, slope)
        if inverse_range is None:
            inverse_range = 1.0 / gap[-1]
        rest = np.clip(1.0 - inverse_range * gap, 0.0, None)
        residual = np.append(traction - rest**2, inverse_range * gap[-1] - 1.0)
        if np.abs(residual).max() < 1e-12:
            break
        matrix = np.block(
            [
                [unit + 2.0 * inverse_range * rest[:, np.newaxis] * gap_slope, (2.0 * rest * gap)[:, np.newaxis]],
                [inverse_range * gap_slope[-1:], gap[-1:, np.newaxis]],
            ]
        )
        change = np.linalg.solve(matrix, residual)
        traction, inverse_range = traction - change[:-1], inverse_range - change[-1]
    return 1.0 / (3.0 * inverse_range), total


def _root(function, value, low, high):
    for _ in range(40):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if function(middle) < value else (low, middle)
    return np.sqrt(low * high)


def _intensities(creep, work, strength, speed):
    """Return K of the opening edge, K_c of the closing edge, and the lengths of both zones."""
    if np.isinf(strength):
        return np.sqrt(2.0 * work / creep.instantaneous), np.sqrt(2.0 * work * creep.instantaneous), (0.0, 0.0)
    intensities, lengths = [], []
    for opens in (True, False):
        elastic = ELASTIC_ZONE * work / strength**2
        bounds = 0.1 * elastic / creep.relaxed, 10.0 * elastic / creep.instantaneous

        def work_of(length, opens=opens):
            return strength**2 * length * edge(creep, length / speed, opens=opens)[0]

        lengths.append(_root(work_of, work, *bounds))
        intensities.append(strength * np.sqrt(lengths[-1]) * edge(creep, lengths[-1] / speed, opens=opens)[1])
    return *intensities, lengths


def edge_factors(creep, work, strength, speed):
    """Return G_open/w and G_close/w for a cubic law of the given strength."""
    opening, closing, _ = _intensities(creep, work, strength, speed)
    return 0.5 * opening**2 * creep.relaxed / work, 0.5 * closing**2 / creep.relaxed / work


def edge_laws(creep, work, strength, zone, speed, half_width, pressure):
    """Return peak and work of cubic laws of the opening and the closing edge, with zones of a length on the mesh.

    An edge whose own zone is longer has the given strength and work. The second term of the pressure ahead of an edge
    follows from the half-width of the contact and the pressure at its center.
    """
    opening, closing, lengths = _intensities(creep, work, strength, speed)
    root = np.sqrt(np.pi * half_width)
    tensions = opening / root, closing / root / creep(half_width / speed)
    laws = []
    for i, (intensity, opens) in enumerate(((opening, True), (closing, False))):
        if lengths[i] > zone:
            laws.append((strength, work))
            continue
        twice = max(2.0 * pressure + 1.25 * tensions[i] + 0.5 * tensions[1 - i], 0.0)
        regular = twice / (np.sqrt(2.0 * np.pi) * tensions[i]) * zone / half_width
        unit_work, unit_intensity = edge(creep, zone / speed, opens=opens, regular=regular)
        peak = intensity / unit_intensity / np.sqrt(zone)
        laws.append((peak, peak**2 * zone * unit_work))
    return laws
