"""Layers and rough surfaces that the tests of sliding share."""

from __future__ import annotations

import numpy as np
import viscoroll as vr

from tests.reference import sliding as reference

SIDE = 1e-3
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=10e6, relaxed_modulus=1e6, relaxation_time=0.01)
SOLID = reference.Solid(10e6, 1e6, 0.01)
#: A second material, so that the layers have no common relaxation function.
SOFT = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=1.5e6, relaxation_time=0.1)
SOFT_SOLID = reference.Solid(2e6, 1.5e6, 0.1)

MAT = vr.CoatedPlane(layers=[vr.Layer(thickness=2e-4, shear_modulus=RUBBER, poisson_ratio=0.5)])
TWO_LAYERS = vr.CoatedPlane(
    layers=[
        vr.Layer(thickness=1e-4, shear_modulus=SOFT, poisson_ratio=0.4),
        vr.Layer(thickness=8e-5, shear_modulus=RUBBER, poisson_ratio=0.3),
    ]
)
ON_HALF_SPACE = vr.CoatedPlane(
    layers=[vr.Layer(thickness=8e-5, shear_modulus=RUBBER, poisson_ratio=0.3)],
    base=vr.HalfSpace(shear_modulus=SOFT, poisson_ratio=0.4),
)


def half_space(poisson_ratio):
    return vr.CoatedPlane(base=vr.HalfSpace(shear_modulus=RUBBER, poisson_ratio=poisson_ratio))


def rough(shape, seed=2):
    """Return a random surface with waves of at least a sixth of its sides, in partial contact."""
    rng = np.random.default_rng(seed)
    x, z = (2.0 * np.pi * np.arange(count) / count for count in shape)
    heights = np.zeros(shape)
    for i in range(7):
        for j in range(-6, 7):
            if shape[1] > 1 or j == 0:
                phase = i * x[:, np.newaxis] + j * z + rng.uniform(0.0, 2.0 * np.pi)
                heights += np.cos(phase) / (1.0 + i * i + j * j)
    return vr.RoughSurface(4e-6 * heights, (SIDE / shape[0], 0.7 * SIDE / shape[1]))


def slid(surface, on=MAT, **options):
    return vr.slide(surface, on=on, threads=2, **{"pressure": 5e4, "speed": 0.02} | options)


def paraboloid(nodes, spacing, radius):
    """Return the heights of a cap of a ball, with a node at its top."""
    x = (np.arange(nodes) - nodes // 2) * spacing
    return -(x[:, np.newaxis] ** 2 + x**2) / (2 * radius)
