"""Units of parameters, by name, and units in line contact."""

from __future__ import annotations

__all__ = ["UNITS", "unit_in_contact"]

#: Units in line contact of quantities that are per length there.
_PER_LENGTH = {
    "N m": "N",
    "N": "N/m",
    "N/m": "N/m^2",
    "N s/m": "N s/m^2",
    "W": "W/m",
    "J": "J/m",
    "kg": "kg/m",
    "m^2": "m",
}

#: Units of parameters of this package. Moduli, bodies and drives add those of their parameters.
UNITS = {
    "load": "N",
    "penetration": "m",
    "angular_speed": "rad/s",
    "speed": "m/s",
    "friction": "1",
    "accuracy": "1",
    "max_iterations": "1",
    "nodes_per_revolution": "1",
    "max_order": "1",
    "theta_nodes_per_revolution": "1",
    "outer_radius": "m",
    "outer_diameter": "m",
    "thickness": "m",
    "density": "kg/m^3",
    "conductivity": "W/(m K)",
    "poisson_ratio": "1",
    "bulk_modulus": "Pa",
    "hardness": "Shore",
    "rebound": "1",
    "critical_strain": "1",
    "exponent": "1",
    "strain": "1",
    "temperature": "K",
}


def unit_in_contact(unit: str, *, line_contact: bool) -> str:
    """Return a unit in point or line contact; in line contact, extensive quantities are per length."""
    return _PER_LENGTH.get(unit, unit) if line_contact else unit
