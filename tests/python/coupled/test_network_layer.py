"""Equivalent linear rolling compared with a layer of a rate-independent network (tests/reference/network_layer.py)."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference.network_layer import Layer

#: Load [Pa mm] to 0.1 % and moment [Pa mm²] to 1 % from another program, by Poisson's ratio and depth [mm].
ROWS = {(0.3, 0.02): (120573.0, 9280.0), (0.3, 0.1): (1.0577e6, 2.196e5), (0.45, 0.02): (241242.0, 25294.0)}


@pytest.mark.parametrize(("ratio", "depth"), ROWS)
def test_layer_agrees_with_another_program(ratio, depth):
    load, moment = ROWS[ratio, depth]
    found = Layer(poisson_ratio=ratio, nodes=2048).pass_of(depth)
    assert found[0] == pytest.approx(load, rel=2e-3)
    assert found[1] == pytest.approx(moment, rel=1e-2)


@pytest.mark.parametrize(("depth", "plain"), [(0.02, 0.98), (0.1, 1.144)])
def test_network_torque_agrees_with_the_layer(depth, plain):
    """At equal load, the torque of the loss method "network" agrees to 5 %, unlike the sum over harmonics."""
    exact = Layer(bulk_modulus=2.7e6, nodes=2048)
    load, moment = exact.pass_of(depth)
    matrix = vr.StandardLinearSolid(
        instantaneous_modulus=exact.relaxed + exact.arm,
        relaxed_modulus=exact.relaxed,
        relaxation_time=exact.relaxation_time,
    )
    network = vr.materials.MasingNetwork(storage=exact.network, critical_strain=exact.critical_strain)
    tread = vr.materials.SofteningModulus(matrix=matrix, network=network)
    layer = vr.Layer(thickness=1e-3 * exact.thickness, shear_modulus=tread, bulk_modulus=exact.bulk_modulus)
    radius = 1e-3 * exact.radius
    found = vr.strain_softening(
        vr.CoatedCylinder(core_radius=radius),
        on=vr.CoatedPlane(layers=[layer]),
        load=1e-3 * load,
        angular_speed=1e-3 * exact.speed / radius,
        mesh=vr.Mesh(nodes_per_revolution=4000),
    )
    harmonic, matched = np.array(found.torque_bounds) / (1e-6 * moment)
    assert matched == pytest.approx(1.0, abs=0.05)
    assert harmonic == pytest.approx(plain, abs=0.01)
    assert 0.9 < found.result.penetration / (1e-3 * depth) < 1.0  # measured from the track, lowered by its set
