"""Base class of shear moduli, and relaxation functions that are sums of exponentials."""

from __future__ import annotations

from dataclasses import dataclass, fields
from enum import Enum
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from .. import _core
from .._support.arguments import as_float, as_float_array, as_floats, as_member
from .._support.tables import ParameterTable
from .._support.text import snake_case
from .._support.units import UNITS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["KnownTimes", "Relaxation", "ShearModulus", "known_times_of"]

#: Beginning of the types of parameters that are columns of numbers.
_COLUMN = "Sequence[float]"

#: Units by the exponents of stress and time.
_UNITS = {(0, 0): "1", (1, 0): "Pa", (-1, 0): "1/Pa", (0, 1): "s", (0, -1): "rad/s", (1, 1): "Pa s"}


@dataclass(frozen=True, slots=True)
class Relaxation:
    """Relaxation function Σ M_k exp(-t/τ_k), in parallel with a dashpot.

    Attributes
    ----------
    moduli : ndarray, shape (k,)
        Moduli M_k [Pa]; the last one is the relaxed modulus.
    times : ndarray, shape (k,)
        Relaxation times τ_k [s]; the last one is infinite.
    viscosity : float
        Viscosity of the dashpot [Pa s].
    """

    moduli: NDArray[np.float64]
    times: NDArray[np.float64]
    viscosity: float = 0.0

    @property
    def longest_time(self) -> float:
        """Longest finite relaxation time [s]; 0 if there is none."""
        return float(self.times[:-1].max(initial=0.0))


@dataclass(frozen=True, slots=True)
class KnownTimes:
    """Times for which a modulus is measured or defined.

    Attributes
    ----------
    longest : float
        Longest time [s]; creep beyond it is an extrapolation.
    meaning : str
        Subject and verb of a sentence that ends with this time.
    extrapolated_rest : (float, float) or None
        Modulus at rest, if it is an extrapolation, and the modulus that the user gives [Pa].
    """

    longest: float
    meaning: str
    extrapolated_rest: tuple[float, float] | None = None


class ShearModulus(ParameterTable):
    """Base class of the moduli of this package."""

    __slots__ = ()

    #: Exponents of stress and time in the units of the parameters, for example (1, 1) for a viscosity [Pa s]; (0, 0)
    #: for parameters that are not listed.
    _units: ClassVar[dict[str, tuple[int, int]]] = {}

    def __init_subclass__(cls) -> None:
        """Register the units of the parameters."""
        numbers = [name for name, kind in cls.__annotations__.items() if str(kind).startswith(("float", _COLUMN))]
        UNITS.update({name: _UNITS[cls._units.get(name, (0, 0))] for name in numbers})

    def __post_init__(self) -> None:
        """Store numbers as floats, columns as tuples and names as members of enumerations; check the parameters."""
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            if field.type == "float" or (field.type == "float | None" and value is not None):
                value = as_float(field.name, value)
            elif str(field.type).startswith(_COLUMN):
                value = as_floats(field.name, value)
            elif isinstance(field.default, Enum):
                value = as_member(field.name, value, type(field.default))
            object.__setattr__(self, field.name, value)
        self._to_core()

    def _to_core(self) -> _core.ShearModulus:
        """Return the corresponding modulus of the C++ core, which has checked the parameters."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]
        parameters = {name: value for name, value in values.items() if value is not None}
        return _core.ShearModulus(snake_case(type(self).__name__), **parameters)

    def complex_modulus(self, angular_frequency: ArrayLike) -> NDArray[np.complex128]:
        """Evaluate μ*(ω).

        Parameters
        ----------
        angular_frequency : array_like
            ω [rad/s], ≥ 0, of any shape.

        Returns
        -------
        ndarray of complex
            Shear modulus [Pa], of the same shape, with a loss modulus ≥ 0; real at ω = 0.

        Raises
        ------
        TypeError
            If the frequencies are not real numbers.
        ValueError
            If a frequency is negative or infinite, or outside the table of a master curve with `extrapolation="error"`.
        """
        omega = as_float_array("angular_frequency", angular_frequency)
        return _core.complex_modulus(self._to_core(), omega.ravel()).reshape(omega.shape)

    def _relaxation(self) -> Relaxation | None:
        """Return the relaxation function, or None if it is not a sum of exponentials."""
        return None

    def _standard_linear_solid(self) -> Any:
        """Return the `StandardLinearSolid` that equals this modulus, or None if there is none."""
        return None

    def _known_times(self) -> KnownTimes | None:
        """Return the times for which the modulus is measured or defined, or None if there is no limit."""
        return None


def known_times_of(modulus: object) -> KnownTimes | None:
    """Return the times for which a modulus is measured or defined; None without a limit, as for functions."""
    return modulus._known_times() if isinstance(modulus, ShearModulus) else None
