"""Conduction in the section of a wheel by another finite-element code: python -m tests.reference.section_heat.

The program solves -∇·(r k ∇T) = r q(r, z) on [r_i, r_o] x [-L/2, L/2] with scikit-fem: biquadratic elements and
Crank-Nicolson steps. There is convection on the surface, with a coefficient that may vary along z, and on both faces;
the hub has convection or a given temperature.
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

    Lengths are in m and the conductivity in W/(m K). `surface_convection`, a number or a function of z,
    `side_convection` and `hub_convection` are coefficients in W/(m² K). If `hub_convection` is None, the hub has a
    given temperature rise.
    """

    def __init__(
        self, radii, width, conductivity, *, surface_convection, side_convection, hub_convection, elements=(24, 48)
    ):
        self.radii, self.width, self.hub_convection = radii, width, hub_convection
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
        given = surface_convection
        coefficient = given if callable(given) else lambda z: np.full(z.shape, given)
        convection = BilinearForm(lambda u, v, w: coefficient(w.x[1]) * w.x[0] * u * v)
        self.matrix = conductivity * _stiffness.assemble(self.basis) + convection.assemble(outer)
        faces = [("sides", side_convection)] + ([] if hub_convection is None else [("hub", hub_convection)])
        for name, value in faces:
            self.matrix = self.matrix + value * _mass.assemble(FacetBasis(mesh, element, facets=name, intorder=6))

    def load(self, source):
        """Return the right side of a source q(r, z) [W/m³]."""
        return LinearForm(lambda v, w: w.x[0] * source(*w.x) * v).assemble(self.basis)

    def steady(self, source, hub_rise=0.0):
        """Return the steady temperature rise at the nodes [K]."""
        load = self.load(source)
        if self.hub_convection is not None:
            return solve(self.matrix, load)
        fixed = self.basis.get_dofs("hub")
        rise = np.zeros(self.basis.N)
        rise[fixed.all()] = hub_rise
        return solve(*condense(self.matrix, load, x=rise, D=fixed))

    def after(self, source, time, capacity, steps):
        """Return the temperature rise at the nodes [K] at a time [s] after a start from zero rise.

        `capacity` is ρc in J/(m³ K). `hub_convection` must not be None.
        """
        assert self.hub_convection is not None
        load = self.load(source)
        mass = capacity * _mass.assemble(self.basis)
        step = time / steps
        forward = splu((mass + 0.5 * step * self.matrix).tocsc())
        rise = np.zeros(self.basis.N)
        for _ in range(steps):
            rise = forward.solve(mass @ rise - 0.5 * step * (self.matrix @ rise) + step * load)
        return rise

    def values(self, rise, radius, z):
        """Return the rise on a grid of radii and axial positions z [m], with a row for each radius."""
        places = np.stack([np.repeat(radius, len(z)), np.tile(z, len(radius))])
        return self.basis.interpolator(rise)(places).reshape(len(radius), len(z))


def sample_source(radius, z):
    """Return an asymmetric heat source near the surface [W/m³]."""
    return 4e4 * np.exp(-(((z - 4e-3) / 6e-3) ** 2)) * (radius / 50e-3) ** 6


def main() -> None:
    """Print the largest rise under `sample_source` in a section with radii of 40 to 50 mm and a width of 36 mm."""
    convection = {"surface_convection": 15.0, "side_convection": 12.0, "hub_convection": 8.0}
    for elements in ((24, 48), (48, 96)):
        section = Section((40e-3, 50e-3), 36e-3, 0.25, elements=elements, **convection)
        print(elements, f"{section.steady(sample_source).max():.8f} K")


if __name__ == "__main__":
    main()
