"""Report of a case as one HTML file (the extras `viscoroll[cli,plot]`)."""

from .page import report_of

__all__ = ["report_of"]
