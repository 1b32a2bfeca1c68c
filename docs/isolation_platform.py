"""A platform on coated balls under a ground motion: the worked example of docs/transient.md.

Every ball rolls between the floor and the platform, so the platform moves by s = 2 r_o ψ against the floor, and the two
contacts of a ball, each with the torque T, push back with T / r_o. Springs bring the platform home:

    M (s'' + a_g) + k s + N T(history of ψ) / r_o = 0.

T depends on all that was before, so the equation is integrated step by step (Newmark's average acceleration), the new s
found by SciPy's secant method around copies of the rolling history.

    python docs/isolation_platform.py [picture.png]
"""

from __future__ import annotations

import copy
import sys
from dataclasses import dataclass

import numpy as np
import viscoroll as vr
from matplotlib.figure import Figure
from scipy.integrate import cumulative_trapezoid
from scipy.optimize import root_scalar
from scipy.signal import butter, sosfilt


@dataclass(frozen=True)
class Platform:
    """Platform, balls and springs."""

    ball: vr.CoatedSphere
    balls: int = 4
    load: float = 100.0  # on each ball [N]
    natural_period: float = 1.5  # of platform and springs [s]

    @property
    def radius(self) -> float:
        """Outer radius of a ball [m]."""
        return self.ball.outer_radius

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.balls * self.load / 9.81

    @property
    def stiffness(self) -> float:
        """Stiffness of the springs [N/m]."""
        return self.mass * (2.0 * np.pi / self.natural_period) ** 2

    def angle(self, displacement: float) -> float:
        """Angle that the balls turn while the platform moves by s [rad]."""
        return displacement / (2.0 * self.radius)


def ground_motion(duration: float = 12.0, step: float = 0.01, peak: float = 0.6) -> tuple[np.ndarray, np.ndarray]:
    """Return times [s] and a synthetic ground acceleration [m/s²]: noise of 0.4 to 4 Hz that swells and fades."""
    time = np.arange(0.0, duration, step)
    noise = np.random.default_rng(7).standard_normal(len(time))
    shaped = sosfilt(butter(2, [0.4, 4.0], btype="bandpass", fs=1.0 / step, output="sos"), noise)
    shaped *= (time / 2.0) ** 2 * np.exp(2.0 - time)
    return time, peak * shaped / np.abs(shaped).max()


def respond(platform: Platform, time: np.ndarray, ground: np.ndarray, mesh: vr.Mesh) -> dict[str, np.ndarray]:
    """Integrate the equation of motion; return displacement [m], torque of a contact [N m] and acceleration [m/s²]."""
    stepper = vr.RollingHistory(platform.ball, load=platform.load, start=vr.Start.RELAXED, mesh=mesh, lattices=2)
    s = v = 0.0
    a = -ground[0]
    rows = [(s, stepper.now.driving_torque, a + ground[0])]
    for step, now, shake in zip(np.diff(time), time[1:], ground[1:], strict=True):

        def acceleration(new: float) -> float:
            return 4.0 * (new - s - step * v) / step**2 - a  # noqa: B023  (called in this pass alone)

        def out_of_balance(new: float) -> float:
            trial = copy.copy(stepper)
            torque = trial.advance(time=now, angle=platform.angle(new), load=platform.load).driving_torque  # noqa: B023
            force = platform.stiffness * new + platform.balls * torque / platform.radius
            return platform.mass * (acceleration(new) + shake) + force  # noqa: B023

        guess = s + step * v + 0.5 * step**2 * a
        new = root_scalar(out_of_balance, x0=guess, x1=guess + 1e-7, xtol=1e-10).root
        stepper.advance(time=now, angle=platform.angle(new), load=platform.load)
        s, v, a = new, v + 0.5 * step * (a + acceleration(new)), acceleration(new)
        rows.append((s, stepper.now.driving_torque, a + shake))
    return dict(zip(("displacement", "torque", "acceleration"), np.array(rows).T, strict=True))


def equivalent_damping(platform: Platform, amplitude: float, mesh: vr.Mesh) -> float:
    """Share of critical damping that loses what a cycle of this amplitude [m] loses in the coatings."""
    period = platform.natural_period
    time = np.linspace(0.0, 3.0 * period, 3 * 120 + 1)
    angle = platform.angle(amplitude) * np.sin(2.0 * np.pi * time / period)
    h = vr.roll(platform.ball, time=time, angle=angle, load=platform.load, mesh=mesh, lattices=2)
    lost = np.diff(np.interp([2.0 * period, 3.0 * period], h.time, h.dissipated_energy))[0]  # of one contact
    return float(2.0 * platform.balls * lost / (2.0 * np.pi * platform.stiffness * amplitude**2))


def break_away(platform: Platform, stand: float, mesh: vr.Mesh) -> float:
    """Force that moves the platform again after standing for some time [N]."""
    time, angle = np.cumsum([0.0, 0.5, stand, 0.5]), [0.0, 1.0, 1.0, 1.2]
    h = vr.roll(platform.ball, time=time, angle=angle, load=platform.load, start=vr.Start.FRESH, mesh=mesh, lattices=2)
    return float(platform.balls * h.driving_torque[h.time > time[2]].max() / platform.radius)


def draw(time: np.ndarray, ground: np.ndarray, platform: Platform, found: dict[str, np.ndarray]) -> Figure:
    """Draw accelerations and displacement over time, and the loop of the balls' force."""
    figure = Figure(figsize=(11.0, 4.6), layout="constrained")
    axes = figure.subplot_mosaic([["acceleration", "loop"], ["displacement", "loop"]])
    axes["acceleration"].plot(time, ground, color="0.6", label="ground")
    axes["acceleration"].plot(time, found["acceleration"], label="platform")
    axes["acceleration"].set_ylabel("acceleration [m/s²]")
    axes["acceleration"].legend(fontsize="small")
    axes["displacement"].plot(time, found["displacement"] * 1e3)
    axes["displacement"].set(xlabel="time [s]", ylabel="displacement [mm]")
    force = platform.balls * found["torque"] / platform.radius
    lost = cumulative_trapezoid(force, found["displacement"])[-1]
    axes["loop"].plot(found["displacement"] * 1e3, force)
    axes["loop"].set(
        xlabel="displacement [mm]", ylabel=f"force of the {platform.balls} balls [N]", title=f"lost: {lost:.3f} J"
    )
    return figure


def main(nodes: int = 200, duration: float = 12.0, picture: str | None = None) -> dict[str, float]:
    """Compute, print and draw; return what was printed."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    layer = vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5)
    platform = Platform(vr.CoatedSphere(core_radius=20e-3, layers=[layer]))
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    time, ground = ground_motion(duration)
    found = respond(platform, time, ground, mesh)
    largest = float(np.abs(found["displacement"]).max())
    numbers = {
        "largest displacement [mm]": largest * 1e3,
        "largest acceleration of the platform [m/s²]": float(np.abs(found["acceleration"]).max()),
        "largest acceleration of the ground [m/s²]": float(np.abs(ground).max()),
        "equivalent damping at that amplitude [%]": 100.0 * equivalent_damping(platform, largest, mesh),
    }
    for stand in (0.0, 0.1, 1.0, 10.0):
        numbers[f"break-away force after standing {stand:g} s [N]"] = break_away(platform, stand, mesh)
    for name, value in numbers.items():
        print(f"{name:<48} {value:8.3f}")
    if picture:
        draw(time, ground, platform, found).savefig(picture, dpi=150)
    return numbers


if __name__ == "__main__":
    main(picture=sys.argv[1] if len(sys.argv) > 1 else None)
