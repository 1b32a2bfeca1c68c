"""LIGGGHTS, `fix wall/gran` and `pair_style gran` with a rolling_friction model."""

from __future__ import annotations

import numpy as np

from .contact import OperatingPoint, Stiffness, Style, Written

__all__ = ["STYLES"]

#: Poisson's ratio that is written beside the modulus; LIGGGHTS wants less than 0.5.
_POISSON = 0.45

_FOLDER = "LIGGGHTS-PUBLIC src"


def _cdt(point: OperatingPoint, stiffness: Stiffness) -> Written:
    """Constant directional torque: T = rmu k_n δ c, with c = R - δ/2 on a wall, at once and at any speed.

    δ is the overlap that the code finds: with the modulus written here that of its law at the load. Source:
    rolling_model_cdt.h (r_torque = rmu Fn wr/|wr| cri), surface_model_default.h (cri = radi - 0.5 deltan).
    """

    def lever(load: np.ndarray) -> np.ndarray:
        overlap = (load / (stiffness.hertz * np.sqrt(point.radius))) ** (2.0 / 3.0)
        return np.asarray(point.radius - 0.5 * overlap)

    rmu = point.torque / (point.load * float(lever(np.asarray(point.load))))
    return Written(
        lines=_lines("cdt", rmu, stiffness),
        parameters={"coefficientRollingFriction": rmu, "youngsModulus": _young(stiffness)},
        law=lambda load, speed: rmu * load * lever(load) + 0.0 * speed,
        torque_law="T = rmu P (R - delta/2), delta the overlap of its Hertz law at P (two balls: rmu P R_eff)",
        source=f"{_FOLDER}/rolling_model_cdt.h, surface_model_default.h",
    )


def _epsd(point: OperatingPoint, stiffness: Stiffness) -> Written:
    """Elastic-plastic spring-dashpot: T = rmu |F_n| R once its spring, 2.25 k_n rmu² R², has turned far enough.

    That takes a turn of δ / (2.25 rmu R), in which the ball meets less; there is no damping beyond it. Source:
    rolling_model_epsd.h (kr = 2.25 kn rmu² reff², r_torque_max = |Fn| reff rmu; reff is the radius on a wall).
    """
    return _limited(point, stiffness, "epsd", turn=point.penetration / (2.25 * point.coefficient * point.radius))


def _epsd2(point: OperatingPoint, stiffness: Stiffness) -> Written:
    """Spring k_t R² without a dashpot: T = rmu |F_n| R once it has turned by rmu P / (k_t R).

    Source: rolling_model_epsd2.h (kr = kt reff², r_torque_max = |Fn| reff rmu; reff is the radius on a wall).
    """
    secant = point.load / point.penetration  # k_t is 2/7 to 1 of it
    return _limited(point, stiffness, "epsd2", turn=point.coefficient * point.load / (secant * point.radius))


def _limited(point: OperatingPoint, stiffness: Stiffness, style: str, *, turn: float) -> Written:
    rmu = point.coefficient
    lines = _lines(style, rmu, stiffness)
    if style == "epsd":
        lines += ("fix rv all property/global coefficientRollingViscousDamping peratomtypepair 1 0.3",)
    return Written(
        lines=lines,
        parameters={"coefficientRollingFriction": rmu, "youngsModulus": _young(stiffness)},
        law=lambda load, speed: rmu * load * point.radius + 0.0 * speed,
        torque_law=f"T = rmu P R once the ball has turned by about {turn:.2g} rad; R the radius (two balls: R_eff)",
        source=f"{_FOLDER}/rolling_model_{style}.h",
    )


def _young(stiffness: Stiffness) -> float:
    """Young's modulus of ball and wall alike, from 1/E* = 2 (1 - ν²) / E."""
    return 2.0 * (1.0 - _POISSON**2) * stiffness.effective_modulus


def _lines(style: str, rmu: float, stiffness: Stiffness) -> tuple[str, ...]:
    return (
        f"fix ym all property/global youngsModulus peratomtype {_young(stiffness)!r}",
        f"fix pr all property/global poissonsRatio peratomtype {_POISSON!r}",
        f"fix rf all property/global coefficientRollingFriction peratomtypepair 1 {rmu!r}",
        f"fix floor all wall/gran model hertz tangential history rolling_friction {style} primitive type 1 zplane 0.0",
    )


STYLES: dict[str, Style] = {"epsd2": _epsd2, "epsd": _epsd, "cdt": _cdt}
