"""Steady sliding of a periodic rigid surface in plain NumPy, with dense matrices and the theory's own axes.

The surface slides along x, the first axis. In its frame a wave exp(i (k_x x + k_z z)) has the frequency -k_x V in the
material, and mu*(-w) is the complex conjugate of mu*(w). With Coulomb friction, all nodes slip: the stress along x on
the layers is the coefficient of friction times the pressure.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm

__all__ = [
    "Solid",
    "contact",
    "half_space",
    "half_space_in_plane",
    "layer",
    "layer_in_plane",
    "loss",
    "symbol",
    "symbols_with_friction",
    "wavenumbers",
]


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


def half_space_in_plane(k, modulus, poisson_ratio):
    """Return displacements per stress of a wave on a half-space, inwards and along the wave [m/Pa].

    K. L. Johnson, Contact Mechanics (1985), equations (2.25), as Fourier coefficients: rows are displacements, columns
    are stresses.
    """
    nu = poisson_ratio
    return np.array([[1.0 - nu, -0.5j * (1.0 - 2.0 * nu)], [0.5j * (1.0 - 2.0 * nu), 1.0 - nu]]) / (modulus * k)


def layer_in_plane(k, modulus, poisson_ratio, thickness):
    """Return the same for a bonded layer, from the matrix exponential of the equations of plane strain.

    The state at depth y is the displacement along the wave and inwards, and the shear and normal stress. The
    exponential loses digits as exp(2 k thickness).
    """
    nu, g, ik = poisson_ratio, modulus, 1j * k
    compliance, ratio = (1.0 - 2.0 * nu) / (2.0 * g * (1.0 - nu)), nu / (1.0 - nu)
    stretch = np.array([-ratio * ik, 0.0, 0.0, compliance])  # dw/dy
    along = np.array([2.0 * g * ik, 0.0, 0.0, 1.0]) - 2.0 * g * stretch  # normal stress along the wave
    rates = np.array([[0.0, -ik, 1.0 / g, 0.0], stretch, -ik * along, [0.0, 0.0, -ik, 0.0]])
    # In units of thickness and modulus, the entries are of order one.
    scale = np.array([thickness, thickness, abs(g), abs(g)])
    to_base = expm(thickness * rates * scale[np.newaxis, :] / scale[:, np.newaxis])
    # The surface stresses are minus the applied ones, given in the order shear, normal; nothing moves at the base.
    moved = np.linalg.solve(to_base[:2, :2], to_base[:2, 2:])[::-1, ::-1]
    return moved * thickness / abs(g)


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


def symbols_with_friction(shape, spacing, modulus, speed, friction, in_plane, across):
    """Return displacements inwards and along x per pressure, of all waves; those of the mean are 0.

    `in_plane` returns the matrix of a wave, from its wavenumber and modulus, and `across` the displacement per stress
    across the wave, both horizontal.
    """
    k_x, k_z = (grid.astype(float) for grid in np.broadcast_arrays(*wavenumbers(shape, spacing)))
    inwards, along = np.zeros(shape, complex), np.zeros(shape, complex)
    for place in np.ndindex(shape):
        k = np.hypot(k_x[place], k_z[place])
        if k == 0.0:
            continue
        g = modulus(-k_x[place] * speed)
        cosine, sine = k_x[place] / k, k_z[place] / k
        inwards[place], parallel = in_plane(k, g) @ [1.0, friction * cosine]
        along[place] = cosine * parallel + friction * sine**2 * across(k, g)
    if shape[0] % 2 == 0:
        inwards[shape[0] // 2] = inwards[shape[0] // 2].real
    return inwards, along


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
