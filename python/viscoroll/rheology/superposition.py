"""Master curve from sweeps at several temperatures, with its shift laws, series, tables and draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .._support.arguments import Floats, as_kelvin
from .._support.celsius import kelvin_text
from .._support.plotting import plots
from ..materials import Draws, MasterCurve, Prony
from ..materials.series import basis
from .alignment import FREQUENCY_RATIO, align
from .bootstrap import wild_copies
from .prony_fit import PronyFit, fit_prony
from .reading import RheologyData
from .shift_laws import ShiftFactors, ShiftLaw, fit_arrhenius, fit_wlf
from .tabulated import tabulated

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

__all__ = ["Superposition", "aligned"]

#: Residual of the shift factors below which a law counts as adequate [decades].
_ADEQUATE_RESIDUAL = 0.01

#: Largest number of undetermined steps that are printed.
_MAX_LISTED = 4


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Superposition:
    """Sweeps at several temperatures, shifted onto one master curve.

    Attributes
    ----------
    data : RheologyData
        Measured sweeps.
    reference : float
        Temperature of the master curve [K].
    factors : ShiftFactors
        log₁₀ a_T at the temperatures of the sweeps.
    vertical : tuple of float
        log₁₀ of the factor by which the moduli of each sweep are divided; zeros without vertical shifts.
    scatter : float
        Relative root-mean-square residual of the best nonnegative series, per degree of freedom [-].
    undetermined : tuple of str
        Steps between neighboring sweeps that do not overlap, or for which all shifts in a range of at least half a
        decade fit about equally well, with this range.
    covariance : ndarray or None
        Covariance of the factors, without that of `anchor`; None for given shift factors.
    anchor : int
        Index of the sweep nearest to the reference.
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
        """Frequency [rad/s], storage and loss modulus [Pa] of each sweep after the shift."""
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
        """Recommended law: Arrhenius, with one constant less, or WLF if the Arrhenius residual is clearly larger."""
        largest_residual = max(_ADEQUATE_RESIDUAL, 1.5 * self.wlf.residual)
        return self.arrhenius if self.arrhenius.residual <= largest_residual else self.wlf

    def at(self, *, temperature: float) -> MasterCurve:
        """Return the modulus at a temperature, as a table that is constant beyond its ends.

        Parameters
        ----------
        temperature : float
            Temperature [K], between the coldest and the hottest sweep. Shift factors are interpolated, without a law.

        Returns
        -------
        MasterCurve
            Table with up to ten entries per decade, geometric means of the points around them. The first entry, at
            frequency 0, cannot be measured; it is the relaxed modulus of `fit`.

        Raises
        ------
        ValueError
            If the temperature is outside the measured range; `law` extrapolates beyond it.
        """
        kelvin = as_kelvin("temperature", temperature)
        scale = 10.0 ** -self.factors(kelvin)
        vertical_factor = 10.0 ** float(np.interp(kelvin, self.factors.temperature, self.vertical))
        table = self._table
        return MasterCurve(
            np.asarray(table.frequency) * scale,
            np.asarray(table.storage) * vertical_factor,
            np.asarray(table.loss) * vertical_factor,
            extrapolation=table.extrapolation,
        )

    @cached_property
    def _table(self) -> MasterCurve:
        return tabulated(self.frequency, self.storage, self.loss, relaxed=self.fit.relaxed_modulus)

    def series_at(self, *, temperature: float) -> Prony:
        """Return the Prony series of `fit` at a temperature [K]; parameter and exceptions same as in `at`."""
        kelvin = as_kelvin("temperature", temperature)
        series = self.fit.series
        vertical_factor = 10.0 ** float(np.interp(kelvin, self.factors.temperature, self.vertical))
        return Prony(
            instantaneous_modulus=series.instantaneous_modulus * vertical_factor,
            weights=series.weights,
            relaxation_times=np.asarray(series.relaxation_times) * 10.0 ** self.factors(kelvin),
        )

    @cached_property
    def fit(self) -> PronyFit:
        """Prony series of the master curve at the reference temperature, from `fit_prony`."""
        return fit_prony(self)

    def draws(self, count: int = 100, *, seed: int = 0) -> Draws[Superposition]:
        """Return equally likely superpositions, each fitted to a copy of the data with random signs of the errors.

        The method is a wild bootstrap (`docs/theory/materials.md`). Each draw has its own shift factors, series and
        tables, but given shift factors are kept. The draws do not include errors that all points share, such as those
        of the dimensions of the specimen.

        Parameters
        ----------
        count : int, default 100
            Number of draws, ≥ 2.
        seed : int, default 0
            Seed of the random signs, ≥ 0.

        Returns
        -------
        Draws of Superposition
            Draws with this superposition as the best estimate. ``curve.draws(100).map(lambda c:
            c.at(temperature=313.15))`` are materials at 313.15 K (40 °C).
        """
        sweeps = self.data.isotherms
        series = self.fit.series
        sweep_index = np.concatenate([np.full(sweep.frequency.size, i) for i, sweep in enumerate(sweeps)])
        frequency, storage, loss = (np.concatenate(parts) for parts in zip(*self._shifted, strict=True))
        expected = _parts_of(series.complex_modulus(frequency))
        columns = [basis(frequency, np.asarray(series.relaxation_times)) / expected[:, None]]
        if self.covariance is not None:
            slope = np.log(_parts_of(series.complex_modulus(frequency * FREQUENCY_RATIO)) / expected)
            columns += [
                np.tile(sweep_index == i, 2)[:, None] * slope[:, None] for i in range(len(sweeps)) if i != self.anchor
            ]
        data = np.concatenate([storage, loss])
        copies = wild_copies(data, expected, np.hstack(columns), count=count, seed=seed)
        return Draws(self, (self._refitted(np.split(copy, 2), sweep_index) for copy in copies))

    def _refitted(self, moduli: Sequence[Floats], sweep_index: NDArray[np.int64]) -> Superposition:
        """Return the superposition fitted to other shifted storage and loss moduli [Pa] at the same frequencies."""
        storage, loss = (values * 10.0 ** np.asarray(self.vertical)[sweep_index] for values in moduli)
        isotherms = tuple(
            replace(sweep, storage=storage[sweep_index == i], loss=loss[sweep_index == i])
            for i, sweep in enumerate(self.data.isotherms)
        )
        data = replace(self.data, isotherms=isotherms)
        if self.covariance is None:
            return replace(self, data=data)
        start = np.array(self.factors.log10_factor)
        found = aligned(data, self.reference, start, self.anchor, vertical=any(self.vertical))
        return replace(self, data=data, **found)

    @property
    def curve(self) -> MasterCurve:
        """Modulus at the reference temperature, as a table."""
        return self.at(temperature=self.reference)

    @plots("only the curve")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Plot the master curve and its shift factors."""
        from .picture import plot_superposition

        laws = (getattr(self, name) for name in ("wlf", "arrhenius"))  # fitted only if they are drawn
        return plot_superposition(self._shifted, self.factors, laws, reference=self.reference, ax=ax)

    def __repr__(self) -> str:
        """Return number of sweeps, frequency range, scatter, laws and undetermined steps."""
        low, high = self.frequency[0], self.frequency[-1]
        lines = [
            f"Superposition of {len(self.data.isotherms)} sweeps at {kelvin_text(self.reference)}: "
            f"{low:.3g} to {high:.3g} rad/s, {np.log10(high / low):.3g} decades",
            f"  scatter about one series  {self.scatter:.2%}",
            f"  {self.wlf}",
            f"  {self.arrhenius}",
            *(f"  undetermined              {text}" for text in self.undetermined[:_MAX_LISTED]),
        ]
        if (more := len(self.undetermined) - _MAX_LISTED) > 0:
            lines.append(f"  undetermined              {more} more of {len(self.data.isotherms) - 1} steps")
        return "\n".join(lines)


def aligned(data: RheologyData, reference: float, start: Floats, anchor: int, *, vertical: bool) -> dict[str, Any]:
    """Move sweeps until one series fits them best, and return the resulting attributes of a `Superposition`."""
    temperature = [sweep.temperature for sweep in data.isotherms]
    found = align(data.isotherms, start, reference=anchor, vertical=vertical)
    measured = ShiftFactors(temperature=tuple(temperature), log10_factor=tuple(found.horizontal))
    vertical_shifts = found.vertical - np.interp(reference, temperature, found.vertical)
    return {
        "factors": measured.relative_to(reference),
        "vertical": tuple(vertical_shifts.tolist()),
        "scatter": found.series.scatter,
        "covariance": found.covariance,
    }


def _parts_of(modulus: NDArray[np.complex128]) -> Floats:
    """Return all storage moduli, then all loss moduli."""
    return np.concatenate([modulus.real, modulus.imag])
