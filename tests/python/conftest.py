"""Balls that several tests use."""

from __future__ import annotations

import signal

import pytest
import viscoroll as vr
from viscoroll import paper

# A shell that starts the tests in the background makes them ignore SIGINT, and so all programs that they start.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def rubber() -> vr.StandardLinearSolid:
    """Material of the paper's section 14."""
    return vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)


@pytest.fixture(scope="session")
def paper_ball() -> vr.CoatedSphere:
    """Ball of the paper's section 14."""
    return paper.ball()


@pytest.fixture(scope="session")
def unlike_ball(rubber: vr.StandardLinearSolid) -> vr.CoatedSphere:
    """Two layers that share no relaxation function, with densities."""
    inner = vr.Layer(thickness=2e-3, shear_modulus=rubber, poisson_ratio=0.45, density=1000.0)
    outer = vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=2e6), poisson_ratio=0.3, density=1500.0)
    return vr.CoatedSphere(core_radius=20e-3, layers=[inner, outer])
