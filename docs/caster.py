"""Temperature, shear and tension in the tread of a caster, as functions of its thickness and speed.

    python docs/caster.py docs/caster.png

The treads are balls of polyurethane, 100 mm in diameter, on rigid cores that take up no heat. The load is 300 N and the
heat transfer coefficient at the surface 15 W/(m² K). The picture shows, for three thicknesses and five speeds, the
hottest point of every steady state, the largest shear at the bond and the largest tension inside. The moduli are those
at the temperature that results from the power loss. Open circles are unstable states.
"""

from __future__ import annotations

import sys
import warnings

import numpy as np
import viscoroll as vr
from matplotlib.figure import Figure

LOAD = 300.0  # [N]
THICKNESSES = (4e-3, 8e-3, 12e-3)  # [m]
SPEEDS = (0.2, 0.5, 1.0, 2.0, 4.0)  # of the center [m/s]
AMBIENT = 293.15  # [K]


def tread(thickness: float) -> vr.CoatedSphere:
    """Return a tread of rubber-like polyurethane, about 85 Shore A, with three relaxation times at 20 °C."""
    material = vr.Prony(instantaneous_modulus=18e6, weights=[0.25, 0.15, 0.1], relaxation_times=[2e-4, 4e-3, 0.1])
    layer = vr.Layer(thickness=thickness, shear_modulus=material, poisson_ratio=0.495, conductivity=0.25)
    return vr.CoatedSphere(core_radius=50e-3 - thickness, layers=[layer])


def steady_states(thickness: float, speed: float) -> list[tuple[bool, float, float, float]]:
    """Return stability, hottest point [°C], largest shear and largest tension [MPa] of every steady state."""
    hot = vr.self_heating(
        tread(thickness),
        load=LOAD,
        angular_speed=speed / 50e-3,
        convection=15.0,
        ambient=AMBIENT,
        shift=vr.materials.Arrhenius(activation_energy=80e3, reference_temperature=293.15),
        mesh=vr.Mesh(nodes_per_revolution=800),
        points=8,
    )
    rows = []
    for state in hot.states:
        r = state.result
        spacing = r.body.outer_radius * r.mesh.spacing
        inside = r.interior(depth=np.linspace(0.5 * spacing, thickness, 12))
        shear = float(inside.shear_traction.isel(depth=-1).max()) / 1e6
        tension = float(inside.principal_stress.sel(principal=1).max()) / 1e6
        rows.append((state.stable, state.temperature.maximum + AMBIENT - 273.15, shear, tension))
    return rows


def main(path: str) -> None:
    """Plot the results of all thicknesses and speeds in one picture."""
    warnings.simplefilter("ignore", vr.ResultWarning)
    figure = Figure(figsize=(12.0, 4.2), layout="constrained")
    axes = figure.subplots(1, 3)
    labels = ("hottest point [°C]", "largest shear at the bond [MPa]", "largest tension inside [MPa]")
    for thickness in THICKNESSES:
        points = [(speed, *row) for speed in SPEEDS for row in steady_states(thickness, speed)]
        for place, (panel, label) in enumerate(zip(axes, labels, strict=True), start=2):
            stable = [(p[0], p[place]) for p in points if p[1]]
            (line,) = panel.plot(*zip(*stable, strict=True), "o-", label=f"{thickness * 1e3:g} mm")
            for p in points:
                if not p[1]:
                    panel.plot(p[0], p[place], "o", markerfacecolor="none", color=line.get_color())
            panel.set(xlabel="speed [m/s]", ylabel=label, xscale="log")
            panel.set_xticks(SPEEDS, [f"{speed:g}" for speed in SPEEDS])
            panel.minorticks_off()
        for p in points:
            print(f"{thickness * 1e3:5.1f} mm {p[0]:5.1f} m/s  " + "  ".join(f"{v:8.3f}" for v in p[2:]))
    axes[0].legend(title="tread")
    figure.suptitle(f"Tread on a rigid core, 100 mm across, {LOAD:g} N")
    figure.savefig(path, dpi=150)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "caster.png")
