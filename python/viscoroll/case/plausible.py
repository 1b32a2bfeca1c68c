"""Sizes of bodies in files that are probably in millimeters, and what an angular speed means at the surface."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator

from .._support.errors import InvalidInput
from ..bodies import Counterbody, Layer, RollingBody

__all__ = ["require_plausible", "require_plausible_width", "speed_text", "speed_warning", "thick_layers"]

# Limits of sizes. A length in millimeters that is read as meters is 1000 times as large, so that a limit of 4 m rejects
# mistakes from 4 mm on. Real bodies remain below: drying cylinders of paper machines have radii up to 3.5 m and widths
# up to 12 m, tires of dump trucks radii of 2 m and rubber 0.3 m thick, road layers thicknesses below 1 m.
_LARGEST_BALL = 1.5  # radius [m]
_LARGEST_RADIUS = 4.0  # of rollers, wheels and their core [m]
_LARGEST_WIDTH = 15.0  # [m]
_LARGEST_COVER = 0.4  # thickness of a layer of a rolling body [m]
_LARGEST_GROUND = 1.0  # thickness of a layer of a plane or groove [m]

# Limits of ratios, for small bodies of which only one length has the wrong unit.
_WIDEST = 100.0  # width over outer radius, if the width exceeds 2 m: rollers of conveyors have up to 40
_THICKEST = 8.0  # thickness over radius of the core, if the thickness exceeds 0.05 m
_FLATTEST = 100.0  # radius of a groove over that of the body, if it exceeds 4 m: dishes of platforms have up to 50
_SMALLEST_CROWN = 2e-6  # height of a crown [m], if its radius exceeds 10 m: less than the roughness of a soft tread

#: Speed of the surface above which a warning asks to check the unit: faster than paper machines and conveyors [m/s].
_LARGEST_SPEED = 35.0


def require_plausible(
    name: str,
    body: RollingBody,
    other_name: str | None,
    other: Counterbody | None,
    *,
    by_diameter: Collection[str | None] = (),
) -> None:
    """Raise an InvalidInput if a length of one of two bodies is probably in millimeters.

    Parameters
    ----------
    name, other_name : str
        Tables of the rolling body and the counterbody in the file.
    body, other : body
        Rolling body and counterbody.
    by_diameter : collection of str
        Tables that give the outer diameter in place of the radius of the core.
    """
    found = [*_implausible(name, body, body.outer_radius, name in by_diameter)]
    if other_name is not None and other is not None:
        found += _implausible(other_name, other, body.outer_radius, other_name in by_diameter)
    if not found:
        return
    path, length, reason = found[0]
    others = [f"{other_path} = {other:g} m" for other_path, other, _ in found[1:]]
    raise InvalidInput(
        path,
        f"must be {reason}, unless allow_large = true is written at the beginning of the file",
        f"{length:g} m",
        more=_in_millimeters(length) + (f"; also implausible: {', '.join(others)}" if others else ""),
    )


def require_plausible_width(path: str, width: float, outer_radius: float) -> None:
    """Raise an InvalidInput if a width [m] at a path of the file is probably in millimeters."""
    if reason := _too_wide(width, outer_radius):
        rule = f"must be {reason}, unless allow_large = true is written at the beginning of the file"
        raise InvalidInput(path, rule, f"{width:g} m", more=_in_millimeters(width))


def thick_layers(layers: Iterable[Layer]) -> Iterator[str]:
    """Yield a hint for each layer of a rolling body whose thickness is probably in millimeters."""
    for j, layer in enumerate(layers):
        if layer.thickness > _LARGEST_COVER:
            yield f"layers[{j}].thickness is {layer.thickness:g} m: {_in_millimeters(layer.thickness)}"


def speed_text(angular_speed: float, outer_radius: float) -> str:
    """Return an angular speed [rad/s] as the speed of the surface and in revolutions per minute."""
    speed = angular_speed * outer_radius
    return f"surface at {speed:.4g} m/s ({3.6 * speed:.4g} km/h), {angular_speed * 30.0 / math.pi:.4g} rpm"


def speed_warning(angular_speed: float, outer_radius: float) -> str:
    """Return a warning about an implausible angular speed [rad/s], or an empty string."""
    if abs(angular_speed) * outer_radius <= _LARGEST_SPEED:
        return ""
    meaning = speed_text(angular_speed, outer_radius)
    return f'angular_speed = {angular_speed:g} rad/s: {meaning}; if revolutions per minute were meant, write "... rpm"'


def _in_millimeters(length: float) -> str:
    return f'if millimeters were meant, write "{abs(length):g} mm"'


def _implausible(
    name: str, body: RollingBody | Counterbody, outer_radius: float, by_diameter: bool
) -> Iterator[tuple[str, float, str]]:
    """Yield path, length [m] and rule of each implausible length of a body."""
    rolls = hasattr(body, "outer_radius")
    limit = _LARGEST_BALL if hasattr(body, "inner_boundary") else _LARGEST_RADIUS
    if (core := getattr(body, "core_radius", 0.0)) > limit:
        if by_diameter:
            yield f"{name}.outer_diameter", 2.0 * body.outer_radius, f"at most {2.0 * limit:g} m"  # type: ignore[union-attr]
        else:
            yield f"{name}.core_radius", core, f"at most {limit:g} m"
    thickest = _LARGEST_COVER if rolls else _LARGEST_GROUND
    for j, layer in enumerate(body.layers):
        path = f"{name}.layers[{j}].thickness"
        if layer.thickness > thickest:
            yield path, layer.thickness, f"at most {thickest:g} m"
        elif layer.thickness > 0.05 and 0.0 < _THICKEST * core < layer.thickness:
            yield path, layer.thickness, f"at most {_THICKEST:g} times the radius of the core"
    if rolls:
        outer_radius = getattr(body, "outer_radius", outer_radius)
        width, crown = getattr(body, "width", None) or 0.0, getattr(body, "crown_radius", None) or math.inf
        if reason := _too_wide(width, outer_radius):
            yield f"{name}.width", width, reason
        elif 10.0 < crown < math.inf and width * width / (8.0 * crown) < _SMALLEST_CROWN:
            yield f"{name}.crown_radius", crown, "so small that the crown is at least 2 µm high"
    for key in ("radius", "path_radius"):
        radius = getattr(body, key, None) or math.inf
        if not rolls and max(4.0, _FLATTEST * outer_radius) < abs(radius) < math.inf:
            yield f"{name}.{key}", radius, f"at most {_FLATTEST:g} times the radius of the rolling body"


def _too_wide(width: float, outer_radius: float) -> str:
    """Return the rule that a width [m] violates, or an empty string."""
    if width > _LARGEST_WIDTH:
        return f"at most {_LARGEST_WIDTH:g} m"
    return f"at most {_WIDEST:g} times the outer radius" if width > max(2.0, _WIDEST * outer_radius) else ""
