"""Torque against speed from the solver and from closed forms (the extras `viscoroll[cli,plot]`)."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from .._core import Compliance, Status
from .._support.arguments import Floats
from .._support.errors import InvalidInput
from .._support.files import write_csv
from .._support.pictures import draw_picture
from .._support.plotting import plots
from .._support.progress import ProgressLike
from .._support.quantities import quantity_text
from .._support.scales import Scale
from .._support.units import unit_in_contact
from ..analytic import applicable
from ..bodies import Drive
from ..modal import critical_speed
from ..solution.scalars import scalar_units
from ..studies.dimensions import require_feasible
from ..studies.runner import run_all
from .quantities import range_in_si

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from ..bodies import RollingBody
    from ..rolling import Result
    from .case import Case

__all__ = ["Comparison", "compare_torques", "parse_speeds"]

_LABELS = {
    "low_speed": "low speed",
    "greenwood_tabor": "Greenwood and Tabor (64), all work dissipated",
    "persson": "Persson",
    "winkler": "viscoelastic springs (Winkler)",
    "hunter": "Hunter's half-plane",
    "winkler_line": "viscoelastic springs (Winkler)",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """Torques [N m], for rollers per length [N m/m], against the angular speed Ω [rad/s].

    Attributes
    ----------
    case : Case
        Case with body, load, and mesh or accuracy.
    speeds, torques : ndarray
        Angular speeds Ω [rad/s], and resisting torques T_r from the solver.
    errors : ndarray
        Error estimates of the solver [-].
    statuses : list of Status
        Status of each solve.
    forms : dict of str to (ndarray, ndarray of bool)
        For each closed form by name, the torques, and whether the closed form is valid at each speed.
    """

    case: Case
    speeds: Floats
    torques: Floats
    errors: Floats
    statuses: list[Status]
    forms: dict[str, tuple[Floats, NDArray[np.bool_]]]

    def unsettled(self) -> dict[Status, int]:
        """Return the number of speeds by status, for the solves that did not converge."""
        return dict(Counter(status for status in self.statuses if status is not Status.CONVERGED))

    def _unit(self) -> str:
        """Return the unit of the torques."""
        return scalar_units(line_contact=self.case.body.line_contact)["resisting_torque"]

    @plots("the torques")
    def plot(self, ax: Axes | None = None) -> Figure | Axes:
        """Draw all torques; closed forms are dashed outside their range of validity."""
        return draw_picture(self._draw, ax, figsize=(8.4, 5.2))

    def _draw(self, axes: Axes) -> None:
        scale = Scale.of(self.torques, self._unit())
        torques = self.torques / scale.factor
        axes.errorbar(
            self.speeds,
            torques,
            yerr=np.abs(self.errors * torques),
            fmt="ko-",
            markersize=3.5,
            linewidth=1.0,
            label="solver, radial compliance",
        )
        for number, (name, (of_form, valid)) in enumerate(self.forms.items()):
            color, label, torque = f"C{number}", _LABELS.get(name, name), of_form / scale.factor
            if not valid.all():
                outside = f"{label}, outside its range of validity"
                axes.plot(self.speeds, torque, "--", color=color, linewidth=1.0, label=outside)
            if valid.any():
                axes.plot(self.speeds, np.where(valid, torque, np.nan), color=color, linewidth=2.5, label=label)
        axes.set(
            xscale="log",
            yscale="log",
            xlabel="rolling speed $Ω$ [rad/s]",
            ylabel=scale.text("resisting torque $T_r$"),
        )
        resisting = torques[torques > 0.0]  # on too coarse a mesh a torque can be negative
        if resisting.size:
            axes.set_ylim(0.3 * resisting.min(), 5.0 * resisting.max())
        load_unit = unit_in_contact("N", line_contact=self.case.body.line_contact)
        axes.set_title(f"$P$ = {quantity_text(self.case.load, load_unit)}")
        axes.legend(fontsize="small")

    def write_csv(self, path: Path) -> None:
        """Write a CSV file with one row for each speed."""
        columns: dict[str, list[object]] = {
            "angular_speed [rad/s]": self.speeds.tolist(),
            f"torque [{self._unit()}]": self.torques.tolist(),
            "error_estimate [1]": self.errors.tolist(),
            "status": [status.name for status in self.statuses],
        }
        for name, (torque, valid) in self.forms.items():
            columns[f"{name} [{self._unit()}]"] = torque.tolist()
            columns[f"{name}_is_valid"] = valid.tolist()
        write_csv(columns, path)


def parse_speeds(text: str) -> tuple[float, float]:
    """Return the two ends of a range of speeds such as "0.05..25" [rad/s] or "10..1000 rpm", with 0 < from < to < ∞."""
    rule = "must be from..to with 0 < from < to in rad/s"
    low, high = range_in_si(text, "rad/s", path="speeds", rule=rule)
    if not 0.0 < low < high:
        raise InvalidInput("speeds", rule, repr(text))
    return low, high


def _critical_speed(body: RollingBody) -> float:
    """Return the critical speed of a rolling body [rad/s]; infinite for a rigid one."""
    return critical_speed(body) if body.layers else np.inf


def compare_torques(
    case: Case,
    *,
    speeds: tuple[float, float] | None = None,
    points: int = 25,
    progress: ProgressLike = None,
) -> Comparison:
    """Solve a case without friction and with the radial compliance at a range of speeds, and evaluate closed forms.

    The speeds are spaced geometrically. The radial compliance is used because the closed forms give the power loss
    divided by the speed, which with the vertical compliance differs from the moment of the pressure.

    Parameters
    ----------
    case : Case
        Case to solve; its friction, drive and compliance are ignored.
    speeds : (float, float), optional
        First and last angular speed [rad/s]. By default, 1/30 and 10 times the speed of the case. The last speed is
        limited to 90 % of the critical speed of the rolling body, but is at least the speed of the case.
    points : int, default 25
        Number of speeds, from 2 to the largest number of points of a study, 1 000 000.
    progress : bool or callable, optional
        True shows a bar. A function is called as progress(stage, fraction) after every speed.

    Raises
    ------
    ValueError, ConvergenceError
        Same as in `viscoroll.solve`.
    """
    require_feasible({"speeds": points})
    load = case.given_load()
    low, high = speeds or (
        case.angular_speed / 30.0,
        min(10.0 * case.angular_speed, max(0.9 * _critical_speed(case.body), case.angular_speed)),
    )
    omega = np.geomspace(low, high, points)
    radial = replace(case, friction=0.0, drive=Drive(force=0.0), compliance=Compliance.RADIAL)

    def point(speed: float) -> Result:
        return radial.at(speed).solve(threads=1)

    results = run_all(point, omega.tolist(), progress=progress)
    forms = {
        name: (np.asarray(form(load, omega)), np.asarray(form.is_valid(load, omega)))
        for name, form in applicable(case.body, on=case.on).items()
    }
    return Comparison(
        case=case,
        speeds=omega,
        torques=np.array([result.resisting_torque for result in results]),
        errors=np.array([result.error_estimate for result in results]),
        statuses=[result.status for result in results],
        forms=forms,
    )
