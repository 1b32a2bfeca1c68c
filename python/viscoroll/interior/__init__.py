"""Interior of the bodies: stress, dissipation and temperature, from the tractions of a solved contact.

Fields and loss are methods of `viscoroll.Result`: `interior`, `bonds` and `loss`.
"""

from ..solution.interior_fields import COMPONENTS, DIRECTIONS, order_fields
from .self_heating import SelfHeating, self_heating
from .softening_result import StrainSoftening
from .softening_search import softens
from .steady_states import Fold, SteadyState
from .strain_softening import strain_softening
from .temperature import Core, Temperature, plane_cooling, temperature

__all__ = [
    "COMPONENTS",
    "DIRECTIONS",
    "Core",
    "Fold",
    "SelfHeating",
    "SteadyState",
    "StrainSoftening",
    "Temperature",
    "order_fields",
    "plane_cooling",
    "self_heating",
    "softens",
    "strain_softening",
    "temperature",
]
