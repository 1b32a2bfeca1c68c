"""Steady sliding of a rigid rough surface on viscoelastic layers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import _core
from .._support.arguments import as_float, as_int, require_type
from .._support.errors import InvalidInput
from .._support.progress import ProgressLike, reporting
from .._support.result_warnings import warn
from ..bodies import CoatedPlane, HalfSpace
from ..bodies.layered import materials_of
from ..materials.softening import strain_amplitude
from .result import SlidingResult
from .rough_surface import RoughSurface
from .scalars import SLIDING_SCALARS
from .solution import Persson, rms_slope_at

__all__ = ["as_plane", "persson_estimate", "slide"]

#: Largest rms slope for which linear theory is trusted; the error grows with the square of the slope.
_LARGEST_SLOPE = 0.3
#: Factor between the strain amplitude of a filled rubber's modulus and that of the contact above which the modulus does
#: not apply.
_STRAIN_RANGE = 2.0
#: Share of the mean square slope in waves of fewer than four nodes above which the mesh does not resolve the surface.
_LARGEST_UNRESOLVED = 0.1
#: Difference of the two friction coefficients, relative to the larger one and in absolute terms, above which the mesh
#: is too coarse. At 1e-4, the tractions are noise of the mesh.
_LARGEST_ERROR = (0.05, 1e-3)


def slide(
    surface: RoughSurface,
    *,
    on: CoatedPlane | HalfSpace,
    pressure: float | None = None,
    load: float | None = None,
    speed: float,
    friction: float = 0.0,
    tolerance: float = 1e-9,
    max_iterations: int = 200,
    threads: int = 0,
    progress: ProgressLike = None,
) -> SlidingResult:
    """Solve the contact of a rigid rough surface that slides steadily, and its friction due to losses in the layers.

    There is no adhesion. The result depends on the shortest waves of the surface: compare two cutoffs
    (`RoughSurface.cutoff`), and two meshes (`RoughSurface.resampled`). The call releases the GIL, may run on several
    threads at once, and stops on Ctrl-C.

    Parameters
    ----------
    surface : RoughSurface
        One period of a periodic surface, or else a surface of finite size, around which the layers are free. The
        contact should not reach the rim of a finite surface, which would act as the edge of a punch.
    on : CoatedPlane or HalfSpace
        Layers on which it slides.
    pressure : float, optional
        Mean pressure over the surface [Pa], > 0. Exactly one of `pressure` and `load` must be given.
    load : float, optional
        Load on one period, or on the finite surface [N], > 0; of a profile, per length [N/m].
    speed : float
        Sliding speed along x [m/s], ≥ 0. At 0 the layers are relaxed. Greater than 0 with `friction`.
    friction : float, default 0.0
        Coulomb's coefficient of friction at the interface [-], ≥ 0. All nodes in contact slip. The friction pulls the
        layers along, which changes pressure and losses unless the layers are an incompressible half-space.
    tolerance : float, default 1e-9
        Relative residual of the contact equations, in [1e-13, 1e-3].
    max_iterations : int, default 200
        Largest number of linear systems solved on a mesh, ≥ 1.
    threads : int, default 0
        Number of threads; 0 for all cores. The result does not depend on it.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) about every 20 ms.

    Returns
    -------
    SlidingResult
        Friction coefficient with its error, contact area, gap and pressure, and Persson's estimate, which is NaN if
        the surface is not periodic.

    Raises
    ------
    ValueError
        If an argument is out of range, or both or neither of pressure and load are given.
    TypeError
        If an argument has the wrong type.
    ConvergenceError
        If the solver finds no usable state. The message contains the residual.
    KeyboardInterrupt
        On Ctrl-C, within 0.3 s.

    Warns
    -----
    ResultWarning
        If the contact did not converge, the layers do not recover within the period, the contact reaches the rim of a
        finite surface, slopes are large, the modulus of a filled rubber
        (`viscoroll.materials.SofteningModulus.at`) holds at another strain than that of the contact, or the mesh does
        not resolve the surface or the contact; also in `SlidingResult.warnings`.

    References
    ----------
    The theory is described in the chapter on sliding. Persson's estimate: B. N. J. Persson, J. Chem. Phys. 115 (2001)
    3840-3861.

    Examples
    --------
    >>> import numpy as np
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
    >>> wavy = vr.RoughSurface.of(lambda x, z: 1e-5 * np.cos(2e3 * np.pi * x), nodes=(512, 1), side=1e-3)
    >>> half_space = vr.HalfSpace(shear_modulus=rubber, poisson_ratio=0.5)
    >>> r = vr.slide(wavy, on=half_space, pressure=6e4, speed=0.01)
    >>> print(f"{r.friction_coefficient:.4f}")
    0.0146
    """
    plane = as_plane(on)
    mean = _mean_pressure(surface, pressure, load)
    velocity = as_float("speed", speed)
    with reporting(progress) as report:
        found = _core.slide(
            **_given(surface, plane, mean, velocity),
            periodic=surface.periodic,
            friction=as_float("friction", friction),
            tolerance=as_float("tolerance", tolerance),
            max_iterations=as_int("max_iterations", max_iterations),
            threads=as_int("threads", threads),
            progress=report,
        )
    messages = _warnings(surface, plane, found, max_iterations)
    warn(messages.values())
    return SlidingResult(
        surface=surface,
        on=plane,
        mean_pressure=mean,
        speed=velocity,
        pressure=found.pressure,
        gap=found.gap,
        converged=found.converged,
        persson=(
            _persson(surface, plane, mean, velocity, 0.5, threads)
            if surface.periodic
            else Persson(friction_coefficient=np.nan, contact_share=np.nan)
        ),
        friction=as_float("friction", friction),
        warnings=messages,
        **{name: getattr(found, name) for name in SLIDING_SCALARS},
    )


def persson_estimate(
    surface: RoughSurface, *, on: CoatedPlane | HalfSpace, pressure: float, speed: float, gamma: float = 0.5
) -> Persson:
    """Estimate friction and contact area by Persson's theory, from the spectrum of the surface.

    Parameters
    ----------
    surface, on, pressure, speed
        Same as in `slide`; the surface must be periodic.
    gamma : float, default 0.5
        Parameter γ of the factor S = γ + (1 - γ) A² that reduces the loss in partial contact, in [0, 1]. Without
        reduction, γ = 1.

    Returns
    -------
    Persson
        Friction coefficient and contact share.

    References
    ----------
    B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840-3861. M. Scaraggi and B. N. J. Persson, J. Phys.: Condens. Matter
    27 (2015) 105102 (the factor S).
    """
    mean = _mean_pressure(surface, pressure, None)
    if not surface.periodic:
        raise InvalidInput("surface.periodic", "must be True; use surface.mirrored()", "False")
    return _persson(surface, as_plane(on), mean, as_float("speed", speed), as_float("gamma", gamma), 0)


def _given(surface: RoughSurface, plane: CoatedPlane, pressure: float, speed: float) -> dict[str, Any]:
    """Return the arguments that the solver and Persson's estimate have in common."""
    return {
        "heights": surface.heights,
        "spacing_x": surface.spacing[0],
        "spacing_z": surface.spacing[1],
        "on": plane._to_core(),
        "pressure": pressure,
        "speed": speed,
    }


def _persson(
    surface: RoughSurface, plane: CoatedPlane, pressure: float, speed: float, gamma: float, threads: int
) -> Persson:
    found = _core.persson_estimate(
        **_given(surface, plane, pressure, speed),
        gamma=gamma,
        threads=threads,
    )
    return Persson(friction_coefficient=found.friction_coefficient, contact_share=found.contact_share)


def as_plane(on: object) -> CoatedPlane:
    """Return the plane, whose base may be given alone."""
    require_type("on", on, CoatedPlane | HalfSpace)
    return CoatedPlane(base=on) if isinstance(on, HalfSpace) else on  # type: ignore[return-value]


def _mean_pressure(surface: RoughSurface, pressure: float | None, load: float | None) -> float:
    """Return the mean pressure over the surface [Pa]."""
    require_type("surface", surface, RoughSurface)
    if (pressure is None) == (load is None):
        raise ValueError("exactly one of pressure and load must be given")
    if pressure is not None:
        return as_float("pressure", pressure)
    along, across = surface.sides
    return as_float("load", load) / (along if surface.is_profile else along * across)


def _warnings(
    surface: RoughSurface, plane: CoatedPlane, found: _core.SlidingResult, max_iterations: int
) -> Mapping[str, str]:
    """Return the warnings about a result, by kind."""
    messages = {}
    if not found.converged:
        messages["max_iterations"] = f"the contact still changed after {max_iterations} iterations (max_iterations)"
    period = surface.sides[0]
    if surface.periodic and found.memory_length > period:
        messages["own_track"] = (
            f"the layers recover over {found.memory_length:.3g} m, more than the period of {period:.3g} m: the surface "
            "slides in its own track; use a longer surface unless it repeats itself"
        )
    if not surface.periodic and _reaches_rim(found.pressure):
        messages["rim"] = (
            "the contact reaches the rim of the surface, which acts as the edge of a punch: take a larger surface, or "
            "continue it by surface.mirrored()"
        )
    slope = surface.rms_slope
    if slope > _LARGEST_SLOPE:
        messages["large_slope"] = (
            f"the rms slope of the surface is {slope:.3g} (recommended: at most {_LARGEST_SLOPE:g}): linear theory may "
            "be wrong by tens of percent; a larger cutoff has smaller slopes"
        )
    amplitudes = [*filter(None, (strain_amplitude(material.shear_modulus) for material in materials_of(plane)))]
    if amplitudes:
        strain = rms_slope_at(surface, found.pressure > 0.0)
        far = [amplitude for amplitude in amplitudes if not 1.0 / _STRAIN_RANGE <= strain / amplitude <= _STRAIN_RANGE]
        if far:
            messages["strain_amplitude"] = (
                f"the modulus of a filled rubber holds at a strain amplitude of {far[0]:.2g}, but the surface, with an "
                f"rms slope of {strain:.2g} in contact, strains the rubber by about that much: use the modulus at "
                f"{strain:.2g}"
            )
    unresolved = _unresolved_share(surface)
    lower, upper = sorted([found.friction_coefficient, found.traction_friction])
    relative, absolute = _LARGEST_ERROR
    if unresolved > _LARGEST_UNRESOLVED:
        messages["coarse_mesh"] = (
            f"waves shorter than four spacings have {unresolved:.0%} of the mean square slope (recommended: at most "
            f"{_LARGEST_UNRESOLVED:.0%}): apply a larger cutoff, or resample the surface after a cutoff"
        )
    elif upper - lower > max(relative * max(upper, -lower), absolute):
        messages["power_balance"] = (
            f"the friction coefficients from power and tractions differ by {upper - lower:.2g}: the mesh does not "
            "resolve the contacts; resample the surface on more nodes"
        )
    return messages


def _reaches_rim(pressure: NDArray[np.float64]) -> bool:
    """Return whether there is pressure at the ends of a profile, or at the sides of a map."""
    sides = [pressure[0], pressure[-1]]
    if pressure.shape[1] > 1:
        sides += [pressure[:, 0], pressure[:, -1]]
    return any(bool((side > 0.0).any()) for side in sides)


def _unresolved_share(surface: RoughSurface) -> float:
    """Return the share of waves shorter than four spacings in the mean square slope."""
    whole = surface if surface.periodic else surface.mirrored()
    k_x, k_z = whole._wavenumbers()
    squares = np.square(np.abs(np.fft.rfft2(whole.heights)))
    squares *= np.square(k_x)[:, np.newaxis] + np.square(k_z)[np.newaxis, :]
    squares[:, 1 : (whole.heights.shape[1] + 1) // 2] *= 2.0
    short = np.abs(k_x)[:, np.newaxis] > 0.5 * np.pi / whole.spacing[0] * (1.0 + 1e-9)
    short = short | (k_z[np.newaxis, :] > 0.5 * np.pi / whole.spacing[1] * (1.0 + 1e-9))
    total = float(squares.sum())
    return float(squares[short].sum()) / total if total > 0.0 else 0.0
