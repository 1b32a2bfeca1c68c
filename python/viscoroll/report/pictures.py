"""Pictures of a report, as SVG inside the page."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from io import BytesIO
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from .._core import ConvergenceError
from .._support.extras import extra
from .._support.pictures import draw_picture
from .._support.result_warnings import silenced
from ..case.limits import deformable_bodies

with extra("plot"):
    import matplotlib as mpl

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from .._support.progress import Report
    from ..case import Case
    from ..case.solved import SolvedCase
    from ..rolling import Result

__all__ = ["ReportPicture", "pictures_of"]

#: Results that the curves show, and factors on speed and load. The strain grows with the load and limits its range.
_CURVES = ("rolling_resistance_torque", "rolling_resistance_coefficient")
_SPEEDS, _LOADS = np.geomspace(0.1, 10.0, 7), np.geomspace(0.25, 2.0, 7)

#: Title of the picture of the curves.
_CURVES_TITLE = "Curves over speed and load"

#: Errors that a report states in place of a picture.
_REPORTED = (ValueError, ImportError, ConvergenceError)

#: Accuracy of the points of the curves, if that of the case is finer.
_ACCURACY = 0.1

#: Frequencies at which moduli are drawn, relative to that of the passage through the contact.
_FREQUENCIES = np.logspace(-3.0, 3.0, 121)


@dataclass(frozen=True, slots=True, kw_only=True)
class ReportPicture:
    """A picture, or the reason why it is missing.

    Attributes
    ----------
    title, note : str
        Title, and a sentence about the picture.
    address : str
        The picture as a data URL; empty if it is missing.
    width : float
        Width of the picture [inch], at which its texts have their size.
    missing : str
        Reason why the picture is missing; empty otherwise.
    """

    title: str
    note: str
    address: str = ""
    width: float = 0.0
    missing: str = ""


def pictures_of(case: Case, solved: SolvedCase, report: Report) -> list[ReportPicture]:
    """Return the pictures of a solved case: pressure, section, temperature, and curves over speed and load.

    Parameters
    ----------
    case : Case
        The case, whose numerical options the curves use.
    solved : SolvedCase
        Its solution.
    report : callable
        Called as report(stage, fraction).
    """
    result = solved.result
    found = [_picture("Contact pressure", "", lambda: _without_title(result.plot()))]
    for body in deformable_bodies(result):
        title = "Section through the " + ("rolling body" if body.of == "body" else "counterbody")
        draw = partial(result.plot_section, of=body.of)
        found.append(_picture(title, "Von Mises stress below the middle of the contact.", draw))
    if solved.temperatures:
        note = "Temperature rise above the surroundings, averaged over a revolution."
        found.append(_picture("Temperature", note, solved.temperatures[0].plot))
    return [*found, _curves(case, solved, report), _picture("Moduli", _MODULI_NOTE, lambda: _plot_moduli(result))]


def _picture(title: str, note: str, draw: Callable[[], Figure]) -> ReportPicture:
    try:
        # Larger texts than in a window, because the page is narrower, and the same file for the same case.
        with mpl.rc_context({"font.size": 12.0, "svg.hashsalt": "viscoroll"}), silenced():
            content = BytesIO()
            figure = draw()
            figure.savefig(content, format="svg", dpi=150, metadata={"Date": None, "Creator": None})
    except _REPORTED as error:
        return ReportPicture(title=title, note=note, missing=str(error))
    data = b64encode(content.getvalue()).decode("ascii")
    address = f"data:image/svg+xml;base64,{data}"
    return ReportPicture(title=title, note=note, address=address, width=float(figure.get_figwidth()))


def _without_title(figure: Figure) -> Figure:
    """Remove the title of a figure, which repeats the numbers of the page."""
    figure.suptitle("")
    return figure


def _curves(case: Case, solved: SolvedCase, report: Report) -> ReportPicture:
    """Return the picture of torque and coefficient over speed and load, with the case as a larger point."""
    result = solved.result
    note = "Frictionless rolling by linear theory; the large points have the load and speed of the case. " + (
        "The moduli are those at the temperature and strain of the case. " if solved.heated or solved.softened else ""
    )
    options: dict[str, Any] = {
        "compliance": result.compliance,
        "curvature": result.curvature,
        "patch_load": case.patch_load,
        "finite_strain": False,
        "progress": lambda _stage, fraction: report("curves over speed and load", fraction),
    }
    if case.mesh is None:
        options["accuracy"] = max(case.accuracy or 0.0, _ACCURACY)
        note += f"Accuracy of the points: {options['accuracy']:g}."
    else:
        options["mesh"] = case.mesh

    places: list[dict[str, Any]] = [
        {"load": result.load, "angular_speed": (result.angular_speed * _SPEEDS).tolist()},
        {"load": (result.load * _LOADS).tolist(), "angular_speed": result.angular_speed},
    ]
    try:
        from ..studies.study import sweep

        with silenced():
            studies = [sweep(result.body, on=result.on, **place, **options) for place in places]
    except _REPORTED as error:
        return ReportPicture(title=_CURVES_TITLE, note=note, missing=str(error))
    failed = [str(message) for study in studies for message in study.error.to_numpy().ravel() if message]
    if failed:
        note += f" {len(failed)} of {len(_SPEEDS) + len(_LOADS)} points failed: {failed[0]}."
    return _picture(_CURVES_TITLE, note, lambda: _draw_curves(studies, result.body.outer_radius))


def _draw_curves(studies: list[xarray.Dataset], radius: float) -> Figure:
    from ..studies.picture import plot_study

    for variable in _CURVES:  # the axes have no space for the explanations of the labels
        for study in studies:
            study[variable].attrs["long_name"] = str(study[variable].attrs["long_name"]).partition(",")[0]

    def compose(figure: Figure) -> None:
        rows = figure.subplots(len(_CURVES), len(studies), squeeze=False)
        for row, variable in zip(rows, _CURVES, strict=True):
            for axes, study, factors in zip(row, studies, (_SPEEDS, _LOADS), strict=True):
                plot_study(study, variable=variable, ax=axes)
                axes.set_title("")
                _mark_case(axes, np.isfinite(study[variable].to_numpy().ravel()), factors)
        above = rows[0][0].secondary_xaxis(
            "top", functions=(lambda speed: speed * radius, lambda speed: speed / radius)
        )
        above.set_xlabel("speed of the surface [m/s]")

    return cast("Figure", draw_picture(lambda _axes: None, None, figsize=(11.0, 7.5), compose=compose))


def _mark_case(axes: Axes, solved: NDArray[np.bool_], factors: NDArray[np.float64]) -> None:
    """Draw the point of the case larger than the others, if it is solved; the curve contains only solved points."""
    case = int(np.argmin(np.abs(np.log(factors))))
    if solved[case]:
        x, y = (np.asarray(values, dtype=float) for values in axes.lines[0].get_data())
        point = int(solved[:case].sum())
        axes.plot(x[point], y[point], "o", color="tab:red", markersize=9)


_MODULI_NOTE = (
    "Storage modulus (solid) and loss modulus (dashed) in shear. The dotted line is the frequency of the passage "
    "through the contact, the speed of the surface divided by half the contact length."
)


def _plot_moduli(result: Result) -> Figure:
    """Draw the moduli of the layers around the frequency of the passage through the contact."""
    passage = 2.0 * result.angular_speed * result.body.outer_radius / result.contact_length
    omega = passage * _FREQUENCIES

    def draw(axes: Axes) -> None:
        moduli = _moduli(result)
        if not moduli:
            raise ValueError("both bodies are rigid")
        for index, (label, modulus) in enumerate(moduli.items()):
            values = np.asarray(modulus.complex_modulus(omega))
            axes.loglog(omega, 1e-6 * values.real, color=f"C{index}", label=label)
            if np.any(values.imag > 0.0):
                axes.loglog(omega, 1e-6 * values.imag, "--", color=f"C{index}")
        axes.axvline(passage, color="0.4", linestyle=":")
        axes.set(xlabel="angular frequency [rad/s]", ylabel="shear modulus [MPa]")
        axes.grid(alpha=0.3)
        axes.legend()

    return cast("Figure", draw_picture(draw, None, figsize=(11.0, 4.2)))


def _moduli(result: Result) -> dict[str, Any]:
    """Return the moduli of the layers of both bodies, with their labels."""
    found: dict[str, Any] = {}
    for body in filter(None, [result.body, result.on]):
        prefix = "counterbody, " if body is result.on else ""
        layers = {f"layer {number}": layer for number, layer in enumerate(body.layers)}
        if (base := getattr(body, "base", None)) is not None:
            layers["base"] = base
        found |= {f"{prefix}{body.noun}, {name}": layer.shear_modulus for name, layer in layers.items()}
    return found
