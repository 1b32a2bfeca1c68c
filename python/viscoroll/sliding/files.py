"""Files of heights."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import ending_in
from .._support.text import shown

__all__ = ["read_heights"]

#: Factors of units of lengths in netCDF files.
_LENGTHS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6, "nm": 1e-9}

Heights = tuple[NDArray[np.float64], tuple[float, float] | None]


def read_heights(path: Path, instrument: str | None = None) -> Heights:
    """Return the heights of a file [m], and the spacing along x and z [m] if the file contains it.

    `instrument` is the name of a format of the package SurfaceTopography. Undefined heights are NaN.
    """
    if instrument is not None:
        return _read_instrument(path, instrument)
    return _READERS[ending_in(_READERS, path).suffix.lower()](path)


def _read_npy(path: Path) -> Heights:
    try:
        heights = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as error:
        raise InvalidInput("path", "must be a file that numpy.save wrote", f"{path.name} ({error})") from None
    if heights.dtype.kind not in "fiu":
        raise InvalidInput("path", "must contain real numbers", f"{path.name} with type {heights.dtype}")
    return heights.astype(np.float64), None


def _read_text(path: Path) -> Heights:
    rows: list[list[float]] = []
    lines = path.read_text(encoding="utf-8-sig").splitlines()
    for number, line in enumerate(lines, start=1):
        cells = line.partition("#")[0].replace(";", " ").replace(",", " ").split()
        if not cells:
            continue
        try:
            rows.append([float(cell) for cell in cells])
        except ValueError:
            raise InvalidInput(
                "path", "must contain numbers only", f"{path.name}, line {number}: {shown(line)}"
            ) from None
        if len(rows[-1]) != len(rows[0]):
            rule = f"must have {len(rows[0])} numbers in every line"
            raise InvalidInput("path", rule, f"{path.name}, line {number}: {len(rows[-1])}")
    if not rows:
        raise InvalidInput("path", "must contain heights", f"{path.name} without numbers")
    return np.array(rows), None


def _read_netcdf(path: Path) -> Heights:
    with extra("files"):
        import netCDF4
    with netCDF4.Dataset(path) as data:
        maps = [
            name for name, variable in data.variables.items() if name not in data.dimensions and variable.ndim in (1, 2)
        ]
        named = [name for name in maps if name.lower() in ("height", "heights")] or maps
        if len(named) != 1:
            rule = "must contain one variable of one or two dimensions, or one with the name heights"
            raise InvalidInput("path", rule, f"{path.name} with {', '.join(maps) or 'none'}")
        variable = data.variables[named[0]]
        heights = np.ma.filled(variable[:].astype(np.float64), np.nan) * _factor(path, variable)
        steps = [_step(path, data.variables[name]) for name in variable.dimensions if name in data.variables]
    if len(steps) != heights.ndim:
        return heights, None
    return heights, (steps[0], steps[-1])


def _read_instrument(path: Path, name: str) -> Heights:
    with extra("surfaces"):
        from SurfaceTopography.Exceptions import CorruptFile, ReadFileError
        from SurfaceTopography.IO import readers
    known = {reader.format(): reader for reader in readers}
    if name not in known:
        raise InvalidInput("format", f"must be one of {', '.join(sorted(known))}", shown(name))
    path.open("rb").close()  # a missing file is an OSError in every format
    try:
        with known[name](str(path)) as file:
            topography = file.topography()
        measured = topography.to_unit("m") if topography.unit is not None else topography
        heights = np.ma.filled(np.ma.asarray(measured.heights(), dtype=np.float64), np.nan)
    except (ReadFileError, CorruptFile, ValueError, KeyError, IndexError, EOFError) as error:
        raise InvalidInput("path", f"must be a file of the format {name}", f"{path.name} ({error})") from None
    if measured.unit is None or not measured.is_uniform:
        raise InvalidInput("path", "must contain heights at equal distances with a unit of length", path.name)
    spacing = measured.pixel_size
    return heights, (float(spacing[0]), float(spacing[-1]))


def _factor(path: Path, variable: Any) -> float:
    """Return the length in m of the unit of a variable."""
    unit = str(getattr(variable, "units", "m"))
    if unit not in _LENGTHS:
        raise InvalidInput("path", f"must have units in {', '.join(_LENGTHS)}", f"{path.name} with {shown(unit)}")
    return _LENGTHS[unit]


def _step(path: Path, coordinate: Any) -> float:
    """Return the distance of equally spaced coordinates [m]."""
    places = np.asarray(coordinate[:], dtype=np.float64) * _factor(path, coordinate)
    steps = np.diff(places)
    if steps.size == 0 or not steps[0] > 0.0 or np.ptp(steps) > 1e-6 * steps[0]:
        raise InvalidInput("path", "must have equally spaced, ascending coordinates", f"{path.name}: {coordinate.name}")
    return float((places[-1] - places[0]) / steps.size)


#: Readers by suffix.
_READERS = {".npy": _read_npy, ".csv": _read_text, ".txt": _read_text, ".nc": _read_netcdf}
