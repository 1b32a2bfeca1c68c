"""Cache of studies: a database of all solved points, stored by keys of their inputs, and a netCDF file of a study.

The netCDF file contains the last study and appears complete or not at all. Points are rows of an SQLite database. Each
point is one transaction, so that a process that is killed at any moment leaves complete rows. Only one study at a time,
in any thread or process, can open the database. Each row has a checksum, and the database stores the checksum of the
netCDF file, so that damaged files are detected.
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

__all__ = ["DAMAGED", "StudyCache", "as_cache_path", "database_path"]

#: Outcome of a point whose row does not match its checksum.
DAMAGED = Outcome(error="the cache is damaged at this point")

#: SQLite application id of a database of viscoroll ("vcrl").
_APPLICATION = 0x7663726C

#: made_by: version that made the database. point: one row per point. study_checksum: checksum of the netCDF file, and
#: those of replacements that failed.
_TABLES = (
    "CREATE TABLE made_by (text TEXT NOT NULL)",
    "CREATE TABLE point (key TEXT PRIMARY KEY, scalars TEXT NOT NULL, fields BLOB, draws BLOB, error TEXT NOT NULL, "
    "checksum BLOB NOT NULL)",
    "CREATE TABLE study_checksum (checksum BLOB NOT NULL)",
)

#: Errors of SQLite that the file system causes. All others with a code of SQLite, except `_IN_USE_ERRORS`, mean damage.
_FILE_SYSTEM_ERRORS = {
    sqlite3.SQLITE_FULL,
    sqlite3.SQLITE_IOERR,
    sqlite3.SQLITE_CANTOPEN,
    sqlite3.SQLITE_READONLY,
    sqlite3.SQLITE_PERM,
}

#: Errors of SQLite that another connection causes.
_IN_USE_ERRORS = {sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED}


def as_cache_path(path: str | Path) -> Path:
    """Return a path as the path of a cache.

    Raises
    ------
    ValueError
        If the path does not end in .nc.
    """
    return ending_in([".nc"], path, name="cache")


def database_path(path: Path) -> Path:
    """Return the path of the database that belongs to a cache."""
    return path.with_name(path.name + ".points")


class StudyCache:
    """Cache of studies: the last study as a netCDF file, and the points of all studies in a database next to it.

    Parameters
    ----------
    path : Path
        Path of the netCDF file. The database is created if it does not exist.

    Raises
    ------
    ValueError
        If a file is damaged or was not written by viscoroll, if another version made the database, or if another study
        uses it.
    OSError
        If a file cannot be read or written.
    """

    def __init__(self, path: Path) -> None:
        with extra("studies"):
            import netCDF4  # noqa: F401  (needed at the end, to write the file)
            import xarray  # noqa: F401

        self.path = path
        self.database_path = database_path(path)
        if path.exists() and not self.database_path.exists():
            raise self._unknown_study()
        with ExitStack() as close_on_failure, self._converting_sqlite_errors():
            # The threads that solve the points of a study use the database one at a time: see `_Recorder`.
            self._database = sqlite3.connect(
                self.database_path, timeout=0.0, isolation_level=None, check_same_thread=False
            )
            close_on_failure.callback(self._database.close)
            self._database.text_factory = bytes  # damaged text may not be UTF-8
            self._open()
            close_on_failure.pop_all()

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
        with self._converting_sqlite_errors():
            known = self._database.execute("SELECT checksum FROM study_checksum").fetchall()
        if (_file_checksum(self.path),) not in known:
            raise self._unknown_study()
        return xarray.load_dataset(self.path, engine="netcdf4")

    def write(self, dataset: xarray.Dataset) -> None:
        """Write a study, which replaces the previous one."""
        compressed = {str(name): {"zlib": True} for name, values in dataset.data_vars.items() if "phi" in values.dims}
        with draft_of(self.path) as draft:
            write_netcdf(dataset, draft, encoding=compressed)
            seal(draft)
            checksum = _file_checksum(draft)
            with self._converting_sqlite_errors():
                self._database.execute("INSERT INTO study_checksum VALUES (?)", (checksum,))
        with self._converting_sqlite_errors():
            self._database.execute("DELETE FROM study_checksum WHERE checksum != ?", (checksum,))

    def outcome(self, key: str) -> Outcome | None:
        """Return the outcome of a point, `DAMAGED` if its checksum does not match, or None if the point is missing."""
        with self._converting_sqlite_errors():
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
        """Store the outcome of a point."""
        scalars, error = json.dumps(dict(outcome.scalars)), outcome.error
        fields, draws = _packed(outcome.fields), _packed(outcome.draws)
        checksum = _checksum(key.encode(), scalars.encode(), fields, draws, error.encode())
        with self._converting_sqlite_errors():
            row = (key, scalars, fields, draws, error, checksum)
            self._database.execute("INSERT OR REPLACE INTO point VALUES (?, ?, ?, ?, ?, ?)", row)

    def _open(self) -> None:
        """Lock the database until it is closed or this process ends; create or check its tables."""
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
            raise self._damaged("its application id is different")
        else:
            found = self._database.execute("SELECT text FROM made_by").fetchone()
            if found != (made_by,):
                version = found[0].decode(errors="replace") if found and isinstance(found[0], bytes) else repr(found)
                raise ValueError(
                    f"cache {self.database_path} must be made by viscoroll {made_by.decode()}, got a cache made by "
                    f"{one_line(version)}: delete it and {self.path.name} to start again, or name another cache"
                )
            if tables != [(statement.encode(),) for statement in sorted(_TABLES)]:
                raise self._damaged("its tables are different")
        self._database.execute("COMMIT")

    @contextmanager
    def _converting_sqlite_errors(self) -> Iterator[None]:
        """Convert an error of SQLite to one that names the file and says what to do."""
        try:
            yield
        except sqlite3.Error as error:
            extended = getattr(error, "sqlite_errorcode", None)
            if extended is None:  # an error that does not concern the file
                raise
            code = extended & 0xFF
            if code in _IN_USE_ERRORS:
                raise ValueError(f"cache {self.database_path} is in use by another study") from None
            if code in _FILE_SYSTEM_ERRORS:
                number = errno.ENOSPC if code == sqlite3.SQLITE_FULL else errno.EIO
                raise OSError(number, str(error), str(self.database_path)) from None
            raise self._damaged(error.sqlite_errorname) from None  # its message may quote damaged text

    def _damaged(self, reason: str) -> ValueError:
        return ValueError(
            f"cache {self.database_path} is damaged, or is not a file of viscoroll ({reason}): "
            f"delete it and {self.path.name} to start again, or name another cache"
        )

    def _unknown_study(self) -> ValueError:
        return ValueError(
            f"cache {self.path} is damaged, or does not belong to {self.database_path.name}: delete it, and the same "
            "call makes it again from the points, or name another cache"
        )


def _checksum(*parts: object) -> bytes:
    """Return a checksum of the values of a row: bytes or None, but possibly of any type in a damaged row."""
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
