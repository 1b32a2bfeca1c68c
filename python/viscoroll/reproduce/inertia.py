"""Figure 13: torque and penetration as functions of inertia."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Curvature
from .._support.arguments import Floats
from .._support.pictures import Picture
from ..bodies import Mesh
from ..modal import critical_speed
from ..rolling import solve
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from ..bodies import CoatedSphere
    from ..rolling import Result

__all__ = ["Figure13", "compute_figure13"]

_THICKNESS, _CORE_RADIUS, _MODULUS = 5e-3, 20e-3, 6e6
_GROUPS = (0.0, 0.025, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.55, 0.57, 0.58)
_COARSE = (0.0, 0.2, 0.5)


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure13:
    """Torques [N m] and penetrations [m] for values of Π of equation (67) [-], and Π at the critical speed."""

    groups: Floats
    torques: Floats
    penetrations: Floats
    critical_group: float

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each Π."""
        return {
            "": {
                "inertia_group [1]": self.groups.tolist(),
                "torque [N m]": self.torques.tolist(),
                "penetration [m]": self.penetrations.tolist(),
                "torque_ratio [1]": (self.torques / self.torques[0]).tolist(),
                "penetration_ratio [1]": (self.penetrations / self.penetrations[0]).tolist(),
                "critical_inertia_group [1]": [self.critical_group] * self.groups.size,
            }
        }

    def draw(self) -> Picture:
        """Plot torque and penetration, relative to those without inertia, up to the critical speed."""
        figure = Picture(figsize=(7.6, 4.8), layout="constrained")
        axes = figure.subplots()
        axes.plot(self.groups, self.torques / self.torques[0], "o-", label="torque $T_r / T_{r0}$")
        axes.plot(self.groups, self.penetrations / self.penetrations[0], "s-", label="penetration $d / d_0$")
        axes.axvline(
            self.critical_group, color="k", linestyle="--", label=f"critical speed, $Π$ = {self.critical_group:.3f}"
        )
        axes.axvspan(self.critical_group, 1.05, color="0.5", alpha=0.15, label="no steady solution: waves are radiated")
        axes.axvline(1.0, color="0.5", linestyle=":", label="$Ω = Ω_n$ of the paper (68)")
        axes.set(xlabel=r"inertia $Π = ρΩ^2r_i^2/G_o$", ylabel="relative to no inertia", xlim=(0.0, 1.05))
        axes.legend(fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the statements of the paper's section 14.7."""
        torque, depth = (float(v[-1] / v[0]) for v in (self.torques, self.penetrations))
        rising = bool((np.diff(self.torques) > 0.0).all() and (np.diff(self.penetrations) > 0.0).all())
        example = _group(paper.ball(thickness=1e-3), 1000.0)
        return [
            Verdict(
                statement="torque and penetration increase with Π",
                found=f"by factors of {torque:.2f} and {depth:.2f} at Π = {self.groups[-1]:g}",
                agrees=rising,
            ),
            Verdict(
                statement="the increase continues up to Ω_n, where Π = 1",
                found=f"steady states exist only up to the critical speed, Π = {self.critical_group:.3f}",
                agrees=self.critical_group >= 1.0,
                by_mesh=False,
            ),
            Verdict(
                statement="Π of the order of 10⁻⁷ in the example",
                found=f"{example:.1e}",
                agrees=1e-7 <= example < 1e-6,
                by_mesh=False,
            ),
        ]


def _group(ball: CoatedSphere, density: float, speed: float = paper.ANGULAR_SPEED) -> float:
    """Return Π of equation (67) [-]."""
    return float(density * speed**2 * ball.core_radius**2 / _MODULUS)


def compute_figure13(runner: Runner) -> Figure13:
    """Solve coatings of 5 mm with increasing density, at the speed of the example."""
    groups = np.array(_COARSE if runner.coarse else _GROUPS)
    mesh = Mesh(nodes_per_revolution=160, max_order=160) if runner.coarse else runner.mesh

    def point(group: float) -> Result:
        density = group * _MODULUS / (paper.ANGULAR_SPEED * _CORE_RADIUS) ** 2
        return solve(
            paper.ball(thickness=_THICKNESS, core_radius=_CORE_RADIUS, density=density),
            load=paper.LOAD,
            angular_speed=paper.ANGULAR_SPEED,
            mesh=mesh,
            compliance=Compliance.RADIAL,
            curvature=Curvature.PAPER,
            threads=1,
        )

    results = runner.map(point, groups.tolist())
    ball = paper.ball(thickness=_THICKNESS, core_radius=_CORE_RADIUS, density=1000.0)
    return Figure13(
        groups=groups,
        torques=np.array([result.resisting_torque for result in results]),
        penetrations=np.array([result.penetration for result in results]),
        critical_group=_group(ball, 1000.0, critical_speed(ball, curvature=Curvature.PAPER)),
    )
