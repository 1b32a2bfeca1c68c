"""Steady rolling: `solve`, `RollingModel` and their results."""

from ..solution import LossSpectrum, Refinement
from .modulus_sensitivity import ModulusSensitivity
from .result import Result
from .sensitivity import Sensitivity
from .steady import RollingModel, pull_off, solve

__all__ = [
    "LossSpectrum",
    "ModulusSensitivity",
    "Refinement",
    "Result",
    "RollingModel",
    "Sensitivity",
    "pull_off",
    "solve",
]
