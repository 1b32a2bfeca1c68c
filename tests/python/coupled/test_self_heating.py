"""Self-heating: steady states in which the moduli, the heat and the temperature are consistent."""

from __future__ import annotations

import math
import warnings
from dataclasses import replace

import numpy as np
import pytest
import viscoroll as vr
from reference.self_heating import steady_rises, torque_curve
from scipy.optimize import brentq
from shared_cases import RUBBER, coated_ball, one_layer
from viscoroll import enums, paper
from viscoroll.materials.shift import shift_factor, shifted
from viscoroll.solution.loss import default_max_order

AMBIENT = 293.15
COOLING = {"conductivity": 0.2, "convection": 10.0, "ambient": AMBIENT}
UNIFORM = COOLING | {"conductivity": 1e3}  # uniform temperature, as in the independent computation
MESH = vr.Mesh(nodes_per_revolution=240)


def exponential_shift(temperature):
    """Return the shift factor a_T = e^(-0.1 (T - ambient))."""
    return math.exp(-0.1 * (temperature - AMBIENT))


def heated(angular_speed, **options):
    ball = paper.ball(thickness=5e-3, density=0.0)
    arguments = {"shift": exponential_shift, "limit": AMBIENT + 120.0, "mesh": MESH, "load": 100.0} | COOLING | options
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        return vr.self_heating(ball, angular_speed=angular_speed, **arguments)


@pytest.fixture(scope="module")
def curve():
    """Return the torque as a function of speed on the same mesh, for the reference program."""
    return torque_curve(1e-4, 100.0, nodes=240)


def rises(curve, angular_speed):
    """Return the rises of a coating of uniform temperature, and whether they are stable."""
    return steady_rises(curve, angular_speed, convection=10.0, shift_rate=0.1, limit=120.0)


@pytest.mark.parametrize("angular_speed", [2.5, 25.0])
def test_one_state(curve, angular_speed):
    """The reference program gives temperature rises of 1.19 and 1.53 K, to 1 %."""
    (state,) = heated(angular_speed, limit=AMBIENT + 30.0, points=8, **UNIFORM).states
    assert state.stable
    assert rises(curve, angular_speed) == [(pytest.approx(state.mean_temperature - AMBIENT, rel=0.01), True)]
    # ΔT = P / (4π r_o² h_c)
    balance = state.result.bulk_power / (4.0 * math.pi * 25e-3**2 * 10.0)
    assert state.mean_temperature - AMBIENT == pytest.approx(balance, rel=1e-3)


def test_three_states(curve):
    """The reference program gives rises of 1.54, 33.5 and 61.1 K at 100 rad/s, to 1 %; the middle state is unstable."""
    hot = heated(100.0, **UNIFORM)
    found = [(pytest.approx(state.mean_temperature - AMBIENT, rel=0.01), state.stable) for state in hot.states]
    assert rises(curve, 100.0) == found
    assert [state.stable for state in hot.states] == [True, False, True]
    for state in hot.states:
        # In a steady state, a solve with the shifted moduli gives the same temperature.
        ball = coated_ball(shifted(RUBBER, exponential_shift(state.mean_temperature)), thickness=5e-3)
        again = vr.solve(ball, load=100.0, angular_speed=100.0, mesh=MESH)
        found = again.temperature(**UNIFORM)
        assert found.mean == pytest.approx(state.mean_temperature - AMBIENT, rel=2e-3)


def test_speeds_without_a_state_are_rejected_with_the_largest_speed():
    """The temperature limit lies below the hot branch, and heating moves the moduli to their loss peak."""
    coarse = vr.Mesh(nodes_per_revolution=120)
    fast = {"load": 400.0, "convection": 3.0, "limit": AMBIENT + 60.0, "points": 8, "mesh": coarse}
    with pytest.raises(ValueError, match=r"angular_speed must be at most about .* rad/s for a steady temperature") as e:
        heated(400.0, **fast)
    largest = float(str(e.value).split("about ")[1].split(" rad/s")[0])
    assert 0.0 < largest < 400.0
    assert heated(0.9 * largest, **fast).states


def test_solving_at_the_speed_of_a_temperature_gives_this_temperature():
    hot = heated(25.0, limit=AMBIENT + 30.0, points=8, **UNIFORM)
    (state,) = hot.states
    assert hot.speeds([state.mean_temperature])[0] == pytest.approx(25.0, rel=0.02)


def test_without_a_shift_the_temperature_is_that_of_a_single_solve():
    ball = paper.ball(density=0.0)
    hot = vr.self_heating(
        ball, load=100.0, angular_speed=25.0, shift=lambda temperature: 1.0, mesh=MESH, points=4, **COOLING
    )
    plain = vr.solve(ball, load=100.0, angular_speed=25.0, mesh=MESH).temperature(**COOLING)
    assert hot.states[0].mean_temperature - AMBIENT == pytest.approx(plain.mean, rel=2e-3)


def test_sublayers_have_temperatures_of_their_own():
    """The outer half is warmer, and a solve with the moduli of both temperatures gives these temperatures."""
    given = {"load": 100.0, "angular_speed": 25.0, "mesh": vr.Mesh(nodes_per_revolution=160)}
    cooling = COOLING | {"core": enums.Core.ISOTHERMAL}
    ball = coated_ball(thickness=5e-3)
    hot = vr.self_heating(
        ball, shift=exponential_shift, points=4, limit=AMBIENT + 20.0, sublayers=2, **given, **cooling
    )
    inner, outer = hot.states[0].layer_temperatures
    assert AMBIENT < inner < outer
    halves = [one_layer(shifted(RUBBER, exponential_shift(there)), thickness=2.5e-3) for there in (inner, outer)]
    found = vr.solve(vr.CoatedSphere(core_radius=20e-3, layers=halves), **given).temperature(**cooling)
    np.testing.assert_allclose(found.layer_means, [inner - AMBIENT, outer - AMBIENT], rtol=5e-3)


@pytest.fixture(scope="module")
def roller():
    """Return a roller of 50 + 10 mm at 30 rad/s under 8 kN/m; its moduli shift by the WLF law of rubber."""
    shift = vr.materials.WilliamsLandelFerry(c1=8.86, c2=101.6, reference_temperature=AMBIENT)
    body = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(RUBBER, thickness=10e-3)])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        return vr.self_heating(
            body,
            load=8e3,
            angular_speed=30.0,
            conductivity=0.25,
            convection=15.0,
            ambient=AMBIENT,
            shift=shift,
            limit=AMBIENT + 80.0,
            mesh=vr.Mesh(nodes_per_revolution=4000),
        )


def test_a_roller_has_three_states_and_a_fold_in_load(roller):
    """Compare with a NumPy program: rises [K], torques [N], and the load where cold and middle state merge."""
    rises = [state.mean_temperature - AMBIENT for state in roller.states]
    assert rises == pytest.approx([1.9248, 13.1285, 36.432], rel=1e-3)
    torques = [state.result.resisting_torque for state in roller.states]
    assert torques == pytest.approx([0.30124, 2.05736, 5.8206], rel=1e-3)
    assert [state.stable for state in roller.states] == [True, False, True]
    fold = roller.largest_load()
    assert fold.load == pytest.approx(10154.4, rel=1e-3)
    assert fold.mean_temperature - AMBIENT == pytest.approx(5.582, rel=0.02)  # the maximum is flat
    assert 0.0 < fold.strain < 0.1
    # At this load, a cold state exists at any speed, because the maximum of ΔT a_T exceeds the plateau of the torque.
    assert roller.largest_speed() is None
    assert len(roller.plot(points=3).axes) == 2
    assert roller.loads([AMBIENT + 5.0, AMBIENT + 30.0])[1] < roller.loads([AMBIENT + 5.0])[0]


def test_a_vertical_shift_scales_load_and_torque():
    """With a vertical shift b, T(F; b) = b T(F/b; 1), to round-off on the same mesh."""
    half = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(RUBBER, thickness=10e-3)])
    given = {"conductivity": 1e3, "convection": 15.0, "ambient": AMBIENT, "mesh": vr.Mesh(nodes_per_revolution=2000)}
    hot = vr.self_heating(
        half,
        load=4e3,
        angular_speed=5.0,
        shift=lambda t: 1.0,
        vertical_shift=lambda t: 0.5,
        points=4,
        limit=AMBIENT + 9.0,
        **given,
    )
    plain = vr.solve(half, load=8e3, angular_speed=5.0, mesh=given["mesh"])
    assert hot.states[0].result.resisting_torque == pytest.approx(0.5 * plain.resisting_torque, rel=1e-9)


#: A crowned wheel with a hub of 50 mm and a tread of 10 mm, 50 mm wide.
WHEEL = vr.CoatedWheel(core_radius=50e-3, layers=[one_layer(thickness=10e-3)], width=50e-3, crown_radius=0.2)
EVEN = {"conductivity": 1e3, "convection": 15.0, "ambient": AMBIENT}  # uniform temperature


def test_state_of_a_wheel_is_consistent():
    """A solve with the shifted moduli gives the same temperature, and the load of this temperature is the given one."""
    # Without free faces, each contact takes a third of the time. A slow test, that of filled rubber, has free faces.
    wheel = replace(WHEEL, sides=enums.Sides.UNBOUNDED)
    given = COOLING | {"side_convection": 8.0, "hub_conductance": 0.1}
    mesh = vr.Mesh(nodes_per_revolution=80)
    hot = vr.self_heating(
        wheel,
        load=150.0,
        angular_speed=20.0,
        shift=exponential_shift,
        limit=AMBIENT + 20.0,
        points=4,
        mesh=mesh,
        **given,
    )
    state = hot.states[0]
    assert state.stable
    heated = replace(
        wheel, layers=[one_layer(shifted(RUBBER, exponential_shift(state.mean_temperature)), thickness=10e-3)]
    )
    again = vr.solve(heated, load=150.0, angular_speed=20.0, mesh=mesh).temperature(**given)
    assert again.mean == pytest.approx(state.mean_temperature - AMBIENT, rel=2e-3)
    assert hot.loads([state.mean_temperature])[0] == pytest.approx(150.0, rel=2e-3)
    assert "mN m" in repr(state)  # a wheel's torque is not per length
    with pytest.raises(ValueError, match="width must be left out with a wheel"):
        vr.self_heating(wheel, load=150.0, angular_speed=20.0, shift=exponential_shift, width=0.05, mesh=mesh, **given)


@pytest.mark.slow
def test_loads_of_a_softening_wheel_have_a_maximum():
    """By T(F; b) = b T(F/b; 1), contacts with one modulus give all states, also beyond the largest load."""
    # Without free faces, each contact takes half the time.
    body = replace(WHEEL, core_radius=20e-3, width=30e-3, crown_radius=0.1, sides=enums.Sides.UNBOUNDED)
    mesh, speed = vr.Mesh(nodes_per_revolution=60), 15.0

    def softening(temperature):
        return 1.0 / (1.0 + math.exp((temperature - AMBIENT - 4.0) / 0.8))

    film = 15.0 * 2.0 * math.pi * body.outer_radius * body.width  # [W/K]
    temperatures, loads = [], []
    for harder in (150.0, 400.0, 800.0):
        power = vr.solve(body, load=harder, angular_speed=speed, mesh=mesh).bulk_power
        rise = brentq(lambda rise, power=power: rise - softening(AMBIENT + rise) * power / film, 0.0, 30.0)
        temperatures.append(AMBIENT + rise)
        loads.append(harder * softening(AMBIENT + rise))
    assert loads[1] > max(loads[0], loads[2])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        hot = vr.self_heating(
            body,
            load=loads[0],
            angular_speed=speed,
            shift=lambda temperature: 1.0,
            vertical_shift=softening,
            limit=temperatures[1],
            points=4,
            mesh=mesh,
            **EVEN,
        )
    assert hot.states[0].mean_temperature == pytest.approx(temperatures[0], abs=0.02)
    # On this coarse mesh, the power increases in steps.
    np.testing.assert_allclose(hot.loads(temperatures), loads, rtol=0.01)


TREAD = vr.materials.SofteningModulus(
    matrix=RUBBER, network=vr.materials.MasingNetwork(storage=6e6, critical_strain=0.01)
)
FILLED = {
    "ball": (coated_ball(TREAD, core_radius=16e-3, thickness=5e-3), 40.0, 5.0, 240),
    "roller": (vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(TREAD, thickness=10e-3)]), 4e3, 25.0, 300),
    "wheel": (replace(WHEEL, layers=[one_layer(TREAD, thickness=10e-3)]), 150.0, 10.0, 80),
}


def filled(name, **options):
    """Return a body of filled rubber and its self-heating; the temperature shifts only the matrix."""
    body, load, speed, nodes = FILLED[name]
    given = {"load": load, "angular_speed": speed, "shift": exponential_shift, "limit": AMBIENT + 40.0, "points": 4}
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        return body, vr.self_heating(body, **COOLING | given | {"mesh": mesh} | options)


@pytest.mark.parametrize("name", ["ball", "roller", pytest.param("wheel", marks=pytest.mark.slow)])
def test_state_of_filled_rubber_is_consistent_in_strain_and_temperature(name):
    """Strain softening with the shifted moduli gives the same contact, and its heat gives the same temperature."""
    body, hot = filled(name)
    state = hot.states[0]
    warm = shifted(TREAD, exponential_shift(state.layer_temperatures[0]))
    rubber = replace(body, layers=[replace(body.layers[0], shear_modulus=warm)])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        found = vr.strain_softening(
            rubber, load=state.result.load, angular_speed=hot.angular_speed, mesh=state.result.mesh, tolerance=1e-5
        )
    assert state.softening.torque_bounds == pytest.approx(found.torque_bounds, rel=1e-3)
    assert state.softening.layer_amplitudes == pytest.approx(found.layer_amplitudes, rel=1e-3)
    assert state.result.resisting_torque == state.softening.torque_bounds[1]
    orders = default_max_order(found.result, 12.0)  # as in self_heating
    rise = found.result.temperature(**COOLING, max_order=orders).mean
    assert AMBIENT + rise == pytest.approx(state.mean_temperature, abs=2e-3 * rise)


def test_filled_rubber_by_harmonics():
    """The loss method "harmonic", which gives the larger loss, leads to the hotter state."""
    hot, harmonic = (filled("roller", softening=method)[1].states[0] for method in ("network", "harmonic"))
    assert harmonic.softening.loss == "harmonic"
    assert harmonic.result.resisting_torque == harmonic.softening.torque_bounds[0]
    sum_of_harmonics, matched = hot.softening.torque_bounds
    assert (harmonic.mean_temperature > hot.mean_temperature) == (sum_of_harmonics > matched)
    with pytest.raises(ValueError, match="softening must be 'network' or 'harmonic', got 'both'"):
        filled("roller", softening="both")


@pytest.mark.slow
def test_filled_rubber_has_a_largest_load():
    """If the matrix softens with temperature, the cold state ends at a largest load; hotter states need less."""
    melting = {"vertical_shift": lambda kelvin: 1.0 / (1.0 + math.exp((kelvin - AMBIENT - 10.0) / 2.0))}
    matrix = vr.StandardLinearSolid(instantaneous_modulus=12e6, relaxed_modulus=9e6, relaxation_time=0.01)
    network = vr.materials.MasingNetwork(storage=2e6, critical_strain=0.02)
    tread = vr.materials.SofteningModulus(matrix=matrix, network=network)
    body = vr.CoatedCylinder(core_radius=50e-3, layers=[one_layer(tread, thickness=10e-3)])
    mesh = vr.Mesh(nodes_per_revolution=150)
    given = COOLING | {"shift": lambda kelvin: 1.0, "limit": AMBIENT + 20.0, "points": 4, "mesh": mesh}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)
        hot = vr.self_heating(body, load=1e3, angular_speed=25.0, **given, **melting)
        fold = hot.largest_load()
        rise = fold.mean_temperature - AMBIENT
        loads = hot.loads([AMBIENT + 0.7 * rise, AMBIENT + 1.15 * rise])
    assert hot.states[0].mean_temperature < fold.mean_temperature
    assert loads.max() < fold.load


def test_shift_factors_in_self_heating():
    wlf = vr.materials.WilliamsLandelFerry(c1=17.44, c2=51.6, reference_temperature=200.0)
    assert wlf(200.0) == 1.0
    assert wlf(251.6) == pytest.approx(10.0**-8.72)
    with pytest.raises(ValueError, match=r"temperature must be > 148\.4 K"):
        wlf(148.0)
    arrhenius = vr.materials.Arrhenius(activation_energy=8.314462618e3, reference_temperature=300.0)
    assert math.log(arrhenius(500.0)) == pytest.approx(1e3 * (1 / 500 - 1 / 300))
    with pytest.raises(ValueError, match="c2 must be > 0 K"):
        vr.materials.WilliamsLandelFerry(c1=1.0, c2=0.0, reference_temperature=300.0)

    class Fitted:
        def __call__(self, celsius):
            return 0.0

        def shift(self):
            return wlf

    with pytest.raises(TypeError, match=r"use shift\(\) of a fitted law"):
        shift_factor(Fitted(), 300.0)
    with pytest.raises(TypeError, match="shift must be a function"):
        shift_factor(1.0, 300.0)
    with pytest.raises(ValueError, match="must be > 0"):
        shift_factor(lambda temperature: -1.0, 300.0)


@pytest.mark.parametrize(
    "modulus",
    [
        vr.Elastic(modulus=1e6),
        vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125),
        vr.Prony(instantaneous_modulus=6e6, weights=[0.2, 0.3], relaxation_times=[0.1, 2.0]),
        vr.materials.KelvinVoigt(modulus=1e6, viscosity=1e4),
        vr.materials.FractionalZener(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.1, order=0.5),
        vr.MasterCurve([0.0, 0.1, 1.0, 1e3], [1e6, 1e6, 2e6, 3e6], [0.0, 1e5, 2e5, 1e5]),
    ],
)
def test_shifted_moduli(modulus):
    omega = np.array([0.0, 1.0, 30.0])
    np.testing.assert_allclose(
        shifted(modulus, 0.25).complex_modulus(omega), modulus.complex_modulus(0.25 * omega), rtol=1e-12
    )


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"shift": 1.0}, TypeError, "shift must be a function"),
        (
            {"shift": [exponential_shift, exponential_shift]},
            ValueError,
            "shift must have one function for each of 1 layers, got 2",
        ),
        ({"points": 2}, ValueError, r"points must be in \[4, 1000\]"),
        ({"sublayers": 0}, ValueError, r"sublayers must be in \[1, 20\]"),
        ({"limit": 200.0}, ValueError, "limit must be > ambient"),
    ],
)
def test_bad_input_is_named(arguments, error, message):
    with pytest.raises(error, match=message):
        heated(2.5, **arguments)
