"""Complex moduli: closed forms, limits, and input checks."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import viscoroll as vr
from hypothesis import given
from hypothesis import strategies as st
from reference import layers
from viscoroll import enums
from viscoroll.materials.shift import scaled, shifted

OMEGA = np.array([0.0, 1e-3, 0.3, 8.0, 8.1, 500.0, 1e7])


def test_prony_is_equation_65():
    series = vr.Prony(instantaneous_modulus=5e6, weights=[0.3, 0.25, 0.05], relaxation_times=[1e-3, 0.2, 30.0])
    expected = layers.prony(5e6, [0.3, 0.25, 0.05], [1e-3, 0.2, 30.0], OMEGA)
    np.testing.assert_allclose(series.complex_modulus(OMEGA), expected, rtol=1e-14)


def compliance_modulus(instantaneous, compliances, times):
    """Return 1/J* over OMEGA, evaluated with 50 digits."""
    with mpmath.workdps(50):
        values = []
        for omega in OMEGA:
            terms = (j / (1 + 1j * mpmath.mpf(omega) * tau) for j, tau in zip(compliances, times, strict=True))
            values.append(complex(1 / (mpmath.mpf(instantaneous) + sum(terms))))
    return np.array(values)


@pytest.mark.parametrize(
    ("compliances", "times"),
    [
        ([], []),
        ([2e-6], [0.3]),
        ([1e-7, 2e-6, 3e-8, 5e-4], [1e-6, 0.1, 30.0, 2e4]),
        ([1e-6, 1e-6], [0.1, 0.1]),  # one term
        ([1e-6, 1e-6], [0.1, 0.1 * (1 + 1e-12)]),
        ([1e-30, 1e-6, 0.0], [1.0, 0.5, 2.0]),
        ((1e-6 * 10.0 ** -np.arange(40.0)).tolist(), np.geomspace(1e-8, 1e8, 40).tolist()),
    ],
)
def test_creep_compliance_agrees_with_its_prony_series(compliances, times):
    solid = vr.materials.CreepCompliance(
        instantaneous_compliance=1e-6, compliances=compliances, retardation_times=times
    )
    expected = compliance_modulus(1e-6, compliances, times)
    np.testing.assert_allclose(solid.complex_modulus(OMEGA), expected, rtol=1e-12)
    np.testing.assert_array_equal(solid.prony().complex_modulus(OMEGA), solid.complex_modulus(OMEGA))


def test_creep_compliance_of_one_term_is_the_standard_linear_solid():
    # J_0 = 1/G_0, J_1 = 1/G_inf - 1/G_0, and the retardation time is tau G_0 / G_inf.
    solid = vr.materials.CreepCompliance(
        instantaneous_compliance=1 / 6e6, compliances=[1 / 3e6 - 1 / 6e6], retardation_times=[0.25]
    )
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    np.testing.assert_allclose(solid.complex_modulus(OMEGA), rubber.complex_modulus(OMEGA), rtol=1e-14)


MODULI = {
    "elastic": vr.Elastic(modulus=2e6),
    "prony": vr.Prony(instantaneous_modulus=5e6, weights=[0.3, 0.2], relaxation_times=[1e-3, 0.2]),
    "standard linear solid": vr.StandardLinearSolid(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125
    ),
    "creep": vr.materials.CreepCompliance(instantaneous_compliance=1e-6, compliances=[1e-6], retardation_times=[0.2]),
    "Kelvin-Voigt": vr.materials.KelvinVoigt(modulus=2e6, viscosity=1e4),
    "fractional": vr.materials.FractionalZener(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=0.4
    ),
    "Havriliak-Negami": vr.materials.HavriliakNegami(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=0.8, asymmetry=0.4
    ),
    "master curve": vr.MasterCurve([1e-3, 1.0, 1e6], [1e6, 2e6, 4e6], [1e5, 2e5, 1e5]),
    "loss factor": vr.LossFactor(modulus=1e6, loss_factor=0.2, reference_frequency=10.0),
    "function": lambda omega: 1e6 + 1e5j * np.sign(omega),
}


@pytest.mark.parametrize("name", MODULI)
def test_shifted_and_scaled_moduli_keep_their_type(name):
    modulus, omega = MODULI[name], np.array([0.3, 8.0, 500.0])
    faster, stiffer = shifted(modulus, 0.25), scaled(modulus, 3.0)
    assert type(faster) is type(stiffer) is type(modulus)
    value = modulus if callable(modulus) else modulus.complex_modulus
    for changed, expected in ((faster, value(0.25 * omega)), (stiffer, 3.0 * value(omega))):
        found = (changed if callable(changed) else changed.complex_modulus)(omega)
        np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_standard_linear_solid_is_a_prony_series(rubber):
    series = vr.Prony(instantaneous_modulus=6e6, weights=[0.5], relaxation_times=[0.125])
    np.testing.assert_array_equal(rubber.complex_modulus(OMEGA), series.complex_modulus(OMEGA))


def test_standard_linear_solid_without_relaxation_is_elastic():
    solid = vr.StandardLinearSolid(instantaneous_modulus=3e6, relaxed_modulus=3e6, relaxation_time=1.0)
    np.testing.assert_array_equal(solid.complex_modulus(OMEGA), np.full(OMEGA.shape, 3e6 + 0j))


def test_kelvin_voigt():
    expected = 2e6 + 1j * OMEGA * 1e4
    np.testing.assert_array_equal(vr.materials.KelvinVoigt(modulus=2e6, viscosity=1e4).complex_modulus(OMEGA), expected)


def test_fractional_zener():
    solid = vr.materials.FractionalZener(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=0.4
    )
    power = (1j * OMEGA * 0.125) ** 0.4
    expected = (3e6 + 6e6 * power) / (1 + power)
    np.testing.assert_allclose(solid.complex_modulus(OMEGA), expected, rtol=1e-14)


def test_fractional_zener_of_order_one_is_the_standard_linear_solid(rubber):
    solid = vr.materials.FractionalZener(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=1.0
    )
    np.testing.assert_allclose(solid.complex_modulus(OMEGA), rubber.complex_modulus(OMEGA), rtol=1e-14)


def havriliak_negami(omega, order, asymmetry):
    """Return the modulus of `HAVRILIAK_NEGAMI` with other exponents, evaluated with 50 digits."""
    with mpmath.workdps(50):
        power = (1j * mpmath.mpf(omega) * mpmath.mpf(0.125)) ** mpmath.mpf(order)
        return complex(6e6 - (6e6 - 2.0) / (1 + power) ** mpmath.mpf(asymmetry))


HAVRILIAK_NEGAMI = {"instantaneous_modulus": 6e6, "relaxed_modulus": 2.0, "relaxation_time": 0.125}


@pytest.mark.parametrize("asymmetry", [1e-3, 0.25, 0.9, 1.0])
@pytest.mark.parametrize("order", [0.05, 0.6, 1.0])
def test_havriliak_negami(order, asymmetry):
    """The relaxed modulus is so small that a difference of the other terms would lose it to round-off."""
    solid = vr.materials.HavriliakNegami(**HAVRILIAK_NEGAMI, order=order, asymmetry=asymmetry)
    omega = np.geomspace(1e-20, 1e20, 41)
    expected = np.array([havriliak_negami(w, order, asymmetry) for w in omega.tolist()])
    found = solid.complex_modulus(omega)
    np.testing.assert_allclose(found.real, expected.real, rtol=1e-12)
    np.testing.assert_allclose(found.imag, expected.imag, rtol=1e-12)


def test_limits_of_havriliak_negami():
    solid = vr.materials.HavriliakNegami(**HAVRILIAK_NEGAMI, order=0.6, asymmetry=0.25)
    assert solid.complex_modulus(0.0) == 2.0
    # G_0 - (G_0 - G_inf) (w tau)^(-alpha beta), which at the largest frequency is below round-off for other exponents
    slow = vr.materials.HavriliakNegami(**HAVRILIAK_NEGAMI, order=1.0, asymmetry=1e-3)
    expected = 6e6 - (6e6 - 2.0) * (1j * 1e300 * 0.125) ** -1e-3
    np.testing.assert_allclose(slow.complex_modulus(1e300), expected, rtol=1e-12)


def test_symmetric_havriliak_negami_is_the_fractional_zener_solid():
    given = {"instantaneous_modulus": 6e6, "relaxed_modulus": 3e6, "relaxation_time": 0.125, "order": 0.4}
    solid, symmetric = vr.materials.FractionalZener(**given), vr.materials.HavriliakNegami(**given, asymmetry=1.0)
    np.testing.assert_allclose(symmetric.complex_modulus(OMEGA), solid.complex_modulus(OMEGA), rtol=1e-14)


def test_master_curve_is_linear_in_log_frequency():
    frequency, storage, loss = [0.1, 1.0, 30.0], [1e6, 2e6, 2.5e6], [1e5, 4e5, 2e5]
    curve = vr.MasterCurve(frequency, storage, loss)
    omega = np.geomspace(0.1, 30.0, 41)
    expected = np.interp(np.log(omega), np.log(frequency), storage) + 1j * np.interp(
        np.log(omega), np.log(frequency), loss
    )
    np.testing.assert_allclose(curve.complex_modulus(omega), expected, rtol=1e-13)


def test_master_curve_raises_or_holds_outside_its_table():
    table = ([1.0, 10.0], [1e6, 2e6], [1e5, 2e5])
    message = r"frequency must be within the master curve's table, 1 to 10 rad/s .*, got 10.5 rad/s"
    with pytest.raises(ValueError, match=message):
        vr.MasterCurve(*table).complex_modulus(10.5)
    with pytest.raises(ValueError, match=r"give the static modulus .*, got 0 rad/s"):
        vr.MasterCurve(*table).complex_modulus(0.0)
    held = vr.MasterCurve(*table, extrapolation=enums.Extrapolation.HOLD)
    np.testing.assert_array_equal(held.complex_modulus([0.0, 0.5, 99.0]), [1e6, 1e6 + 1e5j, 2e6 + 2e5j])


def test_master_curve_may_contain_a_static_modulus_at_zero():
    curve = vr.MasterCurve([0.0, 1.0, 10.0], [0.8e6, 1e6, 2e6], [0.0, 1e5, 2e5])
    np.testing.assert_array_equal(curve.complex_modulus([0.0, 1.0]), [0.8e6, 1e6 + 1e5j])
    with pytest.raises(ValueError, match=r"\(widen the table or set extrapolation to HOLD\), got 0.5 rad/s"):
        curve.complex_modulus(0.5)


def test_complex_modulus_keeps_the_shape(rubber):
    assert rubber.complex_modulus(3.0).shape == ()
    assert rubber.complex_modulus(np.ones((2, 3))).shape == (2, 3)


@given(
    weights=st.lists(st.floats(1e-3, 0.2), min_size=1, max_size=4),
    decades=st.lists(st.floats(-6, 6), min_size=4, max_size=4),
)
def test_prony_is_passive_and_grows_with_frequency(weights, decades):
    times = [10.0**d for d in decades[: len(weights)]]
    modulus = vr.Prony(instantaneous_modulus=1e6, weights=weights, relaxation_times=times).complex_modulus(
        np.geomspace(1e-8, 1e8, 60)
    )
    assert (modulus.imag >= 0.0).all()
    # The tolerance is the round-off of sums of a few terms.
    assert (np.diff(modulus.real) >= -1e-15 * 1e6 * len(weights)).all()


def test_a_callable_may_be_a_modulus(paper_ball, rubber):
    mesh = vr.Mesh(nodes_per_revolution=100, max_order=100)
    layer = vr.Layer(thickness=1e-3, shear_modulus=rubber.complex_modulus, poisson_ratio=0.5, density=1000.0)
    custom = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
    expected = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=mesh)
    result = vr.solve(custom, load=100.0, angular_speed=2.5, mesh=mesh)
    assert result.resisting_torque == pytest.approx(expected.resisting_torque, rel=1e-12)


@pytest.mark.parametrize("modulus", [3e6, np.float64(3e6), 3_000_000, lambda w: 3e6])
def test_a_number_is_an_elastic_modulus(modulus):
    expected, found = (
        vr.modal.surface_compliance(
            vr.CoatedSphere(core_radius=1.0, layers=[vr.Layer(thickness=0.1, shear_modulus=m, poisson_ratio=0.4)]),
            1.0,
            2,
            3,
        )
        for m in (vr.Elastic(modulus=3e6), modulus)
    )
    np.testing.assert_array_equal(found, expected)


def test_weights_that_sum_to_1_except_for_round_off():
    """Ten weights of 0.1 sum to 1 within round-off, which describes a fluid without a modulus at rest."""
    for weights in ([0.1] * 10, [0.7, 0.2, 0.1 + 2e-16], [1.0]):
        series = vr.Prony(instantaneous_modulus=1e6, weights=weights, relaxation_times=np.arange(len(weights)) + 1.0)
        assert series.complex_modulus(1e9).real == pytest.approx(1e6)
        assert series.complex_modulus(1e-6).real < 1e-3 * 1e6
    with pytest.raises(ValueError, match="weights must be such that their sum is <= 1"):
        vr.Prony(instantaneous_modulus=1e6, weights=[0.7, 0.3001], relaxation_times=[1.0, 2.0])


def test_zero_weights_are_dropped():
    series = vr.Prony(instantaneous_modulus=1e6, weights=[0.0, 0.3, 0.0], relaxation_times=[1.0, 2.0, 3.0])
    assert series == vr.Prony(instantaneous_modulus=1e6, weights=[0.3], relaxation_times=[2.0])
    rigid = vr.Prony(instantaneous_modulus=1e6, weights=[0.0], relaxation_times=[1.0])
    assert rigid.weights == rigid.relaxation_times == ()


def test_a_relaxed_modulus_near_zero_is_rejected():
    for rest in (1e-6, 0.0):
        series = vr.Prony(instantaneous_modulus=1e7, weights=[1.0 - rest], relaxation_times=[0.1])
        layer = vr.Layer(thickness=1e-3, shear_modulus=series, poisson_ratio=0.5)
        ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
        for load in (0.01, 100.0):
            with pytest.raises(
                ValueError, match=r"shear_modulus.*relaxe|angular_speed must be >= 1e\+07 rad/s for a Prony"
            ):
                vr.solve(ball, load=load, angular_speed=1.0)


def test_errors_of_a_callable_reach_the_caller():
    def fails(omega):
        raise LookupError("no such material")

    ball = vr.CoatedSphere(core_radius=1.0, layers=[vr.Layer(thickness=0.1, shear_modulus=fails, poisson_ratio=0.5)])
    with pytest.raises(LookupError, match="no such material"):
        vr.solve(ball, load=1.0, angular_speed=1.0)


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (lambda w: 1e6 - 1j * w, "passive, such that the loss modulus is >= 0 Pa, got -1"),
        (lambda w: np.full(w.shape, np.nan), "at 0 rad/s must be finite"),
        (lambda w: np.full(w.shape, np.inf), "at 0 rad/s must be finite"),
        (lambda w: w, "at 0 rad/s must be such that the storage modulus is > 0 Pa, got 0"),
        (lambda w: np.ones(3), r"one value for each frequency, got shape \(3,\)"),
    ],
)
def test_a_callable_is_checked_at_the_harmonics(function, message):
    ball = vr.CoatedSphere(core_radius=1.0, layers=[vr.Layer(thickness=0.1, shear_modulus=function, poisson_ratio=0.5)])
    with pytest.raises(ValueError, match=message):
        vr.solve(ball, load=1.0, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=64, max_order=64))


@pytest.mark.parametrize(
    ("frequency", "error", "message"),
    [
        ("a", TypeError, "must contain real numbers, got <U1 entries"),
        ("1.0", TypeError, "must contain real numbers, got <U3 entries"),
        (1j, TypeError, "must contain real numbers, got complex128 entries"),
        (True, TypeError, "must contain real numbers, got bool entries"),
        (None, TypeError, "must be a real number, got NoneType None"),
        ([1.0, None], TypeError, r"\[1\] must be a real number, got NoneType None"),
        (10**400, ValueError, r"must be <= 1.8e\+308 in magnitude, got about 1e400"),
        ([1.0, 10**400], ValueError, r"\[1\] must be <= 1.8e\+308 in magnitude, got about 1e400"),
        ([[1.0], [1.0, 2.0]], ValueError, "must be an array, got rows of different lengths"),
    ],
)
def test_frequencies_must_be_real_numbers(rubber, frequency, error, message):
    with pytest.raises(error, match=f"^angular_frequency ?{message}$"):
        rubber.complex_modulus(frequency)


def test_a_callable_may_return_an_object_array_of_numbers(rubber):
    layer = vr.Layer(thickness=0.1, shear_modulus=lambda w: [mpmath.mpc(1e6, 1e3)] * len(w), poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=1.0, layers=[layer])
    elastic = vr.Layer(thickness=0.1, shear_modulus=lambda w: np.full(w.shape, 1e6 + 1e3j), poisson_ratio=0.5)
    expected = vr.modal.surface_compliance(vr.CoatedSphere(core_radius=1.0, layers=[elastic]), 1.0, 2, 2)
    np.testing.assert_array_equal(vr.modal.surface_compliance(ball, 1.0, 2, 2), expected)


@pytest.mark.parametrize(
    ("function", "error", "message"),
    [
        (lambda w: "stiff", TypeError, "returns numbers, got <U5 entries"),
        (lambda w: ["1e6"] * len(w), TypeError, "returns numbers, got <U3 entries"),
        (lambda w: w >= 0.0, TypeError, "returns numbers, got bool entries"),
        (lambda w: None, TypeError, "returns numbers, got object entries"),
        (lambda w: [[1.0], [1.0, 2.0]], ValueError, "returns an array of numbers .*"),
        (lambda w: [10**400] * len(w), ValueError, "returns an array of numbers .*"),
    ],
)
def test_a_callable_that_returns_no_numbers(function, error, message):
    layer = vr.Layer(thickness=0.1, shear_modulus=function, poisson_ratio=0.5)
    ball = vr.CoatedSphere(core_radius=1.0, layers=[layer])
    with pytest.raises(error, match=f"^shear_modulus must be a function that {message}$"):
        vr.solve(ball, load=1.0, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=64, max_order=64))
