"""Figure 6: the resisting torque after a sudden start, at many speeds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Start
from .._support.pictures import Picture
from ..bodies import Mesh
from ..rolling import solve
from ..transient import roll
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from ..transient import History

__all__ = ["Figure6", "compute_figure6"]

#: Ω of figure 6 [rad/s], which its text gives the ends of.
_SPEEDS = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0)
_COARSE = (0.5, 2.5, 4.0)
_TURN = 0.8  # [rad]: more than three times the contact's length
_STEADY = 0.02  # within which a torque counts as steady [-]


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure6:
    """Histories by starting state and speed, and the steady torque at each speed [N m]."""

    histories: dict[tuple[Start, float], History]
    steady: dict[float, float]

    def overshoot(self, start: Start, speed: float) -> float:
        """How far the largest torque lies above the steady one [-]."""
        return float(self.histories[start, speed].resisting_torque.max()) / self.steady[speed] - 1.0

    def settling_time(self, start: Start, speed: float) -> float:
        """When the torque is within 2 % of the steady one for good [s]; infinite where that is not reached."""
        history = self.histories[start, speed]
        away = np.flatnonzero(np.abs(history.resisting_torque / self.steady[speed] - 1.0) > _STEADY)
        last = int(away[-1]) + 1 if len(away) else 0
        return float(history.time[last]) if last < len(history.time) else float("inf")

    def tables(self) -> dict[str, Table]:
        """Return a row for each start and speed, and the histories."""
        keys = list(self.histories)
        rows = [(key, i) for key in keys for i in range(len(self.histories[key].time))]
        return {
            "": {
                "start": [start.name for start, _ in keys],
                "angular_speed [rad/s]": [speed for _, speed in keys],
                "steady_torque [N m]": [self.steady[speed] for _, speed in keys],
                "overshoot [1]": [self.overshoot(*key) for key in keys],
                "settling_time [s]": [self.settling_time(*key) for key in keys],
            },
            "-histories": {
                "start": [start.name for (start, _), _ in rows],
                "angular_speed [rad/s]": [speed for (_, speed), _ in rows],
                "time [s]": [float(self.histories[key].time[i]) for key, i in rows],
                "resisting_torque [N m]": [float(self.histories[key].resisting_torque[i]) for key, i in rows],
            },
        }

    def draw(self) -> Picture:
        """Torque over time, for both starting states."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        titles = {Start.FRESH: "pressed on in no time", Start.RELAXED: "has borne the load for ever"}
        for axes, (start, title) in zip(figure.subplots(1, 2), titles.items(), strict=True):
            for place, speed in enumerate(self.steady):
                history = self.histories[start, speed]
                axes.plot(history.time, history.resisting_torque * 1e3, color=f"C{place}", label=f"{speed:g} rad/s")
                axes.axhline(self.steady[speed] * 1e3, color=f"C{place}", linewidth=0.6, linestyle=":")
            axes.set(title=title, xlabel="time [s]", ylabel="$T_r$ [mN m]", xlim=(0.0, 0.8))
        figure.axes[0].legend(fontsize="small", title="dotted: steady", title_fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Judge what the text says, for both starting states."""
        speeds = list(self.steady)
        verdicts = []
        for start in (Start.FRESH, Start.RELAXED):
            settling = [self.settling_time(start, speed) for speed in speeds]
            verdicts.append(
                Verdict(
                    statement=f"a steady state is reached ({start.name} start)",
                    found=f"within {_STEADY:.0%} after {settling[0]:.2f} s at {speeds[0]:g} rad/s, "
                    f"{settling[-1]:.2f} s at {speeds[-1]:g} rad/s",
                    agrees=all(np.isfinite(settling)),
                )
            )
        fresh, relaxed = ([self.overshoot(start, s) for s in speeds] for start in (Start.FRESH, Start.RELAXED))
        verdicts.append(
            Verdict(
                statement="the load is applied somehow before the start",
                found=f"it decides the peak: pressed on at the start {fresh[0]:.1%} to {fresh[-1]:.1%} above the "
                f"steady torque, long borne {relaxed[0]:.0%} to {relaxed[-1]:.0%}",
                agrees=False,
                unclear="unclear: neither text nor picture has numbers",
            )
        )
        return verdicts


def compute_figure6(runner: Runner) -> Figure6:
    """Start at once at every speed, from both states, at the paper's load."""
    ball = paper.ball()
    speeds = _COARSE if runner.coarse else _SPEEDS
    mesh = Mesh(nodes_per_revolution=runner.mesh.nodes_per_revolution)  # all orders, as in the steady torque

    def history(key: tuple[Start, float]) -> History:
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

    keys = [(start, speed) for start in (Start.FRESH, Start.RELAXED) for speed in speeds]
    histories = dict(zip(keys, runner.map(history, keys), strict=True))
    return Figure6(histories=histories, steady=dict(zip(speeds, runner.map(steady, speeds), strict=True)))
