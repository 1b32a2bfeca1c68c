"""Moduli that decrease with strain: laws of the network, measured sweeps, and input checks."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, coated_ball

KRAUS = vr.materials.KrausNetwork(storage=8e6, loss=0.8e6, critical_strain=0.01, exponent=0.6)
MASING = vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
STRAINS = np.array([0.001, 0.003, 0.01, 0.03, 0.1])


def test_kraus_at_its_critical_strain_and_a_decade_from_it():
    # A hand calculation gives u = 10^(±0.6), and 1/(1 + u²) = 0.05935096 for 10^0.6.
    storage, loss = KRAUS.at([0.001, 0.01, 0.1])
    np.testing.assert_allclose(storage + 2e6, [9525192.5, 6e6, 2474807.5], atol=0.05)
    np.testing.assert_allclose(loss + 0.2e6, [578048.58, 1e6, 578048.58], atol=0.005)


@pytest.mark.parametrize("x", [1e-3, 0.0299, 0.0301, 0.3, 1.0, 3.0, 100.0])
def test_masing_is_the_first_harmonic_of_its_loop(x):
    """Integrate the branches of the loop by Masing's rule with Gauss points, to round-off."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    phase, weights = 0.5 * np.pi * (1.0 + nodes), 0.5 * np.pi * weights
    strain = x * np.cos(phase)  # unloading from x to -x, half a period
    first = x / (1.0 + x)
    stress = first - 2.0 * (0.5 * (x - strain)) / (1.0 + 0.5 * (x - strain))
    storage = 2.0 / np.pi * (weights * stress * np.cos(phase)).sum() / x
    # The strain leads the stress of the loss by δ, so the loss is the component of the stress along sin φ.
    loss = 2.0 / np.pi * (weights * stress * np.sin(phase)).sum() / x
    np.testing.assert_allclose(
        vr.materials.MasingNetwork(storage=1.0, critical_strain=1.0).at(x), (storage, abs(loss)), rtol=1e-9, atol=1e-14
    )


def test_strain_of_largest_loss_in_masings_network():
    network = vr.materials.MasingNetwork(storage=1.0, critical_strain=1.0)
    x = np.linspace(1.5, 1.65, 15001)
    loss = network.at(x)[1]
    assert loss.max() == pytest.approx(0.151392, abs=5e-7)
    assert x[loss.argmax()] == pytest.approx(1.56692, abs=2e-4)  # the maximum is flat


@pytest.mark.parametrize(("kind", "factor"), [("shear", 1.0), ("double_shear", 2.0), ("tension", 1.0 / np.sqrt(3.0))])
def test_a_sweep_reproduces_its_network(kind, factor):
    """Double amplitudes are twice as large, and an incompressible bar shears by √3 of its elongation."""
    matrix = RUBBER.complex_modulus(10.0)
    storage, loss = KRAUS.at(STRAINS)
    sweep = vr.materials.StrainSweep(
        strain=factor * STRAINS,
        storage=storage + matrix.real,
        loss=loss + matrix.imag,
        kind=kind,
        matrix=RUBBER,
        frequency=10.0,
    )
    np.testing.assert_allclose(sweep.at(STRAINS), (storage, loss), rtol=1e-12)
    assert sweep.known_strains == pytest.approx((0.001, 0.1))
    # The yield strain is that at half of the first storage modulus, whose 1/(1 + u²) has u² = 10^-1.2. The sweep is
    # interpolated linearly in ln g.
    half = 0.01 * (1.0 + 2.0 * 10.0**-1.2) ** (1.0 / 1.2)
    assert sweep.yield_strain == pytest.approx(half, rel=0.03)


def test_without_a_matrix_the_last_storage_and_the_smallest_loss_define_it():
    storage, loss = KRAUS.at(STRAINS)
    sweep = vr.materials.StrainSweep(strain=STRAINS, storage=storage + 2e6, loss=loss + 2e5)
    np.testing.assert_allclose(sweep.at(STRAINS), (storage - storage[-1], loss - loss.min()), rtol=1e-9, atol=1e-6)
    np.testing.assert_array_equal(sweep.at(10.0), sweep.at(0.1))  # extrapolation holds the last value


def test_a_softening_modulus_is_the_sum_of_matrix_and_network():
    tread = vr.materials.SofteningModulus(matrix=RUBBER, network=MASING)
    at = tread.at(0.01, reference_frequency=50.0, loss_scale=0.7)
    storage, loss = MASING.at(0.01)
    # At ω₀, the causal law has exactly this storage, and its loss is within LossFactor's ripple of 0.5 %.
    expected = RUBBER.complex_modulus(50.0) + storage + 0.7j * loss
    assert at.complex_modulus(50.0) == pytest.approx(expected, rel=2e-3)
    assert at.complex_modulus(0.0).imag == 0.0


def test_a_network_without_loss_is_elastic():
    network = vr.materials.KrausNetwork(storage=1e6, loss=0.0, critical_strain=0.01)
    at = vr.materials.SofteningModulus(matrix=RUBBER, network=network).at(0.01, reference_frequency=1.0)
    omega = np.array([0.0, 0.1, 100.0])
    np.testing.assert_allclose(at.complex_modulus(omega), RUBBER.complex_modulus(omega) + 0.5e6, rtol=1e-14)


def test_a_softening_modulus_without_a_strain_is_rejected():
    ball = coated_ball(vr.materials.SofteningModulus(matrix=RUBBER, network=MASING))
    refused = r"viscoroll\.materials\.SofteningModulus: pass the body to viscoroll\.strain_softening"
    for call in (
        lambda: vr.solve(ball, load=10.0, angular_speed=2.5),
        lambda: vr.RollingModel(ball, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=200)),
        lambda: vr.modal.critical_speed(ball),
        lambda: vr.solve(
            vr.CoatedSphere(core_radius=0.02), on=vr.CoatedPlane(layers=ball.layers), load=1.0, angular_speed=1.0
        ),
        lambda: ball.layers[0].shear_modulus.complex_modulus(1.0),
    ):
        with pytest.raises(TypeError, match=refused):
            call()


def test_layers_with_a_softening_modulus_are_checked():
    tread = vr.materials.SofteningModulus(matrix=RUBBER, network=MASING)
    with pytest.raises(ValueError, match=r"poisson_ratio must be in \(-1, 0\.5\], got 0\.6"):
        vr.Layer(thickness=1e-3, shear_modulus=tread, poisson_ratio=0.6)
    with pytest.raises(ValueError, match="core_radius"):
        coated_ball(tread, core_radius=-1.0)


def sweep(strain=(0.1, 0.2, 0.4), storage=(1e6, 1e6, 1e6), loss=(1e5, 1e5, 1e5), **others):
    return vr.materials.StrainSweep(strain=strain, storage=storage, loss=loss, **others)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: vr.materials.KrausNetwork(storage=0.0, loss=1.0, critical_strain=0.01),
            "storage must be > 0 Pa, got 0",
        ),
        (lambda: vr.materials.KrausNetwork(storage=1.0, loss=-1.0, critical_strain=0.01), "loss must be >= 0 Pa"),
        (
            lambda: vr.materials.KrausNetwork(storage=1.0, loss=1.0, critical_strain=0.01, exponent=2.0),
            r"exponent must be in \(0, 1\]",
        ),
        (lambda: vr.materials.MasingNetwork(storage=1.0, critical_strain=0.0), "critical_strain must be > 0, got 0"),
        (lambda: MASING.at(-0.1), "amplitude must be >= 0, got -0.1"),
        (lambda: sweep(strain=[0.1, 1.0]), "equal lengths of at least 3"),
        (lambda: sweep(strain=[1, 10, 100]), "strain must be a ratio, 0.01 for 1 %"),
        (lambda: sweep(strain=[0.3, 0.2, 0.4]), "strictly increasing"),
        (lambda: sweep(loss=[0.0, 1.0, 1.0]), "loss must be > 0 Pa, got 0"),
        (lambda: sweep(kind="bending"), "kind must be one of shear, double_shear, tension, got 'bending'"),
        (
            lambda: sweep(matrix=2e6, frequency=1.0),
            "storage must be at least that of the matrix at 1 rad/s, 2e[+]06 Pa, got 1e[+]06 Pa",
        ),
        (lambda: sweep(matrix=2e6), "frequency must be given if and only if matrix"),
    ],
)
def test_bad_arguments(make, message):
    with pytest.raises(ValueError, match=message):
        make()
