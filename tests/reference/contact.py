"""Section 11: frictionless contact with the plane, equations (46) to (52)."""

from __future__ import annotations

import numpy as np
from viscoroll.reproduce.plain import solve_normal_contact

from .boundary import flat_patch

__all__ = ["dissipated_power", "power_of_orders", "resisting_torque", "solve_normal_contact"]


def resisting_torque(force, radius, phi, theta):
    """Return the moment of the normal forces about the center, sum of x p with x = r_o sin(theta) cos(phi)."""
    return -(radius * np.sin(theta) * np.cos(phi) * force).sum()


def power_of_orders(
    order_compliance,
    orders,
    angular_speed,
    radius,
    spacing,
    phi,
    theta,
    nodal_forces,
    theta_patch=flat_patch,
):
    """Return the power dissipated in the coating at orders +-m > 0, -2 Omega (2 pi r_o)^2 sum_n m Im(conj(s)^T C s).

    `nodal_forces` has shape (3, nodes) in the components (r, phi, theta); the sum includes the given orders n.
    """
    across = np.arange(-max(orders), max(orders) + 1)
    compliance = order_compliance(*np.meshgrid(orders, across, indexing="ij"))
    along_phi = np.array([flat_patch(orders, center, spacing) for center in phi])
    along_theta = np.array([theta_patch(across, center, spacing) for center in theta])
    stress = np.einsum("ca,am,an->mnc", nodal_forces, along_phi, along_theta, optimize=True) / (2 * np.pi * radius) ** 2
    work = np.einsum("mnp,mnpq,mnq->m", stress.conj(), compliance, stress, optimize=True).imag
    return -2.0 * angular_speed * (2 * np.pi * radius) ** 2 * orders * work


def dissipated_power(order_compliance, max_order, *arguments, **patches):
    """Return the power dissipated in the coating from the spectrum, for all orders up to `max_order`."""
    return power_of_orders(order_compliance, np.arange(1, max_order + 1), *arguments, **patches).sum()
