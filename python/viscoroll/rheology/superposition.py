"""Time-temperature superposition: one master curve from sweeps at several temperatures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, overload

import numpy as np

from .._core import Extrapolation
from .._support.arguments import Floats, as_float, require_type
from ..materials import MasterCurve, Prony
from .alignment import align, shift_pairs, undetermined_pairs
from .prony_fit import PronyFit, fit_prony
from .reading import Isotherm, RheologyData
from .series import fit_series, time_grid
from .shift_laws import ShiftFactors, ShiftLaw, fit_arrhenius, fit_wlf

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Superposition", "superpose", "tabulated"]

#: A law is as good as can be seen that leaves so much of the shift factors [decades].
_ENOUGH = 0.01

#: Entries of a table to a decade: neighboring points of several isotherms are averaged.
_ENTRIES_PER_DECADE = 10


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Superposition:
    """Sweeps shifted onto one another.

    Attributes
    ----------
    data : RheologyData
        What was shifted.
    reference : float
        Temperature of the master curve [°C].
    factors : ShiftFactors
        log₁₀ a_T at the temperatures of the sweeps.
    vertical : tuple of float
        log₁₀ of what the moduli of each sweep were divided by; zeros unless asked for.
    scatter : float
        Root mean square of what the best nonnegative series leaves, relative, for each degree of freedom [-].
    undetermined : tuple of str
        Steps between sweeps that leave their shift open by half a decade or more, with by how much.
    covariance : ndarray or None
        Of the factors but the one of `anchor`; None for shift factors of the user.
    anchor : int
        The sweep nearest to the reference.
    """

    data: RheologyData
    reference: float
    factors: ShiftFactors
    vertical: tuple[float, ...]
    scatter: float
    undetermined: tuple[str, ...]
    covariance: Floats | None
    anchor: int

    @property
    def frequency(self) -> Floats:
        """Reduced angular frequency ω a_T of all points [rad/s], increasing."""
        return self._points[0]

    @property
    def storage(self) -> Floats:
        """Storage modulus of all points [Pa]."""
        return self._points[1]

    @property
    def loss(self) -> Floats:
        """Loss modulus of all points [Pa]."""
        return self._points[2]

    @property
    def _shifted(self) -> list[tuple[Floats, Floats, Floats]]:
        """Frequency, storage and loss of each sweep, shifted."""
        moved = zip(self.data.isotherms, self.factors.log10_factor, self.vertical, strict=True)
        return [(s.frequency * 10.0**a, s.storage * 10.0**-b, s.loss * 10.0**-b) for s, a, b in moved]

    @cached_property
    def _points(self) -> tuple[Floats, Floats, Floats]:
        frequency, storage, loss = (np.concatenate(parts) for parts in zip(*self._shifted, strict=True))
        order = np.argsort(frequency, kind="stable")
        return frequency[order], storage[order], loss[order]

    @cached_property
    def wlf(self) -> ShiftLaw:
        """Williams-Landel-Ferry law, fitted to the factors."""
        return fit_wlf(self.factors, self.reference, covariance=self.covariance, anchor=self.anchor)

    @cached_property
    def arrhenius(self) -> ShiftLaw:
        """Arrhenius law, fitted to the factors."""
        return fit_arrhenius(self.factors, self.reference, covariance=self.covariance, anchor=self.anchor)

    @property
    def law(self) -> ShiftLaw:
        """Arrhenius' law where it leaves hardly more than the other, which has one constant more; else WLF."""
        enough = max(_ENOUGH, 1.5 * self.wlf.residual)
        return self.arrhenius if self.arrhenius.residual <= enough else self.wlf

    def at(self, *, temperature: float) -> MasterCurve:
        """Return the modulus at a temperature, as a table with its end values held.

        Parameters
        ----------
        temperature : float
            [°C], between the coldest and the hottest sweep: shift factors are interpolated, no law is used.

        Returns
        -------
        MasterCurve
            Ten entries to a decade, each the geometric mean of the points around it. The first, at rest, which nobody
            can measure, is the relaxed modulus of `fit`.

        Raises
        ------
        ValueError
            For a temperature that was not measured; `law` tells what lies beyond.
        """
        degrees = as_float("temperature", temperature)
        scale = 10.0 ** -self.factors(degrees)
        lift = 10.0 ** float(np.interp(degrees, self.factors.temperature, self.vertical))
        table = self._table
        return MasterCurve(
            np.asarray(table.frequency) * scale,
            np.asarray(table.storage) * lift,
            np.asarray(table.loss) * lift,
            extrapolation=Extrapolation.HOLD,
        )

    @cached_property
    def _table(self) -> MasterCurve:
        return tabulated(self.frequency, self.storage, self.loss, relaxed=self.fit.relaxed_modulus)

    def series_at(self, *, temperature: float) -> Prony:
        """Return the Prony series of `fit` at a temperature [°C]; errors as of `at`."""
        degrees = as_float("temperature", temperature)
        series = self.fit.series
        lift = 10.0 ** float(np.interp(degrees, self.factors.temperature, self.vertical))
        return Prony(
            instantaneous_modulus=series.instantaneous_modulus * lift,
            weights=series.weights,
            relaxation_times=np.asarray(series.relaxation_times) * 10.0 ** self.factors(degrees),
        )

    @cached_property
    def fit(self) -> PronyFit:
        """The Prony series of the master curve at the reference temperature, as `fit_prony` finds it."""
        return fit_prony(self)

    @property
    def curve(self) -> MasterCurve:
        """The modulus at the reference temperature, as a table."""
        return self.at(temperature=self.reference)

    @overload
    def plot(self) -> Figure: ...

    @overload
    def plot(self, ax: Axes) -> Axes: ...

    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the master curve and its shift factors, or the curve alone into `ax` (the extra `viscoroll[plot]`)."""
        from .picture import plot_superposition

        laws = (getattr(self, name) for name in ("wlf", "arrhenius"))  # fitted where they are drawn
        return plot_superposition(self._shifted, self.factors, laws, reference=self.reference, ax=ax)

    def __repr__(self) -> str:
        """Return what was shifted, how well, and what is open."""
        low, high = self.frequency[0], self.frequency[-1]
        lines = [
            f"Superposition of {len(self.data.isotherms)} sweeps at {self.reference:g} °C: "
            f"{low:.3g} to {high:.3g} rad/s, {np.log10(high / low):.3g} decades",
            f"  scatter about one series  {self.scatter:.2%}",
            f"  {self.wlf}",
            f"  {self.arrhenius}",
            *(f"  undetermined              {text}" for text in self.undetermined),
        ]
        return "\n".join(lines)


def superpose(
    data: RheologyData,
    *,
    reference: float,
    factors: ShiftFactors | None = None,
    vertical: bool = False,
) -> Superposition:
    """Shift sweeps at several temperatures onto one master curve.

    Each sweep is first laid on its neighbor, then all are moved together until one Prony series with nonnegative
    weights fits them best: a master curve that no passive material has costs what it lacks.

    Parameters
    ----------
    data : RheologyData
        At least two sweeps, with temperatures.
    reference : float
        Temperature of the master curve [°C], between the coldest and the hottest sweep.
    factors : ShiftFactors, optional
        The caller's own, at temperatures that span the data; nothing is fitted then.
    vertical : bool, default False
        Let the moduli of a sweep be divided by a factor of its own, too.

    Returns
    -------
    Superposition
        Master curve, shift factors, laws with intervals, and which shifts the data leave open.

    Raises
    ------
    ValueError
        For fewer than two sweeps, for data without temperatures, and a reference outside them.
    """
    require_type("data", data, RheologyData)
    degrees = as_float("reference", reference)
    sweeps = data.isotherms
    temperature = np.array([sweep.temperature for sweep in sweeps])
    if len(sweeps) < 2:
        raise ValueError(f"data must hold at least 2 sweeps to be shifted, got {len(sweeps)}")
    if np.isnan(temperature).any():
        raise ValueError("data must have a temperature for every sweep: pass columns={'temperature': (name, unit)}")
    if not (np.diff(temperature) > 0.0).all():
        sweeps = _one_for_each_temperature(sweeps)
        return superpose(replace(data, isotherms=sweeps), reference=degrees, factors=factors, vertical=vertical)
    low, high = float(temperature[0]), float(temperature[-1])
    if not low - 0.5 <= degrees <= high + 0.5:
        raise ValueError(f"reference must be in [{low:g}, {high:g}] °C, where sweeps were measured, got {degrees:g}")
    if factors is not None:
        return _by_hand(data, degrees, temperature, factors)
    anchor = int(np.argmin(np.abs(temperature - degrees)))
    found = align(sweeps, shift_pairs(sweeps), reference=anchor, vertical=vertical)
    measured = ShiftFactors(temperature=tuple(temperature), log10_factor=tuple(found.horizontal))
    lifted = found.vertical - np.interp(degrees, temperature, found.vertical)
    return Superposition(
        data=data,
        reference=degrees,
        factors=measured.relative_to(degrees),
        vertical=tuple(lifted.tolist()),
        scatter=found.series.scatter,
        undetermined=undetermined_pairs(sweeps),
        covariance=found.covariance,
        anchor=anchor,
    )


def tabulated(frequency: Floats, storage: Floats, loss: Floats, *, relaxed: float | None = None) -> MasterCurve:
    """Return a table of ten entries to a decade at the most, geometric means of the points around them.

    With a relaxed modulus [Pa], the table begins with an entry at rest.
    """
    cells = np.floor(np.log10(frequency) * _ENTRIES_PER_DECADE).astype(np.int64)
    _, cells = np.unique(cells, return_inverse=True)
    count = np.bincount(cells)
    means = [np.exp(np.bincount(cells, np.log(values)) / count) for values in (frequency, storage, loss)]
    rest = [] if relaxed is None else [(0.0, relaxed, 0.0)]
    omega, real, imaginary = np.vstack([*rest, np.column_stack(means)]).T
    return MasterCurve(omega, real, imaginary, extrapolation=Extrapolation.HOLD)


def _by_hand(data: RheologyData, reference: float, temperature: Floats, factors: ShiftFactors) -> Superposition:
    chosen = ShiftFactors(
        temperature=tuple(temperature), log10_factor=tuple(factors(t) - factors(reference) for t in temperature)
    )
    given = Superposition(
        data=data,
        reference=reference,
        factors=chosen,
        vertical=(0.0,) * temperature.size,
        scatter=np.nan,
        undetermined=(),
        covariance=None,
        anchor=int(np.argmin(np.abs(temperature - reference))),
    )
    series = fit_series(given.frequency, given.storage, given.loss, time_grid(given.frequency, 2.0), floor=0.0)
    return replace(given, scatter=series.scatter)


def _one_for_each_temperature(sweeps: Sequence[Isotherm]) -> tuple[Isotherm, ...]:
    """Join sweeps that were repeated at the same temperature."""
    joined = []
    for temperature in sorted({sweep.temperature for sweep in sweeps}):
        same = [sweep for sweep in sweeps if sweep.temperature == temperature]
        columns = [np.concatenate([getattr(s, name) for s in same]) for name in ("frequency", "storage", "loss")]
        order = np.argsort(columns[0], kind="stable")
        frequency, storage, loss = (column[order] for column in columns)
        joined.append(Isotherm(temperature=temperature, frequency=frequency, storage=storage, loss=loss))
    return tuple(joined)
