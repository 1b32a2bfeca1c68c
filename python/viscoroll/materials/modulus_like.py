"""Moduli as users may pass them: a modulus of this package, a number or a function of frequency."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from numbers import Complex
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import as_float
from .._support.errors import InvalidInput, InvalidType
from .._support.text import shown
from .moduli import Elastic, MasterCurve, StandardLinearSolid
from .shear_modulus import Relaxation, ShearModulus

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = [
    "ShearModulusLike",
    "as_modulus",
    "measured_range_of",
    "relaxation_of",
    "standard_linear_solid_of",
    "to_core",
]

#: Types accepted as a shear modulus [Pa]: a modulus of this package; a number, for an elastic material; or a function
#: of an array of angular frequencies ω [rad/s] that returns μ*(ω) as an array, or as one number for all frequencies.
ShearModulusLike: TypeAlias = ShearModulus | Callable[[Any], Any] | float


def to_core(modulus: ShearModulusLike) -> _core.ShearModulus:
    """Convert any accepted modulus to the corresponding modulus of the C++ core.

    Raises
    ------
    TypeError
        If `modulus` is neither a modulus of this package, nor callable, nor a number.
    """
    accepted = as_modulus(modulus)
    return accepted._to_core() if isinstance(accepted, ShearModulus) else _core.custom_modulus(_checked(accepted))


def relaxation_of(modulus: ShearModulusLike) -> Relaxation | None:
    """Return the relaxation function of a modulus, or None if it is not a sum of exponentials."""
    return modulus._relaxation() if isinstance(modulus, ShearModulus) else None


def standard_linear_solid_of(modulus: ShearModulusLike) -> StandardLinearSolid | None:
    """Return the standard linear solid that equals a modulus, or None if there is none."""
    solid: StandardLinearSolid | None = modulus._standard_linear_solid() if isinstance(modulus, ShearModulus) else None
    return solid


def measured_range_of(moduli: Iterable[ShearModulusLike], *, held: bool = False) -> tuple[float, float] | None:
    """Return the frequency range common to all tables of measured moduli [rad/s], or None without such tables.

    Parameters
    ----------
    moduli : iterable of ShearModulus or callable
        Moduli; those that are not tables have no effect.
    held : bool, default False
        Whether to include only tables whose end values are held outside their range.
    """
    tables = [modulus for modulus in moduli if isinstance(modulus, MasterCurve)]
    if held:
        tables = [table for table in tables if table.extrapolation is _core.Extrapolation.HOLD]
    ends = [[w for w in table.frequency if w > 0.0] for table in tables]
    return (max(e[0] for e in ends), min(e[-1] for e in ends)) if ends else None


def as_modulus(modulus: ShearModulusLike) -> ShearModulus | Callable[[Any], Any]:
    """Return a modulus or function unchanged, and a number as an elastic modulus [Pa]."""
    if isinstance(modulus, ShearModulus) or callable(modulus):
        return modulus
    try:
        number = as_float("shear_modulus", modulus)
    except TypeError:
        raise InvalidType(
            "shear_modulus",
            "must be a modulus of viscoroll, a number or a function of frequency",
            f"{shown(modulus)}{_hint_for_a_modulus(modulus)}",
        ) from None
    return Elastic(modulus=number)


def _hint_for_a_modulus(rejected: object) -> str:
    """Return a hint on how to obtain a modulus from the rejected argument, if that is measured data or a fit."""
    hints = {
        "at": "its at(temperature=...)",
        "series": "its series",
        "isotherms": "superpose(...).at(temperature=...) of the data",
        "storage": "fit_prony(...).series of the curve",
        "best_estimate": "its best_estimate, or pass all draws to sweep",
        "value": "its value",
    }
    return next((f"; give {hint}" for name, hint in hints.items() if hasattr(rejected, name)), "")


def _checked(function: Callable[[Any], Any]) -> Callable[[Any], NDArray[Any]]:
    """Wrap a user's function with a check that it returns numbers. The core checks shape and values."""

    def modulus(omega: NDArray[np.float64]) -> NDArray[Any]:
        values = _as_numeric_array(function(omega))
        if values.dtype.kind not in "fciu":
            raise InvalidType("shear_modulus", "must be a function that returns numbers", f"{values.dtype} entries")
        return np.full(omega.shape, values) if values.ndim == 0 else values

    return modulus


def _as_numeric_array(values: Any) -> NDArray[Any]:
    try:
        array = np.asarray(values)
        if array.dtype.kind == "O" and all(isinstance(value, Complex) for value in array.flat):
            array = array.astype(np.complex128)
    except (ValueError, OverflowError) as error:
        raise InvalidInput("shear_modulus", f"must be a function that returns an array of numbers ({error})") from None
    return array
