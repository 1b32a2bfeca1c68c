"""Forces of the cover and their tangent on a coarse mesh."""

from __future__ import annotations

import numpy as np
import pytest
from viscoroll.finite_strain import Law, MooneyRivlin
from viscoroll.finite_strain.contact import RigidSurface
from viscoroll.finite_strain.cover import Cover, CoverMaterial
from viscoroll.finite_strain.mesh import ring_mesh


def coarse_cover(law, volume_compliance=0.0):
    """Return a cover with two layers, one of them with two terms."""
    mesh = ring_mesh(core_radius=0.7, thicknesses=[0.1, 0.2], half_angle=0.4, across=8, through=4)
    materials = [
        CoverMaterial(1.0, np.array([0.5, 1.0]), np.array([0.05, 0.8]), volume_compliance),
        CoverMaterial(2.0, np.array([1.0]), np.array([0.2]), 0.0),
    ]
    return Cover(mesh, materials, law, MooneyRivlin(fraction=0.3))


@pytest.mark.parametrize("law", Law)
def test_tangent_agrees_with_differences(law):
    cover = coarse_cover(law, volume_compliance=1e-2)
    random = np.random.default_rng(3)
    nodes, elements = len(cover.mesh.positions), len(cover.mesh.nodes)
    displacement, change = (2e-3 * random.uniform(-1.0, 1.0, (nodes, 2)) for _ in range(2))
    pressures, pressure_change = (random.uniform(-1.0, 1.0, (elements, 3)) for _ in range(2))
    step = 1e-4

    def values(sign):
        state = cover.state(displacement + sign * step * change, pressures + sign * step * pressure_change)
        return np.concatenate([cover.forces(state), cover.volume_errors(state).ravel()])

    expected = (values(1.0) - values(-1.0)) / (2.0 * step)
    state = cover.state(displacement, pressures)
    stiffness, coupling, volume = cover.blocks(state)
    local = change.ravel()[cover.dofs]
    forces = np.einsum("eij,ej->ei", stiffness, local) + np.einsum("eiq,eq->ei", coupling, pressure_change)
    errors = np.einsum("eiq,ei->eq", coupling, local) + np.einsum("epq,eq->ep", volume, pressure_change)
    found = np.concatenate([cover.assemble(forces) + cover.memory_forces(state, change.ravel()), errors.ravel()])
    np.testing.assert_allclose(found, expected, atol=1e-8 * np.abs(expected).max())


def test_rigid_rotation_is_free_of_stress():
    """The mesh represents a rotation to the order of its elements."""
    cover = coarse_cover(Law.NEWTON)
    x = cover.mesh.positions
    angle = 0.3
    turned = x @ np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    state = cover.state(turned - x, np.zeros((len(cover.mesh.nodes), 3)))
    assert np.abs(state.strain.c - [1.0, 1.0, 0.0]).max() < 1e-4


def test_mesh_has_the_area_of_the_ring():
    mesh = coarse_cover(Law.NEWTON).mesh
    assert mesh.weights.sum() == pytest.approx(np.pi * (1.0 - 0.49), rel=1e-12)
    np.testing.assert_allclose(mesh.shapes.sum(axis=1), 1.0)
    np.testing.assert_array_equal(np.bincount(mesh.layers) >= 2, True)
    values = np.random.default_rng(4).uniform(size=(len(mesh.nodes), 6, 2))
    np.testing.assert_array_equal(mesh.by_element(mesh.by_ring(values)), values)


@pytest.mark.parametrize("curvature", [0.0, 1e-9, 0.4, -0.3])
def test_gap_is_the_distance_from_the_surface(curvature):
    """Gaps against distances from the center of the counterbody; normals and their derivatives by differences."""
    surface, penetration, step = RigidSurface(curvature), 0.05, 1e-6
    x = np.array([[0.1, -1.0], [-0.2, -0.9], [0.0, -0.95]])
    gaps, normals, slopes = surface.gap(x, penetration)
    if abs(curvature) < 1e-6:
        np.testing.assert_allclose(gaps, x[:, 1] + 1.0 - penetration, atol=1e-9)
    else:
        radius = 1.0 / curvature
        center = np.array([0.0, -(1.0 - penetration) - radius])
        distances = np.hypot(*(x - center).T)
        np.testing.assert_allclose(gaps, np.sign(curvature) * (distances - abs(radius)), atol=1e-12)
    for k, change in enumerate(step * np.eye(2)):
        (upper, upper_normal, _), (lower, lower_normal, _) = (
            surface.gap(x + sign * change, penetration) for sign in (1.0, -1.0)
        )
        np.testing.assert_allclose((upper - lower) / (2.0 * step), normals[:, k], atol=1e-8)
        np.testing.assert_allclose((upper_normal - lower_normal) / (2.0 * step), slopes[:, :, k], atol=1e-8)
    raised = (surface.gap(x, penetration + step)[0] - surface.gap(x, penetration - step)[0]) / (2.0 * step)
    np.testing.assert_allclose(raised, -normals[:, 1], atol=1e-8)
