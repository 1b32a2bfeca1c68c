"""Dimensions of a study: the parameters that vary, with values, labels and units."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from enum import Enum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._core import Compliance, Curvature, PatchLoad, SlipKinematics
from .._support.arguments import as_float, as_int, as_member, require_type
from .._support.errors import InvalidInput
from .._support.tables import handy
from .._support.text import shown
from .._support.units import UNITS
from ..bodies import Adhesion, Drive, Mesh, is_body
from ..materials import Draws
from .kinds import ROLLING, StudyKind

__all__ = ["MOST_POINTS", "Dimension", "checked", "label", "require_feasible", "split"]

#: Largest number of points of a study. They need 5.4 GB of memory: a point without fields and draws needs 5.4 kB
#: (measured with tracemalloc over plan, outcomes and dataset of 10 000 points).
MOST_POINTS = 1_000_000

#: Arguments of `viscoroll.solve` that are objects.
_TYPES: dict[str, type] = {
    "mesh": Mesh,
    "drive": Drive,
    "adhesion": Adhesion,
    "compliance": Compliance,
    "curvature": Curvature,
    "patch_load": PatchLoad,
    "slip_kinematics": SlipKinematics,
}

#: Longest text that is used as a label [characters].
_LONGEST_LABEL = 80


@dataclass(frozen=True, slots=True, kw_only=True)
class Dimension:
    """One parameter and its values.

    Parameters
    ----------
    name : str
        Name of the parameter.
    values : tuple
        At least one value, all different.
    unit : str, optional
        Unit of numeric values.
    names : tuple of str, optional
        One label for each value; by default, labels are derived from the values.

    Raises
    ------
    ValueError
        If there are no values, or if a value occurs twice.
    """

    name: str
    values: tuple[Any, ...]
    unit: str | None = None
    names: tuple[str, ...] | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        if not self.values:
            raise InvalidInput(self.name, "must have at least one value", "none")
        seen: Any = set() if self.is_numeric else []  # other values may not be hashable
        keep = seen.add if self.is_numeric else seen.append
        for value in self.values:
            if value in seen:
                raise InvalidInput(self.name, "must have different values", f"{value!r} twice")
            keep(value)

    @property
    def is_numeric(self) -> bool:
        """Whether all values are real numbers."""
        return all(_is_number(value) for value in self.values)

    def labels(self) -> NDArray[Any]:
        """Return the values of the coordinate: the numbers themselves, or texts that are all different."""
        if self.names is not None:
            return np.array(self.names, dtype=object)
        if self.is_numeric:
            return np.array(self.values)
        numbered = [f"{self.name}[{i}]" for i in range(len(self.values))]
        candidates = (
            [label(value) for value in self.values],
            [_structure_text(value) for value in self.values],
            numbered,
        )
        return np.array(next(texts for texts in candidates if _are_labels(texts)), dtype=object)


def require_feasible(sizes: Mapping[str, int]) -> None:
    """Reject studies of more points than `MOST_POINTS`, before arrays of that size are allocated.

    Parameters
    ----------
    sizes : mapping of str to int
        Number of values by the name of the parameter.

    Raises
    ------
    ValueError
        If there are too many points; the message gives their number and the limit.
    """
    if (count := math.prod(sizes.values())) > MOST_POINTS:
        varied = {name: size for name, size in sizes.items() if size > 1}
        factors = " x ".join(f"{shown(size)} {name}" for name, size in varied.items())
        raise ValueError(f"a study must have at most {MOST_POINTS} points, got {shown(count)} ({factors})")


def split(name: str, value: object, kind: StudyKind = ROLLING) -> Dimension | object:
    """Return a dimension for a one-dimensional sequence, array or mapping, and the checked value otherwise.

    The keys of a mapping are the labels of its values. `Draws` of a material are one value: they describe the
    uncertainty of a parameter, not its variation.

    Raises
    ------
    TypeError
        If an argument of the solver has the wrong type.
    ValueError
        For arrays of several dimensions, for more than `MOST_POINTS` values, and for values that `Dimension` rejects.
    """
    if isinstance(value, Draws):
        return checked(name, value, kind)
    if hasattr(value, "ndim") and hasattr(value, "__array__"):
        require_feasible({name: math.prod(getattr(value, "shape", ()))})
        array = np.asarray(value)
        if array.ndim > 1:
            raise InvalidInput(name, "must be a scalar or one-dimensional", f"shape {array.shape}")
        value = array.tolist()
    if isinstance(value, Mapping | Sequence):
        require_feasible({name: _length(value)})
    if isinstance(value, Mapping):
        named = tuple(checked(name, item, kind) for item in value.values())
        return Dimension(name=name, values=named, unit=UNITS.get(name), names=tuple(map(str, value)))
    if not isinstance(value, Sequence) or isinstance(value, str | bytes):
        return checked(name, value, kind)
    values = [item.item() if isinstance(item, np.generic) else item for item in value]
    return Dimension(name=name, values=tuple(checked(name, item, kind) for item in values), unit=UNITS.get(name))


def checked(name: str, value: object, kind: StudyKind = ROLLING) -> object:
    """Return the checked value of a parameter, converted to float or int if the solver takes a number.

    Raises
    ------
    TypeError
        If an argument of the solver has the wrong type.
    """
    if value is None and name in kind.optional:
        return None
    if name == "max_iterations":
        return as_int(name, value)
    if name == "finite_strain":
        require_type(name, value, bool)
        return value
    if name == "on":
        for one in (value.best_estimate, *value) if isinstance(value, Draws) else (value,):
            require_type(name, one, kind.counterbody)
        return value
    if name in _TYPES:
        if issubclass(_TYPES[name], Enum):
            return as_member(name, value, _TYPES[name])  # type: ignore[arg-type]
        require_type(name, value, _TYPES[name])
        return value
    if name in kind.arguments:
        return as_float(name, value)
    return value


def _length(values: Mapping[Any, Any] | Sequence[Any]) -> int:
    """Return the number of values, or `sys.maxsize` for ranges too long for `len`."""
    try:
        return len(values)
    except OverflowError:
        return sys.maxsize


def _are_labels(texts: Sequence[str]) -> bool:
    """Return whether texts can be labels: all differ, are short enough, and contain no memory address."""
    return (
        len(set(texts)) == len(texts)
        and max(map(len, texts)) <= _LONGEST_LABEL
        and not any(" at 0x" in text for text in texts)
    )


def _structure_text(value: object) -> str:
    """Return the type of a body with its core radius and layer thicknesses; an empty text for other values."""
    if not is_body(value):
        return ""
    core = getattr(value, "core_radius", None)
    parts = [] if core is None else [f"core {handy([core], 'm')[0][0]} {handy([core], 'm')[1]}"]
    parts += [f"layer {texts[0]} {unit}" for texts, unit in (handy([one.thickness], "m") for one in value.layers)]
    return ", ".join([type(value).__name__, *parts])


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
            defaults = {parameter.name: parameter.default for parameter in fields(Drive)}
            return ", ".join(f"{name}={number:g}" for name, number in given.items() if number != defaults[name])
        case _:
            return str(getattr(value, "__name__", None) or repr(value))


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
