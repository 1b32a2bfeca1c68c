"""The command line (the extra `viscoroll[cli]`)."""

from .app import app, run

__all__ = ["app", "run"]
