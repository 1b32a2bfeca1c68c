from . import (
    analytic,
    coupled,
    enums,
    export,
    finite_strain,
    materials,
    modal,
    paper,
    rheology,
    rolling,
    sliding,
    studies,
    thermal,
)
from ._core import ConvergenceError, __version__
from ._support.errors import InvalidInput
from ._support.result_warnings import ResultWarning
from .bodies import (
    Adhesion,
    CoatedCylinder,
    CoatedPlane,
    CoatedSphere,
    CoatedWheel,
    Drive,
    Groove,
    HalfSpace,
    Layer,
    Mesh,
)
from .coupled import self_heating, strain_softening
from .ground import Axle, Profile
from .materials import (
    Elastic,
    LossFactor,
    MasterCurve,
    Prony,
    StandardLinearSolid,
)
from .rolling import Result, RollingModel, pull_off, solve
from .sliding import RoughSurface, slide
from .studies import sweep
from .transient import History, RollingHistory, RollingState, roll

__all__ = [
    "Adhesion",
    "Axle",
    "CoatedCylinder",
    "CoatedPlane",
    "CoatedSphere",
    "CoatedWheel",
    "ConvergenceError",
    "Drive",
    "Elastic",
    "Groove",
    "HalfSpace",
    "History",
    "InvalidInput",
    "Layer",
    "LossFactor",
    "MasterCurve",
    "Mesh",
    "Profile",
    "Prony",
    "Result",
    "ResultWarning",
    "RollingHistory",
    "RollingModel",
    "RollingState",
    "RoughSurface",
    "StandardLinearSolid",
    "__version__",
    "analytic",
    "coupled",
    "enums",
    "export",
    "finite_strain",
    "materials",
    "modal",
    "paper",
    "pull_off",
    "rheology",
    "roll",
    "rolling",
    "self_heating",
    "slide",
    "sliding",
    "solve",
    "strain_softening",
    "studies",
    "sweep",
    "thermal",
]
