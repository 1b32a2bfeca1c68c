"""Comparison of a case with measurements against load or speed, with error bands (the extras `viscoroll[cli,plot]`)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._core import Status
from .._support.arguments import Floats
from .._support.columns import read_columns, read_header
from .._support.errors import InvalidInput
from .._support.files import write_csv
from .._support.pictures import draw_picture
from .._support.plotting import plots
from .._support.progress import ProgressLike
from .._support.scales import Scale
from .._support.text import shown
from .._support.units import UNITS, unit_in_contact
from ..solution.scalars import SCALARS, label_of
from ..studies.runner import run_all

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from ..rolling import Result
    from .case import Case

__all__ = ["Measurements", "Trial", "compare_measured", "read_measurements"]

#: Parameters that measurements may vary.
VARIED = ("angular_speed", "load")


@dataclass(frozen=True, slots=True, kw_only=True)
class Measurements:
    """Measured values of one scalar result, in SI units.

    Attributes
    ----------
    varied : str
        Varied parameter: ``"angular_speed"`` [rad/s] or ``"load"`` [N], for rollers [N/m].
    quantity : str
        Name of the measured scalar result.
    places, values, errors : ndarray
        Values of the varied parameter, measured values, and their errors (half the width of the error band).
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
        If the file has other content, or numbers out of range.
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
        raise ValueError(f"{what} {path}: {header[0]} must have at least one value, got none")
    if places.min() <= 0.0:
        raise ValueError(f"{what} {path}: {header[0]} must be > 0 {UNITS[header[0]]}, got {places.min():g}")
    if errors.min() < 0.0:
        raise ValueError(f"{what} {path}: error must be >= 0, got {errors.min():g}")
    return Measurements(varied=header[0], quantity=header[1], places=places, values=values, errors=errors)


@dataclass(frozen=True, slots=True, kw_only=True)
class Trial:
    """Measurements, with the computed results of a case.

    Attributes
    ----------
    case : Case
        Case with all parameters that were not varied.
    measured : Measurements
        Measured values.
    computed : ndarray
        Computed value for each measurement.
    bands : ndarray
        Half the width of the error band of each computed value: the error estimate of the mesh plus the model error, if
        there is one. The uncertainty of the material is not included.
    statuses : list of Status
        Status of the solve for each measurement.
    """

    case: Case
    measured: Measurements
    computed: Floats
    bands: Floats
    statuses: list[Status]

    @property
    def agrees(self) -> NDArray[np.bool_]:
        """Whether the error bands of measurement and computation overlap, for each measurement."""
        return self._excess() <= 0.0

    def _excess(self) -> Floats:
        """Return the distance between the two error bands of each measurement; negative if they overlap."""
        return np.abs(self.measured.values - self.computed) - self.measured.errors - self.bands

    def verdict(self) -> str:
        """Return a text with the number of measurements that agree, and the largest distance between other bands."""
        if self.agrees.all():
            return self._count()
        apart = self._excess().max() / (np.abs(self.measured.values).max() or 1.0)
        return f"{self._count()}; the bands of the others are apart by up to {apart:.2g} of the largest value"

    def _count(self) -> str:
        """Return a text with the number of measurements that agree."""
        return f"{self.agrees.sum()} of {self.agrees.size} measurements agree within the error bands"

    def _units(self) -> tuple[str, str]:
        """Return the units of the varied parameter and of the measured result."""
        line = self.case.body.line_contact
        units = (UNITS[self.measured.varied], SCALARS[self.measured.quantity][0])
        varied, quantity = (unit_in_contact(unit, line_contact=line) for unit in units)
        return varied, quantity

    @plots("the values")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw measured and computed values with their error bands."""
        return draw_picture(self._draw, ax, figsize=(8.4, 5.2))

    def _draw(self, axes: Axes) -> None:
        order = np.argsort(self.measured.places, kind="stable")
        (varied, unit), name = self._units(), self.measured.quantity
        along, up = Scale.of(self.measured.places, varied), Scale.of([*self.measured.values, *self.computed], unit)
        places = self.measured.places / along.factor
        computed, bands = (values[order] / up.factor for values in (self.computed, self.bands))
        axes.fill_between(
            places[order],
            computed - bands,
            computed + bands,
            alpha=0.3,
            linewidth=0.0,
            label="errors of model and mesh",
        )
        axes.plot(places[order], computed, ".-", label="solver")
        axes.errorbar(
            places,
            self.measured.values / up.factor,
            yerr=self.measured.errors / up.factor,
            fmt="ko",
            markersize=4,
            capsize=3,
            label="measured",
        )
        axes.set(
            xscale="log",
            xlabel=along.text(self.measured.varied.replace("_", " ")),
            ylabel=up.text(label_of(name, self.case.body)),
            title=self._count(),
        )
        axes.legend()

    def write_csv(self, path: Path) -> None:
        """Write a CSV file with one row for each measurement."""
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
    """Solve a case for each measurement, with the measured value of the varied parameter.

    Parameters
    ----------
    case : Case
        Case with all other parameters.
    measured : Measurements
        Measured values.
    progress : bool or callable, optional
        True shows a bar. A function is called as progress(stage, fraction) after every solve.

    Raises
    ------
    ValueError, ConvergenceError
        Same as in `viscoroll.solve`. ValueError also if the measured result is undetermined in the case.
    """
    places, indices = np.unique(measured.places, return_inverse=True)

    def point(value: float) -> Result:
        varied: dict[str, Any] = {measured.varied: value}
        return replace(case, **varied).solve(threads=1)

    solved = run_all(point, places.tolist(), progress=progress)
    results = [solved[index] for index in indices]
    values = [getattr(result, measured.quantity) for result in results]
    if None in values:
        raise InvalidInput(measured.quantity, "must be determined by the case", "None: compare another result")
    computed = np.array(values, dtype=float)
    estimates = np.array([result.error_estimate + _model_error(result, measured.quantity) for result in results])
    return Trial(
        case=case,
        measured=measured,
        computed=computed,
        bands=np.abs(computed) * estimates,
        statuses=[result.status for result in results],
    )


def _model_error(result: Result, quantity: str) -> float:
    """Return the error of linear theory in a quantity; one without an estimate of its own has that of the torque."""
    own = "finite_strain_torque_error" if quantity == "finite_strain_torque" else f"{quantity}_model_error"
    error = getattr(result, own, None)
    return float((result.model_error if error is None else error) or 0.0)
