"""Laws of the viscous stress, elastic laws and the memory on a ring."""

from __future__ import annotations

import numpy as np
import pytest
from viscoroll.finite_strain import Law, MooneyRivlin, NeoHookean, Yeoh
from viscoroll.finite_strain.history import memory_matrix
from viscoroll.finite_strain.laws import Strain, measure, viscous_map

ELASTICITIES = (NeoHookean(), MooneyRivlin(fraction=0.3), Yeoh(coefficient=0.05))


def strains(count=5, size=0.3):
    """Return random right Cauchy-Green tensors."""
    random = np.random.default_rng(1)
    gradient = np.eye(2) + size * random.uniform(-1.0, 1.0, (count, 2, 2))
    c = gradient.swapaxes(1, 2) @ gradient
    return np.stack([c[:, 0, 0], c[:, 1, 1], c[:, 0, 1]], axis=-1)


def by_differences(function, c, step=1e-6):
    """Return the derivative of a function of C by central differences."""
    changes = step * np.eye(3)
    columns = [(function(Strain(c + change)) - function(Strain(c - change))) / (2.0 * step) for change in changes]
    return np.stack(columns, axis=-1)


@pytest.mark.parametrize("elasticity", ELASTICITIES, ids=str)
@pytest.mark.parametrize("law", Law)
def test_derivatives_agree_with_differences(law, elasticity):
    c = strains()
    _, slope = measure(law, elasticity, Strain(c))
    np.testing.assert_allclose(slope, by_differences(lambda s: measure(law, elasticity, s)[0], c), atol=1e-8)
    _, slope = elasticity.relaxed(Strain(c))
    np.testing.assert_allclose(slope, by_differences(lambda s: elasticity.relaxed(s)[0], c), atol=1e-8)
    memory = strains()[::-1] - 1.0
    _, by_memory, by_strain = viscous_map(law, Strain(c), memory)
    np.testing.assert_allclose(by_strain, by_differences(lambda s: viscous_map(law, s, memory)[0], c), atol=1e-8)
    np.testing.assert_allclose((by_memory @ memory[..., None])[..., 0], viscous_map(law, Strain(c), memory)[0])


@pytest.mark.parametrize("elasticity", ELASTICITIES, ids=str)
@pytest.mark.parametrize("law", Law)
def test_all_laws_are_the_same_linear_material(law, elasticity):
    """T = 2 ε at small strain, up to a multiple of the unit tensor, which the pressure balances."""
    small = 1e-7 * np.array([0.7, -0.7, 0.4])
    value, _ = measure(law, elasticity, Strain(np.array([1.0, 1.0, 0.0]) + 2.0 * small))
    rest, _ = measure(law, elasticity, Strain(np.array([1.0, 1.0, 0.0])))
    change = value - rest
    mean = 0.5 * (change[0] + change[1])
    np.testing.assert_allclose(change - [mean, mean, 0.0], 2.0 * small, rtol=1e-5)


@pytest.mark.parametrize("law", [Law.SIMO, Law.ABAQUS])
@pytest.mark.parametrize("elasticity", ELASTICITIES, ids=str)
def test_measures_are_deviatoric(law, elasticity):
    """In three dimensions, with C₃₃ = 1: T : C = 0 for `simo`, and tr T = 0 for `abaqus`."""
    c = strains()
    value, _ = measure(law, elasticity, Strain(c))
    full = np.zeros((len(c), 3, 3))
    full[:, [0, 1, 0, 1], [0, 1, 1, 0]] = c[:, [0, 1, 2, 2]]
    full[:, 2, 2] = 1.0
    first = np.trace(full, axis1=1, axis2=2)[:, None, None]
    a, unit = elasticity.second_fraction, np.eye(3)
    factor = 1.0 + 2.0 * elasticity.stiffening * (first - 3.0)
    stress = (1.0 - a) * unit + a * (first * unit - full)
    if law is Law.SIMO:
        third = np.einsum("nij,nij->n", stress, full)[:, None, None] / 3.0
        expected = factor * (stress - third * np.linalg.inv(full))
        assert np.einsum("nij,nij->n", expected, full) == pytest.approx(0.0, abs=1e-12)
    else:
        product = stress @ full
        expected = factor * (product - np.trace(product, axis1=1, axis2=2)[:, None, None] * unit / 3.0)
    np.testing.assert_allclose(value, expected[:, [0, 1, 0], [0, 1, 1]], atol=1e-12)


@pytest.mark.parametrize("lag", [1e-3, 0.09, 1.0, 50.0])
def test_memory_of_a_harmonic(lag):
    """A strain measure exp(iφ) has the memory exp(iφ) i l / (1 + i l)."""
    random = np.random.default_rng(2)
    angles = np.sort(np.linspace(-np.pi, np.pi, 2000, endpoint=False) + 5e-4 * random.uniform(size=2000))
    matrix = memory_matrix(angles, np.array([2.0]), np.array([lag]))
    harmonic = np.exp(1j * angles)
    np.testing.assert_allclose(matrix @ harmonic, 2.0 * harmonic * 1j * lag / (1.0 + 1j * lag), atol=4e-6)


def test_memory_of_constant_strain_vanishes():
    angles = np.linspace(-3.0, 3.0, 40)
    matrix = memory_matrix(angles, np.array([1.0, 2.0]), np.array([0.1, 1e3]))
    np.testing.assert_allclose(matrix @ np.ones(40), 0.0, atol=1e-12)
