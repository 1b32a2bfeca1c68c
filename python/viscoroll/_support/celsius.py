"""Temperatures in messages and printed texts: kelvin, as everywhere in this package, and degrees Celsius."""

from __future__ import annotations

__all__ = ["ZERO_CELSIUS", "celsius", "celsius_text", "kelvin_range", "kelvin_text"]

#: 0 °C [K].
ZERO_CELSIUS = 273.15

#: Decimal places of degrees Celsius: enough for any instrument, and without the round-off of the conversion.
_PLACES = 6


def celsius(temperature: float) -> float:
    """Return a temperature [K] in °C, without round-off in the last digits."""
    return round(float(temperature) - ZERO_CELSIUS, _PLACES) + 0.0


def celsius_text(temperature: float) -> str:
    """Return "20 °C" for 293.15 K."""
    return f"{celsius(temperature):.6g} °C"


def kelvin_text(temperature: float) -> str:
    """Return "293.15 K (20 °C)" for 293.15 K."""
    return f"{temperature:.6g} K ({celsius(temperature):.4g} °C)"


def kelvin_range(lowest: float, highest: float) -> str:
    """Return "273.15 to 293.15 K (0 to 20 °C)" for temperatures from 273.15 to 293.15 K."""
    return f"{lowest:.5g} to {highest:.5g} K ({celsius(lowest):.4g} to {celsius(highest):.4g} °C)"
