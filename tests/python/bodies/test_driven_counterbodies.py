"""Sliding on a soft counterbody, whose material passes the contact at its own speed."""

from __future__ import annotations

import pytest
import viscoroll as vr

STEEL = vr.CoatedCylinder(core_radius=50e-3, layers=[])


@pytest.mark.parametrize("creepage", [0.1, -0.02])
def test_exchanged_elastic_rollers_have_the_same_forces(creepage):
    # Pressure shears compressible thin layers strongly. If both displacements were advected at the same speed, forces
    # would differ by up to a tenth and slip powers by a seventh.
    def roller(thickness, modulus, poisson_ratio):
        layer = vr.Layer(thickness=thickness, shear_modulus=vr.Elastic(modulus=modulus), poisson_ratio=poisson_ratio)
        return vr.CoatedCylinder(core_radius=50e-3 - thickness, layers=[layer])

    one, other = roller(5e-3, 3e5, 0.48), roller(10e-3, 6e5, 0.45)
    given = {"load": 3e3, "friction": 0.5, "mesh": vr.Mesh(nodes_per_revolution=6000)}
    back = 1.0 / (1.0 + creepage) - 1.0
    first = vr.solve(one, on=other, angular_speed=10.0, drive=vr.Drive(creepage=creepage), **given)
    second = vr.solve(other, on=one, angular_speed=10.0 * (1.0 + creepage), drive=vr.Drive(creepage=back), **given)
    tractions = [r.shear_traction[0].sum() for r in (first, second)]
    assert tractions[0] == pytest.approx(-tractions[1], rel=5e-4)
    assert first.slip_power == pytest.approx(second.slip_power, rel=5e-4)
    assert max(first.energy_balance_error, second.energy_balance_error) < 3e-3


@pytest.mark.parametrize(
    "drive", [vr.Drive(torque=50.0), vr.Drive(force=-2e3), vr.Drive(creepage=0.1), vr.Drive(creepage=1.0)]
)
def test_power_balance_of_a_rigid_roller_that_slides_on_a_soft_mat(drive):
    # If the mat's displacement were advected at the speed of the roller's surface, the error would be 8 to 28 %.
    layer = vr.Layer(thickness=5e-3, shear_modulus=vr.Elastic(modulus=1e6 / 2.99), poisson_ratio=0.495)
    r = vr.solve(STEEL, on=vr.CoatedPlane(layers=[layer]), load=1e4, angular_speed=10.0, friction=0.5, drive=drive)
    assert r.energy_balance_error < 3e-3
    assert r.slip_power > 0.0
