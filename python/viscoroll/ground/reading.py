"""Readers of measured profiles."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from .._support.arguments import Floats, as_float_in
from .._support.columns import read_columns
from .._support.errors import InvalidInput, Range, in_file
from .._support.files import ending_in

__all__ = ["read_profile"]


def read_profile(path: Path, *, lateral: float) -> tuple[Floats, Floats]:
    """Return the distances and heights of a file [m]; `lateral` selects the section of an OpenCRG surface [m]."""
    path = ending_in(_READERS, path)
    return _READERS[path.suffix.lower()](path, lateral)


def _read_csv(path: Path, _: float) -> tuple[Floats, Floats]:
    columns = read_columns("profile", path, ("distance", "height"))
    return np.asarray(columns["distance"]), np.asarray(columns["height"])


def _read_npy(path: Path, _: float) -> tuple[Floats, Floats]:
    try:
        values = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as error:
        raise in_file(ValueError(str(error)), path) from None
    if not (isinstance(values, np.ndarray) and values.ndim == 2 and values.shape[1] == 2):
        raise InvalidInput(path, "must be an array of shape (points, 2)", f"shape {np.shape(values)}")
    if values.dtype.kind not in "fiu":
        raise InvalidInput(path, "must be an array of real numbers", f"{values.dtype}")
    points = values.astype(np.float64)
    return points[:, 0], points[:, 1]


def _read_crg(path: Path, lateral: float) -> tuple[Floats, Floats]:
    try:
        import pyopencrg
    except ModuleNotFoundError:
        raise ImportError(
            "OpenCRG files require pyopencrg, which is not installed: pip install pyopencrg", name="pyopencrg"
        ) from None
    with path.open("rb"):  # pyopencrg has errors of its own for files that do not exist
        pass
    try:
        road = pyopencrg.read(path)
    except OSError:
        raise
    except Exception as error:
        raise in_file(ValueError(f"must be an OpenCRG file: {error}"), path) from None
    as_float_in(Range(road.v_min, road.v_max, "m"), "lateral", lateral)
    distances = np.asarray(road.u, dtype=np.float64)
    heights = np.asarray(road.uv_to_z(distances, np.full_like(distances, lateral)), dtype=np.float64)
    return distances - distances[0], heights - heights[0]


#: Functions that read a file and a lateral position, by suffix.
_READERS = {".csv": _read_csv, ".npy": _read_npy, ".crg": _read_crg}
