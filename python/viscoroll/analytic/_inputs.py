"""Input checks of the closed-form solutions. The messages are worded like those of the C++ core."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import as_float_array, as_float_in, as_poisson_ratio
from .._support.errors import Range
from ..materials.modulus_like import ShearModulusLike, to_core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Floats",
    "complex_modulus",
    "float_if_scalar",
    "fraction",
    "poisson",
    "positives",
    "require_one_volumetric_constant",
]

#: Return type: a float if all arguments are numbers, otherwise an array of their broadcast shape.
Floats: TypeAlias = "float | NDArray[np.float64]"


def positives(name: str, values: ArrayLike, unit: str) -> NDArray[np.float64]:
    """Convert numbers to an array of the same shape; raise a ValueError unless all are positive and finite."""
    array = as_float_array(name, values)
    bad = array[~(np.isfinite(array) & (array > 0.0))]
    if bad.size:
        raise Range(0.0, unit=unit, excludes_minimum=True).error(name, f"{bad[0]:g}")
    return array


def fraction(name: str, value: object) -> float:
    """Convert a number to a float; raise a ValueError unless it is in [0, 1]."""
    return as_float_in(Range(0.0, 1.0), name, value)


def poisson(value: object, *, compressible: bool = False) -> float:
    """Convert Poisson's ratio to a float in (-1, 0.5]; if the material must be `compressible`, in (-1, 0.5)."""
    return as_poisson_ratio("poisson_ratio", value, compressible=compressible)


def require_one_volumetric_constant(poisson_ratio: float | None, bulk_modulus: float | None) -> None:
    """Raise a ValueError unless exactly one of Poisson's ratio and bulk modulus is given."""
    if (poisson_ratio is None) == (bulk_modulus is None):
        given = "none" if poisson_ratio is None else "both"
        raise ValueError(f"poisson_ratio or bulk_modulus must be given, and not both, got {given}")


def complex_modulus(modulus: ShearModulusLike, angular_frequency: ArrayLike) -> NDArray[np.complex128]:
    """Evaluate a shear modulus [Pa] of any accepted type at frequencies ω [rad/s]; the C++ core checks both."""
    omega = as_float_array("angular_frequency", angular_frequency)
    return _core.complex_modulus(to_core(modulus), omega.ravel()).reshape(omega.shape)


def float_if_scalar(values: ArrayLike) -> Floats:
    """Return an array of dimension 0 as a float, and any other array unchanged."""
    array = np.asarray(values, dtype=np.float64)
    return float(array) if array.ndim == 0 else array
