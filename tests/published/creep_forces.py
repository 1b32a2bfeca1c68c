"""Creep forces of identical elastic bodies: Kalker's coefficients, and a creep curve to saturation by CONTACT.

For identical bodies, pressure alone causes no slip. A rotating body is a thick coating, whose core is far from the
contact.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import viscoroll as vr
from viscoroll import enums

#: C₁₁, C₂₂, C₂₃ of a circle by Poisson's ratio: J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact
#: (1990), table E3.
KALKER = {0.0: (3.40, 3.40, 1.33), 0.25: (4.12, 3.67, 1.47), 0.5: (5.20, 3.98, 1.63)}

WHEEL_RADIUS, CROWN_RADIUS = 0.625, 1.0 / (2.0 * 0.2814e-3) * 1e-3  # [m]
WHEEL_LOAD, WHEEL_FRICTION = 106.7e3, 0.33  # [N]
STEEL = vr.Elastic(modulus=82e9)
STEEL_RATIO = 0.28
SEMI_AXES = (6.304e-3, 12.61e-3)  # Hertz's [m], along the path and across


def coefficients(poisson_ratio: float, *, across: int) -> tuple[float, float, float]:
    """Return C₁₁, C₂₂, C₂₃ of two identical balls in full stick; `across` nodes along the diameter of the contact."""
    modulus, radius, ratio = 1e6, 20e-3, 160  # R/a, so that balls are nearly flat
    layer = vr.Layer(thickness=0.5 * radius, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=poisson_ratio)
    ball = vr.CoatedSphere(core_radius=0.5 * radius, layers=[layer])
    a = 0.5 * radius / ratio  # with the relative radius
    load = 4.0 / 3.0 * modulus * a**3 / ((1.0 - poisson_ratio) * 0.5 * radius)
    mesh = vr.Mesh(nodes_per_revolution=round(math.pi * radius / a * across))
    model = vr.RollingModel(ball, on=ball, angular_speed=1.0, mesh=mesh)
    small = 1e-6

    def stuck(**creepages: float) -> vr.Result:
        return model.solve(load=load, friction=math.inf, drive=vr.Drive(**creepages))

    free, along = stuck(creepage=0.0), stuck(creepage=small)
    sideways, spinning = stuck(creepage=0.0, lateral_creepage=small), stuck(creepage=0.0, spin=small / a)
    mean = math.sqrt(along.contact_area / math.pi)
    scale = modulus * mean**2 * small
    return (
        (along.driving_force - free.driving_force) / scale,
        abs(sideways.lateral_force) / scale,
        abs(spinning.lateral_force) / (scale * mean / a),
    )


def carter(share: float) -> float:
    """Return the force / (friction * load) of a roller on an identical half-plane, F. W. Carter (1926).

    `share` is the creepage, above that of free rolling, relative to the creepage of full sliding; Carter's force is 1 -
    (1 - share)².
    """
    modulus, radius, a, friction, poisson_ratio = 1e7, 0.1, 1e-4, 0.3, 0.3
    hard = vr.Elastic(modulus=modulus)
    layer = vr.Layer(thickness=60e-3, shear_modulus=hard, poisson_ratio=poisson_ratio)
    roller = vr.CoatedCylinder(core_radius=radius - layer.thickness, layers=[layer])
    ground = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=hard, poisson_ratio=poisson_ratio))
    load = math.pi * modulus * a**2 / (4.0 * (1.0 - poisson_ratio) * radius)
    mesh = vr.Mesh(nodes_per_revolution=round(200 * math.pi * radius / a))
    model = vr.RollingModel(roller, on=ground, angular_speed=1.0, mesh=mesh)
    free = model.solve(load=load, friction=friction).creepage
    r = model.solve(load=load, friction=friction, drive=vr.Drive(creepage=free + share * friction * a / radius))
    return r.driving_force / (friction * load)


def contact_curve() -> list[tuple[float, float]]:
    """Return creepage and force / (friction * load) as printed."""
    with (Path(__file__).parent / "data" / "contact_creep_force.csv").open(encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [(float(row["creepage [1]"]), float(row["force [mu P]"])) for row in rows]


class SteelWheel:
    """A crowned steel wheel on steel, a/b = ½: the example `tractcurv` of CONTACT (d431cdb, user guide, section 5.9).

    Along each direction, the meshes have `refinement` times the elements of the source, 44 by 40 in the contact.
    """

    def __init__(self, *, refinement: float = 1.0) -> None:
        a, b = SEMI_AXES
        layer = vr.Layer(thickness=0.3, shear_modulus=STEEL, poisson_ratio=STEEL_RATIO)
        wheel = vr.CoatedWheel(
            core_radius=WHEEL_RADIUS - layer.thickness,
            layers=[layer],
            width=1.0,
            crown_radius=CROWN_RADIUS,
            sides=enums.Sides.UNBOUNDED,
        )
        mesh = vr.Mesh(
            nodes_per_revolution=round(44 * refinement * math.pi * WHEEL_RADIUS / a),
            theta_nodes_per_revolution=round(40 * refinement * math.pi * WHEEL_RADIUS / b),
        )
        rail = vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=STEEL, poisson_ratio=STEEL_RATIO))
        self.model = vr.RollingModel(wheel, on=rail, angular_speed=1.0, mesh=mesh)
        self.free = self._solve(vr.Drive(force=0.0)).creepage

    def _solve(self, drive: vr.Drive) -> vr.Result:
        return self.model.solve(load=WHEEL_LOAD, friction=WHEEL_FRICTION, drive=drive)

    def force(self, creepage: float) -> float:
        """Return the traction / (friction * load) at a creepage above that of free rolling.

        A curved wheel rolls freely at -3.5e-5, because its surface travels less at the ends of the contact (Heathcote);
        the source's bodies are flat.
        """
        r = self._solve(vr.Drive(creepage=self.free + creepage))
        traction = -r.shear_traction[0].sum() * r.contact_area / r.contact.sum()
        return traction / (WHEEL_FRICTION * WHEEL_LOAD)


def kalkers_slope() -> float:
    """Return the force / (friction * load * creepage) of the steel wheel by Kalker's C₁₁, a/b = ½ (1990, table E3).

    A parabola through 1/C₁₁ interpolates between ν = 0, ¼ and ½.
    """
    nu, table = STEEL_RATIO, {0.0: 2.88, 0.25: 3.62, 0.5: 4.83}
    inverse = 0.0
    for at, c11 in table.items():
        others = [other for other in table if other != at]
        inverse += math.prod((nu - other) / (at - other) for other in others) / c11
    a, b = SEMI_AXES
    return 82e9 * a * b / inverse / (WHEEL_FRICTION * WHEEL_LOAD)
