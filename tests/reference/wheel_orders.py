"""Closed forms of the orders of a wheel's tread: Bessel functions of the order and the axial wave number.

With Z_m a modified Bessel function of either kind and e = exp(i (m phi + k z)), displacements in a tube are sums of

    grad(Z_m e),   curl(Z_m e e_z),   4 (1 - nu) B - grad(r B_r)   with   B = Z_{m+1} e (e_r - i e_phi),

the last of which is Papkovich's and Neuber's (Y. C. Fung and P. Tong, Classical and Computational Solid Mechanics,
section 8.6): B is harmonic, since e_r - i e_phi = exp(i phi) (e_x - i e_y). Its divergence is 2 (1 - 2 nu) div B, so
that the pressure of an incompressible tread is finite.
"""

from __future__ import annotations

import functools

import mpmath
import numpy as np

DIGITS = 40


@functools.cache
def _bessel(kind, order, x, slopes=0):
    """Return I (kind 1) or K (kind -1), or a derivative."""
    if slopes == 0:
        return (mpmath.besseli if kind > 0 else mpmath.besselk)(order, x)
    return kind * (_bessel(kind, order - 1, x, slopes - 1) + _bessel(kind, order + 1, x, slopes - 1)) / 2


def _solution(kind, field, m, k, nu, r):
    """Return displacement along r, phi and z, its radial derivative, and the pressure lambda div u / modulus."""
    order = m + 1 if field == "pressure" else m
    f, df, ddf = (k**slopes * _bessel(kind, order, k * r, slopes) for slopes in (0, 1, 2))
    if field == "gradient":
        return [df, 1j * m * f / r, 1j * k * f], [ddf, 1j * m * (df / r - f / r**2), 1j * k * df], 0
    if field == "curl":
        return [1j * m * f / r, -df, 0], [1j * m * (df / r - f / r**2), -ddf, 0], 0
    share = 4 * (1 - nu)
    u = [share * f - f - r * df, -1j * (share + m) * f, -1j * k * r * f]
    du = [share * df - 2 * df - r * ddf, -1j * (share + m) * df, -1j * k * (f + r * df)]
    return u, du, 4 * nu * (df + (1 + m) * f / r)  # lambda div u = 4 mu nu div B


def _fields(kind, field, m, k, nu, r):
    """Return displacement along r, phi and z, stress / modulus, and strain, as rr, phiphi, zz, rphi, rz, phiz."""
    u, du, pressure = _solution(kind, field, m, k, nu, r)
    strain = [
        du[0],
        (1j * m * u[1] + u[0]) / r,
        1j * k * u[2],
        (1j * m / r * u[0] + du[1] - u[1] / r) / 2,
        (1j * k * u[0] + du[2]) / 2,
        (1j * k * u[1] + 1j * m / r * u[2]) / 2,
    ]
    stress = [2 * strain[i] + (pressure if i < 3 else 0) for i in range(6)]
    return u + stress + strain


def _all_fields(m, k, nu, r):
    """Return six columns of displacement, stress / modulus and strain."""
    return mpmath.matrix(
        [_fields(kind, field, m, k, nu, r) for kind in (1, -1) for field in ("gradient", "curl", "pressure")]
    ).T


def _solutions(m, k, nu, r):
    """Return six columns of displacement and of stress / modulus on the surface r = const."""
    fields = _all_fields(m, k, nu, r)
    return mpmath.matrix([[fields[row, column] for column in range(6)] for row in (0, 1, 2, 3, 6, 7)])


def _amplitudes(hub, layers, m, k):
    """Return amplitudes of the six solutions of all layers under each of three surface stresses, (6 layers, 3)."""
    size = 6 * len(layers)
    matrix = mpmath.zeros(size)
    scales = []
    radius = mpmath.mpf(hub)
    for j, (thickness, modulus, nu) in enumerate(layers):
        units = [1] * 3 + [mpmath.mpmathify(modulus)] * 3
        inner = _solutions(m, k, mpmath.mpf(nu), radius)
        radius += mpmath.mpf(thickness)
        outer = _solutions(m, k, mpmath.mpf(nu), radius)
        # Scale the columns to similar sizes; they may be 1e-70 and 1e70.
        for column in range(6):
            size_of = max(abs(value) for value in [*inner[:, column], *outer[:, column]])
            inner[:, column] /= size_of
            outer[:, column] /= size_of
            scales.append(size_of)
        # Continuity between layers; the hub fixes displacements, and the surface has given stresses.
        for row in range(6):
            for column in range(6):
                if j > 0 or row < 3:
                    matrix[6 * j + row - (3 if j > 0 else 0), 6 * j + column] -= units[row] * inner[row, column]
                if j < len(layers) - 1:
                    matrix[6 * j + 3 + row, 6 * j + column] += units[row] * outer[row, column]
                elif row >= 3:
                    matrix[6 * j + row, 6 * j + column] += units[row] * outer[row, column]
    amplitudes = mpmath.zeros(size, 3)
    for direction in range(3):
        load = mpmath.zeros(size, 1)
        load[size - 3 + direction] = 1
        solved = mpmath.lu_solve(matrix, load)
        for row in range(size):
            amplitudes[row, direction] = solved[row] / scales[row]
    return amplitudes


def order_fields(hub, layers, m, k, places):
    """Return inner displacement, stress and strain per surface stress, (3 or 6, 3) [m/Pa], [-], [1/Pa].

    Parameters
    ----------
    hub, layers, m, k
        Same as in `surface_compliance`.
    places : list of (radius, layer)
        Radius [m], and number of the layer from the hub outwards.
    """
    with mpmath.workdps(DIGITS):
        k = mpmath.mpf(k)
        amplitudes = _amplitudes(hub, layers, m, k)
        found = []
        for radius, layer in places:
            _, modulus, nu = layers[layer]
            units = [1] * 3 + [mpmath.mpmathify(modulus)] * 6 + [1] * 6
            fields = _all_fields(m, k, mpmath.mpf(nu), mpmath.mpf(radius)) * amplitudes[6 * layer : 6 * layer + 6, :]
            values = [[units[row] * fields[row, column] for column in range(3)] for row in range(15)]
            values = np.array(values, dtype=complex)
            found.append((values[:3], values[3:9], values[9:]))
        return found


def surface_compliance(hub, layers, m, k):
    """Return the displacement per stress [m/Pa] at the surface of layers on a rigid hub, along r, phi and z.

    Parameters
    ----------
    hub : float
        Radius of the hub [m].
    layers : list of (thickness, modulus, nu)
        Layers from the hub outwards [m], [Pa]; moduli may be complex.
    m : int
        Order around the axis.
    k : float
        Wave number across [1/m], > 0.
    """
    with mpmath.workdps(DIGITS):
        surface = mpmath.fsum([hub, *(thickness for thickness, _, _ in layers)])
    ((displacement, _, _),) = order_fields(hub, layers, m, k, [(surface, len(layers) - 1)])
    return displacement
