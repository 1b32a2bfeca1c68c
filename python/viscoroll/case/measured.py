"""Measurements beside a case: any result against load or speed, both with bands (the extras `viscoroll[cli,plot]`)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import Status
from .._support.arguments import Floats
from .._support.files import write_csv
from .._support.pictures import drawn
from .._support.plotting import plots
from .._support.progress import ProgressLike
from .._support.text import shown
from .._support.units import UNITS, unit_in_contact
from ..solution.scalars import SCALARS
from ..studies.runner import run_all
from .columns import read_columns, read_header

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from ..rolling import Result
    from .case import Case

__all__ = ["Measurements", "Trial", "compare_measured", "read_measurements"]

#: What may have been varied.
VARIED = ("angular_speed", "load")


@dataclass(frozen=True, slots=True, kw_only=True)
class Measurements:
    """What a laboratory found, in SI units.

    Attributes
    ----------
    varied : str
        ``"angular_speed"`` [rad/s] or ``"load"`` [N, of a roller N/m].
    quantity : str
        Name of a scalar result.
    places, values, errors : ndarray
        What was varied, what was found, and how far that may be off.
    """

    varied: str
    quantity: str
    places: Floats
    values: Floats
    errors: Floats


def read_measurements(path: Path) -> Measurements:
    """Read a CSV file of three columns: `angular_speed` or `load`, a scalar result by its name, and its `error`.

    Raises
    ------
    ValueError
        For another file, and for numbers out of range.
    """
    what = "measurements"
    header = read_header(what, path)
    if len(header) != 3 or header[0] not in VARIED or header[1] not in SCALARS or header[2] != "error":
        raise ValueError(
            f"{what} {path}: columns must be {' or '.join(VARIED)}, the name of a scalar result and error, "
            f"got {shown(','.join(header))}"
        )
    columns = {name: np.array(values) for name, values in read_columns(what, path, header).items()}
    places, values, errors = columns.values()
    if not places.size:
        raise ValueError(f"{what} {path}: there must be a number in {header[0]}, got none")
    if places.min() <= 0.0:
        raise ValueError(f"{what} {path}: {header[0]} must be > 0 {UNITS[header[0]]}, got {places.min():g}")
    if errors.min() < 0.0:
        raise ValueError(f"{what} {path}: error must be >= 0, got {errors.min():g}")
    return Measurements(varied=header[0], quantity=header[1], places=places, values=values, errors=errors)


@dataclass(frozen=True, slots=True, kw_only=True)
class Trial:
    """Measurements, and what a case says of them.

    Attributes
    ----------
    case : Case
        All that was not varied.
    measured : Measurements
        What was found.
    computed : ndarray
        The same by the solver, at each measurement.
    bands : ndarray
        How far that may be off: the error estimate of the mesh, and the model error, where there is one. What is not
        known of the material is not in it.
    statuses : list of Status
        How each solve ended.
    """

    case: Case
    measured: Measurements
    computed: Floats
    bands: Floats
    statuses: list[Status]

    @property
    def agrees(self) -> NDArray[np.bool_]:
        """Whether the two bands of each measurement overlap."""
        return self._excess() <= 0.0

    def _excess(self) -> Floats:
        """Return how far the two bands of each measurement are apart."""
        return np.abs(self.measured.values - self.computed) - self.measured.errors - self.bands

    def verdict(self) -> str:
        """Return in how many places the two agree, and how far they are apart elsewhere."""
        if self.agrees.all():
            return self._count()
        apart = self._excess().max() / (np.abs(self.measured.values).max() or 1.0)
        return f"{self._count()}; the others are up to {apart:.2g} of the largest value farther apart"

    def _count(self) -> str:
        """Return in how many places the two agree."""
        return f"{self.agrees.sum()} of {self.agrees.size} measurements agree within both bands"

    def _units(self) -> tuple[str, str]:
        """Return the units of what was varied and of what was measured."""
        line = self.case.ball.line_contact
        units = (UNITS[self.measured.varied], SCALARS[self.measured.quantity][0])
        varied, quantity = (unit_in_contact(unit, line_contact=line) for unit in units)
        return varied, quantity

    @plots("them")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw what was measured and what was computed, each with its band."""
        return drawn(self._draw, ax, figsize=(8.4, 5.2))

    def _draw(self, axes: Axes) -> None:
        order = np.argsort(self.measured.places, kind="stable")
        places, computed, bands = (values[order] for values in (self.measured.places, self.computed, self.bands))
        axes.fill_between(places, computed - bands, computed + bands, alpha=0.3, linewidth=0.0, label="model and mesh")
        axes.plot(places, computed, ".-", label="solver")
        axes.errorbar(
            self.measured.places,
            self.measured.values,
            yerr=self.measured.errors,
            fmt="ko",
            markersize=4,
            capsize=3,
            label="measured",
        )
        (varied, unit), name = self._units(), self.measured.quantity
        axes.set(
            xscale="log",
            xlabel=f"{self.measured.varied.replace('_', ' ')} [{varied}]",
            ylabel=f"{SCALARS[name][1]} [{unit}]",
            title=self._count(),
        )
        axes.legend()

    def write_csv(self, path: Path) -> None:
        """Write one row for each measurement."""
        varied, unit = self._units()
        columns: dict[str, list[object]] = {
            f"{self.measured.varied} [{varied}]": self.measured.places.tolist(),
            f"measured {self.measured.quantity} [{unit}]": self.measured.values.tolist(),
            f"measured error [{unit}]": self.measured.errors.tolist(),
            f"computed {self.measured.quantity} [{unit}]": self.computed.tolist(),
            f"computed band [{unit}]": self.bands.tolist(),
            "agrees": self.agrees.tolist(),
            "status": [status.name for status in self.statuses],
        }
        write_csv(columns, path)


def compare_measured(case: Case, measured: Measurements, *, progress: ProgressLike = None) -> Trial:
    """Solve a case at the place of each measurement, as it is but for what was varied.

    Parameters
    ----------
    progress : bool or callable, optional
        True shows a bar; or called as progress(stage, fraction) after every solve.

    Raises
    ------
    ValueError, ConvergenceError
        As of `viscoroll.solve`, and where what was measured is undetermined in the case.
    """
    places, which = np.unique(measured.places, return_inverse=True)

    def point(place: float) -> Result:
        there: dict[str, Any] = {measured.varied: place}
        return replace(case, **there).solve(threads=1)

    solved = run_all(point, places.tolist(), progress=progress)
    results = [solved[place] for place in which]
    values = [getattr(result, measured.quantity) for result in results]
    if None in values:
        raise ValueError(f"{measured.quantity} must be determined in the case to be compared, and is not")
    computed = np.array(values, dtype=float)
    doubts = np.array([result.error_estimate + (result.model_error or 0.0) for result in results])
    return Trial(
        case=case,
        measured=measured,
        computed=computed,
        bands=np.abs(computed) * doubts,
        statuses=[result.status for result in results],
    )
