"""Interactive page for cases, which this machine serves and solves (the extra `viscoroll[cli]`)."""

from .answer import answer, scalars
from .server import PageServer, serve

__all__ = ["PageServer", "answer", "scalars", "serve"]
