"""Static contact of an exact, solid, incompressible sphere with a plane: the limit of thick coatings."""

from __future__ import annotations

import numpy as np


def compliance(degree):
    """Return radial displacement / radial traction P_n(cos theta), without shear, in units of radius / shear modulus.

    The solution is Lamb's u = grad phi + (n+3) r^2 grad p / (2 (n+1)(2n+3)) - n x p / ((n+1)(2n+3)), with phi and p
    solid harmonics of degree n >= 2, in units of the shear modulus: sigma_r,theta = 0 gives phi, and sigma_rr = -p
    (2n^2+4n+3) / ((2n+3)(n+1)), u_r = -r p n (2n+1) / (2 (2n+3)(n^2-1)). It tends to 1/(2n), a half-space.
    """
    n = np.asarray(degree, dtype=float)
    return n * (2 * n + 1) / (2 * (n - 1) * (2 * n**2 + 4 * n + 3))


def approach(contact_radius, *, rings=80, planes=1):
    """Return d / a^2 for radius and shear modulus 1, under Hertz's load for the contact radius a.

    The approach is that of one plane relative to the mean of the ball, without the degrees 0 and 1, or half that of two
    opposite planes. Pressure is constant on rings of polar angle and acts along the radius; the plane is at 1 - d.
    """
    edges = np.linspace(0.0, 1.3 * contact_radius, rings + 1)
    x, middle = np.cos(edges), np.cos(0.5 * (edges[1:] + edges[:-1]))
    matrix = np.zeros((rings, rings))
    before, there = (np.ones(rings + 1), x), (np.ones(rings), middle)
    for n in range(1, int(40.0 / (edges[1] - edges[0]))):
        after = ((2 * n + 1) * x * before[1] - n * before[0]) / (n + 1)
        if n >= 2 and n % planes == 0:
            matrix += planes * compliance(n) * np.outer(there[1], np.diff(before[0] - after) / 2)
        before = before[1], after
        there = there[1], ((2 * n + 1) * middle * there[1] - n * there[0]) / (n + 1)
    area, touching = -2.0 * np.pi * np.diff(x) * middle, np.ones(rings, bool)
    while True:
        i = np.flatnonzero(touching)
        system = np.block([[matrix[np.ix_(i, i)], -1.0 / middle[i, None]], [area[None, i], np.zeros((1, 1))]])
        unknowns = np.linalg.solve(system, np.append(1.0 - 1.0 / middle[i], 16.0 / 3.0 * contact_radius**3))
        if (unknowns[:-1] >= 0.0).all():
            return unknowns[-1] / contact_radius**2
        touching[i[unknowns[:-1] < 0.0]] = False
