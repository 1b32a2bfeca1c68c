"""Fields of one order inside flat layers and inside a roller, in extended precision.

The fields follow from Hooke's law and equilibrium, by products of matrix exponentials with extra digits. The layers are
given as `interior.Shell`. Flat layers lie below the surface y = 0: the outermost has `outer` = 0, and y is negative.
"""

from __future__ import annotations

import itertools
import math

import mpmath
import numpy as np


class _FlatWaves:
    """Waves e^{i(k x + l z)} in flat layers.

    The state s = (u_n, u_x, u_z, sigma_nn, sigma_nx, sigma_nz) satisfies ds/dy = A s.
    """

    def __init__(self, k, l):  # noqa: E741
        self.derivatives = (mpmath.mpc(0, k), mpmath.mpc(0, l))  # factors i k of d/dx and i l of d/dz
        self.rate = math.hypot(k, l)

    def coordinate(self, place):
        """Return the independent variable of the equations at a place."""
        return mpmath.mpf(place)

    def length(self, _place):
        """Return the factor on stresses in the state."""
        return mpmath.mpf(1)

    def in_plane(self, place, state, mu, nu):
        """Return the strains xx, zz, xz from the displacements."""
        dx, dz = self.derivatives
        return dx * state[1], dz * state[2], (dx * state[2] + dz * state[1]) / 2

    def rates(self, state, mu, nu, inertia):
        """Return A s; `inertia` is rho V^2 [Pa]."""
        a, b = nu / (1 - nu), (1 - 2 * nu) / (2 * (1 - nu))
        dx, dz = self.derivatives
        un, ux, uz, snn, snx, snz = state
        exx, ezz, exz = self.in_plane(None, state, mu, nu)
        sxx = a * snn + 4 * mu * (1 - b) * exx + 2 * mu * a * ezz
        szz = a * snn + 4 * mu * (1 - b) * ezz + 2 * mu * a * exx
        sxz = 2 * mu * exz
        load = inertia * dx * dx  # rho V^2 d^2/dx^2
        return [
            b / mu * snn - a * (exx + ezz),
            snx / mu - dx * un,
            snz / mu - dz * un,
            -dx * snx - dz * snz + load * un,
            -dx * sxx - dz * sxz + load * ux,
            -dx * sxz - dz * szz + load * uz,
        ]


class _RollerWaves:
    """Waves e^{i m phi} in a roller, constant along its axis.

    The methods are those of `_FlatWaves`. The independent variable is ln r, and the state contains stresses times r.
    """

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

    `speed` [m/s] is the speed of the material past the contact; the frequency is k * speed. The base is rigid.
    """
    return _fields(_FlatWaves(k, l), shells, k * speed, speed**2, places, digits)


def roller_fields(shells, angular_speed, m, places, *, digits=50):
    """Return the fields of `flat_fields` for order m of a roller with a rigid core, at places (r, shell number).

    Inertia is not included.
    """
    return _fields(_RollerWaves(m), shells, m * angular_speed, 0.0, places, digits)


def _fields(waves, shells, omega, square_of_speed, places, digits):
    extent = float(abs(waves.coordinate(shells[-1].outer) - waves.coordinate(shells[0].inner)))
    with mpmath.workdps(int(digits + waves.rate * extent + 30)):
        states = mpmath.zeros(6, 3)  # state of each unit stress at the rigid base
        for i in range(3):
            states[3 + i, i] = 1
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
            found[stops[0], number] = (states, mu, nu)
            for start, end in itertools.pairwise(stops):
                interval = waves.coordinate(end) - waves.coordinate(start)
                states = mpmath.expm(matrix * interval, method="taylor") * states
                found[end, number] = (states, mu, nu)
        to_unit_load = mpmath.inverse(states[3:, :]) * waves.length(shells[-1].outer)
        return [_components(waves, p, *found[p, s], to_unit_load) for p, s in places]


def _components(waves, place, states, mu, nu, to_unit_load):
    """Return displacement, stress and strain at a place for a unit stress in each direction on the surface."""
    state = states * to_unit_load
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
