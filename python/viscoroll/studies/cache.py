"""What a study has computed, kept on disk: a journal while it runs, a netCDF file when it has ended.

The journal holds one line of JSON for each point, appended as soon as the point is solved. Where the process is killed
in the middle of a line, the line is dropped and its point solved again. The netCDF file appears complete or not at all.
"""

from __future__ import annotations

import base64
import io
import json
import sys
import zlib
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np

from .run import Outcome

if TYPE_CHECKING:
    from types import TracebackType

    import xarray
    from numpy.typing import NDArray

__all__ = ["Journal", "as_cache_path", "journal_path", "read_study", "write_study"]

_FORMAT = "viscoroll study 1"


def as_cache_path(path: str | Path) -> Path:
    """Return the path of a cache.

    Raises
    ------
    ValueError
        Unless it ends in .nc.
    """
    path = Path(path)
    if path.suffix != ".nc":
        raise ValueError(f"cache must end in .nc, got {path.name!r}")
    return path


def journal_path(path: Path) -> Path:
    """Return where the points are kept until the study is complete."""
    return path.with_name(path.name + ".partial")


def read_study(path: Path, identity: dict[str, str]) -> xarray.Dataset | None:
    """Return the complete study of a cache, or None where there is no file.

    Raises
    ------
    ValueError
        Where the file holds something else, or a study with other inputs.
    """
    import xarray

    if not path.exists():
        return None
    try:
        dataset = xarray.load_dataset(path, engine="netcdf4")
    except OSError as error:
        raise ValueError(f"cache {path} must be a study of viscoroll, got another file ({error})") from None
    if "inputs" not in dataset.attrs:
        raise ValueError(f"cache {path} must be a study of viscoroll, got another dataset")
    _refuse_others(path, json.loads(dataset.attrs["inputs"]), identity)
    return dataset


def write_study(path: Path, dataset: xarray.Dataset) -> None:
    """Write a complete study, and remove its journal."""
    draft = path.with_name(path.name + ".writing")
    compressed = {name: {"zlib": True} for name, values in dataset.data_vars.items() if "phi" in values.dims}
    dataset.to_netcdf(draft, engine="netcdf4", encoding=compressed)
    draft.replace(path)
    journal_path(path).unlink(missing_ok=True)


class Journal:
    """The points that a study has computed so far, one line each; open in one process at a time.

    Parameters
    ----------
    path : Path
        The file; made where it does not exist.
    identity : dict of str
        All inputs of the study, by name.

    Raises
    ------
    ValueError
        Where the file was made with other inputs, is damaged, or is in use.
    """

    def __init__(self, path: Path, identity: dict[str, str]) -> None:
        self.path = path
        self.outcomes: dict[int, Outcome] = {}
        self._file: BinaryIO = path.open("a+b")
        try:
            _lock(self._file, path)
            self._resume(identity)
        except BaseException:
            self._file.close()
            raise

    def __enter__(self) -> Journal:
        """Return the open journal."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        """Close the file."""
        self._file.close()

    def append(self, index: int, outcome: Outcome) -> None:
        """Keep the outcome of a point."""
        entry = {
            "point": index,
            "scalars": dict(outcome.scalars),
            "fields": {name: _packed(values) for name, values in outcome.fields.items()},
            "error": outcome.error,
        }
        self._file.write(_line(entry))
        self._file.flush()
        self.outcomes[index] = outcome

    def _resume(self, identity: dict[str, str]) -> None:
        header = _line({"format": _FORMAT, "inputs": identity})
        self._file.seek(0)
        content = self._file.read()
        if header.startswith(content):  # new, or killed before the first line was complete
            self._file.truncate(0)
            self._file.write(header)
            self._file.flush()
            return
        first, *lines = [line for line in content.splitlines(keepends=True) if line.endswith(b"\n")] or [b"{}"]
        found = self._parsed(first, 1)
        if found.get("format") != _FORMAT:
            raise ValueError(f"cache {self.path} must be a journal of a study of viscoroll, got another file")
        _refuse_others(self.path, found["inputs"], identity)
        for number, line in enumerate(lines, start=2):
            entry = self._parsed(line, number)
            self.outcomes[entry["point"]] = Outcome(
                scalars=entry["scalars"],
                fields={name: _unpacked(text) for name, text in entry["fields"].items()},
                error=entry["error"],
            )
        self._file.truncate(len(first) + sum(map(len, lines)))

    def _parsed(self, line: bytes, number: int) -> dict[str, Any]:
        try:
            return dict(json.loads(line))
        except ValueError:
            raise ValueError(f"cache {self.path} is damaged in line {number}; delete it to start again") from None


def _line(entry: dict[str, Any]) -> bytes:
    return json.dumps(entry).encode() + b"\n"


def _lock(file: BinaryIO, path: Path) -> None:
    """Keep other processes out until the file is closed or this process ends, however it ends."""
    if sys.platform != "win32":
        import fcntl

        try:
            fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except (BlockingIOError, PermissionError):
            raise ValueError(f"cache {path} is in use by another process") from None


def _refuse_others(path: Path, found: dict[str, str], wanted: dict[str, str]) -> None:
    names = [name for name in {**wanted, **found} if found.get(name) != wanted.get(name)]
    if names:
        differences = "; ".join(
            f"{name} {found.get(name, 'not given')}, not {wanted.get(name, 'given')}" for name in names
        )
        raise ValueError(f"cache {path} was made with other inputs and must be of the same study, got {differences}")


def _packed(values: NDArray[np.float64]) -> str:
    buffer = io.BytesIO()
    np.save(buffer, values, allow_pickle=False)
    return base64.b64encode(zlib.compress(buffer.getvalue())).decode()


def _unpacked(text: str) -> NDArray[np.float64]:
    array: NDArray[np.float64] = np.load(io.BytesIO(zlib.decompress(base64.b64decode(text))), allow_pickle=False)
    return array
