"""Section 11: frictionless contact with the plane, equations (46) to (52)."""

from __future__ import annotations

import numpy as np

from .boundary import flat_patch


def solve_normal_contact(vertical_compliance, profile, load):
    """Find forces F_W < 0 and the height H that satisfy (50), with nothing tensile and nothing overclosed.

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


def resisting_torque(force, radius, phi, theta):
    """Moment of the normal forces about the center, sum of x p with x = r_o sin(theta) cos(phi)."""
    return -(radius * np.sin(theta) * np.cos(phi) * force).sum()


def dissipated_power(
    order_compliance,
    max_order,
    angular_speed,
    radius,
    spacing,
    phi,
    theta,
    nodal_forces,
    theta_patch=flat_patch,
):
    """Return the power lost in the coating from the spectrum, -Omega (2 pi r_o)^2 sum_mn m Im(conj(s)^T C s).

    `nodal_forces` has shape (3, nodes) in the components (r, phi, theta).
    """
    orders = np.arange(-max_order, max_order + 1)
    compliance = order_compliance(*np.meshgrid(orders, orders, indexing="ij"))
    along_phi = np.array([flat_patch(orders, center, spacing) for center in phi])
    along_theta = np.array([theta_patch(orders, center, spacing) for center in theta])
    stress = np.einsum("ca,am,an->mnc", nodal_forces, along_phi, along_theta, optimize=True) / (2 * np.pi * radius) ** 2
    work = np.einsum("mnp,mnpq,mnq->m", stress.conj(), compliance, stress, optimize=True).imag
    return -angular_speed * (2 * np.pi * radius) ** 2 * (orders * work).sum()
