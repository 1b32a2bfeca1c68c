"""Transient rolling: exact checks, and comparison with the independent program tests/reference/transient.py.

On the same mesh and with the same steps, the library and the program give the same history. The limits of fine meshes
and their error bars are results of the program, extrapolated from single meshes at π/150, π/250 and π/400 with the
paper's curvature (docs/theory/transient.md).
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import viscoroll as vr
from reference import transient as reference
from shared_cases import coated_ball
from viscoroll import enums, paper

MILLI_PER_UNIT = 1e3
BALL = paper.ball(density=0.0)
FINE = {"mesh": vr.Mesh(nodes_per_revolution=500), "curvature": enums.Curvature.PAPER}
COARSE = vr.Mesh(nodes_per_revolution=100)


def roll_at_speed(omega: float, turn: float, **options: object) -> vr.History:
    return vr.roll(options.pop("ball", BALL), time=[0.0, turn / omega], angle=[0.0, turn], load=100.0, **options)


# --- exact, on any mesh ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("compliance", list(enums.Compliance))
def test_standing_follows_lee_and_radok(compliance):
    """While the contact grows, the penetration is that of an elastic ball of modulus G₀ under the load G₀ ∫J dP."""
    h = vr.roll(
        BALL, time=[0, 0.3, 0.6], angle=[0, 0, 0], load=[100, 100, 130], start=enums.Start.UNDEFORMED, mesh=COARSE,
        compliance=compliance, averaged_meshes=2,
    )  # fmt: skip
    retardation = 0.25  # τ G₀/G_∞

    def creep(t: float) -> float:  # G₀ ∫ J dP, with G₀ J = 2 - e^(-t/λ)
        rising = max(t - 0.3, 0.0)
        ramp = 2 * rising - retardation * (1 - np.exp(-rising / retardation))
        return 100.0 * (2 - np.exp(-t / retardation)) + 100.0 * ramp

    elastic = coated_ball(vr.Elastic(modulus=6e6))
    for i in (0, len(h.time) // 3, -1):
        expected = vr.RollingHistory(
            elastic, load=creep(h.time[i]), mesh=COARSE, compliance=compliance, averaged_meshes=2
        )
        assert h.penetration[i] == pytest.approx(expected.current.penetration, rel=1e-9)  # tolerance of the solver
    # Nodes at whole and half multiples of the spacing are symmetric about the center.
    assert np.abs(h.resisting_torque).max() < 1e-10


def steady_torque_of_one_node_steps(nodes: int, omega: float) -> float:
    """Return the steady torque of rolling in steps of one node, from the steady compliance C(j) = Σ w_k K(j - k)."""
    elastic = coated_ball(vr.Elastic(modulus=3e6))
    half = 14
    table = vr.modal.influence_tables(
        elastic, angular_speed=1.0, mesh=vr.Mesh(nodes_per_revolution=nodes), reach=(nodes // 2, 2 * half)
    )[0, 0]
    ring = np.concatenate([table[nodes // 2 :], table[1 : nodes // 2]])  # offsets 0 … nodes-1
    z = 2 * np.pi / nodes / omega / 0.25
    r = (1 - np.exp(-z)) / z
    weights = np.exp(-(np.arange(1, nodes + 1) - 1) * z) * (np.exp(-z) * (1 - r) + r - np.exp(-z))
    weights *= 0.5 / (1 - np.exp(-nodes * z))
    kernel = (0.5 + 0.5 * (1 - r)) * ring
    for k, w in enumerate(weights, start=1):
        kernel = kernel + w * np.roll(ring, k, axis=0)

    spacing = 2 * np.pi / nodes
    i, k = (a.ravel() for a in np.meshgrid(np.arange(-half, half + 1), np.arange(-half, half + 1), indexing="ij"))
    matrix = kernel[(i[:, None] - i) % nodes, k[:, None] - k + 2 * half]
    radius = 21e-3
    x = radius * np.cos(k * spacing) * np.sin(-i * spacing)
    drop = radius * (1 - np.cos(k * spacing) * np.cos(i * spacing))
    in_contact = drop < 1e-4
    for _ in range(100):
        contact = np.flatnonzero(in_contact)
        system = np.block([[matrix[np.ix_(contact, contact)], -np.ones((len(contact), 1))],
                           [np.ones((1, len(contact))), np.zeros((1, 1))]])  # fmt: skip
        *force, depth = np.linalg.solve(system, [*-drop[contact], 100.0])
        p = np.zeros(len(x))
        p[contact] = force
        gap = matrix @ p + drop - depth
        new = np.where(in_contact, p > 0, gap < 0)
        if (new == in_contact).all():
            return float(x @ p)
        in_contact = new
    raise AssertionError("the set of contact nodes does not converge")


def test_steps_of_one_node_end_in_the_steady_torque():
    nodes, omega = 100, 2.5
    steps = np.arange(3 * nodes + 1)
    h = vr.roll(
        BALL, time=steps * 2 * np.pi / nodes / omega, angle=steps * 2 * np.pi / nodes, load=100.0, mesh=COARSE,
        averaged_meshes=1, steps_per_spacing=None,
    )  # fmt: skip
    # After three turns, the effect of the start has decayed to 1e-13; the contact is solved to 1e-11.
    assert h.resisting_torque[-1] == pytest.approx(steady_torque_of_one_node_steps(nodes, omega), rel=1e-8)


def test_splitting_a_prony_term_changes_nothing():
    one = vr.Prony(instantaneous_modulus=6e6, weights=[0.5], relaxation_times=[0.125])
    two = vr.Prony(instantaneous_modulus=6e6, weights=[0.2, 0.3], relaxation_times=[0.125, 0.125 * (1 + 1e-9)])
    a, b = (
        roll_at_speed(2.5, 0.2, ball=coated_ball(m), mesh=COARSE, averaged_meshes=1, start=enums.Start.UNDEFORMED)
        for m in (one, two)
    )
    np.testing.assert_allclose(a.resisting_torque, b.resisting_torque, rtol=0, atol=1e-9 * a.resisting_torque.max())
    np.testing.assert_allclose(a.dissipated_energy, b.dissipated_energy, rtol=1e-7, atol=0)


def test_mirrored_motion_has_mirrored_torque():
    t, psi = [0, 0.1, 0.2, 0.25], np.array([0, 0.2, 0.2, 0.1])
    a, b = (vr.roll(BALL, time=t, angle=s * psi, load=100.0, mesh=COARSE, averaged_meshes=1) for s in (1.0, -1.0))
    np.testing.assert_allclose(a.resisting_torque, -b.resisting_torque, rtol=0, atol=1e-10)
    np.testing.assert_allclose(a.penetration, b.penetration, rtol=1e-9)


def test_start_at_another_node_changes_nothing():
    spacing = COARSE.spacing
    a, b = (
        vr.roll(BALL, time=[0, 0.1], angle=[s * spacing, s * spacing + 0.2], load=100.0, mesh=COARSE, averaged_meshes=1)
        for s in (0, 1000007)
    )
    # At a million spacings, round-off leaves ten digits of a spacing.
    np.testing.assert_allclose(a.resisting_torque, b.resisting_torque, rtol=0, atol=1e-9)


def test_elastic_torque_has_mean_zero():
    """T is the derivative of a periodic energy: zero at whole and half multiples of the spacing, and on average."""
    ball = coated_ball(vr.Elastic(modulus=3e6))
    spacing = COARSE.spacing
    torque = []
    for place in np.arange(32) / 32:
        stepper = vr.RollingHistory(ball, load=100.0, mesh=COARSE, averaged_meshes=1, angle=place * spacing)
        torque.append(stepper.current.resisting_torque)
    size = np.sqrt(np.mean(np.square(torque)))
    assert size * MILLI_PER_UNIT > 0.1  # the discrete nodes have an effect
    assert abs(torque[0]) < 1e-8 * size
    assert abs(torque[16]) < 1e-8 * size
    # Nodes enter and leave the contact, so the harmonics of the torque decay slowly: 32 samples alias some of them.
    assert abs(np.mean(torque)) < 1e-2 * size


def test_units_scale_out():
    """If modulus G, length L and time are scaled, and the load with G L², the torque scales with G L³."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=60e6, relaxed_modulus=30e6, relaxation_time=1.25)
    big = coated_ball(rubber, core_radius=40e-3, thickness=2e-3)
    a = vr.roll(BALL, time=[0, 0.1, 0.2], angle=[0, 0.2, 0.2], load=100.0, mesh=COARSE)
    b = vr.roll(big, time=[0, 1.0, 2.0], angle=[0, 0.2, 0.2], load=100.0 * 40, mesh=COARSE)
    np.testing.assert_allclose(80 * a.resisting_torque, b.resisting_torque, rtol=1e-7, atol=1e-9)
    np.testing.assert_allclose(80 * a.dissipated_energy, b.dissipated_energy, rtol=1e-7)


# --- the reference program -------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def ring():
    return reference.Ring(nodes=120, half=6)


@pytest.mark.parametrize("start", list(enums.Start))
def test_agrees_with_the_reference_program(ring, start):
    """The ball starts, stops, reverses, and rolls on under a load that jumps and rises."""
    step = 2.0 * np.pi / 120 / 4
    angle = step * np.concatenate([np.arange(33), np.full(6, 32), np.arange(31, 19, -1), [20], np.arange(21, 29)])
    seconds = np.concatenate(
        [np.full(32, step / 2.5), np.full(6, 0.05), np.full(12, step / 0.8), [0.0], np.full(8, step)]
    )
    time = np.concatenate([[0.0], np.cumsum(seconds)])
    load = np.where(np.arange(time.size) < 51, 100.0, 89.0 + np.arange(time.size))
    h = vr.roll(
        BALL, time=time, angle=angle, load=load, start=start, mesh=vr.Mesh(nodes_per_revolution=120), averaged_meshes=1,
        steps_per_spacing=None, curvature=enums.Curvature.PAPER,
    )  # fmt: skip
    torque, depth = reference.roll(time, angle, load, relaxed=start is enums.Start.RELAXED, ring=ring)
    # The sums of the program are truncated at 8e-7 of the largest torque.
    np.testing.assert_allclose(h.resisting_torque, torque, rtol=0, atol=2e-6 * np.abs(torque).max())
    np.testing.assert_allclose(h.penetration, depth, rtol=1e-6)


# --- limits of fine meshes ------------------------------------------------------------------------------------------

#: (start, Ω [rad/s]): torques at ψ = 0.05, 0.1, 0.2, 0.3 and their maximum [mN m], with error bars.
STARTS = {
    (enums.Start.UNDEFORMED, 2.5): ([3.00, 7.97, 12.15, 11.67, 12.16], [0.02, 0.02, 0.02, 0.02, 0.03]),
    (enums.Start.RELAXED, 2.5): ([50.5, 47.04, 15.05, 9.28, 52.57], [0.1, 0.05, 0.03, 0.03, 0.1]),
    (enums.Start.UNDEFORMED, 0.5): ([11.57, 24.27, 31.41, 31.84, 31.84], [0.03, 0.03, 0.03, 0.03, 0.03]),
    (enums.Start.RELAXED, 0.5): ([42.0, 41.33, 33.25, 31.87, 43.38], [0.1, 0.04, 0.03, 0.03, 0.1]),
}


@pytest.mark.parametrize(("start", "omega"), STARTS)
def test_starts(start, omega):
    values, bars = STARTS[start, omega]
    h = roll_at_speed(omega, 0.5, start=start, **FINE)
    torque = h.resisting_torque * MILLI_PER_UNIT
    found = [*np.interp([0.05, 0.1, 0.2, 0.3], h.angle, torque), torque.max()]
    assert (np.abs(np.subtract(found, values)) <= bars).all(), found
    if (start, omega) == (enums.Start.RELAXED, 2.5):
        assert torque[h.angle > 0.2].min() == pytest.approx(8.26, abs=0.05)


def test_change_of_speed():
    t, psi = [0, 1.0, 1.6], [0, 2.5, 2.8]
    h = vr.roll(BALL, time=t, angle=psi, load=100.0, start=enums.Start.UNDEFORMED, **FINE)
    for rolled_angle, value in {0.05: 16.92, 0.1: 25.76, 0.2: 31.41, 0.3: 31.81}.items():
        assert np.interp(2.5 + rolled_angle, h.angle, h.resisting_torque) * MILLI_PER_UNIT == pytest.approx(
            value, abs=0.03
        )


@pytest.mark.parametrize(("stand", "torque", "bar"), [(0.1, 28.33, 0.05), (1.0, 52.1, 0.1), (10.0, 52.57, 0.1)])
def test_break_away_after_standing(stand, torque, bar):
    t = np.cumsum([0, 0.8, stand, 0.1])
    h = vr.roll(BALL, time=t, angle=[0, 2.0, 2.0, 2.25], load=100.0, start=enums.Start.UNDEFORMED, **FINE)
    assert h.resisting_torque[h.time > t[2]].max() * MILLI_PER_UNIT == pytest.approx(torque, abs=bar)
    if stand == 0.1:
        at = np.searchsorted(h.time, t[2])
        assert h.resisting_torque[at] * MILLI_PER_UNIT == pytest.approx(6.40, abs=0.02)
        assert h.penetration[at] * MILLI_PER_UNIT == pytest.approx(0.1620, abs=2e-5)


def test_energy_dissipated_in_an_oscillation():
    time = np.linspace(0.0, 4.0, 4 * 160 + 1)
    h = vr.roll(BALL, time=time, angle=np.radians(5.0) * np.sin(2 * np.pi * time), load=100.0, **FINE)
    dissipated = np.interp([3.0, 4.0], h.time, h.dissipated_energy)
    assert np.diff(dissipated)[0] * MILLI_PER_UNIT == pytest.approx(9.46, abs=0.03)


def test_vertical_compliance():
    h = roll_at_speed(2.5, 0.35, compliance=enums.Compliance.VERTICAL, start=enums.Start.UNDEFORMED, **FINE)
    assert h.resisting_torque.max() * MILLI_PER_UNIT == pytest.approx(12.34, abs=0.03)
    assert h.driving_torque.max() * MILLI_PER_UNIT == pytest.approx(14.36, abs=0.03)


PENETRATIONS = {
    enums.Compliance.RADIAL: [0.14113, 0.15085, 0.15812, 0.17148, 0.18071, 0.18575],
    enums.Compliance.VERTICAL: [0.15627, 0.16840, 0.17761, 0.19480, 0.20690, 0.21358],
}


@pytest.mark.parametrize(
    "compliance",
    [enums.Compliance.RADIAL, pytest.param(enums.Compliance.VERTICAL, marks=pytest.mark.slow)],
)
def test_penetration_at_standstill(compliance):
    """The penetration by Lee and Radok is exact for steps of any length, so one step per instant is enough."""
    times = [0.0, 0.05, 0.1, 0.25, 0.5, 50.0]
    h = vr.roll(
        BALL, time=times, angle=np.zeros(6), load=100.0, start="undeformed", mesh=vr.Mesh(nodes_per_revolution=1600),
        compliance=compliance, curvature=enums.Curvature.PAPER, averaged_meshes=1, steps_per_spacing=None,
    )  # fmt: skip
    # Limits of fine meshes [mm]. The error decreases with the square of the spacing: 4e-5 mm at π/400, 1e-5 mm here.
    np.testing.assert_allclose(h.penetration * MILLI_PER_UNIT, PENETRATIONS[compliance], rtol=0, atol=2e-5)


# --- the steady solver ----------------------------------------------------------------------------------------------

ZENER = vr.materials.FractionalZener(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=0.5)


@cache
def steady_torque(ball: vr.CoatedSphere, omega: float) -> float:
    return vr.solve(ball, load=100.0, angular_speed=omega, mesh=vr.Mesh(nodes_per_revolution=3200)).resisting_torque


@pytest.mark.parametrize(
    ("nodes", "bound", "omega"),
    [(300, 0.005, omega) for omega in (0.5, 1.0, 2.0, 2.5, 4.0)]
    + [(500, 0.0015, omega) for omega in (0.5, 1.0, 2.0, 2.5)],
)
def test_constant_speed_ends_in_the_steady_torque(omega, nodes, bound):
    steady = steady_torque(BALL, omega)
    turn = 0.8 if omega < 3.0 else 8.0  # at 4 rad/s, the effect of the last turn, e^(-2π/(Ωλ)), is 0.2 %
    h = roll_at_speed(omega, turn, start=enums.Start.UNDEFORMED, mesh=vr.Mesh(nodes_per_revolution=nodes))
    last = h.angle > h.angle[-1] - h.mesh.spacing
    assert h.resisting_torque[last].mean() == pytest.approx(steady, rel=bound)


def test_a_fitted_spectrum_gives_the_history_of_the_known_one():
    """The spectrum of the fractional Zener solid is known; that of the equal Havriliak-Negami solid is fitted."""
    fitted = vr.materials.HavriliakNegami(
        instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125, order=0.5, asymmetry=1.0
    )
    time = np.linspace(0.0, 0.4, 9)
    histories = [
        vr.roll(coated_ball(modulus), time=time, angle=2.5 * time, load=50.0, mesh=vr.Mesh(nodes_per_revolution=200))
        for modulus in (ZENER, fitted)
    ]
    known, found = (h.resisting_torque for h in histories)
    np.testing.assert_allclose(found, known, rtol=0, atol=1e-3 * known.max())


@pytest.mark.parametrize(
    ("nodes", "bound", "omega"),
    [(300, 0.005, 0.5), (300, 0.005, 2.5), (300, 0.005, 4.0), (500, 0.0015, 0.5), (500, 0.0015, 2.5)],
)
def test_fractional_zener_ends_in_the_steady_torque(omega, nodes, bound):
    """Memory decays slowly: at 4 rad/s, the effect of the start is 0.15 % after 1 s and 0.05 % after the 2 s here."""
    ball = coated_ball(ZENER)
    steady = steady_torque(ball, omega)
    h = roll_at_speed(
        omega, 2.0 * omega, ball=ball, start=enums.Start.UNDEFORMED, mesh=vr.Mesh(nodes_per_revolution=nodes)
    )
    last = h.angle > h.angle[-1] - h.mesh.spacing
    assert h.resisting_torque[last].mean() == pytest.approx(steady, rel=bound)


def test_kelvin_voigt_ends_in_the_steady_torque():
    ball = coated_ball(vr.materials.KelvinVoigt(modulus=3e6, viscosity=1.5e5))
    steady = vr.solve(ball, load=100.0, angular_speed=1.0, accuracy=2e-3).resisting_torque
    h = roll_at_speed(1.0, 2.0, ball=ball, mesh=vr.Mesh(nodes_per_revolution=300))
    assert h.resisting_torque[-1] == pytest.approx(steady, rel=0.01)


def test_fit_of_a_table_reports_its_error():
    omega = np.geomspace(1e-4, 1e6, 201)
    values = ZENER.complex_modulus(omega)
    curve = vr.MasterCurve([0.0, *omega], [3e6, *values.real], [0.0, *values.imag], enums.Extrapolation.HOLD)
    a, b = (
        roll_at_speed(2.5, 0.3, ball=coated_ball(m), mesh=COARSE, start=enums.Start.UNDEFORMED) for m in (ZENER, curve)
    )
    assert 0.0 < b.spectrum_error < 2e-3
    np.testing.assert_allclose(b.resisting_torque, a.resisting_torque, rtol=0, atol=5e-3 * a.resisting_torque.max())
    with pytest.raises(ValueError, match="spectrum_tolerance = 1e-05"):
        roll_at_speed(2.5, 0.3, ball=coated_ball(curve), mesh=COARSE, spectrum_tolerance=1e-5)


# --- energy ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("varying", [False, True])
def test_energy_balance(varying):
    waypoints = np.array([0.0, 0.4, 1.0, 1.4, 1.8])
    angles = np.array([0.0, 1.0, 1.0, 2.0, 1.0])
    time = np.unique(np.concatenate([waypoints, np.linspace(0, 1.8, 181)]))
    load = 100.0 * (1 + 0.3 * varying * np.sin(10 * np.pi * time))
    h = vr.roll(
        BALL, time=time, angle=np.interp(time, waypoints, angles), load=load, start=enums.Start.UNDEFORMED,
        mesh=vr.Mesh(nodes_per_revolution=300),
    )  # fmt: skip
    assert h.energy_balance_error[-1] < 1e-3
    assert (np.diff(h.dissipated_energy) > -1e-15).all()


def test_work_of_a_load_jump_is_stored():
    h = vr.roll(
        BALL, time=[0, 0.1, 0.1, 0.2], angle=[0, 0.2, 0.2, 0.4], load=[100, 100, 150, 150], mesh=COARSE,
    )  # fmt: skip
    at = np.flatnonzero(np.diff(h.time) == 0.0)
    assert len(at) == 1
    jump = slice(at[0], at[0] + 2)
    assert np.diff(h.dissipated_energy[jump]) == 0.0
    assert np.diff(h.work[jump]) == pytest.approx(np.diff(h.stored_energy[jump]))
    assert np.diff(h.penetration[jump]) > 0.0


def test_a_flat_spot_returns_each_turn():
    """λ = 10 s: one peak per turn, which decays by e^(-2π/(Ωλ)) each turn."""
    slow = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=5.0)
    omega = 2.5
    h = roll_at_speed(omega, 8 * np.pi, ball=coated_ball(slow), mesh=COARSE)
    turn = (h.angle / (2 * np.pi) + 0.5).astype(int)
    peaks = np.array([h.resisting_torque[turn == k].max() for k in range(4)]) * MILLI_PER_UNIT
    np.testing.assert_allclose(peaks, [53.8, 41.8, 32.6, 25.3], rtol=0.03)  # values at π/150; the mesh here has π/50
    np.testing.assert_allclose(peaks[1:] / peaks[:-1], np.exp(-2 * np.pi / (omega * 10.0)), rtol=0.02)


def test_a_rising_load_widens_the_tables():
    h = vr.roll(BALL, time=[0, 1.0], angle=[0, 0.5], load=[5.0, 400.0], mesh=vr.Mesh(nodes_per_revolution=200))
    applied_at_once = vr.RollingHistory(BALL, load=400.0, mesh=vr.Mesh(nodes_per_revolution=200))
    assert 0.7 < h.penetration[-1] / applied_at_once.current.penetration < 1.0
    assert h.energy_balance_error[-1] < 2e-2


def test_progress_counts_instants():
    """The steps of a single mesh are counted as well."""
    seen = []
    vr.roll(
        BALL, time=[0.0, 1.0], angle=[0.0, 2.0], load=100.0, mesh=vr.Mesh(nodes_per_revolution=500), averaged_meshes=1,
        progress=lambda stage, fraction: seen.append(fraction) if stage == "rolling" else None,
    )  # fmt: skip
    rolled = [fraction for fraction in seen if fraction not in (0.0, 1.0)]  # the first contact is also a stage
    assert len(set(rolled)) > 5
    assert (np.diff(rolled) >= 0.0).all()
