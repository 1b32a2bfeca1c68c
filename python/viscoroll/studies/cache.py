"""What studies have computed, kept on disk: every point by its own inputs, beside the netCDF file of the last study.

Points are rows of an SQLite database, each in a transaction of its own: a process that is killed at any moment leaves
whole rows. The database is open in one study at a time, of any thread or process. The netCDF file appears complete or
not at all.
"""

from __future__ import annotations

import io
import json
import sqlite3
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._core import __commit__, __version__
from .._support.extras import extra
from .._support.files import draft_of, ending_in, write_netcdf
from .._support.sealed import load_sealed, seal
from .run import Outcome

if TYPE_CHECKING:
    from types import TracebackType

    import xarray
    from numpy.typing import NDArray

__all__ = ["PointStore", "as_cache_path", "point_store_path", "read_study", "write_study"]

#: Marks a database as ours ("vcrl").
_APPLICATION = 0x7663726C

_TABLES = """
CREATE TABLE made_by (text TEXT NOT NULL);
CREATE TABLE point (key TEXT PRIMARY KEY, scalars TEXT NOT NULL, fields BLOB, draws BLOB, error TEXT NOT NULL);
"""


def as_cache_path(path: str | Path) -> Path:
    """Return the path of a cache.

    Raises
    ------
    ValueError
        Unless it ends in .nc.
    """
    return ending_in([".nc"], path, name="cache")


def point_store_path(path: Path) -> Path:
    """Return where the points of a cache are kept."""
    return path.with_name(path.name + ".points")


def read_study(path: Path) -> xarray.Dataset | None:
    """Return the study of a cache, or None where there is no file.

    Raises
    ------
    ValueError
        Where the file holds something else.
    """
    with extra("studies"):
        import netCDF4  # noqa: F401  (writes the file, at the end of all work)
        import xarray  # noqa: F401

    if not path.exists():
        return None
    try:
        return load_sealed(path)
    except ValueError as error:
        raise ValueError(f"cache {error}") from None


def write_study(path: Path, dataset: xarray.Dataset) -> None:
    """Write a study in place of the one before."""
    compressed = {name: {"zlib": True} for name, values in dataset.data_vars.items() if "phi" in values.dims}
    with draft_of(path) as draft:
        write_netcdf(dataset, draft, encoding=compressed)
        seal(draft)


class PointStore:
    """The points that studies have computed, by key.

    Parameters
    ----------
    path : Path
        The database; made where it does not exist.

    Raises
    ------
    ValueError
        Where the file is something else, comes from another version, or is in use by another study.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        with ExitStack() as unless_opened:
            unless_opened.enter_context(_explained(path))
            # One study asks from the threads that solve its points, one at a time: see `_Recorder`.
            self._database = sqlite3.connect(path, timeout=0.0, isolation_level=None, check_same_thread=False)
            unless_opened.callback(self._database.close)
            self._open()
            unless_opened.pop_all()

    def __enter__(self) -> PointStore:
        """Return the open store."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        """Close the file, and let others in."""
        self._database.close()

    def outcomes(self, keys: Iterable[str]) -> dict[str, Outcome]:
        """Return what became of the points of some keys, as far as it is known."""
        found = {}
        for key in keys:
            query = "SELECT scalars, fields, draws, error FROM point WHERE key = ?"
            for scalars, fields, draws, error in self._database.execute(query, (key,)):
                found[key] = Outcome(
                    scalars=json.loads(scalars), fields=_unpacked(fields), draws=_unpacked(draws), error=error
                )
        return found

    def keep(self, key: str, outcome: Outcome) -> None:
        """Keep the outcome of a point."""
        arrays = (_packed(outcome.fields), _packed(outcome.draws))
        row = (key, json.dumps(dict(outcome.scalars)), *arrays, outcome.error)
        self._database.execute("INSERT OR REPLACE INTO point VALUES (?, ?, ?, ?, ?)", row)

    def _open(self) -> None:
        """Lock others out until the file is closed or this process ends, however it ends."""
        self._database.execute("PRAGMA locking_mode = EXCLUSIVE")
        self._database.execute("BEGIN EXCLUSIVE")
        made_by = f"{__version__}, commit {__commit__}"
        (application,) = self._database.execute("PRAGMA application_id").fetchone()
        is_new = self._database.execute("SELECT count(*) FROM sqlite_master").fetchone() == (0,)
        if is_new and application == 0:
            for statement in filter(str.strip, _TABLES.split(";")):
                self._database.execute(statement)
            self._database.execute(f"PRAGMA application_id = {_APPLICATION}")
            self._database.execute("INSERT INTO made_by VALUES (?)", (made_by,))
        elif application != _APPLICATION:
            raise sqlite3.DatabaseError
        (found,) = self._database.execute("SELECT text FROM made_by").fetchone()
        if found != made_by:
            raise ValueError(
                f"cache {self.path} was made by viscoroll {found}, and must be of {made_by}; delete it to start again"
            )
        self._database.execute("COMMIT")


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """Say what is wrong with a file that cannot be opened."""
    try:
        yield
    except sqlite3.OperationalError as error:
        if "locked" in str(error):
            raise ValueError(f"cache {path} is in use by another study") from None
        raise OSError(f"cache {path}: {error}") from None
    except sqlite3.DatabaseError:
        raise ValueError(f"cache {path} must hold points of viscoroll, got another file") from None


def _packed(values: Mapping[str, NDArray[np.float64]]) -> bytes | None:
    if not values:
        return None
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **values)  # type: ignore[arg-type]
    return buffer.getvalue()


def _unpacked(blob: bytes | None) -> dict[str, NDArray[np.float64]]:
    if blob is None:
        return {}
    with np.load(io.BytesIO(blob), allow_pickle=False) as arrays:
        return dict(arrays)
