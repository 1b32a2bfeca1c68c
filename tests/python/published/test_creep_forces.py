"""Creep forces: Kalker's coefficients, Carter's curve, and the creep curve of a steel wheel by CONTACT."""

from __future__ import annotations

import pytest
from published import creep_forces

FRACTIONS = {0.0: "0", 0.25: "¼", 0.5: "½"}


# With full stick on elastic bodies, the power in the denominator of the error is nearly zero.
@pytest.mark.filterwarnings("ignore:the relative error of the power balance")
def test_kalkers_coefficients(judge):
    # 80 nodes across take eight seconds. C₁₁ and C₂₂ converge from above and C₂₃ from below, with half the error on
    # each finer mesh: for ν = 0, 20, 40 and 80 nodes have errors of 2.8, 1.4 and 0.6 % of C₂₃.
    found = {}
    for ratio, fraction in FRACTIONS.items():
        for name, value in zip(("C₁₁", "C₂₂", "C₂₃"), creep_forces.coefficients(ratio, across=80), strict=True):
            found[f"{name} of a circle, Poisson's ratio {fraction}"] = value
    judge(found)


def test_carter(judge):
    judge(
        {
            f"Carter's force [μP], creepage {share} of that of full sliding": creep_forces.carter(share)
            for share in (0.2, 0.4, 0.8)
        }
    )


def test_creep_force_of_a_steel_wheel(judge):
    # With as many elements as CONTACT (1400 in contact), the forces differ from those of CONTACT by 0.5 %. The eleven
    # solves are these creepages and free rolling, from which they count. The initial slope of CONTACT differs from
    # Kalker's by 1.5 %, and that of the library by 1 %.
    wheel = creep_forces.SteelWheel()
    judge(
        {
            f"force of a steel wheel [μP], creepage {100.0 * creepage:g} %": wheel.force(creepage)
            for creepage in (1e-5, 4e-4, 8e-4, 1.2e-3, 1.6e-3, 2e-3, 2.4e-3, 3.2e-3, 6e-3, 1e-2)
        }
    )


def test_initial_slope_agrees_with_kalker(judge):
    slope = creep_forces.SteelWheel(refinement=2.0).force(1e-5) / 1e-5
    judge({"initial slope of the force of a steel wheel [μP], by Kalker's C₁₁": slope})
    assert creep_forces.kalkers_slope() == pytest.approx(691.2, abs=0.05)
