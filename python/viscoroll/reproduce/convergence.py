"""Table 2: resisting torque of the example for several meshes and truncation orders."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Curvature
from .._support.pictures import Picture
from ..rolling import solve
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from ..rolling import Result

__all__ = ["Table2", "arc_torque", "compute_table2"]

#: Largest relative deviation from the printed torques for which table 2 counts as reproduced [-], by moment arm.
TOLERANCE = {"x": 0.005, "arc": 0.0025}

#: Nodes per revolution from which on the paper considers its results as converged.
_FINE = 500

Key = tuple[int, int]


@dataclass(frozen=True, slots=True, kw_only=True)
class Table2:
    """Torques [N m] by nodes per revolution and truncation order, with x and with the arc length as the moment arm."""

    by_x: dict[Key, float]
    by_arc: dict[Key, float]

    def deviations(self, torques: dict[Key, float]) -> dict[Key, float]:
        """Return the relative deviations from the printed torques [-]."""
        return {key: torque / paper.TABLE_2[key] - 1.0 for key, torque in torques.items()}

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each entry."""
        x, arc = self.deviations(self.by_x), self.deviations(self.by_arc)
        return {
            "": {
                "nodes_per_revolution [1]": [nodes for nodes, _ in self.by_x],
                "max_order [1]": [order for _, order in self.by_x],
                "printed_torque [N m]": [paper.TABLE_2[key] for key in self.by_x],
                "torque [N m]": list(self.by_x.values()),
                "torque_by_arc [N m]": list(self.by_arc.values()),
                "deviation [1]": list(x.values()),
                "deviation_by_arc [1]": list(arc.values()),
            }
        }

    def draw(self) -> Picture:
        """Plot computed and printed torques, and their deviations for both moment arms."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        torque, deviation = figure.subplots(1, 2)
        orders = sorted({order for _, order in self.by_x})
        rows = sorted({nodes for nodes, _ in self.by_x})
        for position, order in enumerate(orders):
            nodes = [n for n, o in self.by_x if o == order]
            torque.plot(
                nodes, [self.by_x[n, order] * 1e3 for n in nodes], ".-", color=f"C{position}", label=f"$N_t$ = {order}"
            )
            torque.plot(nodes, [paper.TABLE_2[n, order] * 1e3 for n in nodes], "x", color=f"C{position}")
        torque.plot([], [], "kx", label="printed")
        torque.set(xlabel="nodes per revolution $2π/Δ$", ylabel="$T_r$ [mN m]", xticks=rows)
        torque.legend(fontsize="small")
        column = {nodes: index for index, nodes in enumerate(rows)}
        for torques, color, label, shift in (
            (self.by_x, "tab:blue", "moment arm $x$", -0.12),
            (self.by_arc, "tab:orange", "moment arm $r_o(π/2 - φ)$", 0.12),
        ):
            found = self.deviations(torques)
            deviation.plot(
                [column[n] + shift for n, _ in found],
                [v * 100.0 for v in found.values()],
                ".",
                color=color,
                label=label,
            )
        deviation.axhline(0.0, color="0.5", linewidth=0.8)
        deviation.axhspan(-0.05, 0.05, color="0.5", alpha=0.2, label="rounding of the printed numbers")
        deviation.set_xticks(range(len(rows)), [f"π/{nodes // 2}" for nodes in rows])
        deviation.set(xlabel="spacing $Δ$", ylabel="deviation from the printed torque [%]")
        deviation.legend(fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare each entry on its own mesh, and the two statements on convergence."""
        x, arc = (np.abs(list(self.deviations(t).values())) for t in (self.by_x, self.by_arc))
        found = [
            Verdict(
                statement=f"{len(x)} torques",
                found=f"all within {x.max() * 100.0:.2f} %",
                agrees=bool(x.max() <= TOLERANCE["x"]),
                by_mesh=False,
            ),
            Verdict(
                statement=f"{len(x)} torques, with the paper's moment arm (arc length)",
                found=f"all within {arc.max() * 100.0:.2f} %, {int((arc <= 1e-3).sum())} within 0.1 %",
                agrees=bool(arc.max() <= TOLERANCE["arc"]),
                by_mesh=False,
            ),
            self._spread("all torques within 10 % of each other", 0, 0.10),
        ]
        fine = max(nodes for nodes, _ in self.by_x) >= _FINE
        return found + (
            [self._spread("torques for Δ ≤ π/250 within 0.6 % of each other", _FINE, 0.006)] if fine else []
        )

    def _spread(self, statement: str, nodes: int, bound: float) -> Verdict:
        """Compare the relative spread of entries with at least `nodes` nodes with a bound, to a tenth of a percent."""
        spreads = []
        for table in (self.by_x, paper.TABLE_2):
            torques = [table[key] for key in self.by_x if key[0] >= nodes]
            spreads.append(1.0 - min(torques) / max(torques))
        found = f"within {spreads[0] * 100.0:.2f} % (printed entries: {spreads[1] * 100.0:.2f} %)"
        return Verdict(statement=statement, found=found, agrees=round(spreads[0], 3) <= bound, by_mesh=False)


def arc_torque(result: Result) -> float:
    """Return the moment of the pressure with the arc length r_o (π/2 - φ) as the moment arm [N m].

    The torques of the paper's table 2 suggest that it uses this arm.
    """
    rows = result.pressure.shape[0]
    radius, spacing = result.body.outer_radius, result.mesh.spacing
    arc = radius * spacing * (rows // 2 - np.arange(rows))
    force = result.pressure * (radius * spacing) ** 2
    return float((arc[:, None] * force).sum())


def compute_table2(runner: Runner) -> Table2:
    """Solve on all meshes of the table; a coarse run, on those with up to 300 nodes and 500 orders."""
    meshes = paper.table_2_meshes()
    if runner.coarse:
        meshes = {key: mesh for key, mesh in meshes.items() if key[0] <= 300 and key[1] <= 500}

    def point(key: Key) -> Result:
        return solve(
            paper.ball(),
            load=paper.LOAD,
            angular_speed=paper.ANGULAR_SPEED,
            mesh=meshes[key],
            compliance=Compliance.RADIAL,
            curvature=Curvature.PAPER,
            threads=1,
        )

    results = dict(zip(meshes, runner.map(point, meshes), strict=True))
    return Table2(
        by_x={key: result.resisting_torque for key, result in results.items()},
        by_arc={key: arc_torque(result) for key, result in results.items()},
    )
