"""What rolls, what it rolls on, how it is meshed and driven; `orders` is how its layers answer."""

from .bodies import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    Counterpart,
    Groove,
    RollingBody,
    core_counterpart,
    require_body,
)
from .drive import Drive
from .layers import HalfSpace, Layer
from .mesh import Mesh
from .wheel import CoatedWheel

__all__ = [
    "CoatedCylinder",
    "CoatedPlane",
    "CoatedSphere",
    "CoatedWheel",
    "Counterpart",
    "Drive",
    "Groove",
    "HalfSpace",
    "Layer",
    "Mesh",
    "RollingBody",
    "core_counterpart",
    "require_body",
]
