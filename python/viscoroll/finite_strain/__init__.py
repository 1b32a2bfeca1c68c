"""Rolling of covered rollers at finite strain, by viscoelastic finite elements in plane strain.

    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=0.01)
    >>> cover = vr.Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.5)
    >>> roller = vr.CoatedCylinder(core_radius=40e-3, layers=[cover])
    >>> r = vr.finite_strain.solve(roller, load=20e3, angular_speed=9.0, elements_across=24, elements_through=4)
    >>> f"strain {r.strain:.2f}, torque {r.driving_torque:.0f} N m/m, overspeed {r.overspeed:.2f}"
    'strain 0.11, torque 36 N m/m, overspeed 0.09'

`solve` computes one load or penetration, `ladder` several penetrations. Both need SciPy, which
``pip install 'viscoroll[studies]'`` installs.
"""

from .laws import Elasticity, Law, MooneyRivlin, NeoHookean, Yeoh
from .result import FiniteStrainResult
from .solver import ladder, solve

__all__ = [
    "Elasticity",
    "FiniteStrainResult",
    "Law",
    "MooneyRivlin",
    "NeoHookean",
    "Yeoh",
    "ladder",
    "solve",
]
