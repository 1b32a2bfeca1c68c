"""Prony series fitted to measured moduli."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats, as_count, as_float_in, as_positive
from .._support.errors import Range
from .._support.plotting import plots
from .._support.quantities import quantity_text
from ..materials import Draws, Prony
from ..materials.series import FLOOR, MARGIN, SeriesFit, basis, fit_series, fit_sparse, time_grid
from .bootstrap import modulus_band, wild_copies
from .measured import MeasuredModulus, measured

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

__all__ = ["PronyFit", "fit_prony"]

#: Number of shifted grids of relaxation times; the fit uses the best one. The shift matters for materials with few
#: sharp relaxations.
_SHIFTS = 8


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class PronyFit:
    """Prony series with nonnegative weights, with its data and errors.

    Attributes
    ----------
    series : Prony
        Fitted material.
    frequency : ndarray
        Angular frequencies of the data [rad/s], increasing.
    storage, loss : ndarray
        Measured moduli [Pa].
    storage_error, loss_error : ndarray
        Fit / data - 1 at each point [-].
    scatter : float
        Root mean square of both errors per degree of freedom [-]. It estimates the noise of the data if a passive
        material fits them.
    """

    series: Prony
    frequency: Floats
    storage: Floats
    loss: Floats
    storage_error: Floats
    loss_error: Floats
    scatter: float
    _fit: SeriesFit
    _floor: float
    _per_decade: float
    _most_terms: int | None

    @property
    def relaxed_modulus(self) -> float:
        """Relaxed modulus [Pa]."""
        return self._fit.relaxed

    @property
    def storage_rms(self) -> float:
        """Root mean square of the relative error of the storage modulus [-]."""
        return float(np.sqrt(np.mean(self.storage_error**2)))

    @property
    def loss_rms(self) -> float:
        """Root mean square of the relative error of the loss modulus [-]."""
        return float(np.sqrt(np.mean(self.loss_error**2)))

    def draws(self, count: int = 100, *, seed: int = 0) -> Draws[Prony]:
        """Return equally likely alternative series, fitted to copies of the data with errors of random sign.

        The method is a wild bootstrap (`docs/theory/materials.md`). It does not include errors that all points share,
        such as those of the dimensions of the specimen, or errors of shift factors. `Superposition.draws` includes the
        errors of shift factors.

        Parameters
        ----------
        count : int, default 100
            Number of draws, ≥ 2.
        seed : int, default 0
            Seed of the random signs, ≥ 0.

        Returns
        -------
        Draws of Prony
            Draws with `series` as the best estimate, for example for `viscoroll.sweep`.
        """
        expected = self._expected()
        used = np.concatenate([[True], self._fit.terms > 0.0])
        columns = basis(self.frequency, self._fit.times)[:, used] / expected[:, None]
        data = np.concatenate([self.storage, self.loss])
        copies = wild_copies(data, expected, columns, count=count, seed=seed)
        return Draws(self.series, (self._refitted(copy).series for copy in copies))

    def _expected(self) -> Floats:
        """Return storage and loss modulus of the fit at the frequencies of the data [Pa]."""
        fitted = self._fit.modulus(self.frequency)
        return np.concatenate([fitted.real, fitted.imag])

    def _refitted(self, moduli: Floats) -> PronyFit:
        """Return the fit of other data at the same frequencies: all storage moduli, then all loss moduli [Pa]."""
        storage, loss = np.split(moduli, 2)
        fit = _fit_on_best_grid(self.frequency, storage, loss, self._per_decade, self._floor)
        if self._most_terms is not None:
            fit = fit_sparse(fit, self.frequency, storage, loss, terms=self._most_terms, floor=self._floor)
        return _result(fit, self.frequency, storage, loss, self._floor, self._per_decade, self._most_terms)

    def confidence_band(
        self, angular_frequency: ArrayLike, *, confidence: float = 0.95, count: int = 100, seed: int = 0
    ) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Return pointwise confidence bounds of μ*(ω) from the scatter of `draws`.

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
        return modulus_band(self.series, self.draws(count, seed=seed), angular_frequency, confidence)

    def sparse(self, terms: int) -> PronyFit:
        """Return a fit with few terms, whose times are fitted too, for programs that limit the number of terms.

        With fewer terms, the fit deviates more from the data, and the draws do not include this deviation. Use the
        full series for intervals.

        Parameters
        ----------
        terms : int
            Largest number of terms, ≥ 1.

        Returns
        -------
        PronyFit
            Fit with at most that many terms.

        Raises
        ------
        ValueError
            If `terms` is less than 1.
        """
        as_count("terms", terms, 1)
        fit = fit_sparse(self._fit, self.frequency, self.storage, self.loss, terms=terms, floor=self._floor)
        return _result(fit, self.frequency, self.storage, self.loss, self._floor, self._per_decade, terms)

    @plots("only the moduli")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Plot data and fit, and the relative errors below."""
        from .picture import plot_fit

        data = (self.frequency, self.storage, self.loss)
        return plot_fit(data, self.series, errors=(self.storage_error, self.loss_error), ax=ax)

    def __repr__(self) -> str:
        """Return number of points and terms, relaxed modulus and errors."""
        decades = np.log10(self.frequency[-1] / self.frequency[0])
        return (
            f"PronyFit of {self.frequency.size} points over {decades:.3g} decades: {len(self.series.weights)} terms, "
            f"relaxed modulus {quantity_text(self._fit.relaxed, 'Pa')}, error of storage {self.storage_rms:.2%}, "
            f"of loss {self.loss_rms:.2%} (root mean square)"
        )


def fit_prony(curve: MeasuredModulus, *, terms_per_decade: float = 2.0, relaxed_floor: float | None = None) -> PronyFit:
    """Fit a Prony series to measured storage and loss moduli.

    The fit is a nonnegative least-squares problem in the relative errors of both moduli. The times have equal ratios
    and extend half a decade beyond the data. Within the resolution of the times, the result is the best fit of any
    passive material.

    Parameters
    ----------
    curve : MasterCurve, Superposition, Isotherm, or anything with `frequency`, `storage` and `loss`
        Measured moduli: angular frequency [rad/s] and moduli [Pa], all > 0. An entry at frequency 0 is ignored.
    terms_per_decade : float, default 2
        Relaxation times per decade [-], in [0.5, 10].
    relaxed_floor : float, optional
        Smallest relaxed modulus [Pa], > 0; by default a hundredth of the lowest storage modulus. In steady rolling the
        material must support a static load.

    Returns
    -------
    PronyFit
        Material, errors and intervals.

    Raises
    ------
    ValueError
        If there are fewer than three points, or a value is not positive.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.1)
    >>> omega = np.geomspace(0.1, 1000.0, 41)
    >>> modulus = rubber.complex_modulus(omega)
    >>> fit = vr.rheology.fit_prony(vr.MasterCurve(omega, modulus.real, modulus.imag))
    >>> bool(fit.storage_rms < 0.01)
    True
    """
    frequency, storage, loss = measured(curve)
    per_decade = as_float_in(Range(0.5, 10.0), "terms_per_decade", terms_per_decade)
    given = FLOOR * float(storage.min()) if relaxed_floor is None else relaxed_floor
    floor = as_positive("relaxed_floor", given, "Pa")
    fit = _fit_on_best_grid(frequency, storage, loss, per_decade, floor)
    return _result(fit, frequency, storage, loss, floor, per_decade, None)


def _fit_on_best_grid(frequency: Floats, storage: Floats, loss: Floats, per_decade: float, floor: float) -> SeriesFit:
    """Return the fit with the smallest scatter among the shifted grids of times."""
    times = time_grid(frequency, per_decade, margin=MARGIN)
    grids = (times * 10.0 ** (shift / (_SHIFTS * per_decade)) for shift in range(_SHIFTS))
    return min((fit_series(frequency, storage, loss, t, floor=floor) for t in grids), key=lambda fit: fit.scatter)


def _result(
    fit: SeriesFit,
    frequency: Floats,
    storage: Floats,
    loss: Floats,
    floor: float,
    per_decade: float,
    most_terms: int | None,
) -> PronyFit:
    used = fit.terms > 0.0
    instantaneous = fit.relaxed + float(fit.terms.sum())
    return PronyFit(
        series=Prony(
            instantaneous_modulus=instantaneous,
            weights=fit.terms[used] / instantaneous,
            relaxation_times=fit.times[used],
        ),
        frequency=frequency,
        storage=storage,
        loss=loss,
        storage_error=fit.residual[: frequency.size],
        loss_error=fit.residual[frequency.size :],
        scatter=fit.scatter,
        _fit=fit,
        _floor=floor,
        _per_decade=per_decade,
        _most_terms=most_terms,
    )
