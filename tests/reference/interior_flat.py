"""Fields of one order inside flat layers and inside a roller to many digits, directly from Hooke's law.

The method multiplies matrix exponentials with extra digits; shells are those of `interior`. Flat layers lie in 0 > y >=
-thickness, the outermost up to y = 0.
"""

from __future__ import annotations

import itertools
import math

import mpmath
import numpy as np


class _Flat:
    """Waves e^{i(k x + l z)}: z' = A z along y, z = (u_n, u_x, u_z, sigma_nn, sigma_nx, sigma_nz)."""

    def __init__(self, k, l):  # noqa: E741
        self.waves = (mpmath.mpc(0, k), mpmath.mpc(0, l))
        self.rate = math.hypot(k, l)

    def coordinate(self, place):
        return mpmath.mpf(place)

    def length(self, _place):
        return mpmath.mpf(1)

    def in_plane(self, place, state, mu, nu):
        """Return the strains xx, zz, xz from the displacements."""
        x, z = self.waves
        return x * state[1], z * state[2], (x * state[2] + z * state[1]) / 2

    def rates(self, state, mu, nu, inertia):
        a, b = nu / (1 - nu), (1 - 2 * nu) / (2 * (1 - nu))
        x, z = self.waves
        un, ux, uz, snn, snx, snz = state
        exx, ezz, exz = self.in_plane(None, state, mu, nu)
        sxx = a * snn + 4 * mu * (1 - b) * exx + 2 * mu * a * ezz
        szz = a * snn + 4 * mu * (1 - b) * ezz + 2 * mu * a * exx
        sxz = 2 * mu * exz
        load = inertia * x * x  # rho V^2 d^2/dx^2
        return [
            b / mu * snn - a * (exx + ezz),
            snx / mu - x * un,
            snz / mu - z * un,
            -x * snx - z * snz + load * un,
            -x * sxx - z * sxz + load * ux,
            -x * sxz - z * szz + load * uz,
        ]


class _Round:
    """Waves e^{i m phi} around the axis, constant along it: in ln r, with stresses times r."""

    def __init__(self, m):
        self.m = mpmath.mpc(0, m)
        self.rate = abs(m) + 1.0

    def coordinate(self, place):
        return mpmath.log(place)

    def length(self, place):
        return mpmath.mpf(place)

    def in_plane(self, place, state, mu, nu):
        return (self.m * state[1] + state[0]) / place, mpmath.mpf(0), self.m * state[2] / (2 * place)

    def rates(self, state, mu, nu, inertia):
        assert not inertia
        a, b = nu / (1 - nu), (1 - 2 * nu) / (2 * (1 - nu))
        ur, up, _, s, t, w = state
        hoop, _, twist = self.in_plane(1, state, mu, nu)
        across = a * s + 4 * mu * (1 - b) * hoop
        return [
            b / mu * s - a * hoop,
            t / mu - self.m * ur + up,
            w / mu,
            s - self.m * t - (s - across),
            t - self.m * across - 2 * t,
            w - self.m * 2 * mu * twist - w,
        ]


def flat_fields(shells, speed, k, l, places, *, digits=50):  # noqa: E741
    """Return displacement, stress and strain per unit surface stress of waves (k, l) [1/m] at places (y, shell number).

    `speed` is that of the material past the contact, so the frequency is k speed. The base is rigid.
    """
    return _fields(_Flat(k, l), shells, k * speed, speed**2, places, digits)


def roller_fields(shells, angular_speed, m, places, *, digits=50):
    """Return the same fields of order m of a roller with a rigid core, at places (r, shell number), without inertia."""
    return _fields(_Round(m), shells, m * angular_speed, 0.0, places, digits)


def _fields(waves, shells, omega, square_of_speed, places, digits):
    extent = float(abs(waves.coordinate(shells[-1].outer) - waves.coordinate(shells[0].inner)))
    with mpmath.workdps(int(digits + waves.rate * extent + 30)):
        z = mpmath.zeros(6, 3)
        for i in range(3):
            z[3 + i, i] = 1
        found = {}
        for number, shell in enumerate(shells):
            mu = shell.shear_modulus(mpmath.mpf(omega))
            nu = shell.poisson(mu)
            columns = [
                waves.rates([mpmath.mpf(int(i == j)) for i in range(6)], mu, nu, shell.density * square_of_speed)
                for j in range(6)
            ]
            matrix = mpmath.matrix(6, 6)
            for j, column in enumerate(columns):
                for i in range(6):
                    matrix[i, j] = column[i]
            stops = sorted({shell.inner, shell.outer, *(p for p, s in places if s == number)})
            found[stops[0], number] = (z, mu, nu)
            for start, end in itertools.pairwise(stops):
                way = waves.coordinate(end) - waves.coordinate(start)
                z = mpmath.expm(matrix * way, method="taylor") * z
                found[end, number] = (z, mu, nu)
        unit = mpmath.inverse(z[3:, :]) * waves.length(shells[-1].outer)
        return [_components(waves, p, *found[p, s], unit) for p, s in places]


def _components(waves, place, z, mu, nu, unit):
    state = z * unit
    displacement, stress, strain = (np.zeros((rows, 3), dtype=complex) for rows in (3, 6, 6))
    for load in range(3):
        u = [state[row, load] for row in range(3)]
        normal = [state[3 + row, load] / waves.length(place) for row in range(3)]
        exx, ezz, exz = waves.in_plane(waves.length(place), u, mu, nu)
        a, b = nu / (1 - nu), (1 - 2 * nu) / (2 * (1 - nu))
        enn = b / mu * normal[0] - a * (exx + ezz)
        strains = [enn, exx, ezz, normal[1] / (2 * mu), normal[2] / (2 * mu), exz]
        stresses = [
            normal[0],
            a * normal[0] + 4 * mu * (1 - b) * exx + 2 * mu * a * ezz,
            a * normal[0] + 4 * mu * (1 - b) * ezz + 2 * mu * a * exx,
            normal[1],
            normal[2],
            2 * mu * exz,
        ]
        displacement[:, load] = [complex(v) for v in u]
        stress[:, load] = [complex(v) for v in stresses]
        strain[:, load] = [complex(v) for v in strains]
    return displacement, stress, strain
