"""A platform on steel balls between dishes with rubber, on ground that shakes: worked out for docs/jobs/isolation.md.

Every ball, of radius R, rolls between a dish in the floor and an equal one, upside down, in the platform. Both have the
radius ρ, and both contacts go the way s = ρ θ along them, θ the slope there: the platform swings as a pendulum of the
length L = 2 (ρ - R),

    m (L θ'' + g sin θ + a_g cos θ) + N M / R = 0,    N P = m (g cos θ + L θ'² - a_g sin θ),

displaced by L sin θ and lifted by L (1 - cos θ). P is what a contact bears, and M its moment: the two contacts of a
ball cost 2 M (1/R - 1/ρ) a way s, which is M / R a way L θ. Slowly, with W the platform's weight on a ball, that is a
level force W tan θ + M / (R cos θ) under a load W / cos θ: what restores and what is lost add up. Balls weigh nothing.

M depends on all that was before, so it comes from a rolling history, a step of Newmark's rule at a time; or, nearly, on
load and speed alone, from a fitted surface, and then any integrator will do.

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

    layers: tuple[vr.Layer, ...]  # of every dish
    ball_radius: float = 21e-3  # R [m]
    dish_radius: float = 0.4  # ρ [m]
    rim: float = 60e-3  # way along a dish to its rim [m]
    balls: int = 4
    mass: float = 400.0 / GRAVITY  # [kg]

    @property
    def ball(self) -> vr.CoatedSphere:
        """A ball, all core."""
        return vr.CoatedSphere(core_radius=self.ball_radius)

    @property
    def dish(self) -> vr.Groove:
        """A dish, alike along and across."""
        return vr.Groove(radius=self.dish_radius, path_radius=self.dish_radius, layers=self.layers)

    @property
    def length(self) -> float:
        """Length of the pendulum that the platform is, L [m]."""
        return 2.0 * (self.dish_radius - self.ball_radius)

    @property
    def period(self) -> float:
        """Period of small swings without loss [s]."""
        return float(2.0 * np.pi * np.sqrt(self.length / GRAVITY))

    def way(self, slope: float) -> float:
        """Way of the contacts along their dishes [m].

        Raises
        ------
        ValueError
            Beyond the rim.
        """
        way = self.dish_radius * slope
        if abs(way) > self.rim:
            raise ValueError(f"way must be within the rim of the dish, ±{self.rim:g} m, got {way:g} m")
        return way

    def load(self, slope: float, rate: float, shake: float) -> float:
        """Load on each contact [N]; 0 where the ground falls faster than the platform."""
        pressing = GRAVITY * np.cos(slope) + self.length * rate**2 - shake * np.sin(slope)
        return max(0.0, self.mass * float(pressing) / self.balls)

    def swing(self, slope: float, shake: float, moment: float) -> float:
        """Acceleration of the slope, θ'' [rad/s²], by the moment M of each contact."""
        pull = GRAVITY * np.sin(slope) + shake * np.cos(slope)
        return -float(pull + self.balls * moment / (self.ball_radius * self.mass)) / self.length

    def energy(self, slope: np.ndarray, rate: np.ndarray) -> np.ndarray:
        """Energy of the swing above the lowest point [J]."""
        return self.mass * self.length * (0.5 * self.length * rate**2 + GRAVITY * (1.0 - np.cos(slope)))


@dataclass(frozen=True)
class Motion:
    """What the platform does over time, and what a contact does."""

    time: np.ndarray  # [s]
    slope: np.ndarray  # θ [rad]
    rate: np.ndarray  # θ' [rad/s]
    acceleration: np.ndarray  # of the platform, level, the ground's among it [m/s²]
    moment: np.ndarray  # M of each contact [N m]
    load: np.ndarray  # P on it [N]

    def displacement(self, platform: Platform) -> np.ndarray:
        """Of the platform against the ground [m]."""
        return platform.length * np.sin(self.slope)

    def force(self, platform: Platform) -> np.ndarray:
        """Level force of the balls on the platform, against the displacement [N]."""
        return -platform.mass * self.acceleration

    def rolled(self, platform: Platform) -> np.ndarray:
        """Work that the balls' rolling has taken since the first instant [J]."""
        force = platform.balls * self.moment / platform.ball_radius
        return cumulative_trapezoid(force, platform.length * self.slope, initial=0.0)


def ground_motion(duration: float = 12.0, step: float = 0.01, peak: float = 2.0) -> tuple[np.ndarray, np.ndarray]:
    """Return times [s] and a synthetic ground acceleration [m/s²]: noise of 0.4 to 4 Hz that swells and fades."""
    time = np.arange(0.0, duration, step)
    noise = np.random.default_rng(7).standard_normal(len(time))
    shaped = sosfilt(butter(2, [0.4, 4.0], btype="bandpass", fs=1.0 / step, output="sos"), noise)
    shaped *= (time / 2.0) ** 2 * np.exp(2.0 - time)
    return time, peak * shaped / np.abs(shaped).max()


def by_newmark(
    platform: Platform, time: np.ndarray, ground: np.ndarray, mesh: vr.Mesh, slope: float = 0.0
) -> tuple[Motion, vr.RollingHistory]:
    """Integrate from rest at a slope by Newmark's average acceleration; return the motion and a contact's history.

    Both dishes are alike, and so are the histories of all contacts: one stands for all. A step that is tried rolls a
    copy, and the one that balances the forces is the history from there on. The rubber makes θ'' answer to itself by
    less than a hundredth, so every pass brings two digits.
    """
    load = platform.load(slope, 0.0, ground[0])
    start = platform.way(slope)
    stepper = vr.RollingHistory(platform.ball, on=platform.dish, load=load, way=start, mesh=mesh, lattices=2)
    rate, swing = 0.0, platform.swing(slope, ground[0], stepper.now.resisting_torque)
    rows = [(slope, rate, swing, stepper.now.resisting_torque, load)]
    for before, now, shake in zip(time[:-1], time[1:], ground[1:], strict=True):
        step, found, change = now - before, swing, np.inf
        while abs(change) > 1e-9 * GRAVITY / platform.length:
            new_slope = slope + step * rate + 0.25 * step**2 * (swing + found)
            new_rate = rate + 0.5 * step * (swing + found)
            load = platform.load(new_slope, new_rate, shake)
            trial = copy.copy(stepper)
            moment = trial.advance(time=now, way=platform.way(new_slope), load=load).resisting_torque
            change = platform.swing(new_slope, shake, moment) - found
            found += change
        stepper, slope, rate, swing = trial, new_slope, new_rate, found
        rows.append((slope, rate, swing, moment, load))
    return as_motion(platform, time, ground, *np.array(rows).T), stepper


def fitted_resistance(platform: Platform, accuracy: float) -> vr.RollingResistance:
    """Fit the steady rolling resistance in a dish over load and speed."""
    loads = platform.mass * GRAVITY / platform.balls * np.array([0.95, 1.0, 1.05])
    speeds = np.geomspace(0.02, 20.0, 13)
    study = vr.sweep(
        platform.ball, on=platform.dish, load=loads, angular_speed=speeds, accuracy=accuracy, progress=False
    )
    return vr.RollingResistance.from_study(study)


def by_solve_ivp(
    platform: Platform, time: np.ndarray, ground: np.ndarray, surface: vr.RollingResistance, slope: float = 0.0
) -> Motion:
    """Integrate by SciPy's method for stiff equations: the torque of steady rolling knows nothing of before."""
    # Power lost per speed is M times what R is of the relative radius.
    share = 1.0 - platform.ball_radius / platform.dish_radius

    def moment(slope: float, rate: float, shake: float) -> float:
        platform.way(slope)  # within the rim
        speed = platform.dish_radius * rate / platform.ball_radius
        return float(surface(platform.load(slope, rate, shake), speed, outside=vr.Extrapolation.HOLD)) / share

    def change(now: float, state: np.ndarray) -> list[float]:
        shake = float(np.interp(now, time, ground))
        return [state[1], platform.swing(state[0], shake, moment(*state, shake))]

    step = time[1] - time[0]  # of the ground's record, which is to be seen
    done = solve_ivp(change, time[[0, -1]], [slope, 0.0], "LSODA", time, rtol=1e-7, atol=1e-9, max_step=step)
    states = list(zip(*done.y, ground, strict=True))
    moments = np.array([moment(*state) for state in states])
    swings = [platform.swing(s, shake, m) for (s, _, shake), m in zip(states, moments, strict=True)]
    loads = np.array([platform.load(*state) for state in states])
    return as_motion(platform, time, ground, *done.y, np.array(swings), moments, loads)


def as_motion(
    platform: Platform, time: np.ndarray, ground: np.ndarray, slope: np.ndarray, rate: np.ndarray, swing: np.ndarray,
    moment: np.ndarray, load: np.ndarray,
) -> Motion:  # fmt: skip
    """Return a motion, with the platform's acceleration."""
    level = platform.length * (swing * np.cos(slope) - rate**2 * np.sin(slope))
    return Motion(time, slope, rate, level + ground, moment, load)


def break_away(platform: Platform, stand: float, mesh: vr.Mesh) -> float:
    """Force that moves the platform again after a millimeter's roll and standing for some time [N]."""
    time, way = np.cumsum([0.0, 0.4, stand, 0.2]), [-20e-3, 0.0, 0.0, 10e-3]
    load = platform.mass * GRAVITY / platform.balls
    h = vr.roll(platform.ball, on=platform.dish, time=time, way=way, load=load, mesh=mesh, lattices=2)
    return float(platform.balls * h.resisting_torque[h.time > time[2]].max() / platform.ball_radius)


def draw(time: np.ndarray, ground: np.ndarray, platform: Platform, motions: dict[str, Motion]) -> Figure:
    """Draw accelerations and displacement over time, and the loop of all forces of the balls."""
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
    """Compute, print and draw; return what was printed."""
    rubber = vr.StandardLinearSolid(instantaneous_modulus=6e6, relaxed_modulus=3e6, relaxation_time=0.125)
    platform = Platform(layers=(vr.Layer(thickness=1e-3, shear_modulus=rubber, poisson_ratio=0.5),))
    mesh = vr.Mesh(nodes_per_revolution=nodes)
    time, ground = ground_motion(duration)
    motions = {
        "by histories": by_newmark(platform, time, ground, mesh)[0],
        "by steady torque": by_solve_ivp(platform, time, ground, fitted_resistance(platform, accuracy)),
    }
    numbers = {
        "period of small swings without loss [s]": platform.period,
        "largest acceleration of the ground [m/s²]": float(np.abs(ground).max()),
    }
    for name, motion in motions.items():
        numbers |= {
            f"largest displacement, {name} [mm]": float(np.abs(motion.displacement(platform)).max()) * 1e3,
            f"largest acceleration, {name} [m/s²]": float(np.abs(motion.acceleration).max()),
            f"taken by rolling, {name} [mJ]": float(motion.rolled(platform)[-1]) * 1e3,
        }
    for stand in (0.0, 0.1, 1.0, 10.0):
        numbers[f"break-away force after standing {stand:g} s [N]"] = break_away(platform, stand, mesh)
    for name, value in numbers.items():
        print(f"{name:<56} {value:8.3f}")
    if picture:
        draw(time, ground, platform, motions).savefig(picture, dpi=150)
    return numbers


if __name__ == "__main__":
    main(picture=sys.argv[1] if len(sys.argv) > 1 else None)
