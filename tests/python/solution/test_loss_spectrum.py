"""Power lost by harmonics, and how much of it a measured table does not hold."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr

MESH = vr.Mesh(nodes_per_revolution=1000)


def test_harmonics_add_up_to_the_power_of_the_core(paper_ball):
    """The core sums all orders on the mesh; here some hundred of them, at the most 0.1 % off."""
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=MESH)
    spectrum = vr.loss_spectrum(result)
    assert spectrum.power.sum() == pytest.approx(result.bulk_power, rel=1e-3)
    assert spectrum.frequency[0] == 2.5
    assert (spectrum.power > 0.0).mean() > 0.95


def test_harmonics_with_friction(paper_ball):
    """Tractions along the surface come in; of the curvature in their directions the torus's sum knows nothing."""
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=MESH, friction=0.3)
    assert vr.loss_spectrum(result).power.sum() == pytest.approx(result.bulk_power, rel=0.03)


def test_share_outside_a_table(rubber):
    """The whole table holds nearly all of the loss, one that is cut does not."""
    omega = np.geomspace(0.5, 5e4, 101)
    modulus = rubber.complex_modulus(omega)
    whole = vr.MasterCurve(omega, modulus.real, modulus.imag, extrapolation="hold")
    kept = (omega > 5.0) & (omega < 60.0)
    cut = vr.MasterCurve(omega[kept], modulus.real[kept], modulus.imag[kept], extrapolation="hold")
    shares = []
    for table in (whole, cut):
        layer = vr.Layer(thickness=1e-3, shear_modulus=table, poisson_ratio=0.5)
        ball = vr.CoatedSphere(core_radius=20e-3, layers=[layer])
        result = vr.solve(ball, load=100.0, angular_speed=2.5, mesh=MESH)
        shares.append(result.extrapolated_loss())
    assert shares[0] < 1e-3
    spectrum = vr.loss_spectrum(result)
    outside = (spectrum.frequency < omega[kept][0]) | (spectrum.frequency > omega[kept][-1])
    assert shares[1] == pytest.approx(spectrum.power[outside].sum() / spectrum.power.sum())
    assert 0.05 < shares[1] < 0.9
    assert "of that, outside the measured table" in repr(result)


def test_no_share_without_a_table(paper_ball):
    result = vr.solve(paper_ball, load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=200))
    assert result.extrapolated_loss() is None
    assert "outside the measured table" not in repr(result)
