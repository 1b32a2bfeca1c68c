"""Drive of a rolling body with friction."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, fields

from .. import _core
from .._support.arguments import store_floats
from .._support.errors import InvalidInput
from .._support.tables import ParameterTable
from .._support.units import UNITS

__all__ = ["Drive"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Drive(ParameterTable):
    """Drive of a body that rolls with friction: exactly one of force, torque, power and creepage.

    Parameters
    ----------
    force : float, optional
        Q, horizontal force on the center, positive forward [N]; its magnitude is less than friction times load. With
        0 the torque alone drives the body.
    torque : float, optional
        T, driving torque about the rolling axis [N m]. With 0 the body is towed.
    power : float, optional
        Driving power at the axle [W]: the driving torque times the angular speed Ω. A negative power brakes the
        body; with 0 it is towed.
    creepage : float, optional
        V_s / (Ω r_o) - 1 [-], where V_s is the speed of the center and Ω r_o the rolling speed.
    lateral_creepage : float, default 0
        Lateral speed of the center divided by Ω r_o [-]; allowed only with `creepage`.
    spin : float, default 0
        Angular speed of the body about the downward axis through the contact, divided by Ω r_o [1/m]; allowed only with
        `creepage`.

    Raises
    ------
    TypeError
        If a value is not a real number.
    ValueError
        Unless exactly one of force, torque, power and creepage is given, or if lateral creepage or spin is given
        without creepage.

    Examples
    --------
    >>> Drive(torque=0.0)
    Drive(force=None, torque=0.0, power=None, creepage=None, lateral_creepage=0.0, spin=0.0)
    """

    force: float | None = field(default=None, metadata={"unit": "N"})
    torque: float | None = field(default=None, metadata={"unit": "N m"})
    power: float | None = field(default=None, metadata={"unit": "W"})
    creepage: float | None = field(default=None, metadata={"unit": "1"})
    lateral_creepage: float = field(default=0.0, metadata={"unit": "1"})
    spin: float = field(default=0.0, metadata={"unit": "1/m"})

    def __post_init__(self) -> None:
        """Store the numbers as floats and check the parameters."""
        kinds = [parameter.name for parameter in fields(self) if parameter.default is None]
        others = [parameter.name for parameter in fields(self) if parameter.default is not None]
        store_floats(self, others, optional=kinds, prefix="drive.")
        given = [name for name in kinds if getattr(self, name) is not None]
        if len(given) != 1:
            raise InvalidInput(
                "drive",
                f"must have exactly one of {', '.join(kinds[:-1])} and {kinds[-1]}",
                f"{', '.join(given) or 'none'}",
            )
        for name in others:
            if self.creepage is None and getattr(self, name) != 0.0:
                raise InvalidInput(f"drive.{name}", "must be 0 without drive.creepage", repr(getattr(self, name)))

    def _to_core(self) -> _core.Drive:
        return _core.Drive(**{name: value for name, value in asdict(self).items() if value is not None})


UNITS.update({parameter.name: parameter.metadata["unit"] for parameter in fields(Drive)})
