"""The roller, its counterbody and its materials without dimensions: lengths per outer radius, stresses per modulus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.arguments import as_member, as_positive, require_type
from .._support.errors import InvalidInput, InvalidType
from .._support.text import shown
from ..bodies import CoatedCylinder, Counterbody
from ..bodies.bodies import require_body
from ..materials.modulus_like import relaxation_of
from .contact import RigidSurface
from .cover import Cover, CoverMaterial
from .laws import Elasticity, Law, NeoHookean
from .mesh import RingMesh, ring_mesh

if TYPE_CHECKING:
    from ..bodies import Layer

__all__ = ["LARGEST_STRAIN", "SMALLEST_STRAIN", "Problem", "problem"]

#: Smallest Poisson's ratio. The elements are for incompressible and nearly incompressible covers.
_SMALLEST_POISSON_RATIO = 0.48

#: Largest and smallest strain, penetration per thickness. With the default mesh, a solve takes 11 s at 0.1 % and 30 s
#: at 0.02 % on one core, for a cover of 10 mm on a core of 40 mm: the mesh grades from the contact to the cover.
LARGEST_STRAIN, SMALLEST_STRAIN = 0.5, 1e-3

#: Smallest ratio d/(h² (1/R + 1/R')) of the penetration d to the thickness h and the curvatures. By `half_angle`, the
#: half-length of the contact is then 3 % of the thickness.
_SMALLEST_RATIO = 0.005


@dataclass(frozen=True, eq=False)
class Problem:
    """Steady rolling of a covered roller on a rigid body.

    Attributes
    ----------
    roller : CoatedCylinder
        Roller.
    on : Counterbody or None
        Rigid counterbody; None for the plane.
    angular_speed : float
        Ω [rad/s].
    law : Law
        Law of the viscous stress.
    elasticity : Elasticity
        Elastic law.
    modulus : float
        Unit of stress: the smallest relaxed modulus of the layers [Pa].
    materials : tuple of CoverMaterial
        Materials of the layers, in this unit.
    surface : RigidSurface
        Surface of the counterbody.
    """

    roller: CoatedCylinder
    on: Counterbody | None
    angular_speed: float
    law: Law
    elasticity: Elasticity
    modulus: float
    materials: tuple[CoverMaterial, ...]
    surface: RigidSurface

    @property
    def radius(self) -> float:
        """Outer radius of the roller, the unit of length [m]."""
        return float(self.roller.outer_radius)

    @property
    def thickness(self) -> float:
        """Thickness of the cover per outer radius [-]."""
        return self.roller.thickness / self.radius

    @property
    def smallest_strain(self) -> float:
        """Smallest strain for which the contact is large enough for the mesh [-]."""
        return max(SMALLEST_STRAIN, _SMALLEST_RATIO * self.thickness * (1.0 + self.surface.curvature))

    def half_angle(self, penetration: float) -> float:
        """Return an estimate of the half-angle of the contact [rad].

        The form interpolates between a thick cover, whose contact is shorter than the chord of the plane with the
        circle, and a thin incompressible one with a² = 6 R d. Finite elements at h/R_c = 0.05, 0.25 and 1 give 0.169,
        0.28 and 0.338 at 20 % strain, the estimate 0.168, 0.279 and 0.371.
        """
        depth = penetration / (1.0 + self.surface.curvature)
        ratio = np.sqrt(depth) / self.thickness
        return float(min(np.sqrt(6.0 * depth * ratio / (ratio + 2.1)), 0.5 * np.pi))

    def mesh(self, half_angle: float, *, across: int, through: int) -> RingMesh:
        """Return a mesh with elements of equal size up to a half-angle [rad]."""
        return ring_mesh(
            core_radius=self.roller.core_radius / self.radius,
            thicknesses=[layer.thickness / self.radius for layer in self.roller.layers],
            half_angle=half_angle,
            across=across,
            through=through,
        )

    def cover(self, mesh: RingMesh) -> Cover:
        """Return the cover on a mesh."""
        return Cover(mesh, self.materials, self.law, self.elasticity)


def problem(
    roller: CoatedCylinder,
    on: Counterbody | None,
    angular_speed: float,
    law: Law | str,
    elasticity: Elasticity | None,
) -> Problem:
    """Check the arguments of `solve` and `ladder`, and return the problem without dimensions."""
    require_body("roller", roller, CoatedCylinder, "rolling at finite strain")
    if not roller.layers:
        raise InvalidInput("roller.layers", "must contain at least one layer", "none")
    speed = as_positive("angular_speed", angular_speed, "rad/s")
    chosen = NeoHookean() if elasticity is None else elasticity
    require_type("elasticity", chosen, Elasticity)
    relaxed = []
    for j, layer in enumerate(roller.layers):
        relaxation = relaxation_of(layer.shear_modulus)
        path = f"roller.layers[{j}].shear_modulus"
        if relaxation is None:
            raise InvalidType(
                path,
                "must be a number, Elastic, StandardLinearSolid, Prony or CreepCompliance",
                shown(layer.shear_modulus),
            )
        if relaxation.viscosity > 0.0:
            raise InvalidInput(path, "must have a finite instantaneous modulus", shown(layer.shear_modulus))
        if relaxation.moduli[-1] <= 0.0:
            raise InvalidInput(path, "must have a relaxed modulus > 0 Pa", f"{relaxation.moduli[-1]:g} Pa")
        relaxed.append(float(relaxation.moduli[-1]))
    unit = min(relaxed)
    given = Problem(
        roller=roller,
        on=on,
        angular_speed=speed,
        law=as_member("law", law, Law),
        elasticity=chosen,
        modulus=unit,
        materials=tuple(_material(layer, j, speed, unit) for j, layer in enumerate(roller.layers)),
        surface=_surface(on, float(roller.outer_radius)),
    )
    if on is not None and given.smallest_strain > LARGEST_STRAIN:
        least = 1.0 / (LARGEST_STRAIN / (_SMALLEST_RATIO * roller.thickness) - 1.0 / given.radius)
        rule = f"must be at least {least:.4g} m for this cover (use viscoroll.solve for smaller contacts)"
        raise InvalidInput("on.outer_radius", rule, f"{given.radius / given.surface.curvature:g} m")
    return given


def _material(layer: Layer, number: int, speed: float, unit: float) -> CoverMaterial:
    """Return the material of a layer with stresses in a unit [Pa]."""
    relaxation = relaxation_of(layer.shear_modulus)
    assert relaxation is not None
    relaxed = float(relaxation.moduli[-1])
    nu = layer.poisson_ratio
    if nu is None:
        bulk = float(layer.bulk_modulus or 0.0)
        nu = (3.0 * bulk - 2.0 * relaxed) / (6.0 * bulk + 2.0 * relaxed)
    if nu < _SMALLEST_POISSON_RATIO:
        rule = f"must have a Poisson's ratio in [{_SMALLEST_POISSON_RATIO:g}, 0.5] at rest"
        raise InvalidInput(f"roller.layers[{number}]", rule, f"{nu:.4g}")
    return CoverMaterial(
        relaxed=relaxed / unit,
        moduli=relaxation.moduli[:-1] / unit,
        lags=speed * relaxation.times[:-1],
        volume_compliance=(1.0 - 2.0 * nu) / (2.0 * nu) * unit / relaxed,
    )


def _surface(on: Counterbody | None, radius: float) -> RigidSurface:
    """Return the surface of a counterbody, with lengths per outer radius of the roller."""
    if on is None:
        return RigidSurface()
    require_type("on", on, Counterbody)
    if on.is_deformable:
        raise InvalidInput(
            "on",
            "must be rigid: the finite-strain solver has one deformable body",
            f"a {on.noun} with layers or a base",
        )
    along, across = on.curvatures
    if across != 0.0 or on.width is not None:
        raise InvalidInput("on", "must be a plane, a roller, or a groove curved only along the path", f"a {on.noun}")
    if along * radius <= -1.0:
        raise InvalidInput("on.path_radius", f"must exceed the radius of the roller, {radius:g} m", f"{-1.0 / along:g}")
    return RigidSurface(along * radius)
