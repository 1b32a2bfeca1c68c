"""Normal damping of a contact in particle codes, from the coefficient of restitution of an impact."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias

from .contact import ContactModel, Stiffness
from .impact import Impact

__all__ = ["with_restitution"]

_Damping: TypeAlias = Callable[[ContactModel, Impact, Stiffness], ContactModel]


def with_restitution(code: str, model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:
    """Return the model of a code with the normal damping that gives the restitution of an impact."""
    return _DAMPING[code](model, impact, stiffness)


def _add(model: ContactModel, name: str, value: float, *lines: str) -> ContactModel:
    return replace(model, lines=(*model.lines, *lines), parameters={**model.parameters, name: value})


def _lammps(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001  (e suffices)
    """Write e in place of the damping coefficient, with the keyword "damping tsuji", for which it is e.

    Source: LAMMPS manual, pair_style granular, damping tsuji.
    """
    e = impact.restitution
    lines = tuple(
        line.replace("${gamma_n}", repr(e)).replace(" tangential ", " damping tsuji tangential ")
        for line in model.lines
    )
    return replace(model, lines=lines, parameters={**model.parameters, "restitution": e})


def _liggghts(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001
    """Write coefficientRestitution, which the model hertz requires. Source: LIGGGHTS manual, gran model hertz."""
    e = impact.restitution
    types = 2 if any("${rmu_11}" in line for line in model.lines) else 1
    values = f"${{e_11}} {e!r} {e!r} ${{e_22}}" if types == 2 else f"{e!r}"
    line = f"fix cr all property/global coefficientRestitution peratomtypepair {types} {values}"
    return replace(model, lines=(line, *model.lines), parameters={**model.parameters, "coefficientRestitution": e})


def _yade(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001
    """State that the law has no viscous damping. Source: YADE, Law2_ScGeom6D_CohFrictPhys_CohesionMoment."""
    return _add(
        model, "restitution", impact.restitution, "# this law has no viscous damping: an impact has the restitution 1"
    )


def _mercurydpm(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:
    """Write the dissipation c of k δ + c dδ/dt, 2 ζ √(k m). Source: MercuryDPM LinearViscoelasticNormalSpecies.cc."""
    dissipation = 2.0 * impact.damping_ratio * math.sqrt(stiffness.hooke * impact.mass)
    return _add(model, "dissipation", dissipation, f"species.setDissipation({dissipation!r});")


def _chrono(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001
    """Write SetRestitution; Chrono::DEM has a damping constant whose restitution depends on the speed.

    Source: ChContactMaterial.h, SetRestitution; ChDem_SMC.cuh.
    """
    e = impact.restitution
    if any(line.startswith("dem_sys.") for line in model.lines):
        return _add(
            model, "restitution", e, "// SetGn_SPH2...: no restitution; its damping force is Gn m v sqrt(delta)"
        )
    return _add(model, "restitution", e, f"material->SetRestitution({e!r}f);")


def _lethe(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001
    """Write the restitution coefficient beside each rolling friction. Source: Lethe manual, Lagrangian properties."""
    e = impact.restitution
    lines: list[str] = []
    for line in model.lines:
        lines.append(line)
        name, _, _ = line.partition("=")
        if "set rolling friction" in name:
            lines.append(f"{name.rstrip().replace('rolling friction', 'restitution coefficient')} = {e!r}")
    return replace(model, lines=tuple(lines), parameters={**model.parameters, "restitution coefficient": e})


def _mujoco(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:
    """Write solref as stiffness and damping per mass; a contact cannot pull, so e follows from `_unilateral`.

    Source: MuJoCo documentation, Computation, reference (direct format of solref); T. Schwager and T. Pöschel, Granular
    Matter 9 (2007) 465, restitution of a linear dashpot whose force does not pull.
    """
    rate = math.sqrt(stiffness.hooke / impact.mass)
    damping = 2.0 * _unilateral_ratio(impact.restitution) * rate
    solref = f'solref="{-(rate**2)!r} {-damping!r}"'
    lines = tuple(line.replace("<pair ", f"<pair {solref} ") for line in model.lines)
    return replace(model, lines=lines, parameters={**model.parameters, "stiffness": rate**2, "damping": damping})


def _kratos(model: ContactModel, impact: Impact, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001
    """Write COEFFICIENT_OF_RESTITUTION, from which Kratos computes its damping.

    Source: Kratos DEMApplication, GammaForHertzThornton (C. Thornton, S. J. Cummins and P. W. Cleary, Powder Technology
    233 (2013) 30).
    """
    e = impact.restitution
    lines = tuple(
        line.replace('  "ROLLING_FRICTION":', f'  "COEFFICIENT_OF_RESTITUTION": {e!r},\n  "ROLLING_FRICTION":')
        for line in model.lines
    )
    return replace(model, lines=lines, parameters={**model.parameters, "COEFFICIENT_OF_RESTITUTION": e})


def _unilateral_ratio(restitution: float) -> float:
    """Return the damping ratio of a linear spring and dashpot that does not pull, by bisection."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _unilateral(middle) > restitution else (low, middle)
    return 0.5 * (low + high)


def _unilateral(ratio: float) -> float:
    """Return the restitution of a linear spring and dashpot, with a damping ratio in (0, 1), that does not pull."""
    root = math.sqrt(1.0 - ratio**2)
    return math.exp(-ratio / root * (math.pi - math.atan2(2.0 * ratio * root, 1.0 - 2.0 * ratio**2)))


_DAMPING: dict[str, _Damping] = {
    "lammps": _lammps,
    "liggghts": _liggghts,
    "yade": _yade,
    "mercurydpm": _mercurydpm,
    "chrono": _chrono,
    "lethe": _lethe,
    "mujoco": _mujoco,
    "kratos": _kratos,
}
