"""Elastic covered roller by FElupe, for `tests/python/finite_strain`: `python -m tests.reference.felupe_roller`.

It needs FElupe (`pip install felupe`), which no test imports. Half of the ring with radii of 20 and 40 mm, a shear
modulus of 1 and a Poisson's ratio of 0.4995 is pressed on a rigid plane: bilinear elements with a condensed pressure,
and contact by a penalty. The command prints the load per length for penetrations per thickness; FElupe 11.3 gives

    elements along angle x radius    0.3 %     2 %       6 %       12 %
    100 x 20                         0.11031   1.11117   4.85971   13.58474
    200 x 40                         0.11028   1.11052   4.85786
"""

from __future__ import annotations

import argparse

import felupe
import numpy as np

CORE, OUTER, POISSON = 20.0, 40.0, 0.4995
STRAINS = (0.003, 0.02, 0.06, 0.12)


def half_ring(along, through):
    """Return the mesh of half of the ring, with the control point of the plane as its last point."""
    mesh = felupe.Rectangle(n=(through + 1, along + 1))
    radius = CORE + (OUTER - CORE) * mesh.points[:, 0]
    # Three quarters of the elements are within 0.75 rad of the contact.
    angle = np.interp(mesh.points[:, 1], [0.0, 0.75, 1.0], [0.0, 0.75, np.pi])
    points = np.stack([radius * np.sin(angle), -radius * np.cos(angle)], axis=1)
    points[np.abs(points[:, 0]) < 1e-9, 0] = 0.0
    mesh.update(points=np.vstack([points, [0.0, -OUTER]]))
    mesh.points_without_cells = mesh.points_without_cells[:-1]
    return mesh


def loads(along, through):
    """Yield strains and loads per length and modulus."""
    mesh = half_ring(along, through)
    field = felupe.FieldContainer([felupe.FieldPlaneStrain(felupe.RegionQuad(mesh), dim=2)])
    last = np.arange(len(mesh.points)) == len(mesh.points) - 1
    radius = np.hypot(*mesh.points.T)
    core = np.abs(radius - CORE) < 1e-6
    middle = (mesh.points[:, 0] == 0.0) & ~core & ~last
    boundaries = {
        "core": felupe.Boundary(field[0], mask=core),
        "middle": felupe.Boundary(field[0], mask=middle, skip=(False, True)),
        "sideways": felupe.Boundary(field[0], mask=last, skip=(False, True)),
        "height": felupe.Boundary(field[0], mask=last, skip=(True, False)),
    }
    fixed, free = felupe.dof.partition(field, boundaries)
    bulk = 2.0 * (1.0 + POISSON) / (3.0 * (1.0 - 2.0 * POISSON))
    solid = felupe.SolidBodyNearlyIncompressible(felupe.NeoHooke(mu=1.0), field, bulk=bulk)
    surface = np.flatnonzero((np.abs(radius - OUTER) < 1e-6) & ~last & (mesh.points[:, 1] < -CORE))
    plane = felupe.MultiPointContact(
        field, points=surface, centerpoint=len(mesh.points) - 1, skip=(True, False), multiplier=1e3
    )
    for strain in np.unique([*np.linspace(0.0, max(STRAINS), 41)[1:], *STRAINS]):
        for boundary in boundaries.values():
            boundary.update(0.0)
        boundaries["height"].update(strain * (OUTER - CORE))
        prescribed = felupe.dof.apply(field, boundaries, fixed)
        felupe.newtonraphson(items=[solid, plane], dof0=fixed, dof1=free, ext0=prescribed, verbose=0, tol=1e-7)
        if np.isclose(strain, STRAINS).any():
            yield strain, 2.0 * abs(plane.results.force.toarray().reshape(-1, 2)[-1, 1])


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--along", type=int, default=100, help="elements along half of the ring")
    parser.add_argument("--through", type=int, default=20, help="elements through the cover")
    given = parser.parse_args()
    for strain, load in loads(given.along, given.through):
        print(f"{strain:.3f} {load:.5f}", flush=True)


if __name__ == "__main__":
    main()
