"""Bodies, materials, a case file and the command line that many tests share."""

from __future__ import annotations

import io
import subprocess
import sys
import warnings
from collections.abc import Iterator
from contextlib import chdir, contextmanager, redirect_stderr, redirect_stdout
from unittest.mock import patch

import pytest
import viscoroll as vr
from viscoroll import enums
from viscoroll.__main__ import main

#: Material of the paper's section 14.
RUBBER = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)


def one_layer(shear_modulus=RUBBER, *, thickness=1e-3, poisson_ratio=0.5, **others):
    """Return a layer, by default with the paper's thickness and Poisson's ratio."""
    if "bulk_modulus" in others:
        poisson_ratio = None
    return vr.Layer(thickness=thickness, shear_modulus=shear_modulus, poisson_ratio=poisson_ratio, **others)


def coated_ball(shear_modulus=RUBBER, *, core_radius=20e-3, inner_boundary=enums.InnerBoundary.RIGID, **layer):
    """Return a ball with one layer on the paper's core, by default the paper's ball without mass."""
    return vr.CoatedSphere(
        core_radius=core_radius, layers=[one_layer(shear_modulus, **layer)], inner_boundary=inner_boundary
    )


def ball_file(*, nodes_per_revolution):
    """Return the text of a case file: a ball with a layer of 2 mm that rolls at 100 rad/s."""
    return f"""
[ball]
core_radius = 20e-3
[[ball.layers]]
thickness = 2e-3
poisson_ratio = 0.5
[ball.layers.shear_modulus]
type = "standard_linear_solid"
instantaneous_modulus = 6e6
relaxed_modulus = 3e6
relaxation_time = 1e-3
[rolling]
load = 50.0
angular_speed = 100.0
[numerics]
nodes_per_revolution = {nodes_per_revolution}
"""


def command(*arguments, cwd="."):
    """Run the command line in this process, which avoids new imports; return the completed process."""
    words = ["viscoroll", *map(str, arguments)]
    output, messages = io.StringIO(), io.StringIO()
    with (
        patch.object(sys, "argv", words),
        chdir(cwd),
        redirect_stdout(output),
        redirect_stderr(messages),
        warnings.catch_warnings(),
        pytest.raises(SystemExit) as ended,
    ):
        main()
    return subprocess.CompletedProcess(words, ended.value.code or 0, output.getvalue(), messages.getvalue())


@contextmanager
def few_pictures() -> Iterator[list[int]]:
    """Draw only the first and the last picture of each animation; yield the numbers of pictures that were requested.

    A picture takes a tenth of a second. `transient/test_animation.py` draws all pictures of an animation.
    """
    from viscoroll.transient import animation

    all_instants, requested = animation._instants, []

    def first_and_last(time, frames):
        requested.append(frames)
        instants = all_instants(time, frames)
        return [instants[0], instants[-1]]

    with patch.object(animation, "_instants", first_and_last):
        yield requested
