"""What other programs take: rolling friction of discrete-element codes."""

from .contact import OperatingPoint, Stiffness
from .dem import CODES, DemInput, dem

__all__ = ["CODES", "DemInput", "OperatingPoint", "Stiffness", "dem"]
