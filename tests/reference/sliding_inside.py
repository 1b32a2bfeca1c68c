"""Stress and displacement inside layers under waves of pressure and friction, in plain NumPy.

A wave exp(i k s) runs along s, and depth d is measured downwards. A pressure P and a shear traction T along s act on
the surface, so that sigma_dd = -P and sigma_sd = -T there. Across the wave, along t, the shear traction is S.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm

__all__ = ["Wave", "half_space_wave", "in_the_frame_of_the_map", "layered_wave"]


class Wave:
    """Amplitudes at one depth: stresses in the frame (s, t, d), and displacements."""

    def __init__(self, ss, dd, sd, tt, st, td, *, inwards=None, along=None):
        self.ss, self.dd, self.sd, self.tt, self.st, self.td = ss, dd, sd, tt, st, td
        self.inwards, self.along = inwards, along


def half_space_wave(k, poisson_ratio, pressure, along, across, depth):
    """Return a wave in a half-space, from Airy's function (A + B d) exp(i k s - k d) and from antiplane shear.

    The stresses do not depend on the modulus.
    """
    decay = np.exp(-k * depth)
    a = pressure / k**2
    b = pressure / k - 1j * along / k
    ss = (k**2 * a - 2.0 * k * b + k**2 * b * depth) * decay
    dd = -(k**2) * (a + b * depth) * decay
    sd = -1j * k * (b - k * a - k * b * depth) * decay
    return Wave(ss, dd, sd, poisson_ratio * (ss + dd), 1j * across * decay, -across * decay)


def layered_wave(k, layers, pressure, along, depth):
    """Return a wave in bonded layers on a rigid base, without shear across, by matrix exponentials of plane strain.

    `layers` has thickness, complex modulus and Poisson's ratio of each layer, from the surface downwards. The state
    contains the displacements along s and inwards, and the stresses sd and dd.
    """

    def rates(modulus, nu):
        ik = 1j * k
        stretch = np.array([-nu / (1.0 - nu) * ik, 0.0, 0.0, (1.0 - 2.0 * nu) / (2.0 * modulus * (1.0 - nu))])
        ss = np.array([2.0 * modulus * ik, 0.0, 0.0, 1.0]) - 2.0 * modulus * stretch
        return np.array([[0.0, -ik, 1.0 / modulus, 0.0], stretch, -ik * ss, [0.0, 0.0, -ik, 0.0]]), ss

    # In units of the first thickness and modulus, the entries are of order one.
    length, stiffness = layers[0][0], abs(layers[0][1])
    scale = np.array([length, length, stiffness, stiffness])

    def moved(start, end):
        """Return the matrix from one depth to another."""
        matrix, top = np.eye(4, dtype=complex), 0.0
        for thickness, modulus, nu in layers:
            step = min(end, top + thickness) - max(start, top)
            if step > 0.0:
                matrix = expm(step * rates(modulus, nu)[0] * scale[np.newaxis, :] / scale[:, np.newaxis]) @ matrix
            top += thickness
        return matrix

    base = sum(thickness for thickness, _, _ in layers)
    stresses = np.array([-along, -pressure]) / stiffness
    to_base = moved(0.0, base)
    surface = np.concatenate([np.linalg.solve(to_base[:2, :2], -to_base[:2, 2:] @ stresses), stresses])
    state = scale * (moved(0.0, depth) @ surface)
    bottoms = np.cumsum([thickness for thickness, _, _ in layers])
    _, modulus, nu = layers[int(np.searchsorted(bottoms, depth * (1.0 - 1e-12)))]
    ss = rates(modulus, nu)[1] @ state
    return Wave(ss, state[3], state[2], nu * (ss + state[3]), 0.0, 0.0, inwards=state[1], along=state[0])


def in_the_frame_of_the_map(wave, cosine, sine):
    """Return the six stresses rr, phiphi, thetatheta, rphi, rtheta, phitheta.

    The direction of the wave is (cosine, sine) in (x, z); r = -d, phi = -x and theta = -z.
    """
    xx = cosine**2 * wave.ss - 2.0 * cosine * sine * wave.st + sine**2 * wave.tt
    zz = sine**2 * wave.ss + 2.0 * cosine * sine * wave.st + cosine**2 * wave.tt
    xz = cosine * sine * (wave.ss - wave.tt) + (cosine**2 - sine**2) * wave.st
    return np.array([wave.dd, xx, zz, cosine * wave.sd - sine * wave.td, sine * wave.sd + cosine * wave.td, xz])
