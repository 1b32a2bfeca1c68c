"""Tables and figures of the paper: common interface, execution, comparison and output files."""

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

#: Columns of a CSV file by their headings, which include the units.
Table = Mapping[str, Sequence[Any]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """Comparison of one statement of the paper with the computed result.

    Attributes
    ----------
    statement : str
        Statement of the paper.
    found : str
        Computed result, with numbers.
    agrees : bool
        Whether the two agree.
    unclear : str
        Reason why the comparison is inconclusive, or the empty string.
    by_mesh : bool
        Whether the comparison depends on the mesh of the runner.
    """

    statement: str
    found: str
    agrees: bool
    unclear: str = ""
    by_mesh: bool = True

    @property
    def judgment(self) -> str:
        """Result of the comparison, "agrees" or "disagrees", or the reason why it is inconclusive."""
        return self.unclear or ("agrees" if self.agrees else "disagrees")

    def __str__(self) -> str:
        """Return judgment, statement and result in one line."""
        return f"{self.judgment}: {self.statement}: {self.found}"


class Outcome(Protocol):
    """Computed numbers of a table or figure."""

    def tables(self) -> Mapping[str, Table]:
        """Return the tables of the CSV files, by the suffix after the name of the item; '' is the main table."""

    def draw(self) -> Figure:
        """Plot the numbers."""

    def verdicts(self) -> list[Verdict]:
        """Compare the numbers with the statements of the paper."""


class Runner:
    """Resolution and threads of the computations, with one solve per thread.

    Parameters
    ----------
    coarse : bool, default False
        Whether to use a coarse mesh and few points, which takes seconds; otherwise the paper's Δ = π/250 and N_t = 500.
    workers : int, optional
        Number of threads; by default one per core.
    progress : bool or callable, optional
        True prints a progress bar. A callable is called as progress(stage, fraction) after every solve, with the
        completed fraction of the solves of a stage.
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
        """Call a function with every point, in parallel, and return the values in order."""
        return run_all(function, points, workers=self._workers, progress=self._progress)

    def judge(self, outcome: Outcome) -> list[Verdict]:
        """Return the comparisons for an outcome; those that depend on a coarse mesh are marked as not judged."""
        return [
            replace(verdict, unclear="coarse mesh: not judged") if self.coarse and verdict.by_mesh else verdict
            for verdict in outcome.verdicts()
        ]

    def shared(self, compute: Callable[[Runner], T]) -> T:
        """Return the result of `compute` for this runner, computed only once, since some items use the same numbers."""
        if compute not in self._memory:
            self._memory[compute] = compute(self)
        value: T = self._memory[compute]
        return value


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """Table or figure of the paper.

    Attributes
    ----------
    name : str
        Name on the command line: table2, figure12, ...
    title : str
        Short description.
    compute : callable
        Function compute(runner) → Outcome.
    """

    name: str
    title: str
    compute: Callable[[Runner], Outcome]


def write_files(item: Item, outcome: Outcome, folder: Path) -> list[Path]:
    """Write plots (PNG and SVG) and numbers (CSV) of an item to an existing folder, and return the paths."""
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
    """Write the comparisons of all items as a Markdown table."""
    lines = ["| item | statement of the paper | viscoroll | verdict |", "|---|---|---|---|"]
    for name, rows in verdicts.items():
        for index, verdict in enumerate(rows):
            judged = "**disagrees**" if verdict.judgment == "disagrees" else verdict.judgment
            lines.append(f"| {name if index == 0 else ''} | {verdict.statement} | {verdict.found} | {judged} |")
    write_text("\n".join(lines) + "\n", path)
