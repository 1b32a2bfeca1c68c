"""One relaxation spectrum fitted to sweeps, stress relaxation and creep of one material, at any temperatures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .._core import Extrapolation
from .._support.arguments import Floats, as_float, as_kelvin
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput, InvalidType
from .._support.extras import extra
from .._support.quantities import quantity_text
from .._support.text import shown
from ..materials import Draws, MasterCurve, Prony
from ..materials.series import FLOOR, MARGIN, time_grid
from ..materials.shift import Shift, shift_factor
from .alignment import FREQUENCY_RATIO, curve_shift
from .bootstrap import modulus_band, wild_copies
from .checks import Check, scatter_check
from .joint_points import Points, Spectrum, fit_points, points_of, predicted
from .reading import Isotherm, RheologyData
from .shift_laws import ShiftFactors, ShiftLaw, fit_arrhenius, fit_wlf
from .tabulated import ENTRIES_PER_DECADE
from .time_tests import TimeData, TimeTest

if TYPE_CHECKING:
    from typing import TypeAlias

    from numpy.typing import ArrayLike, NDArray

    Test: TypeAlias = Isotherm | TimeTest
    Data: TypeAlias = RheologyData | TimeData | Test

__all__ = ["SpectrumFit", "fit_spectrum"]

_LN10 = math.log(10.0)

#: Relaxation times per decade, and number of shifted grids of times, of which the best is used.
_PER_DECADE, _GRIDS = 3.0, 4

#: Temperatures closer than this belong to one shift factor [K].
_SAME_TEMPERATURE = 1.0


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class SpectrumFit:
    """Prony series with nonnegative weights, fitted to frequency and time data together.

    Attributes
    ----------
    series : Prony
        Fitted material at the reference temperature.
    reference : float
        Reference temperature [K]; NaN if the data have no temperature.
    factors : ShiftFactors or None
        log₁₀ a_T at the temperatures of the data; None for data of one temperature.
    scatter : float
        Root mean square of the relative errors of all moduli, per degree of freedom [-].
    range : tuple of float
        Lowest and highest reduced frequency of the data, ω a_T or a_T/t [rad/s].
    """

    series: Prony
    reference: float
    factors: ShiftFactors | None
    scatter: float
    range: tuple[float, float]
    _points: Points
    _spectrum: Spectrum
    _shifts: Floats
    _temperatures: Floats
    _anchor: int
    _is_shift_given: bool
    _covariance: Floats | None
    _floor: float

    @property
    def relaxed_modulus(self) -> float:
        """Relaxed modulus [Pa]."""
        return self._spectrum.relaxed

    @property
    def check(self) -> Check:
        """Check of the scatter, at most 10 %: a larger one means that no passive material has these moduli.

        An example is a relaxation modulus that grows with time. Other causes are tests of different materials.
        """
        return scatter_check(self.scatter, "about one series")

    @property
    def curve(self) -> MasterCurve:
        """Modulus of the series at the reference temperature, as a table over the measured range with held ends.

        The first entry, at frequency 0, is the relaxed modulus.
        """
        low, high = self.range
        omega = np.geomspace(low, high, max(2, math.ceil(ENTRIES_PER_DECADE * math.log10(high / low)) + 1))
        modulus = self.series.complex_modulus(omega)
        return MasterCurve(
            np.concatenate([[0.0], omega]),
            np.concatenate([[self.relaxed_modulus], modulus.real]),
            np.concatenate([[0.0], modulus.imag]),
            extrapolation=Extrapolation.HOLD,
        )

    def series_at(self, *, temperature: float) -> Prony:
        """Return the series at a temperature [K] within the range of the data, with interpolated shift factors.

        Raises
        ------
        ValueError
            If the temperature is outside the measured range, or the data have one temperature only.
        """
        factor = self._factor(temperature)
        return replace(self.series, relaxation_times=np.asarray(self.series.relaxation_times) * factor)

    def range_at(self, *, temperature: float) -> tuple[float, float]:
        """Return the measured frequencies at a temperature [rad/s]; parameter and exceptions as in `series_at`."""
        factor = self._factor(temperature)
        return self.range[0] / factor, self.range[1] / factor

    def _factor(self, temperature: float) -> float:
        kelvin = as_kelvin("temperature", temperature)
        if self.factors is None:
            raise InvalidInput("temperature", "must be left out for data of one temperature", kelvin_text(kelvin))
        return float(10.0 ** self.factors(kelvin))

    @cached_property
    def law(self) -> ShiftLaw:
        """Williams-Landel-Ferry law of the shift factors, or Arrhenius law if its residual is smaller.

        Raises
        ------
        ValueError
            If the data have one temperature only.
        """
        if self.factors is None:
            raise InvalidInput("data", "must have several temperatures for a law of the shift", "one")
        laws = [
            fit(self.factors, self.reference, covariance=self._covariance, anchor=self._anchor)
            for fit in (fit_arrhenius, fit_wlf)
        ]
        return min(laws, key=lambda law: law.residual)

    def draws(self, count: int = 100, *, seed: int = 0) -> Draws[SpectrumFit]:
        """Return equally likely fits to copies of the data with errors of random sign, as in `PronyFit.draws`.

        Each draw has shift factors of its own, unless they were given. The draws do not include errors that all points
        of a test share, such as those of the dimensions of the specimen.

        Parameters
        ----------
        count : int, default 100
            Number of draws, ≥ 2.
        seed : int, default 0
            Seed of the random signs, ≥ 0.

        Returns
        -------
        Draws of SpectrumFit
            Draws with this fit as the best estimate. ``fit.draws(100).map(lambda one: one.series)`` are materials.
        """
        points, spectrum = self._points, self._spectrum
        expected = points.modulus * (1.0 + spectrum.residual)
        columns = spectrum.derivative[:, spectrum.used]
        if not self._is_shift_given and self._temperatures.size > 1:
            columns = np.hstack([columns, _shift_columns(points, spectrum, self._shifts, self._anchor)])
        copies = wild_copies(points.modulus, expected, columns, count=count, seed=seed)
        return Draws(self, (self._refitted(copy) for copy in copies))

    def _refitted(self, modulus: Floats) -> SpectrumFit:
        return _fitted(
            replace(self._points, modulus=modulus),
            self._temperatures,
            self.reference,
            self._anchor,
            self._shifts,
            is_shift_given=self._is_shift_given,
            floor=self._floor,
        )

    def confidence_band(
        self, angular_frequency: ArrayLike, *, confidence: float = 0.95, count: int = 100, seed: int = 0
    ) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Return pointwise confidence bounds of μ*(ω) at the reference temperature, as `PronyFit.confidence_band`.

        Parameters
        ----------
        angular_frequency : array_like
            ω [rad/s], > 0, one-dimensional.
        confidence : float, default 0.95
            Confidence level of each interval [-].
        count, seed : int, default 100 and 0
            Number of draws and seed, the same as in `draws`.

        Returns
        -------
        lower, upper : ndarray of complex
            Bounds of storage (real part) and loss (imaginary part) [Pa].
        """
        drawn = (one.series for one in self.draws(count, seed=seed))
        return modulus_band(self.series, drawn, angular_frequency, confidence)

    def __repr__(self) -> str:
        """Return the numbers of points and terms, the range and the scatter, and the law of the shift."""
        names = {"storage": "storage and loss", "relaxation": "relaxation", "creep": "creep"}
        counts = {name: int((self._points.quantity == key).sum()) for key, name in names.items()}
        points = ", ".join(f"{count} of {name}" for name, count in counts.items() if count)
        low, high = self.range
        relaxed = quantity_text(self.relaxed_modulus, "Pa")
        lines = [
            f"SpectrumFit of {points}: {len(self.series.weights)} terms, relaxed modulus {relaxed}",
            f"  measured                  {low:.3g} to {high:.3g} rad/s (1/t for points over time)",
            f"  scatter about one series  {self.scatter:.2%}",
        ]
        if self.factors is not None:
            lines.append(f"  {self.law}")
        return "\n".join(lines)


def fit_spectrum(
    data: Data | Iterable[Data],
    *,
    reference: float | None = None,
    factors: ShiftFactors | Shift | None = None,
    relaxed_floor: float | None = None,
) -> SpectrumFit:
    """Fit one Prony series to sweeps, stress relaxation and creep of one material.

    The fit is a nonnegative least-squares problem in the relative errors of all moduli, which are G', G'', G(t) and
    1/J(t). The compliance is that of the series itself. Data at several temperatures are shifted until one series fits
    all of them best, as `superpose` does.

    Parameters
    ----------
    data : RheologyData, TimeData, Isotherm, TimeTest, or iterable of these
        Measurements of one material.
    reference : float, optional
        Temperature of the series [K], between the coldest and the hottest test; required for several temperatures.
    factors : ShiftFactors, WilliamsLandelFerry, Arrhenius or callable, optional
        Known shift factors at temperatures that span the data, or a law as a function of temperature in kelvin. By
        default the shifts are fitted.
    relaxed_floor : float, optional
        Smallest relaxed modulus [Pa], > 0, at most the lowest modulus other than a loss modulus; by default a hundredth
        of this modulus.

    Returns
    -------
    SpectrumFit
        Material, shift factors, errors and draws.

    Raises
    ------
    TypeError
        If `data` contain an object of another type.
    ValueError
        If there are no data, a temperature is missing, the reference is outside the temperatures, or `relaxed_floor` is
        above a measured modulus.
    ConvergenceError
        If the fit does not converge.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> time = np.geomspace(0.01, 100.0, 30)
    >>> test = vr.rheology.TimeTest(kind="relaxation", time=time, modulus=3e6 * (1.0 + np.exp(-time)))
    >>> fit = vr.rheology.fit_spectrum(test)
    >>> bool(fit.scatter < 1e-3)
    True
    """
    tests = list(_tests_of(data))
    if not tests:
        raise InvalidInput("data", "must contain a test", "none")
    temperatures, indices = _temperatures_of(tests)
    points = points_of(tests, indices)
    lowest = float(points.modulus[points.quantity != "loss"].min())
    floor = FLOOR * lowest if relaxed_floor is None else as_float("relaxed_floor", relaxed_floor)
    if not 0.0 < floor <= lowest:
        rule = f"must be in (0, {lowest:.4g}] Pa, at most the lowest modulus other than a loss modulus"
        raise InvalidInput("relaxed_floor", rule, f"{floor:.4g} Pa")
    if temperatures.size == 1:
        kelvin = _one_reference(reference, float(temperatures[0]))
        return _fitted(points, temperatures, kelvin, 0, np.zeros(1), is_shift_given=True, floor=floor)
    low, high = float(temperatures[0]), float(temperatures[-1])
    if reference is None:
        raise InvalidInput("reference", "must be given for several temperatures", kelvin_range(low, high))
    kelvin = as_kelvin("reference", reference)
    if not low - 0.5 <= kelvin <= high + 0.5:
        raise InvalidInput(
            "reference", f"must be in the measured range, {kelvin_range(low, high)}", kelvin_text(kelvin)
        )
    anchor = int(np.argmin(np.abs(temperatures - kelvin)))
    if factors is None:
        start = _first_shifts(tests, indices, temperatures.size)
        shifts = start - start[anchor]
    elif isinstance(factors, ShiftFactors):
        shifts = np.array([factors(t) - factors(kelvin) for t in temperatures.tolist()])
    else:
        shifts = np.log10([shift_factor(factors, t, "factors") for t in temperatures.tolist()])
        shifts = shifts - math.log10(shift_factor(factors, kelvin, "factors"))
    return _fitted(points, temperatures, kelvin, anchor, shifts, is_shift_given=factors is not None, floor=floor)


def _tests_of(data: object) -> Iterable[Test]:
    """Yield the tests of measurements in any accepted form."""
    if isinstance(data, RheologyData):
        yield from data.isotherms
    elif isinstance(data, TimeData):
        yield from data.tests
    elif isinstance(data, Isotherm | TimeTest):
        yield data
    elif isinstance(data, Iterable) and not isinstance(data, str):
        for part in data:
            yield from _tests_of(part)
    else:
        raise InvalidType("data", "must be measurements: RheologyData, TimeData, Isotherm or TimeTest", shown(data))


def _one_reference(reference: float | None, temperature: float) -> float:
    """Return the temperature of data at one temperature, after a check that the reference agrees."""
    if reference is None:
        return temperature
    kelvin = as_kelvin("reference", reference)
    if not abs(kelvin - temperature) <= _SAME_TEMPERATURE:
        got = "one test without a temperature" if math.isnan(temperature) else f"one at {kelvin_text(temperature)}"
        raise InvalidInput("reference", "must be left out without tests at two or more temperatures", got)
    return temperature


def _temperatures_of(tests: Sequence[Test]) -> tuple[Floats, list[int]]:
    """Return the different temperatures [K], increasing, and the index of that of each test."""
    given = np.array([test.temperature for test in tests])
    if np.isnan(given).any():
        if not np.isnan(given).all():
            raise InvalidInput("data", "must have a temperature for every test or for none")
        return np.array([math.nan]), [0] * len(tests)
    order = np.argsort(given, kind="stable")
    groups = np.zeros(given.size, dtype=np.int64)
    groups[order] = np.cumsum(np.diff(given[order], prepend=given[order[0]]) > _SAME_TEMPERATURE)
    means = np.bincount(groups, given) / np.bincount(groups)
    return means, groups.tolist()


def _first_shifts(tests: Sequence[Test], indices: Sequence[int], count: int) -> Floats:
    """Return log₁₀ a_T relative to the coldest temperature, from the shifts between neighbors."""
    curves = [_static([test for test, index in zip(tests, indices, strict=True) if index == i]) for i in range(count)]
    return np.concatenate([[0.0], np.cumsum([curve_shift(cold, hot) for cold, hot in pairwise(curves)])])


def _static(tests: Sequence[Test]) -> list[tuple[Floats, Floats]]:
    """Return log₁₀ of frequency and modulus of each test: G(t) and 1/J(t) are near G'(ω) at ω = 1/t."""
    return [
        (np.log10(test.frequency), np.log10(test.storage))
        if isinstance(test, Isotherm)
        else (-np.log10(test.time[::-1]), np.log10(test.modulus[::-1]))
        for test in tests
    ]


def _fitted(
    points: Points,
    temperatures: Floats,
    reference: float,
    anchor: int,
    shifts: Floats,
    *,
    is_shift_given: bool,
    floor: float,
) -> SpectrumFit:
    """Return the fit of points, in which the shifts are fitted too unless they are given."""
    covariance = None
    margin = MARGIN if is_shift_given else 2.0 * MARGIN  # for changes of the shifts
    times = time_grid(points.shifted(shifts), _PER_DECADE, margin=margin)
    if not is_shift_given:
        shifts, covariance = _aligned(points, times, anchor, shifts, floor)
    reduced = points.shifted(shifts)
    times = time_grid(reduced, _PER_DECADE, margin=MARGIN)
    grids = (times * 10.0 ** (grid / (_GRIDS * _PER_DECADE)) for grid in range(_GRIDS))
    spectrum = min((fit_points(points, reduced, grid, floor=floor) for grid in grids), key=lambda fit: fit.scatter)
    factors = None
    if temperatures.size > 1:
        measured = ShiftFactors(temperature=tuple(temperatures.tolist()), log10_factor=tuple(shifts.tolist()))
        factors = measured if is_shift_given else measured.relative_to(reference)
    # The fit is at the temperature of the anchor; the series is that at the reference.
    moved = 0.0 if factors is None else float(factors.log10_factor[anchor] - shifts[anchor])
    used = spectrum.terms > 0.0
    instantaneous = spectrum.relaxed + float(spectrum.terms.sum())
    reduced = reduced * 10.0**moved
    return SpectrumFit(
        series=Prony(
            instantaneous_modulus=instantaneous,
            weights=spectrum.terms[used] / instantaneous,
            relaxation_times=spectrum.times[used] * 10.0**-moved,
        ),
        reference=reference,
        factors=factors,
        scatter=spectrum.scatter,
        range=(float(reduced.min()), float(reduced.max())),
        _points=points,
        _spectrum=spectrum,
        _shifts=shifts,
        _temperatures=temperatures,
        _anchor=anchor,
        _is_shift_given=is_shift_given,
        _covariance=covariance,
        _floor=floor,
    )


def _aligned(points: Points, times: Floats, anchor: int, start: Floats, floor: float) -> tuple[Floats, Floats]:
    """Return the shifts for which one spectrum fits best, and their covariance without that of the anchor.

    The method is that of `alignment`: only the shifts are iterated, with the Jacobian of Kaufman.
    """
    with extra("studies"):
        from scipy.optimize import least_squares

    others = np.delete(np.arange(start.size), anchor)
    last: list[tuple[Floats, Spectrum]] = []

    def unpacked(x: Floats) -> Floats:
        shifts = np.zeros(start.size)
        shifts[others] = x
        return shifts

    def fit(x: Floats) -> Spectrum:
        if not last or not np.array_equal(last[0][0], x):  # residual and Jacobian share an x
            before = (last[0][1].relaxed, last[0][1].terms) if last else None
            last[:] = [(x.copy(), fit_points(points, points.shifted(unpacked(x)), times, floor=floor, start=before))]
        return last[0][1]

    def jacobian(x: Floats) -> Floats:
        spectrum = fit(x)
        ratio = (1.0 + spectrum.residual)[:, None]
        slopes = _LN10 * ratio * _shift_columns(points, spectrum, unpacked(x), anchor)
        q, _ = np.linalg.qr(ratio * spectrum.derivative[:, spectrum.used])
        return np.asarray(slopes - q @ (q.T @ slopes))

    found = least_squares(
        lambda x: fit(x).residual, start[others], jac=jacobian, x_scale=0.1, xtol=1e-6, ftol=1e-8, max_nfev=60
    )
    scatter = fit(found.x).scatter
    covariance = np.linalg.pinv(found.jac.T @ found.jac, rcond=1e-14, hermitian=True) * scatter**2
    return unpacked(found.x), covariance


def _shift_columns(points: Points, spectrum: Spectrum, shifts: Floats, anchor: int) -> Floats:
    """Return the derivative of the logarithm of all moduli by ln a_T of each temperature except the anchor."""
    frequency = points.shifted(shifts)
    low, _ = predicted(points, frequency / FREQUENCY_RATIO, spectrum.times, spectrum.relaxed, spectrum.terms)
    high, _ = predicted(points, frequency * FREQUENCY_RATIO, spectrum.times, spectrum.relaxed, spectrum.terms)
    slope = np.log(high / low) / (2.0 * math.log(FREQUENCY_RATIO))
    others = np.delete(np.arange(shifts.size), anchor)
    return np.where(points.temperature[:, None] == others, slope[:, None], 0.0)
