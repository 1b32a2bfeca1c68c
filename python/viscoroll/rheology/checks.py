"""Consistency checks of measured moduli."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .._support.arguments import Floats, as_float
from ..bodies import RollingBody
from ..materials.modulus_like import to_core
from ..materials.series import basis, time_grid
from .measured import MeasuredModulus, measured
from .prony_fit import fit_prony
from .superposition import Superposition

__all__ = ["Check", "check_modulus", "check_range", "rolling_range", "scatter_check"]

#: Limit of the checks for data without scatter [-].
_TOLERANCE = 0.02

#: Largest plausible scatter [-]. Rheometers repeat a modulus within a few percent. A larger scatter means that the
#: points belong to different temperatures, strains or specimens.
_LARGEST_SCATTER = 0.1

#: Terms per decade of the passive and of the causal fit. More terms of either sign would fit the noise.
_DENSE, _SIGNED = 4.0, 2.0

#: Cells per decade of frequency. Points in one cell are averaged before the check for a decrease.
_CELLS_PER_DECADE = 10

#: Largest relevant order, relative to R/a with the half-width a of the contact. Higher orders contribute less than
#: about 2 % of the dissipation.
_ORDERS_ACROSS = 8.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Check:
    """Result of one consistency check of a modulus.

    Attributes
    ----------
    name : str
        Name of the property.
    value, limit : float
        Measured value, and the largest value that passes [-].
    message : str
        Sentence that contains both.
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
    """Check measured storage and loss for properties of every passive, causal material.

    * Kramers-Kronig: a series of relaxation terms of *either sign* is causal. The residual of the best such series
      therefore contradicts causality (the linear test of Boukamp, J. Electrochem. Soc. 142 (1995) 1885, applied to
      moduli).
    * Passivity: the residual of the best dense series of *positive* terms. This is the best single check of data.
    * Monotony: the storage modulus of a passive solid never decreases with frequency. The check compares means over
      one, two, four ... tenths of a decade and reports the decrease that is largest relative to its limit.
    * Scatter from point to point: at most 10 %, because the limits of the other checks follow from it.

    The limits of the first two are twice the scatter from point to point, or 2 % if this is larger. The limit of the
    third is the largest decrease that scatter alone is likely to cause, or 2 %.

    Parameters
    ----------
    curve : Superposition, Isotherm, MasterCurve, or anything with `frequency`, `storage` and `loss`
        Angular frequency [rad/s] and moduli [Pa].

    Returns
    -------
    tuple of Check
        The four checks, in this order.
    """
    frequency, storage, loss = measured(curve)
    noise = _scatter(curve)
    limit = max(_TOLERANCE, 2.0 * noise * (1.0 + frequency.size**-0.5))  # adds the uncertainty of the scatter
    causal = _signed_residual(frequency, storage, loss)
    passive = fit_prony(curve, terms_per_decade=_DENSE)
    worst = float(max(np.abs(passive.storage_error).max(), np.abs(passive.loss_error).max()))
    drop, most = _telling_drop(frequency, storage, noise)
    against = f"; scatter of the points {noise:.2%} (limit {limit:.2%})"
    left = math.hypot(passive.storage_rms, passive.loss_rms) / math.sqrt(2.0)
    return (
        Check(
            name="Kramers-Kronig",
            value=causal,
            limit=limit,
            message=f"residual of the best causal series {causal:.2%}{against}",
        ),
        Check(
            name="passivity",
            value=left,
            limit=limit,
            message=f"residual of the best passive series {passive.storage_rms:.2%} (storage) and "
            f"{passive.loss_rms:.2%} (loss), largest {worst:.1%}{against}",
        ),
        Check(
            name="monotonicity",
            value=drop,
            limit=most,
            message=f"largest decrease of the storage modulus with frequency {drop:.2%}; scatter of the points "
            f"{noise:.2%} (limit {most:.2%})",
        ),
        scatter_check(noise, "of the points"),
    )


def scatter_check(scatter: float, reference: str) -> Check:
    """Return the check of a relative scatter [-], whose message contains the reference, such as "of the points"."""
    return Check(
        name="scatter",
        value=scatter,
        limit=_LARGEST_SCATTER,
        message=f"scatter {reference} {scatter:.2%} (limit {_LARGEST_SCATTER:.0%})",
    )


def check_range(curve: MeasuredModulus, *, lowest: float, highest: float) -> Check:
    """Check whether a table contains the frequencies that rolling requires.

    Parameters
    ----------
    curve : MasterCurve, Superposition, or anything with `frequency`, `storage` and `loss`
        Table to check.
    lowest, highest : float
        Angular frequencies [rad/s], for example from `rolling_range`.

    Returns
    -------
    Check
        Its value is the fraction of the required decades that has to be extrapolated [-].
    """
    frequency = measured(curve)[0]
    low, high = as_float("lowest", lowest), as_float("highest", highest)
    if not 0.0 < low < high < math.inf:
        raise ValueError(f"lowest and highest must satisfy 0 < lowest < highest [rad/s], got {low!r} and {high!r}")
    below = max(0.0, math.log10(min(frequency[0], high) / low))
    above = max(0.0, math.log10(high / max(frequency[-1], low)))
    share = (below + above) / math.log10(high / low)
    return Check(
        name="range",
        value=share,
        limit=0.0,
        message=f"rolling requires {low:.3g} to {high:.3g} rad/s, the table covers {frequency[0]:.3g} to "
        f"{frequency[-1]:.3g}: {below:.2g} decades below and {above:.2g} above it are extrapolated",
    )


def rolling_range(body: RollingBody, *, load: float, angular_speed: float) -> tuple[float, float]:
    """Estimate the range of frequencies at which a rolling body dissipates power, without solving.

    The lowest harmonic is the angular speed. The highest relevant one is about 8 R/a times the angular speed, with the
    half-width a of Hertz's contact for the modulus at the contact frequency. The contact on a thin coating is smaller,
    so the true upper end may be higher.

    Parameters
    ----------
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        Rolling body.
    load : float
        Normal load P [N], > 0. For cylinders, load per unit length [N/m].
    angular_speed : float
        Angular speed Ω [rad/s], > 0.

    Returns
    -------
    lowest, highest : float
        Angular frequencies [rad/s].
    """
    from .. import _core

    outer = body.layers[-1]
    radius, nu = body.outer_radius, 0.5 if outer.poisson_ratio is None else outer.poisson_ratio
    order = 10.0
    for _ in range(20):  # a depends on the cube root of the modulus, which hardly depends on a
        frequency = np.array([angular_speed * order])
        modulus = float(np.abs(_core.complex_modulus(to_core(outer.shear_modulus), frequency))[0])
        order = max(1.0, radius / _half_length(body, load, (1.0 - nu) / modulus))
    return angular_speed, angular_speed * _ORDERS_ACROSS * order


def _half_length(body: RollingBody, load: float, compliance: float) -> float:
    """Return half of the length of Hertz's contact along the path [m], for the compliance (1 - ν)/G [1/Pa].

    For a crowned wheel the result is accurate to a tenth; it is at least that of a contact over the whole width.
    """

    def on_line(load: float) -> float:
        return float(np.sqrt(2.0 / np.pi * compliance * load * body.outer_radius))

    def on_spot(radius_ratio: float) -> float:
        return float(np.cbrt(0.375 * compliance * load * body.outer_radius * np.sqrt(radius_ratio)))

    if body.line_contact:
        return on_line(load)
    if body.width is None or body.crown_radius is None:
        return on_spot(1.0)
    return max(on_line(load / body.width), on_spot(body.outer_radius / body.crown_radius))


def _signed_residual(frequency: Floats, storage: Floats, loss: Floats) -> float:
    """Return the root-mean-square residual of a series with terms of either sign, per degree of freedom."""
    data = np.concatenate([storage, loss])
    matrix = basis(frequency, time_grid(frequency, _SIGNED)) / data[:, None]
    found, _, rank, _ = np.linalg.lstsq(matrix / np.linalg.norm(matrix, axis=0), np.ones(data.size), rcond=1e-8)
    left = matrix / np.linalg.norm(matrix, axis=0) @ found - 1.0
    return float(np.sqrt(np.sum(left**2) / max(1, data.size - rank)))


def _scatter(curve: object) -> float:
    """Return the relative noise of single points, from their distances to neighboring points within each sweep."""
    sweeps: Sequence[object] = [curve]
    if isinstance(curve, Superposition) and any(sweep.frequency.size >= 5 for sweep in curve.data.isotherms):
        sweeps = curve.data.isotherms  # otherwise, for example for a ramp, neighbors are points of all sweeps
    squares = []
    for sweep in sweeps:
        frequency, storage, loss = measured(sweep)  # type: ignore[arg-type]
        x = np.log(frequency)
        for y in (np.log(storage), np.log(loss)):
            if x.size < 5:
                continue
            # Third differences at equal ratios eliminate curvature. The squares of their weights add up to 20.
            if np.ptp(np.diff(x)) < 0.2 * np.diff(x).mean():
                squares.append(np.diff(y, 3) ** 2 / 20.0)
            else:
                t = (x[1:-1] - x[:-2]) / np.maximum(x[2:] - x[:-2], 1e-12)
                squares.append((y[1:-1] - (1.0 - t) * y[:-2] - t * y[2:]) ** 2 / (1.0 + (1.0 - t) ** 2 + t**2))
    return float(np.sqrt(np.median(np.concatenate(squares)) / 0.455)) if squares else 0.0  # 0.455: median of χ²


def _telling_drop(frequency: Floats, storage: Floats, noise: float) -> tuple[float, float]:
    """Return the decrease of the storage modulus that exceeds its limit most, and this limit.

    The limit is the largest decrease that scatter alone is likely to cause. The largest of M normal numbers hardly
    exceeds √(2 ln M) standard deviations. N values with the standard deviation s have M = N²/2 differences, each with
    the standard deviation √2 s, so the largest difference hardly exceeds 2 s √(ln N²). The relative error of s,
    estimated from n points, is 1/√n.
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
        # For each earlier mean, compare the decrease to a later mean with the limit from the scatter of both.
        for ahead in range(width, means.size):
            fall = means[:-ahead] - means[ahead:]
            limit = np.maximum(least, spread * np.sqrt(1.0 / points[:-ahead] + 1.0 / points[ahead:]))
            worst = int(np.argmax(fall - limit))
            if fall[worst] - limit[worst] > found[0] - found[1]:
                found = (float(fall[worst]), float(limit[worst]))
        width *= 2
    return max(0.0, -math.expm1(-found[0])), -math.expm1(-found[1])
