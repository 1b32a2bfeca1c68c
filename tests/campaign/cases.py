"""Random cases of steady solves, drawn from a seed and a number."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from typing import Any, ClassVar

import numpy as np
import viscoroll as vr
from viscoroll import enums

from .balls import Geometry, draw_ball, draw_depth, draw_moduli, load_of
from .bodies import as_roller, materials, on_a_wheel
from .counterbodies import elsewhere
from .pairs import on_a_ball

__all__ = ["Case", "draw", "source"]


@dataclass(frozen=True, kw_only=True)
class Case:
    """Arguments of one solve.

    Attributes
    ----------
    call : str
        Name of the function of `viscoroll`.
    name : str
        "SEED:NUMBER".
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        The rolling body.
    arguments : dict
        The other arguments.
    unphysical_argument : str
        Name of the argument that must be rejected, or the empty text.
    """

    call: ClassVar[str] = "solve"
    name: str
    body: vr.bodies.RollingBody
    arguments: dict[str, Any] = field(default_factory=dict)
    unphysical_argument: str = ""

    @property
    def on(self) -> vr.bodies.Counterbody | None:
        """Return the counterbody, or None for the rigid plane."""
        return self.arguments.get("on")

    @property
    def materials(self) -> list[vr.Layer | vr.HalfSpace]:
        """Return the layers of both bodies, and a half-space below them."""
        return [*materials(self.body), *(materials(self.on) if self.on else ())]

    @property
    def thickness(self) -> float:
        """Total thickness of the layers, infinite on a half-space [m]."""
        return sum(getattr(material, "thickness", math.inf) for material in self.materials)

    @property
    def has_friction(self) -> bool:
        """Return whether the case has friction."""
        return float(self.arguments.get("friction", 0.0)) > 0.0

    def source(self) -> str:
        """Return the call as Python text, after the imports that `tests.campaign` prints."""
        arguments = {name: value for name, value in self.arguments.items() if name != "threads"}
        given = ", ".join(f"{name}={source(value)}" for name, value in arguments.items())
        return f"{self.call}({source(self.body)}, {given})"


def source(value: Any) -> str:
    """Return Python text that creates the value, only with fields that differ from their defaults."""
    if isinstance(value, Enum):
        return f"{type(value).__name__}.{value.name}"
    if is_dataclass(value):
        given = {f.name: getattr(value, f.name) for f in fields(value)}
        told = {f.name for f in fields(value) if np.ndim(given[f.name]) > 0 or given[f.name] != f.default}
        return f"{type(value).__name__}({', '.join(f'{name}={source(given[name])}' for name in given if name in told)})"
    if isinstance(value, tuple | list | np.ndarray):
        return f"[{', '.join(source(v) for v in value)}]"
    if isinstance(value, float):
        return repr(float(value)) if math.isfinite(value) else f'float("{value}")'
    return repr(value)


def draw(seed: int, number: int) -> Case:
    """Return a random case."""
    rng = np.random.default_rng([seed, number])
    geometry = Geometry.draw(rng)
    depth = draw_depth(rng, geometry)
    contact_radius = 1.2 * math.sqrt(geometry.radius * depth)
    moduli = draw_moduli(rng, len(geometry.thicknesses))
    densities = rng.uniform(0.0, 2000.0, len(moduli)) if rng.random() < 0.5 else np.zeros(len(moduli))
    speed = 10.0 ** rng.uniform(-3.0, 2.0)
    if densities.max() > 0.0:  # fraction of the slowest shear wave's speed
        speed = min(speed, 10.0 ** rng.uniform(-3.0, -0.4) * math.sqrt(min(moduli) / 2000.0) / geometry.radius)
    time = contact_radius / (geometry.radius * speed)
    ball = draw_ball(rng, geometry, moduli, densities, time, speed)
    load = load_of(ball, geometry, depth, 1.0 / time)
    friction = 0.0 if rng.random() < 0.4 else _friction(rng)
    arguments: dict[str, Any] = {
        "load": load,
        "angular_speed": speed,
        "friction": friction,
        "drive": _drive(rng, friction, load, geometry.radius, contact_radius),
        "compliance": enums.Compliance.RADIAL if rng.random() < 0.5 else enums.Compliance.VERTICAL,
        "patch_load": enums.PatchLoad.SPHERICAL if rng.random() < 0.2 else enums.PatchLoad.FLAT,
        "threads": 1,
    }
    # separate random numbers keep the rest of the case unchanged
    if hasattr(vr, "Curvature"):
        members = list(enums.Curvature)
        arguments["curvature"] = members[np.random.default_rng([seed, number, 1]).integers(len(members))]
    arguments |= _resolution(rng, geometry.radius / contact_radius)
    unphysical_argument = _make_unphysical(rng, arguments)
    drawn: dict[str, Any] = {"body": ball, "arguments": arguments}
    apart = np.random.default_rng([seed, number, 2])  # separate, as above
    if apart.random() < _WHEELS and geometry.inner_boundary is enums.InnerBoundary.RIGID:
        drawn = on_a_wheel(apart, ball, contact_radius, arguments)
    elif (apart := np.random.default_rng([seed, number, 3])).random() < _PAIRS:
        drawn = on_a_ball(apart, ball, time, arguments)
    # with 4 and 5, cases that are cited elsewhere would change
    apart = np.random.default_rng([seed, number, 6])
    if "on" not in drawn["arguments"] and apart.random() < _ELSEWHERE:
        drawn = _elsewhere(apart, contact_radius, time, unphysical_argument, **drawn)
    return Case(name=f"{seed}:{number}", unphysical_argument=unphysical_argument, **drawn)


#: Share of the balls and wheels on the rigid plane that become rollers, or get another counterbody, or both.
_ELSEWHERE = 0.45

#: Share of the balls that roll on another ball.
_PAIRS = 0.25

#: Share of the cases on a rigid core whose layers become the tread of a wheel.
_WHEELS = 0.2


def _elsewhere(
    rng: np.random.Generator,
    contact_radius: float,
    time: float,
    unphysical_argument: str,
    body: vr.CoatedSphere | vr.CoatedWheel,
    arguments: dict[str, Any],
) -> dict[str, Any]:
    """Return a body and its arguments: half of the cored balls become rollers, most get another counterbody."""
    drawn: dict[str, Any] = {"body": body, "arguments": arguments}
    is_roller = rng.random() < 0.5 and getattr(body, "inner_boundary", None) is enums.InnerBoundary.RIGID
    if is_roller:
        drawn = as_roller(body, contact_radius, arguments)
    # A slope under the pressure adds force, so drives that are impossible on the rigid plane may be possible elsewhere.
    if unphysical_argument not in ("drive.force", "drive.torque") and not (is_roller and rng.random() < 0.3):
        drawn = elsewhere(rng, drawn["body"], contact_radius, time, drawn["arguments"])
    drive = drawn["arguments"]["drive"]
    if not is_roller and arguments["friction"] > 0.0 and drive.creepage is not None and rng.random() < 0.5:
        spin = 10.0 ** rng.uniform(-3.0, 0.3) / body.outer_radius * rng.choice([-1.0, 1.0])
        drawn["arguments"] = drawn["arguments"] | {"drive": replace(drive, spin=float(spin))}
    return drawn


def _friction(rng: np.random.Generator) -> float:
    """Return a coefficient of friction up to 4, or, one time in twenty, infinity."""
    friction = 10.0 ** rng.uniform(math.log10(0.003), math.log10(6.0))
    return friction if friction <= 4.0 else math.inf


def _drive(rng: np.random.Generator, friction: float, load: float, radius: float, contact_radius: float) -> vr.Drive:
    creepage = contact_radius / radius * 10.0 ** rng.uniform(-4.0, 0.0) * rng.choice([-1.0, 1.0])
    if friction == 0.0:
        return vr.Drive(force=0.0) if rng.random() < 0.8 else vr.Drive(creepage=creepage)
    share = rng.uniform(-0.95, 0.95)
    match rng.choice(6, p=[0.25, 0.15, 0.15, 0.1, 0.2, 0.15]):
        case 0:
            return vr.Drive(force=0.0)
        case 1:
            # few forces exceed the load
            most = min(friction, 4.0) if rng.random() < 0.3 else min(friction, 1.0)
            return vr.Drive(force=share * most * load)
        case 2:
            return vr.Drive(torque=0.0)
        case 3:
            return vr.Drive(torque=share * min(friction, 1.0) * load * radius)
        case 4:
            return vr.Drive(creepage=creepage)
        case _:
            lateral = contact_radius / radius * 10.0 ** rng.uniform(-4.0, 0.0) * rng.choice([-1.0, 1.0])
            return vr.Drive(creepage=creepage * rng.choice([0.0, 1.0]), lateral_creepage=lateral)


def _resolution(rng: np.random.Generator, radii_per_contact: float) -> dict[str, Any]:
    """Return a mesh with 5 to 25 nodes across the contact, or an accuracy."""
    if rng.random() < 0.3:
        return {"accuracy": 10.0 ** rng.uniform(math.log10(0.02), math.log10(0.3))}
    across = rng.uniform(5.0, 25.0)
    nodes = min(max(16, round(math.pi * radii_per_contact * across)), 1_000_000)
    theta = round(nodes * 2.0 ** rng.uniform(-1.0, 1.0)) if rng.random() < 0.2 else None
    order = math.ceil(max(nodes, theta or 0) * rng.uniform(0.5, 2.0)) if nodes < 1000 and rng.random() < 0.15 else None
    if theta is not None:
        theta = min(max(16, theta), 1_000_000)
    return {"mesh": vr.Mesh(nodes_per_revolution=nodes, theta_nodes_per_revolution=theta, max_order=order)}


def _make_unphysical(rng: np.random.Generator, arguments: dict[str, Any]) -> str:
    """Sometimes make one argument impossible, or the load tiny.

    Returns
    -------
    str
        Name of the argument that must be rejected.
    """
    kind = rng.random()
    if kind < 0.03:
        arguments["load"] *= 10.0 ** rng.uniform(6.0, 12.0)
        return "load"
    if kind < 0.06 and arguments["drive"] in (vr.Drive(force=0.0), vr.Drive(torque=0.0)):
        # on a given mesh, the contact is a single node
        arguments["load"] *= 10.0 ** rng.uniform(-8.0, -2.0)
    elif kind < 0.08 and arguments["friction"] > 0.0:
        arguments["drive"] = vr.Drive(force=rng.uniform(1.0, 10.0) * arguments["friction"] * arguments["load"])
        return "drive.force"
    elif kind < 0.1 and arguments["friction"] > 0.0:
        # [N m], for any ball here
        radius_bound = 1e4 * max(arguments["friction"], 1.0) * arguments["load"]
        arguments["drive"] = vr.Drive(torque=rng.choice([-1.0, 1.0]) * radius_bound)
        return "drive.torque"
    return ""
