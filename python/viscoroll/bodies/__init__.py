"""What rolls, what it rolls on, how it is meshed and driven; `orders` is how its layers answer."""

from .bodies import COUNTERPARTS, CoatedCylinder, CoatedPlane, CoatedSphere, Counterpart, Groove, RollingBody
from .drive import Drive
from .layers import HalfSpace, Layer
from .mesh import Mesh

__all__ = [
    "COUNTERPARTS",
    "CoatedCylinder",
    "CoatedPlane",
    "CoatedSphere",
    "Counterpart",
    "Drive",
    "Groove",
    "HalfSpace",
    "Layer",
    "Mesh",
    "RollingBody",
]
