"""Options of the computation of a history, shared by `RollingHistory`, `roll` and motion files."""

from __future__ import annotations

import inspect
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar

from .. import _core
from .._core import Compliance, Curvature
from .._support.arguments import as_int, as_member, require_type, store_floats
from .._support.errors import InvalidInput
from ..bodies import Drive, Mesh
from ..ground import Axle, Profile

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["HistoryKeywords", "HistoryOptions", "with_options"]

_Target = TypeVar("_Target", bound="Callable[..., Any]")

#: Placeholder for the options in a docstring, and the heading above the options in the docstring of `HistoryOptions`.
_PLACEHOLDER, _HEAD = "**options\n    Same as in `HistoryOptions`.\n", "Parameters\n----------\n"


class HistoryKeywords(TypedDict, total=False):
    """Options as passed to a function, for type checkers: one entry for each of `HistoryOptions`."""

    mesh: Mesh | None
    compliance: Compliance | str
    curvature: Curvature | str
    friction: float
    drive: Drive
    mass: float
    center_speed: float
    ground: Profile | None
    tread: Profile | None
    axle: Axle | None
    averaged_meshes: int
    steps_per_spacing: int | None
    spectrum_tolerance: float
    threads: int


@dataclass(frozen=True, slots=True, kw_only=True)
class HistoryOptions:
    """Options of the computation of a history, with checked types.

    Parameters
    ----------
    mesh : Mesh, optional
        Surface mesh. By default 16 nodes across the contact at rest, for a roller 48.
    compliance : Compliance or str, default Compliance.RADIAL
        Compliance in the contact condition, same as in `viscoroll.solve`; VERTICAL only for a ball on the rigid plane.
    curvature : Curvature or str, default Curvature.SPHERE
        Curvature terms in the equations of the layers of balls: SPHERE or PAPER.
    friction : float, default 0
        Coulomb's coefficient of friction μ between the two bodies [-], in [0, 4]. With friction, a step takes several
        times as long (docs/theory/transient-friction.md).
    drive : Drive, default Drive(force=0.0)
        Horizontal force on the center, or driving torque about it; with a torque of 0 the body is towed. A given
        creepage is not allowed; use `center_displacement` instead.
    mass : float, default 0
        Mass that moves with the center [kg], ≥ 0; requires friction and a given force Q on the center. Q minus the
        force of the contact is mass times acceleration. If Q exceeds friction, the body slides, which is not an error.
    center_speed : float, default 0
        Initial speed of the center, forward [m/s]; used only with a mass.
    ground : Profile, optional
        Height of the ground along the track, over the distance r_o ψ; by default smooth. With friction, the ground
        keeps its position where the center moves farther than the body rolls.
    tread : Profile, optional
        Height of the tread around the rolling body; by default smooth. The distances are in [0, 2π r_o], or the
        profile repeats a whole number of times. A height describes flat spots, shallow texture and runout well. Deep
        lugs are softer than the model, because they also bulge and bend.
    axle : Axle, optional
        Mass, spring and damper between the body and a frame. The load is then the external force on the axle. By
        default the load acts on the contact itself.
    averaged_meshes : int, default 4
        Number of meshes, each shifted by an equal fraction of the node spacing, over which results are averaged, in
        [1, 16]. A single mesh is four times as fast, but its torque varies with the position of its nodes.
    steps_per_spacing : int or None, default 4
        Number of time steps while the body turns by one node spacing, in [1, 64]; at standstill each step is a tenth
        longer than the one before. None: one step to each waypoint, and to the end of each `advance`.
    spectrum_tolerance : float, default 0.01
        Largest relative error of the compliance due to discrete retardation times [-]. For layers with different
        relaxation functions, it determines the number of times and therefore the cost of a step.
    threads : int, default 0
        Number of threads; 0 for all cores.
    """

    mesh: Mesh | None = None
    compliance: Compliance = Compliance.RADIAL
    curvature: Curvature = Curvature.SPHERE
    friction: float = 0.0
    drive: Drive = Drive(force=0.0)  # noqa: RUF009  (immutable)
    mass: float = 0.0
    center_speed: float = 0.0
    ground: Profile | None = None
    tread: Profile | None = None
    axle: Axle | None = None
    averaged_meshes: int = 4
    steps_per_spacing: int | None = 4
    spectrum_tolerance: float = 0.01
    threads: int = 0

    def __post_init__(self) -> None:
        """Convert the types; the core checks the values."""
        require_type("mesh", self.mesh, Mesh, optional=True)
        require_type("drive", self.drive, Drive)
        require_type("ground", self.ground, Profile, optional=True)
        require_type("tread", self.tread, Profile, optional=True)
        require_type("axle", self.axle, Axle, optional=True)
        if self.drive.force is None and self.drive.torque is None:
            raise InvalidInput(
                "drive", "must be a force or a torque in transient rolling; prescribe center_displacement instead"
            )
        store_floats(self, [option.name for option in fields(self) if option.type == "float"])
        for name, kind in (("compliance", Compliance), ("curvature", Curvature)):
            object.__setattr__(self, name, as_member(name, getattr(self, name), kind))
        for option in fields(self):
            value = getattr(self, option.name)
            if option.type == "int" or (option.type == "int | None" and value is not None):
                object.__setattr__(self, option.name, as_int(option.name, value))

    def _to_core(self, *, shortest_time: float, longest_time: float) -> _core.HistoryOptions:
        values = {option.name: getattr(self, option.name) for option in fields(self)}
        values |= {
            "mesh": None if self.mesh is None else self.mesh._to_core(),
            "driving_force": self.drive.force or 0.0,
        }
        values["driving_torque"] = self.drive.torque
        for name in ("ground", "tread", "axle"):
            values[name] = values[name] and values[name]._to_core()
        values |= {"shortest_time": shortest_time, "longest_time": longest_time}
        del values["drive"]
        return _core.HistoryOptions(**values)


def with_options(target: _Target) -> _Target:
    """Replace ``**options`` in the signature and docstring of a function or class by those of `HistoryOptions`."""
    function: Any = target.__init__ if isinstance(target, type) else target  # type: ignore[misc]
    signature = inspect.signature(function)
    named = [parameter for parameter in signature.parameters.values() if parameter.name != "options"]
    options = [
        parameter.replace(annotation=HistoryKeywords.__annotations__[name].__forward_arg__)
        for name, parameter in inspect.signature(HistoryOptions).parameters.items()
    ]
    function.__signature__ = signature.replace(parameters=[*named, *options])
    if target.__doc__ and HistoryOptions.__doc__:  # python -OO has none
        descriptions = inspect.cleandoc(HistoryOptions.__doc__).partition(_HEAD)[2]
        target.__doc__ = inspect.cleandoc(target.__doc__).replace(_PLACEHOLDER, f"{descriptions}\n")
    return target
