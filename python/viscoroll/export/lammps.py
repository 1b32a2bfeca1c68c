"""Input for LAMMPS, `fix wall/gran granular` and `pair_style granular`."""

from __future__ import annotations

from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

#: Rotation of the ball at which the spring reaches its limit [rad].
_LIMIT_ROTATION = 1e-3


def _sds(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for a spring, dashpot and slider: T = μ P R after a small rotation.

    The rolling "pseudo-force" is that of a spring with the elongation R_eff∫Ω_rel dt, limited to μ F_n. The torque on
    both balls, in opposite senses, is R_eff times this force. R_eff is the radius on a wall, and R₁R₂/(R₁+R₂) for two
    balls. Source: LAMMPS manual, pair_style granular, rolling sds; src/GRANULAR/gran_sub_mod_rolling.cpp,
    granular_model.cpp (Reff, relrot).
    """
    mu = point.coefficient
    spring = mu * point.load / (point.radius * _LIMIT_ROTATION)
    return ContactModel(
        lines=_command(point, stiffness, f"rolling sds {spring!r} 0.0 {mu!r}"),
        parameters={"k_roll": spring, "gamma_roll": 0.0, "mu_roll": mu},
        law=lambda load, speed: mu * load * point.radius + 0.0 * speed,
        torque_law=f"T = mu_roll P R after a rotation of {_LIMIT_ROTATION:g} rad; R is the radius, for two balls R_eff",
        source="LAMMPS manual, pair_style granular, rolling sds; src/GRANULAR/gran_sub_mod_rolling.cpp",
    )


def _viscous(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for a dashpot alone: T = γ R² Ω_rel, as long as this is below P R.

    Without a spring, and with a slider that is not reached, the pseudo-force is -γ R Ω. It does not depend on the load.
    The source is the same as in `_sds`.
    """
    gamma = point.torque / (point.radius**2 * point.relative_speed)
    return ContactModel(
        lines=_command(point, stiffness, f"rolling sds 0.0 {gamma!r} 1.0"),
        parameters={"k_roll": 0.0, "gamma_roll": gamma, "mu_roll": 1.0},
        law=lambda load, speed: gamma * point.radius**2 * speed + 0.0 * load,
        torque_law="T = gamma_roll R^2 Omega, for two balls Omega_rel, at any load, up to T = P R",
        source="LAMMPS manual, pair_style granular, rolling sds; src/GRANULAR/gran_sub_mod_rolling.cpp",
    )


def _command(point: OperatingPoint, stiffness: Stiffness, rolling: str) -> tuple[str, ...]:
    normal = f"hertz {stiffness.hertz!r} ${{gamma_n}}"
    model = f"{normal} tangential linear_history ${{k_t}} ${{gamma_t}} ${{mu_t}} {rolling}"
    if point.balls.are_two:
        types = "1 1" if point.balls.alike else "1 2"
        return ("pair_style granular", f"pair_coeff {types} {model}")
    return (f"fix floor all wall/gran granular {model} zplane 0.0 NULL",)


STYLES: dict[str, Style] = {"sds": _sds, "viscous": _viscous}
