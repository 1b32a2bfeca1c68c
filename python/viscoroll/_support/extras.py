"""Packages that only some parts of viscoroll need, imported where they do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import TracebackType

__all__ = ["extra"]


@dataclass(frozen=True, slots=True)
class extra:  # noqa: N801  (read as a word of the language: `with extra("plot"): import matplotlib`)
    """Import packages of an extra, with a message that says how to get them.

    Parameters
    ----------
    name : str
        The extra of viscoroll that installs them.

    Raises
    ------
    ImportError
        Where one is not installed, with the command that installs it; its `name` is the package.

    Examples
    --------
    >>> with extra("plot"):
    ...     import a_package_that_nobody_has
    Traceback (most recent call last):
    ...
    ImportError: this needs a_package_that_nobody_has: pip install 'viscoroll[plot]'
    """

    name: str

    def __enter__(self) -> None:
        """Begin."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        """Name extra and command where a package is missing."""
        if isinstance(error, ModuleNotFoundError) and error.name is not None:
            package = error.name.partition(".")[0]
            if package != "viscoroll":
                raise ImportError(f"this needs {package}: pip install 'viscoroll[{self.name}]'", name=package) from None
