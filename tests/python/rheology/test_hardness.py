"""Hardness and rebound from data sheets, with the spread of the relations."""

from __future__ import annotations

import pytest
import viscoroll as vr
from scipy.integrate import solve_ivp


def retained_energy(loss_factor):
    """Return the fraction of its energy that a mass retains after impact on a spring and dashpot, until zero force."""

    def force(_, state):
        return -state[0] - loss_factor * state[1]

    def gone(time, state):
        return force(time, state)

    gone.terminal, gone.direction = True, 1.0
    found = solve_ivp(
        lambda t, s: [s[1], force(t, s)], (0.0, 10.0), [0.0, 1.0], events=gone, rtol=1e-10, atol=1e-12, max_step=0.05
    )
    return found.y[1, -1] ** 2


@pytest.mark.parametrize("rebound", [0.05, 0.2, 0.55, 0.9])
def test_upper_end_of_a_rebounds_spread_is_an_impact_until_zero_force(rebound):
    """Integrate an impact until the force is zero; data sheets round the rebound to half a percent."""
    loss = vr.rheology.rebound_to_loss_factor(rebound)
    assert loss.unit == "1"
    assert loss.lower < loss.value < loss.upper
    assert retained_energy(loss.upper) == pytest.approx(rebound - 0.005, abs=1e-6)


def test_spread_of_a_rebound_at_the_ends_of_its_range():
    assert vr.rheology.rebound_to_loss_factor(0.999).lower == 0.0
    assert vr.rheology.rebound_to_loss_factor(0.02).upper < 2.0  # limit of `LossFactor`


def test_messages_about_hardness_beyond_shore_a_name_shore_d():
    """The relation of Qi, Joyce and Boyce uses S = S_A = S_D + 50."""
    with pytest.raises(ValueError, match=r"got 95; use scale='D' for harder materials: 95 Shore A is about 45 Shore D"):
        vr.rheology.hardness_to_modulus(95.0)
    with pytest.raises(ValueError, match=r"hardness must be in \[20, 90\] Shore A, got 101$"):
        vr.rheology.hardness_to_modulus(101.0)
    hard, soft = vr.rheology.hardness_to_modulus(45.0, scale="D"), vr.rheology.hardness_to_modulus(90.0)
    assert soft.value < hard.value
    assert hard.upper / hard.lower == pytest.approx(4.0)
