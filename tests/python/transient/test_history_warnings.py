"""Warnings of histories about times without measurements and about large strains."""

from __future__ import annotations

import warnings

import pytest
import viscoroll as vr

DAY = 86400.0


def wheel(modulus, thickness=10e-3):
    return vr.CoatedCylinder(
        core_radius=40e-3, layers=[vr.Layer(thickness=thickness, shear_modulus=modulus, poisson_ratio=0.49)]
    )


def messages(body, duration, load, **options):
    """Return the warnings of a load that rests for a time."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        vr.roll(body, time=[0.0, duration], angle=[0.0, 0.0], load=load, mesh=vr.Mesh(nodes_per_revolution=100), averaged_meshes=1, **options)  # fmt: skip # noqa: E501
    return [str(one.message) for one in caught if issubclass(one.category, vr.ResultWarning)]


def test_dwell_beyond_the_times_of_a_loss_factor():
    tread = vr.LossFactor(modulus=3.2e6, loss_factor=0.15, reference_frequency=100.0)
    (text,) = messages(wheel(tread), 3.0 * DAY, 1e4, start="undeformed")
    assert "the motion lasts 2.59e+05 s, but the loss factor is defined up to 10 s only" in text
    assert "(body.layers[0].shear_modulus)" in text
    assert not messages(wheel(tread), 5.0, 1e4, start="undeformed")


def test_rest_of_infinite_time_with_a_loss_factor():
    tread = vr.LossFactor(modulus=3.2e6, loss_factor=0.15, reference_frequency=100.0)
    (text,) = messages(wheel(tread), 1.0, 1e4)
    relaxed = tread.prony().complex_modulus(1e-12).real
    assert f"its modulus at rest, {relaxed:.3g} Pa in place of 3.2e+06 Pa, is an extrapolation" in text


def test_a_table_is_measured_down_to_its_lowest_frequency():
    table = vr.MasterCurve([0.0, 0.1, 1.0, 100.0], [2e6, 2.2e6, 2.5e6, 3e6], [0.0, 1e5, 2e5, 2e5], "hold")
    (text,) = messages(wheel(table), 60.0, 1e4, spectrum_tolerance=0.5)
    assert "the motion lasts 60 s, but the table is measured up to 10 s only" in text


def test_large_strain_is_stated():
    rubber = vr.StandardLinearSolid(instantaneous_modulus=2e6, relaxed_modulus=5e5, relaxation_time=1.0)
    (text,) = messages(wheel(rubber), 20.0, 4e4, start="undeformed")
    assert text.startswith("the strain, penetration / coating thickness, is up to 0.")
    assert "(recommended: at most 0.2)" in text
    assert not messages(wheel(rubber), 20.0, 1e3)


@pytest.mark.parametrize("base", ["rigid", "half-space"])
def test_counterbodies_are_named(base):
    tread = vr.LossFactor(modulus=3.2e6, loss_factor=0.15, reference_frequency=100.0)
    below = vr.HalfSpace(shear_modulus=tread, poisson_ratio=0.45) if base == "half-space" else None
    layer = vr.Layer(thickness=5e-3, shear_modulus=2e6 if below else tread, poisson_ratio=0.45)
    on = vr.CoatedPlane(layers=[layer], base=below) if below else vr.CoatedPlane(layers=[layer])
    found = messages(vr.CoatedCylinder(core_radius=50e-3), DAY, 1e3, on=on, start="undeformed")
    name = "on.base.shear_modulus" if below else "on.layers[0].shear_modulus"
    assert any(name in text for text in found)
