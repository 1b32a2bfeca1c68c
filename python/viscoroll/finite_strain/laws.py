"""Stress of the relaxed network and strain measures of the viscous part, with their derivatives.

Tensors in the plane are arrays whose last axis holds the components 11, 22 and 12; 1 is the radius, 2 the angle.
Derivatives are by C₁₁, C₂₂ and C₁₂ of the right Cauchy-Green tensor, in the last axis.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_float_in
from .._support.errors import Range

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

__all__ = ["Elasticity", "Law", "MooneyRivlin", "NeoHookean", "Strain", "Yeoh"]

_UNIT = np.array([1.0, 1.0, 0.0])
_COFACTOR = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])


class Law(Enum):
    """Law of the viscous stress S_v; all three are the same linear material at small strain."""

    #: Temporary network (Lodge), with Newton's viscous stress 2 η D in slow motion.
    NEWTON = "newton"
    #: Simo's (1987) and Holzapfel's convolution of the deviatoric second Piola-Kirchhoff stress.
    SIMO = "simo"
    #: Convolution of the Kirchhoff stress, convected as the mean of both mixed components, as in ``*VISCOELASTIC``.
    ABAQUS = "abaqus"


class Strain:
    """Right Cauchy-Green tensor C with its inverse, its determinant and their derivatives.

    Parameters
    ----------
    c : ndarray, shape (..., 3)
        Components of C.
    """

    def __init__(self, c: Floats) -> None:
        self.c = c
        self.det = c[..., 0] * c[..., 1] - c[..., 2] ** 2
        self.jacobian = np.sqrt(self.det)
        self.inverse = np.stack([c[..., 1], c[..., 0], -c[..., 2]], axis=-1) / self.det[..., None]
        #: ∂ln det/∂C; the off-diagonal component counts twice.
        self.log_slope = self.inverse * np.array([1.0, 1.0, 2.0])
        self.inverse_slope = _COFACTOR / self.det[..., None, None] - _outer(self.inverse, self.log_slope)
        #: First invariant in plane strain, with C₃₃ = 1.
        self.first = c[..., 0] + c[..., 1] + 1.0


@dataclass(frozen=True, slots=True)
class Elasticity:
    """Base class of elastic laws: energy W = μ/2 (w(I₁ - 3) + a (I₂ - I₁)) for an incompressible material.

    In plane strain I₁ = I₂, so that a, the fraction of the I₂ term, changes the viscous stress only.
    """

    @property
    def second_fraction(self) -> float:
        """Fraction a of the modulus that the I₂ term contributes [-]."""
        return 0.0

    @property
    def stiffening(self) -> float:
        """Coefficient c₂ in w = I + c₂ I² [-]."""
        return 0.0

    def factor(self, strain: Strain) -> tuple[Floats, Floats]:
        """Return w' and its derivative by C."""
        slope = 2.0 * self.stiffening
        return 1.0 + slope * (strain.first - 3.0), np.broadcast_to(slope * _UNIT, strain.c.shape)

    def relaxed(self, strain: Strain) -> tuple[Floats, Floats]:
        """Return the stress w' (1 - C⁻¹) per modulus, and its derivative by C."""
        factor, factor_slope = self.factor(strain)
        basis = _UNIT - strain.inverse
        return factor[..., None] * basis, _outer(basis, factor_slope) - factor[..., None, None] * strain.inverse_slope


@dataclass(frozen=True, slots=True)
class NeoHookean(Elasticity):
    """Neo-Hookean material, W = μ/2 (I₁ - 3)."""


@dataclass(frozen=True, slots=True, kw_only=True)
class MooneyRivlin(Elasticity):
    """Mooney-Rivlin material, W = μ/2 ((1 - a) (I₁ - 3) + a (I₂ - 3)).

    In plane strain its elastic stress equals that of the neo-Hookean material, but for the laws `simo` and `abaqus` the
    viscous stress differs.

    Parameters
    ----------
    fraction : float
        Fraction a of the modulus in the I₂ term [-], in [0, 1].
    """

    fraction: float

    def __post_init__(self) -> None:
        """Check the fraction."""
        object.__setattr__(self, "fraction", as_float_in(Range(0.0, 1.0), "fraction", self.fraction))

    @property
    def second_fraction(self) -> float:
        """Fraction a of the modulus that the I₂ term contributes [-]."""
        return self.fraction


@dataclass(frozen=True, slots=True, kw_only=True)
class Yeoh(Elasticity):
    """Yeoh material with two terms, W = μ/2 (I + c₂ I²) with I = I₁ - 3.

    Parameters
    ----------
    coefficient : float
        Coefficient c₂ [-], in [0, 1]; filled rubbers that stiffen have about 0.05.
    """

    coefficient: float

    def __post_init__(self) -> None:
        """Check the coefficient."""
        object.__setattr__(self, "coefficient", as_float_in(Range(0.0, 1.0), "coefficient", self.coefficient))

    @property
    def stiffening(self) -> float:
        """Coefficient c₂ in w = I + c₂ I² [-]."""
        return self.coefficient


def measure(law: Law, elasticity: Elasticity, strain: Strain) -> tuple[Floats, Floats]:
    """Return the strain measure T of a law, whose memory is the viscous stress, and its derivative by C."""
    if law is Law.NEWTON:
        return -strain.inverse, -strain.inverse_slope
    a, first, det = elasticity.second_fraction, strain.first, strain.det
    det_slope = det[..., None] * strain.log_slope
    # The coefficient makes the measure deviatoric in three dimensions; I₂ = det C + C₁₁ + C₂₂.
    second, second_slope = det + first - 1.0, det_slope + _UNIT
    coefficient = -(1.0 - a) * first / 3.0 + a * (det - 2.0 * second / 3.0)
    coefficient_slope = -(1.0 - a) * _UNIT / 3.0 + a * (det_slope - 2.0 * second_slope / 3.0)
    if law is Law.SIMO:
        value = _UNIT + coefficient[..., None] * strain.inverse
        slope = _outer(strain.inverse, coefficient_slope) + coefficient[..., None, None] * strain.inverse_slope
    else:
        value = strain.c + coefficient[..., None] * _UNIT
        slope = np.eye(3) + _outer(np.broadcast_to(_UNIT, value.shape), coefficient_slope)
    factor, factor_slope = elasticity.factor(strain)
    return factor[..., None] * value, _outer(value, factor_slope) + factor[..., None, None] * slope


def viscous_map(law: Law, strain: Strain, memory: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the viscous stress, its derivative by the memory and its derivative by C at constant memory.

    The memory itself is the stress for the laws `newton` and `simo`; for `abaqus`, the stress is the symmetric part of
    memory times C⁻¹.
    """
    if law is not Law.ABAQUS:
        return memory, np.broadcast_to(np.eye(3), (*memory.shape, 3)), np.zeros((*memory.shape, 3))
    by_memory = _symmetric_product(strain.inverse)
    by_inverse = _symmetric_product(memory)
    stress = np.einsum("...ij,...j->...i", by_memory, memory)
    return stress, by_memory, by_inverse @ strain.inverse_slope


def _symmetric_product(a: Floats) -> Floats:
    """Return the matrix of the map from a symmetric tensor b to the symmetric part of a b."""
    zero = np.zeros_like(a[..., 0])
    rows = [
        [a[..., 0], zero, a[..., 2]],
        [zero, a[..., 1], a[..., 2]],
        [0.5 * a[..., 2], 0.5 * a[..., 2], 0.5 * (a[..., 0] + a[..., 1])],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def _outer(a: Floats, b: Floats) -> Floats:
    return a[..., :, None] * b[..., None, :]
