"""Input for MercuryDPM, `LinearViscoelasticFrictionSpecies`."""

from __future__ import annotations

from .contact import ContactModel, OperatingPoint, Stiffness, Style

__all__ = ["STYLES"]

#: Comment for two balls.
_FOR_TWO_BALLS = "  // for both balls; if they differ, set it for the mixed species (getMixedObject)"


def _friction(point: OperatingPoint, stiffness: Stiffness) -> ContactModel:
    """Return input for a rolling spring and slider on the *diameter*: T = μ P · 2R after a small rotation.

    The rolling force is limited to μ F_n. Its moment arm is the effective diameter, twice the effective radius, which
    is the radius on a wall and R₁R₂/(R₁+R₂) for two balls. The coefficient is therefore half of that of other codes.
    Without a rolling stiffness the program stops. Source:
    Kernel/Interactions/FrictionForceInteractions/FrictionInteraction.cc (effectiveDiameter = 2 getEffectiveRadius(),
    addTorque(effectiveDiameter n × rollingForce)).
    """
    mu = point.torque / (2.0 * point.load * point.radius)
    return ContactModel(
        lines=(
            f"LinearViscoelasticFrictionSpecies species;{_FOR_TWO_BALLS if point.balls.are_two else ''}",
            f"species.setStiffness({stiffness.hooke!r});",
            f"species.setRollingStiffness(2.0 / 5.0 * {stiffness.hooke!r});",
            f"species.setRollingFrictionCoefficient({mu!r});",
        ),
        parameters={"rollingFrictionCoefficient": mu, "stiffness": stiffness.hooke},
        law=lambda load, speed: 2.0 * mu * load * point.radius + 0.0 * speed,
        torque_law="T = 2 mu P R after a small rotation: the moment arm is the effective diameter, 2 R",
        source="MercuryDPM Kernel/Interactions/FrictionForceInteractions/FrictionInteraction.cc",
    )


STYLES: dict[str, Style] = {"friction": _friction}
