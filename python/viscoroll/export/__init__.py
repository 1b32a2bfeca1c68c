"""What other programs take: rolling friction of discrete-element codes."""

from .balls import Balls
from .contact import OperatingPoint, Stiffness
from .dem import CODES, DemInput, dem

__all__ = ["CODES", "Balls", "DemInput", "OperatingPoint", "Stiffness", "dem"]
