"""Balls on balls: the other body of a case, and equivalent descriptions of a pair, also of rollers."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import viscoroll as vr
from viscoroll import enums

from .bodies import with_loads
from .materials import draw_modulus, modulus_at

__all__ = ["on_a_ball", "on_its_mirror", "swapped"]

#: Modulus of a nearly rigid plane [Pa]; other moduli go up to 1e12.
_MIRROR = 1e22


def on_a_ball(
    rng: np.random.Generator, ball: vr.CoatedSphere, time: float, arguments: dict[str, Any]
) -> dict[str, Any]:
    """Return a ball and its arguments on another ball: an identical one, a coated one, or with one rigid ball.

    Parameters
    ----------
    rng : Generator
        Separate random numbers for this choice.
    ball : CoatedSphere
        The ball that rolls on a plane.
    time : float
        Time in which material crosses the contact [s].
    arguments : dict
        Arguments of `viscoroll.solve` for the plane.
    """
    kind = rng.choice(["alike", "coated", "rigid", "coated under a rigid one"], p=[0.2, 0.5, 0.15, 0.15])
    radius = ball.outer_radius
    # The distances between nodes are equal on both balls, for either order of the balls.
    mesh = arguments.get("mesh")
    nodes = 1000 if mesh is None else mesh.nodes_per_revolution
    wanted = 1.0 if kind == "alike" else 10.0 ** rng.uniform(-0.5, 1.0)
    ratio = min(max(16, round(nodes * wanted)), 1_000_000) / nodes
    # Numbers of the first ball that are not integers on the other are left out.
    if mesh:
        numbers = {name: getattr(mesh, name) for name in ("theta_nodes_per_revolution", "max_order")}
        broken = {name: None for name, number in numbers.items() if number and (ratio * number) % 1.0 > 0.0}
        arguments = arguments | {"mesh": replace(mesh, **broken)}
    other = _other(rng, kind, ball, ratio * radius, time, arguments["angular_speed"])
    # relative radius / radius of the first ball
    share = ratio / (1.0 + ratio)
    changed: dict[str, Any] = {
        "compliance": enums.Compliance.RADIAL,
        "patch_load": enums.PatchLoad.FLAT,
    }
    given = with_loads(arguments | changed, share) | {"on": other}
    if kind == "coated under a rigid one":
        ball, given = swapped(ball, given)
    return {"body": ball, "arguments": given}


def _other(
    rng: np.random.Generator, kind: str, ball: vr.CoatedSphere, radius: float, time: float, speed: float
) -> vr.CoatedSphere:
    if kind == "alike":
        return ball
    if kind != "coated":
        return vr.CoatedSphere(core_radius=radius)
    thickness = radius * 10.0 ** rng.uniform(-2.0, -0.1)
    softest = min(abs(modulus_at(layer.shear_modulus, 1.0 / time)) for layer in ball.layers)
    modulus = softest * 10.0 ** rng.uniform(-1.0, 2.0)
    layer = vr.Layer(
        thickness=thickness,
        shear_modulus=draw_modulus(rng, modulus, time, speed * ball.outer_radius / radius),
        poisson_ratio=0.5 if rng.random() < 0.4 else rng.uniform(0.0, 0.5),
    )
    return vr.CoatedSphere(core_radius=radius - thickness, layers=[layer])


def swapped(body: Any, arguments: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
    """Return the same pair with exchanged bodies, at the same nodes."""
    other = arguments["on"]
    ratio = other.outer_radius / body.outer_radius
    changed = {"on": body, "angular_speed": arguments["angular_speed"] / ratio}
    if mesh := arguments.get("mesh"):
        numbers = {
            name: None if (n := getattr(mesh, name)) is None else max(16, round(n * ratio))
            for name in ("nodes_per_revolution", "theta_nodes_per_revolution", "max_order")
        }
        changed["mesh"] = vr.Mesh(**numbers)
    return other, arguments | changed


def on_its_mirror(arguments: dict[str, Any]) -> dict[str, Any]:
    """Return a ball's arguments on the nearly rigid plane between it and an identical ball.

    Its nodes lie on a paraboloid, as between two balls.
    """
    plane = vr.CoatedPlane(
        layers=[vr.Layer(thickness=1.0, shear_modulus=vr.Elastic(modulus=_MIRROR), poisson_ratio=0.3)]
    )
    return arguments | {"on": plane}
