from .constants import MaterialConstants, read_constants
from .draws import Draws
from .moduli import (
    CreepCompliance,
    Elastic,
    FractionalZener,
    HavriliakNegami,
    KelvinVoigt,
    LossFactor,
    MasterCurve,
    Prony,
    ShearModulus,
    StandardLinearSolid,
)
from .networks import KrausNetwork, MasingNetwork
from .shift import Arrhenius, WilliamsLandelFerry
from .softening import SoftenedModulus, SofteningModulus
from .strain_sweep import StrainSweep

__all__ = [
    "Arrhenius",
    "CreepCompliance",
    "Draws",
    "Elastic",
    "FractionalZener",
    "HavriliakNegami",
    "KelvinVoigt",
    "KrausNetwork",
    "LossFactor",
    "MasingNetwork",
    "MasterCurve",
    "MaterialConstants",
    "Prony",
    "ShearModulus",
    "SoftenedModulus",
    "SofteningModulus",
    "StandardLinearSolid",
    "StrainSweep",
    "WilliamsLandelFerry",
    "read_constants",
]
