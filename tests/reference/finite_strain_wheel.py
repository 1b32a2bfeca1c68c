"""Finite-strain reference in three dimensions: a neo-Hookean tread on a rigid wheel with free side faces.

The wheel is pressed on a rigid frictionless plane; the torque of slow rolling follows from the dissipation of a
Kelvin-Voigt tread that moves through the static field, as in `finite_strain_torque`. Coordinates are the angle phi
from the lowest point in the rolling direction, the undeformed radius R and the lateral distance y from the middle
plane. A quarter of the tread around the contact is computed, phi >= 0 and y >= 0. Lengths have any unit, and stresses
are in units of G. The energy is that of `finite_strain`, in three dimensions,

    W = (tr F^T F - 3)/2 - ln J + p (J - 1) - p^2 / (2 lambda).

Elements are Q2 with 27 nodes, and p is linear in each element, where it is eliminated. On axes (phi, R, y), which are
attached to the material, the rate of C = F^T F is Omega dC/dphi. Newton's viscosity, Cauchy's stress 2 eta D, has the
power 2 eta J D : D per undeformed volume, D : D = tr(C^-1 Cdot C^-1 Cdot)/4.

`python -m tests.reference.finite_strain_wheel` prints load, torque and stretch of the contact against the strain. With
--plane-strain, side faces do not move sideways, as in a roller.
"""

from __future__ import annotations

import argparse

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import solveh_banded

from .finite_strain import graded

#: First Lame constant per shear modulus: Poisson's ratio 0.49995.
LAMBDA = 1e4
#: Pressure of the stiff plane per overlap, in G per thickness. The overlap is below 3e-4 of the thickness.
STIFFNESS = 1e4
#: Entries of the derivative of the cofactors of F by F: eps_ijk eps_abc for F_kc.
EPSILON = np.zeros((3, 3, 3))
for _i, _j, _k in [(0, 1, 2), (1, 2, 0), (2, 0, 1)]:
    EPSILON[_i, _j, _k], EPSILON[_j, _i, _k] = 1.0, -1.0


def reference_points(count):
    """Return slopes of the 27 shape functions along the three axes, coordinates and weights of Gauss points."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    value = np.array([0.5 * nodes * (nodes - 1.0), 1.0 - nodes**2, 0.5 * nodes * (nodes + 1.0)])  # [function][point]
    slope = np.array([nodes - 0.5, -2.0 * nodes, nodes + 0.5])

    def product(a, b, c):
        return np.einsum("ip,jq,kr->ijkpqr", a, b, c).reshape(27, -1)

    slopes = np.array([product(slope, value, value), product(value, slope, value), product(value, value, slope)])
    coordinates = np.array(np.meshgrid(nodes, nodes, nodes, indexing="ij")).reshape(3, -1)
    return slopes, coordinates, np.einsum("p,q,r->pqr", weights, weights, weights).ravel()


class Tread:
    """A tread between a rigid core and a plane; `angles`, `radii` and `sides` are the boundaries of its elements."""

    def __init__(self, angles, radii, sides, *, plane_strain=False):
        self.grid = [np.asarray(axis, dtype=float) for axis in (angles, radii, sides)]
        self.corners = [axis[:-1] for axis in self.grid], [axis[1:] for axis in self.grid]
        lines = [np.sort(np.append(axis, 0.5 * (axis[1:] + axis[:-1]))) for axis in self.grid]
        self.shape = tuple(line.size for line in lines)
        self.phi, self.radius, self.side = (x.ravel() for x in np.meshgrid(*lines, indexing="ij"))
        numbers = np.arange(self.phi.size).reshape(self.shape)
        corner = np.array(np.meshgrid(*(2 * np.arange(axis.size - 1) for axis in self.grid), indexing="ij"))
        step = np.array(np.meshgrid(*[np.arange(3)] * 3, indexing="ij")).reshape(3, 27)
        self.nodes = numbers[tuple(corner.reshape(3, -1)[:, :, None] + step[:, None, :])]  # [element][node]
        self.outer_radius, self.thickness = self.grid[1][-1], np.ptp(self.grid[1])
        self.rest = np.stack(
            [self.radius * np.sin(self.phi), self.radius * np.cos(self.phi), self.side], axis=1
        )  # forward, down, sideways
        fixed = np.zeros((self.phi.size, 3), dtype=bool)
        fixed[(self.radius == self.grid[1][0]) | (self.phi == self.grid[0][-1])] = True
        fixed[self.phi == 0.0, 0] = True
        fixed[self.side == 0.0, 2] = True
        if plane_strain:
            fixed[:, 2] = True
        self.fixed = fixed.ravel()
        self.position, self.p = self.rest.copy(), np.zeros((len(self.nodes), 4))
        self._set_surface(corner)

    def _set_surface(self, corner):
        """Set the nodes on the surface and the area of each, by Simpson's rule on the faces of the elements."""
        outer = np.flatnonzero(corner[1].ravel() == 2 * (self.grid[1].size - 2))
        faces = self.nodes[outer].reshape(-1, 3, 3, 3)[:, :, 2].reshape(-1, 9)
        simpson = np.array([1.0, 4.0, 1.0]) / 6.0
        sizes = [np.ptp(x[faces], axis=1) for x in (self.phi, self.side)]
        areas = self.outer_radius * np.outer(sizes[0] * sizes[1], np.outer(simpson, simpson))
        self.area = np.bincount(faces.ravel(), areas.ravel(), minlength=self.phi.size)

    def points(self, count):
        """Return gradients of shape functions, [element][point][node][axis], volumes, coordinates and modes of p."""
        slopes, local, weights = reference_points(count)
        ends = [np.array(np.meshgrid(*axes, indexing="ij")).reshape(3, -1, 1) for axes in self.corners]
        half, middle = 0.5 * (ends[1] - ends[0]), 0.5 * (ends[1] + ends[0])
        coordinates = middle + half * local[:, None, :]
        scales = 1.0 / half * np.ones_like(coordinates)
        scales[0] /= coordinates[1]
        gradients = np.einsum("anq,aeq->eqna", slopes, scales)
        volumes = np.prod(half, axis=0) * weights * coordinates[1]
        return gradients, volumes, coordinates, np.vstack([np.ones(len(weights)), local])

    def forces(self):
        """Return nodal forces and their derivative with p eliminated, numbers of unknowns, and matrices of p.

        The derivative is [element][81][81]. The last three arrays give the change of p for a change of the positions.
        """
        gradients, volumes, _, modes = self.points(3)
        f = np.einsum("eni,eqna->eqia", self.position[self.nodes], gradients)
        p = self.p @ modes
        cofactors = 0.5 * np.einsum("ijk,abc,eqjb,eqkc->eqia", EPSILON, EPSILON, f, f, optimize=True)
        ratio = np.linalg.det(f)
        pressure = p - 1.0 / ratio
        stress = f + pressure[..., None, None] * cofactors
        slope = np.einsum("eq,ijk,abc,eqkc->eqiajb", pressure, EPSILON, EPSILON, f, optimize=True)
        slope += np.einsum("eq,eqia,eqjb->eqiajb", ratio**-2.0, cofactors, cofactors)
        slope += np.einsum("ij,ab->iajb", np.eye(3), np.eye(3))
        slope *= volumes[..., None, None, None, None]
        count, size = len(self.nodes), 81
        right = np.einsum("eqiajb,eqmb->eqiajm", slope, gradients, optimize=True)
        stiffness = np.einsum("eqna,eqiajm->enimj", gradients, right, optimize=True).reshape(count, size, size)
        force = np.einsum("eqna,eqia,eq->eni", gradients, stress, volumes, optimize=True)
        coupling = np.einsum("eqna,eqia,kq,eq->enik", gradients, cofactors, modes, volumes, optimize=True)
        coupling = coupling.reshape(count, size, 4)
        mass = np.einsum("kq,lq,eq->ekl", modes, modes, volumes) / LAMBDA
        excess = np.einsum("kq,eq,eq->ek", modes, ratio - 1.0, volumes) - np.einsum("ekl,el->ek", mass, self.p)
        inverse = np.linalg.inv(mass)
        stiffness += coupling @ inverse @ coupling.transpose(0, 2, 1)
        force = force.reshape(count, size) + np.einsum("esk,ekl,el->es", coupling, inverse, excess)
        dofs = (3 * self.nodes[:, :, None] + np.arange(3)).reshape(count, size)
        total = np.bincount(dofs.ravel(), force.ravel(), minlength=self.fixed.size)
        return total, stiffness, dofs, (inverse, coupling, excess)

    def pressures(self, height):
        """Return the forces of a stiff plane per undeformed area at the nodes; 0 inside the tread."""
        overlap = self.position[:, 1] - height
        return STIFFNESS / self.thickness * np.where(self.area > 0.0, np.maximum(overlap, 0.0), 0.0)

    def press(self, penetration, steps=40):
        """Move the plane to a penetration, and return the load on the whole tread."""
        height = self.outer_radius - penetration
        for _ in range(steps):
            force, stiffness, dofs, (inverse, coupling, excess) = self.forces()
            pressure = self.pressures(height)
            force[1::3] += pressure * self.area
            diagonal = np.zeros_like(force)
            diagonal[1::3] = np.where(pressure > 0.0, STIFFNESS / self.thickness * self.area, 0.0)
            change = self._solve(force, stiffness, dofs, diagonal)
            self.position += change.reshape(-1, 3)
            self.p += np.einsum("ekl,el->ek", inverse, excess + np.einsum("esk,es->ek", coupling, change[dofs]))
            if np.abs(change).max() < 1e-7 * self.thickness:
                self.height = height
                return 4.0 * float((self.pressures(height) * self.area).sum())
        raise RuntimeError(f"no equilibrium at a penetration of {penetration}")

    def _solve(self, force, stiffness, dofs, diagonal):
        """Return the change of all positions; `diagonal` is added to the stiffness."""
        free = ~self.fixed
        number = np.where(free, np.cumsum(free) - 1, -1)
        rows, columns = np.broadcast_arrays(number[dofs][:, :, None], number[dofs][:, None, :])
        lower = (rows >= columns) & (columns >= 0)
        offset, column = rows[lower] - columns[lower], columns[lower]
        count, band = int(number.max()) + 1, int(offset.max()) + 1
        matrix = np.bincount(offset * count + column, stiffness[lower], minlength=band * count).reshape(band, count)
        matrix[0] += diagonal[free]
        change = np.zeros(force.size)
        change[free] = solveh_banded(matrix, -force[free], lower=True, overwrite_ab=True, check_finite=False)
        return change

    def slow_torque(self, load):
        """Return the torque of slow rolling with Newton's viscosity in units of P Omega r_o eta/G."""
        gradients, volumes, coordinates, _ = self.points(2)
        f = np.einsum("eni,eqna->eqia", self.position[self.nodes], gradients)
        c = np.einsum("eqia,eqib->eqab", f, f)
        order = np.lexsort((coordinates[0].ravel(), coordinates[2].ravel(), coordinates[1].ravel()))
        count = 2 * (self.grid[0].size - 1)
        c = c.reshape(-1, 3, 3)[order].reshape(-1, count, 3, 3)
        angle = coordinates[0].ravel()[order][:count]
        parity = np.ones((3, 3))
        parity[0, 1:] = parity[1:, 0] = -1.0  # the angle changes its sign by reflection
        line = np.concatenate([parity * c[:, 3::-1], c], axis=1)
        rate = CubicSpline(np.append(-angle[3::-1], angle), line, axis=1)(angle, 1)
        mixed = np.linalg.solve(c, rate)
        density = 0.5 * np.einsum("lpij,lpji->lp", mixed, mixed) * np.sqrt(np.linalg.det(c))
        return 4.0 * (density * volumes.ravel()[order].reshape(-1, count)).sum() / (load * self.outer_radius)

    def stretch(self):
        """Return the stretch of the contact per chord, weighted over rows with their loads, and the largest angle."""
        pressure = self.pressures(self.height)
        found = []
        for side in np.unique(self.side):
            row = np.flatnonzero((self.side == side) & (self.area > 0.0))
            row = row[np.argsort(self.phi[row])]
            last = np.flatnonzero(pressure[row] > 0.0)
            if last.size:
                ends = row[last[-1] : last[-1] + 2]
                load = (pressure * self.area)[row].sum()
                found.append((load, self.position[ends, 0].mean(), self.phi[ends].mean()))
        load, forward, angle = np.array(found).T
        stretch = load @ (forward / (self.outer_radius * np.sin(angle))) / load.sum() - 1.0
        return float(stretch), float(angle.max())


def tread(core_radius, outer_radius, width, edge, *, finest=0.05, coarsest=0.25, across=5, plane_strain=False):
    """Return a tread with small elements at the angle `edge`, where contact ends in the middle, and at its surface.

    Sizes of elements are relative to the thickness. In plane strain, tread far from the contact moves along the path.
    """
    h = outer_radius - core_radius
    turn, reach = h / outer_radius, 8.0 if plane_strain else 4.0
    inside = graded(0.0, edge, edge, finest * turn, coarsest * turn, 1.4)
    outside = graded(edge, edge + reach * turn, edge, finest * turn, 1.5 * turn, 1.4)
    radii = graded(core_radius, outer_radius, outer_radius, 2.5 * finest * h, coarsest * h, 1.4)
    part = np.linspace(0.0, 1.0, 2 if plane_strain else across + 1)
    sides = 0.5 * width * (0.4 * part + 0.6 * np.sin(0.5 * np.pi * part))
    return Tread(np.append(inside, outside[1:]), radii, sides, plane_strain=plane_strain)


def press_tread(core_radius, outer_radius, width, penetration, **sizes):
    """Return a tread pressed to a penetration, on a mesh for its contact, and the load."""
    edge = 0.85 * np.sqrt(2.0 * penetration / outer_radius)
    steps = max(1, round(penetration / (0.05 * (outer_radius - core_radius))))
    for _ in range(4):
        body = tread(core_radius, outer_radius, width, edge, **sizes)
        for step in range(1, steps + 1):
            load = body.press(step / steps * penetration)
        _, found = body.stretch()
        if abs(found / edge - 1.0) < 0.02:
            break
        edge = found
    return body, load


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--core-radius", type=float, default=40.0)
    parser.add_argument("--thickness", type=float, default=10.0)
    parser.add_argument("--width", type=float, default=30.0)
    parser.add_argument("--strains", type=float, nargs="+", default=[0.1, 0.2])
    parser.add_argument("--finest", type=float, default=0.05, help="smallest element, in thicknesses")
    parser.add_argument("--across", type=int, default=5, help="elements from the middle to the side face")
    parser.add_argument("--plane-strain", action="store_true", help="hold the side faces, as in a roller")
    given = parser.parse_args()
    sizes = {"finest": given.finest, "across": given.across, "plane_strain": given.plane_strain}
    for strain in given.strains:
        outer = given.core_radius + given.thickness
        body, load = press_tread(given.core_radius, outer, given.width, strain * given.thickness, **sizes)
        print(f"{strain:.0%}: P {load:.6g}, torque {body.slow_torque(load):.4f}, c {body.stretch()[0]:.4f}", flush=True)


if __name__ == "__main__":
    main()
