"""What a history is a time series of."""

from __future__ import annotations

from .._support.units import unit_in_contact

__all__ = ["SERIES", "series_units"]

#: Time series: name, unit, what it is.
SERIES = {
    "angle": ("rad", "angle turned ψ, forward"),
    "load": ("N", "load P"),
    "resisting_torque": ("N m", "resisting torque T_r, offset of the pressure times P"),
    "driving_torque": ("N m", "driving torque T"),
    "penetration": ("m", "approach of the bodies, r_o - H"),
    "contact_area": ("m^2", "contact area"),
    "semi_axis_x": ("m", "contact semi-axis along x"),
    "semi_axis_z": ("m", "contact semi-axis along z"),
    "max_pressure": ("Pa", "largest contact pressure"),
    "stored_energy": ("J", "energy stored in all"),
    "counterpart_stored_energy": ("J", "energy stored in what it rolls on"),
    "dissipated_energy": ("J", "energy lost in all and by slip since the start"),
    "counterpart_dissipated_energy": ("J", "energy lost in what it rolls on since the start"),
    "work": ("J", "work of rolling and load since the start"),
    "energy_imbalance": ("J", "work less what was stored and lost"),
    "driving_force": ("N", "driving force Q"),
    "center_way": ("m", "way of the center since the start"),
    "center_speed": ("m/s", "speed of the center"),
    "slip_energy": ("J", "energy lost by slip since the start"),
    "stick_share": ("1", "share of the nodes in contact that stick"),
    "error_estimate": ("N m", "error estimate of the torque"),
}


def series_units(*, line_contact: bool) -> dict[str, str]:
    """Return the unit of every time series."""
    return {name: unit_in_contact(unit, line_contact=line_contact) for name, (unit, _) in SERIES.items()}
