"""Two dissimilar elastic rollers with friction: R. H. Bentall and K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404.

An aluminum roller is pressed on a steel one, as in the example `bentall` of CONTACT (revision d431cdb, user guide,
section 5.3), with 200 elements. The pressure displaces both surfaces towards the middle, the softer one further, so
that the rollers slip without a tangential force, and the free roller creeps.
"""

from __future__ import annotations

import math

import viscoroll as vr

RADIUS = 50e-3  # each roller [m]
LOAD = 16.2019e3  # [N/m]
HALF_WIDTH = 0.1e-3  # Hertz's [m]
ALUMINUM, STEEL = (23e9, 0.31), (82e9, 0.28)  # shear modulus [Pa], Poisson's ratio [-]

#: Coefficient of friction, and forward force on the center of the steel roller / (friction * load).
CASES = {
    "μ = 1e-4, no force": (1e-4, 0.0),
    "μ = 0.05, no force": (0.05, 0.0),
    "μ = 0.05, force ¾ μP, aluminum driven": (0.05, 0.75),
    "μ = 0.05, force ¾ μP, aluminum braked": (0.05, -0.75),
    "all sticks, no force": (math.inf, 0.0),
}


def equivalent_half_plane() -> vr.CoatedPlane:
    """Return the half-plane equivalent to both bodies under a rigid roller: sums of (1-ν)/G, difference of (1-2ν)/G."""
    (g, nu), (g_other, nu_other) = ALUMINUM, STEEL
    normal = (1.0 - nu) / g + (1.0 - nu_other) / g_other
    coupling = (1.0 - 2.0 * nu) / g - (1.0 - 2.0 * nu_other) / g_other
    both = normal / coupling  # (1-ν)/(1-2ν)
    ratio = (both - 1.0) / (2.0 * both - 1.0)
    base = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=(1.0 - ratio) / normal), poisson_ratio=ratio)
    return vr.CoatedPlane(base=base)


def solid_roller(modulus: float, poisson_ratio: float, radius: float) -> vr.CoatedCylinder:
    """Return a roller with a small core, R/50: a solid roller has no finite compliance to a line load."""
    layer = vr.Layer(thickness=0.98 * radius, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=poisson_ratio)
    return vr.CoatedCylinder(core_radius=0.02 * radius, layers=[layer])


def on_half_plane(*, scale: float = 1.0, across: int = 200) -> vr.RollingModel:
    """Set up the equivalent problem: a rigid roller of the relative radius.

    Under equal load, a/R decreases as 1/√scale and so does the creepage, except for the effect of curvature: flat
    theory is the limit of large scales.
    """
    return _model(vr.CoatedCylinder(core_radius=0.5 * RADIUS * scale), equivalent_half_plane(), scale, across)


def on_each_other(*, scale: float = 1.0, across: int = 200) -> vr.RollingModel:
    """Set up the original problem: steel above, aluminum below."""
    bodies = [solid_roller(*material, RADIUS * scale) for material in (STEEL, ALUMINUM)]
    return _model(*bodies, scale, across)


def _model(roller, on, scale: float, across: int) -> vr.RollingModel:
    nodes = across * math.pi * roller.outer_radius / (HALF_WIDTH * math.sqrt(scale))
    return vr.RollingModel(roller, on=on, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=round(nodes)))


def roll(model: vr.RollingModel, case: str, **options) -> vr.Result:
    """Solve one of the cases."""
    friction, share = CASES[case]
    drive = vr.Drive(force=share * friction * LOAD if share else 0.0)
    return model.solve(load=LOAD, friction=friction, drive=drive, **options)


def sticking(result: vr.Result) -> float:
    """Return the share of the contact that sticks."""
    return result.stick.sum() / result.contact.sum()
