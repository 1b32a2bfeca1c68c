"""Motion of a platform on steel balls between dishes with rubber on shaking ground, for docs/jobs/isolation.md.

Each ball of radius R rolls between a dish in the floor and an identical, inverted dish in the platform, both of radius
ρ. Where the slope of the dishes is θ, each contact has traveled s = ρ θ along its dish. The platform swings as a
pendulum of the length L = 2 (ρ - R):

    m (L θ'' + g sin θ + a_g cos θ) + N M / R = 0,    N P = m (g cos θ + L θ'² - a_g sin θ).

The platform is displaced by L sin θ and lifted by L (1 - cos θ). m is its mass, a_g the horizontal acceleration of the
ground and N the number of balls, whose mass is neglected. P is the normal load of a contact and M its resisting moment.
The two contacts of a ball dissipate the energy 2 M (1/R - 1/ρ) per contact travel s, which equals M / R per L θ. If the
platform moves slowly, a ball that supports the weight W has the load P = W / cos θ + (M / R) tan θ and exerts the
horizontal force W tan θ + M / (R cos θ): restoring force plus rolling resistance.

M depends on the whole history of the motion. `by_newmark` therefore advances a rolling history with each step of
Newmark's method. `by_solve_ivp` approximates M by its steady value, a fitted function of load and speed that works
with any integrator.

    python docs/jobs/isolation_platform.py [picture.png]
"""

from __future__ import annotations

import copy
import sys
from dataclasses import dataclass

import numpy as np
import viscoroll as vr
from matplotlib.figure import Figure
from scipy.integrate import cumulative_trapezoid, solve_ivp
from scipy.signal import butter, sosfilt

GRAVITY = 9.81  # [m/s²]


@dataclass(frozen=True)
class Platform:
    """Platform, balls and dishes."""

    layers: tuple[vr.Layer, ...]  # of each dish
    ball_radius: float = 21e-3  # R [m]
    dish_radius: float = 0.4  # ρ [m]
    rim: float = 60e-3  # arc length from the center of a dish to its rim [m]
    balls: int = 4
    mass: float = 400.0 / GRAVITY  # [kg]

    @property
    def ball(self) -> vr.CoatedSphere:
        """Rigid ball without layers."""
        return vr.CoatedSphere(core_radius=self.ball_radius)

    @property
    def dish(self) -> vr.Groove:
        """Dish with the same radius along and across the path."""
        return vr.Groove(radius=self.dish_radius, path_radius=self.dish_radius, layers=self.layers)

    @property
    def length(self) -> float:
        """Length L of the equivalent pendulum [m]."""
        return 2.0 * (self.dish_radius - self.ball_radius)

    @property
    def period(self) -> float:
        """Period of small oscillations without loss [s]."""
        return float(2.0 * np.pi * np.sqrt(self.length / GRAVITY))

    def distance(self, slope: float) -> float:
        """Travel of the contacts along their dishes at a slope [m].

        Raises
        ------
        ValueError
            If a contact would be beyond the rim.
        """
        distance = self.dish_radius * slope
        if abs(distance) > self.rim:
            raise ValueError(
                f"distance must be in [-{self.rim:g}, {self.rim:g}] m, within the rim of the dish, got {distance:g} m"
            )
        return distance

    def load(self, slope: float, rate: float, shake: float) -> float:
        """Load on each contact [N], under the ground acceleration `shake` [m/s²]; 0 if the platform lifts off."""
        pressing = GRAVITY * np.cos(slope) + self.length * rate**2 - shake * np.sin(slope)
        return max(0.0, self.mass * float(pressing) / self.balls)

    def angular_acceleration(self, slope: float, shake: float, moment: float) -> float:
        """Second derivative θ'' of the slope [rad/s²], with the moment M of each contact."""
        pull = GRAVITY * np.sin(slope) + shake * np.cos(slope)
        return -float(pull + self.balls * moment / (self.ball_radius * self.mass)) / self.length

    def energy(self, slope: np.ndarray, rate: np.ndarray) -> np.ndarray:
        """Kinetic plus potential energy relative to rest at the lowest point [J]."""
        return self.mass * self.length * (0.5 * self.length * rate**2 + GRAVITY * (1.0 - np.cos(slope)))


@dataclass(frozen=True)
class Motion:
    """Motion of the platform, with moment and load of a contact."""

    time: np.ndarray  # [s]
    slope: np.ndarray  # θ [rad]
    rate: np.ndarray  # θ' [rad/s]
    acceleration: np.ndarray  # of the platform, horizontal, including the ground's [m/s²]
    moment: np.ndarray  # M of each contact [N m]
    load: np.ndarray  # P of each contact [N]

    def displacement(self, platform: Platform) -> np.ndarray:
        """Horizontal displacement of the platform relative to the ground [m]."""
        return platform.length * np.sin(self.slope)

    def force(self, platform: Platform) -> np.ndarray:
        """Horizontal force of the balls on the platform, positive against the displacement [N]."""
        return -platform.mass * self.acceleration

    def rolled(self, platform: Platform) -> np.ndarray:
        """Work against the rolling resistance since the start [J]."""
        force = platform.balls * self.moment / platform.ball_radius
        return cumulative_trapezoid(force, platform.length * self.slope, initial=0.0)


def ground_motion(duration: float = 12.0, step: float = 0.01, peak: float = 2.0) -> tuple[np.ndarray, np.ndarray]:
    """Return times [s] and a synthetic ground acceleration [m/s²]: noise of 0.4 to 4 Hz that rises and decays."""
    time = np.arange(0.0, duration, step)
    noise = np.random.default_rng(7).standard_normal(len(time))
    shaped = sosfilt(butter(2, [0.4, 4.0], btype="bandpass", fs=1.0 / step, output="sos"), noise)
    shaped *= (time / 2.0) ** 2 * np.exp(2.0 - time)
    return time, peak * shaped / np.abs(shaped).max()


def by_newmark(
    platform: Platform, time: np.ndarray, ground: np.ndarray, mesh: vr.Mesh, slope: float = 0.0
) -> tuple[Motion, vr.RollingHistory]:
    """Integrate from rest at a slope by Newmark's average acceleration; return the motion and a contact's history.

    All contacts have the same history, because the dishes are identical; one history represents them all. Each
    iteration of a step advances a copy of the history. The copy that balances the forces replaces the history. The
    moment depends so weakly on θ'' that each iteration reduces the error of θ'' at least a hundredfold.
    """
    load = platform.load(slope, 0.0, ground[0])
    start = platform.distance(slope)
    stepper = vr.RollingHistory(
        platform.ball, on=platform.dish, load=load, distance=start, mesh=mesh, averaged_meshes=2
    )
    rate, acceleration = 0.0, platform.angular_acceleration(slope, ground[0], stepper.current.resisting_torque)
    rows = [(slope, rate, acceleration, stepper.current.resisting_torque, load)]
    for before, now, shake in zip(time[:-1], time[1:], ground[1:], strict=True):
        step, found, change = now - before, acceleration, np.inf
        while abs(change) > 1e-9 * GRAVITY / platform.length:
            new_slope = slope + step * rate + 0.25 * step**2 * (acceleration + found)
            new_rate = rate + 0.5 * step * (acceleration + found)
            load = platform.load(new_slope, new_rate, shake)
            trial = copy.copy(stepper)
            moment = trial.advance(time=now, distance=platform.distance(new_slope), load=load).resisting_torque
            change = platform.angular_acceleration(new_slope, shake, moment) - found
            found += change
        stepper, slope, rate, acceleration = trial, new_slope, new_rate, found
        rows.append((slope, rate, acceleration, moment, load))
    return as_motion(platform, time, ground, *np.array(rows).T), stepper


def fitted_resistance(platform: Platform, accuracy: float) -> vr.studies.RollingResistance:
    """Fit the steady rolling resistance in a dish over load and speed."""
    loads = platform.mass * GRAVITY / platform.balls * np.array([0.95, 1.0, 1.05])
    speeds = np.geomspace(0.02, 20.0, 13)
    study = vr.sweep(
        platform.ball, on=platform.dish, load=loads, angular_speed=speeds, accuracy=accuracy, progress=False
    )
    return vr.studies.RollingResistance.from_study(study)


def by_solve_ivp(
    platform: Platform, time: np.ndarray, ground: np.ndarray, surface: vr.studies.RollingResistance, slope: float = 0.0
) -> Motion:
    """Integrate with the torque of steady rolling, which does not depend on the history, by SciPy's LSODA."""
    # Dissipated power / angular speed is M (1 - R/ρ).
    factor = 1.0 - platform.ball_radius / platform.dish_radius

    def moment(slope: float, rate: float, shake: float) -> float:
        platform.distance(slope)  # raises an error beyond the rim
        speed = platform.dish_radius * rate / platform.ball_radius
        return float(surface(platform.load(slope, rate, shake), speed, outside="hold")) / factor

    def change(now: float, state: np.ndarray) -> list[float]:
        shake = float(np.interp(now, time, ground))
        return [state[1], platform.angular_acceleration(state[0], shake, moment(*state, shake))]

    step = time[1] - time[0]  # longer integration steps would skip parts of the ground's motion
    done = solve_ivp(change, time[[0, -1]], [slope, 0.0], "LSODA", time, rtol=1e-7, atol=1e-9, max_step=step)
    states = list(zip(*done.y, ground, strict=True))
    moments = np.array([moment(*state) for state in states])
    accelerations = [
        platform.angular_acceleration(s, shake, m) for (s, _, shake), m in zip(states, moments, strict=True)
    ]
    loads = np.array([platform.load(*state) for state in states])
    return as_motion(platform, time, ground, *done.y, np.array(accelerations), moments, loads)


def as_motion(
    platform: Platform, time: np.ndarray, ground: np.ndarray, slope: np.ndarray, rate: np.ndarray, swing: np.ndarray,
    moment: np.ndarray, load: np.ndarray,
) -> Motion:  # fmt: skip
    """Return the motion with the acceleration of the platform; `swing` is θ''."""
    level = platform.length * (swing * np.cos(slope) - rate**2 * np.sin(slope))
    return Motion(time, slope, rate, level + ground, moment, load)


def break_away(platform: Platform, dwell: float, mesh: vr.Mesh) -> float:
    """Largest force that moves the platform 10 mm away from the center after a rest of `dwell` seconds [N]."""
    time, distance = np.cumsum([0.0, 0.4, dwell, 0.2]), [-20e-3, 0.0, 0.0, 10e-3]
    load = platform.mass * GRAVITY / platform.balls
    h = vr.roll(platform.ball, on=platform.dish, time=time, distance=distance, load=load, mesh=mesh, averaged_meshes=2)
    return float(platform.balls * h.resisting_torque[h.time > time[2]].max() / platform.ball_radius)


def draw(time: np.ndarray, ground: np.ndarray, platform: Platform, motions: dict[str, Motion]) -> Figure:
    """Draw accelerations and displacement over time, and the total force of the balls over the displacement."""
    figure = Figure(figsize=(11.0, 4.6), layout="constrained")
    axes = figure.subplot_mosaic([["acceleration", "loop"], ["displacement", "loop"]])
    axes["acceleration"].plot(time, ground, color="0.6", label="ground")
    for name, motion in motions.items():
        displacement = motion.displacement(platform) * 1e3
        axes["acceleration"].plot(time, motion.acceleration, label=name)
        axes["displacement"].plot(time, displacement)
        axes["loop"].plot(displacement, motion.force(platform), linewidth=0.8)
    axes["acceleration"].set_ylabel("acceleration [m/s²]")
    axes["acceleration"].legend(fontsize="small")
    axes["displacement"].set(xlabel="time [s]", ylabel="displacement [mm]")
    axes["loop"].set(xlabel="displacement [mm]", ylabel=f"force of the {platform.balls} balls [N]")
    return figure


def main(
    nodes: int = 400, accuracy: float = 0.01, duration: float = 12.0, picture: str | None = None
) -> dict[str, float]:
    """Compute and print the numbers, draw the picture if a path is given, and return the numbers."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    platform = Platform(layers=(vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5),))
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    time, ground = ground_motion(duration)
    motions = {
        "by histories": by_newmark(platform, time, ground, mesh)[0],
        "by steady torque": by_solve_ivp(platform, time, ground, fitted_resistance(platform, accuracy)),
    }
    numbers = {
        "period of small oscillations without loss [s]": platform.period,
        "largest acceleration of the ground [m/s²]": float(np.abs(ground).max()),
    }
    for name, motion in motions.items():
        numbers |= {
            f"largest displacement, {name} [mm]": float(np.abs(motion.displacement(platform)).max()) * 1e3,
            f"largest acceleration, {name} [m/s²]": float(np.abs(motion.acceleration).max()),
            f"dissipated by rolling, {name} [mJ]": float(motion.rolled(platform)[-1]) * 1e3,
        }
    for dwell in (0.0, 0.1, 1.0, 10.0):
        numbers[f"break-away force after a dwell of {dwell:g} s [N]"] = break_away(platform, dwell, mesh)
    for name, value in numbers.items():
        print(f"{name:<56} {value:8.3f}")
    if picture:
        draw(time, ground, platform, motions).savefig(picture, dpi=150)
    return numbers


if __name__ == "__main__":
    main(picture=sys.argv[1] if len(sys.argv) > 1 else None)
