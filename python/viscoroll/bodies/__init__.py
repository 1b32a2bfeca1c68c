"""Rolling bodies, counterbodies, layers, meshes, drives and adhesion."""

from .adhesion import Adhesion
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
    "Adhesion",
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
