"""Table 4: law of the thickness, T = a tanh(b h^c)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .. import paper
from .._support.arguments import Floats
from .._support.pictures import Picture
from .item import Runner, Table, Verdict
from .thickness import LOADS, ThicknessSweep, printed_curve, thickness_sweep

__all__ = ["Table4", "compute_table4"]

#: Range of thickness in which the curves of table 4 are compared [m], and largest relative deviation [-].
_RANGE, _TOLERANCE = (1e-3, 10e-3), 0.03

_UNKNOWN_THICKNESSES = (
    "unclear: the paper does not state the fitted thicknesses, and their choice moves b and c into or out of the "
    "intervals (100 N: b from 56 to 60, c from 0.819 to 0.829)"
)


@dataclass(frozen=True, slots=True)
class Table4:
    """Parameters of the fits, and comparison of the fitted curves with the paper's."""

    data: ThicknessSweep

    def deviations(self, thicknesses: Floats, *, refined: bool = False) -> dict[float, Floats]:
        """Return the relative deviations of the fitted curves from the printed ones [-], by load [N]."""
        fits = self.data.refined_fits if refined else self.data.fits
        return {load: fits[load].predict(thicknesses) / printed_curve(load, thicknesses) - 1.0 for load in LOADS}

    def tables(self) -> dict[str, Table]:
        """Return a table of the parameters, and one of the deviations of the curves."""
        rows = [(load, name) for load in LOADS for name in "abc"]
        parameters = [self.data.fits[load].parameters[name] for load, name in rows]
        fine = np.geomspace(0.1e-3, 10e-3, 41)
        curves = {"thickness [m]": fine.tolist()}
        for refined in (False, True):
            for load, deviation in self.deviations(fine, refined=refined).items():
                curves[f"deviation{'_refined' if refined else ''}_P_{load:g}N [1]"] = deviation.tolist()
        return {
            "": {
                "load [N]": [load for load, _ in rows],
                "parameter (a in N m, b in m^-c, c in 1)": [name for _, name in rows],
                "value": [p.value for p in parameters],
                "lower": [p.lower for p in parameters],
                "upper": [p.upper for p in parameters],
                "value_refined": [self.data.refined_fits[load].parameters[name].value for load, name in rows],
                "printed_lower": [paper.TABLE_4[load][name][0] for load, name in rows],
                "printed_upper": [paper.TABLE_4[load][name][1] for load, name in rows],
            },
            "-curves": curves,
        }

    def draw(self) -> Picture:
        """Plot the deviations of the fitted curves, and of the torques themselves, from the paper's curves."""
        figure = Picture(figsize=(11.0, 4.6), layout="constrained")
        fine = np.geomspace(0.1e-3, 10e-3, 300)
        data = self.data
        for axes, refined in zip(figure.subplots(1, 2, sharey=True), (False, True), strict=True):
            torques = data.refined if refined else data.torques
            for index, (load, deviation) in enumerate(self.deviations(fine, refined=refined).items()):
                axes.semilogx(fine * 1e3, deviation * 100.0, color=f"C{index}", label=f"{load:g} N")
                points = torques[load] / printed_curve(load, data.thicknesses) - 1.0
                axes.plot(data.thicknesses * 1e3, points * 100.0, ".", color=f"C{index}")
            axes.fill_between(np.array(_RANGE) * 1e3, -3.0, 3.0, color="0.5", alpha=0.2)
            axes.axhline(0.0, color="0.5", linewidth=0.8)
            axes.set(title="thin coatings refined" if refined else f"$Δ$ = π/{self.data.nodes // 2} throughout")
            axes.set(xlabel="thickness $h$ [mm]")
            axes.set_xticks([0.1, 0.2, 0.5, 1, 2, 5, 10], ["0.1", "0.2", "0.5", "1", "2", "5", "10"])
        figure.axes[0].set_ylabel("deviation from the paper's curve [%]")
        figure.axes[0].legend(fontsize="small", title="lines: fits; points: torques", title_fontsize="small")
        return figure

    def verdicts(self) -> list[Verdict]:
        """Compare curves and parameters with the paper, and determine the effect of the mesh."""
        data, ends = self.data, np.geomspace(*_RANGE, 200)
        worst = max(float(np.abs(deviation).max()) for deviation in self.deviations(ends).values())
        inside = [
            paper.TABLE_4[load][name][0] <= fit.parameters[name].value <= paper.TABLE_4[load][name][1]
            for load, fit in data.fits.items()
            for name in "abc"
        ]
        thin = data.thicknesses < 0.9e-3
        mesh, off = (
            max(float(np.abs(a[load] / b[load] - 1.0)[thin].max()) for load in LOADS)
            for a, b in (
                (data.torques, data.refined),
                (data.refined, {load: printed_curve(load, data.thicknesses) for load in LOADS}),
            )
        )
        own = max(
            float(np.abs(data.fits[p].predict(data.thicknesses) / data.torques[p] - 1)[thin].max()) for p in LOADS
        )
        return [
            Verdict(
                statement="laws of table 4, for h from 1 to 10 mm",
                found=f"within {worst * 100.0:.1f} %",
                agrees=worst <= _TOLERANCE,
            ),
            Verdict(
                statement="our a, b and c lie in the 95 % intervals",
                found=f"{sum(inside)} of {len(inside)} inside",
                agrees=all(inside),
                unclear="" if all(inside) else _UNKNOWN_THICKNESSES,
            ),
            Verdict(
                statement="laws of table 4, for h < 1 mm",
                found=f"torques on a refined mesh deviate by up to {off * 100.0:.0f} %; torques on the mesh "
                f"π/{data.nodes // 2} deviate from the refined ones by up to {mesh * 100.0:.0f} %, and from the law "
                f"that we fitted to them by up to {own * 100.0:.0f} %",
                agrees=off <= _TOLERANCE,
            ),
        ]


def compute_table4(runner: Runner) -> Table4:
    """Fit the law of section 14.5 to coatings of 0.1 to 10 mm, also with refined meshes for thin ones."""
    return Table4(runner.shared(thickness_sweep))
