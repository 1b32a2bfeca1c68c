"""Twins of a case, whose solutions follow from the solution of the case, and the quantities that must agree."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
import viscoroll as vr
from numpy.typing import NDArray
from viscoroll import enums

from .cases import Case
from .invariants import depth_of
from .materials import scaled_modulus
from .pairs import on_its_mirror, swapped

__all__ = ["Twin", "at_its_penetration", "twins"]

#: Factors of length, stress and time in the scaled twin. Products with powers of two are exact, so a difference
#: indicates that the solver contains a constant with a unit.
LENGTH, STRESS, TIME = 2.0**-9, 2.0**13, 2.0**7

#: Tolerances relative to the largest value of each kind. Divided layers and mirrored tables have other round-off, and
#: the solver stops at residuals of 1e-8 or less.
SCALING_TOLERANCE = 1e-8
TOLERANCE = 1e-6

#: Tolerance of a pair with exchanged bodies. The rolling body determines the octaves of orders, so the exchanged pair
#: has sums over other orders.
PAIR_TOLERANCE = 1e-5

#: Largest relative change of a result if the bodies are exchanged, per relative centrifugal growth d/R of the pair.
#: Nodes have equal spacings on the rolling body at rest, which are larger in contact by its growth factor s = 1 + d/R.
#: The gap curvature of the exchanged pair is therefore larger by the factor (s_2/s_1)^2. The penetration is
#: proportional to its power 1/3 (thick), 1/2 (thin) or 2/3 (thin and incompressible), so it changes by 2/3, 1 or 4/3 of
#: the growth; measured: 0.74, 0.99 and 1.22. Moments also change with the position of nodes relative to the edge of the
#: contact, by at most 2.0 with 48 nodes in contact; they are allowed twice this.
CHANGE_PER_GROWTH = {"penetration": 4.0 / 3.0, "resisting_torque": 4.0, "bulk_power": 4.0}

#: Tolerance of divided layers in a tread with faces: elements of its section end where layers do, and are accurate to
#: some 1e-4. Tractions summed from a face inwards have this accuracy. At single nodes closer to the face than a
#: sixteenth of the thickness, which is the element size there, they are accurate to 4 % (case 58 of seed 73, with
#: elements of 1/16 and 1/64 of the thickness).
ELEMENT_TOLERANCE = 1e-3

#: Tolerance of load and torque with the exact sphere if the penetration of a solution is given instead of its load. The
#: solver then chooses the window from a different estimate of the contact. The size of the tables changes results of
#: the exact sphere by up to 1e-5 (`viscoroll.RollingModel`), those of other bodies by 1e-7. On the same window loads
#: agree to 1e-9 (test_penetration.py).
EXACT_LOAD_TOLERANCE = 2e-5

#: Radius of a groove, in radii of the rolling body, at which it acts as a plane: its relative curvature is the inverse.
WIDE = 1e9

#: Exponents of length, stress and time by which the results scale; results per length have one power of length less.
SCALARS = {
    "resisting_torque": (3, 1, 0),
    "driving_torque": (3, 1, 0),
    "driving_force": (2, 1, 0),
    "penetration": (1, 0, 0),
    "contact_area": (2, 0, 0),
    "bulk_power": (3, 1, -1),
    "slip_power": (3, 1, -1),
}
FIELDS = {"pressure": (0, 1, 0), "gap": (1, 0, 0), "shear_traction": (0, 1, 0)}
NEVER_PER_LENGTH = {"penetration", *FIELDS}


@dataclass(frozen=True, kw_only=True)
class Twin:
    """A case whose solution follows from that of another.

    Attributes
    ----------
    kind : str
        Name of the transformation.
    case : Case
        The transformed case.
    differences : callable
        Called with the solutions of the case and of the twin; returns those differences that exceed the tolerance, by
        name, in multiples of the tolerance.
    """

    kind: str
    case: Case
    differences: Callable[[vr.Result, vr.Result], dict[str, float]]


def twins(case: Case) -> Iterator[Twin]:
    """Yield all twins of the case."""
    yield Twin(kind="scaling", case=_scaled(case), differences=_scaling_differences)
    body = case.body if case.body.layers else case.on
    wheel = body if isinstance(body, vr.CoatedWheel) else None
    # On a straight hub, only the outermost layer becomes thinner towards the faces, so half of it is another tread.
    if body.layers and not (wheel and wheel.hub is enums.Hub.STRAIGHT):
        by_elements = wheel is not None and wheel.sides is enums.Sides.FREE
        differences = partial(_differences, allowed=ELEMENT_TOLERANCE, summed=True) if by_elements else _differences
        yield Twin(kind="split layer", case=_split(case), differences=differences)
    if isinstance(case.on, vr.CoatedPlane):
        yield from _planes(case, case.on)
    elif _is_exchangeable(case):
        yield Twin(kind="swap", case=_swapped(case), differences=_swap_differences)
        if case.on == case.body:
            mirror = replace(case, arguments=on_its_mirror(case.arguments))
            yield Twin(kind="mirror plane", case=mirror, differences=_mirror_differences)
    drive = case.arguments["drive"]
    if drive.lateral_creepage or drive.spin:
        mirrored = replace(drive, lateral_creepage=-drive.lateral_creepage, spin=-drive.spin)
        yield Twin(
            kind="mirror",
            case=replace(case, arguments=case.arguments | {"drive": mirrored}),
            differences=partial(_differences, mirrored=True),
        )


def at_its_penetration(case: Case, result: vr.Result) -> Iterator[Twin]:
    """Yield the case with the penetration of its solution instead of the load."""
    # Without a given mesh, the window of the solution follows from the contact on a coarser mesh; a solve with this
    # mesh alone would choose another one.
    if result.penetration is None or "mesh" not in case.arguments:
        return
    given = {name: value for name, value in case.arguments.items() if name != "load"}
    given |= {"penetration": result.penetration}
    yield Twin(kind="penetration", case=replace(case, arguments=given), differences=_load_differences)


def _load_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    """Return differences of load and torque."""
    allowed = EXACT_LOAD_TOLERANCE if one.curvature is enums.Curvature.EXACT else TOLERANCE
    scales = {"load": one.load, "resisting_torque": _scales(one)["resisting_torque"], "penetration": depth_of(one)}
    found = {name: abs(getattr(other, name) - getattr(one, name)) / (allowed * scales[name]) for name in scales}
    return {name: value for name, value in found.items() if not value <= 1.0}


def _planes(case: Case, plane: vr.CoatedPlane) -> Iterator[Twin]:
    """Yield the same plane as a very wide groove, and with part of its half-space as a layer."""
    radius = WIDE * case.body.outer_radius
    across = {} if isinstance(case.body, vr.CoatedCylinder) else {"radius": -radius}
    groove = vr.Groove(layers=plane.layers, base=plane.base, path_radius=radius, **across)
    yield Twin(
        kind="wide groove", case=replace(case, arguments=case.arguments | {"on": groove}), differences=_differences
    )
    # Without a given mesh, the choice of the mesh depends on layer thicknesses, which the twin changes.
    if plane.base is None or "mesh" not in case.arguments:
        return
    base = {name: getattr(plane.base, name) for name in ("shear_modulus", "poisson_ratio", "bulk_modulus", "density")}
    thickness = sum(layer.thickness for layer in plane.layers) or 0.01 * case.body.outer_radius
    thicker = replace(plane, layers=[vr.Layer(thickness=thickness, **base), *plane.layers])
    yield Twin(
        kind="layer of the base",
        case=replace(case, arguments=case.arguments | {"on": thicker}),
        # The first guess of the window depends on thicknesses, so fields may have another shape.
        differences=partial(_differences, fields={}),
    )


def _is_exchangeable(case: Case) -> bool:
    """Return whether the bodies of a case may be exchanged with the same nodes and speeds."""
    if type(case.on) is not type(case.body) or isinstance(case.body, vr.CoatedWheel):
        return False
    # The nodes of balls lie on a paraboloid if the counterbody deforms; those of rollers are always at the same arcs.
    if not isinstance(case.body, vr.CoatedCylinder) and not (case.body.layers and case.on.layers):
        return False
    return not case.has_friction and case.arguments["drive"].creepage is None and "mesh" in case.arguments


def _swapped(case: Case) -> Case:
    body, arguments = swapped(case.body, case.arguments)
    return replace(case, body=body, arguments=arguments)


def _swap_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    """Return differences of the quantities of the pair, and of each body's dissipated power."""
    pairs = {name: (getattr(one, name), getattr(other, name)) for name in ("penetration", "resisting_torque")}
    pairs["bulk_power"] = one.rolling_bulk_power, other.counterbody_bulk_power
    radius = min(one.body.outer_radius, other.body.outer_radius)
    # Identical bodies have equal growth, so their exchange has no effect.
    is_identical = one.on == one.body
    return _pair_differences(one, pairs, growth=0.0 if is_identical else one.centrifugal_displacement / radius)


def _mirror_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    """Return differences between a pair of equal balls and one of them on the plane of symmetry.

    The penetration of the pair is twice that of the ball on the plane.
    """
    pairs = {name: (getattr(one, name), getattr(other, name)) for name in ("resisting_torque", "contact_area")}
    pairs["penetration"] = one.penetration, 2.0 * other.penetration
    pairs["bulk_power"] = one.rolling_bulk_power, other.rolling_bulk_power
    return _pair_differences(one, pairs)


def _pair_differences(
    one: vr.Result, pairs: dict[str, tuple[float, float]], *, growth: float = 0.0
) -> dict[str, float]:
    scales = _scales(one)
    allowed = {name: PAIR_TOLERANCE + CHANGE_PER_GROWTH.get(name, 0.0) * growth for name in pairs}
    found = {name: abs(a - b) / (allowed[name] * scales[name]) for name, (a, b) in pairs.items()}
    return {name: value for name, value in found.items() if not value <= 1.0}


def _scaled(case: Case) -> Case:
    on = {} if case.on is None else {"on": scaled_body(case.on)}
    given = case.arguments
    drive = given["drive"]
    per_length = LENGTH if case.body.line_contact else 1.0
    if drive.force is not None:
        drive = vr.Drive(force=STRESS * LENGTH**2 / per_length * drive.force)
    elif drive.torque is not None:
        drive = vr.Drive(torque=STRESS * LENGTH**3 / per_length * drive.torque)
    elif drive.spin:
        drive = replace(drive, spin=drive.spin / LENGTH)
    changed = {
        "load": STRESS * LENGTH**2 / per_length * given["load"],
        "angular_speed": given["angular_speed"] / TIME,
        "drive": drive,
    }
    return replace(case, body=scaled_body(case.body), arguments=given | changed | on)


def scaled_body(body: Any) -> Any:
    """Return a body with all lengths, stresses and times multiplied."""
    changed: dict[str, Any] = {"layers": [_scaled_material(layer) for layer in body.layers]}
    if getattr(body, "base", None) is not None:
        changed["base"] = _scaled_material(body.base)
    for name in ("core_radius", "width", "crown_radius", "radius", "path_radius"):
        if (length := getattr(body, name, None)) is not None:
            changed[name] = LENGTH * length
    return replace(body, **changed)


def _scaled_material(material: Any) -> Any:
    changed = {
        "shear_modulus": scaled_modulus(material.shear_modulus, stress=STRESS, time=TIME),
        "bulk_modulus": None if material.bulk_modulus is None else STRESS * material.bulk_modulus,
        "density": STRESS * TIME**2 / LENGTH**2 * material.density,
    }
    if isinstance(material, vr.Layer):
        changed["thickness"] = LENGTH * material.thickness
    return replace(material, **changed)


def _split(case: Case) -> Case:
    """Divide the thickest layer of the rolling body in two, or of the counterbody if the rolling body is rigid."""
    body = case.body if case.body.layers else case.on
    layers = list(body.layers)
    thickest = max(range(len(layers)), key=lambda j: layers[j].thickness)
    half = replace(layers[thickest], thickness=0.5 * layers[thickest].thickness)
    layers[thickest : thickest + 1] = [half, half]
    split = replace(body, layers=layers)
    if not case.body.layers:
        return replace(case, arguments=case.arguments | {"on": split})
    return replace(case, body=split)


def _scaling_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    return _differences(one, other, scaled=True, allowed=SCALING_TOLERANCE)


def _differences(
    one: vr.Result,
    other: vr.Result,
    *,
    scaled: bool = False,
    mirrored: bool = False,
    summed: bool = False,
    fields: dict[str, tuple[int, int, int]] = FIELDS,
    allowed: float = TOLERANCE,
) -> dict[str, float]:
    if one.mesh != other.mesh or (fields and one.pressure.shape != other.pressure.shape):
        return {"mesh": float("inf")}
    scales = _scales(one)
    found: dict[str, float] = {}
    for name, powers in (SCALARS | fields).items():
        if getattr(one, name) is None:  # the penetration is undefined on a half-plane
            continue
        per_length = LENGTH if one.body.line_contact and name not in NEVER_PER_LENGTH else 1.0
        factor = _scale_factor(powers) / per_length if scaled else 1.0
        values = np.asarray(getattr(other, name)) / factor
        if mirrored:
            values = _mirrored(name, values)
        difference = values - getattr(one, name)
        if summed and name in fields:
            difference = np.cumsum(difference, axis=-1) / difference.shape[-1]
        found[name] = float(np.abs(difference).max()) / (allowed * scales[name])
    return {name: value for name, value in found.items() if not value <= 1.0}


def _mirrored(name: str, values: NDArray[Any]) -> NDArray[Any]:
    if values.ndim == 0:
        return values
    sides = np.array([1.0, -1.0])[:, None, None] if name == "shear_traction" else 1.0
    mirrored: NDArray[Any] = sides * values[..., ::-1]
    return mirrored


def _scale_factor(powers: tuple[int, int, int]) -> float:
    length, stress, time = powers
    return LENGTH**length * STRESS**stress * TIME**time


def _scales(result: vr.Result) -> dict[str, float]:
    """Return a scale for the differences of each result: the size of its terms before they cancel."""
    radius = result.body.outer_radius
    torque = result.load * max(result.semi_axis_x, result.mesh.spacing * radius)
    force = max(min(result.friction, 1.0) * result.load, 1e-3 * result.load)
    pressure = float(result.pressure.max())
    depth = depth_of(result)
    return {
        "resisting_torque": torque,
        "driving_torque": torque + force * radius,
        "driving_force": force,
        "penetration": depth,
        "contact_area": result.contact_area,
        "bulk_power": torque * result.angular_speed,
        "slip_power": (torque + force * radius) * result.angular_speed,
        "pressure": pressure,
        "gap": max(depth, float(result.gap.max())),
        "shear_traction": max(min(result.friction, 1.0), 1e-3) * pressure,
    }
