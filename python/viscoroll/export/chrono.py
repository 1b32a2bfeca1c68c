"""Input for Project Chrono: non-smooth contacts, smooth contacts of Chrono::Multicore, and Chrono::DEM."""

from __future__ import annotations

import math

from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

#: Poisson's ratio of the materials of Chrono::Multicore.
_POISSON_RATIO = 0.3


def _nsc(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:  # noqa: ARG001  (contacts are rigid)
    """Return input for non-smooth contacts, which limit the rolling torque on each ball to ρ F_n, where ρ is a length.

    Non-smooth contacts are rigid. For two materials the smaller ρ applies, so both materials must be given this value.
    Source: ChContactNSCrolling.cpp (limit of the reaction torque by SetRollingFrictionCoefficient),
    ChContactMaterialNSC.h (rolling friction in units of length); Tasora and Anitescu, Meccanica 48 (2013) 1643. The
    smooth contacts of Chrono's core, SMC, read the value and never use it.
    """
    rho = point.torque / point.load
    return ContactModel(
        lines=(
            "auto material = chrono_types::make_shared<ChContactMaterialNSC>();  "
            f"// {'both balls' if point.balls.are_two else 'ball and floor'}: the smaller value counts",
            f"material->SetRollingFriction({rho!r}f);  // m",
        ),
        parameters={"rolling_friction": rho},
        law=lambda load, speed: rho * load + 0.0 * speed,  # with the shape of both arrays, here and below
        torque_law="T = rolling_friction P, where rolling_friction is a length",
        source="Chrono src/chrono/physics/ChContactNSCrolling.cpp, ChContactMaterialNSC.h",
    )


def _multicore(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for smooth contacts of Chrono::Multicore, T = muRoll P R at any speed; not for two balls.

    The torque acts along r × v_rot, where r leads from the center of a ball to the contact. The sliding speed that the
    rotation causes, v_rot = ω₂ × r₂ - ω₁ × r₁, is 0 for two balls that roll on each other. The torque has no spring: it
    is complete in each step in which it acts. It does not act in a contact younger than the duration of a collision,
    nor below min_roll_vel. For two materials the smaller muRoll applies. Source:
    ChIterativeSolverMulticoreSMC.cpp (m_roll = muRoll_eff F_n r × v_rot / |v_rot|), after Schwartz, Richardson and
    Michel, Granular Matter 14 (2012) 363.
    """
    if point.balls.are_two:
        raise ValueError(
            "style of chrono must be nsc or dem for two balls, got multicore, "
            "whose torque is 0 between two balls that roll on each other"
        )
    mu = point.coefficient
    # Ball and floor have this material, so E* = E / (2 (1 - ν²)). Poisson's ratio is a choice that does not change E*.
    young = 2.0 * (1.0 - _POISSON_RATIO**2) * stiffness.effective_modulus
    return ContactModel(
        lines=(
            "auto material = chrono_types::make_shared<ChContactMaterialSMC>();  // in a ChSystemMulticoreSMC",
            f"material->SetYoungModulus({young!r}f);",
            f"material->SetPoissonRatio({_POISSON_RATIO!r}f);",
            f"material->SetRollingFriction({mu!r}f);",
        ),
        parameters={"rolling_friction": mu},
        law=lambda load, speed: mu * load * point.radius + 0.0 * speed,
        torque_law="T = rolling_friction P R with the radius R",
        source="Chrono::Multicore ChIterativeSolverMulticoreSMC.cpp; Schwartz et al., Granular Matter 14 (2012) 363",
    )


def _dem(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for Chrono::DEM, T = μ_r P R at any speed above a threshold, where all balls have one radius R.

    Source: src/chrono_dem/cuda/ChDemHelpers.cuh, computeRollingAngAcc, mode SCHWARTZ: torque = (rolling_coeff |F_n| /
    |v_rot|) r_contact × v_rot, v_rot = (ω₂ - ω₁) × r_contact; ChDem_SMC.cuh: the force is K_n δ √(δ/2R_eff) on a ball,
    K_n δ √(δ/R) on a wall.
    """
    radius = point.balls.radii[0]
    if len(set(point.balls.radii)) > 1:
        raise ValueError(
            "style of chrono must be nsc for two balls of different radii, got dem, which has one radius for all balls"
        )
    mu = point.torque / (point.load * radius)
    partner = "SPH" if point.balls.are_two else "WALL"
    return ContactModel(
        lines=(
            "dem_sys.SetRollingMode(CHDEM_ROLLING_MODE::SCHWARTZ);",
            f"dem_sys.SetKn_SPH2{partner}({stiffness.hertz * math.sqrt(point.radius * radius)!r}f);",
            f"dem_sys.SetRollingCoeff_SPH2{partner}({mu!r}f);",
        ),
        parameters={"rolling_coeff": mu},
        law=lambda load, speed: mu * load * radius + 0.0 * speed,
        torque_law="T = rolling_coeff P R with the distance R from the center to the point of contact",
        source="Chrono src/chrono_dem/cuda/ChDemHelpers.cuh, computeRollingAngAcc",
    )


STYLES: dict[str, Style] = {"nsc": _nsc, "multicore": _multicore, "dem": _dem}
