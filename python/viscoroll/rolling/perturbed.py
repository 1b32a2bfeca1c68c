"""What a result was solved for, a little changed: one number of it, or a modulus around a frequency."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np

from .. import _core
from .._support.arguments import Floats
from ..bodies import Counterpart, Drive, HalfSpace, Layer, Mesh, RollingBody
from ..bodies.layered import materials_of, with_materials
from ..materials.moduli import to_core
from ..solution import Solution

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..bodies.layered import LayeredBody

__all__ = [
    "Bands",
    "Change",
    "Given",
    "Number",
    "Part",
    "Place",
    "bands_of",
    "change_of_modulus",
    "numbers_of",
    "places_of",
]

#: Of a complex modulus.
Part: TypeAlias = Literal["storage", "loss"]

#: Poisson's ratio from which on there is no room above it for a quotient.
_HIGHEST_POISSON_RATIO = 0.499


@dataclass(frozen=True, slots=True)
class Given:
    """What a result was solved for, as far as it is changed."""

    ball: RollingBody
    on: Counterpart | None
    load: float
    angular_speed: float
    friction: float
    drive: Drive

    @classmethod
    def of(cls, result: Solution) -> Given:
        """Return what a result was solved for."""
        return cls(**{field.name: getattr(result, field.name) for field in fields(cls)})


#: Called with a relative change; returns the input that has it.
Change: TypeAlias = Callable[[float], Given]


@dataclass(frozen=True, slots=True)
class Number:
    """One number of the input.

    Attributes
    ----------
    name : str
        As in the input: ``"load"``, ``"on.layers[0].thickness"``.
    change : callable
        What changes it.
    downwards : bool
        Whether it is as large as it may be.
    """

    name: str
    change: Change
    downwards: bool = False


@dataclass(frozen=True, slots=True)
class Place:
    """Where a material is.

    Attributes
    ----------
    which : "ball" or "on"
        Of what.
    index : int
        Among its `materials_of`.
    name : str
        ``"layers[0]"``, of what is rolled on ``"on.layers[0]"`` or ``"on.base"``.
    """

    which: Literal["ball", "on"]
    index: int
    name: str

    def material(self, given: Given) -> Layer | HalfSpace:
        """Return what is there."""
        return materials_of(getattr(given, self.which))[self.index]

    def with_changed(self, given: Given, **changed: Any) -> Given:
        """Return the input with other parameters of what is there."""
        body: LayeredBody = getattr(given, self.which)
        materials = list(materials_of(body))
        materials[self.index] = replace(materials[self.index], **changed)
        return replace(given, **{self.which: with_materials(body, materials)})  # type: ignore[arg-type]

    def rolling_speed(self, result: Solution) -> float:
        """Return the lowest frequency at which the material is loaded, once in a revolution [rad/s]."""
        if self.which == "ball":
            return result.angular_speed
        radius = getattr(result.on, "outer_radius", result.ball.outer_radius)
        return float(result.angular_speed * result.ball.outer_radius / radius)


def places_of(given: Given) -> Iterator[Place]:
    """Yield where materials are, of what rolls first, each from the inside outwards."""
    for which, prefix in (("ball", ""), ("on", "on.")):
        body = getattr(given, which)
        if body is None:
            continue
        count = len(materials_of(body))
        bases = count - len(body.layers)
        for i in range(count):
            name = "base" if i < bases else f"layers[{i - bases}]"
            yield Place(which, i, f"{prefix}{name}")  # type: ignore[arg-type]


def numbers_of(given: Given) -> Iterator[Number]:
    """Yield what is not 0 of load, speed, friction and drive, and of all materials."""
    for name in ("load", "angular_speed", "friction"):
        value = getattr(given, name)
        if 0.0 < value < math.inf:
            yield Number(name, _change_of(given, name, value))
    for field in fields(given.drive):
        value = getattr(given.drive, field.name)
        if value:
            yield Number(f"drive.{field.name}", _change_of_drive(given, field.name, value))
    for place in places_of(given):
        for name in ("thickness", "poisson_ratio", "bulk_modulus", "density"):
            value = getattr(place.material(given), name, None)
            if value:
                is_highest = name == "poisson_ratio" and value > _HIGHEST_POISSON_RATIO
                yield Number(f"{place.name}.{name}", _change_at(given, place, name, value), is_highest)


def _change_of(given: Given, name: str, value: float) -> Change:
    return lambda share: replace(given, **{name: value * (1.0 + share)})  # type: ignore[arg-type]


def _change_of_drive(given: Given, name: str, value: float) -> Change:
    return lambda share: replace(given, drive=replace(given.drive, **{name: value * (1.0 + share)}))


def _change_at(given: Given, place: Place, name: str, value: float) -> Change:
    return lambda share: place.with_changed(given, **{name: value * (1.0 + share)})


@dataclass(frozen=True, slots=True)
class Bands:
    """Shares of all frequencies, which rise and fall as squares of cosines over its logarithm and add up to 1.

    Attributes
    ----------
    middles : ndarray
        Where a band has all, at equal ratios [rad/s]; the lowest has all below, too, and the highest all above.
    """

    middles: Floats

    def share(self, band: int, frequency: Floats) -> Floats:
        """Return the share of a band at frequencies [-]."""
        with np.errstate(divide="ignore"):
            place = np.log(frequency / self.middles[0]) / np.log(self.middles[1] / self.middles[0])
        distance = np.abs(np.clip(place, 0.0, self.middles.size - 1.0) - band)
        share: Floats = np.where(distance < 1.0, np.cos(0.5 * np.pi * np.minimum(distance, 1.0)) ** 2, 0.0)
        return share


def bands_of(rolling_speed: float, mesh: Mesh, per_decade: int) -> Bands:
    """Return bands from one revolution's frequency to that of the mesh's highest order, around round numbers."""
    lowest = math.floor(math.log10(rolling_speed) * per_decade)
    highest = math.ceil(math.log10(rolling_speed * mesh.nodes_per_revolution / 2.0) * per_decade)
    return Bands(10.0 ** (np.arange(lowest, highest + 1) / per_decade))


def change_of_modulus(given: Given, place: Place, bands: Bands, band: int, part: Part) -> Change:
    """Return what changes a part of a modulus in a band."""
    modulus = to_core(place.material(given).shear_modulus)

    def changed(share: float) -> Given:
        def values(frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
            value = _core.complex_modulus(modulus, frequency)
            change = share * bands.share(band, frequency)
            return value + change * (value.real if part == "storage" else 1j * value.imag)

        return place.with_changed(given, shear_modulus=values)

    return changed
