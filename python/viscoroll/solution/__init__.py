"""Solution of a contact: its scalars and fields, and the methods that evaluate them."""

from .loss_spectrum import LossSpectrum
from .scalars import SCALARS
from .solution import FIELDS, VECTOR_FIELDS, Refinement, Solution

__all__ = [
    "FIELDS",
    "SCALARS",
    "VECTOR_FIELDS",
    "LossSpectrum",
    "Refinement",
    "Solution",
]
