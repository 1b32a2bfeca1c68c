"""Table 3 and figure 10: resisting torque as a function of the load."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import paper
from .._core import Compliance, Curvature
from .._support.arguments import Floats
from .._support.pictures import Picture
from ..rolling import RollingModel
from ..studies.fits import fit_power_law
from .item import Runner, Table, Verdict

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes

    from .._support.least_squares import Fit, Parameter

__all__ = ["Figure10", "Table3", "compute_figure10", "compute_table3"]

_THICKNESSES = (1e-3, 5e-3)


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadSweep:
    """Torques [N m] by thickness [m], for several loads [N], and their power laws."""

    loads: Floats
    torques: dict[float, Floats]
    fits: dict[float, Fit]


@dataclass(frozen=True, slots=True)
class Figure10:
    """Torque as a function of the load, with the power laws."""

    data: LoadSweep

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each load."""
        columns = {"load [N]": self.data.loads.tolist()}
        for h, torque in self.data.torques.items():
            low, high = self.data.fits[h].confidence_band(self.data.loads)
            head = f"h_{h * 1e3:g}mm [N m]"
            columns |= {
                f"torque_{head}": torque.tolist(),
                f"fit_{head}": self.data.fits[h].predict(self.data.loads).tolist(),
                f"fit_lower_{head}": low.tolist(),
                f"fit_upper_{head}": high.tolist(),
            }
        return {"": columns}

    def draw(self) -> Picture:
        """Plot torques, power laws with their confidence bands, and the paper's fits."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        fine = np.linspace(self.data.loads[0], self.data.loads[-1], 200)
        for axes, (h, torque) in zip(figure.subplots(1, 2), self.data.torques.items(), strict=True):
            fit, printed = self.data.fits[h], paper.TABLE_3[h]
            low, high = fit.confidence_band(fine)
            axes.fill_between(fine, low * 1e3, high * 1e3, color="tab:blue", alpha=0.25, label="95 % confidence")
            a, b = fit.parameters["a"].value, fit.parameters["b"].value
            axes.plot(fine, fit.predict(fine) * 1e3, color="tab:blue", label=_law(a, b))
            a, b = (sum(printed[name]) / 2.0 for name in ("a", "b"))
            axes.plot(
                fine,
                a * fine**b * 1e3,
                "k--",
                linewidth=1.0,
                label="paper, table 3 with columns swapped: " + _law(a, b),
            )
            axes.plot(self.data.loads, torque * 1e3, "o", color="tab:blue", markersize=4, label="computed")
            axes.set(xlabel="load $P$ [N]", ylabel="$T_r$ [mN m]", title=f"$h$ = {h * 1e3:g} mm", xlim=0, ylim=0)
            axes.legend(fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the statements of the paper's section 14.4."""
        b = {h: fit.parameters["b"].value for h, fit in self.data.fits.items()}
        thin, thick = (b[h] for h in _THICKNESSES)
        residual = max(
            float(np.abs(self.data.fits[h].predict(self.data.loads) / torque - 1.0)[self.data.loads >= 20.0].max())
            for h, torque in self.data.torques.items()
        )
        values = f"b = {thin:.3f} at 1 mm, {thick:.3f} at 5 mm"
        return [
            Verdict(
                statement="power laws fit the torques well",
                found=f"within {residual * 100.0:.1f} % at loads of at least 20 N",
                agrees=residual < 0.05,
            ),
            Verdict(statement="exponents larger than 4/3", found=values, agrees=min(thin, thick) > 4.0 / 3.0),
            Verdict(
                statement="exponents decrease with thickness",
                found=f"{values} (the paper exchanged the columns of table 3)",
                agrees=thick < thin,
            ),
        ]


@dataclass(frozen=True, slots=True)
class Table3:
    """Factors and exponents of the power laws."""

    data: LoadSweep

    def _rows(self) -> Iterator[tuple[float, str, Parameter]]:
        for h, fit in self.data.fits.items():
            for name in ("a", "b"):
                yield h, name, fit.parameters[name]

    def tables(self) -> dict[str, Table]:
        """Return a table with one row for each thickness and parameter, with the printed intervals of both columns."""
        rows = list(self._rows())
        other = dict(zip(_THICKNESSES, reversed(_THICKNESSES), strict=True))
        return {
            "": {
                "thickness [m]": [h for h, _, _ in rows],
                "parameter (a in N^(1-b) m, b in 1)": [name for _, name, _ in rows],
                "value": [p.value for _, _, p in rows],
                "lower": [p.lower for _, _, p in rows],
                "upper": [p.upper for _, _, p in rows],
                "printed_lower_columns_swapped": [paper.TABLE_3[h][name][0] for h, name, _ in rows],
                "printed_upper_columns_swapped": [paper.TABLE_3[h][name][1] for h, name, _ in rows],
                "printed_lower_as_printed": [paper.TABLE_3[other[h]][name][0] for h, name, _ in rows],
                "printed_upper_as_printed": [paper.TABLE_3[other[h]][name][1] for h, name, _ in rows],
            }
        }

    def draw(self) -> Picture:
        """Plot computed and printed intervals."""
        figure = Picture(figsize=(8.8, 3.6), layout="constrained")
        for axes, name, scale, label in zip(
            figure.subplots(1, 2),
            ("a", "b"),
            (1e5, 1.0),
            ("factor $a_p$ [$10^{-5}$ SI]", "exponent $b_p$"),
            strict=True,
        ):
            for index, h in enumerate(_THICKNESSES):
                p = self.data.fits[h].parameters[name]
                _interval(axes, index + 0.15, (p.lower * scale, p.upper * scale), "tab:blue", p.value * scale)
                for reading, key, color in (("swapped", h, "k"), ("printed", _THICKNESSES[1 - index], "0.6")):
                    low, high = paper.TABLE_3[key][name]
                    shift = 0.0 if reading == "swapped" else -0.15
                    _interval(axes, index + shift, (low * scale, high * scale), color)
            axes.set_yticks(range(2), [f"$h$ = {h * 1e3:g} mm" for h in _THICKNESSES])
            axes.set(xlabel=label, ylim=(-0.5, 1.7))
        for color, text in (("tab:blue", "computed"), ("k", "paper, columns swapped"), ("0.6", "paper, as printed")):
            axes.plot([], [], color=color, label=text, linewidth=3.0)
        figure.legend(loc="outside upper center", ncols=3, fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare with the printed table, as printed and with its columns exchanged."""
        other = dict(zip(_THICKNESSES, reversed(_THICKNESSES), strict=True))
        values = "; ".join(
            f"{h * 1e3:g} mm: a = {fit.parameters['a'].value * 1e5:.3f}e-5, b = {fit.parameters['b'].value:.4f}"
            for h, fit in self.data.fits.items()
        )
        swapped = [_inside(p, name, paper.TABLE_3[h][name]) for h, name, p in self._rows()]
        printed = [_inside(p, name, paper.TABLE_3[other[h]][name]) for h, name, p in self._rows()]
        return [
            Verdict(
                statement="our a and b lie in the 95 % intervals, if the two columns of the table are exchanged",
                found=f"{sum(swapped)} of 4 inside; {values}",
                agrees=all(swapped),
            ),
            Verdict(
                statement="our a and b lie in the 95 % intervals of the columns as printed",
                found=f"{sum(printed)} of 4 inside",
                agrees=all(printed),
            ),
        ]


def _inside(parameter: Parameter, name: str, printed: tuple[float, float]) -> bool:
    """Return whether a value, rounded like the printed ones, lies in the printed interval."""
    value = round(parameter.value, 8 if name == "a" else 3)
    return printed[0] <= value <= printed[1]


def _interval(axes: Axes, height: float, ends: tuple[float, float], color: str, middle: float | None = None) -> None:
    axes.plot(ends, (height, height), color=color, linewidth=3.0)
    if middle is not None:
        axes.plot(middle, height, "o", color=color)


def _law(a: float, b: float) -> str:
    return f"{a * 1e5:.3f}·10⁻⁵ $P^{{{b:.3f}}}$"


def _load_sweep(runner: Runner) -> LoadSweep:
    loads = np.linspace(10.0, 100.0, 5 if runner.coarse else 10)

    def model(h: float) -> RollingModel:
        return RollingModel(
            paper.ball(thickness=h),
            angular_speed=paper.ANGULAR_SPEED,
            mesh=runner.mesh,
            curvature=Curvature.PAPER,
            threads=1,
        )

    models = dict(zip(_THICKNESSES, runner.map(model, _THICKNESSES), strict=True))

    def torque(point: tuple[float, float]) -> float:
        h, load = point
        return models[h].solve(load=load, compliance=Compliance.RADIAL, threads=1).resisting_torque

    points = [(h, float(load)) for h in _THICKNESSES for load in loads]
    values = np.array(runner.map(torque, points)).reshape(len(_THICKNESSES), -1)
    torques = dict(zip(_THICKNESSES, values, strict=True))
    return LoadSweep(loads=loads, torques=torques, fits={h: fit_power_law(loads, t) for h, t in torques.items()})


def compute_table3(runner: Runner) -> Table3:
    """Fit power laws to the torques at ten loads from 10 to 100 N (five in a coarse run)."""
    return Table3(runner.shared(_load_sweep))


def compute_figure10(runner: Runner) -> Figure10:
    """Solve coatings of 1 and 5 mm at ten loads from 10 to 100 N (five in a coarse run)."""
    return Figure10(runner.shared(_load_sweep))
