"""A write that fails on a full disk raises an OSError that names the file, and leaves no draft.

The previous file stays unchanged.
"""

from __future__ import annotations

import errno
import re
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import viscoroll as vr
from matplotlib.figure import Figure
from shared_cases import command
from viscoroll import paper
from viscoroll._support.files import draft_of, save_picture
from viscoroll.case import example_text
from viscoroll.rheology import ShiftFactors
from viscoroll.solution.files import FORMATS
from viscoroll.solution.interior_files import save_interior

resource = pytest.importorskip("resource")

MESH = vr.Mesh(nodes_per_revolution=100, max_order=50)
FACTORS = ShiftFactors(temperature=(293.15, 303.15), log10_factor=(0.0, -1.0))


@contextmanager
def full_disk(size=0):
    """Limit the size of files [B]: a larger write fails as on a full disk, with EFBIG in place of ENOSPC."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


@pytest.fixture(scope="module")
def result():
    return vr.solve(paper.ball(), load=100.0, angular_speed=2.5, mesh=vr.Mesh(nodes_per_revolution=300))


def interior(result):
    angles = 0.5 * np.pi + np.array([-0.02, 0.0, 0.02])
    return result.interior(depth=[2e-4, 8e-4], phi=angles, theta=angles)


def rolling_resistance():
    return vr.studies.RollingResistance(
        load=(1.0, 2.0),
        angular_speed=(1.0, 2.0),
        radius=0.02,
        coefficients=np.ones((2, 2)),
        error=0.0,
        largest_error=0.0,
    )


WRITERS = {
    **{f"fields{suffix}": lambda result, path: result.save(path) for suffix in FORMATS},
    "inside.nc": lambda result, path: save_interior(interior(result), path),
    "inside.vtu": lambda result, path: save_interior(interior(result), path),
    **{
        f"resistance{suffix}": lambda result, path: rolling_resistance().save(path)
        for suffix in (".json", ".csv", ".nc")
    },
    **{f"picture{suffix}": lambda result, path: save_picture(Figure(), path) for suffix in (".png", ".svg", ".pdf")},
    "a.state": lambda result, path: vr.RollingState(np.zeros(1000)).save(path),
    "b.STATE": lambda result, path: vr.RollingState(np.zeros(1000)).save(path),
    "shift.csv": lambda result, path: FACTORS.save(path),
    "input.lammps": lambda result, path: vr.export.dem(result, code="lammps").save(path),
}


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("before", [None, "old"])
def test_a_file_is_written_completely_or_not_at_all(tmp_path, result, name, before):
    path = tmp_path / name
    if before is not None:
        path.write_text(before)
    with full_disk(), pytest.raises(OSError) as raised:  # noqa: PT011  (checked below by its file)
        WRITERS[name](result, path)
    assert raised.value.filename == str(path)
    assert raised.value.errno
    assert raised.value.strerror
    assert [file.read_text() for file in tmp_path.iterdir()] == ([] if before is None else [before])
    WRITERS[name](result, path)
    others = {"input.csv"} if name == "input.lammps" else set()
    assert {file.name for file in tmp_path.iterdir()} == {name} | others
    assert path.stat().st_size > 10


def test_a_symbolic_link_remains_a_link(tmp_path):
    (tmp_path / "link.csv").symlink_to("file.csv")
    FACTORS.save(tmp_path / "link.csv")
    assert (tmp_path / "link.csv").readlink() == Path("file.csv")
    assert (tmp_path / "file.csv").read_text().startswith("T,log_aT")


def test_an_interrupted_draft_is_removed_and_the_error_is_raised(tmp_path):
    for error in (KeyboardInterrupt(), ValueError("no"), FileNotFoundError(errno.ENOENT, "none", "other.txt")):

        def interrupted(error=error):
            with draft_of(tmp_path / "file.csv") as draft:
                draft.write_text("half")
                raise error

        with pytest.raises(type(error)) as raised:
            interrupted()
        assert raised.value is error
        assert list(tmp_path.iterdir()) == []


def test_all_files_are_written_through_drafts():
    """Every function that writes a file uses `draft_of`, or writes to a draft or a buffer in memory.

    The exception is the temporary page of `viscoroll app`.
    """
    package = Path(vr.__file__).parent
    writes = re.compile(r"\.(savefig|to_netcdf|write_text|write_bytes)\(|\bnp\.savez?\w*\(|\.open\(\"[wax]")
    lines = {
        f"{path.relative_to(package)}: {line.strip()}"
        for path in package.rglob("*.py")
        for line in path.read_text(encoding="utf-8").splitlines()
        if writes.search(line) and not re.search(r"draft|figure\.savefig\(content|``", line)
    }
    assert lines == {
        '_support/pictures.py: self.savefig(file, format="png", bbox_inches="tight")',
        "studies/cache.py: np.savez_compressed(buffer, **values)  # type: ignore[arg-type]",
        'app/server.py: path.write_text(_REDIRECT.format(address=escape(self.address)), encoding="utf-8")',
    }


@pytest.mark.parametrize(
    "space",
    [
        pytest.param(0, id="the database cannot be created"),
        pytest.param(25_000, id="the database cannot grow"),
        pytest.param(30_000, id="the study cannot be written"),
    ],
)
def test_a_study_resumes_after_a_full_disk(tmp_path, space):
    """The same sweep succeeds after the disk was full, and its results are those of a sweep without a cache."""
    path = tmp_path / "study.nc"
    case = {"angular_speed": [1.0, 2.0, 4.0], "load": 100.0, "mesh": MESH, "cache": path, "progress": False}
    with full_disk(space), pytest.raises(OSError) as raised:  # noqa: PT011
        vr.sweep(paper.ball(), **case)
    assert raised.value.filename in (str(path), f"{path}.points")
    assert {file.name for file in tmp_path.iterdir()} == {"study.nc.points"}
    study = vr.sweep(paper.ball(), **case)
    np.testing.assert_array_equal(
        study.resisting_torque, vr.sweep(paper.ball(), **case | {"cache": None}).resisting_torque
    )
    assert {file.name for file in tmp_path.iterdir()} == {"study.nc", "study.nc.points"}


@pytest.mark.parametrize(
    "arguments",
    [
        ("solve", "case.toml", "--save", "out.nc"),
        ("solve", "case.toml", "--plot", "out.pdf"),
        ("export", "case.toml", "--for", "yade", "--output", "out.yade"),
        ("sweep", "study.toml", "--output", "out.nc"),
    ],
)
def test_the_command_line_names_the_file(tmp_path, arguments):
    case = example_text("case").replace("accuracy = 0.01", "accuracy = 0.3")
    (tmp_path / "case.toml").write_text(case)
    (tmp_path / "study.toml").write_text(case + '\n[sweep]\n"rolling.load" = [50.0, 60.0]\n')
    with full_disk():
        done = command(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert re.fullmatch(rf"viscoroll: \S*{re.escape(arguments[-1])}(\.points)?: [^\n]+", done.stderr.splitlines()[-1])
    assert not {file.name for file in tmp_path.iterdir()} - {"case.toml", "study.toml", "out.nc.points"}


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is full")
def test_a_full_standard_output():
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "viscoroll", "example"], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert (done.returncode, done.stderr) == (2, "viscoroll: standard output: No space left on device\n")
