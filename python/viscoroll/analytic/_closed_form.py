"""Closed form of the resisting torque, and properties of layers on which the applicable forms depend."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float
from ._inputs import Floats, complex_modulus
from .low_speed import loss_time

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..bodies import HalfSpace, Layer
    from ..materials.modulus_like import ShearModulusLike

__all__ = [
    "ClosedForm",
    "have_real_poisson_ratios",
    "is_defined_at_all_frequencies",
    "is_homogeneous",
    "relaxed_constants",
    "shared_loss_time",
]


@dataclass(frozen=True, slots=True, kw_only=True)
class ClosedForm:
    """Closed form of the resisting torque of one body, with its range of validity.

    Attributes
    ----------
    torque : callable
        Function torque(load, angular_speed) that returns the resisting torque T [N m] for loads P [N] and angular
        speeds Ω [rad/s], which may be arrays. For rollers, T [N m/m] and P [N/m] are per unit length. Calling the
        `ClosedForm` itself is equivalent.
    is_valid : callable
        Function is_valid(load, angular_speed) that returns an array of bool: whether the contact and the speed are
        within the range of validity. Within this range, their finite size adds at most about 10 % to the other errors
        of the form.
    validity : str
        Description of the condition that `is_valid` evaluates.
    """

    torque: Callable[[ArrayLike, ArrayLike], Floats]
    is_valid: Callable[[ArrayLike, ArrayLike], NDArray[np.bool_]]
    validity: str

    def __call__(self, load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        """Return the torque."""
        return self.torque(load, angular_speed)


def have_real_poisson_ratios(layers: Sequence[Layer]) -> bool:
    """Return whether Poisson's ratio of every layer is real."""
    return all(layer.poisson_ratio is not None for layer in layers)


def is_homogeneous(layers: Sequence[Layer]) -> bool:
    """Return whether all layers consist of the same material."""
    materials = [(layer.shear_modulus, layer.poisson_ratio, layer.bulk_modulus) for layer in layers]
    return all(material == materials[0] for material in materials)


def is_defined_at_all_frequencies(modulus: ShearModulusLike) -> bool:
    """Return whether a modulus is defined at all frequencies."""
    try:
        complex_modulus(modulus, [1e-12, 1e12])
    except ValueError:
        return False
    return True


def shared_loss_time(layers: Sequence[Layer]) -> float | None:
    """Return the common loss time [s] of all layers, or None if a layer has another loss time or none."""
    try:
        times = [loss_time(layer.shear_modulus) for layer in layers]
    except ValueError:
        return None
    return times[0] if np.allclose(times, times[0], rtol=1e-9, atol=0.0) else None


def relaxed_constants(layer: Layer | HalfSpace) -> tuple[float, float]:
    """Return the relaxed shear modulus [Pa] and Poisson's ratio of a layer, at zero frequency."""
    modulus = float(complex_modulus(layer.shear_modulus, 0.0).real)
    if layer.poisson_ratio is not None:
        return modulus, layer.poisson_ratio
    bulk = as_float("bulk_modulus", layer.bulk_modulus)
    return modulus, (3.0 * bulk - 2.0 * modulus) / (6.0 * bulk + 2.0 * modulus)
