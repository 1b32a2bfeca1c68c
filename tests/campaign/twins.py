"""Cases that must have the same solution as another, and what their solutions must share."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
import viscoroll as vr
from numpy.typing import NDArray

from .cases import Case
from .materials import scaled_modulus
from .pairs import on_its_mirror, swapped

__all__ = ["Twin", "twins"]

#: Powers of two, whose products are exact: what differs is an absolute number somewhere in the solution.
LENGTH, STRESS, TIME = 2.0**-9, 2.0**13, 2.0**7

#: Relative to the largest value of its kind. Layers that are cut and tables that are mirrored have other round-off, and
#: the solver ends at residuals of 1e-8 and less.
SCALING_TOLERANCE = 1e-8
TOLERANCE = 1e-6

#: Of one pair told from either ball: their orders are split in octaves of their own, and one is the other's elsewhere.
PAIR_TOLERANCE = 1e-5

#: Of layers cut in two, in a tread with faces: elements of its section end where layers do, and are right to some 1e-4.
#: Tractions are so as they sum up from a face: at single nodes nearer to it than a sixteenth of the thickness, which is
#: the elements' size there, they are known to 4 % (case 73:58 with elements of a sixteenth and of a 64th).
ELEMENT_TOLERANCE = 1e-3

#: Results by the powers of length, stress and time that scale them.
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


@dataclass(frozen=True, kw_only=True)
class Twin:
    """A case whose solution is known from that of another.

    Attributes
    ----------
    kind : str
        What was done to it.
    case : Case
        What is solved.
    differences : callable
        Called with the first solution and the twin's; returns differences by name, relative to what is allowed.
    """

    kind: str
    case: Case
    differences: Callable[[vr.Result, vr.Result], dict[str, float]]


def twins(case: Case) -> Iterator[Twin]:
    """Yield all twins that the case has."""
    yield Twin(kind="scaling", case=_scaled(case), differences=_scaling_differences)
    wheel = case.ball if isinstance(case.ball, vr.CoatedWheel) else None
    if not (wheel and wheel.hub is vr.Hub.STRAIGHT):  # its crown cuts one layer
        by_elements = wheel is not None and wheel.sides is vr.Sides.FREE
        differences = partial(_differences, allowed=ELEMENT_TOLERANCE, summed=True) if by_elements else _differences
        yield Twin(kind="split layer", case=_split(case), differences=differences)
    if case.on is not None and _tells_both_alike(case):
        yield Twin(kind="swap", case=_swapped(case), differences=_swap_differences)
        if case.on == case.ball:
            mirror = replace(case, arguments=on_its_mirror(case.arguments))
            yield Twin(kind="mirror plane", case=mirror, differences=_mirror_differences)
    drive = case.arguments["drive"]
    if drive.lateral_creepage:
        mirrored = replace(drive, lateral_creepage=-drive.lateral_creepage)
        yield Twin(
            kind="mirror",
            case=replace(case, arguments=case.arguments | {"drive": mirrored}),
            differences=partial(_differences, mirrored=True),
        )


def _tells_both_alike(case: Case) -> bool:
    """Whether the other ball may roll in place of the first one, at the same nodes and speeds."""
    if not (case.ball.layers and case.on.layers):  # nodes lie on a paraboloid where what is rolled on deforms
        return False
    return not case.has_friction and case.arguments["drive"].creepage is None and "mesh" in case.arguments


def _swapped(case: Case) -> Case:
    ball, arguments = swapped(case.ball, case.arguments)
    return replace(case, ball=ball, arguments=arguments)


def _swap_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    """Return what differs of what has no side, and of what each body loses."""
    pairs = {name: (getattr(one, name), getattr(other, name)) for name in ("penetration", "resisting_torque")}
    pairs["bulk_power"] = one.rolling_bulk_power, other.counterpart_bulk_power
    return _pair_differences(one, pairs)


def _mirror_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    """Return what differs from one of two equal balls on the plane between them: it is pressed in by half."""
    pairs = {name: (getattr(one, name), getattr(other, name)) for name in ("resisting_torque", "contact_area")}
    pairs["penetration"] = one.penetration, 2.0 * other.penetration
    pairs["bulk_power"] = one.rolling_bulk_power, other.rolling_bulk_power
    return _pair_differences(one, pairs)


def _pair_differences(one: vr.Result, pairs: dict[str, tuple[float, float]]) -> dict[str, float]:
    scales = _scales(one)
    found = {name: abs(a - b) / (PAIR_TOLERANCE * scales[name]) for name, (a, b) in pairs.items()}
    return {name: value for name, value in found.items() if not value <= 1.0}


def _scaled(case: Case) -> Case:
    on = {} if case.on is None else {"on": _scaled_body(case.on)}
    given = case.arguments
    drive = given["drive"]
    if drive.force is not None:
        drive = vr.Drive(force=STRESS * LENGTH**2 * drive.force)
    elif drive.torque is not None:
        drive = vr.Drive(torque=STRESS * LENGTH**3 * drive.torque)
    changed = {
        "load": STRESS * LENGTH**2 * given["load"],
        "angular_speed": given["angular_speed"] / TIME,
        "drive": drive,
    }
    return replace(case, ball=_scaled_body(case.ball), arguments=given | changed | on)


def _scaled_body(body: Any) -> Any:
    layers = [
        replace(
            layer,
            thickness=LENGTH * layer.thickness,
            shear_modulus=scaled_modulus(layer.shear_modulus, stress=STRESS, time=TIME),
            bulk_modulus=None if layer.bulk_modulus is None else STRESS * layer.bulk_modulus,
            density=STRESS * TIME**2 / LENGTH**2 * layer.density,
        )
        for layer in body.layers
    ]
    lengths = [name for name in ("core_radius", "width", "crown_radius") if hasattr(body, name)]
    return replace(body, layers=layers, **{name: LENGTH * getattr(body, name) for name in lengths})


def _split(case: Case) -> Case:
    """Cut the thickest layer in two, of what rolls unless that is rigid."""
    body = case.ball if case.ball.layers else case.on
    layers = list(body.layers)
    thickest = max(range(len(layers)), key=lambda j: layers[j].thickness)
    half = replace(layers[thickest], thickness=0.5 * layers[thickest].thickness)
    layers[thickest : thickest + 1] = [half, half]
    split = replace(body, layers=layers)
    if not case.ball.layers:
        return replace(case, arguments=case.arguments | {"on": split})
    return replace(case, ball=split)


def _scaling_differences(one: vr.Result, other: vr.Result) -> dict[str, float]:
    return _differences(one, other, scaled=True, allowed=SCALING_TOLERANCE)


def _differences(
    one: vr.Result,
    other: vr.Result,
    *,
    scaled: bool = False,
    mirrored: bool = False,
    summed: bool = False,
    allowed: float = TOLERANCE,
) -> dict[str, float]:
    if one.mesh != other.mesh or one.pressure.shape != other.pressure.shape:
        return {"mesh": float("inf")}
    scales = _scales(one)
    found: dict[str, float] = {}
    for name, powers in (SCALARS | FIELDS).items():
        unit = _unit(powers) if scaled else 1.0
        values = np.asarray(getattr(other, name)) / unit
        if mirrored:
            values = _mirrored(name, values)
        difference = values - getattr(one, name)
        if summed and name in FIELDS:
            difference = np.cumsum(difference, axis=-1) / difference.shape[-1]
        found[name] = float(np.abs(difference).max()) / (allowed * scales[name])
    return {name: value for name, value in found.items() if not value <= 1.0}


def _mirrored(name: str, values: NDArray[Any]) -> NDArray[Any]:
    if values.ndim == 0:
        return values
    sides = np.array([1.0, -1.0])[:, None, None] if name == "shear_traction" else 1.0
    mirrored: NDArray[Any] = sides * values[..., ::-1]
    return mirrored


def _unit(powers: tuple[int, int, int]) -> float:
    length, stress, time = powers
    return LENGTH**length * STRESS**stress * TIME**time


def _scales(result: vr.Result) -> dict[str, float]:
    """Return the size of each result where nothing cancels."""
    radius = result.ball.outer_radius
    torque = result.load * max(result.semi_axis_x, result.mesh.spacing * radius)
    force = max(min(result.friction, 1.0) * result.load, 1e-3 * result.load)
    pressure = float(result.pressure.max())
    depth = result.penetration + result.centrifugal_displacement
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
