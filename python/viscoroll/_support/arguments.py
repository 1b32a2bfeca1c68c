"""Checks and conversions of the shape and type of arguments; the core checks their values."""

from __future__ import annotations

import operator
import sys
from collections.abc import Callable, Sequence
from enum import Enum
from math import inf
from numbers import Real
from types import UnionType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

from .errors import InvalidInput, InvalidType, Range
from .text import shown

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Member = TypeVar("Member", bound=Enum)

#: Array of real numbers, of any shape.
Floats: TypeAlias = NDArray[np.float64]

__all__ = [
    "Floats",
    "as_count",
    "as_float",
    "as_float_array",
    "as_float_in",
    "as_floats",
    "as_int",
    "as_kelvin",
    "as_member",
    "as_not_negative",
    "as_orders",
    "as_poisson_ratio",
    "as_positive",
    "kind_names",
    "require_callable",
    "require_type",
    "store_floats",
    "store_positive",
]


def require_type(name: str, value: object, kind: type | UnionType, *, optional: bool = False) -> None:
    """Raise a TypeError unless `value` is an instance of `kind`, or None if that is allowed (`optional`)."""
    if not (isinstance(value, kind) or (optional and value is None)):
        wanted = f"a {kind_names(kind)}{' or None' if optional else ''}"
        raise InvalidType(name, f"must be {wanted}", shown(value))


def kind_names(kind: type | UnionType) -> str:
    """Return the public name of a class of this package, or the names of several classes joined by "or"."""
    return " or ".join(map(_public_name, get_args(kind) or (kind,)))


def _public_name(kind: type) -> str:
    root = kind.__module__.split(".")[0]
    if root == "builtins":
        return kind.__name__
    if kind.__name__ in sys.modules[root].__all__:
        return f"{root}.{kind.__name__}"
    return f"{root}.{'enums' if issubclass(kind, Enum) else kind.__module__.split('.')[1]}.{kind.__name__}"


def as_member(name: str, value: Member | str, kind: type[Member]) -> Member:
    """Return a member of an enumeration, given as such or by its name in upper or lower case.

    Raises
    ------
    TypeError
        If `value` is neither a member nor a text.
    ValueError
        If a text is not the name of a member.
    """
    if isinstance(value, kind):
        return value
    names = [member.name.lower() for member in kind]
    if not isinstance(value, str):
        raise InvalidType(name, f"must be a {kind_names(kind)}, or one of {', '.join(names)}", shown(value))
    if value.lower() not in names:
        raise InvalidInput(name, f"must be one of {', '.join(names)}", shown(value))
    return kind[value.upper()]


def require_callable(name: str, value: object) -> None:
    """Raise a TypeError if a value is neither callable nor None."""
    if value is not None and not callable(value):
        raise InvalidType(name, "must be callable or None", shown(value))


def as_float(name: str, value: object) -> float:
    """Return a real number as a float.

    Raises
    ------
    TypeError
        If `value` is not a real number, but for example a string, a complex number, None or an array of several
        numbers.
    ValueError
        If the number is beyond the range of a float.
    """
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, Real):
        raise InvalidType(name, "must be a real number", _described(value))
    try:
        return float(value)
    except OverflowError:
        raise InvalidInput(name, f"must be <= {sys.float_info.max:.2g} in magnitude", shown(value)) from None


def as_float_in(allowed: Range, name: str, value: object, reason: str = "") -> float:
    """Return a number of a range, or raise a TypeError or ValueError; `reason` continues the text of the range."""
    number = as_float(name, value)
    if number not in allowed:
        raise allowed.error(name, f"{number:g}", reason)
    return number


def as_positive(name: str, value: object, unit: str = "") -> float:
    """Return a finite number > 0, or raise a TypeError or ValueError."""
    return as_float_in(Range(0.0, unit=unit, excludes_minimum=True), name, value)


def as_not_negative(name: str, value: object, unit: str = "") -> float:
    """Return a finite number >= 0, or raise a TypeError or ValueError."""
    return as_float_in(Range(0.0, unit=unit), name, value)


def as_poisson_ratio(name: str, value: object, *, compressible: bool = False) -> float:
    """Return Poisson's ratio in (-1, 0.5], or in (-1, 0.5) if the material must be `compressible`."""
    return as_float_in(Range(-1.0, 0.5, excludes_minimum=True, excludes_maximum=compressible), name, value)


def as_kelvin(name: str, value: object) -> float:
    """Return a temperature [K]; reject values below 100 K, where no rubber is rubbery: they are probably in °C."""
    temperature, allowed = as_float(name, value), Range(100.0, unit="K")
    if temperature not in allowed:
        raise allowed.error(name, f"{temperature:g} K", " (20 °C are 293.15 K)")
    return temperature


def as_int(name: str, value: object) -> int:
    """Return a whole number as an int.

    Raises
    ------
    TypeError
        If `value` is not an integer.
    ValueError
        If the number does not fit into 32 bits.
    """
    try:
        if isinstance(value, bool):
            raise TypeError
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise InvalidType(name, "must be a whole number", _described(value)) from None
    if abs(number) > 2**31 - 1:
        raise InvalidInput(name, "must fit into 32 bits", shown(number))
    return number


def as_count(name: str, value: object, least: int, most: float = inf) -> int:
    """Return a whole number from `least` to `most`, or raise a TypeError or ValueError."""
    number = as_int(name, value)
    allowed = Range(least, most)
    if number not in allowed:
        raise allowed.error(name, number)
    return number


def as_float_array(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return real numbers of any shape as an array of floats.

    Raises
    ------
    TypeError
        If an entry is not a real number.
    ValueError
        If an entry is beyond the range of a float, or if rows differ in length.
    """
    array = _each(as_float, name, _as_array(name, values))
    if array.dtype.kind not in "fiu":
        raise InvalidType(name, "must contain real numbers", f"{array.dtype} entries")
    return array.astype(np.float64)


def as_floats(name: str, values: ArrayLike) -> tuple[float, ...]:
    """Return a one-dimensional sequence of real numbers as a tuple of floats.

    Raises
    ------
    TypeError
        If an entry is not a real number.
    ValueError
        If `values` is not one-dimensional, or if an entry is beyond the range of a float.
    """
    if isinstance(values, list | tuple):
        for index, value in enumerate(values):
            if isinstance(value, bool):  # NumPy converts it to a number in a list with numbers
                raise InvalidType(f"{name}[{index}]", "must be a real number", _described(value))
    array = _as_array(name, values, wanted="one-dimensional")
    if array.ndim != 1:
        raise InvalidInput(name, "must be one-dimensional", f"shape {array.shape}")
    return tuple(as_float_array(name, array).tolist())


def as_orders(name: str, values: ArrayLike) -> NDArray[np.int32]:
    """Return whole numbers of any shape as 32-bit integers.

    Raises
    ------
    TypeError
        If an entry is not an integer.
    ValueError
        If an entry exceeds 1e6 in magnitude, which is more than any useful order, or if rows differ in length.
    """
    array = _each(as_int, name, _as_array(name, values))
    if array.dtype.kind not in "iu":
        raise InvalidType(name, "must contain whole numbers", f"{array.dtype} entries")
    if array.size and max(-int(array.min()), int(array.max())) > 10**6:
        raise InvalidInput(name, "must be in [-1e6, 1e6]", f"{array.min()} to {array.max()}")
    return array.astype(np.int32)


def store_floats(target: object, names: Sequence[str], *, optional: Sequence[str] = (), prefix: str = "") -> None:
    """Replace attributes of a frozen object by floats, so that it holds nothing mutable; `optional` ones may be None.

    Raises
    ------
    TypeError
        If an attribute is not a real number. The message gives the name of the attribute, preceded by `prefix`.
    ValueError
        If an attribute is beyond the range of a float.
    """
    given = [name for name in optional if getattr(target, name) is not None]
    for name in (*names, *given):
        object.__setattr__(target, name, as_float(f"{prefix}{name}", getattr(target, name)))


def store_positive(target: object, units: dict[str, str]) -> None:
    """Replace the fields of a frozen dataclass that are keys of `units` by finite floats > 0, or raise an error."""
    for name, unit in units.items():
        object.__setattr__(target, name, as_positive(name, getattr(target, name), unit))


def _as_array(name: str, values: ArrayLike, *, wanted: str = "an array") -> NDArray[Any]:
    try:
        return np.asarray(values)
    except ValueError:
        raise InvalidInput(name, f"must be {wanted}", "rows of different lengths") from None


def _each(convert: Callable[[str, object], Any], name: str, array: NDArray[Any]) -> NDArray[Any]:
    """Convert the entries of an array of objects one by one: NumPy stores integers beyond 64 bits as objects."""
    if array.dtype.kind != "O":
        return array
    entries = [
        convert(f"{name}[{', '.join(map(str, index))}]" if index else name, value)
        for index, value in np.ndenumerate(array)
    ]
    return np.array(entries).reshape(array.shape)


def _described(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"array of shape {value.shape}"
    if isinstance(getattr(value, "value", None), float):  # a value with an interval, as `Parameter`
        return f"{shown(value)}; give its value"
    return f"{type(value).__name__} {shown(value)}"
