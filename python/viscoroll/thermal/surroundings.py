"""Thermal surroundings of a body: the arguments of `Result.temperature`, and their checks for each kind of body."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_kelvin, as_not_negative, as_positive
from .._support.errors import InvalidInput, InvalidType
from .._support.text import shown

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..solution.inside import LayersInside
    from .heat_modes import HeatModes

__all__ = [
    "Core",
    "Surroundings",
    "conductivities_of",
    "core_rise",
    "inner_coefficients",
    "require_heat_sink",
    "require_omitted",
    "uniform_film",
]


class Core(Enum):
    """Thermal condition at the core or base; for a ball, a number is the conductivity of a solid core [W/(m K)]."""

    INSULATED = "insulated"  #: no heat flow
    ISOTHERMAL = "isothermal"  #: a given temperature, by default that of the surroundings


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """Thermal surroundings: the arguments of `Result.temperature` as given."""

    convection: float | Callable[[NDArray[np.float64]], NDArray[np.float64]]
    ambient: float
    core: Core | float = Core.INSULATED
    core_temperature: float | None = None
    width: float | None = None
    side_convection: float | None = None
    hub_conductance: float | None = None
    base_convection: float | None = None
    period: float | None = None


def inner_coefficients(given: Surroundings, modes: HeatModes, area: Callable[[], float]) -> NDArray[np.float64] | None:
    """Return the coefficients at the inner surface [W/(m² K)], or None if its temperature is given.

    Parameters
    ----------
    area : callable
        Function that returns the area of the inner surface [m²].

    Raises
    ------
    TypeError, ValueError
        If an argument is invalid.
    """
    if not isinstance(given.core, Core):
        raise InvalidType("core", "must be a viscoroll.enums.Core, except in a ball", shown(given.core))
    if given.core is Core.ISOTHERMAL:
        if given.hub_conductance is not None:
            raise InvalidInput("hub_conductance", "must be left out with an ISOTHERMAL core")
        return None
    conductance = as_not_negative("hub_conductance", given.hub_conductance or 0.0, "W/K")
    return np.full(modes.count, conductance / area())


def core_rise(given: Surroundings) -> float:
    """Return the rise of a core at a given temperature over the surroundings [K].

    Raises
    ------
    ValueError
        If a temperature is given for a core that is not isothermal.
    """
    if given.core is not Core.ISOTHERMAL:
        if given.core_temperature is not None:
            wanted = "core_temperature must be left out unless core is ISOTHERMAL"
            raise ValueError(f"{wanted}, got {shown(given.core_temperature)}")
        return 0.0
    return (
        0.0 if given.core_temperature is None else as_kelvin("core_temperature", given.core_temperature) - given.ambient
    )


def uniform_film(given: Surroundings) -> float:
    """Return the coefficient of convection at the surface [W/(m² K)]; of a function, the value at θ = π/2.

    Raises
    ------
    TypeError, ValueError
        If the coefficient is negative or not a number.
    """
    if callable(given.convection):
        values = np.atleast_1d(np.asarray(given.convection(np.array([0.5 * np.pi])), dtype=np.float64))
        return as_not_negative("convection", float(values[0]), "W/(m^2 K)")
    return as_not_negative("convection", given.convection, "W/(m^2 K)")


def require_heat_sink(power: float, film: float | NDArray[np.float64], other: bool) -> None:
    """Check that a body with a loss can give off its heat.

    Raises
    ------
    ValueError
        If neither the outer surface nor, according to `other`, another surface removes heat.
    """
    if not other and not np.any(film) and power > 0.0:
        raise InvalidInput("convection", "must be > 0 W/(m^2 K) if nothing else removes heat", "0")


def require_omitted(given: Surroundings, names: Sequence[str], body: str) -> None:
    """Check that arguments that do not apply to a kind of body are omitted.

    Raises
    ------
    ValueError
        If any of the named arguments was given.
    """
    for name in names:
        if getattr(given, name) is not None:
            raise InvalidInput(name, f"must be left out with {body}", shown(getattr(given, name)))


def conductivities_of(inside: LayersInside, given: float | Sequence[float] | None) -> list[float]:
    """Return the conductivity of each layer [W/(m K)].

    Raises
    ------
    TypeError, ValueError
        If a conductivity is invalid or missing.
    """
    layers = inside.body.layers
    if given is None:
        values = [layer.conductivity for layer in layers]
        if None in values:
            raise InvalidInput("conductivity", "must be given here or in every layer", f"layers with {values}")
        return [value for value in values if value is not None]
    if np.ndim(given) == 0:
        return [as_positive("conductivity", given, "W/(m K)")] * len(layers)
    several = [as_positive(f"conductivity[{j}]", value, "W/(m K)") for j, value in enumerate(given)]  # type: ignore[arg-type]
    if len(several) != len(layers):
        raise InvalidInput("conductivity", f"must have one value for each of {len(layers)} layers", len(several))
    return several
