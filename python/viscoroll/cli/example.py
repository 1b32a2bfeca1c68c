"""The command `viscoroll example`, which prints files to start from."""

from __future__ import annotations

from typing import Annotated

from .._support.extras import extra

with extra("cli"):
    import typer

__all__ = ["example"]


def example(
    wheel: Annotated[bool, typer.Option("--wheel", help="Print a wheel with a tread.")] = False,
    rollers: Annotated[bool, typer.Option("--rollers", help="Print a covered roller on a steel roller.")] = False,
    half_space: Annotated[bool, typer.Option("--half-space", help="Print a rigid ball on a half-space.")] = False,
    thermal: Annotated[bool, typer.Option("--thermal", help="Print a wheel that heats itself.")] = False,
    with_sweep: Annotated[bool, typer.Option("--sweep", help="Append the table of a study.")] = False,
    with_design: Annotated[bool, typer.Option("--design", help="Append the table of `viscoroll design`.")] = False,
    motion: Annotated[bool, typer.Option("--motion", help="Print a file for `viscoroll roll` instead.")] = False,
    sliding: Annotated[bool, typer.Option("--sliding", help="Print a file for `viscoroll slide` instead.")] = False,
    measured: Annotated[
        bool, typer.Option("--measured", help="Print invented measurements for `viscoroll compare` instead.")
    ] = False,
) -> None:
    """Print a commented case file to start from, by default of a coated ball: viscoroll example > case.toml."""
    from ..case import example_text
    from ..case.examples import generated_example

    tables = [name for name, wanted in (("sweep", with_sweep), ("design", with_design)) if wanted]
    generated = {"wheel": wheel, "rollers": rollers, "half-space": half_space, "thermal": thermal}
    others = [
        name
        for name, wanted in (generated | {"motion": motion, "sliding": sliding, "measured": measured}).items()
        if wanted
    ]
    if len(others) + bool(tables) > 1:
        options = " and ".join(f"--{name}" for name in [*tables, *others])
        raise ValueError(
            f"--sweep and --design extend a case file; the other options must be given alone, got {options}"
        )
    if others and others[0] in generated:
        typer.echo(generated_example(others[0]), nl=False)
        return
    names = others or ["case", *tables]
    typer.echo("".join(example_text(name) for name in names), nl=False)  # type: ignore[arg-type]
