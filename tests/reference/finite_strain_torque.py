"""Finite-strain reference for slow rolling: the torque follows from the dissipation of a Kelvin-Voigt coating.

While the ball turns at Omega about the lateral axis e, material passes through the static field: x = chi(X), where X
moves at w = Omega e x X. The deformation rate is the rate of C = F^T F in the material frame,

    Cdot = w . grad C + C S - S C,    S = grad w,    D = F^-T Cdot F^-1 / 2.

On axes (R, theta, phi), with phi the azimuth from the rolling direction, the point moves by thetadot = Omega cos(phi)
and phidot = -Omega cot(theta) sin(phi), and these axes rotate relative to the material only about R, by -Omega
sin(phi)/sin(theta). C has the entries RR, R theta, theta theta and phi phi, equal for all phi; hence

    Cdot / Omega = cos(phi) dC/dtheta - sin(phi)/sin(theta) [C_Rtheta on R phi, C_thetatheta - C_phiphi on theta phi].

The second part has exactly the entries that are zero in C, so the power contains no products of both parts, and the
mean over phi is half of each. Three viscosities are objective and equal the linear one at small strain. Their power
per undeformed volume is 2 eta times

    newton     J D : D                          Cauchy's stress 2 eta D
    jaumann    D : b D = tr(C^-1 Cdot Cdot)/4   Kirchhoff's stress eta (b D + D b), Jaumann's rate of eta b
    lagrange   Edot : Edot, E = (C - 1)/2       Piola's second stress 2 eta Edot

and, for constant nu, additionally nu/(1-2nu) J (tr D)^2, for lagrange nu/(1-2nu) (tr Edot)^2. Torque = power / Omega,
here in units of P Omega r_o eta / G: linear theory tends to 1 as the load goes to zero (docs/theory/normal-contact.md).
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline
from skfem import Basis

from .finite_strain import points_of, strain_entries, volumes

VISCOSITIES = ("newton", "jaumann", "lagrange")


def double_trace(a, b):
    """Return tr(a b) of stacks of matrices."""
    return np.einsum("...ij,...ji->...", a, b)


def powers(c, rate, bulk):
    """Return the three powers per undeformed volume at eta = 1; `bulk` is nu / (1 - 2 nu), 0 if incompressible."""
    ratio = np.sqrt(np.linalg.det(c))
    mixed = np.linalg.solve(c, rate)  # C^-1 Cdot, similar to 2 D
    swelling = 0.25 * np.trace(mixed, axis1=-2, axis2=-1) ** 2
    newton = ratio * (0.25 * double_trace(mixed, mixed) + bulk * swelling)
    jaumann = 0.25 * double_trace(mixed, rate) + bulk * ratio * swelling
    lagrange = 0.25 * (double_trace(rate, rate) + bulk * np.trace(rate, axis1=-2, axis2=-1) ** 2)
    return 2.0 * np.array([newton, jaumann, lagrange])


def symmetric(rr, rt, rp, tt, tp, pp):
    """Return stacks of symmetric matrices on the axes (R, theta, phi)."""
    rows = np.broadcast_arrays(rr, rt, rp, rt, tt, tp, rp, tp, pp)
    return np.stack(rows, axis=-1).reshape(*rows[0].shape, 3, 3)


def slow_torques(coating, state, load):
    """Return the torque of each of VISCOSITIES in units of P Omega r_o eta / G.

    C is evaluated at 2 x 2 Gauss points, where the strains of Q2 are one order more accurate, and its rate by splines
    along theta, continued over the axis, where C_Rtheta is odd and all other entries are even.
    """
    gauss = Basis(coating.basis.mesh, coating.basis.elem, intorder=3)
    theta, radius = points_of(gauss)
    order = np.lexsort((theta.ravel(), np.round(radius.ravel() / coating.outer_radius, 12)))
    columns = 2 * (coating.grid[0].size - 1)

    def lines(field):
        """Return values at the points, with a row for each radius."""
        return field.ravel()[order].reshape(-1, columns)

    rest, entries = strain_entries(gauss)
    a, b, c, d, hoop, _ = rest + np.einsum("aieq,ae->ieq", entries, state[gauss.element_dofs])
    angle = lines(theta)[0]
    around = np.append(-angle[3::-1], angle)

    def along_theta(line, parity=1):
        return CubicSpline(around, np.hstack([parity * line[:, 3::-1], line]), axis=1)(angle, 1)

    tt, rt, rr, pp = (lines(entry) for entry in (a * a + c * c, a * b + c * d, b * b + d * d, hoop**2))
    strain = symmetric(rr, rt, 0.0, tt, 0.0, pp)
    ahead = symmetric(along_theta(rr), along_theta(rt, -1), 0.0, along_theta(tt), 0.0, along_theta(pp))
    aside = symmetric(0.0, 0.0, -rt / np.sin(angle), 0.0, (pp - tt) / np.sin(angle), 0.0)
    bulk = 0.5 / coating.softness if coating.softness > 0.0 else 0.0
    density = 0.5 * (powers(strain, ahead, bulk) + powers(strain, aside, bulk))
    return dict(
        zip(
            VISCOSITIES,
            (density * lines(volumes(gauss))).sum(axis=(1, 2)) / (load * coating.outer_radius),
            strict=True,
        )
    )
