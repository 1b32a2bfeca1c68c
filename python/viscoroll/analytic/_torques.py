"""Closed forms of the torque that apply to balls, rollers and wheels."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from ..materials.modulus_like import relaxation_of
from ._closed_form import ClosedForm, have_real_poisson_ratios, relaxed_constants
from ._inputs import Floats, positives
from .low_speed import low_speed_torque

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ._at_rest import Coating

__all__ = ["ContactSize", "low_speed_form", "thin_coating_form"]

#: Function that returns the radius or half-width of the contact at rest [m] for a load.
ContactSize: TypeAlias = "Callable[[ArrayLike], NDArray[np.float64]]"


def low_speed_form(body: Coating, loss_time: float, contact_size: ContactSize, size_name: str) -> ClosedForm:
    """Return the low-speed torque of a body whose surface compliance at low frequency is C(0) (1 - iωt)."""

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return low_speed_torque(load=load, angular_speed=angular_speed, radius=body.outer_radius, loss_time=loss_time)

    def is_valid(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        a = contact_size(load)
        distance = positives("angular_speed", angular_speed, "rad/s") * body.outer_radius * loss_time
        valid: NDArray[np.bool_] = (distance <= 0.05 * a) & (
            have_real_poisson_ratios(body.layers) | (a <= 0.2 * body.thickness)
        )
        return valid

    validity = f"the surface travels at most 5 % of the {size_name} within the loss time; no inertia"
    return ClosedForm(torque=torque, is_valid=is_valid, validity=validity)


def thin_coating_form(
    body: Coating, winkler: Callable[..., Floats], contact_size: ContactSize, size_name: str
) -> ClosedForm | None:
    """Return the torque of a thin coating that acts as a bed of viscoelastic springs.

    The result is None if the coating is incompressible or its relaxation function is not a sum of exponentials.
    """
    layer, h = body.layers[0], body.thickness
    material, (_, nu) = layer.shear_modulus, relaxed_constants(layer)
    relaxation = relaxation_of(material)
    if relaxation is None or nu == 0.5:
        return None

    def torque(load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        return winkler(
            load=load,
            angular_speed=angular_speed,
            radius=body.outer_radius,
            thickness=h,
            shear_modulus=material,
            poisson_ratio=layer.poisson_ratio,
            bulk_modulus=layer.bulk_modulus,
        )

    def is_valid(load: ArrayLike, angular_speed: ArrayLike) -> NDArray[np.bool_]:
        a = contact_size(load)
        slow = positives("angular_speed", angular_speed, "rad/s") * relaxation.longest_time <= 0.2 * np.pi
        valid: NDArray[np.bool_] = (a >= 5.0 * h) & ((1.0 - 2.0 * nu) * a >= h) & (a <= 0.2 * body.outer_radius) & slow
        return valid

    validity = (
        f"{size_name} at least 5 h and h/(1-2ν), with the thickness h, and at most a fifth of the radius; longest "  # noqa: RUF001
        "relaxation time at most a tenth of a revolution; no inertia"
    )
    return ClosedForm(torque=torque, is_valid=is_valid, validity=validity)
