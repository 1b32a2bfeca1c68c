"""Dissipated power by harmonics, and the share that a measured table does not cover."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from reference.contact import power_of_orders
from shared_cases import coated_ball

MESH = vr.Mesh(nodes_per_revolution=1000)
COARSE = vr.Mesh(nodes_per_revolution=200)


def summed(result):
    """Return the power of the orders m from 1 to the number of nodes, each summed over all orders n."""
    phi, theta = (np.pi / 2 + result.mesh.spacing * (np.arange(count) - count // 2) for count in result.pressure.shape)
    phi, theta = (angle.ravel() for angle in np.meshgrid(phi, theta, indexing="ij"))
    tractions = np.stack([-result.pressure, -result.shear_traction[0], -result.shear_traction[1]])
    forces = (tractions * (result.body.outer_radius * result.mesh.spacing) ** 2).reshape(3, -1)

    def compliance(m, n):
        return vr.modal.surface_compliance(result.body, result.angular_speed, m, n, curvature=result.curvature)

    orders = np.arange(1, result.mesh.nodes_per_revolution + 1)
    return power_of_orders(
        compliance, orders, result.angular_speed, result.body.outer_radius, result.mesh.spacing, phi, theta, forces
    )


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_harmonics_agree_with_the_sum_of_all_orders(paper_ball, friction):
    """The library sums orders up to 32 and samples the rest; test pressure alone and three tractions."""
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=COARSE, friction=friction)
    spectrum, power = result.loss_spectrum(), summed(result)
    np.testing.assert_allclose(spectrum.power[:31], power[:31], rtol=2e-3)
    assert spectrum.power.sum() == pytest.approx(power.sum(), rel=1e-3)


def test_harmonics_add_up_to_the_power_of_the_core(paper_ball):
    """The core sums all orders on the mesh; the spectrum uses about a hundred, with an error of at most 0.1 %."""
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=MESH)
    spectrum = result.loss_spectrum()
    assert spectrum.power.sum() == pytest.approx(result.bulk_power, rel=1e-3)
    assert spectrum.frequency[0] == 2.5
    assert (spectrum.power > 0.0).mean() > 0.95


def test_harmonics_with_friction(paper_ball):
    """Shear tractions contribute to the power; the sum neglects the curvature of the surface in their directions."""
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=MESH, friction=0.3)
    assert result.loss_spectrum().power.sum() == pytest.approx(result.bulk_power, rel=0.03)


def test_share_outside_a_table(rubber):
    """The whole table covers nearly all of the loss, and a truncated one does not."""
    omega = np.geomspace(0.5, 5e4, 101)
    modulus = rubber.complex_modulus(omega)
    whole = vr.MasterCurve(omega, modulus.real, modulus.imag, extrapolation="hold")
    kept = (omega > 5.0) & (omega < 60.0)  # orders 3 to 23
    cut = vr.MasterCurve(omega[kept], modulus.real[kept], modulus.imag[kept], extrapolation="hold")
    shares = []
    for table in (whole, cut):
        result = vr.solve(coated_ball(table), load=100.0, angular_speed=2.5, mesh=COARSE)
        shares.append(result.extrapolated_loss())
    assert shares[0] < 1e-3
    power = summed(result)
    outside = (np.arange(1, power.size + 1) * 2.5 < omega[kept][0]) | (
        np.arange(1, power.size + 1) * 2.5 > omega[kept][-1]
    )
    assert shares[1] == pytest.approx(power[outside].sum() / power.sum(), rel=5e-3)
    assert "share of the loss outside the measured table" in repr(result)


def test_no_share_without_a_table(paper_ball):
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=200))
    assert result.extrapolated_loss() is None
    assert "outside the measured table" not in repr(result)
