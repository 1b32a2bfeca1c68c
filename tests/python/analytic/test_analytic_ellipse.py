"""Hertz's ellipse and its torques, compared with SciPy's elliptic integrals, quadrature of the spectrum, and limits."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import trapezoid
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk
from shared_cases import RUBBER
from viscoroll import analytic

HERTZ = {"load": 16.0, "radius": 50e-3, "shear_modulus": 3e6, "poisson_ratio": 0.3}


def johnson(load, radius, crown_radius, shear_modulus, poisson_ratio):
    """Return the semi-axes (long, short), approach and pressure by Johnson's (4.26) with (4.28) to (4.32).

    K. L. Johnson, Contact Mechanics, 1985: the moduli of the integrals are e² = 1 - b²/a².
    """
    wide, narrow = max(radius, crown_radius), min(radius, crown_radius)
    star = 2.0 * shear_modulus / (1.0 - poisson_ratio)

    def curvatures(q):
        m = 1.0 - q**2
        return (ellipk(m) - ellipe(m)) / m, (ellipe(m) / q**2 - ellipk(m)) / m

    q = brentq(lambda q: curvatures(q)[1] / curvatures(q)[0] - wide / narrow, 1e-6, 1.0 - 1e-6, xtol=1e-15)
    long = (3.0 * load * wide * curvatures(q)[0] / (np.pi * star)) ** (1.0 / 3.0)
    pressure = 1.5 * load / (np.pi * q * long**2)
    return long, q * long, pressure * q * long * ellipk(1.0 - q**2) / star, pressure


@pytest.mark.parametrize("crown_radius", [5e-3, 49e-3, 0.3, 20.0])
def test_semi_axes(crown_radius):
    contact = analytic.hertz_ellipse(**HERTZ, crown_radius=crown_radius)
    long, short, approach, pressure = johnson(**HERTZ, crown_radius=crown_radius)
    axes = (contact.semi_axis_x, contact.semi_axis_z)
    # Differences of SciPy's integrals keep eight digits if the ellipse is nearly round.
    assert sorted(axes) == pytest.approx([short, long], rel=1e-8)
    assert (axes[0] < axes[1]) == (crown_radius > HERTZ["radius"])
    assert contact.approach == pytest.approx(approach, rel=1e-8)
    assert contact.max_pressure == pytest.approx(pressure, rel=1e-8)


def test_a_round_ellipse_is_that_of_a_ball():
    ball = analytic.hertz(**HERTZ)
    contact = analytic.hertz_ellipse(**HERTZ, crown_radius=HERTZ["radius"])
    found = (contact.semi_axis_x, contact.semi_axis_z, contact.approach, contact.max_pressure)
    assert found == pytest.approx((ball.radius, ball.radius, ball.approach, ball.max_pressure), rel=1e-12)


def test_a_long_ellipse_is_a_line_in_the_middle():
    contact = analytic.hertz_ellipse(**HERTZ, crown_radius=1e6)
    line = analytic.hertz_line(
        load=0.5 * np.pi * contact.semi_axis_x * contact.max_pressure,
        **{name: value for name, value in HERTZ.items() if name != "load"},
    )
    # The difference is of first order in a²/b² times its logarithm.
    assert contact.semi_axis_x == pytest.approx(line.half_width, rel=1e-6)


def test_the_pressure_supports_the_load():
    contact = analytic.hertz_ellipse(**HERTZ, crown_radius=0.3)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    angle, share = 0.25 * np.pi * (1.0 + nodes), 0.25 * np.pi * weights
    # On a quarter, x = a sin s sin t and z = b sin s cos t, so the pressure is p0 cos s.
    s, t = angle[:, None], angle
    x, z = contact.semi_axis_x * np.sin(s) * np.sin(t), contact.semi_axis_z * np.sin(s) * np.cos(t)
    area = contact.semi_axis_x * contact.semi_axis_z * np.sin(s) * np.cos(s)
    assert 4.0 * share @ (contact.pressure(x, z) * area) @ share == pytest.approx(HERTZ["load"], rel=1e-12)
    assert contact.pressure(1.001 * contact.semi_axis_x, 0.0) == 0.0


@pytest.mark.parametrize("crown_radius", [10e-3, 50e-3, 0.3])
def test_torque_by_the_spectrum_of_the_ellipse(crown_radius):
    """Compare with Persson's sum over all waves, with the transform of Hertz's ellipse, on a plain grid of q."""
    load, radius, speed = 10.0, 50e-3, 1.0
    torque = analytic.persson_torque(
        load=load,
        angular_speed=speed,
        radius=radius,
        shear_modulus=RUBBER,
        poisson_ratio=0.5,
        frequency_factor=0.0,
        crown_radius=crown_radius,
    )
    contact = analytic.hertz_ellipse(
        load=load, radius=radius, crown_radius=crown_radius, shear_modulus=3e6, poisson_ratio=0.5
    )
    a, b = contact.semi_axis_x, contact.semi_axis_z
    qx = np.geomspace(1e-3 / a, 300.0 / a, 1500)
    qz = np.concatenate([[0.0], np.geomspace(1e-4 / max(a, b), 300.0 / b, 1500)])
    x = np.hypot(qx[:, None] * a, qz * b)
    transform = 3.0 * load * (np.sin(x) - x * np.cos(x)) / x**3
    modulus = RUBBER.complex_modulus(qx * speed * radius)
    loss = 0.5 * modulus.imag / np.abs(modulus) ** 2
    waves = qx[:, None] / np.hypot(qx[:, None], qz) * transform**2 * loss[:, None]
    quarter = trapezoid(trapezoid(waves, qz, axis=1), qx)
    # The trapezoidal rule and the ends of the grid are accurate to 1e-4.
    assert torque == pytest.approx(radius * 4.0 * quarter / (2.0 * np.pi) ** 2, rel=1e-4)


def test_torque_of_a_crowned_wheel_with_complete_loss():
    """If all energy is dissipated, the torque is the moment of the front half of the pressure, 3/16 P a."""
    contact = analytic.hertz_ellipse(**HERTZ, crown_radius=0.3)
    torque = analytic.greenwood_tabor_torque(**HERTZ, crown_radius=0.3)
    assert torque == pytest.approx(3.0 / 16.0 * HERTZ["load"] * contact.semi_axis_x, rel=1e-14)
    assert analytic.greenwood_tabor_torque(**HERTZ, crown_radius=HERTZ["radius"]) == pytest.approx(
        analytic.greenwood_tabor_torque(**HERTZ), rel=1e-14
    )


@pytest.mark.parametrize("function", [analytic.hertz_ellipse, analytic.greenwood_tabor_torque])
def test_bad_crowns(function):
    with pytest.raises(ValueError, match="crown_radius must be > 0 m, got -1"):
        function(**HERTZ, crown_radius=-1.0)
