"""Steady rolling: solve, and what that returns."""

from .result import Result
from .sensitivity import ModulusSensitivity, Sensitivity
from .steady import RollingModel, solve

__all__ = ["ModulusSensitivity", "Result", "RollingModel", "Sensitivity", "solve"]
