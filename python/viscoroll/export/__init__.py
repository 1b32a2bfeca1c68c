"""Export of results to other programs: rolling friction for discrete-element codes."""

from .balls import Balls
from .contact import OperatingPoint, Stiffness
from .dem import DemInput, dem
from .impact import Impact, impact

__all__ = ["Balls", "DemInput", "Impact", "OperatingPoint", "Stiffness", "dem", "impact"]
