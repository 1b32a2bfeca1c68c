"""What balls, rollers and wheels roll on: planes, half-spaces, grooves and bodies that turn as well."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import viscoroll as vr

from .bodies import deforms
from .materials import draw_modulus, modulus_at

__all__ = ["elsewhere"]

#: A groove is at least so much wider than what rolls in it: 2 % are asked for.
_CLOSEST_FIT = 0.03


def elsewhere(
    rng: np.random.Generator, body: vr.bodies.RollingBody, size: float, time: float, arguments: dict[str, Any]
) -> dict[str, Any]:
    """Return a body of a case and its arguments on something else than the rigid plane: coated, or rigid itself.

    Parameters
    ----------
    rng : Generator
        Of the case, for this alone.
    body : CoatedSphere, CoatedCylinder or CoatedWheel
        What rolls on a plane.
    size : float
        Half the length of the contact there [m].
    time : float
        That material takes to cross it [s].
    arguments : dict
        Of `viscoroll.solve`, for the plane.
    """
    speed = arguments["angular_speed"] * body.outer_radius
    mesh = arguments.get("mesh")
    ground = _Ground(rng, body, size, time, speed, 1000 if mesh is None else mesh.nodes_per_revolution)
    kinds = ["plane", "plane", "half-space", "groove", "rigid groove"]
    if not isinstance(body, vr.CoatedSphere):  # balls on balls are drawn apart
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
        return {"ball": body, "arguments": arguments | {"on": on}}
    changed: dict[str, Any] = {
        "on": on,
        "compliance": vr.Compliance.RADIAL,
        "patch_load": vr.PatchLoad.FLAT,
    }
    if mesh is not None:  # a plane's orders are not whole
        changed["mesh"] = replace(mesh, max_order=None)
    return {"ball": body, "arguments": arguments | changed}


def _held(material: Any) -> Any:
    """Return a material of a plane: its orders, other than those of a revolution, go down to any frequency."""
    if not isinstance(material.shear_modulus, vr.MasterCurve):
        return material
    held = replace(material.shear_modulus, extrapolation=vr.Extrapolation.HOLD)
    return replace(material, shear_modulus=held)


def _rigid(body: Any) -> Any:
    return replace(body, core_radius=body.outer_radius, layers=[], **_CORE.get(type(body), {}))


#: What a rigid body has no choice of.
_CORE: dict[type, dict[str, Any]] = {vr.CoatedSphere: {"inner_boundary": vr.InnerBoundary.RIGID}}


class _Ground:
    """What a body may roll on, by a generator of its own."""

    def __init__(self, rng: np.random.Generator, body: Any, size: float, time: float, speed: float, nodes: int) -> None:
        self._rng, self._body, self._size, self._time, self._speed = rng, body, size, time, speed
        self._nodes = nodes
        self._softest = min(abs(modulus_at(layer.shear_modulus, 1.0 / time)) for layer in body.layers)

    def layers(self) -> list[vr.Layer]:
        """Return one layer or two, from a contact's tenth to ten of them thick together."""
        count = int(self._rng.choice([1, 2], p=[0.7, 0.3]))
        thickness = 2.0 * self._size * 10.0 ** self._rng.uniform(-1.0, 1.0) / count
        return [vr.Layer(thickness=thickness, **self._material()) for _ in range(count)]

    def half_space(self) -> vr.HalfSpace:
        """Return material without end."""
        return vr.HalfSpace(**self._material())

    def radii(self) -> dict[str, float]:
        """Return radii of curvature across the path and along it, one of them at least: hollow or bulging."""
        along, across = self._body.outer_radius, getattr(self._body, "crown_radius", self._body.outer_radius)
        which = "path_radius" if self._is_roller else self._rng.choice(["radius", "path_radius", "both"])
        radii = {}
        if which != "path_radius":
            radii["radius"] = self._curved(across)
        if which != "radius":
            radii["path_radius"] = self._curved(along)
        return radii

    def _curved(self, own: float) -> float:
        rng = self._rng
        if np.isinf(own):  # under a flat tread nothing is hollow
            return -self._body.outer_radius * float(10.0 ** rng.uniform(0.0, 2.0))
        if rng.random() < 0.3:
            return -own * float(10.0 ** rng.uniform(-0.5, 1.5))
        return own * (1.0 + _CLOSEST_FIT + float(10.0 ** rng.uniform(-1.5, 1.0)))

    def body(self, layers: list[vr.Layer]) -> vr.CoatedCylinder | vr.CoatedWheel:
        """Return another roller, or under a wheel a wheel or a roller."""
        rng = self._rng
        # As many nodes a revolution as are whole.
        nodes = min(max(16, round(self._nodes * 10.0 ** rng.uniform(-0.5, 1.0))), 1_000_000)
        radius = self._body.outer_radius * nodes / self._nodes
        thickness = sum(layer.thickness for layer in layers)
        core_radius = radius - thickness if thickness < 0.9 * radius else radius
        if self._is_roller or rng.random() < 0.4:
            return vr.CoatedCylinder(core_radius=core_radius, layers=layers)
        # Crowned hubs and faces as far off as those of the wheel above, or farther.
        width = self._body.width * (1.0 if rng.random() < 0.3 else 10.0 ** rng.uniform(-0.3, 0.5))
        crown_radius = np.inf if rng.random() < 0.5 else max(width, thickness) * float(10.0 ** rng.uniform(0.0, 2.0))
        sides = vr.Sides.FREE if layers and rng.random() < 0.2 else vr.Sides.ENDLESS
        return vr.CoatedWheel(
            core_radius=core_radius,
            layers=layers,
            width=width,
            crown_radius=crown_radius,
            hub=vr.Hub.CROWNED,
            sides=sides,
        )

    @property
    def _is_roller(self) -> bool:
        return isinstance(self._body, vr.CoatedCylinder)

    def _material(self) -> dict[str, Any]:
        rng = self._rng
        modulus = self._softest * 10.0 ** rng.uniform(-0.5, 2.0)
        poisson_ratio = 0.5 if rng.random() < 0.4 else rng.uniform(0.0, 0.5)
        # Speeds up to a third of the shear wave's.
        density = min(2000.0, 0.1 * modulus / self._speed**2) * rng.uniform() if rng.random() < 0.3 else 0.0
        return {
            "shear_modulus": draw_modulus(rng, modulus, self._time, self._speed / self._body.outer_radius),
            "poisson_ratio": float(poisson_ratio),
            "density": float(density),
        }
