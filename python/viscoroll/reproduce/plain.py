"""Method of the paper in plain NumPy: product (32) over radial sub-intervals, and contact condition (50).

This module shares no code with the solver, so that the tests and figure 4 can compare the two. In every array the axes
of the orders m and n come first: orders of shape (...) give matrices of shape (..., 6, 6) or (..., 3, 3).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Complexes = NDArray[np.complex128]
    Floats = NDArray[np.float64]

__all__ = [
    "Layer",
    "exponential",
    "extrapolated_compliance",
    "product_compliance",
    "prony",
    "shorthand",
    "solve_normal_contact",
    "sub_intervals",
    "surface_compliance",
    "system_matrix",
]


@dataclass
class Layer:
    """Layer with radii [m], shear modulus mu(omega) [Pa], Poisson's ratio [-] and density [kg/m^3]."""

    inner: float
    outer: float
    shear_modulus: Callable[[Any], Any]
    poisson_ratio: float
    density: float = 0.0


def prony(instantaneous: float, weights: Sequence[float], times: Sequence[float], omega: ArrayLike) -> Complexes:
    """Return equation (65): mu* = G0 (g_inf + sum_k g_k (w^2 tau^2 + i w tau) / (1 + w^2 tau^2))."""
    omega = np.asarray(omega, float)
    modulus = np.full(omega.shape, 1.0 - sum(weights), complex)
    for g, tau in zip(weights, times, strict=True):
        modulus += g * (omega**2 * tau**2 + 1j * omega * tau) / (1.0 + omega**2 * tau**2)
    return np.asarray(instantaneous * modulus, complex)


def shorthand(layer: Layer, angular_speed: float, m: Floats, radius: float) -> tuple[Any, ...]:
    """Return mu and S1 to S5 of equations (24), in a form without a special case for Poisson's ratio 1/2.

    At this ratio the Lame parameter lambda is infinite. With a = lambda / (lambda + 2 mu) and b = mu / (lambda + 2 mu):
    S1 = b / mu, S2 = a / r, S3 = b / r, S4 = mu (3a + 2b) / r^2, S5 = mu (a + b) / r^2.
    """
    nu = layer.poisson_ratio
    omega = m * angular_speed
    mu = np.where(omega < 0, np.conj(layer.shear_modulus(abs(omega))), layer.shear_modulus(abs(omega)))
    a = nu / (1.0 - nu)
    b = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu))
    return mu, b / mu, a / radius, b / radius, mu * (3 * a + 2 * b) / radius**2, mu * (a + b) / radius**2


def system_matrix(layer: Layer, angular_speed: float, m: ArrayLike, n: ArrayLike, radius: float) -> Complexes:
    """Return A(r) of (26): dq/dr = A(r) q with q = (u_r, u_phi, u_theta, sigma_rr, sigma_rphi, sigma_rtheta)."""
    m, n = np.broadcast_arrays(np.asarray(m, float), np.asarray(n, float))
    mu, s1, s2, s3, s4, s5 = shorthand(layer, angular_speed, m, radius)
    inertia = layer.density * angular_speed**2
    s6 = 4 * s4 - inertia * (1 + m**2)
    s7 = 2j * m * (s4 - inertia)
    s8 = 4 * m**2 * s5 + n**2 * mu / radius**2 - inertia * (1 + m**2)
    s9 = 4 * n**2 * s5 + m**2 * mu / radius**2 - inertia * m**2
    r = radius
    zero, one = np.zeros(m.shape), np.ones(m.shape)
    rows = [
        [-2 * s2 * one, -1j * m * s2, -1j * n * s2, s1, zero, zero],
        [-1j * m / r, one / r, zero, zero, 1 / mu, zero],
        [-1j * n / r, zero, one / r, zero, zero, 1 / mu],
        [s6, s7, 2j * n * s4, -4 * s3 * one, -1j * m / r, -1j * n / r],
        [-s7, s8, m * n * s4, -1j * m * s2, -3 * one / r, zero],
        [-2j * n * s4, m * n * s4, s9, -1j * n * s2, zero, -3 * one / r],
    ]
    return np.stack([np.stack([entry + 0j * one for entry in row], axis=-1) for row in rows], axis=-2)


def exponential(matrix: Complexes) -> Complexes:
    """Return exp(matrix) by scaling and squaring of its Taylor series, with balanced displacements and stresses."""
    unit = np.sqrt(np.abs(matrix[..., 3:, :3]).max() / np.abs(matrix[..., :3, 3:]).max())
    units = np.repeat([1.0, unit], 3)
    balanced = matrix * units / units[:, None]
    norm = np.abs(balanced).sum(axis=-1).max()
    squarings = max(0, int(np.ceil(np.log2(norm))) + 1)
    term: Complexes = np.broadcast_to(np.eye(6, dtype=complex), matrix.shape)
    result = term
    for k in range(1, 19):
        term = term @ (balanced / 2.0**squarings) / k
        result = result + term
    for _ in range(squarings):
        result = result @ result
    return np.asarray(result * units[:, None] / units, complex)


def sub_intervals(
    layer: Layer, angular_speed: float, m: ArrayLike, n: ArrayLike, count: int, alpha: float = 0.5
) -> Iterator[Complexes]:
    """Yield the factors of equation (32) in one layer: exp(dr A(r_i + (k - alpha) dr)) for k = 1 ... count."""
    step = (layer.outer - layer.inner) / count
    for k in range(1, count + 1):
        yield exponential(step * system_matrix(layer, angular_speed, m, n, layer.inner + (k - alpha) * step))


def product_compliance(
    layers: Sequence[Layer], angular_speed: float, m: ArrayLike, n: ArrayLike, count: int
) -> Complexes:
    """Return T12 T22^-1 of the whole product, literally as in (31), (32) and (34); it overflows for thick coatings."""
    transition = np.eye(6, dtype=complex)
    for layer in layers:
        for factor in sub_intervals(layer, angular_speed, m, n, count):
            transition = factor @ transition
    return np.asarray(transition[..., :3, 3:] @ np.linalg.inv(transition[..., 3:, 3:]), complex)


def surface_compliance(
    layers: Sequence[Layer], angular_speed: float, m: ArrayLike, n: ArrayLike, count: int, alpha: float = 0.5
) -> Complexes:
    """Return the same compliance by applying equation (31) to each sub-interval, which cannot overflow.

    With d = Y f at the inner side of a sub-interval, d = (T11 Y + T12)(T21 Y + T22)^-1 f at its outer side.
    """
    y = np.zeros((*np.broadcast_shapes(np.shape(m), np.shape(n)), 3, 3), complex)
    for layer in layers:
        for t in sub_intervals(layer, angular_speed, m, n, count, alpha):
            y = (t[..., :3, :3] @ y + t[..., :3, 3:]) @ np.linalg.inv(t[..., 3:, :3] @ y + t[..., 3:, 3:])
    return y


def extrapolated_compliance(
    layers: Sequence[Layer],
    angular_speed: float,
    m: ArrayLike,
    n: ArrayLike,
    counts: Sequence[int] = (8, 16, 32),
) -> Complexes:
    """Return the limit of `surface_compliance` for many sub-intervals, by Richardson extrapolation.

    With alpha = 1/2 the error contains only even powers of dr.
    """
    table = [surface_compliance(layers, angular_speed, m, n, count) for count in counts]
    for level in range(1, len(counts)):
        ratios = [(counts[i + level] / counts[i]) ** 2 for i in range(len(counts) - level)]
        table = [
            (ratio * fine - coarse) / (ratio - 1.0)
            for ratio, coarse, fine in zip(ratios, table, table[1:], strict=False)
        ]
    return table[0]


def solve_normal_contact(vertical_compliance: Floats, profile: Floats, load: float) -> tuple[Floats, float]:
    """Find forces F_W < 0 and the height H that satisfy (50), without tension and without overclosure.

    `profile` is the undeformed depth r_o sin(theta) sin(phi) of the nodes below the center.
    """
    contact = np.ones(profile.size, bool)
    while True:
        nodes = np.flatnonzero(contact)
        system = np.zeros((nodes.size + 1, nodes.size + 1))
        system[:-1, :-1] = vertical_compliance[np.ix_(nodes, nodes)]
        system[:-1, -1] = -1.0
        system[-1, :-1] = 1.0
        unknowns = np.linalg.solve(system, -np.append(profile[nodes], load))
        force = np.zeros(profile.size)
        force[nodes], height = unknowns[:-1], unknowns[-1]
        tensile = force > 0.0
        if tensile.any():
            contact &= ~tensile
            continue
        overclosure = vertical_compliance @ force + profile - height
        overclosed = (overclosure > 1e-12 * height) & ~contact
        if not overclosed.any():
            return force, height
        contact |= overclosed
