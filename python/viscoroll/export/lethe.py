"""Input for Lethe, with constant, viscous or elastic-plastic rolling resistance."""

from __future__ import annotations

from .balls import Balls
from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

_SOURCE = "Lethe include/dem/particle_particle_contact_force.h and its rolling resistance torque models"


def _constant(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for T = μ_r P R, immediately and at any speed.

    The law is M_r = -μ_r R_eff |F_n| ω̂_rel. R_eff is the radius on a wall, and R₁R₂/(R₁+R₂) for two balls. The value
    of a pair is the harmonic mean 2 μ₁μ₂/(μ₁+μ₂), so both get the same value. Source: Lethe's
    `constant_rolling_resistance_torque`.
    """
    mu = point.coefficient
    return _contact_model(
        point, stiffness, "constant", mu, lambda load, speed: mu * load * point.radius + 0.0 * speed, "T = mu_r P R"
    )


def _viscous(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for T = μ_r P R² Ω; not for two balls.

    The law has the form of the low-speed limit of a coated ball, T = P Ω R Σ g_k τ_k / g_∞. It is M_r = -μ_r R_eff
    |F_n| |V_ω| ω̂ with V_ω = ω₁ × R₁n + ω₂ × R₂n and μ_r in s/m. V_ω is 0 for two balls that roll on each other.
    Source: Lethe's `viscous_rolling_resistance_torque`.
    """
    if point.balls.are_two:
        raise ValueError(
            "style of lethe must be constant or epsd for two balls, got viscous, "
            "whose torque is 0 between two balls that roll on each other"
        )
    mu = point.torque / (point.load * point.radius**2 * point.angular_speed)
    return _contact_model(
        point,
        stiffness,
        "viscous",
        mu,
        lambda load, speed: mu * load * point.radius**2 * speed,
        "T = mu_r P R^2 Omega, mu_r in s/m",
    )


def _epsd(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for an elastic-plastic spring-dashpot: T = μ_r P R once its spring has reached the limit.

    The stiffness of the spring is 2.25 k_n μ_r² R², so the limit is reached after a rotation of about δ/(2.25 μ_r R).
    With an f coefficient of 0 there is no damping beyond it. R is the radius on a wall, and R₁R₂/(R₁+R₂) for two balls.
    Source: Lethe's `epsd_rolling_resistance_torque` and `epsd_rolling_torque`.
    """
    mu = point.coefficient
    turn = point.penetration / (2.25 * mu * point.radius)
    return _contact_model(
        point,
        stiffness,
        "epsd",
        mu,
        lambda load, speed: mu * load * point.radius + 0.0 * speed,
        f"T = mu_r P R after a rotation of about {turn:.2g} rad",
    )


#: Fraction of critical damping of the rolling spring below its limit.
_ROLLING_DAMPING = 0.3


def _contact_model(
    point: OperatingPoint, stiffness: Stiffness, method: str, mu: float, law: object, torque_law: str
) -> ContactModel:
    young = 2.0 * (1.0 - 0.3**2) * stiffness.effective_modulus
    wall = (
        f"  set young modulus wall    = {young!r}",
        "  set poisson ratio wall    = 0.3",
        f"  set rolling friction wall = {mu!r}",
        *((f"  set rolling viscous damping wall = {_ROLLING_DAMPING!r}",) if method == "epsd" else ()),
    )
    return ContactModel(
        lines=(
            "subsection model parameters",
            f"  set rolling resistance torque method = {method}  # {method}_resistance in older versions",
            *(("  set f coefficient = 0.0",) if method == "epsd" else ()),
            "end",
            "subsection lagrangian physical properties",
            *(
                line
                for number, radius in enumerate(_types(point.balls))
                for line in _type(number, radius, young, mu, method)
            ),
            *(() if point.balls.are_two else wall),
            "end",
        ),
        parameters={"rolling friction": mu, "young modulus": young},
        law=law,  # type: ignore[arg-type]
        torque_law=torque_law,
        source=_SOURCE,
    )


def _types(balls: Balls) -> tuple[float, ...]:
    """Return the radii of the particle types."""
    return balls.radii[:1] if balls.alike else balls.radii


def _type(number: int, radius: float, young: float, mu: float, method: str) -> tuple[str, ...]:
    return (
        f"  subsection particle type {number}",
        f"    set diameter                   = {2.0 * radius!r}",
        f"    set young modulus particles    = {young!r}",
        "    set poisson ratio particles    = 0.3",
        f"    set rolling friction particles = {mu!r}",
        *((f"    set rolling viscous damping particles = {_ROLLING_DAMPING!r}",) if method == "epsd" else ()),
        "  end",
    )


STYLES: dict[str, Style] = {"constant": _constant, "viscous": _viscous, "epsd": _epsd}
