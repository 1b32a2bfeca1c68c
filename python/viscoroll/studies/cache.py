"""Points that studies have computed, kept on disk under keys of their inputs, beside the netCDF file of the last study.

Points are rows of an SQLite database, each in a transaction of its own: a process that is killed at any moment leaves
complete rows. One study at a time, in any thread or process, opens the database. The netCDF file appears complete or
not at all. Each row has a checksum, and the database has one of the netCDF file: no damaged file gives a number.
"""

from __future__ import annotations

import errno
import hashlib
import io
import json
import sqlite3
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._core import __commit__, __version__
from .._support.extras import extra
from .._support.files import draft_of, ending_in, write_netcdf
from .._support.sealed import seal
from .._support.text import one_line
from .run import Outcome

if TYPE_CHECKING:
    from types import TracebackType

    import xarray
    from numpy.typing import NDArray

__all__ = ["DAMAGED", "StudyCache", "as_cache_path", "point_store_path"]

#: Outcome of a point whose row does not have its checksum.
DAMAGED = Outcome(error="the cache is damaged at this point")

#: Marks a database as one of viscoroll ("vcrl").
_APPLICATION = 0x7663726C

#: Tables: the version that made the database; points; checksums of the netCDF file, before and after it is replaced.
_TABLES = (
    "CREATE TABLE made_by (text TEXT NOT NULL)",
    "CREATE TABLE point (key TEXT PRIMARY KEY, scalars TEXT NOT NULL, fields BLOB, draws BLOB, error TEXT NOT NULL, "
    "checksum BLOB NOT NULL)",
    "CREATE TABLE written (checksum BLOB NOT NULL)",
)

#: Errors of SQLite that the file system causes, and those that another connection causes. All others mean damage.
_OF_FILE_SYSTEM = {
    sqlite3.SQLITE_FULL,
    sqlite3.SQLITE_IOERR,
    sqlite3.SQLITE_CANTOPEN,
    sqlite3.SQLITE_READONLY,
    sqlite3.SQLITE_PERM,
}
_IN_USE = {sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED}


def as_cache_path(path: str | Path) -> Path:
    """Return the path of a cache.

    Raises
    ------
    ValueError
        Unless it ends in .nc.
    """
    return ending_in([".nc"], path, name="cache")


def point_store_path(path: Path) -> Path:
    """Return the path of the database that belongs to a cache."""
    return path.with_name(path.name + ".points")


class StudyCache:
    """The last study as a netCDF file, and the points of all studies in a database beside it.

    Parameters
    ----------
    path : Path
        The netCDF file. The database is made if it does not exist.

    Raises
    ------
    ValueError
        If a file is damaged or was not written by viscoroll, another version made the database, or another study uses
        it.
    OSError
        If a file cannot be read or written.
    """

    def __init__(self, path: Path) -> None:
        with extra("studies"):
            import netCDF4  # noqa: F401  (writes the file, at the end of all work)
            import xarray  # noqa: F401

        self.path = path
        self.points = point_store_path(path)
        if path.exists() and not self.points.exists():
            raise self._unknown_study()
        with ExitStack() as unless_opened, self._explained():
            # One study asks from the threads that solve its points, one at a time: see `_Recorder`.
            self._database = sqlite3.connect(self.points, timeout=0.0, isolation_level=None, check_same_thread=False)
            unless_opened.callback(self._database.close)
            self._database.text_factory = bytes  # damaged text is no UTF-8
            self._open()
            unless_opened.pop_all()

    def __enter__(self) -> StudyCache:
        """Return the open cache."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        """Close the database, so that other studies can open it."""
        self._database.close()

    def study(self) -> xarray.Dataset | None:
        """Return the study of the netCDF file, or None if there is no file."""
        import xarray

        if not self.path.exists():
            return None
        with self._explained():
            known = self._database.execute("SELECT checksum FROM written").fetchall()
        if (_file_checksum(self.path),) not in known:
            raise self._unknown_study()
        return xarray.load_dataset(self.path, engine="netcdf4")

    def write(self, dataset: xarray.Dataset) -> None:
        """Write a study in place of the one before."""
        compressed = {str(name): {"zlib": True} for name, values in dataset.data_vars.items() if "phi" in values.dims}
        with draft_of(self.path) as draft:
            write_netcdf(dataset, draft, encoding=compressed)
            seal(draft)
            checksum = _file_checksum(draft)
            with self._explained():
                self._database.execute("INSERT INTO written VALUES (?)", (checksum,))
        with self._explained():
            self._database.execute("DELETE FROM written WHERE checksum != ?", (checksum,))

    def outcome(self, key: str) -> Outcome | None:
        """Return the outcome of a point, `DAMAGED` if its checksum does not fit, or None if there is no such point."""
        with self._explained():
            query = "SELECT scalars, fields, draws, error, checksum FROM point WHERE key = ?"
            row = self._database.execute(query, (key,)).fetchone()
        if row is None:
            return None
        *values, checksum = row
        if checksum != _checksum(key.encode(), *values):
            return DAMAGED
        scalars, fields, draws, error = values
        return Outcome(
            scalars=json.loads(scalars), fields=_unpacked(fields), draws=_unpacked(draws), error=error.decode()
        )

    def keep(self, key: str, outcome: Outcome) -> None:
        """Keep the outcome of a point."""
        scalars, error = json.dumps(dict(outcome.scalars)), outcome.error
        fields, draws = _packed(outcome.fields), _packed(outcome.draws)
        checksum = _checksum(key.encode(), scalars.encode(), fields, draws, error.encode())
        with self._explained():
            row = (key, scalars, fields, draws, error, checksum)
            self._database.execute("INSERT OR REPLACE INTO point VALUES (?, ?, ?, ?, ?, ?)", row)

    def _open(self) -> None:
        """Lock the database until it is closed or this process ends, and check what it is."""
        self._database.execute("PRAGMA locking_mode = EXCLUSIVE")
        self._database.execute("BEGIN EXCLUSIVE")
        made_by = f"{__version__}, commit {__commit__}".encode()
        (application,) = self._database.execute("PRAGMA application_id").fetchone()
        tables = self._database.execute("SELECT sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY sql").fetchall()
        if not tables and application == 0:
            for statement in _TABLES:
                self._database.execute(statement)
            self._database.execute(f"PRAGMA application_id = {_APPLICATION}")
            self._database.execute("INSERT INTO made_by VALUES (?)", (made_by.decode(),))
        elif application != _APPLICATION:
            raise self._damaged("it has another mark")
        else:
            found = self._database.execute("SELECT text FROM made_by").fetchone()
            if found != (made_by,):
                version = found[0].decode(errors="replace") if found and isinstance(found[0], bytes) else repr(found)
                raise ValueError(
                    f"cache {self.points} was made by viscoroll {one_line(version)}, and must be of "
                    f"{made_by.decode()}: delete it and {self.path.name} to start again, or name another cache"
                )
            if tables != [(statement.encode(),) for statement in sorted(_TABLES)]:
                raise self._damaged("it has other tables")
        self._database.execute("COMMIT")

    @contextmanager
    def _explained(self) -> Iterator[None]:
        """Turn an error of SQLite into one that names the file and says what to do."""
        try:
            yield
        except sqlite3.Error as error:
            extended = getattr(error, "sqlite_errorcode", None)
            if extended is None:  # not of the file
                raise
            code = extended & 0xFF
            if code in _IN_USE:
                raise ValueError(f"cache {self.points} is in use by another study") from None
            if code in _OF_FILE_SYSTEM:
                number = errno.ENOSPC if code == sqlite3.SQLITE_FULL else errno.EIO
                raise OSError(number, str(error), str(self.points)) from None
            raise self._damaged(error.sqlite_errorname) from None  # its text may quote the file

    def _damaged(self, reason: str) -> ValueError:
        return ValueError(
            f"cache {self.points} is damaged, or another file than viscoroll writes ({reason}): "
            f"delete it and {self.path.name} to start again, or name another cache"
        )

    def _unknown_study(self) -> ValueError:
        return ValueError(
            f"cache {self.path} is damaged, or another file than viscoroll wrote with {self.points.name}: delete "
            "it, and the same call makes it again from the points, or name another cache"
        )


def _checksum(*parts: object) -> bytes:
    """Return a checksum of values from a row, which are bytes or None, and of any type in a damaged one."""
    checksum = hashlib.sha256()
    for part in parts:
        content = part if isinstance(part, bytes) else repr(part).encode()
        checksum.update(f"{type(part).__name__} {len(content)} ".encode())
        checksum.update(content)
    return checksum.digest()


def _file_checksum(path: Path) -> bytes:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").digest()


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
