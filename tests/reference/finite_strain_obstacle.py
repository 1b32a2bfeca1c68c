"""Finite-strain reference with another contact algorithm: node by node, at a given depth.

`finite_strain.Coating` prescribes the edge of the contact, to which its mesh is fitted, and computes the depth. Here
the depth is given, and any mesh is allowed: nodes that would penetrate the plane are placed on it, and nodes in tension
leave it. The error of the edge, at most half an element, causes an error of the load that decreases with the element
size.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse.linalg import splu

from .finite_strain import Coating


def press_node_by_node(coating: Coating, depth, state=None):
    """Return the state and the load at `depth`, a penetration, starting from `state` or from rest.

    Raises RuntimeError if forty Newton steps do not converge: then `state` must come from a smaller depth.
    """
    surface = coating.basis.get_dofs(lambda x: x[1] == coating.grid[1][-1]).all(["u^2^1"])
    theta, radius = coating.basis.doflocs[:, surface]
    lowest = coating.outer_radius - depth - radius * np.cos(theta)  # displacement onto the plane
    held = np.setdiff1d(np.arange(coating.basis.N), np.concatenate([coating.free, surface]))
    state = np.zeros(coating.basis.N) if state is None else state.copy()
    touching = theta < np.sqrt(1.7 * depth / coating.outer_radius)
    for _ in range(40):
        step = np.zeros(coating.basis.N)
        step[surface[touching]] = (lowest - state[surface])[touching]
        free = np.setdiff1d(np.arange(coating.basis.N), np.concatenate([held, surface[touching]]))
        force, slope = coating.equations(state)
        step[free] = splu(slope[free][:, free].tocsc()).solve(-(force + slope @ step)[free])
        state += step
        if np.abs(step[surface]).max() > 1e-8 * coating.thickness:
            continue
        force = coating.equations(state)[0][surface]
        kept = np.where(touching, force < 0.0, state[surface] > lowest)
        if np.array_equal(kept, touching):
            return state, -force.sum()
        touching = kept
    raise RuntimeError(f"no convergence at a depth of {depth}")
