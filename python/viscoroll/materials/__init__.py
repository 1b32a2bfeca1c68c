"""Shear moduli of viscoelastic materials, strain-dependent filler networks and time-temperature shifts."""

from .draws import Draws
from .loss_factor import LossFactor
from .moduli import (
    Elastic,
    FractionalZener,
    KelvinVoigt,
    MasterCurve,
    Prony,
    ShearModulus,
    ShearModulusLike,
    StandardLinearSolid,
)
from .networks import KrausNetwork, MasingNetwork, Network
from .shift import Arrhenius, Shift, WilliamsLandelFerry
from .softening import SoftenedModulus, SofteningModulus
from .strain_sweep import StrainKind, StrainSweep

__all__ = [
    "Arrhenius",
    "Draws",
    "Elastic",
    "FractionalZener",
    "KelvinVoigt",
    "KrausNetwork",
    "LossFactor",
    "MasingNetwork",
    "MasterCurve",
    "Network",
    "Prony",
    "ShearModulus",
    "ShearModulusLike",
    "Shift",
    "SoftenedModulus",
    "SofteningModulus",
    "StandardLinearSolid",
    "StrainKind",
    "StrainSweep",
    "WilliamsLandelFerry",
]
