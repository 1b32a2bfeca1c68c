"""Draws of measured materials: their scatter, their independence, and shifts that are fitted again."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import viscoroll as vr
from campaign.intervals import REFERENCE, RUBBER, TEMPERATURES, Noise, measured, true_modulus
from viscoroll.rheology import Isotherm
from viscoroll.rheology.bootstrap import wild_copies

OMEGA = np.geomspace(0.1, 1e3, 61)
PROBE = np.geomspace(1.0, 100.0, 7)


def sampled(storage_noise, loss_noise, seed=0):
    generator = np.random.default_rng(seed)
    modulus = RUBBER.complex_modulus(OMEGA)
    storage = modulus.real * (1.0 + storage_noise * generator.standard_normal(OMEGA.size))
    loss = modulus.imag * (1.0 + loss_noise * generator.standard_normal(OMEGA.size))
    return Isotherm(temperature=293.15, frequency=OMEGA, storage=storage, loss=loss)


def scatter(draws):
    """Return standard deviations of storage and loss at some frequencies, relative to the middle."""
    middle = draws.best_estimate.complex_modulus(PROBE)
    values = np.array([draw.complex_modulus(PROBE) for draw in draws])
    return values.real.std(axis=0) / middle.real, values.imag.std(axis=0) / middle.imag


def test_draws_scatter_like_fits_to_new_data():
    """Compare, to a third, 60 fits to new noise with 60 draws of each of 4 data sets.

    The standard deviations themselves have errors of about 10 % and 20 %.
    """
    fits = [vr.rheology.fit_prony(sampled(0.03, 0.03, seed)) for seed in range(60)]
    refitted = scatter(vr.materials.Draws(RUBBER, [fit.series for fit in fits]))
    drawn = np.mean([scatter(fit.draws(60)) for fit in fits[:4]], axis=0)
    np.testing.assert_allclose(drawn.mean(axis=1), np.mean(refitted, axis=1), rtol=0.35)


def test_simulated_data_have_errors_of_random_sign_corrected_for_leverage():
    """The size of each error is that of the data divided by 1 - leverage, at most ten times as large."""
    expected = np.array([1.0, 2.0, 4.0, 8.0])
    data = expected * [1.1, 0.9, 1.05, 1.0]
    columns = np.array([[1.0], [1.0], [0.0], [0.0]])  # leverage ½, ½, 0 and 0
    copies = np.array(list(wild_copies(data, expected, columns, count=50, seed=0)))
    np.testing.assert_allclose(np.abs(copies / expected - 1.0), np.tile([0.2, 0.2, 0.05, 0.0], (50, 1)), atol=1e-12)
    assert (copies[:, :3].std(axis=0) > 0.0).all()
    (first, *_) = wild_copies(data, expected, np.eye(4), count=2, seed=0)
    error = first / expected - 1.0  # -1 would give a zero modulus
    np.testing.assert_allclose(error, np.where(error > 0.0, [1.0, 1.0, 0.5, 0.0], [-0.9, -0.9, -0.5, 0.0]), atol=1e-12)


def test_seed_and_data_determine_the_draws():
    fit = vr.rheology.fit_prony(sampled(0.03, 0.03))
    first, again, other = (fit.draws(3, seed=seed) for seed in (0, 0, 1))
    assert first[0] == again[0] != other[0]
    assert first.best_estimate == fit.series
    # Materials measured at the same frequencies have independent draws.
    of_others = vr.rheology.fit_prony(sampled(0.03, 0.03, seed=1)).draws(100)
    of_these = fit.draws(100)
    torques = [np.array([m.complex_modulus(10.0).imag for m in draws]) for draws in (of_these, of_others)]
    assert abs(np.corrcoef(*torques)[0, 1]) < 0.35  # the standard deviation is 0.1


def test_a_sparse_fit_draws_sparse_series():
    draws = vr.rheology.fit_prony(sampled(0.02, 0.02)).sparse(4).draws(3)
    assert all(len(series.weights) <= 4 for series in (draws.best_estimate, *draws))


@pytest.fixture(scope="module")
def curve():
    return vr.rheology.superpose(measured(2, Noise()), reference=REFERENCE)


def test_draws_fit_the_shifts_again(curve):
    """The shifts scatter by their linear covariance, to a half; the scatter of 40 draws is accurate to a tenth."""
    draws = curve.draws(40)
    factors = np.array([draw.factors.log10_factor for draw in draws])
    others = np.arange(len(TEMPERATURES)) != curve.anchor
    expected = np.sqrt(np.diag(curve.covariance))
    np.testing.assert_allclose(factors.std(axis=0, ddof=1)[others], expected, rtol=0.5)
    assert (factors[:, curve.anchor] == 0.0).all()
    at_rest = draws.map(lambda c: c.series_at(temperature=313.15))
    assert isinstance(at_rest, vr.materials.Draws)
    assert at_rest[3] == draws[3].series_at(temperature=313.15)


def test_factors_of_the_user_are_kept():
    factors = vr.rheology.ShiftFactors(temperature=TEMPERATURES, log10_factor=(1.9, 0.9, 0.0, -0.8, -1.5))
    curve = vr.rheology.superpose(measured(2, Noise()), reference=REFERENCE, factors=factors)
    draws = curve.draws(3)
    assert all(draw.factors is curve.factors for draw in draws)
    assert not np.array_equal(draws[0].storage, draws[1].storage)


def test_draws_fit_the_vertical_shifts_again():
    draws = vr.rheology.superpose(measured(2, Noise()), reference=REFERENCE, vertical=True).draws(3)
    assert len({draw.vertical for draw in (draws.best_estimate, *draws)}) == 4


def test_bias_of_the_shifts_is_small(curve):
    true = [np.log10(true_modulus(t).relaxation_times[0] / RUBBER.relaxation_times[0]) for t in TEMPERATURES]
    errors = np.array(curve.factors.log10_factor) - true
    assert (np.abs(errors[errors != 0.0]) < 4.0 * np.sqrt(np.diag(curve.covariance))).all()


def test_draws_are_a_sequence(curve):
    draws = vr.materials.Draws(3.0e6, [2.9e6, 3.2e6, 3.0e6])
    assert (len(draws), draws[0], list(draws[1:]), 3.2e6 in draws) == (3, 2.9e6, [3.2e6, 3.0e6], True)
    assert repr(draws) == "3 draws of 3000000.0"
    assert list(pickle.loads(pickle.dumps(draws))) == list(draws)
    with pytest.raises(ValueError, match="members must be at least 2 draws, got 1"):
        vr.materials.Draws(3.0e6, [3.0e6])
    with pytest.raises(ValueError, match=r"count must be in \[2, 100000\], got 1"):
        curve.draws(1)
    with pytest.raises(ValueError, match="seed must be >= 0, got -1"):
        curve.fit.draws(seed=-1)
    with pytest.raises(ValueError, match=r"confidence must be in \(0, 1\), got 95"):
        curve.fit.confidence_band([1.0], confidence=95)
