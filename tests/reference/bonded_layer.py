"""Static contact on a flat layer bonded to a rigid base, to six digits."""

from __future__ import annotations

import math

import numpy as np


def bonded_layer(slenderness, poisson_ratio):
    """Return load and approach of a rigid paraboloid for h = R = G = 1 and the contact radius `slenderness`.

    The pressure is p(r) = int_r^a psi(t) / sqrt(t^2 - r^2) dt, whose Hankel transform is the integral of psi(t)
    sin(kt)/k. The contact condition is then a Fredholm equation of the second kind for psi.
    """
    a, kappa = slenderness, 3.0 - 4.0 * poisson_ratio

    def panels(end, count):
        nodes, weights = np.polynomial.legendre.leggauss(8)
        half = 0.5 * end / count
        return (half * (2 * np.arange(count)[:, None] + 1 + nodes)).ravel(), np.tile(half * weights, count)

    t, dt = panels(a, max(10, math.ceil(a)))
    k, dk = panels(25.0, math.ceil(20 + 12.5 * a))
    e = np.exp(-2.0 * k)
    compliance = (kappa * (1.0 - e * e) - 4.0 * k * e) / (kappa * (1.0 + e * e) + (4.0 * k * k + 1.0 + kappa**2) * e)
    lost = (1.0 - compliance) * dk
    sines = np.sin(np.outer(t, k))
    kernel = np.eye(len(t)) - 2.0 / np.pi * ((sines * lost) @ sines.T) * dt
    psi = np.linalg.solve(kernel, 4.0 * t / (np.pi * (1.0 - poisson_ratio)))
    approach = (1.0 - poisson_ratio) * (psi * dt) @ (0.5 * np.pi - sines @ (lost / k))
    return 2.0 * np.pi * (psi * t) @ dt, approach
