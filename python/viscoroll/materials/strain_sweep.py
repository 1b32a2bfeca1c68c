"""Filler network from a measured strain sweep, after subtraction of the matrix."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import as_floats, as_member, as_positive
from .._support.errors import InvalidInput, Range
from .modulus_like import ShearModulusLike, as_modulus, to_core
from .networks import Network

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .._support.arguments import Floats

__all__ = ["StrainKind", "StrainSweep"]

#: Largest relative amount by which a modulus of the sweep may lie below that of the matrix: the scatter of a good
#: instrument.
_SCATTER = 0.02


class StrainKind(Enum):
    """Definition of strain that an instrument uses in a sweep."""

    SHEAR = 1.0
    """Single amplitude of simple shear."""

    DOUBLE_SHEAR = 0.5
    """Shear strain from peak to peak, the double amplitude that is common in the rubber industry."""

    TENSION = math.sqrt(3.0)
    """Amplitude of the elongation of a bar of constant volume."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StrainSweep(Network):
    """Network moduli measured over strain at one frequency, interpolated linearly over the logarithm of the strain.

    The contribution of the matrix is subtracted. If `matrix` is given, its modulus at the frequency of the sweep is
    used. Otherwise the matrix is assumed to have the last storage modulus and the smallest loss modulus of the sweep,
    independent of strain. Outside the sweep the end values are held, and `strain_softening` issues a warning.

    Parameters
    ----------
    strain : array_like
        Strain amplitudes [-], > 0, strictly increasing, at least three; ratios, not percent.
    storage, loss : array_like
        Shear moduli of the filled rubber [Pa], > 0, as many as `strain`. Divide moduli measured in tension by 3.
    kind : StrainKind or str, default StrainKind.SHEAR
        Definition of `strain`: amplitude of shear, double amplitude of shear, or amplitude of tension.
    matrix : ShearModulus, callable or float, optional
        Modulus of the matrix [Pa], the same as in `SofteningModulus`.
    frequency : float, optional
        Angular frequency of the sweep [rad/s], > 0. Required with `matrix`, and allowed only with it.

    Examples
    --------
    >>> sweep = StrainSweep(strain=[0.001, 0.01, 0.1], storage=[9e6, 6e6, 2e6], loss=[6e5, 1e6, 6e5])
    >>> [float(modulus) for modulus in sweep.at(0.01)]
    [4000000.0, 400000.0]
    """

    strain: Sequence[float] | NDArray[np.float64]
    storage: Sequence[float] | NDArray[np.float64]
    loss: Sequence[float] | NDArray[np.float64]
    kind: StrainKind = StrainKind.SHEAR
    matrix: ShearModulusLike | None = None
    frequency: float | None = None

    def __post_init__(self) -> None:
        """Convert the columns to tuples and check the table."""
        for name in ("strain", "storage", "loss"):
            object.__setattr__(self, name, as_floats(name, getattr(self, name)))
        object.__setattr__(self, "kind", as_member("kind", self.kind, StrainKind))
        if (self.matrix is None) != (self.frequency is None):
            raise InvalidInput("frequency", "must be given if and only if matrix is given")
        if self.matrix is not None and self.frequency is not None:
            object.__setattr__(self, "matrix", as_modulus(self.matrix))
            object.__setattr__(self, "frequency", as_positive("frequency", self.frequency, "rad/s"))
        self._require_table()
        self._moduli(np.asarray(self.strain))

    def _require_table(self) -> None:
        lengths = [len(getattr(self, name)) for name in ("strain", "storage", "loss")]
        if len(set(lengths)) != 1 or lengths[0] < 3:
            raise ValueError(f"strain, storage and loss must have equal lengths of at least 3, got {lengths}")
        strain = np.asarray(self.strain)
        if not (np.isfinite(strain).all() and strain[0] > 0.0 and (np.diff(strain) > 0.0).all()):
            raise InvalidInput(
                "strain", "must be finite, > 0 and strictly increasing", f"{strain[0]:g} to {strain[-1]:g}"
            )
        if strain[0] >= 1.0:
            raise InvalidInput("strain", "must be a ratio, 0.01 for 1 %", f"{strain[0]:g} to {strain[-1]:g}")
        for name in ("storage", "loss"):
            values = np.asarray(getattr(self, name))
            if not (np.isfinite(values).all() and (values > 0.0).all()):
                raise Range(0.0, unit="Pa", excludes_minimum=True).error(name, f"{values.min():g}")

    @property
    def amplitudes(self) -> Floats:
        """Amplitudes of the equivalent simple shear [-]."""
        return np.asarray(self.strain) * self.kind.value

    @property
    def known_strains(self) -> tuple[float, float]:
        """First and last amplitude of shear strain in the sweep [-]."""
        return float(self.amplitudes[0]), float(self.amplitudes[-1])

    @property
    def yield_strain(self) -> float:
        """Strain at which the storage modulus of the network is half of its first value [-]."""
        storage = self._network_moduli()[0]
        below = np.flatnonzero(storage < 0.5 * storage[0])
        if not below.size:
            return self._extrapolated_yield_strain(storage)
        after = below[0]
        fraction = (storage[after - 1] - 0.5 * storage[0]) / (storage[after - 1] - storage[after])
        return float(self.amplitudes[after - 1] * (self.amplitudes[after] / self.amplitudes[after - 1]) ** fraction)

    def _extrapolated_yield_strain(self, storage: Floats) -> float:
        """Return the half-value strain of the hyperbolic law that decreases over the sweep as much as the data [-]."""
        left = storage[-1] / storage[0]
        return math.inf if left >= 1.0 - 1e-12 else float(self.amplitudes[-1] * left / (1.0 - left))

    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        storage, loss = self._network_moduli()
        position = np.log(np.clip(strain, self.amplitudes[0], self.amplitudes[-1]))
        known = np.log(self.amplitudes)
        return np.interp(position, known, storage), np.interp(position, known, loss)

    def _network_moduli(self) -> tuple[Floats, Floats]:
        """Return storage and loss modulus of the network alone at the points of the sweep [Pa]."""
        storage, loss = np.asarray(self.storage), np.asarray(self.loss)
        if self.matrix is None or self.frequency is None:
            return np.maximum(storage - storage[-1], 0.0), loss - loss.min()
        matrix = complex(_core.complex_modulus(to_core(self.matrix), np.array([self.frequency]))[0])
        parts = []
        for name, whole, part in (("storage", storage, matrix.real), ("loss", loss, matrix.imag)):
            if whole.min() < (1.0 - _SCATTER) * part:
                raise InvalidInput(
                    name,
                    f"must be at least that of the matrix at {self.frequency:g} rad/s, {part:.4g} Pa",
                    f"{whole.min():.4g} Pa",
                )
            parts.append(np.maximum(whole - part, 0.0))
        return parts[0], parts[1]
