"""Transient rolling: start, stop, stand, reverse."""

from .history import History
from .rolling_history import RollingHistory, RollingState
from .roll import roll

__all__ = ["History", "RollingHistory", "RollingState", "roll"]
