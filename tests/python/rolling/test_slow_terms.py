"""Series whose slow terms hold the modulus at rest: kept terms against series cut by hand, melts, and messages."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import _core

SLOW = 1e6  # product of angular speed and relaxation time from which a term is not relaxed at rest


def roller(modulus, poisson_ratio=0.4):
    layer = vr.Layer(thickness=5e-3, shear_modulus=modulus, poisson_ratio=poisson_ratio)
    return vr.CoatedCylinder(core_radius=20e-3, layers=[layer])


def ball(modulus, poisson_ratio=0.4):
    layer = vr.Layer(thickness=3e-3, shear_modulus=modulus, poisson_ratio=poisson_ratio)
    return vr.CoatedSphere(core_radius=20e-3, layers=[layer])


def without_slow_terms(series, angular_speed):
    """Return the series without its slow terms, whose moduli become part of the relaxed modulus."""
    kept = [(w, t) for w, t in zip(series.weights, series.relaxation_times, strict=True) if t * angular_speed < SLOW]
    weights, times = zip(*kept, strict=True)
    return vr.Prony(instantaneous_modulus=series.instantaneous_modulus, weights=weights, relaxation_times=times)


#: Series of 27 terms: a transition from glass to rubber, whose plateau of 1 MPa is held by terms from 1e6 to 1e12 s.
TWENTY_SEVEN = vr.Prony.from_moduli(
    relaxed_modulus=2e3,
    moduli=[*(1e9 * np.geomspace(0.3, 3e-4, 20)), *np.full(7, 1.4e5)],
    relaxation_times=[*np.geomspace(1e-9, 10.0, 20), *np.geomspace(1e6, 1e12, 7)],
)

#: Master curve from a glass of 1 GPa to a rubber of 1 MPa, with terms of up to 1e8 s.
GLASS_TO_RUBBER = vr.Prony.from_moduli(
    relaxed_modulus=1e6,
    moduli=1e9 * np.geomspace(0.25, 1e-5, 35),
    relaxation_times=np.geomspace(1e-9, 1e8, 35),
)


@pytest.mark.parametrize("angular_speed", [1.0, 10.0, 100.0])
@pytest.mark.parametrize(("body", "load"), [(roller, 1e3), (ball, 2.0)], ids=["roller", "ball"])
@pytest.mark.parametrize("series", [TWENTY_SEVEN, GLASS_TO_RUBBER], ids=["27-terms", "glass-to-rubber"])
def test_kept_terms_agree_with_a_series_cut_by_hand(series, body, load, angular_speed):
    with pytest.warns(vr.ResultWarning, match="too slow to relax at this speed"):
        kept = vr.solve(body(series), load=load, angular_speed=angular_speed)
    cut = vr.solve(body(without_slow_terms(series, angular_speed)), load=load, angular_speed=angular_speed)
    # The terms add at most 1 / SLOW to the loss tangent, which is at least 0.01 in both materials.
    assert kept.rolling_resistance_coefficient == pytest.approx(cut.rolling_resistance_coefficient, rel=1e-4)
    assert kept.penetration == pytest.approx(cut.penetration, rel=1e-4)
    assert not cut.warnings


def test_a_plateau_held_by_one_slow_term():
    slow = vr.Prony(instantaneous_modulus=6e8, weights=[0.5, 0.499], relaxation_times=[0.1, 1e9])
    cut = vr.Prony(instantaneous_modulus=6e8, weights=[0.5], relaxation_times=[0.1])
    with pytest.warns(vr.ResultWarning) as issued:
        found = vr.solve(roller(slow), load=5e3, angular_speed=10.0)
    assert found.rolling_resistance_coefficient == pytest.approx(
        vr.solve(roller(cut), load=5e3, angular_speed=10.0).rolling_resistance_coefficient, rel=1e-7
    )
    expected = (
        "layers[0].shear_modulus has 1 term with a relaxation time of at least 1e+09 s, too slow to relax at this "
        "speed: 2.99e+08 of the 3e+08 Pa of the modulus at rest belong to it"
    )
    assert [str(one.message) for one in issued] == [expected]
    assert found.warnings == {_core.WarningKind.SLOW_TERMS: expected}


def test_a_relaxed_modulus_a_thousandth_of_that_at_the_contact_frequency():
    # Without slow terms, the relaxed modulus itself is small; the power balance of the solution is the check.
    rubber = vr.Prony(
        instantaneous_modulus=1e9, weights=0.999 * np.full(8, 0.125), relaxation_times=np.geomspace(1e-3, 10.0, 8)
    )
    for angular_speed in (10.0, 30.0, 100.0):
        found = vr.solve(roller(rubber, 0.5), load=1e3, angular_speed=angular_speed)
        assert not found.warnings
        assert found.energy_balance_error < 0.01


def test_modulus_in_rolling():
    series = vr.Prony(instantaneous_modulus=1e6, weights=[0.4, 0.3, 0.2], relaxation_times=[1.0, 1e5, 1e9])
    omega = np.array([0.0, 3.0, 30.0])
    for angular_speed, at_rest in ((9.9, 0.3e6), (10.0, 0.6e6), (1e-4, 0.1e6)):
        found = _core.modulus_in_rolling(series._to_core(), angular_speed, omega)
        np.testing.assert_allclose(found[0], at_rest, rtol=1e-14)
        np.testing.assert_array_equal(found[1:], series.complex_modulus(omega[1:]))


def test_melts_roll_as_solids_above_a_speed():
    melt = vr.Prony(instantaneous_modulus=6e6, weights=[0.5, 0.5], relaxation_times=[0.1, 1e5])
    rule = (
        r"^angular_speed must be >= 10 rad/s for a Prony series whose weights add up to 1, so that its slowest term, "
        r"of 1e\+05 s, does not relax; or the weights must add up to less than 1, got 9.9 rad/s"
    )
    with pytest.raises(vr.InvalidInput, match=rule):
        vr.solve(roller(melt), load=100.0, angular_speed=9.9)
    with pytest.warns(vr.ResultWarning, match="too slow to relax"):
        found = vr.solve(roller(melt), load=100.0, angular_speed=10.0)
    solid = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.1)
    expected = vr.solve(roller(solid), load=100.0, angular_speed=10.0)
    assert found.rolling_resistance_coefficient == pytest.approx(expected.rolling_resistance_coefficient, rel=1e-4)


@pytest.mark.filterwarnings("ignore::viscoroll.ResultWarning")
def test_sensitivities_keep_slow_terms():
    melt = vr.Prony(instantaneous_modulus=6e6, weights=[0.5, 0.5], relaxation_times=[0.1, 1e6])
    solid = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.1)
    found, expected = (
        vr.solve(roller(modulus), load=100.0, angular_speed=10.0, accuracy=0.05).sensitivity()
        for modulus in (melt, solid)
    )
    np.testing.assert_allclose(found.moduli[0].storage, expected.moduli[0].storage, rtol=1e-3, atol=1e-5)
