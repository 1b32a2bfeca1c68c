"""Draw the figure of docs/published-results.md: `python -m tests.published.pictures`, half a minute on one core."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from . import bentall_johnson, creep_forces, pavement

DOCS = Path(__file__).parents[2] / "docs"


def draw_tractions(axes: Axes) -> None:
    """Draw the tractions on the steel roller in Bentall and Johnson's three cases at μ = 0.05."""
    model = bentall_johnson.on_each_other()
    for case in list(bentall_johnson.CASES)[1:4]:
        r = bentall_johnson.roll(model, case)
        x, friction = r.x.ravel() / bentall_johnson.HALF_WIDTH, r.friction
        axes.plot(x, r.shear_traction[0].ravel() / (friction * r.max_pressure), label=case.partition(", ")[2])
    bound = r.pressure.ravel() / r.max_pressure
    axes.plot(x, bound, "k:", x, -bound, "k:", linewidth=0.8)
    axes.set(
        xlabel="$x/a$, forward",
        ylabel="traction on steel / $μ p_0$",
        xlim=(-1.15, 1.15),
        title="Bentall and Johnson, two solid rollers",
    )
    axes.legend(fontsize="x-small")


def draw_creep_force(axes: Axes) -> None:
    """Draw the creep-force curve of a steel wheel with CONTACT's curve and Kalker's slope."""
    printed = np.array(creep_forces.contact_curve())
    wheel = creep_forces.SteelWheel()
    creepage = np.linspace(0.0, 5e-3, 26)
    axes.plot(100 * creepage, [wheel.force(c) for c in creepage], label="viscoroll")
    shown = printed[printed[:, 0] <= creepage[-1]]
    axes.plot(100 * shown[:, 0], shown[:, 1], "ko", markersize=4, fillstyle="none", label="CONTACT")
    slope = creep_forces.kalkers_slope()
    axes.plot([0.0, 100 / slope], [0.0, 1.0], "k--", linewidth=0.8, label="Kalker's $C_{11}$")
    axes.set(xlabel="creepage [%]", ylabel="force / $μ P$", ylim=(0.0, 1.05), title="steel wheel on a rail, a/b = ½")
    axes.legend(fontsize="x-small")


def draw_moving_disc(axes: Axes) -> None:
    """Draw the deflection next to the path of a disc on asphalt, by ELLVA and by viscoroll."""
    data = pavement.printed("ellva_moving_load.csv")
    past, deflection = data["past [m]"], data["deflection [mm]"]
    near = np.abs(past) <= 3.0
    axes.plot(past[near], 1e3 * pavement.moving(past[near]), label="viscoroll")
    axes.plot(past[near][::4], deflection[near][::4], "ko", markersize=3, fillstyle="none", label="ELLVA")
    axes.set(xlabel="disc past the point [m]", ylabel="deflection [mm]", title="asphalt under a moving disc")
    axes.invert_yaxis()
    axes.legend(fontsize="x-small")


def main() -> None:
    """Write the figure."""
    figure = Figure(figsize=(12.0, 3.8), layout="constrained")
    for draw, axes in zip((draw_tractions, draw_creep_force, draw_moving_disc), figure.subplots(1, 3), strict=True):
        draw(axes)
    figure.savefig(DOCS / "published-results.png", dpi=110)


if __name__ == "__main__":
    main()
