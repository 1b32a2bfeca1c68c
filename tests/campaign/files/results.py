"""Studies in netCDF files: a damaged file must be rejected, or have the same content."""

from __future__ import annotations

import tempfile
import warnings
from functools import cache
from pathlib import Path
from random import Random

import viscoroll as vr
import xarray
from viscoroll import paper
from viscoroll._support.sealed import load_sealed

from .judging import command_failure, reading_failure
from .mutations import mutated

__all__ = ["check"]


#: Share of files that the command reads as well [-].
_BY_COMMAND = 0.1


@cache
def _original() -> tuple[bytes, xarray.Dataset]:
    """Return the netCDF file of a study of two points, as bytes and as dataset."""
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore", vr.ResultWarning)  # coarse mesh
        path = Path(folder, "study.nc")
        mesh = vr.Mesh(nodes_per_revolution=100, max_order=100)
        vr.sweep(paper.ball(), load=[50.0, 100.0], angular_speed=2.5, mesh=mesh, cache=path, progress=False)
        return path.read_bytes(), load_sealed(path)


def check(seed: int, folder: Path) -> str | None:
    """Write one damaged study into a folder, and return what is wrong with the way it is read, or None."""
    random = Random(seed)
    content, study = _original()
    path = folder / "study.nc"
    path.write_bytes(mutated(content, random, is_text=False))
    failure = reading_failure(
        load_sealed, path, lambda found: None if found.identical(study) else "content differs from the file"
    )
    if failure is None and random.random() < _BY_COMMAND:
        return command_failure(("plot", path), folder)
    return failure
