"""Least-squares fits of laws to the resisting torque, with confidence intervals."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import Floats, as_positive
from .._support.errors import InvalidInput, Range
from .._support.least_squares import Fit, Parameter, fit_law

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = ["fit_friction_law", "fit_power_law", "fit_thickness_law"]

#: Smallest ratio c_o / (ε c_i) of the two friction scales of the law, which assumes a thin boundary layer.
_LEAST_RATIO = 1.5


def fit_power_law(load: ArrayLike, torque: ArrayLike, *, confidence: float = 0.95) -> Fit:
    """Fit T = a P^b to the resisting torque as a function of load.

    Parameters
    ----------
    load : array_like
        Loads P [N], > 0; at least three different values.
    torque : array_like
        Resisting torques T_r [N m], > 0, of the same shape. NaN (a failed point) is left out.
    confidence : float, default 0.95
        Confidence level of the intervals [-], in (0, 1).

    Returns
    -------
    Fit
        Parameters a [N^(1-b) m] and b [-].

    Raises
    ------
    ValueError
        For values out of range, too few points, and data that do not determine the parameters.
    ConvergenceError
        If the least-squares iteration does not converge.

    References
    ----------
    Section 14.4 and table 3 of G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic
    coatings".

    Examples
    --------
    >>> import numpy as np
    >>> load = np.array([10.0, 20.0, 50.0, 100.0])
    >>> fit = fit_power_law(load, 5e-5 * load**1.4)
    >>> round(fit.parameters["b"].value, 6)
    1.4
    """
    x, y = _checked_points("load", "N", load, torque, parameters=2)
    slope, intercept = np.polyfit(np.log(x), np.log(y), 1)
    units = {"a": "N^(1-b) m", "b": "1"}
    return fit_law("T = a P^b", _power, x, y, np.array([math.exp(intercept), slope]), units, confidence)


def fit_thickness_law(thickness: ArrayLike, torque: ArrayLike, *, confidence: float = 0.95) -> Fit:
    """Fit T = a tanh(b h^c) to the resisting torque as a function of the thickness of the coating.

    Parameters
    ----------
    thickness : array_like
        Thicknesses h [m], > 0; at least four different values.
    torque : array_like
        Resisting torques T_r [N m], > 0, of the same shape. NaN (a failed point) is left out.
    confidence : float, default 0.95
        Confidence level of the intervals [-], in (0, 1).

    Returns
    -------
    Fit
        Parameters a [N m], b [m^-c] and c [-].

    Raises
    ------
    ValueError, ConvergenceError
        Same as in `fit_power_law`.

    References
    ----------
    Section 14.5 and table 4 of G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic
    coatings".

    Examples
    --------
    >>> import numpy as np
    >>> thickness = np.linspace(1e-3, 10e-3, 8)
    >>> fit = fit_thickness_law(thickness, 0.06 * np.tanh(60.0 * thickness**0.83))
    >>> round(fit.parameters["c"].value, 6)
    0.83
    """
    x, y = _checked_points("thickness", "m", thickness, torque, parameters=3)
    # For a given a, artanh(T / a) = b h^c is a power law, a straight line in logarithms.
    starts = []
    for a in y.max() * (1.0 + np.geomspace(1e-3, 10.0, 24)):
        c, log_b = np.polyfit(np.log(x), np.log(np.arctanh(y / a)), 1)
        starts.append(np.array([a, math.exp(log_b), c]))
    start = min(starts, key=lambda p: float(np.sum((_saturating(x, *p) - y) ** 2)))
    return fit_law("T = a tanh(b h^c)", _saturating, x, y, start, {"a": "N m", "b": "m^-c", "c": "1"}, confidence)


def fit_friction_law(
    friction: ArrayLike,
    torque: ArrayLike,
    *,
    frictionless_torque: float | None = None,
    boundary_layer_width: float = 0.1,
    confidence: float = 0.95,
) -> Fit:
    """Fit the paper's matched exponentials (60)-(63) to the resisting torque as a function of friction.

    The law is T = a_i (1 + b_i (1 - exp(-μ/(ε c_i)))) + a_o (1 + b_o exp(-μ/c_o)) - δ with
    δ = a_i (1 + b_i) = a_o (1 + b_o). The torque without friction, a_i = T(μ = 0), is given; ε is the width of the
    boundary layer at small friction.

    Parameters
    ----------
    friction : array_like
        Coefficients of friction μ [-], ≥ 0; at least five different values above 0.
    torque : array_like
        Resisting torques T_r [N m], > 0, of the same shape. NaN (a failed point) is left out.
    frictionless_torque : float, optional
        Torque a_i [N m], > 0. By default, the mean of `torque` at μ = 0; the points must then contain μ = 0.
    boundary_layer_width : float, default 0.1
        Width ε [-], > 0. Only c_i depends on this choice.
    confidence : float, default 0.95
        Confidence level of the intervals [-], in (0, 1). The intervals treat a_i as exact.

    Returns
    -------
    Fit
        Parameters a_o [N m], b_o [-], c_o [-] and c_i [-]. The scale c_o is at least 1.5 ε c_i: if the data give a
        smaller ratio, the fit sets c_o = 1.5 ε c_i, and `law` states this.

    Raises
    ------
    ValueError, ConvergenceError
        Same as in `fit_power_law`.

    References
    ----------
    Section 14.3 of G.-P. Zéhil and H. P. Gavin, "Rolling resistance of a rigid sphere with viscoelastic coatings".

    Examples
    --------
    >>> import numpy as np
    >>> friction = np.array([0.0, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.2, 2.0])
    >>> torque = 0.010 + 0.001 * np.exp(-friction / 0.5) - 0.0005 * np.exp(-friction / 0.03)
    >>> fit = fit_friction_law(friction, torque)
    >>> round(fit.parameters["c_i"].value, 6)
    0.3
    """
    boundary_layer_width = as_positive("boundary_layer_width", boundary_layer_width)
    x, y = _checked_points("friction", "", friction, torque, parameters=0, zero=True)
    if frictionless_torque is None:
        if not (x == 0.0).any():
            raise InvalidInput("frictionless_torque", "must be given if friction contains no 0", "None")
        frictionless_torque = float(y[x == 0.0].mean())
    frictionless_torque = as_positive("frictionless_torque", frictionless_torque, "N m")
    # At μ = 0 the law equals a_i whatever the parameters are, so points at μ = 0 do not help to determine them.
    x, y = _checked_points("friction", "", x[x > 0.0], y[x > 0.0], parameters=4)
    law = f"matched exponentials (60)-(63), a_i = {frictionless_torque:.6g} N m, ε = {boundary_layer_width:g}"
    model = _FrictionLaw(frictionless_torque=frictionless_torque, width=boundary_layer_width)
    start = model.start(x, y)
    units = {"a_o": "N m", "b_o": "1", "c_o": "1", "c_i": "1"}
    try:
        fit = fit_law(law, model, x, y, start, units, confidence)
        if fit.parameters["c_o"].value >= _LEAST_RATIO * boundary_layer_width * fit.parameters["c_i"].value:
            return fit
    except ValueError:  # the data do not distinguish the two scales
        pass
    return _fit_with_least_ratio(model, x, y, start, law, confidence)


def _fit_with_least_ratio(model: _FrictionLaw, x: Floats, y: Floats, start: Floats, law: str, confidence: float) -> Fit:
    """Fit with c_o = 1.5 ε c_i. It serves data for which a free c_o would approach ε c_i, so that b_o would diverge."""
    ratio = _LEAST_RATIO * model.width

    def constrained(x: Floats, a_o: float, b_o: float, c_i: float) -> Floats:
        return model(x, a_o, b_o, ratio * c_i, c_i)

    units = {"a_o": "N m", "b_o": "1", "c_i": "1"}
    fit = fit_law(f"{law}, c_o = {_LEAST_RATIO:g} ε c_i", constrained, x, y, start[[0, 1, 3]], units, confidence)
    inner = fit.parameters["c_i"]
    outer = Parameter(value=ratio * inner.value, lower=ratio * inner.lower, upper=ratio * inner.upper, unit="1")
    # Jacobian of the four parameters of the law with respect to the three free ones.
    jacobian = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, ratio], [0.0, 0.0, 1.0]])
    parameters = {"a_o": fit.parameters["a_o"], "b_o": fit.parameters["b_o"], "c_o": outer, "c_i": inner}
    covariance = jacobian @ fit.covariance @ jacobian.T
    return replace(fit, parameters=parameters, covariance=covariance, _model=model)


def _power(x: Floats, a: float, b: float) -> Floats:
    return np.asarray(a * x**b)


def _saturating(x: Floats, a: float, b: float, c: float) -> Floats:
    return np.asarray(a * np.tanh(b * x**c))


@dataclass(frozen=True, slots=True, kw_only=True)
class _FrictionLaw:
    """Equation (63) with b_i eliminated by (62)."""

    frictionless_torque: float
    width: float

    def __call__(self, x: Floats, a_o: float, b_o: float, c_o: float, c_i: float) -> Floats:
        rise = a_o * (1.0 + b_o) - self.frictionless_torque  # a_i b_i
        return np.asarray(a_o + a_o * b_o * np.exp(-x / c_o) - rise * np.exp(-x / (self.width * c_i)))

    def start(self, x: Floats, y: Floats) -> Floats:
        """Return the best start values on a grid of c_o and c_i, with a_o and a_o b_o from linear least squares."""
        best, start = math.inf, np.ones(4)
        for inner in np.geomspace(0.3 * x.min(), 0.5 * x.max(), 16):
            for outer in np.geomspace(2.0 * inner, 5.0 * x.max(), 16):
                decay = np.exp(-x / inner)
                columns = np.stack([1.0 - decay, np.exp(-x / outer) - decay], axis=1)
                (a, ab), *_ = np.linalg.lstsq(columns, y - self.frictionless_torque * decay, rcond=None)
                error = float(np.sum((columns @ [a, ab] + self.frictionless_torque * decay - y) ** 2))
                if error < best and a > 0.0:
                    best, start = error, np.array([a, ab / a, outer, inner / self.width])
        return start


def _checked_points(
    name: str, unit: str, x: ArrayLike, torque: ArrayLike, *, parameters: int, zero: bool = False
) -> tuple[Floats, Floats]:
    """Check the points, and return them without the failed ones, whose torque is NaN."""
    first, second = np.asarray(x, dtype=np.float64).ravel(), np.asarray(torque, dtype=np.float64).ravel()
    if np.shape(x) != np.shape(torque):
        raise InvalidInput("torque", f"must have the shape of {name}, {np.shape(x)}", np.shape(torque))
    kept = ~np.isnan(second)
    first, second = first[kept], second[kept]
    good = np.isfinite(first) & ((first >= 0.0) if zero else (first > 0.0))
    if not good.all():
        raise Range(0.0, unit=unit, excludes_minimum=not zero).error(name, f"{first[~good][0]:g}")
    if not (np.isfinite(second) & (second > 0.0)).all():
        wrong = second[~(second > 0.0) | np.isinf(second)][0]
        raise Range(0.0, unit="N m", excludes_minimum=True).error("torque", f"{wrong:g}")
    if (count := len(np.unique(first))) <= parameters:
        raise InvalidInput(
            name, f"must have more than {parameters} different values to determine the parameters", f"{count}"
        )
    return first, second
