"""Mass, spring and damper between a rolling body and its frame."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, fields

from .. import _core
from .._support.arguments import store_floats
from .._support.tables import ParameterTable

__all__ = ["Axle"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Axle(ParameterTable):
    """Axle that moves up and down: mass, spring and damper between the rolling body and a frame at constant height.

    The load of a motion is then the external force on the axle. At the start, the axle is at rest under this force, and
    spring and damper exert no force. The body lifts off if the contact would have to pull. At least one parameter must
    be positive.

    Parameters
    ----------
    mass : float, default 0
        Mass that moves up and down with the axle [kg], for rollers per length [kg/m], ≥ 0. Steps are then at most a
        sixtieth of the period in which it vibrates on the contact.
    stiffness : float, default 0
        Stiffness of the spring [N/m], for rollers per length [N/m^2], ≥ 0.
    damping : float, default 0
        Force of the damper per speed [N s/m], for rollers per length [N s/m^2], ≥ 0.

    Raises
    ------
    TypeError
        If a value is not a real number.
    ValueError
        If a value is negative, or all are 0.

    Examples
    --------
    >>> Axle(mass=20.0)
    Axle(mass=20.0, stiffness=0.0, damping=0.0)
    """

    mass: float = field(default=0.0, metadata={"unit": "kg"})
    stiffness: float = field(default=0.0, metadata={"unit": "N/m"})
    damping: float = field(default=0.0, metadata={"unit": "N s/m"})

    def __post_init__(self) -> None:
        """Store the numbers as floats and check them."""
        store_floats(self, [one.name for one in fields(self)])
        self._to_core()

    def _to_core(self) -> _core.Axle:
        return _core.Axle(**asdict(self))
