"""Output files of results: CSV tables, netCDF, pictures and text, each written completely or not at all."""

from __future__ import annotations

import contextlib
import csv
import errno
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from .errors import InvalidInput
from .extras import extra
from .text import shown

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

__all__ = ["draft_of", "ending_in", "save", "save_picture", "write_csv", "write_netcdf", "write_text"]

_Saved = TypeVar("_Saved")


def ending_in(suffixes: Collection[str], path: str | Path, *, name: str = "path") -> Path:
    """Return a path that ends in one of `suffixes`, in upper or lower case; raise a ValueError for others."""
    path = Path(path)
    if path.suffix.lower() not in suffixes:
        *others, last = suffixes
        allowed = " or ".join(filter(None, [", ".join(others), last]))
        raise InvalidInput(name, f"must end in {allowed}", shown(path.name))
    return path


def save(saved: _Saved, path: str | Path, formats: Mapping[str, Callable[[_Saved, Path], object]]) -> None:
    """Write a file with the function of `formats` for the suffix of the path; raise a ValueError for others."""
    path = ending_in(formats, path)
    formats[path.suffix.lower()](saved, path)


@contextlib.contextmanager
def draft_of(path: Path) -> Iterator[Path]:
    """Open a block that writes a draft of a file, which replaces the file when the block ends without an error.

    Yields
    ------
    Path
        Path of the draft, in the folder of the file and with its suffix. The draft is removed if the block fails.

    Raises
    ------
    OSError
        If the block raises an OSError. The name of the file is added, which libraries omit for a full disk.
    """
    target = path.resolve()  # replace the target of a symbolic link, not the link
    draft = target.with_name(f"{target.stem}.writing{target.suffix}")
    try:
        yield draft
        draft.replace(target)
    except OSError as error:
        if error.filename not in (None, str(draft)):  # the error concerns another file
            raise
        reason = error.strerror or f"cannot be written, the disk may be full ({error})"
        raise OSError(error.errno or errno.EIO, reason, str(path)) from None
    finally:
        with contextlib.suppress(OSError):
            draft.unlink()


def write_csv(columns: Mapping[str, Sequence[Any]], path: Path) -> None:
    """Write columns of equal lengths as CSV, below their names, which contain the units."""
    with draft_of(path) as draft, draft.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))


def save_picture(figure: Figure, path: Path) -> None:
    """Write a figure in the format that the suffix of the path gives."""
    content = BytesIO()  # if writing fails, matplotlib raises errors that hide those of the file
    figure.savefig(content, format=path.suffix.lower().removeprefix("."), dpi=150)
    with draft_of(path) as draft:
        draft.write_bytes(content.getvalue())


def write_text(text: str, path: Path) -> None:
    """Write a text as UTF-8."""
    with draft_of(path) as draft:
        draft.write_text(text, encoding="utf-8")


def write_netcdf(dataset: xarray.Dataset, path: Path, *, encoding: Mapping[str, Any] | None = None) -> None:
    """Write a dataset as netCDF; `encoding` is the argument of ``xarray.Dataset.to_netcdf``."""
    with extra("files"):
        import netCDF4  # noqa: F401  (xarray writes with it)
    with draft_of(path) as draft:
        draft.touch()  # raises the true error; netCDF4 reports a PermissionError also for a full disk
        try:
            dataset.to_netcdf(draft, engine="netcdf4", encoding=encoding)
        except (OSError, RuntimeError) as error:
            if isinstance(error, RuntimeError) and not str(error).startswith("NetCDF: "):
                raise
            raise OSError(f"netCDF4: {error}") from None
