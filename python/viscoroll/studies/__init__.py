"""Parameter studies and fits to them (the extra `viscoroll[studies]`)."""

from .fits import fit_friction_law, fit_power_law, fit_thickness_law
from .least_squares import Fit, Parameter
from .study import sweep

__all__ = ["Fit", "Parameter", "fit_friction_law", "fit_power_law", "fit_thickness_law", "sweep"]
