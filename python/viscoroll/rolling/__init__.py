"""Steady rolling: solve, and what that returns."""

from .result import Refinement, Result
from .steady import RollingModel, solve

__all__ = ["Refinement", "Result", "RollingModel", "solve"]
