"""Entry of the command line; names the extra that it needs where that is not installed."""

from __future__ import annotations

import sys

__all__ = ["main"]


def main() -> None:
    """Run the command line."""
    try:
        from .cli import run
    except ImportError as error:
        sys.exit(f"viscoroll: the command line needs {error.name}: pip install 'viscoroll[cli,plot]'")
    run()


if __name__ == "__main__":
    main()
