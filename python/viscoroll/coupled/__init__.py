"""Solves in which strain or temperature changes the moduli: `strain_softening` and `self_heating`."""

from .self_heating import SelfHeating, self_heating
from .softening import strain_softening
from .softening_result import StrainSoftening
from .steady_states import Fold, SteadyState

__all__ = ["Fold", "SelfHeating", "SteadyState", "StrainSoftening", "self_heating", "strain_softening"]
