"""Sections 9 to 11: the boundary-element compliance matrix of the surface, and its rotation to rectangular axes.

Nodes are numbered one after the other; matrices have blocks for the components (r, phi, theta) or (W, U, V).
"""

from __future__ import annotations

import numpy as np


def nodes(spacing, half_phi, half_theta):
    """Return angles of a rectangular set of nodes around the lowest point phi = theta = pi/2, row by row in phi."""
    phi = np.pi / 2 + spacing * np.arange(-half_phi, half_phi + 1)
    theta = np.pi / 2 + spacing * np.arange(-half_theta, half_theta + 1)
    return tuple(angle.ravel() for angle in np.meshgrid(phi, theta, indexing="ij"))


def flat_patch(orders, center, spacing):
    """Return the factor of equation (53) along one angle: sinc(m Delta/2) exp(-i m phi_N), sinc(x) = sin(x) / x."""
    return np.sinc(orders * spacing / (2 * np.pi)) * np.exp(-1j * orders * center)


def spherical_patch(orders, center, spacing):
    """Return (1/Delta) int exp(-i n theta) / sin(theta) d theta of equation (38), by 20 Gauss points."""
    points, weights = np.polynomial.legendre.leggauss(20)
    theta = center + spacing / 2 * points
    return (weights / 2 / np.sin(theta) * np.exp(-1j * np.outer(orders, theta))).sum(axis=1)


def compliance_matrix(order_compliance, max_order, radius, spacing, phi, theta, theta_patch=flat_patch):
    """Return the matrix C_s of equation (35), shape (3, 3, nodes, nodes), by direct summation of all orders.

    `order_compliance(m, n)` returns the 3 x 3 surface compliance of arrays of orders.
    """
    orders = np.arange(-max_order, max_order + 1)
    compliance = order_compliance(*np.meshgrid(orders, orders, indexing="ij"))
    rows, row = np.unique(phi, return_inverse=True)
    columns, column = np.unique(theta, return_inverse=True)
    to_rows, to_columns = np.exp(1j * np.outer(rows, orders)), np.exp(1j * np.outer(columns, orders))
    matrix = np.empty((3, 3, phi.size, phi.size))
    # Sum over m for all patches of a row, then over n for each patch.
    for source in np.unique(row):
        stress = flat_patch(orders, rows[source], spacing) / (2 * np.pi * radius) ** 2
        along_phi = np.tensordot(to_rows * stress, compliance, axes=1)
        for node in np.flatnonzero(row == source):
            along_both = np.tensordot(to_columns * theta_patch(orders, theta[node], spacing), along_phi, axes=(1, 1))
            matrix[..., node] = along_both[column, row].real.transpose(1, 2, 0)
    return matrix


def rotation(phi, theta):
    """Return the nodal matrices Q of equation (40), shape (nodes, 3, 3): rows (r, phi, theta), columns (W, U, V)."""
    s, c = np.sin, np.cos
    zero = np.zeros_like(phi)
    return np.stack(
        [
            np.stack([s(theta) * s(phi), -s(theta) * c(phi), -c(theta)], axis=-1),
            np.stack([c(phi), s(phi), zero], axis=-1),
            np.stack([c(theta) * s(phi), -c(theta) * c(phi), s(theta)], axis=-1),
        ],
        axis=-2,
    )


def to_rectangular(matrix, phi, theta):
    """Return C_r = Q^T C_s Q, equation (44), shape (3, 3, nodes, nodes) in the components (W, U, V)."""
    q = rotation(phi, theta)
    return np.einsum("apw,pqab,bqv->wvab", q, matrix, q, optimize=True)


def to_turned(matrix, phi, theta):
    """Return C_RR and its other blocks (docs/theory/friction.md): W is the r component, and u_r contributes to U, V."""
    q = np.broadcast_to(np.eye(3), (phi.size, 3, 3)).copy()
    q[:, 0, 1] = phi - 0.5 * np.pi
    q[:, 0, 2] = -np.cos(theta)
    return np.einsum("apw,pqab,bqv->wvab", q, matrix, q, optimize=True)
