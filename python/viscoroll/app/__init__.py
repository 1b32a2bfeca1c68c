"""Interactive page for cases, which this machine serves and solves (the extra `viscoroll[cli]`)."""

from .answer import answer, scalars
from .history import history_answer, history_scalars
from .server import PageServer, serve

__all__ = ["PageServer", "answer", "history_answer", "history_scalars", "scalars", "serve"]
