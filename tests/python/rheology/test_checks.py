"""Checks of measured moduli: scatter causes no false alarm, and larger errors are detected."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import command

RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)


def scattered(omega, storage, loss, seed, scatter=0.03):
    generator = np.random.default_rng(seed)
    noisy = (part * (1.0 + scatter * generator.standard_normal(omega.size)) for part in (storage, loss))
    return SimpleNamespace(frequency=omega, **dict(zip(("storage", "loss"), noisy, strict=True)))


@pytest.mark.parametrize("omega", [np.logspace(-4, 1, 51), np.logspace(-1, 2, 31)], ids=["on a plateau", "rising"])
def test_scatter_of_3_percent_is_not_a_decrease_of_the_storage_modulus(omega):
    """Each check refuses at most two of 40 sweeps of a passive rubber, because its limit is statistical."""
    modulus = RUBBER.complex_modulus(omega)
    refused = np.zeros(4)
    for seed in range(40):
        curve = scattered(omega, modulus.real, modulus.imag, seed)
        refused += [not check.passed for check in vr.rheology.check_modulus(curve)]
    assert (refused <= 2).all()


def test_a_decrease_larger_than_the_scatter_is_detected():
    """A decrease by a fifth over three decades is six times the scatter, and is found in each of 40 sweeps."""
    omega = np.logspace(-1, 2, 31)
    falling = 1e6 * np.linspace(1.0, 0.8, omega.size)
    for seed in range(40):
        monotonicity = vr.rheology.check_modulus(scattered(omega, falling, np.full(omega.size, 1e5), seed))[2]
        assert not monotonicity.passed
        assert "scatter of the points" in monotonicity.message


def test_limits_of_a_smooth_curve():
    """A single point 3 % below a smooth curve is reported, and one 1 % below passes."""
    omega = np.logspace(-1, 2, 31)
    modulus = RUBBER.complex_modulus(omega)
    for depth, passes in ((0.03, False), (0.01, True)):
        storage = modulus.real.copy()
        storage[-3] *= 1.0 - depth
        check = vr.rheology.check_modulus(SimpleNamespace(frequency=omega, storage=storage, loss=modulus.imag))[2]
        assert check.passed is passes
        assert check.limit == pytest.approx(0.02)


def test_the_command_saves_inconsistent_sweeps_only_if_they_are_accepted(tmp_path):
    """The storage modulus decreases with frequency, which no passive solid can do."""
    path, saved = tmp_path / "sweep.csv", tmp_path / "rubber.toml"
    rows = "".join(f"{w!r},{1e6 * w**-0.1!r},1e5\n" for w in np.logspace(-1, 2, 31).tolist())
    path.write_text(f"f [rad/s],G' [Pa],G'' [Pa]\n{rows}")
    done = command("material", path, "--save", saved)
    assert done.returncode == 2
    assert "monotonicity: INCONSISTENT" in done.stdout
    message = " ".join(done.stderr.split())
    assert "sweep.csv: must be consistent with one passive material, got residual of the best causal series" in message
    assert "give --accept to use the data anyway" in message
    assert not saved.exists()
    assert command("material", path, "--save", saved, "--accept").returncode == 0
    assert isinstance(vr.rheology.load_material(saved), vr.MasterCurve)
