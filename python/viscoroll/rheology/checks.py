"""What is wrong with measured moduli, with names and numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import assert_never

import numpy as np

from .._support.arguments import Floats, as_float
from ..bodies import CoatedCylinder, CoatedSphere, CoatedWheel, RollingBody
from ..materials.moduli import to_core
from .measured import MeasuredModulus, measured
from .prony_fit import fit_prony
from .series import basis, time_grid
from .superposition import Superposition

__all__ = ["Check", "check_modulus", "check_range", "rolling_range"]

#: What a check lets pass whatever the noise [-].
_TOLERANCE = 0.02

#: Terms to a decade of the densest passive fit, and of the causal one, which more would let follow noise.
_DENSE, _SIGNED = 4.0, 2.0

#: Points of a tenth of a decade are averaged, before falls are looked for.
_CELLS_PER_DECADE = 10

#: Harmonics above the order 8 R/a, R/a across the contact's half-width, make less than about 2 % of the loss.
_ORDERS_ACROSS = 8.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """One property that a modulus must have.

    Attributes
    ----------
    name : str
        What is checked.
    value, limit : float
        What was found, and up to where it passes [-].
    message : str
        Both in a sentence.
    """

    name: str
    value: float
    limit: float
    message: str

    @property
    def passed(self) -> bool:
        """Whether the value is within its limit."""
        return self.value <= self.limit

    def __str__(self) -> str:
        """Return name, verdict and message in one line."""
        return f"{self.name}: {'consistent' if self.passed else 'INCONSISTENT'}, {self.message}"


def check_modulus(curve: MeasuredModulus) -> tuple[Check, ...]:
    """Check measured storage and loss against what every passive, causal material obeys.

    * Kramers-Kronig: a series of relaxation terms of *either sign* is causal, whatever else it is. What the best one
      leaves is at odds with causality (the linear test of Boukamp, J. Electrochem. Soc. 142 (1995) 1885, on moduli).
    * Passivity: what the best dense series of *positive* terms leaves; the best single check of data.
    * Monotony: the storage modulus of a passive solid never falls with frequency. Looked at are means over one, two,
      four ... tenths of a decade, and of their falls the one that is largest beside what scatter alone makes.

    Limits are twice the scatter from point to point, or 2 %; of monotony what the largest fall of so many points that
    scatter so much is hardly above.

    Parameters
    ----------
    curve : Superposition, Isotherm, MasterCurve, or anything with `frequency`, `storage` and `loss`
        Angular frequency [rad/s] and moduli [Pa].

    Returns
    -------
    tuple of Check
        In this order.
    """
    frequency, storage, loss = measured(curve)
    noise = _scatter(curve)
    limit = max(_TOLERANCE, 2.0 * noise * (1.0 + frequency.size**-0.5))  # to so much the scatter itself is known
    causal = _signed_residual(frequency, storage, loss)
    passive = fit_prony(curve, terms_per_decade=_DENSE)
    worst = float(max(np.abs(passive.storage_error).max(), np.abs(passive.loss_error).max()))
    drop, most = _telling_drop(frequency, storage, noise)
    against = f"where points scatter by {noise:.2%} (limit {limit:.2%})"
    left = math.hypot(passive.storage_rms, passive.loss_rms) / math.sqrt(2.0)
    return (
        Check(
            name="Kramers-Kronig",
            value=causal,
            limit=limit,
            message=f"the best causal series leaves {causal:.2%} of storage and loss {against}",
        ),
        Check(
            name="passivity",
            value=left,
            limit=limit,
            message=f"the best passive series leaves {passive.storage_rms:.2%} of storage and {passive.loss_rms:.2%} "
            f"of loss, {worst:.1%} at worst, {against}",
        ),
        Check(
            name="monotony",
            value=drop,
            limit=most,
            message=f"the storage modulus falls by {drop:.2%} as the frequency rises, where points that scatter by "
            f"{noise:.2%} may (limit {most:.2%})",
        ),
    )


def check_range(curve: MeasuredModulus, *, lowest: float, highest: float) -> Check:
    """Check whether a table holds the frequencies that rolling will ask for.

    Parameters
    ----------
    curve : MasterCurve, Superposition, or anything with `frequency`, `storage` and `loss`
        The table.
    lowest, highest : float
        Angular frequencies [rad/s], as of `rolling_range`.

    Returns
    -------
    Check
        Its value is the share of the decades asked for that has to be extrapolated.
    """
    frequency = measured(curve)[0]
    low, high = as_float("lowest", lowest), as_float("highest", highest)
    if not 0.0 < low < high < math.inf:
        raise ValueError(f"lowest and highest must be 0 < lowest < highest rad/s, got {low!r} and {high!r}")
    below = max(0.0, math.log10(min(frequency[0], high) / low))
    above = max(0.0, math.log10(high / max(frequency[-1], low)))
    share = (below + above) / math.log10(high / low)
    return Check(
        name="range",
        value=share,
        limit=0.0,
        message=f"rolling asks for {low:.3g} to {high:.3g} rad/s, the table has {frequency[0]:.3g} to "
        f"{frequency[-1]:.3g}: {below:.2g} decades below and {above:.2g} above are extrapolated",
    )


def rolling_range(ball: RollingBody, *, load: float, angular_speed: float) -> tuple[float, float]:
    """Estimate between which frequencies rolling dissipates, before solving.

    The lowest harmonic is the speed, the highest that counts about 8 R/a times the speed, with the contact's half-width
    a of Hertz for the modulus that it sees (larger than on a thin coating, so the upper end is an estimate from below).

    Parameters
    ----------
    ball : CoatedSphere, CoatedCylinder or CoatedWheel
        The body.
    load : float
        P [N], of a cylinder per length [N/m], > 0.
    angular_speed : float
        Ω [rad/s], > 0.

    Returns
    -------
    lowest, highest : float
        [rad/s].
    """
    from .. import _core

    outer = ball.layers[-1]
    radius, nu = ball.outer_radius, 0.5 if outer.poisson_ratio is None else outer.poisson_ratio
    order = 10.0
    for _ in range(20):  # a changes with the third root of the modulus, which changes little with a
        frequency = np.array([angular_speed * order])
        modulus = float(np.abs(_core.complex_modulus(to_core(outer.shear_modulus), frequency))[0])
        order = max(1.0, radius / _half_length(ball, load, (1.0 - nu) / modulus))
    return angular_speed, angular_speed * _ORDERS_ACROSS * order


def _half_length(body: RollingBody, load: float, compliance: float) -> float:
    """Half of Hertz's contact along the path [m], of (1 - ν)/G [1/Pa]; of a crown to a tenth, or of all its width."""

    def on_line(load: float) -> float:
        return float(np.sqrt(2.0 / np.pi * compliance * load * body.outer_radius))

    def on_spot(radius_ratio: float) -> float:
        return float(np.cbrt(0.375 * compliance * load * body.outer_radius * np.sqrt(radius_ratio)))

    match body:
        case CoatedSphere():
            return on_spot(1.0)
        case CoatedCylinder():
            return on_line(load)
        case CoatedWheel():
            return max(on_line(load / body.width), on_spot(body.outer_radius / body.crown_radius))
        case _:
            assert_never(body)


def _signed_residual(frequency: Floats, storage: Floats, loss: Floats) -> float:
    """Root mean square of what terms of either sign leave, for each degree of freedom."""
    data = np.concatenate([storage, loss])
    matrix = basis(frequency, time_grid(frequency, _SIGNED)) / data[:, None]
    found, _, rank, _ = np.linalg.lstsq(matrix / np.linalg.norm(matrix, axis=0), np.ones(data.size), rcond=1e-8)
    left = matrix / np.linalg.norm(matrix, axis=0) @ found - 1.0
    return float(np.sqrt(np.sum(left**2) / max(1, data.size - rank)))


def _scatter(curve: object) -> float:
    """Relative noise of single points: what they are off the line through their neighbors, sweep by sweep."""
    sweeps: Sequence[object] = [curve]
    if isinstance(curve, Superposition) and any(sweep.frequency.size >= 5 for sweep in curve.data.isotherms):
        sweeps = curve.data.isotherms  # else, as of a ramp, the points of all beside each other
    squares = []
    for sweep in sweeps:
        frequency, storage, loss = measured(sweep)  # type: ignore[arg-type]
        x = np.log(frequency)
        for y in (np.log(storage), np.log(loss)):
            if x.size < 5:
                continue
            # Third differences at equal ratios: curvature drops out; the weights' squares add up to 20.
            if np.ptp(np.diff(x)) < 0.2 * np.diff(x).mean():
                squares.append(np.diff(y, 3) ** 2 / 20.0)
            else:
                t = (x[1:-1] - x[:-2]) / np.maximum(x[2:] - x[:-2], 1e-12)
                squares.append((y[1:-1] - (1.0 - t) * y[:-2] - t * y[2:]) ** 2 / (1.0 + (1.0 - t) ** 2 + t**2))
    return float(np.sqrt(np.median(np.concatenate(squares)) / 0.455)) if squares else 0.0  # 0.455: of chi-squared


def _telling_drop(frequency: Floats, storage: Floats, noise: float) -> tuple[float, float]:
    """Return the fall of the storage modulus that is largest beside what it may be by scatter alone, and that.

    Of N values that scatter by s the largest difference is hardly above 2 s √(ln N²): the largest of M normal
    numbers is hardly above √2 s √(2 ln M), and there are M = N²/2 of them. From n points the scatter itself is known
    to 1/√n of it.
    """
    cells = np.floor(np.log10(frequency) * _CELLS_PER_DECADE).astype(np.int64)
    _, cells = np.unique(cells, return_inverse=True)
    count = np.bincount(cells).astype(float)
    level = np.bincount(cells, np.log(storage))
    spread = noise * (1.0 + frequency.size**-0.5) * np.sqrt(2.0 * np.log(max(count.size**2, 2)))
    least = -math.log1p(-_TOLERANCE)
    found = (-math.inf, least)
    width = 1
    while 2 * width <= count.size:
        points = np.convolve(count, np.ones(width), "valid")
        means = np.convolve(level, np.ones(width), "valid") / points
        # For each mean that a later one may fall short of, the highest beside its own scatter.
        for ahead in range(width, means.size):
            fall = means[:-ahead] - means[ahead:]
            limit = np.maximum(least, spread * np.sqrt(1.0 / points[:-ahead] + 1.0 / points[ahead:]))
            worst = int(np.argmax(fall - limit))
            if fall[worst] - limit[worst] > found[0] - found[1]:
                found = (float(fall[worst]), float(limit[worst]))
        width *= 2
    return max(0.0, -math.expm1(-found[0])), -math.expm1(-found[1])
