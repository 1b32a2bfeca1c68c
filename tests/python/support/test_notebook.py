"""Output in a notebook, tested in a real kernel: tables with units, each picture once, progress bars."""

from __future__ import annotations

import textwrap

import nbclient
import nbformat
import pytest

CELLS = {
    "set up": """
        import viscoroll as vr
        from viscoroll import paper
        ball = paper.ball()
        case = dict(angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=200))
        """,
    "ball": "ball",
    "bar": """
        fine = vr.Mesh(nodes_per_revolution=2000)  # which takes longer than the 20 ms between reports
        vr.solve(ball, load=50.0, angular_speed=2.5, friction=0.3, mesh=fine, progress=True)
        result = vr.solve(ball, load=50.0, **case)
        """,
    "result": "result",
    "picture": "result.plot()",
    "axes": """
        import matplotlib.pyplot as plt
        figure, (left, right) = plt.subplots(1, 2)
        result.plot(ax=left)
        """,
    "picture with pyplot": "result.plot()",
    "history": """
        mesh = vr.Mesh(nodes_per_revolution=64)
        vr.roll(ball, time=[0.0, 0.2], angle=[0.0, 0.1], load=50.0, mesh=mesh, averaged_meshes=1)
        """,
    "study": "vr.sweep(ball, load=[50.0, 60.0], **case)",
    "inside": "result.interior(depth=[0.5e-3])",
}


@pytest.fixture(scope="module")
def outputs():
    """Return the outputs of each cell."""
    cells = [nbformat.v4.new_code_cell(textwrap.dedent(text).strip()) for text in CELLS.values()]
    notebook = nbformat.v4.new_notebook(cells=cells)
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    return dict(zip(CELLS, (cell.outputs for cell in notebook.cells), strict=True))


def of_kind(outputs, kind):
    return [output["data"][kind] for output in outputs if kind in output.get("data", {})]


def streams(outputs):
    return "".join(output["text"] for output in outputs if output["output_type"] == "stream")


@pytest.mark.parametrize(
    ("cell", "texts"),
    [
        ("ball", ["core radius", "0.02", "StandardLinearSolid", "relaxation time"]),
        ("result", ["P = 50 N", "resisting torque T_r", "N m", "CONVERGED"]),
        ("history", ["RELAXED start", "last", "energy stored in both bodies"]),
        ("study", ["resisting_torque"]),
        ("inside", ["von_mises"]),
    ],
)
def test_results_are_displayed_as_tables(outputs, cell, texts):
    (html,) = of_kind(outputs[cell], "text/html")
    for text in texts:
        assert text in html


def test_each_picture_is_displayed_once(outputs):
    for cell in ("picture", "axes", "picture with pyplot"):
        assert len(of_kind(outputs[cell], "image/png")) == 1, cell


def test_progress_bars_are_displayed_without_warnings(outputs):
    # The bar is a text on the error stream, or a widget if ipywidgets is installed.
    texts = {cell: streams(outputs[cell]) + "".join(of_kind(outputs[cell], "text/plain")) for cell in ("study", "bar")}
    assert "point" in texts["study"]
    assert "%|" in texts["bar"]
    for cell in ("bar", "study"):
        assert "TqdmWarning" not in streams(outputs[cell])
