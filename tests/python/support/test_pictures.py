"""Plot methods draw into axes of the caller. A picture with several axes then draws only its main part."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import matplotlib.figure
import pytest
import viscoroll as vr
from viscoroll import enums, paper
from viscoroll._support.pictures import Picture
from viscoroll.case.compare import compare_torques
from viscoroll.studies.picture import plot_study

MESH = vr.Mesh(nodes_per_revolution=64, max_order=96)
CASE = {"load": 50.0, "angular_speed": 2.5, "mesh": MESH}


@pytest.fixture(scope="module")
def result():
    return vr.solve(paper.ball(), **CASE)


# The following results are computed once for all tests.


@cache
def heated(result):
    return result.temperature(conductivity=0.2, convection=10.0, ambient=293.0)


@cache
def history(result):
    return vr.roll(result.body, time=[0.0, 0.1], angle=[0.0, 0.1], load=50.0, mesh=vr.Mesh(nodes_per_revolution=64))


@cache
def study(result):
    return vr.sweep(result.body, **CASE | {"load": [50.0, 60.0]}, progress=False)


@cache
def comparison(result):
    from viscoroll.case import Case

    names = ("body", "load", "angular_speed", "friction", "drive", "mesh", "compliance", "curvature", "patch_load")
    given = {name: getattr(result, name) for name in names}
    case = Case(**given, penetration=None, accuracy=None, slip_kinematics=enums.SlipKinematics.EXACT)
    return compare_torques(case, points=2)


@cache
def superposed():
    data = vr.rheology.read_rheology(vr.rheology.example_data("pressure_sensitive_adhesive.txt"), tensile=False)
    return vr.rheology.superpose(data.between(288.15, 338.15), reference=293.15)


@pytest.mark.parametrize(
    ("plot", "label"),
    [
        (lambda r, **o: r.plot(**o), "x [mm], rolling to the right"),
        (lambda r, **o: r.plot_loss(**o), "across the track [mm]"),
        (lambda r, **o: heated(r).plot(**o), "along the axis [mm]"),
        (lambda r, **o: history(r).plot(**o), "time [s]"),
        (lambda r, **o: plot_study(study(r), **o), "load $P$ [N]"),
        (lambda r, **o: comparison(r).plot(**o), "rolling speed $Ω$ [rad/s]"),
        (lambda r, **o: superposed().fit.plot(**o), "angular frequency [rad/s]"),
        (lambda r, **o: superposed().plot(**o), "angular frequency at 20 °C [rad/s]"),
    ],
    ids=["result", "loss", "temperature", "history", "study", "comparison", "fit", "superposition"],
)
def test_plots_draw_into_given_axes(result, plot, label):
    figure = matplotlib.figure.Figure(layout="constrained")
    left, right = figure.subplots(1, 2)
    assert plot(result, ax=right) is right
    assert right.get_xlabel() == label
    assert right.has_data()
    assert not left.has_data()
    figure.draw_without_rendering()
    own = plot(result)
    assert isinstance(own, Picture)
    assert own._repr_png_().startswith(b"\x89PNG")
    with pytest.raises(TypeError, match=r"ax must be a matplotlib.axes.Axes or None, got .*>$"):
        plot(result, ax=figure)


@pytest.mark.parametrize("path", ["c.png", Path("c.png")])
def test_file_name_instead_of_axes_raises(result, path):
    with pytest.raises(TypeError, match=r"ax must be .*; to write a file, omit ax and call savefig\('c.png'\) on"):
        result.plot(path)
