"""Temperature ramps at one frequency, and what they can and cannot give."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .._support.arguments import Floats, as_float
from ..materials import LossFactor

__all__ = ["TemperatureRamp"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class TemperatureRamp:
    """Moduli over temperature at one frequency, the file that most laboratories send.

    It tells the modulus and the loss factor at that frequency, whatever the temperature. How both depend on frequency
    it does not tell: no two of its points overlap, so that no shift can be found from them. A master curve takes a law
    of the shift from elsewhere, measured or typical of the polymer: ``superpose(data, reference=..., factors=law)``.

    Attributes
    ----------
    frequency : float
        Angular frequency [rad/s].
    temperature : ndarray
        [°C], increasing.
    storage, loss : ndarray
        Shear moduli [Pa], > 0.
    """

    frequency: float
    temperature: Floats
    storage: Floats
    loss: Floats

    @property
    def loss_peak(self) -> float:
        """Temperature at which tan δ is largest [°C]: the glass transition, as seen at this frequency."""
        return float(self.temperature[np.argmax(self.loss / self.storage)])

    def at(self, *, temperature: float, decades: float = 3.0) -> LossFactor:
        """Return modulus and loss factor at a temperature, taken to hold around the frequency of the ramp.

        Parameters
        ----------
        temperature : float
            [°C], in the range of the ramp; logarithms of moduli are linear between its points.
        decades : float, default 3
            How far above and below the frequency of the ramp the loss factor is to hold, as of `LossFactor`: a guess,
            which the ramp does not support; solve with others to see what it matters.

        Returns
        -------
        LossFactor
            A modulus that layers take.

        Raises
        ------
        ValueError
            For a temperature that was not measured, and what `LossFactor` refuses.
        """
        degrees = as_float("temperature", temperature)
        low, high = self.temperature[0], self.temperature[-1]
        if not low <= degrees <= high:
            raise ValueError(f"temperature must be in [{low:g}, {high:g}] °C, where it was measured, got {degrees:g}")
        storage, loss = (
            math.exp(np.interp(degrees, self.temperature, np.log(values))) for values in (self.storage, self.loss)
        )
        return LossFactor(
            modulus=storage, loss_factor=loss / storage, reference_frequency=self.frequency, decades=decades
        )

    def __repr__(self) -> str:
        """Return what it is, and what can be had of it."""
        tan_delta = self.loss / self.storage
        return "\n".join(
            [
                f"a temperature ramp at one frequency, {self.frequency:.4g} rad/s "
                f"({self.frequency / math.tau:.4g} Hz): {self.temperature.size} points at "
                f"{self.temperature[0]:.4g} to {self.temperature[-1]:.4g} °C",
                f"  storage {self.storage.min():.4g} to {self.storage.max():.4g} Pa, tan δ {tan_delta.min():.3g} to "
                f"{tan_delta.max():.3g}, largest at {self.loss_peak:.4g} °C",
                "  it gives       modulus and loss factor at this frequency, by temperature: ramp.at(temperature=...)",
                "  it cannot give how they depend on frequency: no shift can be found at a single one",
                "  with a law     of the shift, measured or typical of the polymer, a master curve: "
                "superpose(data, reference=..., factors=law)",
            ]
        )
