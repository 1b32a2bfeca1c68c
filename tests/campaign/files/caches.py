"""Damaged caches of studies: each must give the numbers of the undamaged study, or an error that names the file."""

from __future__ import annotations

import contextlib
import functools
import random
import sqlite3
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import viscoroll as vr
import xarray
from viscoroll import paper

__all__ = ["check", "study"]

#: Longest time of a study from a damaged cache [s]; a study that finds no point in the cache takes 0.1 s.
_LONGEST = 20.0

#: Size of a page of the database [B].
_PAGE = 4096

#: Each point has its own speed and shares nothing, so a repeated solve gives the same bits.
_SPEEDS = (1.0, 2.0, 4.0, 8.0)

_STUDY, _POINTS = "study.nc", "study.nc.points"

_Files = dict[str, bytes]


def study(cache: Path | None, *, speeds: tuple[float, ...] = _SPEEDS, retry_failed: bool = False) -> xarray.Dataset:
    """Run the study of all caches."""
    mesh = vr.Mesh(nodes_per_revolution=100, max_order=50)
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    softer = vr.StandardLinearSolid(instantaneous_modulus=5.9e6, relaxed_modulus=3e6, relaxation_time=0.125)

    def ball(modulus: vr.StandardLinearSolid) -> vr.CoatedSphere:
        layer = vr.Layer(thickness=1e-3, shear_modulus=modulus, poisson_ratio=0.5)
        return vr.CoatedSphere(core_radius=20e-3, layers=[layer])

    return vr.sweep(
        ball,
        modulus=vr.materials.Draws(rubber, [rubber, softer]),
        load=paper.LOAD,
        angular_speed=speeds,
        mesh=mesh,
        fields=["pressure"],
        cache=cache,
        retry_failed=retry_failed,
        progress=False,
    )


def check(seed: int, folder: Path) -> str | None:
    """Damage a cache, run its study again, and judge the result.

    Parameters
    ----------
    seed : int
        Seed of the damage.
    folder : Path
        Folder of the files.

    Returns
    -------
    str or None
        Description of the failure in one line, or None: the numbers are the same, or the error is clear and following
        its advice gives the same numbers.
    """
    random_of = random.Random(seed)
    files = dict(random_of.choice(_originals()))
    kind = random_of.choice([*_OF_BYTES, *_OF_ROWS, *_OF_FILES])
    for name in (_STUDY, _POINTS, f"{_POINTS}-journal"):
        (folder / name).unlink(missing_ok=True)
    if kind in _OF_BYTES:
        name = random_of.choice(sorted(files))
        files[name] = kind(random_of, files[name])
    elif kind in _OF_FILES:
        kind(random_of, files)
    for name, content in files.items():
        (folder / name).write_bytes(content)
    if kind in _OF_ROWS:
        with contextlib.closing(sqlite3.connect(folder / _POINTS, isolation_level=None)) as database:
            kind(random_of, database)
    start = time.monotonic()
    found = _judged(folder)
    if (seconds := time.monotonic() - start) > _LONGEST:
        found = found or f"takes {seconds:.0f} s"
    return None if found is None else f"{kind.__name__}: {found}"


def _judged(folder: Path) -> str | None:
    """Return what is wrong with the study of a damaged cache: its result, or its error and the advice."""
    advised = ""
    for retry_failed in (False, True):
        try:
            found = study(folder / _STUDY, retry_failed=retry_failed)
        except (ValueError, OSError) as error:
            advised = str(error)
        except Exception as error:
            return f"raises {type(error).__name__}: {error}"
        else:
            return _difference(found)
        if str(folder / _STUDY) not in advised:
            return f"error does not name the file: {advised}"
        if "\n" in advised or not advised.isprintable() or len(advised) > 500:
            return f"error is not one readable line: {advised!r}"
        if "retry_failed" not in advised:
            break
    if "delete it" not in advised:
        return f"error does not say what to do: {advised}"
    for name in (_STUDY, _POINTS) if f"{_POINTS} is damaged" in advised or "made by" in advised else (_STUDY,):
        (folder / name).unlink(missing_ok=True)
    try:
        return _difference(study(folder / _STUDY, retry_failed=True))
    except Exception as error:
        return f"deletion does not fix the cache: {type(error).__name__}: {error}"


def _difference(found: xarray.Dataset) -> str | None:
    try:
        xarray.testing.assert_identical(found.assign_attrs(_right_numbers().attrs), _right_numbers())
    except AssertionError as error:
        return f"numbers differ: {' '.join(str(error).split())[:200]}"
    return None


@functools.cache
def _right_numbers() -> xarray.Dataset:
    return study(None)


@functools.cache
def _originals() -> tuple[_Files, ...]:
    """Return caches of a complete study, of an incomplete one, and of one after a study of other points."""
    found = []
    for before, after in ((None, _SPEEDS), (_SPEEDS[:2], None), ((1.0, 16.0), _SPEEDS)):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / _STUDY
            for speeds in filter(None, (before, after)):
                study(path, speeds=speeds)
            if after is None:
                path.unlink()
            found.append({file.name: file.read_bytes() for file in Path(folder).iterdir()})
    return tuple(found)


def _flipped(random_of: random.Random, content: bytes) -> bytes:
    """Change bits anywhere, or in the header."""
    changed = bytearray(content)
    end = random_of.choice([100, 1024, len(changed), len(changed), len(changed)])
    for _ in range(random_of.choice([1, 1, 2, 8, 64])):
        changed[random_of.randrange(min(end, len(changed)))] ^= 1 << random_of.randrange(8)
    return bytes(changed)


def _replaced(random_of: random.Random, content: bytes) -> bytes:
    """Change bytes anywhere."""
    changed = bytearray(content)
    for _ in range(random_of.choice([1, 4, 32])):
        changed[random_of.randrange(len(changed))] = random_of.choice([0, 1, 127, 128, 255, random_of.randrange(256)])
    return bytes(changed)


def _truncated(random_of: random.Random, content: bytes) -> bytes:
    size = random_of.randrange(len(content))
    return content[: random_of.choice([0, size, size - size % _PAGE])]


def _extended(random_of: random.Random, content: bytes) -> bytes:
    return content + random_of.randbytes(random_of.choice([1, 100, _PAGE, 3 * _PAGE]))


def _erased(random_of: random.Random, content: bytes) -> bytes:
    """Set a block to zeros or to noise."""
    size = random_of.choice([16, 512, _PAGE])
    first = random_of.randrange(0, len(content), size)
    block = random_of.choice([bytes(size), random_of.randbytes(size)])
    return content[:first] + block[: len(content) - first] + content[first + size :]


def _shifted(random_of: random.Random, content: bytes) -> bytes:
    """Insert or delete bytes."""
    first, size = random_of.randrange(len(content)), random_of.choice([1, 7, 512])
    if random_of.random() < 0.5:
        return content[:first] + content[first + size :]
    return content[:first] + random_of.randbytes(size) + content[first:]


def _pages_swapped(random_of: random.Random, content: bytes) -> bytes:
    """Exchange two pages of the database, or copy one over another."""
    pages = [content[i : i + _PAGE] for i in range(0, len(content), _PAGE)]
    a, b = random_of.randrange(len(pages)), random_of.randrange(len(pages))
    pages[a], pages[b] = pages[b], random_of.choice([pages[a], pages[b]])
    return b"".join(pages)


def _other_content(random_of: random.Random, content: bytes) -> bytes:
    return random_of.choice([b"", b"important", b"text\n" * 1000, random_of.randbytes(len(content)), content[::-1]])


def _one_missing(random_of: random.Random, files: _Files) -> None:
    del files[random_of.choice(sorted(files))]


def _files_swapped(random_of: random.Random, files: _Files) -> None:
    files[_STUDY], files[_POINTS] = files[_POINTS], files.get(_STUDY, b"")


def _with_journal(random_of: random.Random, files: _Files) -> None:
    """Add a journal next to the database, as a killed process leaves it."""
    content = random_of.choice(
        [random_of.randbytes(2000), bytes.fromhex("d9d505f920a163d7") + random_of.randbytes(2000)]
    )
    files[f"{_POINTS}-journal"] = content


def _of_another_cache(random_of: random.Random, files: _Files) -> None:
    """Replace one of the two files by that of another cache."""
    other = random_of.choice(_originals())
    name = random_of.choice(sorted(files))
    files[name] = other.get(name, files[name])


def _row_changed(random_of: random.Random, database: sqlite3.Connection) -> None:
    """Write another value to a column of a point."""
    column = random_of.choice(["scalars", "fields", "draws", "error", "checksum", "key"])
    (key,) = random_of.choice(database.execute("SELECT key FROM point").fetchall())
    (value,) = database.execute(f"SELECT {column} FROM point WHERE key = ?", (key,)).fetchone()
    if isinstance(value, str):
        digits = [i for i, character in enumerate(value) if character.isdigit()]
        i = random_of.choice(digits) if digits else 0
        value = random_of.choice([value[:i] + str(random_of.randrange(10)) + value[i + 1 :], value + "x", "", 7, b"x"])
    else:
        value = random_of.choice([_flipped(random_of, value), value[:-1], b"", "text"])
    database.execute(f"UPDATE OR REPLACE point SET {column} = ? WHERE key = ?", (value, key))


def _rows_mixed(random_of: random.Random, database: sqlite3.Connection) -> None:
    """Copy values of another point, with or without the checksum."""
    columns = random_of.choice(
        [["scalars"], ["fields"], ["draws"], ["scalars", "fields", "draws", "error", "checksum"]]
    )
    keys = database.execute("SELECT key FROM point").fetchall()
    (one,), (other,) = random_of.sample(keys, 2)
    for column in columns:
        database.execute(
            f"UPDATE point SET {column} = (SELECT {column} FROM point WHERE key = ?) WHERE key = ?", (other, one)
        )


def _rows_missing(random_of: random.Random, database: sqlite3.Connection) -> None:
    keys = database.execute("SELECT key FROM point").fetchall()
    for (key,) in random_of.sample(keys, random_of.randint(1, len(keys))):
        database.execute("DELETE FROM point WHERE key = ?", (key,))


def _other_tables(random_of: random.Random, database: sqlite3.Connection) -> None:
    """Change the tables, the version or the application id of the database."""
    statements = [
        "DROP TABLE point",
        "DROP TABLE written",
        "DROP TABLE made_by",
        "DELETE FROM study_checksum",
        "DELETE FROM made_by",
        "UPDATE made_by SET text = '0.0.1, commit 1234567'",
        "UPDATE made_by SET text = char(10, 27, 0, 955) || text",
        "UPDATE made_by SET text = zeroblob(3)",
        "ALTER TABLE point ADD COLUMN more TEXT",
        "ALTER TABLE point RENAME COLUMN scalars TO numbers",
        "ALTER TABLE point DROP COLUMN checksum",  # database without checksums, as in old versions
        "CREATE TABLE more (text TEXT)",
        "PRAGMA application_id = 7",
        "PRAGMA journal_mode = WAL",
    ]
    database.execute(random_of.choice(statements))


_OF_BYTES: tuple[Callable[[random.Random, bytes], bytes], ...] = (
    _flipped,
    _replaced,
    _truncated,
    _extended,
    _erased,
    _shifted,
    _pages_swapped,
    _other_content,
)
_OF_FILES: tuple[Callable[[random.Random, _Files], None], ...] = (
    _one_missing,
    _files_swapped,
    _with_journal,
    _of_another_cache,
)
_OF_ROWS: tuple[Callable[[random.Random, sqlite3.Connection], None], ...] = (
    _row_changed,
    _rows_mixed,
    _rows_missing,
    _other_tables,
)
