"""A strip of thickness 1 on a rigid base, incompressible, in plane strain, under a flat frictionless punch.

With free sides, scikit-fem solves the strip with Taylor-Hood elements, Q2 and Q1, which need no large bulk modulus; the
meshes are refined towards the sides, and the results extrapolated. For an unbounded strip, Galerkin's method uses the
closed compliance

    C(k) = (sinh 2k - 2k) / (cosh 2k + 1 + 2k^2) / (2 G k)

and pressures p = sum a_n T_2n(x/a) / sqrt(a^2 - x^2), whose transforms are Bessel functions. Each method gives mean
pressure / (shear modulus * penetration), p/(G d).
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.legendre import leggauss
from scipy.sparse import bmat
from scipy.special import jv
from skfem import Basis, BilinearForm, ElementQuad1, ElementQuad2, ElementVector, MeshQuad, condense, solve
from skfem.helpers import ddot, div, sym_grad


@BilinearForm
def _shear(u, v, _):
    return 2.0 * ddot(sym_grad(u), sym_grad(v))


@BilinearForm
def _volume(u, q, _):
    return -div(u) * q


def free_stiffness(width, elements):
    """Return p/(G d) for free sides, with `elements` across half of the width and as many across the thickness."""
    half = 0.5 * width
    across = half * np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, elements + 1))
    down = 0.5 * (1.0 - np.cos(np.pi * np.linspace(0.0, 1.0, elements + 1)))
    mesh = MeshQuad.init_tensor(across, down)
    u = Basis(mesh, ElementVector(ElementQuad2()), intorder=4)
    p = u.with_element(ElementQuad1())
    shear, volume = _shear.assemble(u), _volume.assemble(u, p)
    system = bmat([[shear, volume.T], [volume, None]], format="csr")
    base = u.get_dofs(lambda x: x[1] < 1e-12).all()
    punch = u.get_dofs(lambda x: x[1] > 1.0 - 1e-12).all(["u^2"])
    middle = u.get_dofs(lambda x: x[0] < 1e-12).all(["u^1"])
    moved = np.zeros(system.shape[0])
    moved[punch] = -1.0
    fixed = np.unique(np.concatenate([base, punch, middle]))
    solution = solve(*condense(system, np.zeros_like(moved), x=moved, D=fixed))
    return -float((system @ solution)[punch].sum()) / half


def extrapolated_free_stiffness(width, elements=24):
    """Return p/(G d) on a fine mesh and the extrapolated value; the error is of second order in the element size."""
    coarse, fine = free_stiffness(width, elements), free_stiffness(width, 2 * elements)
    return fine, fine + (fine - coarse) / 3.0


def unbounded_stiffness(width, terms=8, longest=400.0, panels=1600):
    """Return p/(G d) if the strip continues on both sides of the punch."""
    half = 0.5 * width
    points, weights = leggauss(20)
    edges = np.linspace(0.0, longest / half, panels + 1)
    reach = 0.5 * np.diff(edges)[:, None]
    k = (0.5 * (edges[1:] + edges[:-1])[:, None] + reach * points).ravel()
    weight = (reach * weights).ravel()
    decay = np.exp(-2.0 * k)
    softness = (0.5 * (1.0 - decay**2) - 2.0 * k * decay) / (0.5 * (1.0 + decay**2) + decay * (1.0 + 2.0 * k**2))
    shapes = np.array([(-1) ** n * jv(2 * n, k * half) for n in range(terms)])
    matrix = (shapes * (weight * softness / (2.0 * k))) @ shapes.T / np.pi
    # Beyond the longest wave number, the compliance is 1/2k as for a half-plane, and products of Bessel functions have
    # their mean value.
    matrix += 1.0 / (2.0 * np.pi**2 * longest)
    return float(np.linalg.solve(matrix, np.eye(terms)[0])[0]) / width


if __name__ == "__main__":
    for width in (1.0, 2.0, 3.0, 4.0, 6.0):
        print(width, *extrapolated_free_stiffness(width), unbounded_stiffness(width))
