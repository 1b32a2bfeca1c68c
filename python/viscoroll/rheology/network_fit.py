"""Fit of a network law to a strain sweep of filled rubber, with confidence intervals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from .._core import ConvergenceError
from .._support.arguments import Floats, require_type
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.intervals import as_confidence
from .._support.least_squares import Parameter, with_intervals
from .._support.plotting import plots
from .._support.text import shown
from ..materials import KrausNetwork, MasingNetwork, StrainSweep

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["NetworkFit", "fit_network"]

#: Parameters of each law and their units; followed by the moduli of the matrix at the frequency of the sweep.
_UNITS = {
    "kraus": {"storage": "Pa", "loss": "Pa", "critical_strain": "1", "exponent": "1"},
    "masing": {"storage": "Pa", "critical_strain": "1"},
}
_BESIDE = {"matrix_storage": "Pa", "matrix_loss": "Pa"}

#: Start value of Kraus's exponent, typical of carbon black.
_EXPONENT = 0.6


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class NetworkFit:
    """Fitted network law with its parameters and errors.

    Attributes
    ----------
    network : KrausNetwork or MasingNetwork
        Fitted law.
    parameters : mapping of str to Parameter
        Parameters of the law with intervals, and the moduli of the matrix at the frequency of the sweep,
        `matrix_storage` and `matrix_loss` [Pa].
    sweep : StrainSweep
        Measured data.
    storage_error, loss_error : ndarray
        Fit / data - 1 at each point [-].
    """

    network: KrausNetwork | MasingNetwork
    parameters: Mapping[str, Parameter]
    sweep: StrainSweep
    storage_error: Floats
    loss_error: Floats

    @plots("the moduli")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Plot data and fit."""
        from .picture import plot_strain_sweep

        strain = self.sweep.amplitudes
        fine = np.geomspace(strain[0], strain[-1], 200)
        storage, loss = self.network.at(fine)
        beside = self.parameters["matrix_storage"].value, self.parameters["matrix_loss"].value
        measured = strain, np.asarray(self.sweep.storage), np.asarray(self.sweep.loss)
        return plot_strain_sweep(measured, (fine, storage + beside[0], loss + beside[1]), ax=ax)

    def __repr__(self) -> str:
        """Return law, errors and parameters with intervals."""
        rms = [float(np.sqrt(np.mean(error**2))) for error in (self.storage_error, self.loss_error)]
        rows = [
            f"  {name} = {p.value:.4g} {p.unit} in [{p.lower:.4g}, {p.upper:.4g}]"
            for name, p in self.parameters.items()
        ]
        head = f"{type(self.network).__name__}, error of storage {rms[0]:.2%}, of loss {rms[1]:.2%} (root mean square)"
        return "\n".join([head, *rows])


def fit_network(
    sweep: StrainSweep, *, law: Literal["kraus", "masing"] = "kraus", confidence: float = 0.95
) -> NetworkFit:
    """Fit a network law to a strain sweep, with the moduli of the matrix at the frequency of the sweep as unknowns.

    The fit minimizes the squares of the relative errors of both moduli.

    Parameters
    ----------
    sweep : StrainSweep
        Measured sweep. The fit ignores its matrix.
    law : {"kraus", "masing"}, default "kraus"
        Law with four or with two parameters.
    confidence : float, default 0.95
        Confidence level of the intervals [-], in (0, 1), for independent and normally distributed errors.

    Returns
    -------
    NetworkFit
        Law, parameters with intervals, and errors.

    Raises
    ------
    ValueError
        If the law is unknown, or the sweep has too few points or does not determine the parameters.
    ConvergenceError
        If the iteration does not converge.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> strain = np.geomspace(1e-3, 0.3, 12)
    >>> storage, loss = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01).at(strain)
    >>> sweep = vr.materials.StrainSweep(strain=strain, storage=storage + 3e6, loss=loss + 2e5)
    >>> fit = vr.rheology.fit_network(sweep, law="masing")
    >>> print(f"{fit.network.storage:.3g} Pa, {fit.network.critical_strain:.3g}")
    6e+06 Pa, 0.01
    """
    with extra("studies"):
        from scipy.optimize import least_squares

    require_type("sweep", sweep, StrainSweep)
    if law not in _UNITS:
        raise InvalidInput("law", "must be 'kraus' or 'masing'", shown(law))
    confidence = as_confidence(confidence)
    strain, data = sweep.amplitudes, np.array([sweep.storage, sweep.loss])
    start = np.log(_start(law, strain, data))
    freedom = data.size - len(start)
    if freedom < 1:
        raise InvalidInput("sweep", f"must have more than {len(start) / 2:g} points for {len(start)} parameters")

    def errors(logs: Floats) -> Floats:
        values = np.exp(logs)
        fitted = np.array(_network(law, values).at(strain)) + values[-2:, None]
        return np.asarray((fitted / data - 1.0).ravel())

    bounds = np.full(len(start), np.inf)
    if law == "kraus":
        bounds[3] = 0.0  # exponents up to 1
    found = least_squares(errors, start, bounds=(-np.inf, bounds), x_scale="jac", xtol=1e-13, ftol=1e-13, gtol=1e-13)
    if not found.success:
        raise ConvergenceError(f"the fit of {law} did not converge: residual {found.cost:.3g}")
    singular = np.linalg.svd(found.jac, compute_uv=False)
    if not singular[-1] > 1e-10 * singular[0]:
        raise InvalidInput("sweep", f"must determine all parameters of {law}", "data that many values fit equally well")
    values = np.exp(found.x)
    covariance = np.linalg.inv(found.jac.T @ found.jac) * (2.0 * found.cost / freedom) * np.outer(values, values)
    storage_error, loss_error = found.fun.reshape(2, -1)
    return NetworkFit(
        network=_network(law, values),
        parameters=with_intervals(_UNITS[law] | _BESIDE, values, covariance, confidence, freedom),
        sweep=sweep,
        storage_error=storage_error,
        loss_error=loss_error,
    )


def _network(law: str, values: Floats) -> KrausNetwork | MasingNetwork:
    given = dict(zip(_UNITS[law], values.tolist(), strict=False))
    return KrausNetwork(**given) if law == "kraus" else MasingNetwork(**given)


def _start(law: str, strain: Floats, data: Floats) -> Floats:
    """Return start values: changes of the moduli over the sweep, strain of the largest loss, moduli of the matrix."""
    storage, loss = data
    fall = max(storage[0] - storage[-1], 0.1 * storage[0])
    rise = max(loss.max() - loss.min(), 0.1 * loss.max())
    beside = [max(storage[-1] - 0.1 * fall, 0.1 * storage[-1]), 0.9 * loss.min()]
    peak = strain[loss.argmax()]
    return np.array([fall, rise, peak, _EXPONENT, *beside] if law == "kraus" else [fall, peak, *beside])
