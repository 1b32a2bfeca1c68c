"""How a history is computed: the options that `RollingHistory`, `roll` and motion files have in common."""

from __future__ import annotations

import inspect
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar

from .. import _core
from .._core import Compliance, Curvature
from .._support.arguments import as_int, as_member, require_type, store_floats
from ..bodies import Drive, Mesh

if TYPE_CHECKING:
    from collections.abc import Callable

__all__ = ["HistoryKeywords", "HistoryOptions", "with_options"]

_Target = TypeVar("_Target", bound="Callable[..., Any]")

#: What stands for the options in a docstring, and before them in that of `HistoryOptions`.
_PLACE, _HEAD = "**options\n    As of `HistoryOptions`.\n", "Parameters\n----------\n"


class HistoryKeywords(TypedDict, total=False):
    """Options as they may be given, for type checkers: a line for each of `HistoryOptions`."""

    mesh: Mesh | None
    compliance: Compliance | str
    curvature: Curvature | str
    friction: float
    drive: Drive
    mass: float
    center_speed: float
    lattices: int
    steps_per_spacing: int | None
    spectrum_tolerance: float
    threads: int


@dataclass(frozen=True, slots=True, kw_only=True)
class HistoryOptions:
    """Options, checked.

    Parameters
    ----------
    mesh : Mesh, optional
        Surface mesh; by default 16 nodes across the contact at rest, of a roller 48.
    compliance : Compliance or str, default Compliance.RADIAL
        As of `viscoroll.solve`; RADIAL but for a ball on the rigid plane.
    curvature : Curvature or str, default Curvature.SPHERE
        SPHERE or PAPER, of balls.
    friction : float, default 0
        Coulomb's coefficient μ between the two bodies [-], in [0, 4]. With it a step takes six to
        twelve times as long.
    drive : Drive, default Drive(force=0.0)
        Horizontal force on the center, or driving torque about it: with a torque of 0 the body is towed. A given
        creepage is refused here, and `center_way` given instead.
    mass : float, default 0
        Of what moves with the center, with friction and a force Q on it [kg], ≥ 0: Q less the contact's own is mass ×
        acceleration. Then a force that exceeds friction is no error: the ball slides.
    center_speed : float, default 0
        Of the center with its mass at the first instant, forward [m/s].
    lattices : int, default 4
        Lattices of nodes, each shifted by a share of the spacing, that are averaged, in [1, 16]. One is four times as
        fast, and its torque carries the staircase of the nodes.
    steps_per_spacing : int or None, default 4
        Steps of time while the body turns by a spacing, in [1, 64]; at standstill steps grow by a tenth. None: one
        step to each knot, and to the end of each `advance`.
    spectrum_tolerance : float, default 0.01
        Largest relative error with which discrete retardation times may stand for the compliance [-]. Of layers that
        share no relaxation function, it decides how many times are followed, and so what a step costs.
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
    lattices: int = 4
    steps_per_spacing: int | None = 4
    spectrum_tolerance: float = 0.01
    threads: int = 0

    def __post_init__(self) -> None:
        """Settle the types; the core checks the values."""
        require_type("mesh", self.mesh, Mesh, optional=True)
        require_type("drive", self.drive, Drive)
        if self.drive.creepage is not None:
            raise ValueError(
                "drive must be a force or a torque in transient rolling; a given speed is a center_way over time"
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
        values |= {"shortest_time": shortest_time, "longest_time": longest_time}
        del values["drive"]
        options = _core.HistoryOptions()
        for name, value in values.items():
            setattr(options, name, value)
        return options


def with_options(target: _Target) -> _Target:
    """Show keywords and paragraphs of `HistoryOptions` where a function or a class takes ``**options``."""
    function: Any = target.__init__ if isinstance(target, type) else target  # type: ignore[misc]
    signature = inspect.signature(function)
    named = [parameter for parameter in signature.parameters.values() if parameter.name != "options"]
    options = [
        parameter.replace(annotation=HistoryKeywords.__annotations__[name].__forward_arg__)
        for name, parameter in inspect.signature(HistoryOptions).parameters.items()
    ]
    function.__signature__ = signature.replace(parameters=[*named, *options])
    if target.__doc__ and HistoryOptions.__doc__:  # python -OO has none
        told = inspect.cleandoc(HistoryOptions.__doc__).partition(_HEAD)[2]
        target.__doc__ = inspect.cleandoc(target.__doc__).replace(_PLACE, f"{told}\n")
    return target
