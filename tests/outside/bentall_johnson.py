"""Two unlike elastic rollers with friction: R. H. Bentall and K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404.

An aluminum roller on a steel one, as the example `bentall` of CONTACT (revision d431cdb, user guide, section 5.3) has
them on 200 elements: the pressure draws the surfaces of both towards the middle, the softer one's further, so that the
two slip where no force asks for it, and a roller that no force drives creeps.
"""

from __future__ import annotations

import math

import viscoroll as vr

RADIUS = 50e-3  # of each roller [m]
LOAD = 16.2019e3  # [N/m]
HALF_WIDTH = 0.1e-3  # Hertz's [m]
ALUMINUM, STEEL = (23e9, 0.31), (82e9, 0.28)  # shear modulus [Pa], Poisson's ratio [-]

#: Coefficient of friction, and force on the center of the steel roller, forward, per friction times load.
CASES = {
    "μ = 1e-4, no force": (1e-4, 0.0),
    "μ = 0.05, no force": (0.05, 0.0),
    "μ = 0.05, ¾ of sliding, aluminum driven": (0.05, 0.75),
    "μ = 0.05, ¾ of sliding, aluminum braked": (0.05, -0.75),
    "all sticks, no force": (math.inf, 0.0),
}


def equivalent_half_plane() -> vr.CoatedPlane:
    """Return the half-plane that yields under a rigid roller as both do: sums of (1-ν)/G, differences of (1-2ν)/G."""
    (g, nu), (g_other, nu_other) = ALUMINUM, STEEL
    normal = (1.0 - nu) / g + (1.0 - nu_other) / g_other
    coupling = (1.0 - 2.0 * nu) / g - (1.0 - 2.0 * nu_other) / g_other
    both = normal / coupling  # (1-ν)/(1-2ν)
    ratio = (both - 1.0) / (2.0 * both - 1.0)
    base = vr.HalfSpace(shear_modulus=vr.Elastic(modulus=(1.0 - ratio) / normal), poisson_ratio=ratio)
    return vr.CoatedPlane(base=base)


def solid_roller(modulus: float, poisson_ratio: float, radius: float) -> vr.CoatedCylinder:
    """Return a roller whose core is a fiftieth of its radius: a line load has no finite compliance without."""
    layer = vr.Layer(thickness=0.98 * radius, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=poisson_ratio)
    return vr.CoatedCylinder(core_radius=0.02 * radius, layers=[layer])


def on_half_plane(*, scale: float = 1.0, across: int = 200) -> vr.RollingModel:
    """Pose the equivalent problem: a rigid roller of the relative radius.

    Under one load a/R falls as 1/√scale and creepage with it, but for what curvature adds: the flat theory is the
    limit of large ones.
    """
    return _model(vr.CoatedCylinder(core_radius=0.5 * RADIUS * scale), equivalent_half_plane(), scale, across)


def on_each_other(*, scale: float = 1.0, across: int = 200) -> vr.RollingModel:
    """Pose it as it is: steel above, aluminum below."""
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
