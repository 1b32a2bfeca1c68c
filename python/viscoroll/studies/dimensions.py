"""What a study varies: its dimensions, with values, labels and units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from enum import Enum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core import Compliance, Curvature, PatchLoad, SlipKinematics
from .._support.arguments import as_float, as_int, as_member, require_type
from .._support.units import UNITS
from ..bodies import Counterpart, Drive, Mesh

__all__ = ["LOAD_CASE", "Dimension", "checked", "label", "split"]

#: Arguments of `viscoroll.solve` that are objects.
_TYPES: dict[str, type] = {
    "mesh": Mesh,
    "drive": Drive,
    "compliance": Compliance,
    "curvature": Curvature,
    "patch_load": PatchLoad,
    "slip_kinematics": SlipKinematics,
}

#: Arguments of `viscoroll.solve` that a study may fix or vary; all other parameters are those of the ball.
LOAD_CASE = frozenset({"on", "load", "angular_speed", "friction", "accuracy", "max_iterations", *_TYPES})

#: Longest text that serves as a label.
_LONGEST_LABEL = 80


@dataclass(frozen=True, slots=True, kw_only=True)
class Dimension:
    """One parameter and the values that it takes.

    Parameters
    ----------
    name : str
        Its name.
    values : tuple
        At least one value, all different.
    unit : str, optional
        Unit of numbers.

    Raises
    ------
    ValueError
        Without values, and for a value that comes twice.
    """

    name: str
    values: tuple[Any, ...]
    unit: str | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        if not self.values:
            raise ValueError(f"{self.name} must have at least one value, got none")
        if self.is_numeric and len(set(self.values)) == len(self.values):
            return
        for i, value in enumerate(self.values):
            if any(value is other or value == other for other in self.values[:i]):
                raise ValueError(f"{self.name} must have different values, got {value!r} twice")

    @property
    def is_numeric(self) -> bool:
        """Whether all values are real numbers."""
        return all(_is_number(value) for value in self.values)

    def labels(self) -> NDArray[Any]:
        """Return the coordinate: the numbers themselves, or texts, of which no two are the same."""
        if self.is_numeric:
            return np.array(self.values)
        texts = [label(value) for value in self.values]
        if len(set(texts)) < len(texts) or max(map(len, texts)) > _LONGEST_LABEL or any(" at 0x" in t for t in texts):
            texts = [f"{self.name}[{i}]" for i in range(len(texts))]
        return np.array(texts, dtype=object)


def split(name: str, value: object) -> Dimension | object:
    """Return a dimension for a one-dimensional sequence or array, and any other value as it is, checked.

    Raises
    ------
    TypeError
        Where an argument of `viscoroll.solve` has the wrong type.
    ValueError
        For arrays of more dimensions, and what `Dimension` refuses.
    """
    if hasattr(value, "ndim") and hasattr(value, "__array__"):
        array = np.asarray(value)
        if array.ndim > 1:
            raise ValueError(f"{name} must be a scalar or one-dimensional, got shape {array.shape}")
        value = array.tolist()
    if not isinstance(value, Sequence) or isinstance(value, str | bytes):
        return checked(name, value)
    values = [item.item() if isinstance(item, np.generic) else item for item in value]
    return Dimension(name=name, values=tuple(checked(name, item) for item in values), unit=UNITS.get(name))


def checked(name: str, value: object) -> object:
    """Return a value of a parameter, as a float or int where `viscoroll.solve` wants one.

    Raises
    ------
    TypeError
        Where an argument of `viscoroll.solve` has the wrong type.
    """
    if value is None and name in ("on", "mesh", "accuracy"):
        return None
    if name == "max_iterations":
        return as_int(name, value)
    if name == "on":
        require_type(name, value, Counterpart)
        return value
    if name in _TYPES:
        if issubclass(_TYPES[name], Enum):
            return as_member(name, value, _TYPES[name])  # type: ignore[arg-type]
        if not isinstance(value, _TYPES[name]):
            raise TypeError(f"{name} must be a viscoroll.{_TYPES[name].__name__}, got {value!r}")
        return value
    if name in LOAD_CASE:
        return as_float(name, value)
    return value


def label(value: object) -> str:
    """Return a short text for a value."""
    match value:
        case Mesh():
            theta = f"/{value.theta_nodes_per_revolution}" if value.theta_nodes_per_revolution else ""
            return f"{value.nodes_per_revolution}{theta} x {'all' if value.max_order is None else value.max_order}"
        case Enum():
            return value.name
        case Drive():
            given = {parameter.name: getattr(value, parameter.name) for parameter in fields(Drive)}
            left_out = {parameter.name: parameter.default for parameter in fields(Drive)}
            return ", ".join(f"{name}={number:g}" for name, number in given.items() if number != left_out[name])
        case _:
            return str(getattr(value, "__name__", None) or repr(value))


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
