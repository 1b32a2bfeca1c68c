"""Equivalent linear rolling compared with a roller on independent columns of a rate-independent network.

`tests/reference/network_columns.py` computes the columns.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
import viscoroll as vr
from reference.network_columns import Columns

#: Results of another program for each peak strain: load [N/m], moment [N], and permanent set / peak strain.
ROWS = {
    0.001: (2.53478, 6.63585e-6, 0.0307),
    0.003: (11.46052, 9.47594e-5, 0.0794),
    0.01: (51.62258, 1.431810e-3, 0.1716),
    0.1: (942.7153, 0.1932784, 0.1425),
    0.2: (2492.479, 0.7255869, 0.0851),
}


@pytest.mark.parametrize("peak", ROWS)
def test_columns_agree_with_another_program(peak):
    """Both programs agree to the digits printed in ROWS."""
    load, moment, permanent_set = ROWS[peak]
    found = Columns().pass_of(peak)
    assert found[:2] == pytest.approx((load, moment), rel=2e-6)
    assert found[2] == pytest.approx(permanent_set, abs=6e-5)


@pytest.mark.parametrize(
    ("peak", "bound"),
    # Sources of the deviation: the library uses one modulus for all strains of a pass, and the columns neglect their
    # interaction, which is of order h/a.
    [(0.01, 0.02), (0.1, 0.045)],
)
def test_network_torque_agrees_with_columns(peak, bound):
    """A thin layer with ν = 0 deforms as columns: E = 2 G, and the equivalent shear is 2/√3 of the axial strain."""
    columns = Columns()
    load, moment, permanent_set = columns.pass_of(peak)
    matrix = vr.StandardLinearSolid(
        instantaneous_modulus=0.5 * (columns.spring + columns.arm),
        relaxed_modulus=0.5 * columns.spring,
        relaxation_time=columns.relaxation_time,
    )
    network = vr.materials.MasingNetwork(
        storage=0.5 * columns.network, critical_strain=columns.critical_strain * 2.0 / math.sqrt(3.0)
    )
    height = 0.04e-3
    radius = columns.radius_by_height / height
    tread = vr.materials.SofteningModulus(matrix=matrix, network=network)
    layer = vr.Layer(thickness=height, shear_modulus=tread, poisson_ratio=0.0)
    found = vr.strain_softening(
        vr.CoatedCylinder(core_radius=radius - height, layers=[layer]),
        load=load,
        angular_speed=columns.speed / radius,
        mesh=vr.Mesh(nodes_per_revolution=62500),
    )
    harmonic_torque, network_torque = np.array(found.torque_bounds) / moment
    assert network_torque == pytest.approx(1.0, abs=bound)
    # For a parabolic strain history, the loss summed over harmonics is 1.62 times that of the network.
    assert harmonic_torque > 1.2
    # The penetration is measured from the surface of the track, which its permanent set has lowered.
    assert found.result.penetration == pytest.approx(height * peak * (1.0 - permanent_set), rel=bound)
    assert found.layer_amplitudes[0] == pytest.approx(peak * (1.0 - permanent_set) / math.sqrt(3.0), rel=bound)
