"""Figure 8: the resisting torque after a sudden start, at many coefficients of friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Start
from .._support.pictures import Picture
from ..bodies import Mesh
from ..transient import roll
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from ..transient import History

__all__ = ["Figure8", "compute_figure8"]

#: Ω of section 14.3 [rad/s].
_SPEED = 0.2
_FRICTIONS = (0.0, 0.1, 0.3, 0.5, 1.0, 2.0)
_COARSE = (0.0, 0.5, 2.0)
_TURN = 0.6  # [rad]: 3 s
_NOTHING = 1e-3  # of an overshoot [-]
_NODES, _COARSE_NODES = 300, 240


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure8:
    """Histories by starting state and coefficient of friction."""

    histories: dict[tuple[Start, float], History]

    def overshoot(self, start: Start, friction: float) -> float:
        """How far the largest torque lies above the last one [-]."""
        torque = self.histories[start, friction].resisting_torque
        return float(torque.max() / torque[-1]) - 1.0

    def overshoots(self, start: Start) -> list[float]:
        """Overshoots by rising friction."""
        return [self.overshoot(start, friction) for known, friction in self.histories if known is start]

    def tables(self) -> dict[str, Table]:
        """Return a row for each start and coefficient, and the histories."""
        keys = list(self.histories)
        rows = [(key, i) for key in keys for i in range(len(self.histories[key].time))]
        return {
            "": {
                "start": [start.name for start, _ in keys],
                "friction [1]": [friction for _, friction in keys],
                "last_torque [N m]": [float(self.histories[key].resisting_torque[-1]) for key in keys],
                "overshoot [1]": [self.overshoot(*key) for key in keys],
            },
            "-histories": {
                "start": [start.name for (start, _), _ in rows],
                "friction [1]": [friction for (_, friction), _ in rows],
                "time [s]": [float(self.histories[key].time[i]) for key, i in rows],
                "resisting_torque [N m]": [float(self.histories[key].resisting_torque[i]) for key, i in rows],
            },
        }

    def draw(self) -> Picture:
        """Torque over time, for both starting states."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        titles = {Start.FRESH: "pressed on in no time", Start.RELAXED: "has borne the load for ever"}
        for axes, (start, title) in zip(figure.subplots(1, 2, sharey=True), titles.items(), strict=True):
            for (known, friction), history in self.histories.items():
                if known is start:
                    axes.plot(history.time, history.resisting_torque * 1e3, label=f"$μ$ = {friction:g}")
            axes.set(title=title, xlabel="time [s]")
        figure.axes[0].set_ylabel("$T_r$ [mN m]")
        figure.axes[0].legend(fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Judge what the text says of the overshoot, for both starting states."""
        verdicts = []
        for start in (Start.FRESH, Start.RELAXED):
            overshoots = self.overshoots(start)
            rises = bool(np.all(np.diff(overshoots) > -_NOTHING)) and overshoots[-1] > _NOTHING
            verdicts.append(
                Verdict(
                    statement=f"the overshoot increases with μ ({start.name} start)",
                    found=", ".join(f"{overshoot:.2%}" for overshoot in overshoots)
                    + f" at μ = {', '.join(f'{friction:g}' for known, friction in self.histories if known is start)}",
                    agrees=rises,
                    unclear="" if rises else "unclear: the text does not say how the load was put on",
                )
            )
        return verdicts


def compute_figure8(runner: Runner) -> Figure8:
    """Start at once at every coefficient, from both states; node by node, so that no staircase blurs the overshoot."""
    ball = paper.ball()
    mesh = Mesh(nodes_per_revolution=_COARSE_NODES if runner.coarse else _NODES)
    angle = np.arange(int(_TURN / mesh.spacing) + 1) * mesh.spacing

    def history(key: tuple[Start, float]) -> History:
        start, friction = key
        return roll(
            ball,
            time=angle / _SPEED,
            angle=angle,
            load=paper.LOAD,
            start=start,
            friction=friction,
            compliance=Compliance.VERTICAL,
            mesh=mesh,
            lattices=1,
            steps_per_spacing=None,
            threads=1,
        )

    keys = [(start, mu) for start in (Start.FRESH, Start.RELAXED) for mu in (_COARSE if runner.coarse else _FRICTIONS)]
    return Figure8(histories=dict(zip(keys, runner.map(history, keys), strict=True)))
