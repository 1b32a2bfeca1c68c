"""Closed form of the resisting torque, and conditions that it imposes on the layers."""

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

    from ..bodies import Layer
    from ..materials.moduli import ShearModulusLike

__all__ = ["ClosedForm", "at_rest", "is_homogeneous", "is_known_throughout", "is_real", "shared_loss_time"]


@dataclass(frozen=True, slots=True, kw_only=True)
class ClosedForm:
    """Closed form of the resisting torque of one body, with its range of validity.

    Attributes
    ----------
    torque : callable
        torque(load, angular_speed) → T [N m], for loads P [N] and angular speeds Ω [rad/s], which may be arrays. For
        rollers T and P are per unit length [N, N/m]. Calling the object is equivalent.
    holds : callable
        holds(load, angular_speed) → array of bool: whether contact and speed are small enough for the form, so that
        they add at most about 10 % to its other errors.
    validity : str
        Condition of `holds` in words.
    """

    torque: Callable[[ArrayLike, ArrayLike], Floats]
    holds: Callable[[ArrayLike, ArrayLike], NDArray[np.bool_]]
    validity: str

    def __call__(self, load: ArrayLike, angular_speed: ArrayLike) -> Floats:
        """Return the torque."""
        return self.torque(load, angular_speed)


def is_real(layers: Sequence[Layer]) -> bool:
    """Return whether Poisson's ratio of every layer is real."""
    return all(layer.poisson_ratio is not None for layer in layers)


def is_homogeneous(layers: Sequence[Layer]) -> bool:
    """Return whether all layers have the same material."""
    materials = [(layer.shear_modulus, layer.poisson_ratio, layer.bulk_modulus) for layer in layers]
    return all(material == materials[0] for material in materials)


def is_known_throughout(modulus: ShearModulusLike) -> bool:
    """Return whether a modulus is defined at all frequencies."""
    try:
        complex_modulus(modulus, [1e-12, 1e12])
    except ValueError:
        return False
    return True


def shared_loss_time(layers: Sequence[Layer]) -> float | None:
    """Return the loss time [s] if the shear moduli of all layers have the same one, otherwise None."""
    try:
        times = [loss_time(layer.shear_modulus) for layer in layers]
    except ValueError:
        return None
    return times[0] if np.allclose(times, times[0], rtol=1e-9, atol=0.0) else None


def at_rest(layer: Layer) -> tuple[float, float]:
    """Return shear modulus [Pa] and Poisson's ratio of a layer at rest."""
    modulus = float(complex_modulus(layer.shear_modulus, 0.0).real)
    if layer.poisson_ratio is not None:
        return modulus, layer.poisson_ratio
    bulk = as_float("bulk_modulus", layer.bulk_modulus)
    return modulus, (3.0 * bulk - 2.0 * modulus) / (6.0 * bulk + 2.0 * modulus)
