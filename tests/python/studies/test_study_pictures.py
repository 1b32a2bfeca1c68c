"""Pictures of studies: names and units on the axes, scales, legends, and texts that do not overlap."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
import viscoroll as vr
import xarray
from viscoroll import paper
from viscoroll.studies.picture import plot_study

UNITS = {"load": "N", "angular_speed": "rad/s", "friction": "1", "thickness": "m"}
CASE = {"load": 50.0, "angular_speed": 2.5, "mesh": vr.Mesh(nodes_per_revolution=100, max_order=50), "progress": False}


def _unit(name):
    return {"units": UNITS.get(name, "1")}


def study_of(scale=1e-3, missing=(), **dimensions):
    """Return a study in which a power law of all parameters gives the torque [N m]."""
    shape = [len(values) for values in dimensions.values()]
    torque = np.full(shape, scale)
    for axis, values in enumerate(dimensions.values()):
        if not isinstance(values[0], str):
            along = (0.1 + np.array(values, dtype=float)) ** 1.4
            torque = torque * np.expand_dims(along, [i for i in range(len(shape)) if i != axis])
    for place in missing:
        torque[place] = np.nan
    coordinates = {
        name: (name, np.array(values, dtype=object if isinstance(values[0], str) else float), _unit(name))
        for name, values in dimensions.items()
    }
    attributes = {"units": "N m", "long_name": "resisting torque T_r"}
    status = np.where(np.isnan(torque), "FAILED", "CONVERGED").astype(object)
    variables = {"resisting_torque": (list(dimensions), torque, attributes), "status": (list(dimensions), status)}
    return xarray.Dataset(variables, coordinates)


def drawn(study, **options):
    figure = plot_study(study, **options)
    figure.draw_without_rendering()
    return figure


def legend(axes):
    return [] if axes.get_legend() is None else [text.get_text() for text in axes.get_legend().get_texts()]


def test_default_picture_of_a_study():
    study = vr.sweep(paper.ball, **CASE | {"load": [10.0, 20.0, 40.0]}, thickness=[1e-3, 2e-3], friction=[0.0, 0.1])
    (axes,) = drawn(study).axes
    assert axes.get_xlabel() == "load $P$ [N]"
    assert axes.get_ylabel().endswith("[mN m]")
    assert axes.get_title().splitlines()[1] == r"$\Omega$ = 2.5 rad/s"
    assert legend(axes) == ["$h$ = 1 mm", "$h$ = 2 mm", r"$\mu$ = 0", r"$\mu$ = 0.1"]
    assert len([line for line in axes.get_lines() if line.get_xdata().size]) == 4
    line = axes.get_lines()[0]
    expected = 1e3 * study.resisting_torque.isel(thickness=0, friction=0)
    np.testing.assert_allclose(line.get_ydata(), expected, rtol=1e-12)


def test_axes_over_decades_are_logarithmic():
    (axes,) = drawn(study_of(load=[1.0, 5.0, 100.0], angular_speed=[1.0, 2.0])).axes
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    shown = [text.get_text() for text in axes.get_xticklabels() if 1.0 <= text.get_position()[0] <= 100.0]
    assert shown == ["1", "10", "100"]
    (axes,) = drawn(study_of(friction=[0.0, 0.01, 0.1, 1.0])).axes
    assert axes.get_xscale() == "symlog"
    (axes,) = drawn(study_of(thickness=[1e-3, 2e-3, 3e-3])).axes
    assert (axes.get_xscale(), axes.get_yscale(), axes.get_xlabel()) == ("linear", "linear", "thickness $h$ [mm]")
    assert legend(axes) == []


def test_many_curves_have_a_color_bar():
    axes, bar = drawn(study_of(angular_speed=np.geomspace(0.1, 10.0, 7), load=np.geomspace(1.0, 100.0, 30))).axes
    assert bar.get_ylabel() == "load $P$ [N]"
    assert bar.get_yscale() == "log"
    assert legend(axes) == []
    assert len({tuple(line.get_color()) for line in axes.get_lines()[:30]}) == 30


def test_values_without_a_curve_are_not_in_the_legend():
    study = study_of(load=[1.0, 2.0, 1e9], thickness=[1e-3, 2e-3, 3e-3], missing=[np.s_[:, 1], np.s_[2]])
    (axes,) = drawn(study).axes
    assert legend(axes) == ["$h$ = 1 mm", "$h$ = 3 mm"]
    assert axes.get_title().splitlines()[-1] == "5 of 9 points have no value"
    assert axes.get_xlim()[1] < 3.0


def test_points_that_have_not_converged_are_hollow():
    study = study_of(load=[1.0, 2.0, 4.0], friction=[0.1, 0.2])
    study.status[1, 1] = "ACCURACY_NOT_REACHED"
    (axes,) = drawn(study).axes
    assert legend(axes)[-1] == "not converged"
    (x,), (y,) = axes.get_lines()[-1].get_data()
    unit = {"[N m]": 1.0, "[mN m]": 1e3}[axes.get_ylabel().partition("$ ")[2]]
    assert (x, y) == (2.0, pytest.approx(study.resisting_torque[1, 1].item() * unit))


DRIVES = ["force=0", "torque=0.01", "creepage=0.01", "creepage=-0.01, lateral_creepage=0.02", "force=1.25"]


@pytest.mark.parametrize("count", [2, 5, 24])
def test_texts_below_the_axis_do_not_overlap(count):
    drives = (DRIVES + [f"creepage={0.01 * i:g}, lateral_creepage=0.02" for i in range(2, 30)])[:count]
    figure = drawn(study_of(drive=drives, friction=[0.1, 0.3]))
    (axes,) = figure.axes
    assert axes.get_xlabel() == "drive"
    labels = [text for text in axes.get_xticklabels() if text.get_text()]
    assert [text.get_text() for text in labels][:2] == ["force = 0 N", "torque = 0.01 N m"]
    for one, other in pairwise(labels):
        # The boxes of slanted texts overlap, but the texts do not if their distance exceeds their height.
        apart = other.get_window_extent().x1 - one.get_window_extent().x1
        assert apart > 0.0
        if one.get_rotation() == 0.0:
            assert not one.get_window_extent().overlaps(other.get_window_extent())
        else:
            lines = max(text.get_text().count("\n") + 1 for text in (one, other))
            height = 1.25 * one.get_fontsize() * figure.dpi / 72.0 * lines
            assert apart * np.sin(np.radians(one.get_rotation())) > 0.9 * height


def test_studies_that_cannot_be_drawn_are_rejected():
    study = study_of(load=[1.0, 2.0])
    with pytest.raises(ValueError, match="variable must be one of resisting_torque, got 'heat'"):
        plot_study(study, variable="heat")
    with pytest.raises(ValueError, match="must have a dimension to be drawn against, got resisting_torque at a single"):
        plot_study(study.isel(load=0))
    with pytest.raises(ValueError, match="must have finite values to be drawn, got resisting_torque, which has none"):
        plot_study(study_of(load=[1.0, 2.0], missing=[np.s_[:]]))
    many = {"load": [1.0, 2.0], "friction": list(range(9)), "thickness": list(range(1, 6))}
    with pytest.raises(ValueError, match="at most 4 combinations of thickness, got 5; select some of them"):
        plot_study(study_of(**many))
    with pytest.raises(ValueError, match="at most 10 values of drive, got 11; select some of them"):
        plot_study(study_of(load=[1.0, 2.0], drive=[f"force={i}" for i in range(11)]))
