"""Figure 11: resisting torque as a function of the thickness of the coating."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Curvature
from .._support.arguments import Floats
from .._support.pictures import Picture
from ..bodies import Mesh
from ..rolling import RollingModel
from ..studies.fits import fit_thickness_law
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .._support.least_squares import Fit

__all__ = ["LOADS", "Figure11", "ThicknessSweep", "compute_figure11", "printed_curve", "thickness_sweep"]

_OUTER_RADIUS = 21e-3
#: Loads [N] of table 4 and figure 11.
LOADS = tuple(paper.TABLE_4)
#: Thicknesses [m]. The paper states their range only.
_THICKNESSES = np.array([0.1, 0.25, 0.5, 0.75, *np.arange(1.0, 10.1, 0.5)]) * 1e-3
_COARSE = np.array([0.1, 0.5, 1.0, 2.0, 4.0, 7.0, 10.0]) * 1e-3
#: Factor on the number of nodes for a second solve of coatings up to the given thickness [m].
_REFINED = {0.25e-3: 4, 2e-3: 2}


@dataclass(frozen=True, slots=True, kw_only=True)
class ThicknessSweep:
    """Torques [N m] by load [N], for several thicknesses [m], and their fits.

    `refined` contains the torques on finer meshes for thin coatings, and the same torques as `torques` for others.
    """

    nodes: int
    thicknesses: Floats
    torques: dict[float, Floats]
    refined: dict[float, Floats]
    fits: dict[float, Fit]
    refined_fits: dict[float, Fit]

    @property
    def thin(self) -> NDArray[np.bool_]:
        """Thicknesses for which the mesh was refined, as a mask."""
        return self.thicknesses <= max(_REFINED) * (1.0 + 1e-9)


@dataclass(frozen=True, slots=True)
class Figure11:
    """Torque as a function of thickness, with the fits."""

    data: ThicknessSweep

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each thickness."""
        data = self.data
        columns = {"thickness [m]": data.thicknesses.tolist()}
        for load in LOADS:
            low, high = data.fits[load].confidence_band(data.thicknesses)
            head = f"P_{load:g}N [N m]"
            columns |= {
                f"torque_{head}": data.torques[load].tolist(),
                f"torque_refined_{head}": data.refined[load].tolist(),
                f"fit_{head}": data.fits[load].predict(data.thicknesses).tolist(),
                f"fit_lower_{head}": low.tolist(),
                f"fit_upper_{head}": high.tolist(),
                f"paper_{head}": printed_curve(load, data.thicknesses).tolist(),
            }
        return {"": columns}

    def draw(self) -> Picture:
        """Plot torques, fits with confidence bands and the paper's curves, and thin coatings with logarithmic axes."""
        figure = Picture(figsize=(12.0, 5.0), layout="constrained")
        axes = figure.subplots(1, 2)
        data, fine = self.data, np.geomspace(0.1e-3, 10e-3, 300)
        for index, load in enumerate(LOADS):
            color = f"C{index}"
            low, high = data.fits[load].confidence_band(fine)
            axes[0].fill_between(fine * 1e3, low * 1e3, high * 1e3, color=color, alpha=0.25)
            for ax in axes:
                ax.plot(fine * 1e3, data.fits[load].predict(fine) * 1e3, color=color, linewidth=1.2)
                ax.plot(fine * 1e3, printed_curve(load, fine) * 1e3, "k--", linewidth=0.9)
                ax.plot(
                    data.thicknesses * 1e3,
                    data.torques[load] * 1e3,
                    "o",
                    color=color,
                    markersize=4,
                    label=f"{load:g} N",
                )
            refined = data.refined[load][data.thin] * 1e3
            axes[1].plot(data.thicknesses[data.thin] * 1e3, refined, "s", color=color, markerfacecolor="none")
        for label, style in (("$a$ tanh($b h^c$) fitted", "0.4"), ("paper, table 4", "k--")):
            axes[0].plot([], [], style, label=label)
        axes[1].plot([], [], "ks", markerfacecolor="none")
        axes[1].plot([], [], "ko", markersize=4)
        axes[0].set(xlabel="thickness $h$ [mm]", ylabel="$T_r$ [mN m]", xlim=0, ylim=0)
        axes[1].set(xlabel="thickness $h$ [mm]", xscale="log", yscale="log", title="thin coatings", xlim=(0.08, 2.5))
        axes[1].set_ylim(0.5 * data.refined[LOADS[0]][0] * 1e3, 1.5 * data.refined[LOADS[-1]][data.thin][-1] * 1e3)
        axes[0].legend(fontsize="small")
        axes[1].legend(axes[1].get_lines()[-2:], ["mesh refined", f"$Δ$ = π/{data.nodes // 2}"], fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the statements of the paper's section 14.5."""
        data = self.data
        rising = all(bool((np.diff(torques) > 0.0).all()) for torques in data.refined.values())
        growth = [float(t[-1] / np.interp(7e-3, data.thicknesses, t) - 1.0) for t in data.refined.values()]
        return [
            Verdict(
                statement="the torque increases with thickness towards a limit",
                found=f"{'it increases throughout' if rising else 'it does not increase throughout'}, from 7 to "
                f"10 mm by {min(growth) * 100.0:.0f} % (25 N) to {max(growth) * 100.0:.0f} % (100 N)",
                agrees=rising,
            ),
            Verdict(
                statement="the law a tanh(b h^c) fits the torques with r² = 0.9999",
                found=f"r² ≥ {min(fit.r_squared for fit in data.fits.values()):.5f}",
                agrees=min(fit.r_squared for fit in data.fits.values()) >= 0.99985,
            ),
        ]


def printed_curve(load: float, thickness: Floats) -> Floats:
    """Return the torque [N m] of table 4, with the middles of its intervals as parameters."""
    a, b, c = (sum(paper.TABLE_4[load][name]) / 2.0 for name in "abc")
    return np.asarray(a * np.tanh(b * thickness**c))


def thickness_sweep(runner: Runner) -> ThicknessSweep:
    """Solve coatings of 0.1 to 10 mm at four loads, thin ones also on finer meshes, and fit the law of section 14.5."""
    thicknesses = _COARSE if runner.coarse else _THICKNESSES

    def torques(point: tuple[float, int]) -> list[float]:
        h, factor = point
        nodes, order = runner.mesh.nodes_per_revolution, runner.mesh.max_order
        # Truncation orders that are odd multiples of half the number of nodes converge best. The paper's mesh is
        # unchanged.
        mesh = Mesh(nodes_per_revolution=nodes * factor, max_order=3 * nodes * factor // 2 if factor > 1 else order)
        ball = paper.ball(thickness=h, core_radius=_OUTER_RADIUS - h)
        model = RollingModel(ball, angular_speed=paper.ANGULAR_SPEED, mesh=mesh, curvature=Curvature.PAPER, threads=1)
        return [model.solve(load=p, compliance=Compliance.RADIAL, threads=1).resisting_torque for p in LOADS]

    points = [(float(h), 1) for h in thicknesses]
    points += [(h, factor) for h, _ in points if (factor := _refinement(h)) > 1]
    found = dict(zip(points, runner.map(torques, points), strict=True))
    rough = np.array([found[h, 1] for h in thicknesses.tolist()]).T
    finer = np.array([found[h, _refinement(h)] for h in thicknesses.tolist()]).T
    return ThicknessSweep(
        nodes=runner.mesh.nodes_per_revolution,
        thicknesses=thicknesses,
        torques=dict(zip(LOADS, rough, strict=True)),
        refined=dict(zip(LOADS, finer, strict=True)),
        fits={load: fit_thickness_law(thicknesses, t) for load, t in zip(LOADS, rough, strict=True)},
        refined_fits={load: fit_thickness_law(thicknesses, t) for load, t in zip(LOADS, finer, strict=True)},
    )


def _refinement(thickness: float) -> int:
    """Return the factor on the number of nodes for a thickness [m]."""
    return next((factor for limit, factor in _REFINED.items() if thickness <= limit * (1.0 + 1e-9)), 1)


def compute_figure11(runner: Runner) -> Figure11:
    """Compute coatings of 0.1 to 10 mm at four loads, thin ones also on finer meshes."""
    return Figure11(runner.shared(thickness_sweep))
