"""A rubber roller pressed on a plane at finite strain, by another program, FElupe (felupe on PyPI, A. Dutzler).

The cover is neo-Hookean, nearly incompressible and 20 mm thick on a core of 20 mm, in plane strain without friction.
data/felupe_roller.csv contains FElupe's results, and `press` computes them again if FElupe is installed.
"""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import viscoroll as vr

CORE_RADIUS, OUTER_RADIUS = 20e-3, 40e-3  # [m]
YOUNG, POISSON_RATIO = 1.4e6, 0.4995
SHEAR = YOUNG / (2.0 * (1.0 + POISSON_RATIO))
# Penalty stiffness of the contact [MPa], hundreds of times the stiffness of the elements at a node.
PENALTY = 1e3


def printed() -> list[dict[str, float]]:
    """Return FElupe's results: penetration [m], load [N/m] and largest pressure [Pa] of each."""
    with (Path(__file__).parent / "data" / "felupe_roller.csv").open(encoding="utf-8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return [{name: float(value) for name, value in row.items()} for row in rows]


def linear(load: float) -> vr.Result:
    """Solve the same case by linear theory."""
    rubber = vr.Elastic(modulus=SHEAR)
    layer = vr.Layer(thickness=OUTER_RADIUS - CORE_RADIUS, shear_modulus=rubber, poisson_ratio=POISSON_RATIO)
    roller = vr.CoatedCylinder(core_radius=CORE_RADIUS, layers=[layer])
    return vr.solve(roller, load=load, angular_speed=1.0, accuracy=1e-3)


def _half_ring(rings: int, arc: float):
    """Return nodes [mm] by angle from the lowest point and by radius, finer in the contact, and the angles."""
    angles = [0.0]
    step = arc / (1e3 * OUTER_RADIUS)
    while angles[-1] < np.pi:
        step *= 1.15 if angles[-1] > 0.35 else 1.0
        angles.append(angles[-1] + step)
    angles = np.array(angles) * np.pi / angles[-1]
    inwards = np.linspace(1.0, 0.0, rings) ** 1.6
    radii = 1e3 * (OUTER_RADIUS - (OUTER_RADIUS - CORE_RADIUS) * inwards)
    angle, radius = np.meshgrid(angles, radii, indexing="ij")
    return np.stack([radius * np.sin(angle), -radius * np.cos(angle)], axis=-1), angles


def press(penetrations, *, rings: int = 25, arc: float = 0.15):
    """Yield load [N/m] and largest pressure [Pa] at increasing penetrations [m], by FElupe.

    `rings` is the number of nodes from core to surface, and `arc` [mm] the spacing in the contact; bilinear elements
    whose mean volume is constrained.
    """
    import felupe

    nodes, angles = _half_ring(rings, arc)
    number = np.arange(nodes[..., 0].size).reshape(nodes.shape[:2])
    cells = np.stack([number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]], axis=-1).reshape(-1, 4)
    mesh = felupe.Mesh(nodes.reshape(-1, 2), cells, "quad")
    mesh.add_points([0.0, -1e3 * OUTER_RADIUS])  # the plane
    plane = mesh.npoints - 1
    mesh.points_without_cells = mesh.points_without_cells[:-1]
    displacement = felupe.FieldPlaneStrain(felupe.RegionQuad(mesh), dim=2)
    field = felupe.FieldContainer([displacement])
    bulk = YOUNG / (3.0 * (1.0 - 2.0 * POISSON_RATIO))
    rubber = felupe.SolidBodyNearlyIncompressible(felupe.NeoHooke(mu=1e-6 * SHEAR), field, bulk=1e-6 * bulk)
    surface = number[angles < 0.6, -1]
    contact = felupe.MultiPointContact(field, surface, plane, skip=(True, False), multiplier=PENALTY)
    points = np.arange(mesh.npoints)
    boundaries = {
        "core": felupe.Boundary(displacement, mask=np.isin(points, number[:, 0])),
        "middle": felupe.Boundary(displacement, fx=0.0, skip=(False, True)),
        "plane": felupe.Boundary(displacement, mask=points == plane, skip=(False, True)),
        "pressed": felupe.Boundary(displacement, mask=points == plane, skip=(True, False)),
    }
    ramp = {boundaries["pressed"]: 1e3 * np.asarray(penetrations)}
    for _ in felupe.Step([rubber, contact], boundaries=boundaries, ramp=ramp).generate(x0=field, verbose=0):
        force = np.abs(contact.assemble.vector(field).toarray().reshape(-1, 2)[:, 1])
        x = mesh.points[surface, 0] + displacement.values[surface, 0]
        width = np.gradient(x)
        width[0] *= 0.5  # the other half is on the other side
        yield 2e3 * force[plane], 1e6 * (force[surface] / width)[:3].max()
