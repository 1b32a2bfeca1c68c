"""Steady rolling at finite strain, for one load or penetration or for a ladder of penetrations."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from .._core import ConvergenceError
from .._support.arguments import as_count, as_float, as_floats, as_positive
from .._support.errors import InvalidInput
from .._support.progress import ProgressLike, Report, reporting
from .._support.result_warnings import warn
from ..bodies.si_hints import si_hints, unit_doubt
from .equilibrium import Equilibrium, Rolling, Target
from .problem import LARGEST_STRAIN, Problem, problem
from .result import FiniteStrainResult, result_of

if TYPE_CHECKING:
    from ..bodies import CoatedCylinder, Counterbody
    from .cover import CoverState
    from .laws import Elasticity, Law

__all__ = ["ladder", "solve"]

#: First strain from the undeformed cover, and largest increment of strain between two equilibria.
_FIRST_STRAIN, _INCREMENT = 0.03, 0.06

#: Relative difference from the smallest strain that passes, because the message rounds the limit.
_ROUNDING = 1e-3

#: Number of times an increment is halved if Newton's method fails.
_HALVINGS = 6

#: Allowed half-angle of the contact per half-angle of the fine part of the mesh, their ratio in a new mesh, and the
#: largest number of meshes.
_LOWEST_FILL, _HIGHEST_FILL, _FILL, _MESHES = 0.55, 0.97, 0.88, 3

#: Strains of the estimate of the penetration under a load, and its elements across the contact and along the radius.
_PILOT_STRAINS, _PILOT_ELEMENTS = (0.02, 0.05, 0.09, 0.14, 0.2, 0.27, 0.35, 0.43, 0.5), (16, 3)

_Found = tuple[FiniteStrainResult, ...]


def solve(
    roller: CoatedCylinder,
    *,
    on: Counterbody | None = None,
    load: float | None = None,
    penetration: float | None = None,
    angular_speed: float,
    law: Law | str = "newton",
    elasticity: Elasticity | None = None,
    elements_across: int = 40,
    elements_through: int = 6,
    progress: ProgressLike = None,
) -> FiniteStrainResult:
    """Solve steady rolling of a covered roller on a rigid body, without friction and inertia, at finite strain.

    Parameters
    ----------
    roller : CoatedCylinder
        Roller whose layers have sums of exponentials as relaxation functions (`Elastic`, `StandardLinearSolid`,
        `Prony`, `CreepCompliance`) and a Poisson's ratio from 0.48 to 0.5. The density has no effect.
    on : CoatedPlane, CoatedCylinder or Groove, optional
        Rigid counterbody: a plane, which is the default, a roller, or a drum around the roller (a groove that is curved
        along the path).
    load : float, optional
        Load P per length [N/m], > 0. Exactly one of `load` and `penetration` must be given. The penetration that it
        causes has the limits of `penetration`.
    penetration : float, optional
        Penetration r_o - H [m], from 0.1 % to 50 % of the thickness h of the cover. The lower limit is larger,
        0.005 h² (1/r_o + 1/R'), if the cover is thick or the counterbody has a small radius R': the half-length of the
        contact must be at least 3 % of the thickness. `viscoroll.solve` solves smaller strains.
    angular_speed : float
        Ω relative to the line of centers [rad/s], > 0.
    law : Law or str, default "newton"
        Law of the viscous stress: "newton", "simo" or "abaqus". Up to 10 % strain, their torques differ by 1 to 2 %; at
        20 %, by 5 to 14 %.
    elasticity : NeoHookean, MooneyRivlin or Yeoh, default NeoHookean()
        Elastic law. Its shear modulus at small strain is that of each layer.
    elements_across : int, default 40
        Number of elements over the length of the contact at the largest strain, from 8 to 400.
    elements_through : int, default 6
        Number of elements through a cover that is thinner than the contact is long, from 2 to 40. A thicker cover has
        more of them, finer near the surface.
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction) after every equilibrium.

    Returns
    -------
    FiniteStrainResult
        Torque, load, penetration, overspeed, contact pressure and fields.

    Raises
    ------
    ValueError, TypeError
        If an argument is invalid; the message contains parameter, value, unit and allowed range.
    ConvergenceError
        If no equilibrium is found, for example because the surface folds onto itself.
    ImportError
        If SciPy is missing (the extra `viscoroll[studies]`).
    KeyboardInterrupt
        On Ctrl-C.

    Warns
    -----
    ResultWarning
        If the strain is above 0.15, where the laws differ by more than 2 %, or if the mesh is too coarse; also in
        `FiniteStrainResult.warnings`. If lengths or moduli look as if they were not given in SI units.

    Examples
    --------
    >>> import viscoroll as vr
    >>> rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1e6, relaxation_time=0.01)
    >>> cover = vr.Layer(thickness=10e-3, shear_modulus=rubber, poisson_ratio=0.5)
    >>> roller = vr.CoatedCylinder(core_radius=40e-3, layers=[cover])
    >>> r = solve(roller, penetration=1e-3, angular_speed=9.0, elements_across=24, elements_through=4)
    >>> f"{r.load / 1e3:.1f} kN/m, {r.driving_torque:.1f} N m/m, overspeed {r.overspeed:.3f}"
    '16.6 kN/m, 27.7 N m/m, overspeed 0.073'
    """
    if (load is None) == (penetration is None):
        raise InvalidInput("load", "or penetration must be given, and not both", "both" if load is not None else "none")
    given = problem(roller, on, angular_speed, law, elasticity)
    size = _elements(elements_across, elements_through)
    with reporting(progress) as report, si_hints(roller, on, angular_speed=given.angular_speed):
        if penetration is not None:
            rungs = [_checked(given, "penetration", as_float("penetration", penetration))]
            (result,) = _climb(given, rungs, None, size, report)
        else:
            wanted = as_positive("load", load, "N/m") / (given.modulus * given.radius)
            rungs = [_penetration(given, wanted, report)]
            (result,) = _climb(given, rungs, wanted, size, report)
    _warn([result])
    return result


def ladder(
    roller: CoatedCylinder,
    *,
    on: Counterbody | None = None,
    penetrations: Sequence[float],
    angular_speed: float,
    law: Law | str = "newton",
    elasticity: Elasticity | None = None,
    elements_across: int = 40,
    elements_through: int = 6,
    progress: ProgressLike = None,
) -> tuple[FiniteStrainResult, ...]:
    """Solve steady rolling at several penetrations on one mesh, each from the previous ones.

    Parameters
    ----------
    penetrations : sequence of float
        Penetrations r_o - H [m], increasing, within the limits of `penetration` in `solve`. The mesh is designed for
        the largest one; the smallest should be above 5 % of it.
    roller, on, angular_speed, law, elasticity, elements_across, elements_through, progress
        Same as in `solve`.

    Returns
    -------
    tuple of FiniteStrainResult
        One result for each penetration.

    Raises
    ------
    ValueError, TypeError, ConvergenceError, ImportError, KeyboardInterrupt
        Same as in `solve`.

    Warns
    -----
    ResultWarning
        Same as in `solve`, for the largest penetration; every result has the warnings of its own.
    """
    given = problem(roller, on, angular_speed, law, elasticity)
    size = _elements(elements_across, elements_through)
    values = as_floats("penetrations", penetrations)
    if not values:
        raise InvalidInput("penetrations", "must contain at least one penetration", "none")
    rungs = [_checked(given, f"penetrations[{j}]", value) for j, value in enumerate(values)]
    for j, (lower, upper) in enumerate(pairwise(values), start=1):
        if upper <= lower:
            raise InvalidInput(f"penetrations[{j}]", f"must be > penetrations[{j - 1}] = {lower:g} m", f"{upper:g} m")
    with reporting(progress) as report, si_hints(roller, on, angular_speed=given.angular_speed):
        results = _climb(given, rungs, None, size, report)
    _warn(results)
    return results


def _elements(across: int, through: int) -> tuple[int, int]:
    return as_count("elements_across", across, 8, 400), as_count("elements_through", through, 2, 40)


def _checked(given: Problem, name: str, penetration: float) -> float:
    """Return a penetration per outer radius after a check of its range."""
    least, most = given.smallest_strain, LARGEST_STRAIN
    thickness = given.roller.thickness
    if not least * (1.0 - _ROUNDING) <= penetration / thickness <= most:
        rule = (
            f"must be in [{least * thickness:.4g}, {most * thickness:g}] m, {least:.2g} to {most:g} times the "
            "thickness (use viscoroll.solve for smaller strains)"
        )
        raise InvalidInput(name, rule, f"{penetration:g} m")
    return penetration / given.radius


def _warn(results: Sequence[FiniteStrainResult]) -> None:
    last = results[-1]
    warn([*last.warnings, *filter(None, [unit_doubt(last.roller, last.on)])])


def _penetration(given: Problem, load: float, report: Report | None) -> float:
    """Return an estimate of the penetration under a load, both without dimensions."""
    strains = [0.0]
    loads = [0.0]
    mesh = given.mesh(
        1.1 * given.half_angle(0.2 * given.thickness), across=_PILOT_ELEMENTS[0], through=_PILOT_ELEMENTS[1]
    )
    equilibrium = Equilibrium(given.cover(mesh), given.surface)
    path = _Path(equilibrium)
    for strain in _PILOT_STRAINS:
        rolling, _ = path.to(strain * given.thickness)
        strains.append(strain)
        loads.append(float(rolling.forces.sum()))
        if report is not None:
            report("penetration under the load", min(loads[-1] / load, 1.0))
        if loads[-1] >= load:
            break
    else:
        most = loads[-1] * given.modulus * given.radius
        rule = f"must be below {most:.3g} N/m, the load at a penetration of half of the thickness"
        raise InvalidInput("load", rule, f"{load * given.modulus * given.radius:g} N/m")
    # Load grows about as the power 1.3 of the penetration, whatever the thickness.
    power = 1.3
    (low, high), (start, end) = (np.array(loads[-2:]) ** (1.0 / power), strains[-2:])
    strain = float(start + (load ** (1.0 / power) - low) / (high - low) * (end - start))
    if strain < given.smallest_strain:
        thickness = given.roller.thickness
        rule = (
            f"must cause a penetration of at least {given.smallest_strain * thickness:.4g} m, "
            f"{given.smallest_strain:.2g} times the thickness (use viscoroll.solve for smaller strains)"
        )
        got = f"{load * given.modulus * given.radius:g} N/m, which causes about {strain * thickness:.2g} m"
        raise InvalidInput("load", rule, got)
    return strain * given.thickness


class _Path:
    """Equilibria on one mesh at increasing penetrations."""

    def __init__(self, equilibrium: Equilibrium) -> None:
        self.equilibrium = equilibrium
        self._earlier: Rolling | None = None
        self._last: Rolling | None = None
        thickness = equilibrium.cover.mesh.radii[-1] - equilibrium.cover.mesh.radii[0]
        self._first, self._increment = _FIRST_STRAIN * thickness, _INCREMENT * thickness

    def to(self, penetration: float) -> tuple[Rolling, CoverState]:
        """Solve at a penetration, with equilibria between if the increment is too large."""
        reached = 0.0 if self._last is None else self._last.penetration
        step, halvings = penetration - reached, 0
        step = min(step, self._first if self._last is None else self._increment)
        while True:
            following = penetration if reached + 1.01 * step >= penetration else reached + step
            try:
                found = self._solved(following)
            except ConvergenceError:
                halvings += 1
                if halvings > _HALVINGS:
                    raise
                step *= 0.5
                continue
            reached = following
            if reached == penetration:
                return found
            step = min(1.5 * step, self._increment)

    def under(self, load: float) -> tuple[Rolling, CoverState]:
        """Solve at a load near that of the last equilibrium."""
        assert self._last is not None
        return self.equilibrium.solve(self._last, Target(load, is_load=True))

    def _solved(self, penetration: float) -> tuple[Rolling, CoverState]:
        if self._last is None:
            guess = self.equilibrium.start(penetration)
        elif self._earlier is None:
            guess = self._last
        else:
            guess = self._last.toward(self._earlier, penetration)
        rolling, state = self.equilibrium.solve(guess, Target(penetration))
        self._earlier, self._last = self._last, rolling
        return rolling, state


def _climb(
    given: Problem, rungs: Sequence[float], load: float | None, size: tuple[int, int], report: Report | None
) -> _Found:
    """Return results at increasing penetrations, or under a load near the last of them."""
    half_angle = given.half_angle(rungs[-1]) / _FILL
    results: list[FiniteStrainResult] = []
    for number in range(_MESHES):
        mesh = given.mesh(min(half_angle, 0.6 * np.pi), across=size[0], through=size[1])
        cover = given.cover(mesh)
        path = _Path(Equilibrium(cover, given.surface))
        results = []
        for j, rung in enumerate(rungs):
            rolling, state = path.to(rung)
            if load is not None and j == len(rungs) - 1:
                rolling, state = path.under(load)
            results.append(result_of(given, cover, rolling, state, "penetration" if load is None else "load"))
            if report is not None:
                report("penetrations", (j + 1) / len(rungs))
        reach = float(np.abs(mesh.angles[rolling.forces > 0.0]).max())
        if _LOWEST_FILL <= reach / half_angle <= _HIGHEST_FILL or number == _MESHES - 1:
            break
        half_angle = reach / _FILL
    return tuple(results)
