"""Shear moduli, and how temperature shifts them."""

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
from .shift import Arrhenius, Shift, WilliamsLandelFerry

__all__ = [
    "Arrhenius",
    "Elastic",
    "FractionalZener",
    "KelvinVoigt",
    "LossFactor",
    "MasterCurve",
    "Prony",
    "ShearModulus",
    "ShearModulusLike",
    "Shift",
    "StandardLinearSolid",
    "WilliamsLandelFerry",
]
