"""The option `--cite`."""

from __future__ import annotations

from .._support.citation import bibtex
from .._support.extras import extra

with extra("cli"):
    import typer

__all__ = ["print_citation"]


def print_citation(wanted: bool) -> None:
    """Print how to cite viscoroll, and exit, if it is wanted."""
    if wanted:
        typer.echo(bibtex(), nl=False)
        raise typer.Exit
