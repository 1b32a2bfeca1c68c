"""Progress of long computations: all of them accept `progress`, a function or True."""

from __future__ import annotations

import dataclasses
import inspect

import numpy as np
import pytest
import viscoroll as vr
from viscoroll import paper
from viscoroll._support.progress import counted, reporting
from viscoroll.case import example_text
from viscoroll.case.compare import compare_torques
from viscoroll.case.design import design_case
from viscoroll.coupled import SelfHeating
from viscoroll.reproduce import Runner

MESH = vr.Mesh(nodes_per_revolution=400)
CASE = {"load": 50.0, "angular_speed": 2.5, "mesh": MESH}
SMALL = CASE | {"mesh": vr.Mesh(nodes_per_revolution=150, max_order=225)}
COOLING = {"conductivity": 0.2, "convection": 10.0, "ambient": 293.15}
SHIFT = vr.materials.Arrhenius(activation_energy=60e3, reference_temperature=293.15)
#: Long enough for a report every 20 ms.
MOTION = {"time": [0.0, 0.8], "angle": [0.0, 2.0], "load": 50.0, "mesh": vr.Mesh(nodes_per_revolution=300)}


@pytest.fixture(scope="module")
def ball(rubber):
    """Return a ball of dissimilar layers, which are solved order by order: reports come every 20 ms."""
    inner = vr.Layer(thickness=0.5e-3, shear_modulus=rubber, poisson_ratio=0.5)
    outer = vr.Layer(thickness=0.5e-3, shear_modulus=vr.Elastic(modulus=4e6), poisson_ratio=0.45)
    return vr.CoatedSphere(core_radius=20e-3, layers=[inner, inner, outer])


def larger(ball, core_radius):
    """Return a ball that no other test solves: the compliances of known layers take less than 20 ms."""
    return dataclasses.replace(ball, core_radius=core_radius)


@pytest.fixture(scope="module")
def result(ball):
    return vr.solve(ball, **SMALL)


@pytest.mark.parametrize(
    "compute",
    [
        lambda ball, _, **p: vr.solve(ball, **CASE, **p),
        lambda ball, _, **p: vr.RollingModel(larger(ball, 21e-3), angular_speed=2.5, mesh=MESH, **p),
        lambda ball, _, **p: vr.modal.influence_tables(
            larger(ball, 22e-3), angular_speed=2.5, mesh=MESH, reach=20, **p
        ),
        lambda *_, **p: vr.roll(paper.ball(), **MOTION, **p),
        lambda ball, _, **p: vr.sweep(ball, **CASE | {"load": [50.0, 60.0]}, **p),
        lambda *_, **p: vr.self_heating(paper.ball(), **SMALL, **COOLING, shift=SHIFT, points=4, **p),
        lambda _, result, **p: result.interior(depth=np.linspace(1e-5, 1e-3, 40), **p),
        lambda _, result, **p: result.loss(**p),
        lambda _, result, **p: result.bonds(**p),
        lambda _, result, **p: result.temperature(**COOLING, **p),
        lambda *_, **p: Runner(**p).map(abs, [1, 2]),
    ],
    ids=["solve", "model", "tables", "roll", "sweep", "heating", "interior", "loss", "bonds", "temperature", "runner"],
)
def test_reports_and_bars(ball, result, compute, capsys):
    seen = []
    compute(ball, result, progress=lambda stage, fraction: seen.append((stage, fraction)))
    assert seen
    assert all(isinstance(stage, str) and 0.0 <= fraction <= 1.0 for stage, fraction in seen)
    assert capsys.readouterr().err == ""
    compute(ball, result, progress=True)
    assert "%|" in capsys.readouterr().err
    with pytest.raises(TypeError, match=r"progress must be True, False, callable or None, got 3"):
        compute(ball, result, progress=3)


def test_case_files_report_progress(tmp_path):
    path = tmp_path / "case.toml"
    case = example_text().replace("accuracy = 0.01", "accuracy = 0.005")  # reports come every 20 ms
    design = '[design]\nvary = "ball.layers[0].thickness"\nfrom = 1e-3\nto = 2e-3\n'
    path.write_text(f"{case}\n{design}", encoding="utf-8")
    seen = []
    design_case(path, progress=lambda stage, fraction: seen.append((stage, fraction)))
    assert any(stage.startswith("case 2") for stage, _ in seen)
    assert all(0.0 <= fraction <= 1.0 for _, fraction in seen)


def test_all_functions_with_progress_have_the_same_parameter():
    for function in (design_case, compare_torques, SelfHeating.speeds, vr.RollingModel.solve, vr.RollingHistory):
        assert inspect.signature(function).parameters["progress"].annotation == "ProgressLike"


def test_no_bar_is_shown_by_default(ball, capsys):
    vr.solve(ball, **CASE)
    vr.solve(ball, **CASE, progress=False)
    vr.sweep(ball, **CASE, progress=False)
    assert capsys.readouterr().err == ""


def test_a_bar_is_closed_if_the_computation_fails(capsys):
    def divide():
        with reporting(True) as report:
            report("dividing", 1 / 2)
            report("dividing", 1 / 0)

    with pytest.raises(ZeroDivisionError):
        divide()
    assert "%|" in capsys.readouterr().err


def test_counts_are_reported_as_fractions(capsys):
    seen = []
    with counted(lambda *report: seen.append(report), total=4, unit="point", done=2) as advance:
        advance()
        advance()
    assert seen == [("points", 0.75), ("points", 1.0)]
    with counted(True, total=2, unit="point") as advance:
        advance()
        advance()
    assert "2/2" in capsys.readouterr().err
