"""Export of results to other programs: rolling friction for discrete-element codes."""

from .balls import Balls
from .contact import OperatingPoint, Stiffness
from .dem import CODES, DemInput, dem

__all__ = ["CODES", "Balls", "DemInput", "OperatingPoint", "Stiffness", "dem"]
