"""What rolls, what it rolls on, how it is meshed and driven, and how its layers answer single orders."""

from .bodies import CoatedCylinder, CoatedPlane, CoatedSphere, Counterpart, Groove, RollingBody
from .drive import Drive
from .layers import HalfSpace, Layer
from .mesh import Mesh
from .orders import (
    centrifugal_displacement,
    critical_speed,
    degree_compliance,
    influence_tables,
    state_matrix,
    surface_compliance,
)

__all__ = [
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
    "centrifugal_displacement",
    "critical_speed",
    "degree_compliance",
    "influence_tables",
    "state_matrix",
    "surface_compliance",
]
