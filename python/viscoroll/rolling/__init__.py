"""Steady rolling: solve, and what that returns."""

from .result import Result
from .steady import RollingModel, solve

__all__ = ["Result", "RollingModel", "solve"]
