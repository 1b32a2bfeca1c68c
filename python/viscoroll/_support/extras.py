"""Imports of optional packages, which only some parts of viscoroll need."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from types import TracebackType

__all__ = ["extra"]


@dataclass(frozen=True, slots=True)
class extra:  # noqa: N801  (used like a statement: `with extra("plot"): import matplotlib`)
    """Context for imports of packages of an extra; if a package is missing, the error says how to install it.

    Parameters
    ----------
    name : str
        Extra of viscoroll that installs the packages.

    Raises
    ------
    ImportError
        If a package is not installed. The message gives the command that installs it; `name` is the package.

    Examples
    --------
    >>> with extra("plot"):
    ...     import a_missing_package
    Traceback (most recent call last):
    ...
    ImportError: this function requires a_missing_package, which is not installed: pip install 'viscoroll[plot]'
    """

    name: str

    def __enter__(self) -> None:
        """Enter the context."""

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        """Raise an ImportError with the command that installs the extra if a package is missing."""
        if isinstance(error, ModuleNotFoundError) and error.name is not None:
            package = error.name.partition(".")[0]
            if package != "viscoroll":
                raise ImportError(
                    f"this function requires {package}, which is not installed: pip install 'viscoroll[{self.name}]'",
                    name=package,
                ) from None
