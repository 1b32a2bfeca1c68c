"""What moves the ball along the plane."""

from __future__ import annotations

from dataclasses import dataclass, field, fields

from .. import _core
from .._support.arguments import store_floats
from .._support.tables import ParameterTable
from .._support.units import UNITS

__all__ = ["Drive"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Drive(ParameterTable):
    """What is given besides load and angular speed of rolling with friction: exactly one of force, torque and creepage.

    Parameters
    ----------
    force : float, optional
        Q, horizontal force on the center, forward [N], smaller than friction times load in magnitude. With 0 a torque
        alone drives the ball.
    torque : float, optional
        T, driving torque about the axis of rolling [N m]. With 0 the ball is towed.
    creepage : float, optional
        V_s / (Ω r_o) - 1 [-], where V_s is the speed of the center.
    lateral_creepage : float, default 0
        Sideways speed of the center per Ω r_o [-]; only with `creepage`.
    spin : float, default 0
        Turning of the ball about the downward axis through the contact per Ω r_o [1/m]; only with `creepage`.

    Raises
    ------
    TypeError
        For values that are not real numbers.
    ValueError
        Unless exactly one of the three is given.

    Examples
    --------
    >>> Drive(torque=0.0)
    Drive(force=None, torque=0.0, creepage=None, lateral_creepage=0.0, spin=0.0)
    """

    force: float | None = field(default=None, metadata={"unit": "N"})
    torque: float | None = field(default=None, metadata={"unit": "N m"})
    creepage: float | None = field(default=None, metadata={"unit": "1"})
    lateral_creepage: float = field(default=0.0, metadata={"unit": "1"})
    spin: float = field(default=0.0, metadata={"unit": "1/m"})

    def __post_init__(self) -> None:
        """Store the numbers as floats and check the parameters."""
        store_floats(self, ("lateral_creepage", "spin"), optional=("force", "torque", "creepage"), prefix="drive.")
        given = [name for name in ("force", "torque", "creepage") if getattr(self, name) is not None]
        if len(given) != 1:
            raise ValueError(
                f"drive must have exactly one of force, torque and creepage, got {', '.join(given) or 'none'}"
            )
        for name in ("lateral_creepage", "spin"):
            if self.creepage is None and getattr(self, name) != 0.0:
                raise ValueError(f"drive.{name} must be 0 without drive.creepage, got {getattr(self, name)!r}")
        self._to_core()

    def _to_core(self) -> _core.DriveForce | _core.DriveTorque | _core.DriveCreepage:
        if self.force is not None:
            return _core.DriveForce(self.force)
        if self.torque is not None:
            return _core.DriveTorque(self.torque)
        assert self.creepage is not None
        return _core.DriveCreepage(creepage=self.creepage, lateral_creepage=self.lateral_creepage, spin=self.spin)


UNITS.update({parameter.name: parameter.metadata["unit"] for parameter in fields(Drive)})
