"""Steady sliding of a periodic rigid surface in plain NumPy, with dense matrices and the theory's own axes.

The surface slides along x, the first axis. In its frame a wave exp(i (k_x x + k_z z)) has the frequency -k_x V in the
material, and mu*(-w) is the complex conjugate of mu*(w).
"""

from __future__ import annotations

import numpy as np

__all__ = ["Solid", "contact", "half_space", "layer", "loss", "symbol", "wavenumbers"]


class Solid:
    """Standard linear solid with moduli in Pa and the relaxation time of the modulus in s."""

    def __init__(self, instantaneous, relaxed, time):
        self.instantaneous, self.relaxed, self.time = instantaneous, relaxed, time

    def __call__(self, omega):
        """Return the complex shear modulus, at frequencies of any sign."""
        wt = 1j * omega * self.time
        return self.relaxed + (self.instantaneous - self.relaxed) * wt / (1.0 + wt)


def half_space(k, modulus, poisson_ratio):
    """Return the normal displacement per pressure of waves on a half-space [m/Pa]."""
    return (1.0 - poisson_ratio) / (modulus * k)


def layer(k, modulus, poisson_ratio, thickness):
    """Return the same for a layer that is bonded to a rigid base."""
    q, nu = k * thickness, poisson_ratio
    hard = q > 20.0  # beyond this depth, a layer is a half-space to 16 digits
    q = np.where(hard, 1.0, q)
    ratio = ((3 - 4 * nu) * np.sinh(2 * q) - 2 * q) / (
        (3 - 4 * nu) * np.cosh(2 * q) + 2 * q**2 + 5 - 12 * nu + 8 * nu**2
    )
    return half_space(k, modulus, nu) * np.where(hard, 1.0, ratio)


def wavenumbers(shape, spacing):
    """Return k_x and k_z of all waves of a map, as arrays that broadcast to its shape [rad/m]."""
    k_x, k_z = (2.0 * np.pi * np.fft.fftfreq(count, step) for count, step in zip(shape, spacing, strict=True))
    return k_x[:, np.newaxis], k_z[np.newaxis, :]


def symbol(shape, spacing, modulus, speed, compliance):
    """Return the compliance of all waves; that of the mean is 0, and the highest wave along x is real.

    `compliance` is a function of wavenumber and modulus.
    """
    k_x, k_z = wavenumbers(shape, spacing)
    k = np.hypot(k_x, k_z)
    k[0, 0] = 1.0
    waves = compliance(k, modulus(-k_x * speed) + 0.0 * k)
    waves[0, 0] = 0.0
    if shape[0] % 2 == 0:
        waves[shape[0] // 2] = waves[shape[0] // 2].real
    return waves


def contact(heights, waves, pressure, *, passes=100):
    """Return pressure [Pa] and gap [m] at every node, by an active set with direct solutions."""
    rows, columns = heights.shape
    table = np.fft.ifft2(waves).real
    i, j = (grid.ravel() for grid in np.indices(heights.shape))
    matrix = table[(i[:, np.newaxis] - i) % rows, (j[:, np.newaxis] - j) % columns]
    initial = -heights.ravel()
    touches = np.ones(initial.size, dtype=bool)
    for _ in range(passes):
        inside = np.flatnonzero(touches)
        count = inside.size
        system = np.ones((count + 1, count + 1))
        system[:count, :count] = matrix[np.ix_(inside, inside)]
        system[count, count] = 0.0
        system[:count, count] = -1.0
        solved = np.linalg.solve(system, [*-initial[inside], pressure * initial.size])
        p = np.zeros(initial.size)
        p[inside] = solved[:count]
        gap = initial + matrix @ p - solved[count]
        changed = (touches & (p > 0.0)) | (~touches & (gap < -1e-12 * np.ptp(initial)))
        if (changed == touches).all():
            return p.reshape(heights.shape), gap.reshape(heights.shape)
        touches = changed
    raise RuntimeError("the active set did not settle")


def loss(pressure, waves, spacing):
    """Return the energy dissipated per area and distance [Pa]."""
    k_x, _ = wavenumbers(pressure.shape, spacing)
    return float((k_x * waves.imag * np.abs(np.fft.fft2(pressure, norm="forward")) ** 2).sum())
