"""Shape and type of arguments, settled once before they reach the core, which checks their values."""

from __future__ import annotations

import operator
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["as_float", "as_floats", "as_int", "as_orders", "require_type"]


def require_type(name: str, value: object, wanted: type) -> None:
    """Refuse a value of another type than a class of this package.

    Raises
    ------
    TypeError
        Naming the parameter and the class.
    """
    if not isinstance(value, wanted):
        raise TypeError(f"{name} must be a viscoroll.{wanted.__name__}, got {value!r}")


def as_float(name: str, value: object) -> float:
    """Return a real number as a float.

    Raises
    ------
    TypeError
        Where `value` is not a real number: a string, a complex number, an array of several, None.
    """
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{name} must be a real number, got {_described(value)}")
    return float(value)


def as_int(name: str, value: object) -> int:
    """Return a whole number as an int.

    Raises
    ------
    TypeError
        Where `value` is not an integer.
    ValueError
        Where it does not fit into 32 bits.
    """
    try:
        if isinstance(value, bool):
            raise TypeError
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise TypeError(f"{name} must be a whole number, got {_described(value)}") from None
    if abs(number) > 2**31 - 1:
        raise ValueError(f"{name} must fit into 32 bits, got {number}")
    return number


def as_floats(name: str, values: ArrayLike) -> tuple[float, ...]:
    """Return a one-dimensional sequence of real numbers as a tuple of floats.

    Raises
    ------
    TypeError
        Where an entry is not a real number.
    ValueError
        Where `values` is not one-dimensional.
    """
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(f"{name} must be one-dimensional, got rows of different lengths") from None
    if array.ndim != 1:
        raise ValueError(f"{name} must be one-dimensional, got shape {array.shape}")
    if array.size and array.dtype.kind not in "fiu":
        raise TypeError(f"{name} must hold real numbers, got {array.dtype} entries")
    return tuple(float(value) for value in array)


def as_orders(name: str, values: ArrayLike) -> NDArray[np.int32]:
    """Return whole numbers of any shape as 32-bit integers.

    Raises
    ------
    TypeError
        Where the entries are not integers.
    ValueError
        Where an entry is above 1e6 in size, beyond any order of use.
    """
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must hold whole numbers, got {array.dtype} entries")
    if array.size and max(-int(array.min()), int(array.max())) > 10**6:
        raise ValueError(f"{name} must be in [-1e6, 1e6], got {array.min()} to {array.max()}")
    return array.astype(np.int32)


def _described(value: Any) -> str:
    return f"{type(value).__name__} {value!r}" if not isinstance(value, np.ndarray) else f"array of shape {value.shape}"
