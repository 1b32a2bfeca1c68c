"""Random histories: body, counterbody, motion and steps, drawn from a seed and a number."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import viscoroll as vr
from viscoroll import enums

from ..balls import Geometry, draw_ball, draw_depth, draw_moduli, load_of
from ..bodies import as_roller, curvature, on_a_wheel
from ..cases import Case
from ..counterbodies import elsewhere
from ..pairs import on_a_ball
from .motions import Motion, draw_motion

__all__ = ["HistoryCase", "draw"]

#: Moduli with known retardation spectra; few other ones, tables and functions, can be fitted well enough.
_DISCRETE = (vr.Elastic, vr.StandardLinearSolid, vr.Prony, vr.materials.KelvinVoigt, vr.materials.FractionalZener)

#: Least total thickness of the layers / radius, so that 200 nodes per revolution put some nodes in the contact.
_THINNEST = 0.05

#: Largest penetration / radius, for contacts of a quarter of the radius to each side.
_DEEPEST = 0.05


@dataclass(frozen=True, kw_only=True)
class HistoryCase(Case):
    """Arguments of one history."""

    call: ClassVar[str] = "roll"

    @property
    def moduli(self) -> list[Any]:
        """Return the shear moduli of both bodies."""
        return [material.shear_modulus for material in self.materials]

    @property
    def is_followed(self) -> bool:
        """Return whether all retardation times are discrete, and no jump meets a missing instantaneous compliance."""
        viscous = any(isinstance(modulus, vr.materials.KelvinVoigt) for modulus in self.moduli)
        jumps = self.arguments["start"] is enums.Start.UNDEFORMED or 0.0 in np.diff(self.arguments["time"])
        fitted = any(not isinstance(modulus, _DISCRETE) for modulus in self.moduli)
        return not fitted and not (viscous and (jumps or len(self.moduli) > 1))


def draw(seed: int, number: int) -> HistoryCase:
    """Return a random history, in most cases of suitable materials, which are rare among all kinds."""
    for attempt in itertools.count():
        rng = np.random.default_rng([seed, number, 7, attempt])
        case = _draw(rng, f"{seed}:{number}")
        # the tables of a wheel for dozens of fitted times take a minute
        is_quick = not isinstance(case.body, vr.CoatedWheel)
        if case.is_followed or (is_quick and rng.random() < _ANY):
            return case
    raise AssertionError


#: Share of the draws with other materials that are kept.
_ANY = 0.03


def _draw(rng: np.random.Generator, name: str) -> HistoryCase:
    geometry = Geometry.draw(rng, thinnest=_THINNEST)
    depth = min(max(draw_depth(rng, geometry), 0.05 * geometry.thickness), _DEEPEST * geometry.radius)
    contact_radius = 1.2 * math.sqrt(geometry.radius * depth)
    moduli = draw_moduli(rng, len(geometry.thicknesses))
    speed = 10.0 ** rng.uniform(-2.0, 2.0)
    time = contact_radius / (geometry.radius * speed)
    ball = draw_ball(rng, geometry, moduli, np.zeros(len(moduli)), time, speed)
    nodes = round(math.pi * geometry.radius / contact_radius * rng.uniform(3.0, 12.0))
    arguments: dict[str, Any] = {
        "load": load_of(ball, geometry, depth, 1.0 / time),
        "angular_speed": speed,
        "drive": vr.Drive(force=0.0),
        "mesh": vr.Mesh(nodes_per_revolution=min(max(60, nodes), 200)),
    }
    drawn = _bodies(rng, ball, contact_radius, time, arguments)
    motion = draw_motion(rng, turn=contact_radius / geometry.radius, time=time, load=drawn["arguments"]["load"])
    given = drawn["arguments"]
    changed = {
        **({"on": given["on"]} if "on" in given else {}),
        "time": motion.time,
        "angle": motion.angle,
        "load": motion.load,
        "start": enums.Start.RELAXED if rng.random() < 0.5 else enums.Start.UNDEFORMED,
        "mesh": given["mesh"],
        "averaged_meshes": int(rng.choice([1, 2, 4], p=[0.5, 0.4, 0.1])),
        "steps_per_spacing": int(rng.choice([2, 4, 8], p=[0.2, 0.6, 0.2])),
        # Both times depend on the whole motion, whether or not it is followed at once.
        "shortest_time": (motion.time[-1] - motion.time[0]) * 10.0 ** rng.uniform(-6.0, -3.0),
        "longest_time": (motion.time[-1] - motion.time[0]) * 10.0,
        "threads": 1,
    }
    if isinstance(drawn["body"], vr.CoatedSphere) and rng.random() < 0.15:
        changed["curvature"] = enums.Curvature.PAPER
    case = HistoryCase(name=name, body=drawn["body"], arguments=changed)
    case.arguments.update(_along(rng, case, motion, depth, time))
    unphysical_argument = _make_unphysical(rng, case.arguments)
    return replace(case, unphysical_argument=unphysical_argument)


def _bodies(
    rng: np.random.Generator, ball: vr.CoatedSphere, contact_radius: float, time: float, arguments: dict[str, Any]
) -> dict[str, Any]:
    """Return a ball, a roller or a wheel with these layers, and its counterbody."""
    drawn: dict[str, Any] = {"body": ball, "arguments": arguments}
    has_core = ball.inner_boundary is enums.InnerBoundary.RIGID
    shape = rng.choice(["ball", "roller", "wheel"], p=[0.4, 0.35, 0.25]) if has_core else "ball"
    if shape == "roller":
        drawn = as_roller(ball, contact_radius, arguments)
    elif shape == "wheel":
        drawn = on_a_wheel(rng, ball, contact_radius, arguments)
    if shape == "ball" and rng.random() < 0.25:
        return on_a_ball(rng, ball, time, arguments)
    if rng.random() < 0.7:
        return elsewhere(rng, drawn["body"], contact_radius, time, drawn["arguments"])
    return drawn


def _along(rng: np.random.Generator, case: HistoryCase, motion: Motion, depth: float, time: float) -> dict[str, Any]:
    """Return a consistent choice of friction, drive of the center and compliance, possibly empty."""
    is_ball_on_plane = isinstance(case.body, vr.CoatedSphere) and case.on is None
    compliance = {"compliance": enums.Compliance.VERTICAL} if is_ball_on_plane and rng.random() < 0.3 else {}
    if rng.random() < 0.6:
        return compliance
    friction = 10.0 ** rng.uniform(-1.3, 0.3)
    least = min(motion.load)
    given: dict[str, Any] = {"friction": friction, **compliance}
    kinds = ["free", "towed", "led"]
    if not motion.lifts:
        kinds += ["pushed"]
    # otherwise the paths of center and contact differ in length
    if curvature(case.on) == 0.0:
        kinds += ["mass"]
    match rng.choice(kinds):
        case "towed":
            given["drive"] = vr.Drive(torque=0.0)
        case "led":
            creepage = depth / case.body.outer_radius * 10.0 ** rng.uniform(-2.0, 0.5) * rng.choice([-1.0, 1.0])
            displacement = (1.0 + creepage) * case.body.outer_radius * (np.array(motion.angle) - motion.angle[0])
            given["center_displacement"] = displacement.tolist()
        case "pushed":
            given["drive"] = vr.Drive(force=rng.uniform(-0.9, 0.9) * min(friction, 1.0) * least)
        case "mass":
            load = motion.load[0]
            given["mass"] = load * time**2 / depth * 10.0 ** rng.uniform(0.0, 2.0)
            given["drive"] = vr.Drive(force=rng.uniform(-2.0, 2.0) * min(friction, 1.0) * load)
            given["center_speed"] = case.body.outer_radius * 0.1 * rng.uniform(-1.0, 1.0) / time
    return given


#: Changes that must be rejected, by the argument that the message names.
_UNPHYSICAL: dict[str, Any] = {
    "load": lambda a: {"load": [1e9 * load for load in a["load"]]},
    "load[": lambda a: {"load": [*a["load"][:-1], -a["load"][0]]},
    "time[": lambda a: {"time": [*a["time"][:-1], a["time"][0] - 1.0]},
    "angle[": lambda a: {"angle": [*a["angle"][:-1], math.inf]},
    "friction": lambda _: {"friction": math.inf},
    "averaged_meshes": lambda _: {"averaged_meshes": 17},
    "steps_per_spacing": lambda _: {"steps_per_spacing": 0},
    "spectrum_tolerance": lambda _: {"spectrum_tolerance": 1.0},
    "mass": lambda _: {"mass": 1.0, "friction": 0.0, "drive": vr.Drive(force=0.0), "center_displacement": None},
    "curvature": lambda _: {"curvature": enums.Curvature.EXACT},
}


def _make_unphysical(rng: np.random.Generator, arguments: dict[str, Any]) -> str:
    """Sometimes make one argument impossible.

    Returns
    -------
    str
        Beginning of the message of the rejection.
    """
    if rng.random() >= 0.08:
        return ""
    name = str(rng.choice(list(_UNPHYSICAL)))
    arguments.update(_UNPHYSICAL[name](arguments))
    return name
