"""Picture of the contact pressure."""

from __future__ import annotations

import numpy as np
import viscoroll as vr
from shared_cases import coated_ball


def test_the_map_contains_a_contact_that_is_wider_than_the_window_is_long():
    adhesive = vr.rheology.example_material("pressure_sensitive_adhesive").at(temperature=293.15)
    result = vr.solve(coated_ball(adhesive, poisson_ratio=0.49), load=5.0, angular_speed=3.0, accuracy=0.1)
    across = np.abs(result.z[result.contact]).max()
    assert across > result.x.max()  # creep shortens the contact along the path
    axes = result.plot().axes[0]
    assert axes.get_ylim()[1] > 1e3 * across
