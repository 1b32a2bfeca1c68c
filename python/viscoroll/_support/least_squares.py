"""Least-squares fits with confidence intervals."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._core import ConvergenceError
from .arguments import Floats
from .errors import InvalidInput
from .extras import extra
from .intervals import as_confidence, student_quantile

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["Fit", "Parameter", "fit_law", "with_intervals"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter:
    """Fitted parameter with its confidence interval.

    Attributes
    ----------
    value : float
        Best value, in `unit`.
    lower, upper : float
        Ends of the confidence interval, in `unit`.
    unit : str
        SI unit.
    """

    value: float
    lower: float
    upper: float
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class Fit:
    """Law with fitted parameters.

    Attributes
    ----------
    law : str
        Formula of the law.
    parameters : mapping of str to Parameter
        Parameters by name, in the order of `covariance`.
    covariance : ndarray
        Covariance matrix of the parameters.
    confidence : float
        Probability that an interval contains the true value [-], for errors that are independent, normal and of equal
        size.
    r_squared : float
        1 - (squared residuals) / (squared deviations from the mean) [-]; NaN if the torque does not vary.
    degrees_of_freedom : int
        Number of points minus number of parameters.
    """

    law: str
    parameters: Mapping[str, Parameter]
    covariance: Floats
    confidence: float
    r_squared: float
    degrees_of_freedom: int
    _model: Callable[..., Floats]

    def predict(self, x: ArrayLike) -> Floats:
        """Evaluate the law.

        Parameters
        ----------
        x : array_like
            Load [N], thickness [m] or coefficient of friction [-], of any shape.

        Returns
        -------
        ndarray
            Resisting torque [N m], of the same shape.
        """
        return np.asarray(self._model(np.asarray(x, dtype=np.float64), *self._values()))

    def confidence_band(self, x: ArrayLike) -> tuple[Floats, Floats]:
        """Return pointwise confidence bounds of the law, to first order in the parameters.

        Parameters
        ----------
        x : array_like
            Same as in `predict`.

        Returns
        -------
        lower, upper : ndarray
            Resisting torque [N m], of the same shape.
        """
        x = np.asarray(x, dtype=np.float64)
        values = self._values()
        steps = np.sqrt(np.diag(self.covariance)) * 1e-3 + np.abs(values) * 1e-7
        slopes = np.stack(
            [(self._model(x, *(values + s)) - self._model(x, *(values - s))) / (2.0 * s.sum()) for s in np.diag(steps)]
        )
        variance = np.einsum("i...,ij,j...->...", slopes, self.covariance, slopes)
        margin = student_quantile(self.confidence, self.degrees_of_freedom) * np.sqrt(np.maximum(variance, 0.0))
        torque = self.predict(x)
        return torque - margin, torque + margin

    def __repr__(self) -> str:
        """Return a text with the law, its parameters and their intervals."""
        rows = [
            f"  {name} = {p.value:.6g} {p.unit} in [{p.lower:.6g}, {p.upper:.6g}]"
            for name, p in self.parameters.items()
        ]
        return "\n".join([f"{self.law} ({self.confidence:.0%} confidence, r² = {self.r_squared:.6f})", *rows])

    def _values(self) -> Floats:
        return np.array([parameter.value for parameter in self.parameters.values()])


def fit_law(
    law: str,
    model: Callable[..., Floats],
    x: Floats,
    y: Floats,
    start: Floats,
    units: dict[str, str],
    confidence: float,
) -> Fit:
    """Fit ``model(x, *parameters)`` to `y`, starting from `start`; `units` has the names of the parameters.

    Raises
    ------
    ValueError
        For a confidence out of range, or if the data do not determine the parameters.
    ConvergenceError
        If the iteration does not converge.
    """
    with extra("studies"):
        from scipy.optimize import least_squares

    confidence = as_confidence(confidence)
    scale = np.where(start == 0.0, 1.0, np.abs(start))
    size = float(np.abs(y).max())

    def residuals(p: Floats) -> Floats:
        with np.errstate(over="ignore", invalid="ignore"):
            return np.nan_to_num((model(x, *(p * scale)) - y) / size, nan=1e9, posinf=1e9, neginf=-1e9)

    found = least_squares(residuals, start / scale, xtol=1e-14, ftol=1e-14, gtol=1e-14, x_scale="jac", max_nfev=2000)
    if not found.success:
        raise ConvergenceError(f"the fit of {law} did not converge in 2000 evaluations: residual {found.cost:.3g}")
    freedom = len(x) - len(start)
    singular = np.linalg.svd(found.jac, compute_uv=False)
    if not singular[-1] > 1e-10 * singular[0]:
        raise InvalidInput(
            "torque", f"must determine all parameters of {law}", "data that many values fit equally well"
        )
    covariance = np.linalg.inv(found.jac.T @ found.jac) * (2.0 * found.cost / freedom)
    values, covariance = found.x * scale, covariance * np.outer(scale, scale)
    spread = float(np.sum((y - y.mean()) ** 2))
    return Fit(
        law=law,
        parameters=with_intervals(units, values, covariance, confidence, freedom),
        covariance=covariance,
        confidence=confidence,
        r_squared=1.0 - 2.0 * found.cost * size**2 / spread if spread > 0.0 else math.nan,
        degrees_of_freedom=freedom,
        _model=model,
    )


def with_intervals(
    units: Mapping[str, str], values: Floats, covariance: Floats, confidence: float, degrees_of_freedom: int
) -> dict[str, Parameter]:
    """Return the parameters, named by `units`, with intervals from Student's quantiles."""
    margins = student_quantile(confidence, degrees_of_freedom) * np.sqrt(np.diag(covariance))
    return {
        name: Parameter(value=float(v), lower=float(v - m), upper=float(v + m), unit=unit)
        for (name, unit), v, m in zip(units.items(), values, margins, strict=True)
    }
