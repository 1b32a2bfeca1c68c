"""Height profiles of the ground and of treads."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _core
from .._support.arguments import as_count, as_float, as_float_array, require_callable
from .._support.errors import InvalidInput
from .._support.plotting import plots

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Profile"]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class Profile:
    """Height over distance, linear between points; the same at all lateral positions.

    On the ground, the distance is that along the track: the contact passes it when the body has turned by distance /
    r_o. On a tread, it is the distance around the body, whose points meet the track at the same distance in the first
    revolution.

    Parameters
    ----------
    distance : array_like
        Distances [m], not decreasing, at least two. Two equal distances are a step.
    height : array_like
        Height above the smooth surface at each distance [m]. Linear theory is valid up to about 0.03 of the radius and
        for slopes much smaller than 1. Outside its points, a profile keeps the height of its first or last point.
    periodic : bool, default False
        Whether the profile repeats; the period is the range of the distances.

    Raises
    ------
    ValueError
        If the arrays differ in length, are too short or not finite, or if distances decrease.
    TypeError
        If the arrays do not contain real numbers.

    Examples
    --------
    >>> profile = Profile([0.0, 10e-3, 10e-3, 20e-3], [0.0, 0.0, 1e-3, 1e-3])
    >>> profile.height_at([5e-3, 10e-3]).tolist()
    [0.0, 0.001]
    """

    distance: NDArray[np.float64]
    height: NDArray[np.float64]
    periodic: bool = False

    if TYPE_CHECKING:  # the fields are arrays, but lists are also accepted

        def __init__(self, distance: ArrayLike, height: ArrayLike, periodic: bool = False) -> None: ...

    def __post_init__(self) -> None:
        """Store read-only arrays of floats and check them."""
        for name in ("distance", "height"):
            values = as_float_array(name, getattr(self, name)).copy()
            if values.ndim != 1:
                raise InvalidInput(name, "must be one-dimensional", f"shape {values.shape}")
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        object.__setattr__(self, "periodic", bool(self.periodic))
        self._to_core()

    @classmethod
    def step(cls, height: float, *, at: float) -> Profile:
        """Return a step up, or down if the height is negative.

        Forces and work converge with the mesh, but the largest pressure at the edge does not.

        Parameters
        ----------
        height : float
            Height of the ground behind the step [m].
        at : float
            Distance of the step [m].
        """
        return cls._of_type("step", height=height, at=at)

    @classmethod
    def half_sine(cls, height: float, *, length: float, at: float) -> Profile:
        """Return a bump with the shape of half a sine period, or a dip if the height is negative.

        Parameters
        ----------
        height : float
            Height of the top [m].
        length : float
            Length of the bump [m], positive.
        at : float
            Distance of the top [m].
        """
        return cls._of_type("half_sine", height=height, length=length, at=at)

    @classmethod
    def joint(cls, depth: float, *, width: float, at: float) -> Profile:
        """Return a joint between two plates: a groove with vertical walls.

        Parameters
        ----------
        depth : float
            Depth of the joint [m], positive. If it exceeds the penetration, its value has no effect.
        width : float
            Width along the track [m], positive.
        at : float
            Distance of the middle of the joint [m].
        """
        return cls._of_type("joint", depth=depth, width=width, at=at)

    @classmethod
    def corrugation(cls, amplitude: float, *, period: float, at: float = 0.0) -> Profile:
        """Return a periodic profile, amplitude * sin(2π (distance - at) / period).

        Parameters
        ----------
        amplitude : float
            Amplitude [m].
        period : float
            Length of a period [m], positive. On a tread, the circumference is a multiple of it.
        at : float, default 0
            Distance at which the height rises through zero [m].
        """
        return cls._of_type("corrugation", amplitude=amplitude, period=period, at=at)

    @classmethod
    def _of_type(cls, kind: str, **parameters: object) -> Profile:
        """Return the points of a shape of the core."""
        found = _core.profile_of(kind, **{name: as_float(name, value) for name, value in parameters.items()})
        return cls(found.distance, found.height, found.periodic)

    @classmethod
    def of(
        cls, function: Callable[[Any], Any], *, start: float, stop: float, points: int = 10001, periodic: bool = False
    ) -> Profile:
        """Return the profile of a function of the distance.

        Parameters
        ----------
        function : callable
            Function of an array of distances [m] that returns their heights [m].
        start, stop : float
            Range of the distances [m].
        points : int, default 10001
            Number of points at equal distances, at least 2.
        periodic : bool, default False
            Whether the profile repeats with the period stop - start.
        """
        require_callable("function", function)
        points = as_count("points", points, 2)
        distance = np.linspace(as_float("start", start), as_float("stop", stop), points)
        heights = np.broadcast_to(as_float_array("height", function(distance)), distance.shape)
        return cls(distance, heights, periodic)

    @classmethod
    def read(cls, path: str | Path, *, lateral: float = 0.0, periodic: bool = False) -> Profile:
        """Read a measured profile from a file.

        Parameters
        ----------
        path : path-like
            CSV file (``.csv``) with the columns distance and height [m], NumPy file (``.npy``) with an array of shape
            (points, 2), or OpenCRG road surface (``.crg``), which needs the package pyopencrg.
        lateral : float, default 0
            Lateral position of the section of an OpenCRG surface [m].
        periodic : bool, default False
            Whether the profile repeats.

        Raises
        ------
        ValueError
            If the suffix is another one, or the file has other content.
        OSError
            If the file cannot be read.
        ImportError
            If pyopencrg is missing, for ``.crg``.
        """
        from .reading import read_profile

        return cls(*read_profile(Path(path), lateral=as_float("lateral", lateral)), periodic)

    def height_at(self, distance: ArrayLike) -> NDArray[np.float64]:
        """Return the height at distances [m]; at a step, that behind it."""
        distances = as_float_array("distance", distance)
        return self._to_core().height_at(np.ascontiguousarray(distances.ravel())).reshape(distances.shape)

    @property
    def largest_slope(self) -> float:
        """Largest slope between two points in magnitude, except at steps [-]."""
        smooth = np.diff(self.distance) > 0.0
        return float(np.max(np.abs(np.diff(self.height)[smooth] / np.diff(self.distance)[smooth]), initial=0.0))

    @property
    def shortest_feature(self) -> float:
        """Length of the shortest bump, dip or joint [m]; infinite for a single step or a plane.

        It is the shortest distance between two successive steps, or twice the shortest distance between two successive
        extrema.
        """
        distance, height = self.distance, self.height
        if self.periodic:  # two periods contain all features, but their ends belong to none
            distance, height = np.append(distance, distance + np.ptp(distance)), np.append(height, height)
        rise, is_step = np.diff(height), np.diff(distance) == 0.0
        moves = np.flatnonzero(rise)
        successive = list(pairwise(moves.tolist()))
        lengths = [
            distance[after] - distance[before + 1] for before, after in successive if is_step[[before, after]].all()
        ]
        turns = [after for before, after in successive if rise[before] * rise[after] < 0.0 and not is_step[after]]
        extrema = turns if self.periodic or not turns else [int(moves[0]), *turns, int(moves[-1]) + 1]
        lengths += [2.0 * (distance[after] - distance[before]) for before, after in pairwise(extrema)]
        return float(min((length for length in lengths if length > 0.0), default=np.inf))

    def __eq__(self, other: object) -> bool:
        """Return whether another profile has the same points."""
        if not isinstance(other, Profile):
            return NotImplemented
        return (
            np.array_equal(self.distance, other.distance)
            and np.array_equal(self.height, other.height)
            and self.periodic == other.periodic
        )

    def __hash__(self) -> int:
        """Return a hash of the points."""
        return hash((self.distance.tobytes(), self.height.tobytes(), self.periodic))

    def __repr__(self) -> str:
        """Return the ranges of distance and height."""
        distance, height = self.distance, self.height
        return (
            f"Profile({len(distance)} points, distance {distance[0]:.6g} to {distance[-1]:.6g} m, "
            f"height {height.min():.4g} to {height.max():.4g} m{', periodic' if self.periodic else ''})"
        )

    @plots("the height over the distance")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw the height over the distance."""
        from .picture import plot_profile

        return plot_profile(self.distance, self.height, ax)

    def _to_core(self) -> _core.HeightProfile:
        return _core.HeightProfile(distance=self.distance.tolist(), height=self.height.tolist(), periodic=self.periodic)
