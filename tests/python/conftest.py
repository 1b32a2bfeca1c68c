"""Fixtures and settings of all tests."""

from __future__ import annotations

import os
import signal

# Set before NumPy is imported. Threads of small dense products would wait for each other by spinning, while each core
# has its own test process. viscoroll starts its own threads.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ["COLUMNS"] = "80"  # width of tables on the terminal, whatever that of the terminal that starts the tests

import pytest
import viscoroll as vr
from shared_cases import RUBBER
from viscoroll import paper

# A shell that starts the tests in the background makes them, and all programs that they start, ignore SIGINT.
signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_configure(config: pytest.Config) -> None:
    """Allow warnings of results: many tests use coarse meshes, and tests of warnings catch them.

    In pyproject.toml, this setting would import NumPy before this file.
    """
    config.addinivalue_line("filterwarnings", "ignore::viscoroll.ResultWarning")


@pytest.fixture(scope="session")
def rubber() -> vr.StandardLinearSolid:
    """Return the material of the paper's section 14."""
    return RUBBER


@pytest.fixture(scope="session")
def paper_ball() -> vr.CoatedSphere:
    """Return the ball of the paper's section 14."""
    return paper.ball()


@pytest.fixture(scope="session")
def two_layer_ball(rubber: vr.StandardLinearSolid) -> vr.CoatedSphere:
    """Return a ball with two layers of different relaxation functions, with densities."""
    inner = vr.Layer(thickness=2e-3, shear_modulus=rubber, poisson_ratio=0.45, density=1000.0)
    outer = vr.Layer(thickness=1e-3, shear_modulus=vr.Elastic(modulus=2e6), poisson_ratio=0.3, density=1500.0)
    return vr.CoatedSphere(core_radius=20e-3, layers=[inner, outer])
