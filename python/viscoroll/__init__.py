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
- `studies`: sweeps of histories, fits to sweeps, and tables of the rolling resistance for other programs
- `export`: input of discrete-element programs
- `modal`: response of the layers to single orders, critical speeds and influence tables
- `analytic`: closed forms for comparison
- `enums`: enumerations of options and outcomes
- `finite_strain`: rollers at finite strain, by finite elements
- `paper`: the example of Zéhil and Gavin
"""

from ._support.lazy import lazy_names

__getattr__, __dir__, __all__ = lazy_names(__name__, __path__)
