"""Counterbodies of balls, rollers and wheels: planes, half-spaces, grooves, and rotating bodies."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import viscoroll as vr
from viscoroll import enums

from .bodies import deforms
from .materials import draw_modulus, modulus_at

__all__ = ["elsewhere"]

#: Smallest relative clearance of a groove; the library requires 2 %.
_CLOSEST_FIT = 0.03


def elsewhere(
    rng: np.random.Generator, body: vr.bodies.RollingBody, size: float, time: float, arguments: dict[str, Any]
) -> dict[str, Any]:
    """Return a body and its arguments on a counterbody other than the rigid plane: coated, or rigid.

    Parameters
    ----------
    rng : Generator
        Separate random numbers for this choice.
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        The body that rolls on a plane.
    size : float
        Half length of the contact there [m].
    time : float
        Time in which material crosses the contact [s].
    arguments : dict
        Arguments of `viscoroll.solve` for the plane.
    """
    speed = arguments["angular_speed"] * body.outer_radius
    mesh = arguments.get("mesh")
    ground = _Ground(rng, body, size, time, speed, 1000 if mesh is None else mesh.nodes_per_revolution)
    kinds = ["plane", "plane", "half-space", "groove", "rigid groove"]
    if not isinstance(body, vr.CoatedSphere):  # other code draws balls on balls
        kinds += ["body", "body"]
    kind = rng.choice(kinds)
    moved = kind in ("plane", "groove", "body") and rng.random() < 0.35
    layers = list(body.layers) if moved else ground.layers()
    if kind != "body":
        layers = [_held(layer) for layer in layers]
    on: Any
    match kind:
        case "plane":
            on = vr.CoatedPlane(layers=layers)
        case "half-space":
            on = vr.CoatedPlane(layers=layers if rng.random() < 0.5 else [], base=_held(ground.half_space()))
        case "groove":
            on = vr.Groove(layers=layers, **ground.radii())
        case "rigid groove":
            on = vr.Groove(**ground.radii())
        case _:
            on = ground.body(layers if moved or rng.random() < 0.6 else [])
    if moved:
        body = _rigid(body)
    if not deforms(on):
        return {"body": body, "arguments": arguments | {"on": on}}
    changed: dict[str, Any] = {
        "on": on,
        "compliance": enums.Compliance.RADIAL,
        "patch_load": enums.PatchLoad.FLAT,
    }
    if mesh is not None:  # a plane has a continuous spectrum
        changed["mesh"] = replace(mesh, max_order=None)
    return {"body": body, "arguments": arguments | changed}


def _held(material: Any) -> Any:
    """Return a material with held extrapolation: a plane has waves of any low frequency, unlike a revolution."""
    if not isinstance(material.shear_modulus, vr.MasterCurve):
        return material
    held = replace(material.shear_modulus, extrapolation=enums.Extrapolation.HOLD)
    return replace(material, shear_modulus=held)


def _rigid(body: Any) -> Any:
    return replace(body, core_radius=body.outer_radius, layers=[], **_CORE.get(type(body), {}))


#: Arguments that are fixed for a rigid body.
_CORE: dict[type, dict[str, Any]] = {vr.CoatedSphere: {"inner_boundary": enums.InnerBoundary.RIGID}}


class _Ground:
    """Random counterbodies with a separate generator."""

    def __init__(self, rng: np.random.Generator, body: Any, size: float, time: float, speed: float, nodes: int) -> None:
        self._rng, self._body, self._size, self._time, self._speed = rng, body, size, time, speed
        self._nodes = nodes
        self._softest = min(abs(modulus_at(layer.shear_modulus, 1.0 / time)) for layer in body.layers)

    def layers(self) -> list[vr.Layer]:
        """Return one or two layers, in total 0.1 to 10 contact lengths thick."""
        count = int(self._rng.choice([1, 2], p=[0.7, 0.3]))
        thickness = 2.0 * self._size * 10.0 ** self._rng.uniform(-1.0, 1.0) / count
        return [vr.Layer(thickness=thickness, **self._material()) for _ in range(count)]

    def half_space(self) -> vr.HalfSpace:
        """Return a half-space."""
        return vr.HalfSpace(**self._material())

    def radii(self) -> dict[str, float]:
        """Return at least one of the radii of curvature across and along the path, concave or convex."""
        along = self._body.outer_radius
        across = along if self._body.crown_radius is None else self._body.crown_radius
        which = "path_radius" if self._is_roller else self._rng.choice(["radius", "path_radius", "both"])
        radii = {}
        if which != "path_radius":
            radii["radius"] = self._curved(across)
        if which != "radius":
            radii["path_radius"] = self._curved(along)
        return radii

    def _curved(self, own: float) -> float:
        rng = self._rng
        if np.isinf(own):  # a flat tread needs a convex counterbody
            return -self._body.outer_radius * float(10.0 ** rng.uniform(0.0, 2.0))
        if rng.random() < 0.3:
            return -own * float(10.0 ** rng.uniform(-0.5, 1.5))
        return own * (1.0 + _CLOSEST_FIT + float(10.0 ** rng.uniform(-1.5, 1.0)))

    def body(self, layers: list[vr.Layer]) -> vr.CoatedCylinder | vr.CoatedWheel:
        """Return another roller, or for a wheel another wheel or a roller."""
        rng = self._rng
        # The number of nodes per revolution is an integer on both bodies.
        nodes = min(max(16, round(self._nodes * 10.0 ** rng.uniform(-0.5, 1.0))), 1_000_000)
        radius = self._body.outer_radius * nodes / self._nodes
        thickness = sum(layer.thickness for layer in layers)
        core_radius = radius - thickness if thickness < 0.9 * radius else radius
        if self._is_roller or rng.random() < 0.4:
            return vr.CoatedCylinder(core_radius=core_radius, layers=layers)
        # A crowned hub, and a width independent of that of the other wheel.
        width = self._body.width * (1.0 if rng.random() < 0.3 else 10.0 ** rng.uniform(-0.3, 0.5))
        crown_radius = np.inf if rng.random() < 0.5 else max(width, thickness) * float(10.0 ** rng.uniform(0.0, 2.0))
        sides = enums.Sides.FREE if layers and rng.random() < 0.2 else enums.Sides.UNBOUNDED
        return vr.CoatedWheel(
            core_radius=core_radius,
            layers=layers,
            width=width,
            crown_radius=crown_radius,
            hub=enums.Hub.CROWNED,
            sides=sides,
        )

    @property
    def _is_roller(self) -> bool:
        return isinstance(self._body, vr.CoatedCylinder)

    def _material(self) -> dict[str, Any]:
        rng = self._rng
        modulus = self._softest * 10.0 ** rng.uniform(-0.5, 2.0)
        poisson_ratio = 0.5 if rng.random() < 0.4 else rng.uniform(0.0, 0.5)
        # The speed is at most a third of the shear wave's.
        density = min(2000.0, 0.1 * modulus / self._speed**2) * rng.uniform() if rng.random() < 0.3 else 0.0
        return {
            "shear_modulus": draw_modulus(rng, modulus, self._time, self._speed / self._body.outer_radius),
            "poisson_ratio": float(poisson_ratio),
            "density": float(density),
        }
