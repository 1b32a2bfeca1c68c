"""Rolling resistance of balls, rollers and wheels with viscoelastic layers.

    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    >>> ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    >>> r = vr.solve(ball, load=100.0, angular_speed=2.5)
    >>> print(f"{r.resisting_torque * 1e3:.0f} mN m")
    11 mN m

All quantities are in SI units and angles in radians. All moduli are shear moduli, except `bulk_modulus`.

Bodies, materials and solvers are names of this package. Its modules contain the rest:

- `materials`: all moduli; strain-dependent networks, shifts with temperature, moduli given by functions or by draws
- `rheology`: measured moduli and material files; hardness and rebound
- `rolling`: sensitivities, loss spectra and refinements of results
- `sliding`: results of rough surfaces that slide, and Persson's estimate
- `thermal`: temperature of the layers
- `coupled`: results of solves in which strain or temperature changes the moduli
- `studies`: fits to sweeps, and tables of the rolling resistance for other programs
- `export`: input of discrete-element programs
- `modal`: response of the layers to single orders, critical speeds and influence tables
- `analytic`: closed forms for comparison
- `enums`: enumerations of options and outcomes
- `finite_strain`: rollers at finite strain, by finite elements
- `paper`: the example of Zéhil and Gavin
"""

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
