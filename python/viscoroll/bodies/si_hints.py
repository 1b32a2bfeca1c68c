"""Hints for input that seems to be in millimeters, megapascals or revolutions per minute."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import Protocol

import numpy as np

from .._core import ConvergenceError, complex_modulus
from .._support.errors import InvalidInput
from ..materials.modulus_like import ShearModulusLike, to_core
from .layers import Layer, at_rest

__all__ = ["si_hint", "si_hints", "unit_doubt"]


class _Layered(Protocol):
    """Protocol of a body with layers."""

    @property
    def layers(self) -> Sequence[Layer]:
        """Layers from the inside outwards."""


#: Limits of plausible input: larger radii and widths, thicker layers, lower moduli and higher speeds probably have the
#: wrong unit.
_LARGEST_RADIUS = 1.5  # [m]
_LARGEST_THICKNESS = 0.5  # [m]
_SMALLEST_MODULUS = 1e3  # [Pa]
_LARGEST_SPEED = 100.0  # [rad/s]

#: Pattern of a modulus at rest from 10 to 100 Pa, a number that may be a Shore hardness.
_SHORE = re.compile(r"= \d\d(?:\.\d+)? Pa at rest")

#: Parameters that are rejected if other lengths or moduli have wrong units.
_AFFECTED = ("load", "angular_speed", "speed")


def si_hint(body: _Layered, on: _Layered | None = None) -> str:
    """Return a hint that lists implausible lengths and moduli of both bodies, or an empty string."""
    doubtful = [*_doubtful(body, ""), *([] if on is None else _doubtful(on, "on."))]
    return f"viscoroll expects SI units, got {', '.join(doubtful)}" if doubtful else ""


def unit_doubt(body: _Layered, on: _Layered | None = None) -> str:
    """Return a hint that asks whether other units were meant, or an empty string if all values are plausible."""
    hint = si_hint(body, on)
    stress = "megapascals or a Shore hardness" if _SHORE.search(hint) else "megapascals"
    meant = [name for name, unit in (("millimeters", " m"), (stress, " Pa at rest")) if _mentions(hint, unit)]
    return f"{hint}; were {' and '.join(meant)} meant?" if hint else ""


def _mentions(hint: str, unit: str) -> bool:
    return any(part.endswith(unit) for part in hint.split(", "))


@contextmanager
def si_hints(body: _Layered, on: _Layered | None = None, *, angular_speed: float = 0.0) -> Iterator[None]:
    """Append a hint at implausible units to errors of convergence and to errors about the load or the speed."""
    try:
        yield
    except ConvergenceError as error:
        raise ConvergenceError("; ".join(filter(None, [str(error), si_hint(body, on)]))) from None
    except InvalidInput as error:
        if error.parameter not in _AFFECTED:
            raise
        hints = [si_hint(body, on)]
        if error.parameter == "angular_speed" and _LARGEST_SPEED <= angular_speed < math.inf:
            hints.append(f"{angular_speed:g} rad/s are {angular_speed * 30.0 / math.pi:.0f} revolutions per minute")
        raise error.with_more("; ".join(filter(None, hints))) from None


def _doubtful(body: _Layered, where: str) -> Iterator[str]:
    if (radius := getattr(body, "outer_radius", 0.0)) > _LARGEST_RADIUS:
        yield f"{where}outer_radius = {radius:g} m"
    if (width := getattr(body, "width", None) or 0.0) > _LARGEST_RADIUS:
        yield f"{where}width = {width:g} m"
    for j, layer in enumerate(body.layers):
        if layer.thickness > _LARGEST_THICKNESS:
            yield f"{where}layers[{j}].thickness = {layer.thickness:g} m"
        yield from _soft(at_rest(layer).shear_modulus, f"{where}layers[{j}]")
    if (base := getattr(body, "base", None)) is not None:
        yield from _soft(at_rest(base).shear_modulus, f"{where}base")


def _soft(modulus: ShearModulusLike, where: str) -> Iterator[str]:
    """Yield the modulus at rest if it is too low for a solid; skip tables that contain no modulus at rest."""
    with suppress(ValueError):
        static = complex_modulus(to_core(modulus), np.zeros(1))[0].real
        if static < _SMALLEST_MODULUS:
            yield f"{where}.shear_modulus = {static:.3g} Pa at rest"
