"""Input for LIGGGHTS, `fix wall/gran` and `pair_style gran` with a rolling_friction model."""

from __future__ import annotations

from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

#: Poisson's ratio that is written with the modulus; LIGGGHTS requires less than 0.5.
_POISSON = 0.45


def _cdt(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for constant directional torque: T = rmu |F_n| R, immediately and at any speed.

    Source: rolling_model_cdt.h (r_torque = rmu Fn wr/|wr| cri). By its formula cri is R - δ/2, but on a wall it is R: a
    ball in a run of LIGGGHTS 3.8 has the torque of R to 1e-6 (`tests/python/export/test_dem.py`). For two balls the
    radius is reff = R₁R₂/(R₁+R₂).
    """
    return _contact_model(point, stiffness, "cdt", "immediately")


def _epsd(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for an elastic-plastic spring-dashpot: T = rmu |F_n| R once its spring has reached its limit.

    The spring is 2.25 k_n rmu² R², so the limit is reached after a rotation of δ / (2.25 rmu R), over which the torque
    is smaller. There is no damping beyond it. Source: rolling_model_epsd.h (kr = 2.25 kn rmu² reff²,
    r_torque_max = |Fn| reff rmu; reff is the radius on a wall, otherwise R₁R₂/(R₁+R₂)).
    """
    return _limited(point, stiffness, "epsd", turn=point.penetration / (2.25 * point.coefficient * point.radius))


def _epsd2(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for a spring k_t R² without a dashpot: T = rmu |F_n| R after a rotation of rmu P / (k_t R).

    Source: rolling_model_epsd2.h (kr = kt reff², r_torque_max = |Fn| reff rmu; reff is the radius on a wall, otherwise
    R₁R₂/(R₁+R₂)).
    """
    secant = point.load / point.penetration  # secant stiffness; k_t is 2/7 to 1 of it
    return _limited(point, stiffness, "epsd2", turn=point.coefficient * point.load / (secant * point.radius))


def _limited(point: OperatingPoint, stiffness: Stiffness, style: str, *, turn: float) -> ContactModel:
    return _contact_model(point, stiffness, style, f"after a rotation of about {turn:.2g} rad")


def _contact_model(point: OperatingPoint, stiffness: Stiffness, style: str, when: str) -> ContactModel:
    rmu, young = point.coefficient, _young(stiffness)
    # For two dissimilar balls, the user supplies the values for contacts between balls of one type.
    types = 2 if point.balls.are_two and not point.balls.alike else 1
    friction = f"${{rmu_11}} {rmu!r} {rmu!r} ${{rmu_22}}" if types == 2 else f"{rmu!r}"
    properties = [
        f"fix ym all property/global youngsModulus peratomtype {' '.join(types * [repr(young)])}",
        f"fix pr all property/global poissonsRatio peratomtype {' '.join(types * [repr(_POISSON)])}",
        f"fix rf all property/global coefficientRollingFriction peratomtypepair {types} {friction}",
    ]
    if style == "epsd":
        damping = " ".join(types**2 * ["0.3"])
        properties.append(
            f"fix rv all property/global coefficientRollingViscousDamping peratomtypepair {types} {damping}"
        )
    model = f"model hertz tangential history rolling_friction {style}"
    command = (
        [f"pair_style gran {model}", "pair_coeff * *"]
        if point.balls.are_two
        else [f"fix floor all wall/gran {model} primitive type 1 zplane 0.0"]
    )
    return ContactModel(
        lines=(*properties, *command),
        parameters={"coefficientRollingFriction": rmu, "youngsModulus": young},
        law=lambda load, speed: rmu * load * point.radius + 0.0 * speed,
        torque_law=f"T = rmu P R {when}; R is the radius, for two balls R_eff",
        source=f"LIGGGHTS-PUBLIC src/rolling_model_{style}.h",
    )


def _young(stiffness: Stiffness) -> float:
    """Return Young's modulus for ball and wall (identical materials), from 1/E* = 2 (1 - ν²) / E."""
    return 2.0 * (1.0 - _POISSON**2) * stiffness.effective_modulus


STYLES: dict[str, Style] = {"epsd2": _epsd2, "epsd": _epsd, "cdt": _cdt}
