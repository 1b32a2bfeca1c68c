"""Transient rolling: start, stop, stand, reverse."""

from .history import History
from .roll import roll
from .rolling_history import RollingHistory, RollingState

__all__ = ["History", "RollingHistory", "RollingState", "roll"]
