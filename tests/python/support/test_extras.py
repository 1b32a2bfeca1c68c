"""Optional packages that are not installed: an ImportError that names the package and the command to install it."""

from __future__ import annotations

import subprocess
import sys

import pytest
import viscoroll as vr
from viscoroll._support.extras import extra

BALL = "ball = vr.paper.ball(); case = dict(angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=64)); "
FIGURE_4 = "from viscoroll.reproduce import ITEMS, Runner; ITEMS['figure4'].compute(Runner(coarse=True))"
SWEEP = BALL + "vr.sweep(ball, load=[50.0, 60.0], **case, progress=False, cache={!r})"
HEATING = BALL + "vr.self_heating(ball, load=50.0, **case, convection=10.0, ambient=293.15, shift=lambda t: 1.0)"
RESULT = BALL + "result = vr.solve(ball, load=50.0, **case); result."


#: Statements that require a package, with the extra that contains it.
STATEMENTS = {
    "xarray": [(SWEEP.format(None), "studies"), (RESULT + "to_xarray()", "files")],
    "tqdm": [
        (BALL + "vr.solve(ball, load=50.0, **case, progress=True)", "studies"),
        (BALL + "vr.sweep(ball, load=[50.0, 60.0], **case)", "studies"),
    ],
    "netCDF4": [(SWEEP.format("study.nc"), "studies"), (RESULT + "save('fields.nc')", "files")],
    "scipy": [
        ("vr.studies.fit_power_law([1.0, 2.0, 3.0], [1.0, 2.0, 3.1])", "studies"),
        (FIGURE_4, "studies"),
        (HEATING, "studies"),
    ],
    "meshio": [(RESULT + "save('fields.vtu')", "files")],
    "matplotlib": [
        (RESULT + "plot()", "plot"),
        ("import viscoroll.reproduce", "plot"),
        ("import viscoroll.case.compare", "plot"),
    ],
    "pydantic": [("import viscoroll.case.case", "cli"), ("import viscoroll.case.study", "cli")],
    "typer": [("import viscoroll.cli", "cli")],
    "rich": [("import viscoroll.cli", "cli")],
}

#: Program that runs statements without a package and prints their errors; each statement has names of its own.
PROGRAM = """
import sys
sys.modules[{package!r}] = None
import viscoroll as vr
import viscoroll.paper
for statement in {statements!r}:
    try:
        exec(statement, {{"vr": vr}})
    except ImportError as error:
        print(type(error).__name__, error)
    else:
        print("no error:", statement)
"""


@pytest.mark.parametrize("package", STATEMENTS)
def test_a_missing_package_is_named_with_its_extra(tmp_path, package):
    program = PROGRAM.format(package=package, statements=[statement for statement, _ in STATEMENTS[package]])
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, cwd=tmp_path)
    assert done.stdout.splitlines() == [
        f"ImportError this function requires {package}, which is not installed: pip install 'viscoroll[{name}]'"
        for _, name in STATEMENTS[package]
    ]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("package", "arguments", "name"),
    [("scipy", "reproduce table2", "studies"), ("matplotlib", "plot study.nc", "plot")],
)
def test_the_command_line_names_a_missing_package_in_one_line(tmp_path, package, arguments, name):
    program = f"import sys; sys.modules[{package!r}] = None; from viscoroll.__main__ import main; main()"
    command = [sys.executable, "-c", program, *arguments.split()]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 2
    assert (
        done.stderr
        == f"viscoroll: this function requires {package}, which is not installed: pip install 'viscoroll[{name}]'\n"
    )


def test_the_extras_of_messages_exist():
    from importlib.metadata import metadata

    assert {"studies", "files", "plot", "cli"} <= set(metadata("viscoroll").get_all("Provides-Extra"))
    assert vr.sweep.__doc__.count("viscoroll[studies]") == 1


def test_other_import_errors_are_not_changed():
    with pytest.raises(ZeroDivisionError), extra("plot"):
        raise ZeroDivisionError
    with pytest.raises(ModuleNotFoundError, match=r"No module named 'viscoroll\.absent'"), extra("plot"):
        import viscoroll.absent  # noqa: F401
