"""Contacts at rest: shape of the pressure, and estimate of the contact size on layers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol, TypeAlias

import numpy as np

from .._support.arguments import as_positive
from ._closed_form import relaxed_constants
from ._inputs import Floats, float_if_scalar, positives

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import ArrayLike, NDArray

    from ..bodies import Layer

__all__ = ["Coating", "PressureBell", "load_and_sizes", "reach_at_rest"]


class Coating(Protocol):
    """Properties of a body that closed forms use: its layers, and the radius of the gap before deformation."""

    @property
    def layers(self) -> Sequence[Layer]: ...

    @property
    def thickness(self) -> float: ...

    @property
    def outer_radius(self) -> float: ...


class PressureBell:
    """Pressure p₀ (1 - s²/a²)ᵏ at the distance s from the center of a contact."""

    __slots__ = ()

    max_pressure: Floats
    exponent: float

    @property
    def reach(self) -> Floats:
        """Distance a of the edge from the center [m]."""
        raise NotImplementedError

    def pressure(self, distance: ArrayLike) -> Floats:
        """Return the pressure at a distance from the center [Pa], 0 outside the contact.

        Parameters
        ----------
        distance : array_like
            s [m], of a shape that broadcasts with that of a.

        Returns
        -------
        float or ndarray
            p(s) [Pa].

        Examples
        --------
        >>> from viscoroll import analytic
        >>> analytic.hertz(load=100.0, radius=20e-3, shear_modulus=3e6, poisson_ratio=0.5).pressure(1.0)
        0.0
        """
        inside = np.clip(1.0 - (np.asarray(distance, dtype=np.float64) / self.reach) ** 2, 0.0, None)
        return float_if_scalar(self.max_pressure * inside**self.exponent)


#: Function that returns a contact at rest on a thick or a thin layer, with keyword arguments.
_Limit: TypeAlias = "Callable[..., _Contact]"


class _Contact(Protocol):
    @property
    def reach(self) -> Floats: ...


def reach_at_rest(
    body: Coating, load: ArrayLike, *, thick: _Limit, squeezed: _Limit, springs: _Limit
) -> NDArray[np.float64]:
    """Estimate the contact radius or half-width at rest [m]: the smaller one of the thick and the thin limit.

    One layer with the mean compliance and the mean Poisson's ratio replaces several layers. There are two thin limits:
    a layer that is squeezed out sideways (`squeezed`), and a bed of springs (`springs`). The larger one is used,
    because a thin layer deforms in both ways at once.
    """
    h = body.thickness
    mixed = [(layer.thickness / h, *relaxed_constants(layer)) for layer in body.layers]
    layer = {"radius": body.outer_radius, "shear_modulus": 1.0 / sum(fraction / g for fraction, g, _ in mixed)}
    nu = min(sum(fraction * ratio for fraction, _, ratio in mixed), 0.5)
    thin = squeezed(load=load, thickness=h, **layer).reach
    if nu < 0.5:
        thin = np.maximum(thin, springs(load=load, thickness=h, poisson_ratio=nu, **layer).reach)
    return np.asarray(np.minimum(thick(load=load, poisson_ratio=nu, **layer).reach, thin))


def load_and_sizes(
    load: ArrayLike, unit: str, radius: float, thickness: float
) -> tuple[NDArray[np.float64], float, float]:
    """Check load, radius and thickness of a thin layer, and return them."""
    return positives("load", load, unit), as_positive("radius", radius, "m"), as_positive("thickness", thickness, "m")
