"""Animations of histories, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.files import draft_of
from .._support.pictures import Picture
from .._support.scales import Scale
from .._support.text import shown

with extra("plot"):
    from matplotlib.animation import FFMpegWriter, PillowWriter
    from matplotlib.backends.backend_agg import FigureCanvasAgg

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from numpy.typing import NDArray

    from ..bodies import RollingBody
    from ..ground import Profile

__all__ = ["Animated", "write_animation"]

#: Half of the shown distance, and shown height above and below the undeformed lowest point, relative to the radius.
_ASIDE, _ABOVE, _BELOW = 1.3, 2.2, 0.15

_RESOLUTION = 80  # [dots per inch]


@dataclass(frozen=True, slots=True, kw_only=True)
class Animated:
    """Data of a history that an animation draws: body, surfaces, and time series by name with their units."""

    body: RollingBody
    ground: Profile | None
    tread: Profile | None
    distance: NDArray[np.float64]
    series: Mapping[str, NDArray[np.float64]]
    units: Mapping[str, str]


def write_animation(history: Animated, path: Path, *, frames: int, frames_per_second: int) -> None:
    """Write pictures of a history at equal intervals of time to a file; parameters as in `History.animate`."""
    is_gif = path.suffix.lower() == ".gif"
    if not is_gif and not FFMpegWriter.isAvailable():
        raise InvalidInput("path", "must end in .gif where the program ffmpeg is not installed", shown(path.name))
    writer = PillowWriter(fps=frames_per_second) if is_gif else FFMpegWriter(fps=frames_per_second)
    picture = Picture(figsize=(8.0, 6.4), layout="constrained")
    FigureCanvasAgg(picture)
    scene = _Scene(history, picture)
    instants = _instants(history.series["time"], frames)
    scene.show(instants[0])
    picture.draw_without_rendering()
    picture.set_layout_engine("none")  # positions of the axes, which would take half of the time of every picture
    with draft_of(path) as draft, writer.saving(picture, str(draft), _RESOLUTION):
        for instant in instants:
            scene.show(instant)
            writer.grab_frame()


def _instants(time: NDArray[np.float64], frames: int) -> list[int]:
    """Return the indices of the first instants at or after equally spaced times."""
    return [int(instant) for instant in np.searchsorted(time, np.linspace(time[0], time[-1], frames))]


class _Scene:
    """Body on its ground at true scale, above load and push force over the distance."""

    def __init__(self, history: Animated, picture: Picture) -> None:
        self._history = history
        self._radius = history.body.outer_radius
        self._length = Scale.of([self._radius], "m")
        self._view = picture.add_subplot(2, 1, 1)
        self._view.set(aspect="equal", xlabel=self._length.text("distance"), ylabel=self._length.text("height"))
        self._angles = np.linspace(0.0, 2.0 * np.pi, 361)
        (self._outline,) = self._view.plot([], [], color="C0")
        (self._spoke,) = self._view.plot([], [], color="C0", marker="o", markevery=[0], linewidth=0.8)
        (self._ground,) = self._view.plot([], [], color="0.3")
        (self._contact,) = self._view.plot([], [], color="C3", linewidth=3.0)
        self._marks = []
        distance = history.distance / self._length.factor
        for place, name, label in ((3, "load", "load"), (4, "resisting_force", "push force")):
            scale = Scale.of(history.series[name], history.units[name])
            axes = picture.add_subplot(4, 1, place)
            values = history.series[name] / scale.factor
            axes.plot(distance, values, linewidth=0.9)
            axes.set(ylabel=scale.text(label))
            (mark,) = axes.plot([], [], "o", color="C3")
            self._marks.append((mark, values))
        axes.set(xlabel=self._length.text("distance"))

    def show(self, instant: int) -> None:
        """Move everything to an instant."""
        history, radius, factor = self._history, self._radius, self._length.factor
        here, height = history.distance[instant], history.series["axle_height"][instant]
        height = height if np.isfinite(height) else radius
        at = here + np.linspace(-_ASIDE, _ASIDE, 1201) * radius
        heights = np.zeros_like(at) if history.ground is None else history.ground.height_at(at)
        surface = radius * np.ones_like(self._angles)
        if history.tread is not None:
            # A point of the tread meets the track at its own distance, when it is below the axle.
            turned = (history.series["angle"][instant] + self._angles) % (2.0 * np.pi)
            surface += history.tread.height_at(turned * radius)
        forward, upward = surface * np.sin(self._angles), height - surface * np.cos(self._angles)
        below = np.interp(here + forward, at, heights)
        lowered = np.where(np.cos(self._angles) > 0.0, np.maximum(upward, below), upward)
        self._outline.set_data((here + forward) / factor, lowered / factor)
        psi = history.series["angle"][instant]
        self._spoke.set_data(
            [here / factor, (here - radius * np.sin(psi)) / factor],
            [height / factor, (height - radius * np.cos(psi)) / factor],
        )
        self._ground.set_data(at / factor, heights / factor)
        touching = (np.cos(self._angles) > 0.0) & (upward < below) & (history.series["load"][instant] > 0.0)
        self._contact.set_data(
            np.where(touching, here + forward, np.nan) / factor, np.where(touching, lowered, np.nan) / factor
        )
        self._view.set(
            xlim=((here - _ASIDE * radius) / factor, (here + _ASIDE * radius) / factor),
            ylim=(-_BELOW * radius / factor, _ABOVE * radius / factor),
            title=f"{history.series['time'][instant]:.3g} s",
        )
        for mark, values in self._marks:
            mark.set_data([here / factor], [values[instant]])
