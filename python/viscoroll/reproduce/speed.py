"""Figures 7 and 12: resisting torque as a function of the rolling speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import analytic, paper
from .._core import Compliance, Curvature
from .._support.arguments import Floats
from .._support.pictures import Picture
from ..rolling import RollingModel
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from ..rolling import Result

__all__ = ["Figure7", "Figure12", "compute_figure7", "compute_figure12"]

#: Smallest and largest angular speed of figure 7 [rad/s].
_SLOWEST, _FASTEST = 0.05, 25.0
#: Angular speed of the "deepest penetration" of the paper's footnote 1 [rad/s].
_DEEPEST = 0.3
_THICKNESSES = (1e-3, 5e-3)
#: Relative steps of the torque as rows of nodes enter the contact [-]: docs/theory/reference-values.md.
_STAIRCASE = 0.01


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure7:
    """Torque [N m] and penetration [m] of the example for angular speeds Ω [rad/s]."""

    speeds: Floats
    torques: Floats
    penetrations: Floats
    low_speed: Floats

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each speed."""
        return {
            "": {
                "angular_speed [rad/s]": self.speeds.tolist(),
                "torque [N m]": self.torques.tolist(),
                "penetration [m]": self.penetrations.tolist(),
                "low_speed_limit [N m]": self.low_speed.tolist(),
            }
        }

    def draw(self) -> Picture:
        """Plot the torque, its low-speed limit, and the penetration."""
        figure = Picture(figsize=(8.0, 4.8), layout="constrained")
        axes = figure.subplots()
        axes.semilogx(self.speeds, self.torques * 1e3, "o-", markersize=3.5, label="$T_r$")
        shown = self.low_speed < 1.15 * self.torques.max()
        axes.plot(
            self.speeds[shown], self.low_speed[shown] * 1e3, "k--", linewidth=1.0, label="low speed: $PΩr_oτg_1/g_∞$"
        )
        axes.plot(paper.ANGULAR_SPEED, paper.TABLE_2[500, 500] * 1e3, "kx", label="printed in table 2")
        axes.axvspan(0.5, 4.0, color="0.5", alpha=0.15, label="range of the paper's finite elements")
        axes.set(xlabel="rolling speed $Ω$ [rad/s]", ylabel="$T_r$ [mN m]", ylim=0)
        depth = axes.twinx()
        depth.semilogx(self.speeds, self.penetrations * 1e3, color="tab:red", linewidth=1.0)
        depth.set_ylabel("penetration [mm]", color="tab:red")
        depth.set_ylim(0.0)
        axes.legend(fontsize="small", loc="lower center")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the printed torque of table 2, and with the footnote on penetration."""
        at = int(np.argmin(np.abs(self.speeds - paper.ANGULAR_SPEED)))
        printed = paper.TABLE_2[500, 500]
        off = float(self.torques[at] / printed - 1.0)
        deepest, most = (float(self.speeds[np.argmax(v)]) for v in (self.penetrations, self.torques))
        near = int(np.argmin(np.abs(self.speeds - _DEEPEST)))
        fraction = float(self.torques[near] / self.torques.max())
        return [
            Verdict(
                statement=f"{printed * 1e3:.2f} mN m at 2.5 rad/s (from table 2, because the paper does not print the "
                "points of figure 7)",
                found=f"{self.torques[at] * 1e3:.2f} mN m, {off * 100.0:+.2f} %",
                agrees=abs(off) <= 0.005,
            ),
            Verdict(
                statement='"deepest penetration" roughly at 0.3 rad/s',
                found=f"the penetration is largest at {deepest:.2g} rad/s and decreases with speed; the torque is "
                f"largest at {most:.2g} rad/s; at 0.3 rad/s it is {fraction * 100.0:.1f} % of that maximum",
                agrees=bool(abs(np.log2(deepest / _DEEPEST)) < 1.0),
            ),
        ]


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure12:
    """Torques [N m] by thickness [m], as arrays of shape (loads, speeds)."""

    speeds: Floats
    loads: Floats
    torques: dict[float, Floats]

    def tables(self) -> dict[str, Table]:
        """Return a table for each thickness, with one row for each speed."""
        return {
            f"-{h * 1e3:g}mm": {"angular_speed [rad/s]": self.speeds.tolist()}
            | {f"torque_P_{p:g}N [N m]": t.tolist() for p, t in zip(self.loads, torques, strict=True)}
            for h, torques in self.torques.items()
        }

    def draw(self) -> Picture:
        """Plot a curve for each load."""
        from matplotlib import colormaps

        figure = Picture(figsize=(12.0, 4.8), layout="constrained")
        colors = colormaps["viridis"](np.linspace(0.0, 0.9, self.loads.size))
        for axes, (h, torques) in zip(figure.subplots(1, 2), self.torques.items(), strict=True):
            for load, torque, color in zip(self.loads, torques, colors, strict=True):
                axes.semilogx(self.speeds, torque * 1e3, color=color, label=f"{load:g} N")
            peaks = torques.argmax(axis=1)
            axes.plot(self.speeds[peaks], torques.max(axis=1) * 1e3, "k.", markersize=5, label="peak")
            axes.set(xlabel="rolling speed $Ω$ [rad/s]", ylabel="$T_r$ [mN m]", title=f"$h$ = {h * 1e3:g} mm", ylim=0)
        handles, labels = figure.axes[0].get_legend_handles_labels()
        figure.legend(handles[::-1], labels[::-1], loc="outside right center", title="load $P$", fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the statements of the paper's section 14.6."""
        single = all(_has_one_peak(torque) for torques in self.torques.values() for torque in torques)
        ends = [t[:, [0, -1]] / t.max(axis=1, keepdims=True) for t in self.torques.values()]
        slow, fast = (max(float(e[:, k].max()) for e in ends) for k in (0, 1))
        peaks = {h: self.speeds[torques.argmax(axis=1)] for h, torques in self.torques.items()}
        where = "; ".join(f"{p[0]:.2g} (10 N) to {p[-1]:.2g} rad/s (100 N) at {h * 1e3:g} mm" for h, p in peaks.items())
        return [
            Verdict(
                statement="one peak at an intermediate speed, for every load",
                found=f"{'one peak each' if single else 'not one peak each'}, at {where}",
                agrees=single,
            ),
            Verdict(
                statement="resistance decreases towards 0 at low and at high speed",
                found=f"at most {slow * 100.0:.0f} % of the peak at {self.speeds[0]:g} rad/s "
                f"and {fast * 100.0:.0f} % at {self.speeds[-1]:g} rad/s",
                agrees=max(slow, fast) < 0.7,
            ),
        ]


def _has_one_peak(torque: Floats) -> bool:
    """Return whether a curve rises to one peak and falls after it, apart from the steps of the mesh."""
    top = int(torque.argmax())
    rise, fall = torque[: top + 1], torque[top:][::-1]
    return all(bool((part >= np.maximum.accumulate(part) * (1.0 - _STAIRCASE)).all()) for part in (rise, fall))


def _speeds(count: int) -> Floats:
    """Return angular speeds with equal ratios [rad/s], and in addition those of the example and of the footnote."""
    return np.unique([*np.geomspace(_SLOWEST, _FASTEST, count), _DEEPEST, paper.ANGULAR_SPEED])


def compute_figure7(runner: Runner) -> Figure7:
    """Solve the example at speeds from 0.05 to 25 rad/s."""
    speeds = _speeds(8 if runner.coarse else 45)
    ball = paper.ball()

    def point(speed: float) -> Result:
        model = RollingModel(ball, angular_speed=speed, mesh=runner.mesh, curvature=Curvature.PAPER, threads=1)
        return model.solve(load=paper.LOAD, compliance=Compliance.RADIAL, threads=1)

    results = runner.map(point, speeds.tolist())
    return Figure7(
        speeds=speeds,
        torques=np.array([result.resisting_torque for result in results]),
        penetrations=np.array([result.penetration for result in results]),
        low_speed=np.asarray(analytic.applicable(ball)["low_speed"](paper.LOAD, speeds)),
    )


def compute_figure12(runner: Runner) -> Figure12:
    """Solve coatings of 1 and 5 mm at ten loads (three in a coarse run) and speeds from 0.05 to 25 rad/s."""
    speeds = np.geomspace(_SLOWEST, _FASTEST, 7 if runner.coarse else 28)
    loads = np.linspace(10.0, 100.0, 3 if runner.coarse else 10)

    def torques(point: tuple[float, float]) -> list[float]:
        h, speed = point
        model = RollingModel(
            paper.ball(thickness=h), angular_speed=speed, mesh=runner.mesh, curvature=Curvature.PAPER, threads=1
        )
        return [model.solve(load=float(p), compliance=Compliance.RADIAL, threads=1).resisting_torque for p in loads]

    points = [(h, float(speed)) for h in _THICKNESSES for speed in speeds]
    values = np.array(runner.map(torques, points)).reshape(len(_THICKNESSES), speeds.size, loads.size)
    return Figure12(speeds=speeds, loads=loads, torques={h: v.T for h, v in zip(_THICKNESSES, values, strict=True)})
