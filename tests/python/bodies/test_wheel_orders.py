"""Orders of a wheel's tread: Bessel functions with 40 digits, limit of a roller, layers, parities, invalid input."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference import wheel_orders as reference
from shared_cases import RUBBER

SPEED = 2.5


def wheel(hub, layers):
    layers = [
        vr.Layer(thickness=thickness, shear_modulus=modulus, poisson_ratio=nu) for thickness, modulus, nu in layers
    ]
    return vr.CoatedWheel(core_radius=hub, layers=layers, width=30e-3, sides="unbounded")


def error(found, expected):
    """Return the largest error of an entry, relative to the geometric mean of its diagonal entries."""
    expected = np.reshape(expected, (3, 3))
    size = np.sqrt(np.abs(np.diag(expected)))
    return np.max(np.abs(found - expected) / np.outer(size, size))


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("hub", [40e-3, 15e-3])
@pytest.mark.parametrize(("m", "k_radius"), [(0, 0.3), (1, 0.3), (2, 1.0), (3, 7.0), (5, 80.0), (20, 0.5), (60, 3.0)])
def test_one_layer_agrees_with_bessel_functions(m, k_radius, hub, nu):
    k = k_radius / 50e-3
    thickness = 50e-3 - hub
    found = vr.modal.surface_compliance(wheel(hub, [(thickness, RUBBER, nu)]), SPEED, m, k)
    modulus = RUBBER.complex_modulus(m * SPEED)
    # The tolerance is about a hundred times the round-off.
    assert error(found, reference.surface_compliance(hub, [(thickness, complex(modulus), nu)], m, k)) < 1e-12


@pytest.mark.parametrize(("m", "k"), [(0, 100.0), (4, 60.0), (-7, 90.0), (30, -200.0)])
def test_several_layers_agree_with_bessel_functions(m, k):
    soft = vr.StandardLinearSolid(instantaneous_modulus=4e6, relaxed_modulus=1e6, relaxation_time=0.02)
    layers = [(6e-3, RUBBER, 0.5), (4e-3, soft, 0.45)]
    found = vr.modal.surface_compliance(wheel(40e-3, layers), SPEED, m, k)
    moduli = [complex(modulus.complex_modulus(abs(m) * SPEED)) for _, modulus, _ in layers]
    if m < 0:
        moduli = np.conj(moduli)
    given = [(thickness, mu, nu) for (thickness, _, nu), mu in zip(layers, moduli, strict=True)]
    expected = reference.surface_compliance(40e-3, given, abs(m), abs(k))
    flip = np.diag([1.0, -1.0 if m < 0 else 1.0, np.sign(k)])  # mirror images
    assert error(found, flip @ expected @ flip) < 1e-12


def test_identical_layers_act_as_one():
    parts = wheel(40e-3, [(3e-3, RUBBER, 0.45), (7e-3, RUBBER, 0.45)])
    whole = wheel(40e-3, [(10e-3, RUBBER, 0.45)])
    for m, k in [(0, 3.0), (2, 100.0), (300, 5e3)]:
        one = vr.modal.surface_compliance(whole, SPEED, m, k)
        assert error(vr.modal.surface_compliance(parts, SPEED, m, k), one) < 1e-12


def test_bad_orders_are_rejected():
    with pytest.raises(ValueError, match="k must be"):
        vr.modal.surface_compliance(wheel(40e-3, [(10e-3, RUBBER, 0.45)]), SPEED, 2, np.nan)


def test_a_cached_tread_has_the_compliance_of_a_new_one():
    # The cache keeps the compliance per modulus of treads with one relaxation function, for other rubbers and speeds. A
    # tread that is thicker by a hundredth of a nanometer is not in the cache.
    def torque(relaxed, time, thickness=10e-3):
        rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=relaxed, relaxation_time=time)
        tread = vr.Layer(thickness=thickness, shear_modulus=rubber, poisson_ratio=0.45)
        wheel = vr.CoatedWheel(core_radius=40e-3, layers=[tread], width=30e-3)
        mesh = vr.Mesh(nodes_per_revolution=300)
        return vr.solve(wheel, load=500.0, angular_speed=2.5, mesh=mesh, finite_strain=False).resisting_torque

    torque(3e6, 0.125)
    cached = torque(2e6, 0.02)
    assert cached == pytest.approx(torque(2e6, 0.02, 10e-3 + 1e-11), rel=1e-7)
    assert cached != torque(3e6, 0.125)
