"""Wheels and rollers with the layers of a ball, and properties of any body."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import viscoroll as vr
from viscoroll import enums

__all__ = ["as_roller", "curvature", "deforms", "materials", "on_a_wheel", "with_loads"]


def deforms(on: vr.bodies.Counterbody | None) -> bool:
    """Return whether the counterbody deforms."""
    return on is not None and bool(materials(on))


def materials(body: Any) -> tuple[Any, ...]:
    """Return the layers and the half-space below them."""
    base = getattr(body, "base", None)
    return (*body.layers, *(() if base is None else (base,)))


def curvature(on: vr.bodies.Counterbody | None) -> float:
    """Return the curvature of the counterbody along the path, negative if concave [1/m]."""
    if isinstance(on, vr.Groove):
        return 0.0 if on.path_radius is None else -1.0 / on.path_radius
    return 0.0 if on is None or isinstance(on, vr.CoatedPlane) else 1.0 / on.outer_radius


def with_loads(arguments: dict[str, Any], factor: float) -> dict[str, Any]:
    """Return arguments with load, driving force and driving torque multiplied."""
    drive = arguments["drive"]
    driven = {name: None if (f := getattr(drive, name)) is None else f * factor for name in ("force", "torque")}
    return arguments | {"load": arguments["load"] * factor, "drive": replace(drive, **driven)}


def as_roller(ball: vr.CoatedSphere, contact_radius: float, arguments: dict[str, Any]) -> dict[str, Any]:
    """Return a roller with the layers of a ball on a core, and its arguments: about the same load per length."""
    mesh = arguments.get("mesh")
    changed: dict[str, Any] = {"curvature": enums.Curvature.SPHERE, "patch_load": enums.PatchLoad.FLAT}
    if mesh is not None:
        changed["mesh"] = replace(mesh, theta_nodes_per_revolution=None)
    drive = arguments["drive"]
    if drive.lateral_creepage:  # a line contact has no lateral creepage
        changed["drive"] = replace(drive, lateral_creepage=0.0)
    roller = vr.CoatedCylinder(core_radius=ball.core_radius, layers=ball.layers)
    return {"body": roller, "arguments": with_loads(arguments | changed, 0.5 / contact_radius)}


def on_a_wheel(
    rng: np.random.Generator, ball: vr.CoatedSphere, contact_radius: float, arguments: dict[str, Any]
) -> dict[str, Any]:
    """Return a wheel with the layers of a ball, and its arguments: about the same load per width of the contact."""
    width = contact_radius * 10.0 ** rng.uniform(-0.3, 1.0)
    is_flat = rng.random() < 0.4
    # Drop of the crown at the faces. It lies within the outermost layer, as straight hubs require.
    drop = min(0.8 * ball.layers[-1].thickness, 0.5 * width) * 10.0 ** rng.uniform(-1.5, 0.0)
    crown_radius = math.inf if is_flat else (0.25 * width**2 + drop**2) / (2.0 * drop)
    wheel = vr.CoatedWheel(
        core_radius=ball.core_radius,
        layers=ball.layers,
        width=width,
        crown_radius=crown_radius,
        hub=enums.Hub.STRAIGHT if rng.random() < 0.5 else enums.Hub.CROWNED,
        sides=enums.Sides.FREE if rng.random() < 0.3 else enums.Sides.UNBOUNDED,
    )
    wider = min(math.sqrt(crown_radius / ball.outer_radius), 0.5 * width / contact_radius)
    mesh = arguments.get("mesh")
    changed = {
        "curvature": enums.Curvature.SPHERE,
        "patch_load": enums.PatchLoad.FLAT,
        **({} if mesh is None else {"mesh": replace(mesh, max_order=None)}),
    }
    return {"body": wheel, "arguments": with_loads(arguments | changed, wider)}
