"""Random coated balls, also hollow and solid ones, and suitable loads."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import viscoroll as vr
from numpy.typing import NDArray
from viscoroll import enums

from .materials import draw_modulus, modulus_at, scaled_modulus

__all__ = ["Geometry", "draw_ball", "draw_depth", "draw_moduli", "load_of"]


@dataclass(frozen=True, kw_only=True)
class Geometry:
    """Radii, thicknesses from the center outwards [m], and the inner boundary."""

    radius: float
    core_radius: float
    thicknesses: list[float]
    inner_boundary: enums.InnerBoundary

    @property
    def thickness(self) -> float:
        """Total thickness of the layers [m]."""
        return sum(self.thicknesses)

    @classmethod
    def draw(cls, rng: np.random.Generator, *, thinnest: float = 1e-3) -> Geometry:
        """Return a random geometry whose total layer thickness is at least `thinnest` radii."""
        radius = 10.0 ** rng.uniform(-3.0, 0.0)
        boundary = rng.choice([0, 1, 2], p=[0.7, 0.15, 0.15])
        inner_boundary = (enums.InnerBoundary.RIGID, enums.InnerBoundary.HOLLOW, enums.InnerBoundary.SOLID)[boundary]
        solid = inner_boundary is enums.InnerBoundary.SOLID
        thickness = radius if solid else radius * 10.0 ** rng.uniform(math.log10(thinnest), math.log10(0.9))
        count = int(rng.choice([1, 2, 3], p=[0.55, 0.3, 0.15]))
        shares = 0.05 + rng.dirichlet(np.ones(count))
        thicknesses = (thickness * shares / shares.sum()).tolist()
        return cls(
            radius=radius,
            core_radius=0.0 if solid else radius - thickness,
            thicknesses=thicknesses,
            inner_boundary=inner_boundary,
        )


def draw_depth(rng: np.random.Generator, geometry: Geometry) -> float:
    """Return the intended penetration: 0.1 to 40 % of the thickness, for contacts of at most half a radius."""
    depth = geometry.thickness * 10.0 ** rng.uniform(-3.0, math.log10(0.4))
    return min(depth, 0.15 * geometry.radius)


def draw_moduli(rng: np.random.Generator, count: int) -> list[float]:
    """Return moduli [Pa] with a contrast of up to 1e4."""
    contrast = rng.uniform(0.0, 4.0) if rng.random() < 0.7 else 0.0
    exponents = rng.uniform(4.0, 10.0) + contrast * rng.uniform(-0.5, 0.5, count)
    return [float(modulus) for modulus in 10.0**exponents]


def _materials(rng: np.random.Generator, moduli: list[float], time: float, speed: float) -> list[Any]:
    """Return materials with these moduli, either of independent kinds or with one relaxation function."""
    if rng.random() < 0.5:
        return [draw_modulus(rng, modulus, time, speed) for modulus in moduli]
    common = draw_modulus(rng, moduli[0], time, speed)
    return [scaled_modulus(common, stress=modulus / moduli[0], time=1.0) for modulus in moduli]


def _volume(rng: np.random.Generator, modulus: float) -> dict[str, float]:
    match rng.choice(5, p=[0.35, 0.3, 0.2, 0.05, 0.1]):
        case 0:
            return {"poisson_ratio": 0.5}
        case 1:
            return {"poisson_ratio": rng.uniform(0.0, 0.5)}
        case 2:
            return {"poisson_ratio": rng.uniform(-0.99, 0.0)}
        case 3:
            return {"poisson_ratio": 0.5 - 10.0 ** rng.uniform(-8.0, -2.0)}
        case _:
            return {"bulk_modulus": modulus * 10.0 ** rng.uniform(-1.0, 4.0)}


def draw_ball(
    rng: np.random.Generator,
    geometry: Geometry,
    moduli: list[float],
    densities: NDArray[np.float64],
    time: float,
    speed: float,
) -> vr.CoatedSphere:
    """Return a ball of random materials.

    Parameters
    ----------
    rng : Generator
        Random numbers of the case.
    geometry : Geometry
        Geometry of the ball.
    moduli, densities : sequence of float
        Moduli at high frequency [Pa] and densities [kg/m³] of its layers.
    time : float
        Time in which material crosses the contact [s].
    speed : float
        Angular speed [rad/s].
    """
    layers = [
        vr.Layer(thickness=thickness, shear_modulus=material, density=float(density), **_volume(rng, modulus))
        for thickness, modulus, material, density in zip(
            geometry.thicknesses, moduli, _materials(rng, moduli, time, speed), densities, strict=True
        )
    ]
    return vr.CoatedSphere(core_radius=geometry.core_radius, layers=layers, inner_boundary=geometry.inner_boundary)


def load_of(ball: vr.CoatedSphere, geometry: Geometry, depth: float, frequency: float) -> float:
    """Return the load [N] that gives about this penetration with the softest layer alone."""
    radius, thickness = geometry.radius, geometry.thickness
    softest = min(abs(modulus_at(layer.shear_modulus, frequency)) for layer in ball.layers)
    hertz = 8.0 / 3.0 * softest * math.sqrt(radius * depth**3)
    bonded = math.pi * softest * radius * depth**2 / thickness  # incompressible thin layers support more
    if geometry.inner_boundary is enums.InnerBoundary.HOLLOW:
        return min(hertz, 4.0 * softest * thickness**2 * depth / radius)  # a shell bends
    return hertz if geometry.inner_boundary is enums.InnerBoundary.SOLID else hertz + bonded
