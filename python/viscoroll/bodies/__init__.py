"""Rolling bodies, counterbodies, layers, meshes and drives."""

from .bodies import (
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    Counterbody,
    Groove,
    RollingBody,
    core_counterbody,
    is_body,
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
    "Counterbody",
    "Drive",
    "Groove",
    "HalfSpace",
    "Layer",
    "Mesh",
    "RollingBody",
    "core_counterbody",
    "is_body",
    "require_body",
]
