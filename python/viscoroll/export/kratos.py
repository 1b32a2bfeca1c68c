"""Input for the DEMApplication of Kratos Multiphysics: a material relation with rolling friction."""

from __future__ import annotations

import json
import math
from collections.abc import Callable

import numpy as np

from .._support.arguments import Floats
from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

#: Poisson's ratio that is written with the modulus.
_POISSON_RATIO = 0.3

_SOURCE = "Kratos applications/DEMApplication/custom_constitutive/DEM_rolling_friction_model"


def _constant(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for T = ρ P L, immediately and at any speed.

    L is the radius minus the indentation on a wall, and the smaller radius of two balls. Source:
    DEM_rolling_friction_model_constant_torque.cpp (arm_length).
    """
    arm = _arm(point, stiffness)
    mu = point.torque / (point.load * float(arm(np.asarray(point.load))))
    where = "the smaller radius" if point.balls.are_two else "the radius minus the indentation"
    return _contact_model(
        stiffness,
        "DEMRollingFrictionModelConstantTorque",
        mu,
        lambda load, speed: mu * load * arm(load) + 0.0 * speed,
        f"T = ROLLING_FRICTION P L, where L is {where}",
        f"{_SOURCE}_constant_torque.cpp",
    )


def _viscous(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for T = ρ P L² Ω, where ρ is in s/m; not for two balls, on which the torques would differ.

    L is the radius minus the indentation. Source: DEM_rolling_friction_model_viscous_torque.cpp.
    """
    if point.balls.are_two:
        raise ValueError(
            "style of kratos must be constant for two balls, got viscous, whose torques on both balls are not opposite"
        )
    arm = _arm(point, stiffness)
    mu = point.torque / (point.load * float(arm(np.asarray(point.load))) ** 2 * point.angular_speed)
    return _contact_model(
        stiffness,
        "DEMRollingFrictionModelViscousTorque",
        mu,
        lambda load, speed: mu * load * arm(load) ** 2 * speed,
        "T = ROLLING_FRICTION P L^2 Omega in s/m, where L is the radius minus the indentation",
        f"{_SOURCE}_viscous_torque.cpp",
    )


def _arm(point: OperatingPoint, stiffness: Stiffness) -> Callable[[Floats], Floats]:
    """Return the moment arm as a function of the load; the indentation is that of Hertz's law, as in Kratos."""
    radius = min(point.balls.radii)
    if point.balls.are_two:
        return lambda load: radius + 0.0 * load
    unit_load = stiffness.hertz * math.sqrt(radius)
    return lambda load: radius - (load / unit_load) ** (2.0 / 3.0)


def _contact_model(
    stiffness: Stiffness, model: str, mu: float, law: Callable[[Floats, Floats], Floats], torque_law: str, source: str
) -> ContactModel:
    young = 2.0 * (1.0 - _POISSON_RATIO**2) * stiffness.effective_modulus
    material = {"YOUNG_MODULUS": young, "POISSON_RATIO": _POISSON_RATIO}
    relation = {
        "DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME": "DEM_D_Hertz_viscous_Coulomb",
        "DEM_ROLLING_FRICTION_MODEL_NAME": model,
        "ROLLING_FRICTION": mu,
        "ROLLING_FRICTION_WITH_WALLS": mu,
    }
    return ContactModel(
        lines=(
            "// in MaterialsDEM.json: Variables of both materials, and of their entry in material_relations",
            f'"Variables": {json.dumps(material)}',
            *f'"Variables": {json.dumps(relation, indent=2)}'.splitlines(),
        ),
        parameters={"ROLLING_FRICTION": mu, "YOUNG_MODULUS": young},
        law=law,
        torque_law=torque_law,
        source=source,
    )


STYLES: dict[str, Style] = {"constant": _constant, "viscous": _viscous}
