"""What every table and figure has in common: where it is computed, what it hands back, and its files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from .._support.files import save_picture, write_csv, write_text
from .._support.progress import ProgressLike
from ..bodies import Mesh
from ..studies.runner import run_all

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["Item", "Outcome", "Runner", "Table", "Verdict", "write_files", "write_verdicts"]

S = TypeVar("S")
T = TypeVar("T")

#: Columns of a CSV file by their heads, which hold the units.
Table = Mapping[str, Sequence[Any]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """One statement of the paper beside what was computed.

    Attributes
    ----------
    statement : str
        What the paper prints.
    found : str
        What was computed, with numbers.
    agrees : bool
        Whether the two agree.
    unclear : str
        Why that says nothing of the paper, or the empty text.
    by_mesh : bool
        Whether the mesh of the runner decides.
    """

    statement: str
    found: str
    agrees: bool
    unclear: str = ""
    by_mesh: bool = True

    @property
    def judgment(self) -> str:
        """Agrees, disagrees, or why neither can be said."""
        return self.unclear or ("agrees" if self.agrees else "disagrees")

    def __str__(self) -> str:
        """Return one line."""
        return f"{self.judgment}: {self.statement}: {self.found}"


class Outcome(Protocol):
    """Numbers of a table or figure."""

    def tables(self) -> Mapping[str, Table]:
        """Return CSV files by what is added to the item's name; '' is the main one."""

    def draw(self) -> Figure:
        """Draw the numbers."""

    def verdicts(self) -> list[Verdict]:
        """Judge them by what the paper says."""


class Runner:
    """Where items are computed: the resolution, and threads with one solve on each.

    Parameters
    ----------
    coarse : bool, default False
        A coarse mesh and few points, to try everything out in seconds; else the paper's Δ = π/250 and N_t = 500.
    workers : int, optional
        Number of threads; by default one for each core.
    progress : bool or callable, optional
        True shows a bar; or called as progress(stage, fraction) after every solve, with the share of those of a kind.
    """

    def __init__(
        self,
        *,
        coarse: bool = False,
        workers: int | None = None,
        progress: ProgressLike = None,
    ) -> None:
        self.coarse = coarse
        nodes, order = (300, 300) if coarse else (500, 500)
        self.mesh = Mesh(nodes_per_revolution=nodes, max_order=order)
        self._workers = workers
        self._progress = progress
        self._memory: dict[Callable[[Runner], Any], Any] = {}

    def map(self, function: Callable[[S], T], points: Iterable[S]) -> list[T]:
        """Call the function with every point, on threads; return the values in order."""
        return run_all(function, points, workers=self._workers, progress=self._progress)

    def judge(self, outcome: Outcome) -> list[Verdict]:
        """Return the verdicts on an outcome of this runner: a coarse mesh is no witness for or against the paper."""
        return [
            replace(verdict, unclear="coarse mesh: not judged") if self.coarse and verdict.by_mesh else verdict
            for verdict in outcome.verdicts()
        ]

    def shared(self, compute: Callable[[Runner], T]) -> T:
        """Return what `compute` makes of this runner, computed once: some items draw the same numbers."""
        if compute not in self._memory:
            self._memory[compute] = compute(self)
        value: T = self._memory[compute]
        return value


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """A table or figure of the paper.

    Attributes
    ----------
    name : str
        As on the command line: table2, figure12, …
    title : str
        What it shows.
    compute : callable
        compute(runner) → Outcome.
    """

    name: str
    title: str
    compute: Callable[[Runner], Outcome]


def write_files(item: Item, outcome: Outcome, folder: Path) -> list[Path]:
    """Write pictures (PNG and SVG) and numbers (CSV) of an item to a folder, which must exist."""
    paths = []
    figure = outcome.draw()
    for suffix in ("png", "svg"):
        paths.append(folder / f"{item.name}.{suffix}")
        save_picture(figure, paths[-1])
    for addition, table in outcome.tables().items():
        paths.append(folder / f"{item.name}{addition}.csv")
        write_csv(table, paths[-1])
    return paths


def write_verdicts(path: Path, verdicts: Mapping[str, Sequence[Verdict]]) -> None:
    """Write the verdicts on each item as a table in Markdown."""
    lines = ["| | the paper | found | |", "|---|---|---|---|"]
    for name, rows in verdicts.items():
        for place, verdict in enumerate(rows):
            judged = "**disagrees**" if verdict.judgment == "disagrees" else verdict.judgment
            lines.append(f"| {name if place == 0 else ''} | {verdict.statement} | {verdict.found} | {judged} |")
    write_text("\n".join(lines) + "\n", path)
