"""The page on which cases are tried, served and solved on this machine (the extra `viscoroll[cli]`)."""

from .answer import answer, scalars
from .server import PageServer, serve

__all__ = ["PageServer", "answer", "scalars", "serve"]
