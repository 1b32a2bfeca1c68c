"""The random cases: what is solved, drawn from a seed and a number."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from typing import Any

import numpy as np
import viscoroll as vr

from .materials import draw_modulus, modulus_at, scaled_modulus
from .pairs import on_a_ball

__all__ = ["Case", "draw", "source"]


@dataclass(frozen=True, kw_only=True)
class Case:
    """One solve.

    Attributes
    ----------
    name : str
        "SEED:NUMBER".
    ball : CoatedSphere or CoatedWheel
        What rolls.
    arguments : dict
        The other arguments of `viscoroll.solve`.
    absurd : str
        Name of the argument that must be refused, or the empty text.
    """

    name: str
    ball: vr.CoatedSphere | vr.CoatedWheel
    arguments: dict[str, Any] = field(default_factory=dict)
    absurd: str = ""

    @property
    def on(self) -> vr.CoatedSphere | None:
        """The other ball, where it rolls on one."""
        return self.arguments.get("on")

    @property
    def layers(self) -> list[vr.Layer]:
        """Return the layers of both bodies."""
        return [*self.ball.layers, *(self.on.layers if self.on else ())]

    @property
    def has_friction(self) -> bool:
        """Whether stick and slip are to be found."""
        return float(self.arguments["friction"]) > 0.0

    def source(self) -> str:
        """Return the call as Python text, after ``from viscoroll import *``."""
        arguments = {name: value for name, value in self.arguments.items() if name != "threads"}
        given = ", ".join(f"{name}={source(value)}" for name, value in arguments.items())
        return f"solve({source(self.ball)}, {given})"


def source(value: Any) -> str:
    """Return Python text that makes the value, with fields that differ from their defaults only."""
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
    """Return a case of a campaign."""
    rng = np.random.default_rng([seed, number])
    geometry = _Geometry.draw(rng)
    depth = _depth(rng, geometry)
    contact_radius = 1.2 * math.sqrt(geometry.radius * depth)
    moduli = _moduli(rng, len(geometry.thicknesses))
    densities = rng.uniform(0.0, 2000.0, len(moduli)) if rng.random() < 0.5 else np.zeros(len(moduli))
    speed = 10.0 ** rng.uniform(-3.0, 2.0)
    if densities.max() > 0.0:  # a share of the slowest shear wave
        speed = min(speed, 10.0 ** rng.uniform(-3.0, -0.4) * math.sqrt(min(moduli) / 2000.0) / geometry.radius)
    time = contact_radius / (geometry.radius * speed)
    layers = [
        vr.Layer(thickness=thickness, shear_modulus=material, density=float(density), **_volume(rng, modulus))
        for thickness, modulus, material, density in zip(
            geometry.thicknesses, moduli, _materials(rng, moduli, time, speed), densities, strict=True
        )
    ]
    ball = vr.CoatedSphere(core_radius=geometry.core_radius, layers=layers, inner_boundary=geometry.inner_boundary)
    load = _load(ball, geometry, depth, 1.0 / time)
    friction = 0.0 if rng.random() < 0.4 else _friction(rng)
    arguments: dict[str, Any] = {
        "load": load,
        "angular_speed": speed,
        "friction": friction,
        "drive": _drive(rng, friction, load, geometry.radius, contact_radius),
        "compliance": vr.Compliance.RADIAL if rng.random() < 0.5 else vr.Compliance.VERTICAL,
        "patch_load": vr.PatchLoad.SPHERICAL if rng.random() < 0.2 else vr.PatchLoad.FLAT,
        "threads": 1,
    }
    if hasattr(vr, "Curvature"):  # drawn apart, so that the rest of a case is what it was without
        members = list(vr.Curvature)
        arguments["curvature"] = members[np.random.default_rng([seed, number, 1]).integers(len(members))]
    arguments |= _resolution(rng, geometry.radius / contact_radius)
    absurd = _make_absurd(rng, arguments)
    apart = np.random.default_rng([seed, number, 2])  # as above
    if apart.random() < _WHEELS and geometry.inner_boundary is vr.InnerBoundary.RIGID:
        return Case(name=f"{seed}:{number}", absurd=absurd, **_on_a_wheel(apart, ball, contact_radius, arguments))
    apart = np.random.default_rng([seed, number, 3])
    if apart.random() < _PAIRS:
        return Case(name=f"{seed}:{number}", absurd=absurd, **on_a_ball(apart, ball, time, arguments))
    return Case(name=f"{seed}:{number}", ball=ball, arguments=arguments, absurd=absurd)


#: Share of the balls that roll on another one.
_PAIRS = 0.25

#: Share of the cases on a rigid core in which its layers are the tread of a wheel.
_WHEELS = 0.2


def _on_a_wheel(
    rng: np.random.Generator, ball: vr.CoatedSphere, contact_radius: float, arguments: dict[str, Any]
) -> dict[str, Any]:
    """Return a wheel with the layers of a ball, and its arguments: about as much load for each width of the contact."""
    width = contact_radius * 10.0 ** rng.uniform(-0.3, 1.0)
    is_flat = rng.random() < 0.4
    # The crown falls by so much to the faces, and lies within the outermost layer, as straight hubs need it.
    drop = min(0.8 * ball.layers[-1].thickness, 0.5 * width) * 10.0 ** rng.uniform(-1.5, 0.0)
    crown_radius = math.inf if is_flat else (0.25 * width**2 + drop**2) / (2.0 * drop)
    wheel = vr.CoatedWheel(
        core_radius=ball.core_radius,
        layers=ball.layers,
        width=width,
        crown_radius=crown_radius,
        hub=vr.Hub.STRAIGHT if rng.random() < 0.5 else vr.Hub.CROWNED,
        sides=vr.Sides.FREE if rng.random() < 0.3 else vr.Sides.ENDLESS,
    )
    wider = min(math.sqrt(crown_radius / ball.outer_radius), 0.5 * width / contact_radius)
    drive = arguments["drive"]
    pulled = {name: None if (f := getattr(drive, name)) is None else f * wider for name in ("force", "torque")}
    mesh = arguments.get("mesh")
    changed = {
        "load": arguments["load"] * wider,
        "drive": replace(drive, **pulled),
        "curvature": vr.Curvature.SPHERE,
        "patch_load": vr.PatchLoad.FLAT,
        **({} if mesh is None else {"mesh": replace(mesh, max_order=None)}),
    }
    return {"ball": wheel, "arguments": arguments | changed}


@dataclass(frozen=True, kw_only=True)
class _Geometry:
    radius: float
    core_radius: float
    thicknesses: list[float]
    inner_boundary: vr.InnerBoundary

    @property
    def thickness(self) -> float:
        return sum(self.thicknesses)

    @classmethod
    def draw(cls, rng: np.random.Generator) -> _Geometry:
        radius = 10.0 ** rng.uniform(-3.0, 0.0)
        boundary = rng.choice([0, 1, 2], p=[0.7, 0.15, 0.15])
        inner_boundary = (vr.InnerBoundary.RIGID, vr.InnerBoundary.HOLLOW, vr.InnerBoundary.SOLID)[boundary]
        solid = inner_boundary is vr.InnerBoundary.SOLID
        thickness = radius if solid else radius * 10.0 ** rng.uniform(-3.0, math.log10(0.9))
        count = int(rng.choice([1, 2, 3], p=[0.55, 0.3, 0.15]))
        shares = 0.05 + rng.dirichlet(np.ones(count))
        thicknesses = (thickness * shares / shares.sum()).tolist()
        return cls(
            radius=radius,
            core_radius=0.0 if solid else radius - thickness,
            thicknesses=thicknesses,
            inner_boundary=inner_boundary,
        )


def _depth(rng: np.random.Generator, geometry: _Geometry) -> float:
    """Return the penetration to aim at: 0.1 to 40 % of the thickness, with contacts of at most half a radius."""
    depth = geometry.thickness * 10.0 ** rng.uniform(-3.0, math.log10(0.4))
    return min(depth, 0.15 * geometry.radius)


def _moduli(rng: np.random.Generator, count: int) -> list[float]:
    """Return moduli [Pa] with a contrast of up to 1e4."""
    contrast = rng.uniform(0.0, 4.0) if rng.random() < 0.7 else 0.0
    exponents = rng.uniform(4.0, 10.0) + contrast * rng.uniform(-0.5, 0.5, count)
    return [float(modulus) for modulus in 10.0**exponents]


def _materials(rng: np.random.Generator, moduli: list[float], time: float, speed: float) -> list[Any]:
    """Return materials of these moduli, of kinds of their own or with one relaxation function."""
    if rng.random() < 0.5:
        return [draw_modulus(rng, modulus, time, speed) for modulus in moduli]
    common = draw_modulus(rng, moduli[0], time, speed)
    return [scaled_modulus(common, stress=modulus / moduli[0], time=1.0) for modulus in moduli]


def _volume(rng: np.random.Generator, modulus: float) -> dict[str, float]:
    match rng.choice(5, p=[0.35, 0.3, 0.2, 0.05, 0.1]):
        case 0:
            return {"poisson_ratio": 0.5}
        case 1:
            return {"poisson_ratio": rng.uniform(0.0, 0.5)}
        case 2:
            return {"poisson_ratio": rng.uniform(-0.99, 0.0)}
        case 3:
            return {"poisson_ratio": 0.5 - 10.0 ** rng.uniform(-8.0, -2.0)}
        case _:
            return {"bulk_modulus": modulus * 10.0 ** rng.uniform(-1.0, 4.0)}


def _load(ball: vr.CoatedSphere, geometry: _Geometry, depth: float, frequency: float) -> float:
    """Return a load [N] that should press the ball about so deep: that of the softest layer alone."""
    radius, thickness = geometry.radius, geometry.thickness
    softest = min(abs(modulus_at(layer.shear_modulus, frequency)) for layer in ball.layers)
    hertz = 8.0 / 3.0 * softest * math.sqrt(radius * depth**3)
    bonded = math.pi * softest * radius * depth**2 / thickness  # incompressible thin layers bear more
    if geometry.inner_boundary is vr.InnerBoundary.HOLLOW:
        return min(hertz, 4.0 * softest * thickness**2 * depth / radius)  # a shell bends
    return hertz if geometry.inner_boundary is vr.InnerBoundary.SOLID else hertz + bonded


def _friction(rng: np.random.Generator) -> float:
    """Return a coefficient up to 4, or, one time in twenty, an infinite one."""
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
            most = min(friction, 4.0) if rng.random() < 0.3 else min(friction, 1.0)  # few pull more than the load
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


def _make_absurd(rng: np.random.Generator, arguments: dict[str, Any]) -> str:
    """Now and then, make one argument impossible, or the load tiny.

    Returns
    -------
    str
        The name of what must be refused.
    """
    kind = rng.random()
    if kind < 0.03:
        arguments["load"] *= 10.0 ** rng.uniform(6.0, 12.0)
        return "load"
    if kind < 0.06 and arguments["drive"] in (vr.Drive(force=0.0), vr.Drive(torque=0.0)):
        arguments["load"] *= 10.0 ** rng.uniform(-8.0, -2.0)  # in a contact of a single node where a mesh is given
    elif kind < 0.08 and arguments["friction"] > 0.0:
        arguments["drive"] = vr.Drive(force=rng.uniform(1.0, 10.0) * arguments["friction"] * arguments["load"])
        return "drive.force"
    elif kind < 0.1 and arguments["friction"] > 0.0:
        radius_bound = 1e4 * max(arguments["friction"], 1.0) * arguments["load"]  # [N m], of any ball here
        arguments["drive"] = vr.Drive(torque=rng.choice([-1.0, 1.0]) * radius_bound)
        return "drive.torque"
    return ""
