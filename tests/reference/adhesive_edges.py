"""Laws of adhesion for edges finer than the mesh, by quadrature on graded panels and bisection."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

__all__ = ["DUGDALE", "Creep", "edge_factors", "edge_laws"]

#: A cubic law acts on an edge as Dugdale's law of this fraction of its peak.
DUGDALE = 0.75

_PANELS = np.concatenate([[0.0], 10.0 ** np.arange(-14, -1.0), [0.1, 0.25, 0.5]])
_POINTS, _GAUSS = np.polynomial.legendre.leggauss(20)


def _mean(function):
    """Integrate a function of u = √η and of 1 - u from 0 to 1, on panels that shrink towards both ends."""
    total = 0.0
    for low, high in pairwise(_PANELS):
        small = low + 0.5 * (high - low) * (_POINTS + 1.0)
        weights = 0.5 * (high - low) * _GAUSS
        total += weights @ function(small, 1.0 - small) + weights @ function(1.0 - small, small)
    return total


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

    def opening(self, time):
        """Return the mean weighted by the slope of the gap; `time` is that of the passage of the zone."""
        return _mean(lambda u, v: self(v * (1.0 + u) * time) * u * (np.log1p(u) - np.log(v)))

    def intensity(self, time):
        """Return the mean weighted by the distance to the power -1/2."""
        return _mean(lambda u, v: self(v * (1.0 + u) * time))


def _root(function, value, low, high):
    for _ in range(70):
        middle = np.sqrt(low * high)
        low, high = (middle, high) if function(middle) < value else (low, middle)
    return np.sqrt(low * high)


def _edges(creep, strength, speed):
    """Return functions of the length of a zone: works and intensities of both edges."""
    scale = 4.0 / np.pi * strength**2
    return (
        lambda length: scale * length * creep.opening(length / speed),
        lambda length: scale * length * (2.0 * creep.intensity(length / speed) - creep.opening(length / speed)),
        lambda length: 2.0 * scale * length * creep.intensity(length / speed) ** 2,
    )


def _intensities(creep, work, strength, speed):
    """Return K² of the opening edge, its counterpart at the closing edge, and both zones, for Dugdale's law."""
    if np.isinf(strength):
        return 2.0 * work / creep.instantaneous, 2.0 * work * creep.instantaneous, (0.0, 0.0)
    opening, closing, intensity = _edges(creep, strength, speed)
    elastic = np.pi * work / (4.0 * strength**2)
    bounds = 0.1 * elastic / creep.relaxed, 10.0 * elastic / max(creep.instantaneous, 1e-6 * creep.relaxed)
    lengths = _root(opening, work, *bounds), _root(closing, work, *bounds)
    return 8.0 / np.pi * strength**2 * lengths[0], intensity(lengths[1]), lengths


def edge_factors(creep, work, strength, speed):
    """Return G_open/w and G_close/w for Dugdale's law of the given strength."""
    opening, closing, _ = _intensities(creep, work, strength, speed)
    return 0.5 * opening * creep.relaxed / work, 0.5 * closing / creep.relaxed / work


def edge_laws(creep, work, strength, zone, speed):
    """Return peak and work of cubic laws of the opening and the closing edge, with zones of a length on the mesh.

    An edge whose own zone is longer has the given strength and work.
    """
    opening, closing, lengths = _intensities(creep, work, DUGDALE * strength, speed)
    slope, intensity = creep.opening(zone / speed), creep.intensity(zone / speed)
    peaks = np.sqrt(np.pi * opening / (8.0 * zone)), np.sqrt(np.pi * closing / (8.0 * zone)) / intensity
    works = 0.5 * opening * slope, 4.0 / np.pi * peaks[1] ** 2 * zone * (2.0 * intensity - slope)
    return [
        (strength, work) if length > zone else (peak / DUGDALE, mesh_work)
        for length, peak, mesh_work in zip(lengths, peaks, works, strict=True)
    ]
