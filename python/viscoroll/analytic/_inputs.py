"""Input checks of the closed forms: shape, type and range, with the messages of the core."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import as_float, as_float_array
from ..materials.moduli import ShearModulusLike, to_core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Floats",
    "complex_modulus",
    "fraction",
    "one_volume",
    "plain",
    "poisson",
    "positives",
]

#: Float if all arguments are numbers, otherwise an array of their common shape.
Floats: TypeAlias = "float | NDArray[np.float64]"


def positives(name: str, values: ArrayLike, unit: str) -> NDArray[np.float64]:
    """Return positive numbers as an array of any shape; otherwise raise a TypeError or ValueError."""
    array = as_float_array(name, values)
    bad = array[~(np.isfinite(array) & (array > 0.0))]
    if bad.size:
        raise ValueError(f"{name} must be > 0 {unit}, got {bad[0]:g}")
    return array


def fraction(name: str, value: object) -> float:
    """Return a number in [0, 1]."""
    number = as_float(name, value)
    if not 0.0 <= number <= 1.0:
        raise ValueError(f"{name} must be in [0, 1], got {number:g}")
    return number


def poisson(value: object, *, compressible: bool = False) -> float:
    """Return a Poisson's ratio in (-1, 0.5], or in (-1, 0.5) for a `compressible` material."""
    number = as_float("poisson_ratio", value)
    if not (-1.0 < number < 0.5 or (number == 0.5 and not compressible)):
        raise ValueError(f"poisson_ratio must be in (-1, 0.5{')' if compressible else ']'}, got {number:g}")
    return number


def one_volume(poisson_ratio: float | None, bulk_modulus: float | None) -> None:
    """Raise a ValueError unless exactly one of Poisson's ratio and bulk modulus is given."""
    if (poisson_ratio is None) == (bulk_modulus is None):
        given = "none" if poisson_ratio is None else "both"
        raise ValueError(f"poisson_ratio or bulk_modulus must be given, and not both, got {given}")


def complex_modulus(modulus: ShearModulusLike, angular_frequency: ArrayLike) -> NDArray[np.complex128]:
    """Return any accepted modulus [Pa] at frequencies ω [rad/s] of any shape, with the checks of the core."""
    omega = as_float_array("angular_frequency", angular_frequency)
    return _core.complex_modulus(to_core(modulus), omega.ravel()).reshape(omega.shape)


def plain(values: ArrayLike) -> Floats:
    """Return a single value as a float, and any other array unchanged."""
    array = np.asarray(values, dtype=np.float64)
    return float(array) if array.ndim == 0 else array
