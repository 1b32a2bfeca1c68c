"""Input for YADE, `CohFrictMat` with the moment law."""

from __future__ import annotations

from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]


def _moment(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for a moment law with a plastic limit: T = etaRoll P R once its spring has reached the limit.

    The limit is min(etaRoll₁ R₁, etaRoll₂ R₂) F_n, so both materials get the same etaRoll, and for two balls R is the
    smaller radius. A Box is treated as a ball of the same radius. (A Wall has no moments: there is no
    Ig2_Wall_Sphere_ScGeom6D.) The law acts if momentRotationLaw is set for both materials. Without cohesion, it also
    requires always_use_moment_law. useIncrementalForm is required because the total form discards the plastic rotation.
    The stiffness of the spring is k_r = alphaKr k_n R₁ R₂.

    Source: pkg/dem/CohesiveFrictionalContactLaw.cpp (RollMax = maxRollPl |F_n|),
    Ip2_CohFrictMat_CohFrictMat_CohFrictPhys (maxRollPl = min(etaRoll₁ R₁, etaRoll₂ R₂); k_n = 2 E₁R₁E₂R₂/(E₁R₁+E₂R₂)).
    """
    first_radius, other_radius = (*point.balls.radii, point.radius)[:2]
    smaller_radius = min(first_radius, other_radius)
    eta = point.torque / (point.load * smaller_radius)
    young = stiffness.hooke * (first_radius + other_radius) / (2.0 * first_radius * other_radius)
    rotation = eta * smaller_radius * point.penetration / (first_radius * other_radius)  # etaRoll P R / k_r
    geometry = (
        "Ig2_Sphere_Sphere_ScGeom6D()" if point.balls.are_two else "Ig2_Box_Sphere_ScGeom6D()  # the floor is a Box"
    )
    other_label = "other" if point.balls.are_two else "floor"
    material = (
        f"CohFrictMat(young={young!r}, poisson=0.3, frictionAngle=friction_angle, density=density, isCohesive=False, "
        f"momentRotationLaw=True, alphaKr=1.0, alphaKtw=0.0, etaRoll={eta!r}, etaTwist=0.0, label="
    )
    return ContactModel(
        lines=(
            f"O.materials.append({material}'ball'))",
            f"O.materials.append({material}'{other_label}'))  # same value: YADE uses the smaller etaRoll R",
            f"geometry = {geometry}",
            "law = Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True, useIncrementalForm=True)",
        ),
        parameters={"etaRoll": eta, "young": young},
        law=lambda load, speed: eta * load * smaller_radius + 0.0 * speed,  # broadcast to the shape of speed
        torque_law=f"T = etaRoll P R after a rotation of about {rotation:.2g} rad; R is the smaller radius",
        source="YADE pkg/dem/CohesiveFrictionalContactLaw.cpp, Ip2_CohFrictMat_CohFrictMat_CohFrictPhys",
    )


STYLES: dict[str, Style] = {"moment": _moment}
