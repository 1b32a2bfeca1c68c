"""Figures 6 and 8: resisting torque after a sudden start, for several speeds and coefficients of friction."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Start
from .._support.pictures import Picture
from ..bodies import Mesh
from ..rolling import solve
from ..transient import roll
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..transient import History

__all__ = ["Figure6", "Figure8", "compute_figure6", "compute_figure8"]

#: Starting states, with their titles in the plots.
_STARTS = {Start.UNDEFORMED: "load applied at the start", Start.RELAXED: "relaxed under the load"}

#: Angular speeds Ω of figure 6 [rad/s]. The paper's text states the smallest and the largest one.
_SPEEDS, _COARSE_SPEEDS = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0), (0.5, 2.5, 4.0)
_TURN = 0.8  # rotation [rad]: more than three times the length of the contact
_STEADY = 0.02  # largest relative deviation of a steady torque [-]

#: Angular speed Ω of section 14.3 [rad/s], and coefficients of friction μ of figure 8 [-].
_SPEED = 0.2
_FRICTIONS, _COARSE_FRICTIONS = (0.0, 0.1, 0.3, 0.5, 1.0, 2.0), (0.0, 0.5, 2.0)
_FRICTION_TURN = 0.6  # rotation [rad]: 3 s
_NEGLIGIBLE = 1e-3  # negligible overshoot [-]
_NODES, _COARSE_NODES = 300, 240

#: Starting state, and value of the quantity that varies.
Key = tuple[Start, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class SuddenStarts:
    """Histories by starting state and value of the quantity that varies."""

    histories: dict[Key, History]

    def _columns(self, varied: str) -> tuple[Table, Table]:
        """Return the columns of a table with one row for each history, and of one with one row for each instant."""
        rows = [(key, i) for key, history in self.histories.items() for i in range(len(history.time))]
        return {
            "start": [start.name for start, _ in self.histories],
            varied: [number for _, number in self.histories],
        }, {
            "start": [start.name for (start, _), _ in rows],
            varied: [number for (_, number), _ in rows],
            "time [s]": [float(self.histories[key].time[i]) for key, i in rows],
            "resisting_torque [N m]": [float(self.histories[key].resisting_torque[i]) for key, i in rows],
        }

    def _panels(self, figure: Picture, label: str, *, sharey: bool) -> Iterator[Axes]:
        """Plot the torque over time in one panel for each starting state, and yield the panels."""
        for axes, (start, title) in zip(figure.subplots(1, 2, sharey=sharey), _STARTS.items(), strict=True):
            found = [(number, history) for (known, number), history in self.histories.items() if known is start]
            for index, (number, history) in enumerate(found):
                torque = history.resisting_torque * 1e3
                axes.plot(history.time, torque, color=f"C{index}", label=label.format(number))
            axes.set(title=title, xlabel="time [s]", ylabel="$T_r$ [mN m]")
            yield axes


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure6(SuddenStarts):
    """Histories by starting state and angular speed, and the steady torque at each speed [N m]."""

    steady: dict[float, float]

    def overshoot(self, start: Start, speed: float) -> float:
        """Return the relative excess of the largest torque over the steady one [-]."""
        return float(self.histories[start, speed].resisting_torque.max()) / self.steady[speed] - 1.0

    def settling_time(self, start: Start, speed: float) -> float:
        """Return the time from which on the torque stays within 2 % of the steady one [s]; infinite if it does not."""
        history = self.histories[start, speed]
        away = np.flatnonzero(np.abs(history.resisting_torque / self.steady[speed] - 1.0) > _STEADY)
        last = int(away[-1]) + 1 if len(away) else 0
        return float(history.time[last]) if last < len(history.time) else float("inf")

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each start and speed, and one with the histories."""
        keys, (summary, instants) = list(self.histories), self._columns("angular_speed [rad/s]")
        found = {
            "steady_torque [N m]": [self.steady[speed] for _, speed in keys],
            "overshoot [1]": [self.overshoot(*key) for key in keys],
            "settling_time [s]": [self.settling_time(*key) for key in keys],
        }
        return {"": {**summary, **found}, "-histories": instants}

    def draw(self) -> Picture:
        """Plot the torque over time for both starting states."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        for axes in self._panels(figure, "{:g} rad/s", sharey=False):
            for index, torque in enumerate(self.steady.values()):
                axes.axhline(torque * 1e3, color=f"C{index}", linewidth=0.6, linestyle=":")
            axes.set(xlim=(0.0, 0.8))
        figure.axes[0].legend(fontsize="small", title="dotted: steady", title_fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the paper's text, for both starting states."""
        speeds = list(self.steady)
        verdicts = []
        for start in _STARTS:
            settling = [self.settling_time(start, speed) for speed in speeds]
            verdicts.append(
                Verdict(
                    statement=f"a steady state is reached ({start.name} start)",
                    found=f"within {_STEADY:.0%} after {settling[0]:.2f} s at {speeds[0]:g} rad/s, "
                    f"{settling[-1]:.2f} s at {speeds[-1]:g} rad/s",
                    agrees=all(np.isfinite(settling)),
                )
            )
        undeformed, relaxed = ([self.overshoot(start, s) for s in speeds] for start in _STARTS)
        verdicts.append(
            Verdict(
                statement="the load is applied before rolling starts",
                found="the peak exceeds the steady torque by "
                f"{undeformed[0]:.1%} to {undeformed[-1]:.1%} if the load is applied as rolling starts, "
                f"{relaxed[0]:.0%} to {relaxed[-1]:.0%} if the ball has relaxed under the load",
                agrees=False,
                unclear="unclear: neither the text nor the figure gives numbers",
            )
        )
        return verdicts


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure8(SuddenStarts):
    """Histories by starting state and coefficient of friction."""

    def overshoot(self, start: Start, friction: float) -> float:
        """Return the relative excess of the largest torque over the last one [-]."""
        torque = self.histories[start, friction].resisting_torque
        return float(torque.max() / torque[-1]) - 1.0

    def overshoots(self, start: Start) -> list[float]:
        """Return the overshoots [-] in the order of increasing friction."""
        return [self.overshoot(start, friction) for known, friction in self.histories if known is start]

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each start and coefficient, and one with the histories."""
        keys, (summary, instants) = list(self.histories), self._columns("friction [1]")
        found = {
            "last_torque [N m]": [float(history.resisting_torque[-1]) for history in self.histories.values()],
            "overshoot [1]": [self.overshoot(*key) for key in keys],
        }
        return {"": {**summary, **found}, "-histories": instants}

    def draw(self) -> Picture:
        """Plot the torque over time for both starting states."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        for axes in self._panels(figure, "$μ$ = {:g}", sharey=True):
            axes.label_outer()
        figure.axes[0].legend(fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the paper's text on the overshoot, for both starting states."""
        verdicts = []
        for start in _STARTS:
            overshoots = self.overshoots(start)
            rises = bool(np.all(np.diff(overshoots) > -_NEGLIGIBLE)) and overshoots[-1] > _NEGLIGIBLE
            verdicts.append(
                Verdict(
                    statement=f"the overshoot increases with μ ({start.name} start)",
                    found=", ".join(f"{overshoot:.2%}" for overshoot in overshoots)
                    + f" at μ = {', '.join(f'{friction:g}' for known, friction in self.histories if known is start)}",
                    agrees=rises,
                    unclear="" if rises else "unclear: the text does not state how the load was applied",
                )
            )
        return verdicts


def compute_figure6(runner: Runner) -> Figure6:
    """Start suddenly at every speed, from both states, at the paper's load."""
    ball = paper.ball()
    speeds = _COARSE_SPEEDS if runner.coarse else _SPEEDS
    mesh = Mesh(nodes_per_revolution=runner.mesh.nodes_per_revolution)  # all orders, the same as for the steady torque

    def history(key: Key) -> History:
        start, speed = key
        return roll(
            ball,
            time=[0.0, _TURN / speed],
            angle=[0.0, _TURN],
            load=paper.LOAD,
            start=start,
            mesh=mesh,
            threads=1,
        )

    def steady(speed: float) -> float:
        return solve(ball, load=paper.LOAD, angular_speed=speed, accuracy=2e-3, threads=1).resisting_torque

    keys = [(start, speed) for start in _STARTS for speed in speeds]
    histories = dict(zip(keys, runner.map(history, keys), strict=True))
    return Figure6(histories=histories, steady=dict(zip(speeds, runner.map(steady, speeds), strict=True)))


def compute_figure8(runner: Runner) -> Figure8:
    """Start suddenly with every coefficient of friction, from both states.

    Each step advances the mesh by one node, so that the staircase of the mesh does not hide the overshoot.
    """
    ball = paper.ball()
    mesh = Mesh(nodes_per_revolution=_COARSE_NODES if runner.coarse else _NODES)
    angle = np.arange(int(_FRICTION_TURN / mesh.spacing) + 1) * mesh.spacing

    def history(key: Key) -> History:
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
            averaged_meshes=1,
            steps_per_spacing=None,
            threads=1,
        )

    keys = [(start, mu) for start in _STARTS for mu in (_COARSE_FRICTIONS if runner.coarse else _FRICTIONS)]
    return Figure8(histories=dict(zip(keys, runner.map(history, keys), strict=True)))
