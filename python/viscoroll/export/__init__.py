"""Export of results to other programs: rolling friction for discrete-element codes."""

from .balls import Balls
from .contact import OperatingPoint, Stiffness
from .dem import DemInput, dem

__all__ = ["Balls", "DemInput", "OperatingPoint", "Stiffness", "dem"]
