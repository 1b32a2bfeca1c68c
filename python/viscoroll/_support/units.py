"""Units of parameters, by name, and units in line contact."""

from __future__ import annotations

__all__ = ["DISPLAY_UNITS", "PER_LENGTH", "UNITS", "suitable_unit", "unit_in_contact"]

#: Units in line contact of quantities that are per length there.
PER_LENGTH = {
    "N m": "N m/m",
    "N": "N/m",
    "N/m": "N/m^2",
    "N s/m": "N s/m^2",
    "W": "W/m",
    "J": "J/m",
    "kg": "kg/m",
    "m^2": "m",
}

#: Prefixes of usual units: their SI values, and the smallest values displayed with them.
_PREFIXES = {"k": (1e3, 1e3), "": (1.0, 1.0), "m": (1e-3, 1e-4), "µ": (1e-6, 1e-7), "n": (1e-9, 0.0)}

#: Units in which values are displayed, by SI unit: the SI value of each, and the smallest value displayed in it, from
#: large to small. Lengths are in mm up to 1 m, and pressures in MPa from 0.1 MPa, as in data sheets.
DISPLAY_UNITS = {
    **{
        unit: {f"{prefix}{unit}": pair for prefix, pair in _PREFIXES.items()}
        for unit in ("N", "N m", "N m/m", "W", "W/m", "J", "J/m")
    },
    "N/m": {"kN/m": (1e3, 1e3), "N/m": (1.0, 1.0), "mN/m": (1e-3, 0.0)},
    "m": {"m": (1.0, 1.0), "mm": (1e-3, 1e-5), "µm": (1e-6, 1e-8), "nm": (1e-9, 0.0)},
    "m^2": {"m²": (1.0, 1.0), "mm²": (1e-6, 1e-9), "µm²": (1e-12, 0.0)},
    "m/s": {"m/s": (1.0, 0.1), "mm/s": (1e-3, 1e-4), "µm/s": (1e-6, 0.0)},
    "Pa": {"GPa": (1e9, 1e9), "MPa": (1e6, 1e5), "kPa": (1e3, 1e3), "Pa": (1.0, 0.0)},
    "J/m^3": {"MJ/m³": (1e6, 1e6), "kJ/m³": (1e3, 1e3), "J/m³": (1.0, 1.0), "mJ/m³": (1e-3, 0.0)},
    "Pa s": {"MPa s": (1e6, 1e6), "kPa s": (1e3, 1e3), "Pa s": (1.0, 1.0), "mPa s": (1e-3, 0.0)},
    "s": {"s": (1.0, 1.0), "ms": (1e-3, 1e-3), "µs": (1e-6, 1e-6), "ns": (1e-9, 0.0)},
}

#: Units of parameters of this package. Moduli, bodies and drives add those of their parameters.
UNITS = {
    "load": "N",
    "penetration": "m",
    "angular_speed": "rad/s",
    "speed": "m/s",
    "pressure": "Pa",
    "cutoff": "m",
    "rolloff": "m",
    "rms_height": "m",
    "rms_slope": "1",
    "hurst": "1",
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
    """Return a unit in point or line contact; in line contact, forces, torques, powers and areas are per length."""
    return PER_LENGTH.get(unit, unit) if line_contact else unit


def suitable_unit(size: float, unit: str) -> tuple[str, float]:
    """Return the unit in which a value is displayed, and the SI value of this unit.

    Parameters
    ----------
    size : float
        Value in SI units; of several with a common unit, the one with the largest absolute value.
    unit : str
        SI unit; "1" for a pure number, which has no unit.

    Examples
    --------
    >>> suitable_unit(8.46e6, "Pa")
    ('MPa', 1000000.0)
    >>> suitable_unit(0.012, "1")
    ('', 1.0)
    """
    if unit == "1":
        return "", 1.0
    displayed = DISPLAY_UNITS.get(unit, {})
    if size == 0.0 or not displayed:
        return next((name for name, (scale, _) in displayed.items() if scale == 1.0), unit), 1.0
    name = next((name for name, (_, least) in displayed.items() if abs(size) >= least), [*displayed][-1])
    return name, displayed[name][0]
