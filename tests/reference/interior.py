"""Fields of one order inside the layers to many digits, by products of transition matrices with extra digits."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import mpmath
import numpy as np


@dataclass(frozen=True)
class Shell:
    """A layer with a Prony series; `poisson_ratio` or `bulk_modulus` as in the package."""

    inner: float
    outer: float
    prony: tuple[float, list[float], list[float]]
    poisson_ratio: float | None = None
    bulk_modulus: float | None = None
    density: float = 0.0

    def shear_modulus(self, omega):
        """Return the complex shear modulus at a frequency >= 0."""
        g0, weights, times = self.prony
        terms = [
            mpmath.mpf(g) * 1j * omega * t / (1 + 1j * omega * mpmath.mpf(t))
            for g, t in zip(weights, times, strict=True)
        ]
        return mpmath.mpf(g0) * (1 - sum(mpmath.mpf(g) for g in weights) + sum(terms))

    def poisson(self, mu):
        """Return Poisson's ratio, complex if the bulk modulus is given."""
        if self.poisson_ratio is not None:
            return mpmath.mpf(self.poisson_ratio)
        bulk = mpmath.mpf(self.bulk_modulus)
        return (3 * bulk - 2 * mu) / (6 * bulk + 2 * mu)


def _equations(nu, mu, m, n, membrane):
    """Return B and M of z' = (B + q M) z in s = ln r, docs/theory/layers.md, in the components of the paper."""
    i = mpmath.mpc(0, 1)
    a, b = nu / (1 - nu), (1 - 2 * nu) / (2 * (1 - nu))
    gamma = mu * (3 * a + 2 * b)
    elastic = mpmath.matrix(
        [
            [-2 * a, -i * m * a, -i * n * a, b / mu, 0, 0],
            [-i * m, 1, 0, 0, 1 / mu, 0],
            [-i * n, 0, 1, 0, 0, 1 / mu],
            [4 * gamma, 2 * i * m * gamma, 2 * i * n * gamma, 1 - 4 * b, -i * m, -i * n],
            [-2 * i * m * gamma, m**2 * gamma + membrane, m * n * gamma, -i * m * a, -2, 0],
            [-2 * i * n * gamma, m * n * gamma, n**2 * gamma + membrane, -i * n * a, 0, -2],
        ]
    )
    inertia = mpmath.zeros(6)
    inertia[3, 0] = inertia[4, 1] = -(1 + m**2)
    inertia[3, 1], inertia[4, 0], inertia[5, 2] = -2 * i * m, 2 * i * m, -(m**2)
    return elastic, inertia


def _transition(elastic, inertia, q, x):
    """Return the Taylor series in (r - r0) / r0 up to x of (1 + x) dz/dx = (B + q (1 + x)^2 M) z."""
    if not q:
        return mpmath.expm(elastic * mpmath.log1p(x), method="taylor")
    total = term = mpmath.eye(6)
    before = before2 = mpmath.zeros(6)
    j = 0
    while j <= 5 or mpmath.mnorm(term, 1) >= mpmath.eps * mpmath.mnorm(total, 1):
        rate = elastic * term - j * term
        rate += q * (inertia * (term + 2 * x * before + x**2 * before2))
        before2, before, term = before, term, x / (j + 1) * rate
        total += term
        j += 1
    return total


def order_fields(shells, angular_speed, m, n, places, *, inner_boundary="rigid", paper=True, digits=50):
    """Return displacement, stress and strain per unit surface stress at places (radius, number of the shell).

    Returns arrays (places, 3 or 6, 3) of components r, phi, theta and rr, phiphi, thetatheta, rphi, rtheta, phitheta.
    `paper` selects the membrane term of (26). Otherwise the term is that of a sphere, and stress and strain along the
    surface are nan.
    """
    k = math.hypot(m, n)
    outer = shells[-1].outer
    growth = k * math.log(outer / shells[0].inner) if shells[0].inner > 0 else 40.0
    with mpmath.workdps(int(digits + 1.0 * growth + 30)):
        inner = mpmath.mpf(shells[0].inner)
        if inner_boundary == "solid":
            inner = mpmath.mpf(outer) * mpmath.exp(-40 / mpmath.mpf(k))
        z = mpmath.zeros(6, 3)
        for i in range(3):
            z[i if inner_boundary == "hollow" else 3 + i, i] = 1
        found = {}
        omega = mpmath.mpf(m) * mpmath.mpf(angular_speed)
        for number, shell in enumerate(shells):
            mu = shell.shear_modulus(omega)
            nu = shell.poisson(mu)
            k2 = m**2 + n**2
            membrane = mu * (k2 if paper else k2 - 2 if k2 >= 4 else mpmath.mpf(k2) / 2)
            elastic, inertia = _equations(nu, mu, m, n, membrane)
            low = inner if number == 0 else mpmath.mpf(shell.inner)
            stops = sorted({low, mpmath.mpf(shell.outer), *(mpmath.mpf(r) for r, s in places if s == number)})
            for start, end in itertools.pairwise(stops):
                found.setdefault((float(start), number), (z, mu, nu))
                steps = int(mpmath.ceil(mpmath.log(end / start) / 0.2)) if shell.density else 1
                x = mpmath.expm1(mpmath.log(end / start) / steps)
                for step in range(steps):
                    radius = start * (1 + x) ** step
                    q = mpmath.mpf(shell.density) * mpmath.mpf(angular_speed) ** 2 * radius**2
                    z = _transition(elastic, inertia, q, x) * z
            found[float(mpmath.mpf(shell.outer)), number] = (z, mu, nu)
        unit = mpmath.inverse(z[3:, :]) * mpmath.mpf(outer)
        return [_components(*found[float(r), s], unit, r, m, n, paper) for r, s in places]


def _components(z, mu, nu, unit, radius, m, n, paper):
    i, r = mpmath.mpc(0, 1), mpmath.mpf(radius)
    state = z * unit
    displacement, stress, strain = (np.full((rows, 3), np.nan, dtype=complex) for rows in (3, 6, 6))
    for load in range(3):
        ur, up, ut, srr, srp, srt = (state[row, load] for row in range(6))
        srr, srp, srt = srr / r, srp / r, srt / r
        displacement[:, load] = [complex(v) for v in (ur, up, ut)]
        stress[[0, 3, 4], load] = [complex(v) for v in (srr, srp, srt)]
        strain[[3, 4], load] = [complex(v / (2 * mu)) for v in (srp, srt)]
        if not paper:
            continue
        epp, ett, ept = (ur + i * m * up) / r, (ur + i * n * ut) / r, i * (m * ut + n * up) / (2 * r)
        # Hooke's law, (18), solved for the unknown components.
        err = ((1 - 2 * nu) * (1 + nu) / (2 * mu * (1 + nu)) * srr - nu * (epp + ett)) / (1 - nu)
        spp, stt = srr + 2 * mu * (epp - err), srr + 2 * mu * (ett - err)
        stress[[1, 2, 5], load] = [complex(v) for v in (spp, stt, 2 * mu * ept)]
        strain[[0, 1, 2, 5], load] = [complex(v) for v in (err, epp, ett, ept)]
    return displacement, stress, strain
