"""Files that results are written to: by the suffix of the path, as a table or as netCDF."""

from __future__ import annotations

import contextlib
import csv
import errno
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from .extras import extra
from .text import shown

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

__all__ = ["draft_of", "ending_in", "save", "save_picture", "write_csv", "write_netcdf", "write_text"]

_Saved = TypeVar("_Saved")


def ending_in(suffixes: Collection[str], path: str | Path, *, name: str = "path") -> Path:
    """Return a path that ends in one of some suffixes, in capitals or not; refuse others."""
    path = Path(path)
    if path.suffix.lower() not in suffixes:
        *others, last = suffixes
        allowed = " or ".join(filter(None, [", ".join(others), last]))
        raise ValueError(f"{name} must end in {allowed}, got {shown(path.name)}")
    return path


def save(saved: _Saved, path: str | Path, formats: Mapping[str, Callable[[_Saved, Path], object]]) -> None:
    """Write a file by that one of some functions, by suffix, which the path names; refuse other suffixes."""
    path = ending_in(formats, path)
    formats[path.suffix.lower()](saved, path)


@contextlib.contextmanager
def draft_of(path: Path) -> Iterator[Path]:
    """Open a block that writes a draft of a file: the file appears complete when the block ends, or not at all.

    Yields
    ------
    Path
        The draft, beside the file and with its suffix. It is removed if the block fails.

    Raises
    ------
    OSError
        If the block raises one, with the name of the file: libraries report a full disk without it.
    """
    target = path.resolve()  # a symbolic link stays one
    draft = target.with_name(f"{target.stem}.writing{target.suffix}")
    try:
        yield draft
        draft.replace(target)
    except OSError as error:
        if error.filename not in (None, str(draft)):  # of another file
            raise
        reason = error.strerror or f"cannot be written, the disk may be full ({error})"
        raise OSError(error.errno or errno.EIO, reason, str(path)) from None
    finally:
        with contextlib.suppress(OSError):
            draft.unlink()


def write_csv(columns: Mapping[str, Sequence[Any]], path: Path) -> None:
    """Write columns of equal lengths, below their names, which hold the units."""
    with draft_of(path) as draft, draft.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))


def save_picture(figure: Figure, path: Path) -> None:
    """Write a figure in the format of the suffix."""
    content = BytesIO()  # where writing fails, matplotlib raises errors that hide those of the file
    figure.savefig(content, format=path.suffix.lower().removeprefix("."), dpi=150)
    with draft_of(path) as draft:
        draft.write_bytes(content.getvalue())


def write_text(text: str, path: Path) -> None:
    """Write a text as UTF-8."""
    with draft_of(path) as draft:
        draft.write_text(text, encoding="utf-8")


def write_netcdf(dataset: xarray.Dataset, path: Path, *, encoding: Mapping[str, Any] | None = None) -> None:
    """Write a dataset as netCDF; `encoding` is that of ``xarray.Dataset.to_netcdf``."""
    with extra("files"):
        import netCDF4  # noqa: F401  (what xarray writes with)
    with draft_of(path) as draft:
        draft.touch()  # raises what is true: netCDF4 reports a PermissionError for a full disk, too
        try:
            dataset.to_netcdf(draft, engine="netcdf4", encoding=encoding)
        except (OSError, RuntimeError) as error:
            if isinstance(error, RuntimeError) and not str(error).startswith("NetCDF: "):
                raise
            raise OSError(f"netCDF4: {error}") from None
