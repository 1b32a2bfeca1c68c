"""Torque and temperature of a coating with uniform temperature: python -m tests.reference.self_heating.

The ball has a core of 20 mm and 5 mm of the rubber of section 14, under 100 N. A shift of all frequencies is a shift of
the speed, so that one torque curve applies to every temperature. All the heat leaves through the surface:
Omega T(a_T Omega) = 4 pi r_o^2 h_c (T - T_ambient), where T on the left side is the torque.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from .one_layer import Table, ball_equations, steady

RADIUS, LOAD = 25e-3, 100.0


def torque_curve(slowest, fastest, nodes=300):
    """Return the torque [N m] as a function of ln(angular speed [rad/s]), from 60 speeds."""
    table = Table(ball_equations, 20e-3, RADIUS, nodes, 2 * (nodes // 20) + 1)
    speeds = np.geomspace(slowest, fastest, 60)
    return CubicSpline(np.log(speeds), [steady(table, w, LOAD, nodes // 15, nodes // 20)[0] for w in speeds])


def steady_rises(curve, angular_speed, *, convection, shift_rate, limit):
    """Return temperature rises [K] up to a limit, and whether each is stable, with a_T = e^(-shift_rate rise)."""

    def surplus(rise):
        torque = curve(np.log(angular_speed) - shift_rate * rise)
        return angular_speed * torque / (4.0 * np.pi * RADIUS**2 * convection) - rise

    grid = np.linspace(0.0, limit, 400)
    signs = np.sign([surplus(rise) for rise in grid])
    found = np.flatnonzero(signs[1:] != signs[:-1])
    return [(brentq(surplus, grid[i], grid[i + 1]), bool(signs[i] > 0)) for i in found]


def main() -> None:
    """Print the states of docs/theory/temperature.md."""
    curve = torque_curve(1e-4, 100.0)
    for angular_speed in (2.5, 25.0, 100.0):
        states = steady_rises(curve, angular_speed, convection=10.0, shift_rate=0.1, limit=120.0)
        words = (f"{rise:.2f} K, {'stable' if stable else 'unstable'}" for rise, stable in states)
        print(f"{angular_speed} rad/s:", "; ".join(words))


if __name__ == "__main__":
    main()
