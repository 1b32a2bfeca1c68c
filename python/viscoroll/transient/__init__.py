"""Transient rolling: `roll` and `RollingHistory` follow motions with starts, stops, rests and reversals."""

from .history import History
from .roll import roll
from .rolling_history import RollingHistory, RollingState

__all__ = ["History", "RollingHistory", "RollingState", "roll"]
