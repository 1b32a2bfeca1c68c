"""Closed forms with adhesion, compared with quadrature and root finding in mpmath, energies, and limits."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference.adhesion import Roller
from scipy import integrate, optimize
from viscoroll import analytic

RADIUS = 10e-3
SOLID = {"radius": RADIUS, "shear_modulus": 1e6, "poisson_ratio": 0.5}  # E* = 4 MPa
WORK = 10.0
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
ROLLER = {"radius": 50e-3, "shear_modulus": RUBBER, "poisson_ratio": 0.5}


def close(expected, *, rel):
    return pytest.approx(expected, rel=rel, abs=0.0)


def maugis_case(parameter):
    """Return the arguments of `maugis` for a Maugis parameter, and the units of radius, load and approach."""
    modulus = 4e6 * 4.0 / 3.0
    strength = 0.5 * parameter / np.cbrt(RADIUS / (np.pi * WORK * modulus**2))
    length = np.cbrt(np.pi * WORK * RADIUS**2 / modulus)
    return {**SOLID, "work": WORK, "strength": strength}, (length, np.pi * WORK * RADIUS, length**2 / RADIUS)


@pytest.mark.parametrize(
    ("parameter", "load", "radius", "ratio", "approach"),  # 30 digits in mpmath
    [
        (1.0, 0.0, 1.63609048961, 1.22590447374, 1.12989389147),
        (1.0, 1.0, 1.80929329275, 1.19942316551, 1.67586180908),
        (0.5, 0.0, 1.51738352649, 1.50466845545, 1.16513372917),
        (0.1, 0.0, 1.33617980844, 2.94210369715, 1.29242534548),
    ],
)
def test_maugis(parameter, load, radius, ratio, approach):
    case, (length, force, depth) = maugis_case(parameter)
    contact = analytic.maugis(load=load * force, **case)
    assert contact.half_width == close(radius * length, rel=1e-11)
    assert contact.zone == close((ratio - 1.0) * radius * length, rel=1e-10)
    assert contact.approach == close(approach * depth, rel=1e-10)


@pytest.mark.parametrize(("parameter", "pull_off"), [(2.0, -1.53460323807), (3.0, -1.51676390004)])
def test_pull_off_of_maugis(parameter, pull_off):
    case, (_, force, _) = maugis_case(parameter)
    assert analytic.maugis(load=0.0, **case).pull_off == close(pull_off * force, rel=1e-9)


def test_maugis_tends_to_jkr_and_to_dmt():
    case, (length, force, depth) = maugis_case(60.0)
    short = analytic.maugis(load=[-1.0 * force, 2.0 * force], **case)
    jkr = analytic.jkr(load=[-1.0 * force, 2.0 * force], work=WORK, **SOLID)
    assert short.half_width == close(jkr.half_width, rel=2e-3)
    assert short.approach == close(jkr.approach, rel=5e-3)
    case, (length, force, depth) = maugis_case(1e-5)
    long = analytic.maugis(load=force, **case)  # a³ = P + 2
    assert long.half_width == close(np.cbrt(3.0) * length, rel=1e-3)
    assert long.approach == close(np.cbrt(9.0) * depth, rel=3e-3)  # converges as the root of λ
    assert long.pull_off == close(-2.0 * force, rel=2e-3)


def test_jkr_load_follows_from_the_stress_intensity():
    loads = np.array([-0.45, 0.0, 3.0])
    contact = analytic.jkr(load=loads, work=WORK, **SOLID)
    a = contact.half_width
    assert 4.0 / 3.0 * 4e6 * a**3 / RADIUS - np.sqrt(8.0 * np.pi * WORK * 4e6 * a**3) == pytest.approx(loads, abs=1e-9)
    assert contact.pull_off == close(-1.5 * np.pi * WORK * RADIUS, rel=1e-14)
    assert np.all(contact.zone == 0.0)


def test_jkr_approach_is_the_slope_of_its_energy():
    # dU/dd = P along the path of equilibrium, with U the elastic energy minus the work of adhesion.
    loads = np.linspace(0.0, 1.0, 400)
    contact = analytic.jkr(load=loads, work=WORK, **SOLID)
    a, d = contact.half_width, contact.approach
    # Hertz to the radius a, then a flat punch to the load P.
    hertz = 4.0 / 3.0 * 4e6 * a**3 / RADIUS
    stiffness = 2.0 * 4e6 * a
    energy = 0.4 * hertz * a**2 / RADIUS + 0.5 * (loads**2 - hertz**2) / stiffness - np.pi * a**2 * WORK
    work = integrate.cumulative_simpson(loads, x=d, initial=0.0)
    assert energy - energy[0] == pytest.approx(work, abs=1e-6 * work[-1])


def test_jkr_line_is_stationary():
    contact = analytic.jkr_line(load=[-200.0, 0.0, 200.0], work=WORK, **SOLID)
    a = contact.half_width
    # The intensity of the tension at the edges, K = (P_Hertz(a) - P)/√(π a), releases w = K²/(2E*).
    hertz = np.pi * 4e6 * a**2 / (4.0 * RADIUS)
    assert (hertz - np.array([-200.0, 0.0, 200.0])) ** 2 / (np.pi * a) / (2.0 * 4e6) == close(WORK, rel=1e-12)
    assert contact.approach is None


def test_pull_off_of_a_line():
    # Units of docs/theory/adhesion.md: -0.27679 N/mm.
    pull_off = analytic.jkr_line(load=0.0, work=WORK, **SOLID).pull_off
    least = np.cbrt(2.0 * WORK * RADIUS**2 / (np.pi * 4e6))
    assert pull_off == close(-0.75 * np.sqrt(2.0 * np.pi * 4e6 * WORK * least), rel=1e-12)
    assert pull_off == close(-276.79, rel=2e-5)
    analytic.jkr_line(load=pull_off, work=WORK, **SOLID)
    with pytest.raises(ValueError, match=r"^load must be >= -276\.79.* N/m, the pull-off load, got -276\.8$"):
        analytic.jkr_line(load=-276.8, work=WORK, **SOLID)


def test_thin_adhesive_layer_minimizes_the_energy():
    layer = {"radius": RADIUS, "thickness": 0.1e-3, "shear_modulus": 1e6, "poisson_ratio": 0.3}
    confined = 2e6 * 0.7 / 0.4
    contact = analytic.thin_adhesive_layer_line(load=50.0, work=WORK, **layer)

    def energy(a, d):
        springs = integrate.quad(lambda x: 0.5 * confined / 0.1e-3 * (d - x**2 / (2.0 * RADIUS)) ** 2, -a, a)[0]
        return springs - 2.0 * a * WORK

    d, a = contact.approach, contact.half_width
    least = optimize.minimize_scalar(
        lambda ratio: energy(ratio * a, d), bounds=(0.5, 1.5), method="bounded", options={"xatol": 1e-9}
    )
    assert least.x == close(1.0, rel=1e-6)
    step = 1e-3 * a**2 / RADIUS
    force = (energy(a, d + step) - energy(a, d - step)) / (2.0 * step)  # the energy is stationary in a
    assert force == close(50.0, rel=1e-9)


def test_thin_adhesive_layer_pulls_off_at_zero_approach():
    layer = {"radius": RADIUS, "thickness": 0.1e-3, "shear_modulus": 1e6, "poisson_ratio": 0.3}
    pull_off = analytic.thin_adhesive_layer_line(load=0.0, work=WORK, **layer).pull_off
    contact = analytic.thin_adhesive_layer_line(load=pull_off, work=WORK, **layer)
    assert abs(contact.approach) < 1e-9 * contact.half_width
    springs = 2e6 * 0.7 / 0.4 / 0.1e-3
    assert pull_off == close(-springs * contact.half_width**3 / (3.0 * RADIUS), rel=1e-9)


def test_adhesive_hunter():
    # Moments and half-widths: 25 digits in mpmath, from the three equations without the closed sums.
    fast = analytic.adhesive_hunter(load=100.0, speed=0.5, work=1.0, **ROLLER)
    assert fast.half_width == close(0.00117568418076, rel=1e-11)
    assert fast.center == close(5.07394186688e-6, rel=1e-8)
    assert fast.moment == close(0.0012275607386, rel=1e-9)
    middle = analytic.adhesive_hunter(load=5000.0, speed=0.05, work=1.0, **ROLLER)
    assert middle.half_width == close(0.00407706313323, rel=1e-11)
    assert middle.center == close(0.000685887874983, rel=1e-9)
    assert middle.moment == close(4.29548658294, rel=1e-11)
    stiff = vr.StandardLinearSolid(instantaneous_modulus=15e6, relaxed_modulus=3e6, relaxation_time=0.0625)
    slow = analytic.adhesive_hunter(load=100.0, speed=0.05, work=1.0, **ROLLER | {"shear_modulus": stiff})
    assert slow.half_width == close(0.000843421914197, rel=1e-11)
    assert slow.moment == close(0.0191087892204, rel=1e-9)


def test_adhesive_hunter_of_many_cases():
    contact = analytic.adhesive_hunter(load=[[5000.0], [100.0]], speed=[0.5, 0.05, 0.005], work=1.0, **ROLLER)
    moments = [[1.037976, 4.295487, 2.637373], [0.001228, 0.009818, 0.064708]]
    assert contact.moment == pytest.approx(np.array(moments), abs=1e-6)


@pytest.mark.parametrize(("load", "speed", "half_width"), [(5000.0, 0.05, 4.1), (100.0, 0.005, 1.3)])
def test_adhesive_hunter_agrees_with_an_independent_program(load, speed, half_width):
    """Zones of 0.09 half-widths have the stress intensity of edges of vanishing range."""
    contact = analytic.adhesive_hunter(load=load, speed=speed, work=1.0, **ROLLER)
    roller = Roller.standard(125.0 * speed, modulus=12.0, radius=50.0, work=1e-3)
    nodes, moment = roller.with_two_laws(1e-3 * load, 0.09 * half_width, 12.5)
    assert moment == close(contact.moment, rel=3e-3)
    assert nodes.half_width * 1e-3 == close(contact.half_width, rel=0.06)  # the contact without its cohesive zones


def test_adhesive_hunter_without_adhesion_is_hunter():
    case = {"load": 5000.0, "speed": np.array([0.5, 0.05, 0.005]), **ROLLER}
    with_adhesion, without = analytic.adhesive_hunter(work=1e-13, **case), analytic.hunter(**case)
    # The half-width changes with the square root of the work.
    assert with_adhesion.half_width == close(without.half_width, rel=1e-7)
    assert with_adhesion.moment == close(without.moment, rel=1e-7)
    assert with_adhesion.center == close(without.center, rel=1e-6)


def test_adhesive_hunter_in_fast_rolling_is_jkr_of_the_instantaneous_modulus():
    contact = analytic.adhesive_hunter(load=200.0, speed=1e5, work=1.0, **ROLLER)
    elastic = analytic.jkr_line(load=200.0, work=1.0, **ROLLER | {"shear_modulus": 6e6})
    assert contact.half_width == close(elastic.half_width, rel=1e-6)
    assert contact.pull_off == close(elastic.pull_off, rel=1e-6)


@pytest.mark.parametrize("ratio", [1.5, 2.0, 10.0])
def test_adhesive_hunter_in_slow_rolling_releases_the_ratio_of_the_moduli(ratio):
    solid = vr.StandardLinearSolid(instantaneous_modulus=3e6 * ratio, relaxed_modulus=3e6, relaxation_time=0.125)
    contact = analytic.adhesive_hunter(load=100.0, speed=1e-5, work=1.0, **ROLLER | {"shear_modulus": solid})
    assert contact.moment == close(50e-3 * (ratio - 1.0 / ratio), rel=5e-3)


def test_pull_off_of_adhesive_hunter_is_the_limit_of_its_loads():
    case = {"speed": 0.05, "work": 1.0, **ROLLER}
    pull_off = analytic.adhesive_hunter(load=0.0, **case).pull_off
    assert pull_off < 0.0
    near = analytic.adhesive_hunter(load=0.999 * pull_off, **case)
    assert near.half_width < analytic.adhesive_hunter(load=0.0, **case).half_width
    with pytest.raises(ValueError, match=r"^load must be >= -.* N/m, the pull-off load, got -"):
        analytic.adhesive_hunter(load=1.001 * pull_off, **case)


@pytest.mark.parametrize(
    ("function", "case", "message"),
    [
        (analytic.jkr, {"load": np.nan}, r"^load must be finite, got nan$"),
        (analytic.jkr, {"load": -1.0}, r"^load must be >= -0\.47.* N, the pull-off load, got -1$"),
        (analytic.jkr, {"work": 0.0}, r"^work must be > 0 J/m², got 0$"),
        (analytic.maugis, {"strength": -1.0}, r"^strength must be > 0 Pa, got -1$"),
        (analytic.jkr_line, {"poisson_ratio": 0.6}, r"^poisson_ratio must be in \(-1, 0.5\], got 0.6$"),
        (analytic.thin_adhesive_layer_line, {"thickness": 1e-4}, r"^poisson_ratio must be in \(-1, 0.5\), got 0.5$"),
    ],
)
def test_messages(function, case, message):
    defaults = {"load": 1.0, "work": WORK, **SOLID}
    with pytest.raises(ValueError, match=message):
        function(**defaults | case)
