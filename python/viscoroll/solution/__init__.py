"""A solved contact: its numbers and fields, and all that looks into them."""

from .loss_spectrum import LossSpectrum, loss_spectrum
from .scalars import SCALARS
from .solution import FIELDS, VECTOR_FIELDS, Refinement, Solution

__all__ = [
    "FIELDS",
    "SCALARS",
    "VECTOR_FIELDS",
    "LossSpectrum",
    "Refinement",
    "Solution",
    "loss_spectrum",
]
