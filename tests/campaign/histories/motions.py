"""Random motions: waypoints of angle and load, between which a body rolls, stands, jumps or is lifted."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

__all__ = ["Motion", "draw_motion"]


@dataclass
class Motion:
    """Waypoints, appended one by one.

    Attributes
    ----------
    time, angle, load : list of float
        [s], [rad], and [N], for a roller [N/m].
    """

    time: list[float] = field(default_factory=list)
    angle: list[float] = field(default_factory=list)
    load: list[float] = field(default_factory=list)

    def go(self, duration: float, turn: float, load: float) -> None:
        """Append a waypoint."""
        self.time.append(self.time[-1] + duration)
        self.angle.append(self.angle[-1] + turn)
        self.load.append(load)

    @property
    def lifts(self) -> bool:
        """Return whether the body lifts off anywhere."""
        return 0.0 in self.load

    @property
    def jumps(self) -> bool:
        """Return whether any segment takes zero time."""
        return any(later == time for time, later in zip(self.time, self.time[1:], strict=False))


def draw_motion(rng: np.random.Generator, *, turn: float, time: float, load: float) -> Motion:
    """Return a random motion.

    Parameters
    ----------
    rng : Generator
        Random numbers of the case.
    turn : float
        Angle by which a body turns while it rolls half the length of its contact [rad].
    time : float
        Time of this turn [s].
    load : float
        Load that the layers support [N], for a roller [N/m].
    """
    elsewhere = rng.random() < 0.5  # start at other values than 0 s and 0 rad
    motion = Motion(
        time=[elsewhere * time * rng.uniform(-1.0, 1.0)],
        angle=[elsewhere * rng.uniform(-3.0, 3.0)],
        load=[load * rng.uniform(0.3, 1.0)],
    )
    for _ in range(rng.integers(2, 6)):
        supported = load * rng.uniform(0.3, 1.0) if rng.random() < 0.5 else motion.load[-1]
        stretch = rng.uniform(0.3, 3.0)
        speed = 10.0 ** rng.uniform(-0.5, 0.5)
        match rng.choice(["forward", "backward", "stand", "jump", "lift"], p=[0.35, 0.25, 0.2, 0.1, 0.1]):
            case "forward":
                motion.go(stretch * time / speed, stretch * turn, supported)
            case "backward":
                motion.go(stretch * time / speed, -stretch * turn, supported)
            case "stand":
                motion.go(time * 10.0 ** rng.uniform(-1.0, 2.0), 0.0, supported)
            case "jump":
                # A state between two jumps to the same position contains only one of them.
                turned = turn * rng.uniform(-0.3, 0.3) if rng.random() < 0.3 else 0.0
                motion.go(0.0, turned, load * rng.uniform(0.3, 1.0))
            case _:
                rolls = rng.choice([-1.0, 0.0, 1.0], size=3)  # before, during and after the lift
                for rolled, left in zip(rolls.tolist(), (0.0, 0.0, supported), strict=True):
                    motion.go(stretch * time / speed, rolled * stretch * turn / 3.0, left)
    return motion
