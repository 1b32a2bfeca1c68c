"""Which closed forms a roller has on a rigid plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..materials import StandardLinearSolid
from ._closed_form import ClosedForm, at_rest, is_homogeneous, is_real, shared_loss_time
from ._inputs import Floats, positives
from .hunter import hunter
from .line_contact import hertz_line, thin_compressible_layer_line, thin_incompressible_layer_line
from .low_speed import low_speed_torque
from .winkler import KNOWN_IN_TIME, longest_time, winkler_torque_line

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..bodies import CoatedCylinder

__all__ = ["forms_of_roller"]


def forms_of_roller(roller: CoatedCylinder) -> dict[str, ClosedForm]:
    """Find the closed forms of a roller: ``"low_speed"``, ``"hunter"`` and ``"winkler_line"``, where they suit it."""
    if not roller.layers:
        return {}
    return _low_speed(roller) | (_hunter(roller) | _thin(roller) if is_homogeneous(roller.layers) else {})


def _low_speed(roller: CoatedCylinder) -> dict[str, ClosedForm]:
    time = shared_loss_time(roller.layers)
    if time is None or not is_real(roller.layers):
        return {}

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return low_speed_torque(load=load, angular_speed=angular_speed, radius=roller.outer_radius, loss_time=time)

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        way = positives("angular_speed", angular_speed, "rad/s") * roller.outer_radius * time
        met: NDArray[np.bool_] = way <= 0.05 * _half_width(roller, load)
        return met

    moves = "the surface moves by less than 5 % of the half width in the loss time; no inertia"
    return {"low_speed": ClosedForm(torque=torque, holds=holds, validity=moves)}


def _hunter(roller: CoatedCylinder) -> dict[str, ClosedForm]:
    layer, radius = roller.layers[0], roller.outer_radius
    material, nu = layer.shear_modulus, layer.poisson_ratio
    if not isinstance(material, StandardLinearSolid) or nu is None:
        return {}

    retardation = material.relaxation_time * material.instantaneous_modulus / material.relaxed_modulus

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        speed = positives("angular_speed", angular_speed, "rad/s") * radius
        return hunter(load=load, speed=speed, radius=radius, shear_modulus=material, poisson_ratio=nu).moment

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        # The wake of the contact, f V τ long, must not feel the core either.
        wake = positives("angular_speed", angular_speed, "rad/s") * radius * retardation
        met: NDArray[np.bool_] = (_half_width(roller, load) <= 0.2 * roller.thickness) & (
            wake <= 0.5 * roller.thickness
        )
        return met

    small = "half width below a fifth of the thickness, way in the retardation time below half of it; no inertia"
    return {"hunter": ClosedForm(torque=torque, holds=holds, validity=small)}


def _thin(roller: CoatedCylinder) -> dict[str, ClosedForm]:
    layer, h = roller.layers[0], roller.thickness
    material = layer.shear_modulus
    _, nu = at_rest(layer)
    if not isinstance(material, KNOWN_IN_TIME) or nu == 0.5:
        return {}

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return winkler_torque_line(
            load=load,
            angular_speed=angular_speed,
            radius=roller.outer_radius,
            thickness=h,
            shear_modulus=material,
            poisson_ratio=layer.poisson_ratio,
            bulk_modulus=layer.bulk_modulus,
        )

    def holds(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        a = _half_width(roller, load)
        slow = positives("angular_speed", angular_speed, "rad/s") * longest_time(material) <= 0.2 * np.pi
        met: NDArray[np.bool_] = (a >= 5.0 * h) & ((1.0 - 2.0 * nu) * a >= h) & (a <= 0.2 * roller.outer_radius) & slow
        return met

    wide = (
        "half width a above 5 thicknesses h and h/(1-2ν), below a fifth of the radius; forgets in a tenth of a "  # noqa: RUF001
        "revolution; no inertia"
    )
    return {"winkler_line": ClosedForm(torque=torque, holds=holds, validity=wide)}


def _half_width(roller: CoatedCylinder, load: ArrayLike) -> NDArray[np.float64]:
    """Estimate the half width at rest [m], of layers as if mixed: the lesser of the thick and the thin limit.

    Of the thin limits the larger one counts, since a thin layer gives way in both manners at once.
    """
    h, radius = roller.thickness, roller.outer_radius
    mixed = [(layer.thickness / h, *at_rest(layer)) for layer in roller.layers]
    modulus = 1.0 / sum(share / g for share, g, _ in mixed)
    nu = min(sum(share * ratio for share, _, ratio in mixed), 0.5)
    thick = hertz_line(load=load, radius=radius, shear_modulus=modulus, poisson_ratio=nu).half_width
    thin = thin_incompressible_layer_line(load=load, radius=radius, thickness=h, shear_modulus=modulus).half_width
    if nu < 0.5:
        springs = thin_compressible_layer_line(
            load=load, radius=radius, thickness=h, shear_modulus=modulus, poisson_ratio=nu
        ).half_width
        thin = np.maximum(thin, springs)
    return np.minimum(thick, thin)
