"""Temperature ramps at one frequency, and their limitations."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .._support.arguments import Floats, as_kelvin
from .._support.celsius import kelvin_range, kelvin_text
from .._support.errors import InvalidInput
from ..materials import LossFactor

__all__ = ["TemperatureRamp"]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False, repr=False)
class TemperatureRamp:
    """Moduli over temperature at one frequency, the most common measurement of a laboratory.

    A ramp contains modulus and loss factor at its frequency, for any temperature in its range. It does not contain
    their dependence on frequency, and no shift can be determined from it: a shift requires isotherms whose frequency
    ranges overlap. A master curve needs a shift
    law from another source, measured or typical of the polymer: ``superpose(data, reference=..., factors=law)``.

    Attributes
    ----------
    frequency : float
        Angular frequency [rad/s].
    temperature : ndarray
        Temperatures [K], increasing.
    storage, loss : ndarray
        Shear moduli [Pa], > 0.
    """

    frequency: float
    temperature: Floats
    storage: Floats
    loss: Floats

    def __post_init__(self) -> None:
        """Check that temperatures are in kelvin."""
        for index, temperature in enumerate(self.temperature):
            as_kelvin(f"temperature[{index}]", temperature)

    @property
    def loss_peak(self) -> float:
        """Temperature at which tan δ has its maximum [K]: the glass transition at this frequency."""
        return float(self.temperature[np.argmax(self.loss / self.storage)])

    def at(self, *, temperature: float, decades: float = 3.0) -> LossFactor:
        """Return the modulus at a temperature, with a loss factor that is assumed constant around the ramp frequency.

        Parameters
        ----------
        temperature : float
            Temperature [K], within the ramp. The logarithms of the moduli are interpolated linearly between its
            points.
        decades : float, default 3
            Decades above and below the frequency of the ramp over which the loss factor is assumed constant [-],
            in [0.5, 8], the same as in `LossFactor`. The ramp does not support this assumption; solve with other values
            to see their effect.

        Returns
        -------
        LossFactor
            Shear modulus of a layer.

        Raises
        ------
        ValueError
            If the temperature is outside the ramp, or `LossFactor` rejects a parameter.
        """
        kelvin = as_kelvin("temperature", temperature)
        low, high = self.temperature[0], self.temperature[-1]
        if not low <= kelvin <= high:
            raise InvalidInput(
                "temperature", f"must be in the measured range, {kelvin_range(low, high)}", f"{kelvin_text(kelvin)}"
            )
        storage, loss = (
            math.exp(np.interp(kelvin, self.temperature, np.log(values))) for values in (self.storage, self.loss)
        )
        return LossFactor(
            modulus=storage, loss_factor=loss / storage, reference_frequency=self.frequency, decades=decades
        )

    def __repr__(self) -> str:
        """Return a summary: frequency and ranges of the ramp, what it provides, and how to obtain a master curve."""
        tan_delta = self.loss / self.storage
        return "\n".join(
            [
                f"a temperature ramp at one frequency, {self.frequency:.4g} rad/s "
                f"({self.frequency / math.tau:.4g} Hz): {self.temperature.size} points at "
                f"{kelvin_range(self.temperature[0], self.temperature[-1])}",
                f"  storage {self.storage.min():.4g} to {self.storage.max():.4g} Pa, tan δ {tan_delta.min():.3g} to "
                f"{tan_delta.max():.3g}, largest at {kelvin_text(self.loss_peak)}",
                "  available      modulus and loss factor at this frequency: ramp.at(temperature=...)",
                "  unavailable    dependence on frequency: data at a single frequency do not determine a shift",
                "  master curve   with a shift law, measured or typical of the polymer: "
                "superpose(data, reference=..., factors=law)",
            ]
        )
