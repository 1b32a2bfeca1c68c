"""Input of a result with small changes: one number, or a modulus around a frequency."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import Floats
from ..bodies import Counterbody, Drive, HalfSpace, Layer, Mesh, RollingBody
from ..bodies.layered import materials_of, with_materials
from ..materials.modulus_like import to_core
from ..solution import Solution

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..bodies.layered import LayeredBody

__all__ = [
    "Bands",
    "Change",
    "Given",
    "MaterialPosition",
    "Number",
    "Part",
    "bands_of",
    "change_of_modulus",
    "material_positions",
    "numbers_of",
]

#: Part of a complex modulus.
Part: TypeAlias = Literal["storage", "loss"]

#: Poisson's ratio above which a difference quotient uses only smaller values, because the limit is 0.5.
_HIGHEST_POISSON_RATIO = 0.499


@dataclass(frozen=True, slots=True)
class Given:
    """Input of a result that can be changed."""

    body: RollingBody
    on: Counterbody | None
    load: float | None
    penetration: float | None
    angular_speed: float
    friction: float
    drive: Drive

    @classmethod
    def of(cls, result: Solution) -> Given:
        """Return the input of a result."""
        values = {field.name: getattr(result, field.name) for field in fields(cls)}
        return cls(**{**values, result.unprescribed: None})


#: Function of a relative change that returns the changed input.
Change: TypeAlias = Callable[[float], Given]


@dataclass(frozen=True, slots=True)
class Number:
    """One number of the input.

    Attributes
    ----------
    name : str
        Name in the input, such as ``"load"`` or ``"on.layers[0].thickness"``.
    change : callable
        Function that changes the number.
    downwards : bool
        Whether the number is so close to its upper limit that it can only decrease.
    """

    name: str
    change: Change
    downwards: bool = False


@dataclass(frozen=True, slots=True)
class MaterialPosition:
    """Position of a material in the bodies of an input.

    Attributes
    ----------
    which : "body" or "on"
        Body: the rolling body or the counterbody.
    index : int
        Index in `materials_of` that body.
    name : str
        ``"layers[0]"``, or ``"on.layers[0]"`` or ``"on.base"`` in a counterbody.
    """

    which: Literal["body", "on"]
    index: int
    name: str

    def material(self, given: Given) -> Layer | HalfSpace:
        """Return the layer or half-space at this position."""
        return materials_of(getattr(given, self.which))[self.index]

    def with_changed(self, given: Given, **changed: Any) -> Given:
        """Return the input with other parameters of the material at this position."""
        body: LayeredBody = getattr(given, self.which)
        materials = list(materials_of(body))
        materials[self.index] = replace(materials[self.index], **changed)
        return replace(given, **{self.which: with_materials(body, materials)})  # type: ignore[arg-type]

    def rolling_speed(self, result: Solution) -> float:
        """Return the lowest frequency of the load on the material [rad/s]: the rolling speed / radius of its body."""
        if self.which == "body":
            return result.angular_speed
        radius = getattr(result.on, "outer_radius", result.body.outer_radius)
        return float(result.angular_speed * result.body.outer_radius / radius)


def material_positions(given: Given) -> Iterator[MaterialPosition]:
    """Yield the positions of all materials, first of the rolling body, each body from the inside outwards."""
    for which, prefix in (("body", ""), ("on", "on.")):
        body = getattr(given, which)
        if body is None:
            continue
        count = len(materials_of(body))
        bases = count - len(body.layers)
        for i in range(count):
            name = "base" if i < bases else f"layers[{i - bases}]"
            yield MaterialPosition(which, i, f"{prefix}{name}")  # type: ignore[arg-type]


def numbers_of(given: Given) -> Iterator[Number]:
    """Yield all nonzero numbers: load or penetration, speed, friction, drive, and the numbers of all materials."""
    for name in ("load", "penetration", "angular_speed", "friction"):
        value = getattr(given, name)
        if value and math.isfinite(value):
            yield Number(name, _change_of(given, name, value))
    for field in fields(given.drive):
        value = getattr(given.drive, field.name)
        if value:
            yield Number(f"drive.{field.name}", _change_of_drive(given, field.name, value))
    for position in material_positions(given):
        for name in ("thickness", "poisson_ratio", "bulk_modulus", "density"):
            value = getattr(position.material(given), name, None)
            if value:
                is_highest = name == "poisson_ratio" and value > _HIGHEST_POISSON_RATIO
                yield Number(f"{position.name}.{name}", _change_at(given, position, name, value), is_highest)


def _change_of(given: Given, name: str, value: float) -> Change:
    return lambda change: replace(given, **{name: value * (1.0 + change)})  # type: ignore[arg-type]


def _change_of_drive(given: Given, name: str, value: float) -> Change:
    return lambda change: replace(given, drive=replace(given.drive, **{name: value * (1.0 + change)}))


def _change_at(given: Given, position: MaterialPosition, name: str, value: float) -> Change:
    return lambda change: position.with_changed(given, **{name: value * (1.0 + change)})


@dataclass(frozen=True, slots=True)
class Bands:
    """Weights of overlapping frequency bands: squared cosines of the logarithm of frequency that add up to 1.

    Attributes
    ----------
    centers : ndarray
        Frequencies at which the weight of a band is 1, at equal ratios [rad/s]. The lowest band also has the weight 1
        at all lower frequencies, and the highest band at all higher ones.
    """

    centers: Floats

    def weight(self, band: int, frequency: Floats) -> Floats:
        """Return the weight of a band at frequencies [-]."""
        with np.errstate(divide="ignore"):
            position = np.log(frequency / self.centers[0]) / np.log(self.centers[1] / self.centers[0])
        distance = np.abs(np.clip(position, 0.0, self.centers.size - 1.0) - band)
        weight: Floats = np.where(distance < 1.0, np.cos(0.5 * np.pi * np.minimum(distance, 1.0)) ** 2, 0.0)
        return weight


def bands_of(rolling_speed: float, mesh: Mesh, per_decade: int) -> Bands:
    """Return bands centered at powers of 10^(1/per_decade) rad/s, from one revolution to the mesh's highest order."""
    lowest = math.floor(math.log10(rolling_speed) * per_decade)
    highest = math.ceil(math.log10(rolling_speed * mesh.nodes_per_revolution / 2.0) * per_decade)
    return Bands(10.0 ** (np.arange(lowest, highest + 1) / per_decade))


def change_of_modulus(
    given: Given, position: MaterialPosition, bands: Bands, band: int, part: Part, *, rolling_speed: float
) -> Change:
    """Return a function that changes the storage or the loss part of a modulus in a band.

    `rolling_speed` is the lowest frequency of the load on the material [rad/s], at which slow terms do not relax.
    """
    modulus = to_core(position.material(given).shear_modulus)

    def changed(relative: float) -> Given:
        def values(frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
            value = _core.modulus_in_rolling(modulus, rolling_speed, frequency)
            change = relative * bands.weight(band, frequency)
            return value + change * (value.real if part == "storage" else 1j * value.imag)

        return position.with_changed(given, shear_modulus=values)

    return changed
