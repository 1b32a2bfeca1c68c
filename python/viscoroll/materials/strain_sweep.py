"""A network of filler as a measured strain sweep has it, less what of the sweep is the matrix's."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import as_floats, as_member, as_positive
from .moduli import ShearModulusLike, as_modulus, to_core
from .networks import Network

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .._support.arguments import Floats

__all__ = ["StrainKind", "StrainSweep"]

#: What a modulus of the sweep may lie below the matrix's, of itself: the scatter of a good instrument.
_SCATTER = 0.02


class StrainKind(Enum):
    """What an instrument calls the strain of a sweep."""

    SHEAR = 1.0
    """Amplitude of simple shear."""

    DOUBLE_SHEAR = 0.5
    """Shear from peak to peak, the double amplitude of the rubber trade."""

    TENSION = math.sqrt(3.0)
    """Amplitude of the elongation of a bar that keeps its volume."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StrainSweep(Network):
    """Measured moduli over strain at one frequency, linear in the logarithm of strain between the points.

    What of the sweep belongs to the matrix is taken off: the matrix's own modulus at the frequency of the sweep where
    that is given, else the last storage modulus, which it then keeps at any strain, and the least loss modulus. Outside
    of the sweep its ends are held; `strain_softening` warns of that.

    Parameters
    ----------
    strain : array_like
        Amplitudes [-], > 0, strictly increasing, at least three; not in percent.
    storage, loss : array_like
        Shear moduli of the filled rubber [Pa], > 0, as long as `strain`. Those of tension are three times as large.
    kind : StrainKind or str, default StrainKind.SHEAR
        What the strains are: amplitudes of shear, their doubles from peak to peak, or of tension.
    matrix : ShearModulus, callable or float, optional
        Modulus of the matrix [Pa], that of `SofteningModulus`.
    frequency : float, optional
        Of the sweep [rad/s], > 0; with a matrix.

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
        """Freeze the table and check it."""
        for name in ("strain", "storage", "loss"):
            object.__setattr__(self, name, as_floats(name, getattr(self, name)))
        object.__setattr__(self, "kind", as_member("kind", self.kind, StrainKind))
        if (self.matrix is None) != (self.frequency is None):
            raise ValueError("frequency must be given with matrix, and with matrix alone")
        if self.matrix is not None and self.frequency is not None:
            object.__setattr__(self, "matrix", as_modulus(self.matrix))
            object.__setattr__(self, "frequency", as_positive("frequency", self.frequency, "rad/s"))
        self._require_table()
        self._moduli(np.asarray(self.strain))

    def _require_table(self) -> None:
        lengths = [len(getattr(self, name)) for name in ("strain", "storage", "loss")]
        if len(set(lengths)) != 1 or lengths[0] < 3:
            raise ValueError(f"strain, storage and loss must have one length of at least 3, got {lengths}")
        strain = np.asarray(self.strain)
        if not (np.isfinite(strain).all() and strain[0] > 0.0 and (np.diff(strain) > 0.0).all()):
            raise ValueError(f"strain must be finite, > 0 and strictly increasing, got {strain[0]:g} to {strain[-1]:g}")
        if strain[0] >= 1.0:
            raise ValueError(f"strain must be a ratio, 0.01 for 1 %, got {strain[0]:g} to {strain[-1]:g}")
        for name in ("storage", "loss"):
            values = np.asarray(getattr(self, name))
            if not (np.isfinite(values).all() and (values > 0.0).all()):
                raise ValueError(f"{name} must be > 0 Pa, got {values.min():g}")

    @property
    def amplitudes(self) -> Floats:
        """Amplitudes of the equivalent simple shear [-]."""
        return np.asarray(self.strain) * self.kind.value

    @property
    def known_strains(self) -> tuple[float, float]:
        """First and last amplitude of shear strain [-]."""
        return float(self.amplitudes[0]), float(self.amplitudes[-1])

    @property
    def yield_strain(self) -> float:
        """Strain at which the storage modulus has fallen to half of its first value [-]."""
        storage = self._of_network()[0]
        below = np.flatnonzero(storage < 0.5 * storage[0])
        if not below.size:
            return self._beyond(storage)
        after = below[0]
        share = (storage[after - 1] - 0.5 * storage[0]) / (storage[after - 1] - storage[after])
        return float(self.amplitudes[after - 1] * (self.amplitudes[after] / self.amplitudes[after - 1]) ** share)

    def _beyond(self, storage: Floats) -> float:
        """Return where a hyperbolic law would have its half that falls as far as this one does by its end."""
        left = storage[-1] / storage[0]
        return math.inf if left >= 1.0 - 1e-12 else float(self.amplitudes[-1] * left / (1.0 - left))

    def _moduli(self, strain: Floats) -> tuple[Floats, Floats]:
        storage, loss = self._of_network()
        place = np.log(np.clip(strain, self.amplitudes[0], self.amplitudes[-1]))
        known = np.log(self.amplitudes)
        return np.interp(place, known, storage), np.interp(place, known, loss)

    def _of_network(self) -> tuple[Floats, Floats]:
        """Return storage and loss at the points of the sweep, without the matrix's [Pa]."""
        storage, loss = np.asarray(self.storage), np.asarray(self.loss)
        if self.matrix is None or self.frequency is None:
            return np.maximum(storage - storage[-1], 0.0), loss - loss.min()
        matrix = complex(_core.complex_modulus(to_core(self.matrix), np.array([self.frequency]))[0])
        parts = []
        for name, whole, part in (("storage", storage, matrix.real), ("loss", loss, matrix.imag)):
            if whole.min() < (1.0 - _SCATTER) * part:
                raise ValueError(
                    f"{name} must be at least that of the matrix at {self.frequency:g} rad/s, {part:.4g} Pa, "
                    f"got {whole.min():.4g} Pa"
                )
            parts.append(np.maximum(whole - part, 0.0))
        return parts[0], parts[1]
