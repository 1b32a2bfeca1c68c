"""Shift factors and their dependence on temperature."""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats, as_floats, as_kelvin
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput, Range, in_file
from .._support.extras import extra
from .._support.files import write_text
from .._support.least_squares import Parameter, with_intervals
from .._support.text import finite_number, shown
from ..materials import Arrhenius, WilliamsLandelFerry
from .formats import read_text
from .names import PLACES, UNITS_OF, parse_header

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["ShiftFactors", "ShiftLaw", "fit_arrhenius", "fit_wlf"]

_GAS_CONSTANT = 8.314462618  # [J/(mol K)]

#: Largest absolute value of log₁₀ a_T: five times the shifts of polymers across the glass transition. Beyond it, times
#: and frequencies may exceed the range of floats.
_MAX_DECADES = 100.0

#: Highest temperature of a table, and smallest difference between two of its entries [K].
_HOTTEST, _CLOSEST = 1e4, 1e-6


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ShiftFactors:
    """Measured shift factors: the modulus at temperature T and frequency ω is that of the reference at ω a_T.

    Parameters
    ----------
    temperature : array_like
        Temperatures [K], in [100, 1e4], at least two, increasing by at least 1e-6 K from entry to entry.
    log10_factor : array_like
        log₁₀ a_T [-], in [-100, 100], as many as `temperature`; 0 at the reference.
    """

    temperature: tuple[float, ...]
    log10_factor: tuple[float, ...]

    def __post_init__(self) -> None:
        """Check the table."""
        for name in ("temperature", "log10_factor"):
            object.__setattr__(self, name, as_floats(name, getattr(self, name)))
        if len(self.temperature) < 2 or len(self.temperature) != len(self.log10_factor):
            raise ValueError(
                "temperature and log10_factor must have the same length >= 2, "
                f"got {len(self.temperature)} and {len(self.log10_factor)}"
            )
        hottest = Range(maximum=_HOTTEST, unit="K")
        for index, value in enumerate(self.temperature):
            if as_kelvin(f"temperature[{index}]", value) not in hottest:
                raise hottest.error(f"temperature[{index}]", f"{value:g} K")
        for index, value in enumerate(self.log10_factor):
            if not abs(value) <= _MAX_DECADES:
                allowed = f"[-{_MAX_DECADES:g}, {_MAX_DECADES:g}]"
                raise InvalidInput(f"log10_factor[{index}]", f"must be in {allowed}", f"{value:g}")
        if not (np.diff(self.temperature) >= _CLOSEST).all():
            raise InvalidInput("temperature", f"must increase from entry to entry, by at least {_CLOSEST:g} K")

    def __call__(self, temperature: float) -> float:
        """Return log₁₀ a_T at a temperature [K], interpolated by a monotonic cubic.

        Raises
        ------
        ValueError
            If the temperature is outside the table.
        """
        with extra("studies"):
            from scipy.interpolate import PchipInterpolator

        temperature = as_kelvin("temperature", temperature)
        low, high = self.temperature[0], self.temperature[-1]
        if not low - 0.5 <= temperature <= high + 0.5:  # the temperature of a sweep drifts by some tenths
            raise InvalidInput(
                "temperature",
                f"must be in the measured range, {kelvin_range(low, high)}",
                f"{kelvin_text(temperature)}",
            )
        return float(PchipInterpolator(self.temperature, self.log10_factor)(min(max(temperature, low), high)))

    def relative_to(self, reference: float) -> ShiftFactors:
        """Return the factors relative to another temperature [K]."""
        offset = self(reference)
        return ShiftFactors(
            temperature=self.temperature, log10_factor=tuple(value - offset for value in self.log10_factor)
        )

    @classmethod
    def read(cls, path: str | Path) -> ShiftFactors:
        """Read a CSV file of temperatures and log₁₀ a_T.

        Parameters
        ----------
        path : path-like
            File with a row of names, "T,log_aT"; a row of units, with K, C or F for the temperature; and rows of
            numbers. The unit may instead be in the name, as in "temperature [°C]"; then the row of units is absent.

        Returns
        -------
        ShiftFactors
            Table with temperatures in K.

        Raises
        ------
        ValueError
            If the file has another form, the unit of the temperature is missing, or `ShiftFactors` rejects a number.
        """
        try:
            rows = [row for row in csv.reader(read_text(Path(path)).splitlines(), skipinitialspace=True) if row]
        except csv.Error as error:
            raise in_file(error, path) from None
        name, unit = parse_header(rows[0][0]) if rows else ("", "")
        first = 1 if unit else 2
        if len(rows) <= first or name.lower() not in ("t", "temperature", "temp."):
            raise ValueError(f"{path}: must have a row of names (T, log_aT), a row of units (K, -) and rows of numbers")
        unit = unit or rows[1][0].strip()
        scale = {key.lower(): value for key, value in UNITS_OF["temperature"].items()}.get(unit.strip("[]()").lower())
        if scale is None:
            raise ValueError(
                f"{path}: temperature must have the unit 'K', 'C' or 'F' in the row of units, got {unit!r}"
            )
        factor, offset = scale
        pairs = []
        for row in rows[first:]:
            numbers = [finite_number(cell) for cell in row[:2]]
            if len(row) != len(rows[0]) or len(numbers) < 2 or None in numbers:
                raise ValueError(
                    f"{path}: every row below the units must start with two finite numbers, and have as many cells as "
                    f"the row of names, got {shown(row)}"
                )
            pairs.append(numbers)
        temperature, shifts = zip(*sorted(pairs), strict=True)
        try:
            kelvin = tuple(round(value * factor + offset, PLACES) for value in temperature)
            return cls(temperature=kelvin, log10_factor=shifts)
        except ValueError as error:
            raise in_file(error, path) from None

    def save(self, path: str | Path) -> None:
        """Write a CSV file that `read` reads, with temperatures in K."""
        rows = "".join(f"{t!r},{a!r}\n" for t, a in zip(self.temperature, self.log10_factor, strict=True))
        write_text(f"T,log_aT\nK,-\n{rows}", Path(path))


#: C₂ [K] beyond which the Williams-Landel-Ferry law is a straight line, to one percent over a hundred kelvin. For
#: polymers C₂ is about 50 K plus the distance of the reference from the glass transition.
_STRAIGHT = 1e4


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ShiftLaw:
    """Law fitted to shift factors.

    Attributes
    ----------
    name : str
        "WLF", log₁₀ a_T = -C₁ (T - T_r) / (C₂ + T - T_r), or "Arrhenius", ln a_T = E_a / R (1/T - 1/T_r).
    reference : float
        Reference temperature T_r [K].
    parameters : dict of str to Parameter
        c1 [1] and c2 [K], or activation_energy [J/mol], with their intervals.
    confidence : float
        Confidence level of the intervals [-].
    residual : float
        Root-mean-square residual of the law [decades].
    """

    name: str
    reference: float
    parameters: dict[str, Parameter]
    confidence: float
    residual: float

    def __call__(self, temperature: ArrayLike) -> Floats:
        """Return log₁₀ a_T at temperatures [K]."""
        kelvin = np.asarray(temperature, dtype=float)
        if kelvin.size:
            as_kelvin("temperature", kelvin.min())
        values = [parameter.value for parameter in self.parameters.values()]
        model = _wlf if self.name == "WLF" else _arrhenius
        return model(kelvin, self.reference, *values)

    def shift(self) -> WilliamsLandelFerry | Arrhenius:
        """Return a_T as a function of temperature in kelvin, for `viscoroll.self_heating`."""
        values = {name: parameter.value for name, parameter in self.parameters.items()}
        kind = WilliamsLandelFerry if self.name == "WLF" else Arrhenius
        return kind(**values, reference_temperature=self.reference)

    def __str__(self) -> str:
        """Return law, parameters with intervals, and residual in one line."""
        left = f"residual {self.residual:.3f} decades"
        if (c2 := self.parameters.get("c2")) is not None and c2.value > _STRAIGHT:
            return (
                f"{self.name} at {kelvin_text(self.reference)}: constants undetermined, the shifts lack its curvature; "
                f"{left}"
            )
        terms = ", ".join(
            f"{name} = {p.value:.5g} {'' if p.unit == '1' else p.unit + ' '}in [{p.lower:.5g}, {p.upper:.5g}]"
            for name, p in self.parameters.items()
        )
        return f"{self.name} at {kelvin_text(self.reference)}: {terms}; {left}"


def fit_wlf(factors: ShiftFactors, reference: float, **options: object) -> ShiftLaw:
    """Fit the constants of the Williams-Landel-Ferry law; the arguments are the same as in `fit_arrhenius`."""
    start = np.array([15.0, 60.0 + max(0.0, reference - factors.temperature[0])])
    return _fit("WLF", _wlf, factors, reference, {"c1": "1", "c2": "K"}, start, **options)  # type: ignore[arg-type]


def fit_arrhenius(factors: ShiftFactors, reference: float, **options: object) -> ShiftLaw:
    """Fit the activation energy of the Arrhenius law.

    Parameters
    ----------
    factors : ShiftFactors
        Measured shift factors.
    reference : float
        Reference temperature T_r [K].
    covariance : ndarray, optional
        Covariance of the factors relative to that at `anchor`, which is left out. By default all have the same weight.
    anchor : int, default 0
        Index of the factor to which the others are relative.
    confidence : float, default 0.95
        Confidence level of the intervals [-].
    """
    units = {"activation_energy": "J/mol"}
    return _fit("Arrhenius", _arrhenius, factors, reference, units, np.array([1e5]), **options)  # type: ignore[arg-type]


def _wlf(temperature: Floats, reference: float, c1: float, c2: float) -> Floats:
    return -c1 * (temperature - reference) / (c2 + temperature - reference)


def _arrhenius(temperature: Floats, reference: float, energy: float) -> Floats:
    inverse = 1.0 / temperature - 1.0 / reference
    return np.asarray(energy / (_GAS_CONSTANT * math.log(10.0)) * inverse)


def _fit(
    name: str,
    model: Callable[..., Floats],
    factors: ShiftFactors,
    reference: float,
    units: dict[str, str],
    start: Floats,
    *,
    covariance: Floats | None = None,
    anchor: int = 0,
    confidence: float = 0.95,
) -> ShiftLaw:
    with extra("studies"):
        from scipy.optimize import least_squares

    temperature, measured = np.array(factors.temperature), np.array(factors.log10_factor)
    others = np.arange(temperature.size) != anchor
    # Factors of isotherms that were shifted together have common errors: whiten them by their covariance.
    whiten = np.eye(int(others.sum())) if covariance is None else np.linalg.inv(np.linalg.cholesky(covariance))

    def left(p: Floats) -> Floats:
        law = model(temperature, reference, *(p * start))
        return np.asarray((measured - measured[anchor]) - (law - law[anchor]))

    def whitened(p: Floats) -> Floats:
        with np.errstate(all="ignore"):
            return np.asarray(np.nan_to_num(whiten @ left(p)[others], nan=1e9, posinf=1e9, neginf=-1e9))

    # C₂ > T_r - T keeps the pole of the law below all temperatures.
    lowest = [0.0, (reference - temperature.min() + 1.0) / start[1]] if name == "WLF" else [-np.inf]
    found = least_squares(whitened, np.maximum(np.ones(start.size), np.array(lowest) * 1.1), bounds=(lowest, np.inf))
    freedom = max(1, int(others.sum()) - start.size)
    spread = 2.0 * found.cost / freedom
    scale = spread if covariance is None else max(1.0, spread)
    of_parameters = np.linalg.pinv(found.jac.T @ found.jac) * scale * np.outer(start, start)
    return ShiftLaw(
        name=name,
        reference=reference,
        parameters=with_intervals(units, found.x * start, of_parameters, confidence, freedom),
        confidence=confidence,
        residual=float(np.sqrt(np.mean(left(found.x)[others] ** 2))),
    )
