"""Parameter studies and fits to them (the extra `viscoroll[studies]`)."""

from .._support.least_squares import Fit, Parameter
from .fits import fit_friction_law, fit_power_law, fit_thickness_law
from .histories import sweep_histories
from .rolling_resistance import RollingResistance
from .study import sweep

__all__ = [
    "Fit",
    "Parameter",
    "RollingResistance",
    "fit_friction_law",
    "fit_power_law",
    "fit_thickness_law",
    "sweep",
    "sweep_histories",
]
