"""A ball or roller with one incompressible layer on a rigid core: compliance of orders, tables of offsets, contact.

For a single layer with a real Poisson's ratio, the compliance of an order is G / mu*(m Omega), where the real number G
does not depend on the modulus, so it is computed once. Forces and displacements are normal to the surface.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import expm
from scipy.special import erfc
from viscoroll.reproduce.plain import Layer, system_matrix

# The sums end smoothly at this multiple of the nodes per revolution, which leaves an error of 1e-7 of the torque.
FOLDS = 8


def rubber(omega):
    """Return the complex modulus [Pa] of the solid of section 14: 3 and 6 MPa, 0.125 s."""
    rate = 0.125j * np.asarray(omega)
    return 3e6 + 3e6 * rate / (1.0 + rate)


def ball_equations(k):
    """Return B of dz/d(ln r) = B z along a wave, z = (u_r, u_k, r sigma_rr, r sigma_rk): equation (26) at r = 1."""
    layer = Layer(inner=0.0, outer=1.0, shear_modulus=np.ones_like, poisson_ratio=0.5)
    in_plane = [0, 1, 3, 4]
    return system_matrix(layer, 0.0, k, 0.0, 1.0)[..., in_plane, :][..., in_plane] + np.diag([0.0, 0.0, 1.0, 1.0])


def roller_equations(k):
    """Return B of `ball_equations` in plane strain, with u_k and sigma_rk divided by i (docs/theory/rollers.md)."""
    one, zero = np.ones_like(k), np.zeros_like(k)
    rows = [
        [-one, k, zero, zero],
        [-k, one, zero, one],
        [4.0 * one, -4.0 * k, one, k],
        [-4.0 * k, 4.0 * k**2, -k, -one],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def layer_compliance(equations, core_radius, radius, highest):
    """Return G(k) [m] up to `highest`: outward displacement due to an outward traction of wave number k, modulus 1."""
    k = np.concatenate([np.arange(0.0, 8.0, 0.125), np.geomspace(8.0, highest, 400)])
    # Material 40 e-folds below the surface has no effect on it.
    thickness = np.minimum(np.log(radius / core_radius), 40.0 / np.maximum(k, 1.0))
    step = expm((thickness / 10.0)[:, None, None] * equations(k))
    y = np.zeros((k.size, 2, 2))
    for _ in range(10):
        y = (step[:, :2, :2] @ y + step[:, :2, 2:]) @ np.linalg.inv(step[:, 2:, :2] @ y + step[:, 2:, 2:])
    return CubicSpline(k, radius * y[:, 0, 0].real)


def patch(orders, nodes):
    """Return the transform of a patch as wide as the spacing, times the smooth truncation, at each order."""
    return np.sinc(orders / nodes) * 0.5 * erfc(4.8 * (orders / (FOLDS * nodes) - 1.0))


class Table:
    """Displacements at offsets of whole nodes due to a unit force on one of them, for one layer and any modulus."""

    def __init__(self, equations, core_radius, radius, nodes, columns):
        """Sum over the orders along the axis; a roller has one column, and loads per length."""
        self.radius, self.nodes = radius, nodes
        self.orders = np.arange(1.5 * FOLDS * nodes)
        compliance = layer_compliance(equations, core_radius, radius, 1.5 * FOLDS * nodes * np.sqrt(2.0))
        twice = np.where(self.orders == 0.0, 1.0, 2.0) * patch(self.orders, nodes) / (2.0 * np.pi * radius)
        if columns == 1:
            self.across = (twice * compliance(self.orders))[:, None]
            return
        cosines = twice[:, None] * np.cos(2.0 * np.pi / nodes * np.outer(self.orders, np.arange(columns)))
        self.across = np.array([compliance(np.hypot(m, self.orders)) @ cosines for m in self.orders]) * twice[:, None]

    def offsets(self, modulus, angular_speed):
        """Return the table [m/N]: offsets 0 ... nodes - 1 backward, on a ring, and 0 ... columns - 1 sideways."""
        weights = self.across / modulus(self.orders * angular_speed)[:, None]
        folded = np.zeros((self.nodes, weights.shape[1]), complex)
        np.add.at(folded, self.orders.astype(int) % self.nodes, weights)
        return self.nodes * np.fft.ifft(folded, axis=0).real


def window(radius, nodes, half, half_across, start=0.0):
    """Return rows and columns of nodes around the lowest point, their x and height above the plane [m], as lists."""
    spacing = 2.0 * np.pi / nodes
    row, column = (a.ravel() for a in np.mgrid[-half : half + 1, -half_across : half_across + 1])
    place = row * spacing + start
    x = radius * np.cos(column * spacing) * np.sin(-place)
    return row, column, x, radius * (1.0 - np.cos(column * spacing) * np.cos(place))


def press(compliance, height, load):
    """Return the forces on a plane with the given sum, without tension and overlap, and the depth."""
    touching = height <= np.sort(height)[height.size // 4]
    for _ in range(100):
        inside = np.flatnonzero(touching)
        system = np.ones((inside.size + 1, inside.size + 1))
        system[:-1, :-1] = compliance[np.ix_(inside, inside)]
        system[:-1, -1], system[-1, -1] = -1.0, 0.0
        *pressed, depth = np.linalg.solve(system, [*-height[inside], load])
        force = np.zeros(height.size)
        force[inside] = pressed
        now = np.where(touching, force > 0.0, compliance @ force + height - depth < 0.0)
        if (now == touching).all():
            return force, depth
        touching = now
    raise AssertionError("the contact did not settle")


def steady(table, angular_speed, load, half, half_across=0):
    """Return the resisting torque [N m] and the depth [m] of steady rolling, from a window of nodes."""
    row, column, x, height = window(table.radius, table.nodes, half, half_across)
    offsets = table.offsets(rubber, angular_speed)
    compliance = offsets[(row[:, None] - row) % table.nodes, np.abs(column[:, None] - column)]
    force, depth = press(compliance, height, load)
    touched = force > 0.0
    assert np.abs(row[touched]).max() < half, "the window is too short"
    return float(x @ force), float(depth)
