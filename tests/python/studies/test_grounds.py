"""Studies that vary the counterbody: by a function, as a list of bodies, and by names."""

from __future__ import annotations

import numpy as np
import pytest
import viscoroll as vr
from shared_cases import RUBBER, one_layer
from viscoroll.studies.dimensions import Dimension
from viscoroll.studies.picture import plot_study

IDLER = vr.CoatedCylinder(core_radius=80e-3)
CASE = {"load": 2e3, "angular_speed": [10.0, 20.0], "mesh": vr.Mesh(nodes_per_revolution=600), "progress": False}


def belt(cover, modulus=RUBBER):
    return vr.CoatedPlane(layers=[one_layer(modulus, thickness=cover)])


def test_a_function_returns_the_counterbody():
    study = vr.sweep(IDLER, on=belt, cover=[4e-3, 6e-3], **CASE)
    assert study.resisting_torque.dims == ("cover", "angular_speed")
    assert study.attrs["on"] == "CoatedPlane(belt)"
    there = study.resisting_torque.sel(cover=6e-3, angular_speed=20.0)
    alone = vr.solve(IDLER, on=belt(6e-3), load=2e3, angular_speed=20.0, mesh=CASE["mesh"])
    assert float(there) == pytest.approx(alone.resisting_torque, rel=1e-12)
    fixed = vr.sweep(IDLER, on=belt, cover=4e-3, **CASE)
    np.testing.assert_allclose(fixed.resisting_torque, study.resisting_torque.sel(cover=4e-3), rtol=1e-12)


def test_body_and_counterbody_functions_get_their_own_parameters():
    def idler(radius, cover):
        return vr.CoatedCylinder(core_radius=radius + 0.0 * cover)

    study = vr.sweep(idler, on=belt, radius=[60e-3, 80e-3], cover=[4e-3, 6e-3], **CASE | {"angular_speed": 10.0})
    assert study.resisting_torque.dims == ("radius", "cover")
    one = vr.solve(vr.CoatedCylinder(core_radius=60e-3), on=belt(6e-3), load=2e3, angular_speed=10.0, mesh=CASE["mesh"])
    assert float(study.resisting_torque.sel(radius=60e-3, cover=6e-3)) == pytest.approx(one.resisting_torque, rel=1e-12)


def test_labels_of_counterbodies():
    def labels(on):
        return vr.sweep(IDLER, on=on, **CASE).on.values.tolist()

    assert labels([belt(4e-3), belt(6e-3)]) == ["CoatedPlane, layer 4 mm", "CoatedPlane, layer 6 mm"]
    assert labels({"new": belt(4e-3), "worn": belt(4e-3, 3e6)}) == ["new", "worn"]
    assert labels([belt(4e-3), belt(4e-3, 3e6)]) == ["on[0]", "on[1]"]  # no short label distinguishes them
    steel, soft = vr.CoatedCylinder(core_radius=50e-3), vr.CoatedCylinder(core_radius=40e-3, layers=belt(5e-3).layers)
    (axes,) = plot_study(vr.sweep(IDLER, on={"new": belt(4e-3), "worn": belt(4e-3, 3e6)}, **CASE)).axes
    assert [text.get_text() for text in axes.get_xticklabels()] == ["new", "worn"]
    assert Dimension(name="on", values=(steel, soft)).labels().tolist() == [
        "CoatedCylinder, core 50 mm",
        "CoatedCylinder, core 40 mm, layer 5 mm",
    ]


def test_an_error_of_a_function_fails_only_its_points():
    study = vr.sweep(IDLER, on=belt, cover=[-1.0, 4e-3], **CASE)
    assert (study.error.sel(cover=-1.0) == "InvalidInput: thickness must be > 0 m, got -1").all()
    assert (study.error.sel(cover=4e-3) == "").all()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"on": belt}, "on, called with no parameter: missing a required argument: 'cover'"),
        ({"on": belt, "cover": 4e-3, "hight": 1.0}, "a rolling body has no parameter hight; pass a function of hight"),
        ({"on": lambda cover: cover, "cover": 4e-3}, r"on must return a viscoroll.CoatedPlane or .*, got 0\.004"),
    ],
)
def test_functions_with_other_parameters_are_rejected(options, message):
    with pytest.raises(TypeError, match=message):
        vr.sweep(IDLER, **options, **CASE)


def test_a_study_of_counterbodies_is_exported():
    ball = vr.CoatedSphere(core_radius=20e-3)
    case = {"load": [10.0, 20.0], "angular_speed": [1.0, 2.0], "mesh": vr.Mesh(nodes_per_revolution=200)}
    study = vr.sweep(ball, on=belt, cover=[2e-3, 3e-3], progress=False, **case)
    with pytest.raises(ValueError, match="study must vary only load and angular_speed, got also cover"):
        vr.export.dem(study, code="lammps")
    assert "a ball on a plane" in vr.export.dem(study.isel(cover=0), code="lammps").text
