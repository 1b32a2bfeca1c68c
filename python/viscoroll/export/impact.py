"""Normal impact of a ball: force over approach, coefficient of restitution and damping constants."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import _core
from .._support.arguments import Floats, as_float, as_int, require_type
from .._support.errors import InvalidInput
from .._support.files import write_csv
from .._support.pictures import draw_picture
from .._support.plotting import plots
from .._support.progress import ProgressLike, Report, reporting
from .._support.quantities import quantity_text
from .._support.result_warnings import warn
from .._support.scales import Scale
from ..bodies import Counterbody, Mesh, RollingBody
from ..transient import RollingHistory
from ..transient.history_warnings import strain_warnings
from .balls import balls_of
from .resolved import resolved

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["SCALARS", "Impact", "impact"]

#: Columns of a saved impact, with their units.
_COLUMNS = {"time": "s", "approach": "m", "speed": "m/s", "force": "N", "stored_energy": "J", "dissipated_energy": "J"}

#: Steps in the time that the ball needs for the largest approach at its initial speed; an elastic impact has three
#: times as many. The steps are halved until energy is balanced within the tolerance, at most this many times less one.
#: An error that remains above the last number is a warning.
_STEPS, _TOLERANCE, _HALVINGS, _WORTH_MENTION = 100, 2e-4, 4, 1e-3

#: Shortest relaxation time of the materials, relative to the step. Forces are linear over a step. In a material that
#: relaxes much faster, they would alternate from step to step about the right value, at an amplitude that does not
#: depend on the step, and dissipate 1/12 of the square of their change. With a fourth of the step, they approach it by
#: a factor of -1/3 per step.
_SHORTEST_RELAXATION = 0.25

#: Longest impact, relative to the time of the largest approach at the initial speed; an elastic impact takes 3 of them.
_LONGEST = 200

#: Ratio of approaches of neighboring steps in the estimate of the largest approach, the first approach relative to the
#: radius, and the nodes per revolution of its first mesh.
_GROWTH, _FIRST_APPROACH, _FIRST_NODES = 1.15, 1e-6, 128

#: Initial load, relative to the largest force of a ball that stops within its largest approach.
_FIRST_LOAD = 1e-8


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Impact:
    """Normal impact of a ball that does not rotate: time series from first contact to separation.

    Attributes
    ----------
    mass : float
        Mass of the ball, for two balls m₁m₂/(m₁+m₂) [kg].
    time : ndarray
        Time since first contact [s].
    approach : ndarray
        Approach δ of the centers, or penetration into the plane [m].
    speed : ndarray
        Speed of approach dδ/dt [m/s], negative while the ball rebounds.
    force : ndarray
        Contact force [N].
    stored_energy : ndarray
        Energy stored in the layers [J].
    dissipated_energy : ndarray
        Energy dissipated in the layers since first contact [J], computed from the memory of the material.
    mesh : Mesh
        Surface mesh.
    """

    mass: float
    time: Floats
    approach: Floats
    speed: Floats
    force: Floats
    stored_energy: Floats
    dissipated_energy: Floats
    mesh: Mesh

    @property
    def impact_speed(self) -> float:
        """Speed v of approach at first contact [m/s]."""
        return float(self.speed[0])

    @property
    def rebound_speed(self) -> float:
        """Speed of separation at the end of contact [m/s]."""
        return -float(self.speed[-1])

    @property
    def restitution(self) -> float:
        """Coefficient of restitution e, rebound speed / impact speed, at most 1 [-]."""
        return min(self.rebound_speed / self.impact_speed, 1.0)

    @property
    def duration(self) -> float:
        """Duration of contact [s]."""
        return float(self.time[-1])

    @property
    def largest_force(self) -> float:
        """Largest contact force [N]."""
        return float(self.force.max())

    @property
    def largest_approach(self) -> float:
        """Largest approach [m]."""
        return float(self.approach.max())

    @property
    def lost_energy(self) -> float:
        """Kinetic energy that the impact takes, (1 - e²) m v²/2 [J].

        It is the energy dissipated during contact plus the energy that is still stored in the layers at separation and
        dissipated later.
        """
        return 0.5 * self.mass * (self.impact_speed**2 - self.rebound_speed**2)

    @property
    def energy_balance_error(self) -> float:
        """Largest error of the balance of kinetic, stored and dissipated energy, relative to the initial energy [-]."""
        kinetic = 0.5 * self.mass * self.speed**2
        total = kinetic + self.stored_energy + self.dissipated_energy
        return float(np.abs(total - total[0]).max() / kinetic[0])

    @cached_property
    def damping_ratio(self) -> float:
        """Damping ratio ζ = -ln e / √(π² + ln² e) [-].

        A linear spring k with the damper 2 ζ √(k m) has this restitution at every speed; so has Hertz's law
        P = k δ^(3/2) with the damping force √5 ζ √(k m) δ^(1/4) dδ/dt. In both, contact ends at δ = 0. Source:
        Y. Tsuji, T. Tanaka and T. Ishida, Powder Technology 71 (1992) 239; D. Antypov and J. A. Elliott, EPL 94 (2011)
        50004.
        """
        logarithm = math.log(self.restitution)
        return -logarithm / math.hypot(math.pi, logarithm)

    @property
    def dashpot(self) -> float:
        """Damping constant of a linear spring and dashpot with this restitution and duration of contact [N s/m].

        c = -2 m ln e / duration. The stiffness of its spring is `spring`.
        """
        return -2.0 * self.mass * math.log(self.restitution) / self.duration

    @property
    def spring(self) -> float:
        """Stiffness of a linear spring and dashpot with this restitution and duration of contact [N/m].

        k = m (π² + ln² e) / duration².
        """
        return self.mass * (math.pi**2 + math.log(self.restitution) ** 2) / self.duration**2

    def scalars(self) -> dict[str, float]:
        """Return the numbers of the impact by name, in SI units."""
        return {name: float(getattr(self, name)) for name in SCALARS}

    def __repr__(self) -> str:
        """Return a line for each number of the impact."""
        values = self.scalars()
        width = max(len(label) for label, _ in SCALARS.values()) + 2
        lines = [f"{label:{width}}{quantity_text(values[name], unit)}" for name, (label, unit) in SCALARS.items()]
        return "\n".join(["Normal impact of a ball", *(f"  {line}" for line in lines)])

    def save(self, path: str | Path) -> None:
        """Write the time series to a CSV file."""
        write_csv({f"{name} [{unit}]": getattr(self, name).tolist() for name, unit in _COLUMNS.items()}, Path(path))

    @plots("force over approach")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the force over the approach."""
        across, up = Scale.of(self.approach, "m"), Scale.of(self.force, "N")

        def draw(axes: Axes) -> None:
            axes.plot(self.approach / across.factor, self.force / up.factor)
            axes.set_xlabel(across.text("approach"))
            axes.set_ylabel(up.text("contact force"))
            axes.set_title(f"restitution {self.restitution:.3g} at {quantity_text(self.impact_speed, 'm/s')}")

        return draw_picture(draw, ax, figsize=(6.4, 4.4))


#: Numbers of an impact: label and unit.
SCALARS = {
    "impact_speed": ("impact speed", "m/s"),
    "restitution": ("coefficient of restitution", "1"),
    "rebound_speed": ("rebound speed", "m/s"),
    "lost_energy": ("kinetic energy lost", "J"),
    "duration": ("duration of contact", "s"),
    "largest_force": ("largest force", "N"),
    "largest_approach": ("largest approach", "m"),
    "damping_ratio": ("damping ratio", "1"),
    "dashpot": ("dashpot of a linear model", "N s/m"),
    "spring": ("spring of a linear model", "N/m"),
    "energy_balance_error": ("error of the energy balance", "1"),
}


def impact(
    ball: RollingBody,
    *,
    mass: float,
    speed: float,
    on: Counterbody | None = None,
    nodes: int = 16,
    averaged_meshes: int = 1,
    progress: ProgressLike = None,
) -> Impact:
    """Compute the normal impact of a ball that does not rotate.

    Only the mass of the ball and the viscoelastic layers act: weight, adhesion and waves in the layers are neglected.
    The contact is that of `viscoroll.roll`, and the equation of motion is integrated by the velocity Verlet method.
    Relaxation that is faster than the steps, such as that of a Kelvin-Voigt solid, is computed as a term of the same
    viscosity with a fourth of the step as its relaxation time; this changes the restitution by less than 1e-3.

    Parameters
    ----------
    ball : CoatedSphere
        Ball with layers, or a rigid ball on a deformable counterbody.
    mass : float
        Mass m of the ball [kg], > 0. For two free balls m₁m₂/(m₁+m₂), half of the mass of each for identical balls.
    speed : float
        Speed v of approach at first contact [m/s], > 0.
    on : CoatedPlane or CoatedSphere, optional
        Counterbody at rest, same as in `viscoroll.solve`; by default the rigid plane.
    nodes : int, default 16
        Nodes across the largest contact, in [8, 200].
    averaged_meshes : int, default 1
        Number of shifted meshes over which the force is averaged, in [1, 16].
    progress : bool or callable, optional
        True shows a progress bar; a callable is called as progress(stage, fraction).

    Returns
    -------
    Impact
        Force, approach and energies over time, coefficient of restitution and damping constants.

    Raises
    ------
    ValueError
        If an argument is out of range, or the body is not a ball on a plane or on another ball.
    ConvergenceError
        If contact does not end: a material without elasticity at rest may hold the ball.

    Warns
    -----
    ResultWarning
        If the strain is above 0.2, or the error of the energy balance above 1e-3.

    Examples
    --------
    >>> from viscoroll import paper
    >>> hit = impact(paper.ball(), mass=0.3, speed=0.1)
    >>> f"restitution {hit.restitution:.3f}, contact of {hit.duration * 1e3:.1f} ms"
    'restitution 0.996, contact of 2.9 ms'
    """
    require_type("ball", ball, RollingBody)
    balls_of(ball, on)
    mass, speed = (
        _positive(name, value, unit) for name, value, unit in (("mass", mass, "kg"), ("speed", speed, "m/s"))
    )
    nodes = as_int("nodes", nodes)
    if not 8 <= nodes <= 200:
        raise InvalidInput("nodes", "must be in [8, 200]", f"{nodes}")
    pair = _Pair(ball, on, as_int("averaged_meshes", averaged_meshes))
    with reporting(progress) as report:
        mesh, largest = _mesh(pair, mass, speed, nodes)
        step = largest / speed / _STEPS
        for _ in range(_HALVINGS):
            found = _integrated(pair, mesh, mass=mass, speed=speed, largest=largest, step=step, report=report)
            if found.energy_balance_error <= _TOLERANCE:
                break
            step *= 0.5
    warn([*strain_warnings(ball, on, found.approach), *_balance_warnings(found)])
    return found


def _balance_warnings(found: Impact) -> list[str]:
    """Return a warning if the energy balance has a large error."""
    if found.energy_balance_error <= _WORTH_MENTION:
        return []
    return [
        f"the error of the energy balance is {found.energy_balance_error:.2g} of the kinetic energy (recommended: at "
        f"most {_WORTH_MENTION:g}): the squared restitution may have an error as large; use more nodes"
    ]


def _positive(name: str, value: float, unit: str) -> float:
    number = as_float(name, value)
    if not 0.0 < number < math.inf:
        raise InvalidInput(name, f"must be in (0, inf) {unit}", f"{number:g}")
    return number


@dataclass(frozen=True, slots=True)
class _Pair:
    """Ball and counterbody, and the number of shifted meshes."""

    ball: RollingBody
    on: Counterbody | None
    averaged_meshes: int

    @property
    def deepest(self) -> float:
        """Largest approach for which a contact is computed [m]: half of the radius or 90 % of the layers."""
        depth = sum(one.depth for one in (self.ball, self.on) if one is not None)
        return min(0.5 * self.ball.outer_radius, 0.9 * depth)

    def resolved(self, shortest: float) -> _Pair:
        """Return the pair with materials that do not relax in less than a given time [s]."""
        on = None if self.on is None else resolved(self.on, shortest)
        return replace(self, ball=resolved(self.ball, shortest), on=on)

    def touching(self, load: float, mesh: Mesh, *, shortest: float, longest: float) -> RollingHistory:
        """Return the history of a pair that has just touched under a small load."""
        return RollingHistory(
            self.ball,
            on=self.on,
            load=load,
            start="undeformed",
            mesh=mesh,
            averaged_meshes=self.averaged_meshes,
            steps_per_spacing=None,
            shortest_time=shortest,
            longest_time=longest,
        )


def _mesh(pair: _Pair, mass: float, speed: float, nodes: int) -> tuple[Mesh, float]:
    """Return a mesh with as many nodes across the largest contact, and an estimate of the largest approach [m]."""
    per_revolution = _FIRST_NODES
    while True:
        mesh = Mesh(nodes_per_revolution=per_revolution)
        largest, length = _estimated(pair, mesh, mass, speed)
        needed = 2 * math.ceil(math.pi * pair.ball.outer_radius * nodes / length)
        if needed <= per_revolution:
            return Mesh(nodes_per_revolution=max(needed, 16)), largest
        per_revolution = min(needed, 4 * per_revolution)


def _estimated(pair: _Pair, mesh: Mesh, mass: float, speed: float) -> tuple[float, float]:
    """Return the approach at which a ball of constant speed has done the work m v²/2, and the contact length there."""
    radius = pair.ball.outer_radius
    approach, load, work, time = 0.0, 0.0, 0.0, 0.0
    following = _FIRST_APPROACH * radius
    energy = 0.5 * mass * speed**2
    shortest = 0.1 * following / speed
    history = pair.resolved(shortest).touching(
        _FIRST_LOAD * energy / radius, mesh, shortest=shortest, longest=10.0 * radius / speed
    )
    start = history.current.penetration
    while True:
        time += (following - approach) / speed
        now = history.advance(time=time, angle=0.0, axle_height=radius - start - following)
        work += 0.5 * (load + now.load) * (following - approach)
        approach, load = following, now.load
        if work >= energy:
            return approach, now.contact_length
        following *= _GROWTH
        if following > pair.deepest:
            raise InvalidInput(
                "speed",
                f"must be so small that the ball stops within {quantity_text(pair.deepest, 'm')}",
                f"{speed:g} m/s for a mass of {mass:g} kg",
            )


def _integrated(
    pair: _Pair, mesh: Mesh, *, mass: float, speed: float, largest: float, step: float, report: Report | None
) -> Impact:
    """Integrate the motion of the ball from first contact until the contact force vanishes."""
    longest = _LONGEST * largest / speed
    first = _FIRST_LOAD * mass * speed**2 / largest
    history = pair.resolved(_SHORTEST_RELAXATION * step).touching(
        first, mesh, shortest=0.1 * step, longest=10.0 * longest
    )
    instant = history.current
    radius = pair.ball.outer_radius
    approach, moving, time = instant.penetration, speed, 0.0
    force = instant.load
    rows = [(time, approach, moving, force, instant.stored_energy, instant.dissipated_energy)]
    while force > 0.0 or moving > 0.0:
        if time > longest:
            raise _core.ConvergenceError(
                f"the impact lasts more than {longest:.3g} s, {_LONGEST} times the time of the approach: the material "
                "may hold the ball; use a material with a larger relaxed modulus"
            )
        approach += (moving - 0.5 * step * force / mass) * step
        time += step
        instant = history.advance(time=time, angle=0.0, axle_height=radius - approach)
        moving -= 0.5 * step * (force + instant.load) / mass
        force = instant.load
        rows.append((time, approach, moving, force, instant.stored_energy, instant.dissipated_energy))
        if report is not None and len(rows) % 16 == 0:
            report("impact", 0.5 - 0.5 * moving / speed)
    series = (np.asarray(column) for column in zip(*rows, strict=True))
    return Impact(mass=mass, mesh=history.mesh, **dict(zip(_COLUMNS, series, strict=True)))
