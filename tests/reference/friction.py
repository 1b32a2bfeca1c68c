"""Sections 4 and 13: contact with Coulomb friction, with all blocks of C_r and slip (55a) that varies laterally.

The unknowns are three forces at every node, the height H and the linear speed. Components are (W, U, V): down, backward
and sideways (-z), as in (39). The forces act on the coating, so F_W <= 0.
"""

from __future__ import annotations

import numpy as np

from .contact import solve_normal_contact


def upstream(theta):
    """Return the number of each node's neighbor at phi - Delta_phi, or its own in the first row."""
    columns = np.unique(theta).size
    return np.maximum(np.arange(theta.size) - columns, np.arange(theta.size) % columns)


def solve_frictional_contact(
    compliance, profile, forward, step, load, friction, *, first, force=None, torque=None, creepage=None, lateral=0.0
):
    """Find nodal forces, H and V_s / (Omega r_o) by Newton steps on the projections of Alart and Curnier.

    `compliance` is C_r with shape (3, 3, nodes, nodes), `profile` and `forward` the undeformed y and x of the nodes,
    `step` is r_o Delta, and `first` contains the upstream neighbors. Exactly one of force Q, torque T (at displaced
    points) and creepage is given. Friction decreases in steps from full stick. Returns the forces (3, nodes), H, and
    V_s / (Omega r_o).
    """
    nodes = profile.size
    dense = compliance.transpose(0, 2, 1, 3).reshape(3 * nodes, 3 * nodes)
    down, back, side = dense[:nodes], dense[nodes : 2 * nodes], dense[2 * nodes :]
    normal = 1.0 / np.diag(down[:, :nodes]).mean()
    tangential = 1.0 / np.diag((back - back[first])[:, nodes : 2 * nodes]).mean()
    start, height = solve_normal_contact(compliance[0, 0], profile, load)
    unknowns = np.concatenate([start, np.zeros(2 * nodes), [height, 1.0 + (creepage or 0.0)]])
    inner = first != np.arange(nodes)  # nodes with an upstream neighbor

    # Slip from the upstream neighbor, along U and V, is linear in the unknowns: slope @ unknowns + offset.
    slope = np.zeros((2, nodes, 3 * nodes + 2))
    slope[0, :, :-2], slope[1, :, :-2] = back - back[first], side - side[first]
    slope[0, :, -1] = -step
    offset = np.stack([-(forward - forward[first]), np.full(nodes, -lateral * step)])
    gap_slope = np.hstack([-down, np.ones((nodes, 1)), np.zeros((nodes, 1))])
    unit = np.eye(3 * nodes + 2)

    def equations(z, mu):
        p, t = -z[:nodes], z[nodes : 3 * nodes].reshape(2, nodes)
        predicted = p - normal * (gap_slope @ z - profile)
        touches = (predicted > 0.0) & inner
        trial = t - tangential * (slope @ z + offset)
        size = np.hypot(*trial)
        rows, values = unit[:-2].copy(), z[: 3 * nodes].copy()
        for i in np.flatnonzero(touches):
            rows[i], values[i] = normal * gap_slope[i], normal * (gap_slope[i] @ z - profile[i])
            own = [nodes + i, 2 * nodes + i]
            if size[i] <= mu * predicted[i]:
                rows[own] = tangential * slope[:, i]
                values[own] = tangential * (slope[:, i] @ z + offset[:, i])
                continue
            e = trial[:, i] / size[i]
            across = mu * predicted[i] / size[i] * (np.eye(2) - np.outer(e, e))
            limit = -unit[i] - normal * gap_slope[i]
            rows[own] = unit[own] - mu * np.outer(e, limit) - across @ (unit[own] - tangential * slope[:, i])
            values[own] = t[:, i] - mu * predicted[i] * e
        balance = np.zeros((2, z.size))
        balance[0, :nodes] = -1.0
        if creepage is not None:
            balance[1, -1], speed = 1.0, z[-1] - 1.0 - creepage
        elif force is not None:
            balance[1, nodes : 2 * nodes], speed = 1.0, t[0].sum() - force
        else:
            x, y = forward - back @ z[:-2], profile + down @ z[:-2]
            balance[1, :nodes], balance[1, nodes : 2 * nodes] = -x, -y
            balance[1, :-2] += p @ -back - t[0] @ down
            balance[1] /= step
            speed = ((x * p - y * t[0]).sum() - torque) / step
        return np.vstack([rows, balance]), np.concatenate([values, [p.sum() - load, speed]])

    for mu in [np.inf, *np.geomspace(max(1.0, friction), friction, 6 if friction < 1.0 else 1)]:
        for _ in range(40):
            jacobian, residual = equations(unknowns, mu)
            if np.abs(residual).max() < 1e-11 * load:
                break
            unknowns = unknowns - np.linalg.solve(jacobian, residual)
        else:
            raise RuntimeError(f"no convergence at friction {mu}")
    return unknowns[:-2].reshape(3, nodes), unknowns[-2], unknowns[-1]
