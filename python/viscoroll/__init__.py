"""Rolling resistance of balls, rollers and wheels with viscoelastic layers.

    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    >>> layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5, density=1000.0)
    >>> ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    >>> r = vr.solve(ball, load=100.0, angular_speed=2.5)
    >>> print(f"{r.resisting_torque * 1e3:.0f} mN m")
    11 mN m

All quantities are in SI units; angles are in radians and all moduli are shear moduli.
"""

from . import analytic, paper
from ._core import (
    Compliance,
    ConvergenceError,
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
    __version__,
)
from ._support.cautions import ResultWarning
from ._support.keywords import explain_keywords
from .bodies import CoatedCylinder, CoatedPlane, CoatedSphere, CoatedWheel, Drive, Groove, HalfSpace, Layer, Mesh
from .bodies.orders import (
    centrifugal_displacement,
    critical_speed,
    degree_compliance,
    influence_tables,
    state_matrix,
    surface_compliance,
)
from .export import dem
from .interior import Core, StrainSoftening, Temperature, plane_cooling, self_heating, strain_softening, temperature
from .materials import (
    Arrhenius,
    Draws,
    Elastic,
    FractionalZener,
    KelvinVoigt,
    KrausNetwork,
    MasingNetwork,
    MasterCurve,
    Prony,
    ShearModulus,
    SofteningModulus,
    StandardLinearSolid,
    StrainKind,
    StrainSweep,
    WilliamsLandelFerry,
)
from .rheology import (
    LossFactor,
    ShiftFactors,
    check_modulus,
    check_range,
    example_data,
    example_material,
    fit_network,
    fit_prony,
    hardness_to_modulus,
    load_material,
    read_rheology,
    read_strain_sweep,
    rebound_to_loss_factor,
    rolling_range,
    save_material,
    superpose,
)
from .rolling import ModulusSensitivity, Result, RollingModel, Sensitivity, solve
from .solution import LossSpectrum, Refinement, loss_spectrum
from .studies import Fit, Parameter, fit_friction_law, fit_power_law, fit_thickness_law, sweep
from .studies.rolling_resistance import RollingResistance
from .transient import History, RollingHistory, RollingState, roll

__all__ = [
    "Arrhenius",
    "CoatedCylinder",
    "CoatedPlane",
    "CoatedSphere",
    "CoatedWheel",
    "Compliance",
    "ConvergenceError",
    "Core",
    "Curvature",
    "Draws",
    "Drive",
    "Elastic",
    "Extrapolation",
    "Fit",
    "FractionalZener",
    "Groove",
    "HalfSpace",
    "History",
    "Hub",
    "InnerBoundary",
    "KelvinVoigt",
    "KrausNetwork",
    "Layer",
    "LossFactor",
    "LossSpectrum",
    "MasingNetwork",
    "MasterCurve",
    "Mesh",
    "ModulusSensitivity",
    "Parameter",
    "PatchLoad",
    "Prony",
    "Refinement",
    "Result",
    "ResultWarning",
    "RollingHistory",
    "RollingModel",
    "RollingResistance",
    "RollingState",
    "Sensitivity",
    "ShearModulus",
    "ShiftFactors",
    "Sides",
    "SlipKinematics",
    "SofteningModulus",
    "StandardLinearSolid",
    "Start",
    "Status",
    "StrainKind",
    "StrainSoftening",
    "StrainSweep",
    "Temperature",
    "WarningKind",
    "WilliamsLandelFerry",
    "__version__",
    "analytic",
    "centrifugal_displacement",
    "check_modulus",
    "check_range",
    "critical_speed",
    "degree_compliance",
    "dem",
    "example_data",
    "example_material",
    "fit_friction_law",
    "fit_network",
    "fit_power_law",
    "fit_prony",
    "fit_thickness_law",
    "hardness_to_modulus",
    "influence_tables",
    "load_material",
    "loss_spectrum",
    "paper",
    "plane_cooling",
    "read_rheology",
    "read_strain_sweep",
    "rebound_to_loss_factor",
    "roll",
    "rolling_range",
    "save_material",
    "self_heating",
    "solve",
    "state_matrix",
    "strain_softening",
    "superpose",
    "surface_compliance",
    "sweep",
    "temperature",
]

explain_keywords(globals())
