"""The command `viscoroll example`, which prints files to start from."""

from __future__ import annotations

from typing import Annotated

from .._support.extras import extra
from ..case import example_text

with extra("cli"):
    import typer

__all__ = ["example"]


def example(
    with_sweep: Annotated[bool, typer.Option("--sweep", help="Append the table of a study.")] = False,
    with_design: Annotated[bool, typer.Option("--design", help="Append the table of `viscoroll design`.")] = False,
    motion: Annotated[bool, typer.Option("--motion", help="Print a file for `viscoroll roll` instead.")] = False,
    measured: Annotated[
        bool, typer.Option("--measured", help="Print invented measurements for `viscoroll compare` instead.")
    ] = False,
) -> None:
    """Print a commented case file to start from: viscoroll example > case.toml."""
    tables = [name for name, wanted in (("sweep", with_sweep), ("design", with_design)) if wanted]
    others = [name for name, wanted in (("motion", motion), ("measured", measured)) if wanted]
    if len(others) + bool(tables) > 1:
        options = " and ".join(f"--{name}" for name in [*tables, *others])
        raise ValueError(
            f"--sweep and --design extend a case file; --motion and --measured must be given alone, got {options}"
        )
    names = others or ["case", *tables]
    typer.echo("".join(example_text(name) for name in names), nl=False)  # type: ignore[arg-type]
