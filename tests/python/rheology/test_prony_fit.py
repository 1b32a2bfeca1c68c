"""Fits of Prony series, with and without noise; moduli from loss factor and hardness; loss factor from rebound."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
import viscoroll as vr

#: Known series with two terms per decade, at times that are not round numbers.
KNOWN = vr.Prony(
    instantaneous_modulus=2e7,
    weights=[0.05, 0.06, 0.08, 0.1, 0.12, 0.1, 0.09, 0.08, 0.06],
    relaxation_times=0.37 * np.logspace(-4, 0, 9),
)


def sampled(series, omega, noise=0.0, seed=0):
    generator = np.random.default_rng(seed)
    modulus = series.complex_modulus(omega)
    storage, loss = (
        part * (1.0 + noise * generator.standard_normal(omega.size)) for part in (modulus.real, modulus.imag)
    )
    return SimpleNamespace(frequency=omega, storage=storage, loss=loss)


def torque(material):
    layer = vr.Layer(thickness=2e-3, shear_modulus=material, poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    result = vr.solve(ball, load=50.0, angular_speed=3.0, mesh=vr.Mesh(nodes_per_revolution=500))
    return result.dissipated_power / 3.0


OMEGA = np.geomspace(0.1, 1e5, 61)


def test_known_series_is_recovered():
    fit = vr.rheology.fit_prony(sampled(KNOWN, OMEGA))
    fine = np.geomspace(OMEGA[0], OMEGA[-1], 301)
    true, found = KNOWN.complex_modulus(fine), fit.series.complex_modulus(fine)
    np.testing.assert_allclose(found.real, true.real, rtol=0.01)
    np.testing.assert_allclose(found.imag, true.imag, rtol=0.01)
    assert torque(fit.series) == pytest.approx(torque(KNOWN), rel=0.005)


def test_known_series_from_noise_of_3_percent():
    found = [torque(vr.rheology.fit_prony(sampled(KNOWN, OMEGA, 0.03, seed)).series) for seed in range(5)]
    np.testing.assert_allclose(found, torque(KNOWN), rtol=0.02)


def test_intervals_contain_the_true_value():
    """Coverage over 40 noisy data sets and 10 frequencies; `tests/campaign/intervals.py` tests many more.

    The 800 samples are correlated over neighboring frequencies and between both moduli, so they count as about 200
    independent ones. The fraction inside has a standard deviation of about 2 %.
    """
    probe = np.geomspace(0.3, 3e4, 10)
    true = KNOWN.complex_modulus(probe)
    inside = []
    for seed in range(40):
        fit = vr.rheology.fit_prony(sampled(KNOWN, OMEGA, 0.03, seed))
        low, high = fit.confidence_band(probe, count=40, seed=seed)
        inside += [
            (low.real <= true.real) & (true.real <= high.real),
            (low.imag <= true.imag) & (true.imag <= high.imag),
        ]
    assert 0.88 <= np.mean(inside) <= 0.985


def test_scatter_estimates_the_noise():
    scatters = [vr.rheology.fit_prony(sampled(KNOWN, OMEGA, 0.03, seed)).scatter for seed in range(10)]
    assert np.mean(scatters) == pytest.approx(0.03, rel=0.1)


def test_isolated_terms_need_more_times_per_decade():
    """A single term between the times of the grid is fitted poorly with two times per decade, and well with eight."""
    series = vr.Prony(instantaneous_modulus=1e7, weights=[0.3, 0.2, 0.3], relaxation_times=[1.3e-3, 0.9, 57.0])
    omega = np.geomspace(1e-3, 1e4, 71)
    coarse, fine = (vr.rheology.fit_prony(sampled(series, omega), terms_per_decade=n) for n in (2, 8))
    assert fine.loss_rms < 0.01
    assert coarse.loss_rms > 3.0 * fine.loss_rms


def test_sparse_series_on_request():
    """A series of three isolated terms is recovered; seven terms fit a series of nine less well than the full fit."""
    isolated = vr.Prony(instantaneous_modulus=1e7, weights=[0.3, 0.2, 0.3], relaxation_times=[1.3e-3, 0.9, 57.0])
    found = vr.rheology.fit_prony(sampled(isolated, np.geomspace(1e-3, 1e4, 71))).sparse(3).series
    np.testing.assert_allclose(sorted(found.relaxation_times), [1.3e-3, 0.9, 57.0], rtol=1e-3)
    full = vr.rheology.fit_prony(sampled(KNOWN, OMEGA))
    few = full.sparse(7)
    assert len(few.series.weights) <= 7
    assert full.loss_rms < few.loss_rms < 0.05
    with pytest.raises(ValueError, match="terms must be >= 1, got 0"):
        full.sparse(0)


def test_relaxed_modulus_has_a_floor():
    """A liquid has no relaxed modulus, so the fit returns `relaxed_floor`.

    Its default is a hundredth of the lowest storage modulus.
    """
    omega = np.geomspace(0.1, 1e3, 41)
    x = 1j * omega * 0.01
    fluid = 1e6 * x / (1.0 + x)
    curve = SimpleNamespace(frequency=omega, storage=fluid.real, loss=fluid.imag)
    fit = vr.rheology.fit_prony(curve)
    assert fit.relaxed_modulus == pytest.approx(1e-2 * fluid.real.min(), rel=1e-6)
    assert vr.rheology.fit_prony(curve, relaxed_floor=5.0).relaxed_modulus == pytest.approx(5.0, rel=1e-3)


def test_picture_and_text():
    fit = vr.rheology.fit_prony(sampled(KNOWN, OMEGA, 0.01))
    assert "error of storage" in repr(fit)
    above, below = fit.plot().axes
    assert above.get_ylabel() == "shear modulus [Pa]"
    assert below.get_xlabel() == "angular frequency [rad/s]"


@pytest.mark.parametrize(
    ("curve", "options", "error", "message"),
    [
        (
            SimpleNamespace(frequency=[1.0, 2.0], storage=[1.0, 1.0], loss=[1.0, 1.0]),
            {},
            ValueError,
            "at least 3 points",
        ),
        (
            SimpleNamespace(frequency=[1.0, 2.0, 3.0], storage=[1.0] * 3, loss=[0.0] * 3),
            {},
            ValueError,
            "curve.loss must be > 0",
        ),
        (
            SimpleNamespace(frequency=[1.0, 2.0, 3.0], storage=[1.0] * 2, loss=[1.0] * 3),
            {},
            ValueError,
            "columns of equal length",
        ),
        (3.0, {}, TypeError, "curve must have frequency, storage and loss, got 3.0"),
        (
            sampled(KNOWN, OMEGA),
            {"terms_per_decade": 0.0},
            ValueError,
            r"terms_per_decade must be in \[0.5, 10\], got 0",
        ),
        (sampled(KNOWN, OMEGA), {"relaxed_floor": 0.0}, ValueError, "relaxed_floor must be > 0 Pa, got 0"),
    ],
)
def test_invalid_curves_and_options_are_rejected(curve, options, error, message):
    with pytest.raises(error, match=message):
        vr.rheology.fit_prony(curve, **options)


@pytest.mark.parametrize(("loss_factor", "error"), [(1e-3, 2e-3), (0.1, 2e-3), (0.5, 2e-3), (1.0, 5e-3), (2.0, 3e-2)])
@pytest.mark.parametrize("decades", [1.0, 3.0])
def test_loss_factor_is_constant_over_its_decades(loss_factor, error, decades):
    pad = vr.LossFactor(modulus=2e6, loss_factor=loss_factor, reference_frequency=50.0, decades=decades)
    omega = 50.0 * np.logspace(-decades, decades, 81)
    modulus = pad.complex_modulus(omega)
    np.testing.assert_allclose(modulus.imag / modulus.real, loss_factor, rtol=error)
    assert pad.complex_modulus(50.0).real == pytest.approx(2e6, rel=1e-12)


def test_loss_factor_follows_kjartanssons_law():
    """The storage modulus rises as ω^α, and a passive Prony series fits the modulus, so it is causal."""
    pad = vr.LossFactor(modulus=1e6, loss_factor=0.3, reference_frequency=10.0)
    omega = 10.0 * np.logspace(-3, 3, 61)
    alpha = 2.0 / np.pi * np.arctan(0.3)
    np.testing.assert_allclose(pad.complex_modulus(omega).real, 1e6 * (omega / 10.0) ** alpha, rtol=2e-3)
    assert vr.rheology.fit_prony(sampled(pad, omega)).loss_rms < 0.005


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"modulus": 0.0}, "modulus must be > 0 Pa, got 0$"),
        ({"loss_factor": 3.0}, r"loss_factor must be in \[1e-06, 2\], got 3$"),
        ({"reference_frequency": -1.0}, "reference_frequency must be > 0 rad/s, got -1$"),
        ({"decades": 9.0}, r"decades must be in \[0.5, 8\], got 9$"),
    ],
)
def test_loss_factor_out_of_range(change, message):
    with pytest.raises(ValueError, match=message):
        vr.LossFactor(**({"modulus": 1e6, "loss_factor": 0.1, "reference_frequency": 1.0} | change))


def test_hardness():
    """Compare with Gent's and Qi's relations at Shore A 60, by hand: E = 3.61 and 5.89 MPa."""
    shear = vr.rheology.hardness_to_modulus(60.0)
    assert shear.value == pytest.approx(np.sqrt(3.605e6 * 5.884e6) / 3.0, rel=1e-3)
    assert shear.lower < 3.605e6 / 3.0 < 5.884e6 / 3.0 < shear.upper
    # Qi's S = S_D + 50
    assert vr.rheology.hardness_to_modulus(30.0, scale="D").value == pytest.approx(
        10 ** (0.0235 * 80 - 0.6403) * 1e6 / 3.0
    )
    with pytest.raises(ValueError, match=r"hardness must be in \[20, 90\] Shore A, got 95"):
        vr.rheology.hardness_to_modulus(95.0)
    with pytest.raises(ValueError, match="scale must be 'A' or 'D', got 'B'"):
        vr.rheology.hardness_to_modulus(50.0, scale="B")


def test_rebound():
    """A weakly damped oscillator, η = 2 ζ, retains e^(-2 π ζ / sqrt(1 - ζ²)) of its energy over half a cycle."""
    for damping in (1e-3, 0.05):
        kept = np.exp(-np.pi * damping / np.sqrt(1.0 - damping**2)) ** 2  # square of the ratio of amplitudes
        assert vr.rheology.rebound_to_loss_factor(kept).value == pytest.approx(2.0 * damping, rel=2.0 * damping**2)
    with pytest.raises(
        ValueError, match=r"^rebound must be in \[0.02, 1\), as a fraction of the energy, got 55; 55 % is 0.55$"
    ):
        vr.rheology.rebound_to_loss_factor(55)
    with pytest.raises(ValueError, match=r"got 1$"):
        vr.rheology.rebound_to_loss_factor(1.0)
    with pytest.raises(TypeError, match="rebound must be a real number, got str '55 %'"):
        vr.rheology.rebound_to_loss_factor("55 %")


def test_hardness_as_written_on_data_sheets():
    assert vr.rheology.hardness_to_modulus(60.0, scale="a") == vr.rheology.hardness_to_modulus(60.0)
    assert vr.rheology.hardness_to_modulus(40.0, scale="d") == vr.rheology.hardness_to_modulus(40.0, scale="D")
    with pytest.raises(TypeError, match=r"^hardness must be a real number, got str '60 A'; pass the scale separately"):
        vr.rheology.hardness_to_modulus("60 A")
    with pytest.raises(ValueError, match=r"^scale must be 'A' or 'D', got 'Shore A'$"):
        vr.rheology.hardness_to_modulus(60.0, scale="Shore A")
    with pytest.raises(ValueError, match=r"^scale must be 'A' or 'D', got None$"):
        vr.rheology.hardness_to_modulus(60.0, scale=None)
