"""What all tests have in common: balls, and where they run."""

from __future__ import annotations

import os
import signal

# Before NumPy is imported. Threads of small dense products wait for each other by spinning, and here each core has a
# process of tests; those of viscoroll are its own.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ["COLUMNS"] = "80"  # of tables on the terminal, whatever the one in which tests are started

import pytest
import viscoroll as vr
from specimens import RUBBER
from viscoroll import paper

# A shell that starts the tests in the background makes them ignore SIGINT, and so all programs that they start.
signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_configure(config: pytest.Config) -> None:
    """Let results warn: many tests take coarse meshes, and those of warnings catch.

    Said in pyproject.toml, it would have NumPy imported before this file.
    """
    config.addinivalue_line("filterwarnings", "ignore::viscoroll.ResultWarning")


@pytest.fixture(scope="session")
def rubber() -> vr.StandardLinearSolid:
    """Material of the paper's section 14."""
    return RUBBER


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
