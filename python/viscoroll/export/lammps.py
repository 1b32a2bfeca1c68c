"""LAMMPS, `fix wall/gran granular` and `pair_style granular`."""

from __future__ import annotations

from .contact import OperatingPoint, Stiffness, Style, Written

__all__ = ["STYLES"]

#: Turn of the ball in which the spring reaches its limit [rad].
_TURN = 1e-3


def _sds(point: OperatingPoint, stiffness: Stiffness) -> Written:
    """Spring, dashpot and slider: past a small turn T = μ P R.

    The rolling "pseudo-force" is a spring on R∫Ω dt, limited to μ F_n, and the torque R_eff times it; on a wall R_eff
    is the radius. Source: LAMMPS manual, pair_style granular, rolling sds; src/GRANULAR/gran_sub_mod_rolling.cpp.
    """
    mu = point.coefficient
    spring = mu * point.load / (point.radius * _TURN)
    return Written(
        lines=(_wall(stiffness, f"rolling sds {spring!r} 0.0 {mu!r}"),),
        parameters={"k_roll": spring, "gamma_roll": 0.0, "mu_roll": mu},
        law=lambda load, speed: mu * load * point.radius + 0.0 * speed,
        torque_law=f"T = mu_roll P R once the ball has turned by {_TURN:g} rad; R the radius (two balls: R_eff)",
        source="LAMMPS manual, pair_style granular, rolling sds; src/GRANULAR/gran_sub_mod_rolling.cpp",
    )


def _viscous(point: OperatingPoint, stiffness: Stiffness) -> Written:
    """Dashpot alone: T = γ R² Ω, as long as that is below P R.

    Without a spring, and with a slider that is not reached, the pseudo-force is -γ R Ω. It does not know the load.
    Source: as of `_sds`.
    """
    gamma = point.torque / (point.radius**2 * point.angular_speed)
    return Written(
        lines=(_wall(stiffness, f"rolling sds 0.0 {gamma!r} 1.0"),),
        parameters={"k_roll": 0.0, "gamma_roll": gamma, "mu_roll": 1.0},
        law=lambda load, speed: gamma * point.radius**2 * speed + 0.0 * load,
        torque_law="T = gamma_roll R^2 Omega, at any load, up to T = P R",
        source="LAMMPS manual, pair_style granular, rolling sds; src/GRANULAR/gran_sub_mod_rolling.cpp",
    )


def _wall(stiffness: Stiffness, rolling: str) -> str:
    normal = f"hertz {stiffness.hertz!r} ${{gamma_n}}"
    tangential = "tangential linear_history ${k_t} ${gamma_t} ${mu_t}"
    return f"fix floor all wall/gran granular {normal} {tangential} {rolling} zplane 0.0 NULL"


STYLES: dict[str, Style] = {"sds": _sds, "viscous": _viscous}
