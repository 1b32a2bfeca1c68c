"""Enumerations of options and of outcomes. Every option also accepts the name of a member as a string.

>>> from viscoroll import paper, solve
>>> solve(paper.ball(), load=100.0, angular_speed=2.5, accuracy=0.1, compliance="vertical").compliance.name
'VERTICAL'
"""

from ._core import (
    Compliance,
    Curvature,
    Extrapolation,
    Hub,
    InnerBoundary,
    PatchLoad,
    Sides,
    SlipKinematics,
    Start,
    Status,
    WarningKind,
)
from .materials.strain_sweep import StrainKind
from .thermal.surroundings import Core

__all__ = [
    "Compliance",
    "Core",
    "Curvature",
    "Extrapolation",
    "Hub",
    "InnerBoundary",
    "PatchLoad",
    "Sides",
    "SlipKinematics",
    "Start",
    "Status",
    "StrainKind",
    "WarningKind",
]
