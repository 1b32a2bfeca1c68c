"""Entry point of the command line. If its extra is not installed, a message says how to install it."""

from __future__ import annotations

import sys

__all__ = ["main"]


def main() -> None:
    """Run the command line; Ctrl-C ends it with exit code 130 and no traceback, from the first import on."""
    try:
        _run()
    except KeyboardInterrupt:
        sys.exit(130)


def _run() -> None:
    try:
        from .cli import run
    except ImportError as error:
        sys.exit(f"viscoroll: the command line requires {error.name}, not installed: pip install 'viscoroll[cli,plot]'")
    run()


if __name__ == "__main__":
    main()
