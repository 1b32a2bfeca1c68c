"""A roller on independent columns of filled rubber: `python -m tests.reference.network_columns` prints a table.

Every column is a spring and a Maxwell arm parallel to a network of springs and dry sliders, whose first loading is E_N
ε/(1 + ε/ε_c). The roller has passed before, so the sliders have already slid at the peak strain. The pass starts
from the free strain of the network, the set, follows the roller, and ends where the column would be in tension. Under
such passes, the network stays between two turning points, by Masing's rule, and the arm is an ordinary differential
equation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import trapezoid
from scipy.optimize import brentq


@dataclass(frozen=True)
class Columns:
    """Moduli in compression [Pa], relaxation time [s], critical strain [-], radius * height [m²], speed [m/s]."""

    spring: float = 3e6
    arm: float = 1.5e6
    relaxation_time: float = 10e-3
    network: float = 6e6
    critical_strain: float = 0.01
    radius_by_height: float = 20e-6
    speed: float = 0.1

    def first_loading(self, strain):
        """Return the stress of a network without earlier strain [Pa]."""
        return self.network * strain / (1.0 + strain / self.critical_strain)

    def network_stress(self, strain, peak, lowest, *, unloading):
        """Return the stress of the network between its turning points [Pa]."""
        top = self.first_loading(peak)
        if unloading:
            return top - 2.0 * self.first_loading(0.5 * (peak - strain))
        bottom = top - 2.0 * self.first_loading(0.5 * (peak - lowest))
        return bottom + 2.0 * self.first_loading(0.5 * (strain - lowest))

    def free_strain(self, peak):
        """Return the strain that remains without stress, long after a pass [-]."""

        def stress(strain):
            return self.spring * strain + self.network_stress(strain, peak, strain, unloading=True)

        return brentq(stress, -peak, peak, xtol=1e-15 * peak, rtol=1e-14)

    def pass_of(self, peak, points=20001):
        """Return load [N/m], moment of the pressure [N], and permanent set / peak [-] for a peak strain [-]."""
        lowest = self.free_strain(peak)
        entry = np.sqrt(2.0 * self.radius_by_height * (peak - lowest))
        x = np.linspace(entry, -entry, points)
        strain = peak - x**2 / (2.0 * self.radius_by_height)
        stress = (
            self.spring * strain
            + self.arm_stress(x)
            + np.where(
                x > 0.0,
                self.network_stress(strain, peak, lowest, unloading=False),
                self.network_stress(strain, peak, lowest, unloading=True),
            )
        )
        pulls = np.flatnonzero((stress < 0.0) & (x < 0.0))
        end = pulls[0] if pulls.size else points
        stress, x = np.maximum(stress[:end], 0.0), x[:end]
        return -trapezoid(stress, x), -trapezoid(stress * x, x), lowest / peak

    def arm_stress(self, x):
        """Return the stress of the Maxwell arm [Pa], σ' + σ/τ = E ε', with ε' = V x/(R h), in closed form from x[0]."""
        length = self.speed * self.relaxation_time
        rate = self.arm * length / self.radius_by_height
        # With d/dt = -V d/dx, rate (x + length) is a particular solution; the decaying part makes it zero at x[0].
        return rate * (x + length - (x[0] + length) * np.exp((x - x[0]) / length))


def main():
    """Print load, moment and set."""
    print("   peak [%]     P [N/m]         M [N]      set")
    for peak in (0.001, 0.003, 0.01, 0.1, 0.2):
        load, moment, left = Columns().pass_of(peak)
        print(f"{100 * peak:11g} {load:11.6g} {moment:13.7g} {left:8.4f}")


if __name__ == "__main__":
    main()
