"""Creep forces: Kalker's coefficients, Carter's curve, and the creep curve of a steel wheel by CONTACT."""

from __future__ import annotations

import pytest
from published import creep_forces as source

FRACTIONS = {0.0: "0", 0.25: "¼", 0.5: "½"}


# With full stick on elastic bodies, the power in the denominator of the error is nearly zero.
@pytest.mark.filterwarnings("ignore:the relative error of the power balance")
def test_kalkers_coefficients(judge):
    # 80 nodes across take eight seconds. C₁₁ and C₂₂ converge from above and C₂₃ from below, with half the error on
    # each finer mesh: 20, 40 and 80 nodes have errors of 2.8, 1.4 and 0.6 % of C₂₃.
    found = {}
    for ratio, fraction in FRACTIONS.items():
        for name, value in zip(("C₁₁", "C₂₂", "C₂₃"), source.coefficients(ratio, across=80), strict=True):
            found[f"{name} of a circle, Poisson's ratio {fraction}"] = value
    judge(found)


def test_carter(judge):
    judge(
        {
            f"Carter's force [μP], creepage {share} of what slides throughout": source.carter(share)
            for share in (0.2, 0.4, 0.8)
        }
    )


def test_creep_force_of_a_steel_wheel(judge):
    # Eleven solves, each with as many elements as CONTACT (1400 in contact), differ by 0.5 %. The initial slope of
    # CONTACT differs from Kalker's by 1.5 %, and that of the library by 1 %.
    wheel = source.SteelWheel()
    judge(
        {
            f"force of a steel wheel [μP], creepage {100.0 * creepage:g} %": wheel.force(creepage)
            for creepage in (1e-5, 4e-4, 8e-4, 1.2e-3, 1.6e-3, 2e-3, 2.4e-3, 3.2e-3, 6e-3, 1e-2)
        }
    )


def test_initial_slope_agrees_with_kalker(judge):
    judge({"its slope at rest [μP], Kalker's C₁₁": source.SteelWheel(finer=2.0).force(1e-5) / 1e-5})
    assert source.kalkers_slope() == pytest.approx(691.2, abs=0.05)
