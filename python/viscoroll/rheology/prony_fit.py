"""Prony series fitted to measured moduli."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol, overload

import numpy as np

from .._support.arguments import Floats, as_float, as_float_array, as_int
from .._support.extras import extra
from .._support.text import shown
from ..materials import Prony
from .series import MARGIN, SeriesFit, basis, fit_series, fit_sparse, nonnegative, time_grid

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

__all__ = ["MeasuredModulus", "PronyFit", "fit_prony"]

#: Least relaxed modulus, relative to the lowest storage modulus measured.
_FLOOR = 1e-2

#: Places of the grid of times that are tried, of which the best is kept: a material of few sharp terms shows them.
_PLACES = 8


class MeasuredModulus(Protocol):
    """What has been measured: angular frequency [rad/s] and shear moduli [Pa], as long as one another."""

    @property
    def frequency(self) -> ArrayLike:
        """Angular frequency [rad/s]."""

    @property
    def storage(self) -> ArrayLike:
        """Storage modulus [Pa]."""

    @property
    def loss(self) -> ArrayLike:
        """Loss modulus [Pa]."""


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class PronyFit:
    """A Prony series with nonnegative weights, and how well it fits.

    Attributes
    ----------
    series : Prony
        The material.
    frequency : ndarray
        Angular frequencies of the data [rad/s], increasing.
    storage, loss : ndarray
        The data [Pa].
    storage_error, loss_error : ndarray
        Fit over data less 1, at each point [-].
    scatter : float
        Root mean square of both for each degree of freedom [-]: the noise of data that a passive material can have.
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

    @property
    def relaxed_modulus(self) -> float:
        """Modulus at rest [Pa]."""
        return self._fit.relaxed

    @property
    def storage_rms(self) -> float:
        """Root mean square of the relative error of the storage modulus [-]."""
        return float(np.sqrt(np.mean(self.storage_error**2)))

    @property
    def loss_rms(self) -> float:
        """Root mean square of the relative error of the loss modulus [-]."""
        return float(np.sqrt(np.mean(self.loss_error**2)))

    def confidence_band(
        self, angular_frequency: ArrayLike, *, confidence: float = 0.95, trials: int = 300, seed: int = 0
    ) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Return bounds of μ*(ω), point by point, by parametric bootstrap.

        Noise of the size of `scatter` is put on the fit, independently at every point, and fitted again with the same
        times. The intervals hold what such fits scatter by; they know nothing of errors that points have in common.

        Parameters
        ----------
        angular_frequency : array_like
            ω [rad/s], > 0, one-dimensional.
        confidence : float, default 0.95
            Probability that an interval holds the true value [-].
        trials : int, default 300
            Fits to noise, ≥ 20.
        seed : int, default 0
            Of the noise.

        Returns
        -------
        lower, upper : ndarray of complex
            Bounds of storage (real part) and loss (imaginary part) [Pa].
        """
        omega = np.atleast_1d(as_float_array("angular_frequency", angular_frequency))
        if as_int("trials", trials) < 20:
            raise ValueError(f"trials must be >= 20, got {trials}")
        if not 0.0 < as_float("confidence", confidence) < 1.0:
            raise ValueError(f"confidence must be in (0, 1), got {confidence!r}")
        with extra("studies"):
            from scipy.stats import norm

        samples = self._resampled(trials, np.random.default_rng(seed))
        values = basis(omega, self._fit.times) @ samples
        width = float(norm.ppf(0.5 + 0.5 * confidence)) * values.std(axis=1, ddof=1)
        middle = self._fit.modulus(omega)
        half = width[: omega.size] + 1j * width[omega.size :]
        return middle - half, middle + half

    def _resampled(self, trials: int, generator: np.random.Generator) -> Floats:
        """Return relaxed moduli and terms [Pa] of fits to noisy copies of this fit, one to a column."""
        fitted = self._fit.modulus(self.frequency)
        expected = np.concatenate([fitted.real, fitted.imag])
        # Relative to the fit rather than to each noisy copy: one matrix for all, and no bias to low points.
        matrix = basis(self.frequency, self._fit.times) / expected[:, None]
        noise = self.scatter * generator.standard_normal((expected.size, trials))
        size = np.linalg.norm(matrix, axis=0)
        right = 1.0 + noise - self._floor * matrix[:, :1]
        found = nonnegative(matrix / size, right) / size[:, None]
        found[0] += self._floor
        return np.asarray(found)

    def sparse(self, terms: int) -> PronyFit:
        """Return a fit with few terms, for programs that cannot take many: their times are fitted, too.

        Its errors are larger, and `confidence_band` knows nothing of that: use the full series here.

        Parameters
        ----------
        terms : int
            The most terms, ≥ 1.

        Returns
        -------
        PronyFit
            With so many terms, or fewer.

        Raises
        ------
        ValueError
            For less than one term.
        """
        if as_int("terms", terms) < 1:
            raise ValueError(f"terms must be >= 1, got {terms}")
        fit = fit_sparse(self._fit, self.frequency, self.storage, self.loss, terms=terms, floor=self._floor)
        return _result(fit, self.frequency, self.storage, self.loss, self._floor)

    @overload
    def plot(self) -> Figure: ...

    @overload
    def plot(self, ax: Axes) -> Axes: ...

    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw data, fit and residual (the extra `viscoroll[plot]`).

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw the moduli alone.

        Returns
        -------
        matplotlib.figure.Figure or matplotlib.axes.Axes
            A new figure, moduli above, relative error below; or `ax`.
        """
        from .picture import plot_fit

        data = (self.frequency, self.storage, self.loss)
        return plot_fit(data, self.series, errors=(self.storage_error, self.loss_error), ax=ax)

    def __repr__(self) -> str:
        """Return what was fitted, and how well."""
        decades = np.log10(self.frequency[-1] / self.frequency[0])
        return (
            f"PronyFit of {self.frequency.size} points over {decades:.3g} decades: {len(self.series.weights)} terms, "
            f"relaxed modulus {self._fit.relaxed:.4g} Pa, error of storage {self.storage_rms:.2%}, "
            f"of loss {self.loss_rms:.2%} (root mean square)"
        )


def fit_prony(curve: MeasuredModulus, *, terms_per_decade: float = 2.0, relaxed_floor: float | None = None) -> PronyFit:
    """Fit a Prony series to measured storage and loss.

    Nonnegative least squares on the relative errors of both moduli, with times at equal ratios that reach half a decade
    beyond the data: the best that any passive material can do, within the resolution of the times.

    Parameters
    ----------
    curve : MasterCurve, Superposition, Isotherm, or anything with `frequency`, `storage` and `loss`
        What to fit: [rad/s], [Pa], [Pa], all > 0; an entry at frequency 0 is left out.
    terms_per_decade : float, default 2
        Relaxation times to a decade [-], in [0.5, 10].
    relaxed_floor : float, optional
        Least relaxed modulus [Pa], > 0; by default a hundredth of the lowest storage modulus. Rolling has gone on for
        ever, and needs a material that bears a load at rest.

    Returns
    -------
    PronyFit
        Material, errors, intervals and a picture.

    Raises
    ------
    ValueError
        For fewer than three points, and values that are not positive.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.1)
    >>> omega = np.geomspace(0.1, 1000.0, 41)
    >>> modulus = rubber.complex_modulus(omega)
    >>> fit = vr.fit_prony(vr.MasterCurve(omega, modulus.real, modulus.imag))
    >>> bool(fit.storage_rms < 0.01)
    True
    """
    frequency, storage, loss = measured(curve)
    per_decade = as_float("terms_per_decade", terms_per_decade)
    if not 0.5 <= per_decade <= 10.0:
        raise ValueError(f"terms_per_decade must be in [0.5, 10], got {per_decade!r}")
    floor = _FLOOR * float(storage.min()) if relaxed_floor is None else as_float("relaxed_floor", relaxed_floor)
    if not 0.0 < floor < np.inf:
        raise ValueError(f"relaxed_floor must be > 0 Pa, got {floor!r}")
    times = time_grid(frequency, per_decade, margin=MARGIN)
    moved = (times * 10.0 ** (place / (_PLACES * per_decade)) for place in range(_PLACES))
    fit = min((fit_series(frequency, storage, loss, t, floor=floor) for t in moved), key=lambda fit: fit.scatter)
    return _result(fit, frequency, storage, loss, floor)


def _result(fit: SeriesFit, frequency: Floats, storage: Floats, loss: Floats, floor: float) -> PronyFit:
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
    )


def measured(curve: MeasuredModulus) -> tuple[Floats, Floats, Floats]:
    """Return frequency, storage and loss of measured moduli, by increasing frequency and without rest.

    Raises
    ------
    TypeError
        For something without these attributes.
    ValueError
        For columns of unlike length, fewer than three points, and values that are not positive.
    """
    try:
        columns = [as_float_array(name, getattr(curve, name)) for name in ("frequency", "storage", "loss")]
    except AttributeError:
        raise TypeError(f"curve must have frequency, storage and loss, got {shown(curve)}") from None
    frequency, storage, loss = columns
    if frequency.ndim != 1 or not frequency.shape == storage.shape == loss.shape:
        raise ValueError(f"curve must have columns of one length, got {[column.shape for column in columns]}")
    order = np.argsort(frequency, kind="stable")
    order = order[frequency[order] > 0.0]
    if order.size < 3:
        raise ValueError(f"curve must have at least 3 points above 0 rad/s, got {order.size}")
    for name, column in (("storage", storage), ("loss", loss)):
        if not (np.isfinite(column[order]).all() and (column[order] > 0.0).all()):
            raise ValueError(f"curve.{name} must be > 0 Pa at every point, got {column[order].min():g}")
    return frequency[order], storage[order], loss[order]
