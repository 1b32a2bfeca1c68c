"""Steady rolling: `solve`, `RollingModel` and their results."""

from .modulus_sensitivity import ModulusSensitivity
from .result import Result
from .sensitivity import Sensitivity
from .steady import RollingModel, solve

__all__ = ["ModulusSensitivity", "Result", "RollingModel", "Sensitivity", "solve"]
