"""Finite-strain reference, statics: a neo-Hookean coating on a rigid ball, pressed on a rigid frictionless plane.

The model is axisymmetric about the vertical through the contact, in the polar angle theta from it and the radius R of
the undeformed coating; the cap is so wide that its free end is at rest. Lengths have any unit, and stresses are in
units of G. With F = dx/dX and J = det F,

    W = (tr F^T F - 3)/2 - ln J + p (J - 1) - p^2 / (2 lambda),    lambda = 2 nu / (1 - 2 nu),

is stationary in x and p. This is the compressible neo-Hookean law (I_1 - 3)/2 - ln J + lambda (J - 1)^2 / 2, and the
incompressible one for 1/lambda = 0, so that nu = 1/2 needs no large bulk modulus. Elements are Q2 for the displacement
and Q1 for p (Taylor and Hood), or of first order, Q1 and Q0, to show their error; their coordinates are theta and R, so
that the sphere is exact.

The edge of the contact is given, at a line of the mesh, which is refined towards it. Nodes up to the edge lie on the
plane. The pressure decreases to zero at the edge, so the last node has zero force, which determines the height of the
plane. There is no active set and no penalty. Load as a function of penetration is accurate to 1e-5 if the finest
element is h/50, because an error of the edge moves a state along this curve.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import RegularGridInterpolator
from scipy.sparse import coo_array, csc_array, hstack
from scipy.sparse.linalg import splu
from skfem import Basis, ElementQuad0, ElementQuad1, ElementQuad2, ElementVector, MeshQuad


def energy_derivatives(y, softness):
    """Return gradient and Hessian of W by y = (F_11, F_12, F_21, F_22, hoop stretch, p); softness is 1/lambda."""
    a, b, c, d, hoop, p = y
    area = a * d - b * c
    ratio = area * hoop
    slope = np.stack([hoop * d, -hoop * c, -hoop * b, hoop * a, area, np.zeros_like(p)])
    gradient = y + (p - 1.0 / ratio) * slope
    gradient[5] = ratio - 1.0 - softness * p
    curvature = np.zeros((6, *y.shape))
    for i, j, value in [(0, 3, hoop), (1, 2, -hoop), (0, 4, d), (1, 4, -c), (2, 4, -b), (3, 4, a)]:
        curvature[i, j] = curvature[j, i] = value
    hessian = (p - 1.0 / ratio) * curvature + slope[:, None] * slope / ratio**2
    hessian[5, :5] = hessian[:5, 5] = slope[:5]
    for i in range(5):
        hessian[i, i] += 1.0
    hessian[5, 5] = -softness
    return gradient, hessian


def points_of(basis):
    """Return theta and R of the quadrature points."""
    return (np.asarray(x) for x in np.asarray(basis.global_coordinates()))


def strain_entries(basis):
    """Return y at rest, and the derivatives of its entries by the unknowns, [unknown][entry][element][point].

    Rows of F are the directions away from the vertical axis and down along it; columns are theta and R.
    """
    theta, radius = points_of(basis)
    s, c = np.sin(theta), np.cos(theta)
    columns = []
    for u, p in basis.basis:
        gradient, field = np.asarray(u.grad), np.asarray(u)
        entries = [gradient[0, 0] / radius, gradient[0, 1], gradient[1, 0] / radius, gradient[1, 1]]
        columns.append(np.stack([*entries, field[0] / (radius * s), np.broadcast_to(p, s.shape)]))
    return np.stack([c, s, -s, c, np.ones_like(s), np.zeros_like(s)]), np.stack(columns)


def volumes(basis):
    """Return the undeformed volumes of the quadrature points."""
    theta, radius = points_of(basis)
    return 2.0 * np.pi * radius**2 * np.sin(theta) * basis.dx


def graded(start, end, focus, finest, coarsest, growth):
    """Return nodes on [start, end], one of them at `focus`; spacings increase from there, `finest` to `coarsest`."""

    def one_side(length):
        steps, spacing = [0.0], finest
        while steps[-1] < length:
            steps.append(steps[-1] + spacing)
            spacing = min(spacing * growth, coarsest)
        return np.array(steps) * (length / steps[-1] if length > 0.0 else 1.0)

    return np.concatenate([focus - one_side(focus - start)[:0:-1], focus + one_side(end - focus)])


class Coating:
    """A coating in contact with the plane up to the polar angle `edge` of its material.

    Element sizes, `finest` at the edge and `coarsest`, are relative to the thickness; `growth` is the ratio of
    neighbors.
    """

    def __init__(
        self, core_radius, outer_radius, poisson_ratio, edge, *, finest=0.002, coarsest=0.2, growth=1.4, order=2
    ):
        h = outer_radius - core_radius
        turn = h / outer_radius
        self.outer_radius, self.thickness, self.edge = outer_radius, h, edge
        self.softness = (1.0 - 2.0 * poisson_ratio) / (2.0 * poisson_ratio)
        self.grid = (
            graded(0.0, min(edge + 12.0 * turn, 2.5), edge, finest * turn, coarsest * turn, growth),
            graded(core_radius, outer_radius, outer_radius, finest * h, coarsest * h, growth),
        )
        moved, pressed = {1: (ElementQuad1, ElementQuad0), 2: (ElementQuad2, ElementQuad1)}[order]
        self.basis = Basis(MeshQuad.init_tensor(*self.grid), ElementVector(moved()) * pressed(), intorder=5)
        self._number()
        self.rest, self.entries = strain_entries(self.basis)
        self.volumes = volumes(self.basis)

    def _number(self):
        """Set the numbers of the free unknowns, of those on the plane, and of the equations."""
        locations, dofs, (thetas, radii) = self.basis.doflocs, self.basis.get_dofs, self.grid
        core = dofs(lambda x: x[1] == radii[0]).all(["u^1^1", "u^2^1"])
        axis = dofs(lambda x: x[0] == thetas[0]).all(["u^1^1"])
        surface = dofs(lambda x: x[1] == radii[-1]).all(["u^2^1"])
        self.touching = surface[locations[0, surface] <= self.edge * (1.0 + 1e-9)]
        last = self.touching[np.argmax(locations[0, self.touching])]
        self.free = np.setdiff1d(np.arange(self.basis.N), np.concatenate([core, axis, self.touching]))
        self.rows = np.append(self.free, last)
        pressures = self.basis.get_dofs(elements=True).all(["u^2"])
        self.moving = ~np.isin(np.append(self.free, self.touching), pressures)

    def equations(self, state):
        """Return nodal forces and their derivative, a sparse matrix."""
        dofs, n = self.basis.element_dofs, self.basis.N
        y = self.rest + np.einsum("aieq,ae->ieq", self.entries, state[dofs])
        gradient, hessian = energy_derivatives(y, self.softness)
        forces = np.einsum("aieq,ieq,eq->ae", self.entries, gradient, self.volumes, optimize=True)
        force = np.bincount(dofs.ravel(), forces.ravel(), minlength=n)
        left = self.entries.transpose(2, 0, 3, 1)  # [element][unknown][point][entry]
        right = np.einsum("ijeq,bjeq,eq->eqib", hessian, self.entries, self.volumes, optimize=True)
        count, size = left.shape[:2]
        blocks = left.reshape(count, size, -1) @ right.reshape(count, -1, size)
        rows, columns = (np.broadcast_to(k, blocks.shape) for k in (dofs.T[:, :, None], dofs.T[:, None, :]))
        slope = coo_array((blocks.ravel(), (rows.ravel(), columns.ravel())), shape=(n, n)).tocsc()
        return force, slope

    def press(self, guess=None):
        """Return the state (displacements and p), penetration and load, by Newton steps.

        The first step from rest is linear elasticity. Raises RuntimeError if ten steps are not enough: then `guess`
        must come from a smaller contact.
        """
        touching, free = self.touching, self.free
        state = np.zeros(self.basis.N) if guess is None else guess.copy()
        theta, radius = self.basis.doflocs[:, touching]
        for _ in range(10):
            force, slope = self.equations(state)
            slope = slope[self.rows]
            height = state[touching] + radius * np.cos(theta)  # nodes that must lie on the plane
            plane = csc_array(slope[:, touching].sum(axis=1)[:, None])
            system = hstack([slope[:, free], plane]).tocsc()
            solution = splu(system).solve(slope[:, touching] @ height - force[self.rows])
            step = np.append(solution[:-1], solution[-1] - height)
            state[free] += step[: free.size]
            state[touching] += step[free.size :]
            if np.abs(step[self.moving]).max() < 1e-8 * self.thickness:
                return state, self.outer_radius - solution[-1], -self.equations(state)[0][touching].sum()
        raise RuntimeError(f"no convergence with contact up to {self.edge} rad")

    def surface(self, state):
        """Return theta, gap to the plane and upward force of the surface's nodes, starting at the axis."""
        dofs = self.basis.get_dofs(lambda x: x[1] == self.grid[1][-1]).all(["u^2^1"])
        dofs = dofs[np.argsort(self.basis.doflocs[0, dofs])]
        theta, radius = self.basis.doflocs[:, dofs]
        height = state[dofs] + radius * np.cos(theta)
        return theta, height[0] - height, -self.equations(state)[0][dofs]

    def stretch(self, state):
        """Return the stretch of the contact: its radius relative to that of its material at rest, minus 1."""
        edge = self.basis.get_dofs(lambda x: x[1] == self.grid[1][-1]).all(["u^1^1"])
        edge = edge[np.argmin(np.abs(self.basis.doflocs[0, edge] - self.edge))]
        return float(state[edge] / (self.outer_radius * np.sin(self.edge)))

    def guess_from(self, other, state):
        """Return a guess from the state of another edge, stretched along theta and scaled to the depth of this edge."""
        values, stretch = np.zeros(self.basis.N), self.edge / other.edge
        theta, radius = self.basis.doflocs
        points = np.column_stack([np.minimum(theta / stretch, other.grid[0][-1]), radius])
        corners = np.lexsort(other.basis.mesh.p[::-1])
        shape = [nodes.size for nodes in other.grid]
        for row, name in enumerate(["u^1^1", "u^2^1", "u^2"]):
            table = state[other.basis.nodal_dofs[row]][corners].reshape(shape)
            dofs = self.basis.get_dofs(elements=True).all([name])
            values[dofs] = stretch**2 * RegularGridInterpolator(other.grid, table)(points[dofs])
        return values
