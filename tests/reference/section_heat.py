"""Conduction in the section of a wheel by another finite-element code: python -m tests.reference.section_heat.

The program solves -∇·(r k ∇T) = r q(r, z) on [r_i, r_o] x [-L/2, L/2] with scikit-fem: biquadratic elements and
Crank-Nicolson steps. The surface, where the coefficient may vary along z, and both faces have convection; the hub has
convection or a given temperature.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse.linalg import splu
from skfem import Basis, BilinearForm, ElementQuad2, FacetBasis, LinearForm, MeshQuad, condense, solve


@BilinearForm
def _stiffness(u, v, w):
    return w.x[0] * (u.grad[0] * v.grad[0] + u.grad[1] * v.grad[1])


@BilinearForm
def _mass(u, v, w):
    return w.x[0] * u * v


class Section:
    """A section divided into elements.

    Lengths are in m, the conductivity in W/(m K), and convection coefficients in W/(m² K). `hub` is a convection
    coefficient, or None for a given temperature rise.
    """

    def __init__(self, radii, width, conductivity, *, film, side, hub, elements=(24, 48)):
        self.radii, self.width, self.hub = radii, width, hub
        rows = np.linspace(*radii, elements[0] + 1)
        columns = np.linspace(-0.5 * width, 0.5 * width, elements[1] + 1)
        mesh = MeshQuad.init_tensor(rows, columns).with_boundaries(
            {
                "hub": lambda x: x[0] == rows[0],
                "surface": lambda x: x[0] == rows[-1],
                "sides": lambda x: abs(x[1]) == 0.5 * width,
            }
        )
        element = ElementQuad2()
        self.basis = Basis(mesh, element, intorder=6)
        outer = FacetBasis(mesh, element, facets="surface", intorder=8)
        coefficient = film if callable(film) else lambda z: np.full(z.shape, film)
        convection = BilinearForm(lambda u, v, w: coefficient(w.x[1]) * w.x[0] * u * v)
        self.matrix = conductivity * _stiffness.assemble(self.basis) + convection.assemble(outer)
        faces = [("sides", side)] + ([] if hub is None else [("hub", hub)])
        for name, value in faces:
            self.matrix = self.matrix + value * _mass.assemble(FacetBasis(mesh, element, facets=name, intorder=6))

    def load(self, source):
        """Return the right side of a source q(r, z) [W/m³]."""
        return LinearForm(lambda v, w: w.x[0] * source(*w.x) * v).assemble(self.basis)

    def steady(self, source, hub_rise=0.0):
        """Return the rise at the nodes [K]."""
        load = self.load(source)
        if self.hub is not None:
            return solve(self.matrix, load)
        fixed = self.basis.get_dofs("hub")
        rise = np.zeros(self.basis.N)
        rise[fixed.all()] = hub_rise
        return solve(*condense(self.matrix, load, x=rise, D=fixed))

    def after(self, source, time, capacity, steps):
        """Return the rise at a time [s] after a cold start, ρc in J/(m³ K)."""
        load = self.load(source)
        mass = capacity * _mass.assemble(self.basis)
        step = time / steps
        forward = splu((mass + 0.5 * step * self.matrix).tocsc())
        rise = np.zeros(self.basis.N)
        for _ in range(steps):
            rise = forward.solve(mass @ rise - 0.5 * step * (self.matrix @ rise) + step * load)
        return rise

    def values(self, rise, radius, z):
        """Return the rise on a grid of radii and places across, with a row for each radius."""
        places = np.stack([np.repeat(radius, len(z)), np.tile(z, len(radius))])
        return self.basis.interpolator(rise)(places).reshape(len(radius), len(z))


def sample_source(radius, z):
    """Return an asymmetric heat source near the surface [W/m³]."""
    return 4e4 * np.exp(-(((z - 4e-3) / 6e-3) ** 2)) * (radius / 50e-3) ** 6


def main() -> None:
    """Print the largest rise of a section of 40 to 50 mm by 36 mm, on two meshes."""
    for elements in ((24, 48), (48, 96)):
        section = Section((40e-3, 50e-3), 36e-3, 0.25, film=15.0, side=12.0, hub=8.0, elements=elements)
        print(elements, f"{section.steady(sample_source).max():.8f} K")


if __name__ == "__main__":
    main()
