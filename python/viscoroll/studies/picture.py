"""Pictures of studies, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal, overload

import numpy as np

from .._support.arguments import Floats
from .._support.errors import InvalidInput
from .._support.extras import extra
from .._support.pictures import draw_picture
from .axes import Abscissa, Colors, choose_scale, quantity_name, scale_of, value_text

with extra("plot"):
    from matplotlib.lines import Line2D

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["default_variable", "plot_study"]

#: Line styles, in the order of their use.
_LINE_STYLES: tuple[Literal["-", "--", ":", "-."], ...] = ("-", "--", ":", "-.")


@overload
def plot_study(study: xarray.Dataset, *, variable: str | None = ...) -> Figure: ...


@overload
def plot_study(study: xarray.Dataset, *, variable: str | None = ..., ax: Axes) -> Axes: ...


def plot_study(study: xarray.Dataset, *, variable: str | None = None, ax: Axes | None = None) -> Figure | Axes:
    """Draw a scalar result of a study against its first dimension, one curve for each value of the others.

    Among the other dimensions, the one with most values sets the color of the curves; the remaining ones set the line
    style. An axis is logarithmic if its numbers span decades. If the study has confidence intervals, bands show them.

    Parameters
    ----------
    study : xarray.Dataset
        Dataset from `viscoroll.sweep`, or a selection of it.
    variable : str, optional
        Name of the scalar result; by default the resisting torque, or the friction coefficient of rough surfaces.
    ax : matplotlib.axes.Axes, optional
        Axes to draw into; by default, a new figure is made.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        A new figure, which a notebook displays, or `ax`. Failed points are not drawn; the title reports their number.
        Points that have not converged are hollow.

    Raises
    ------
    ValueError
        If the variable is unknown or has no dimensions or no finite values, or if the curves need more colors or line
        styles than there are.
    """
    values = _checked_variable(study, default_variable(study) if variable is None else variable)
    return draw_picture(lambda axes: _draw_study(axes, study, values), ax, figsize=(7.6, 5.0))


def default_variable(study: xarray.Dataset) -> str:
    """Return the name of the main result: resisting torque, or friction coefficient of rough surfaces."""
    return "friction_coefficient" if "friction_coefficient" in study else "resisting_torque"


def _draw_study(axes: Axes, study: xarray.Dataset, values: xarray.DataArray) -> None:
    varied = [str(name) for name in values.dims if values.sizes[name] > 1] or [str(values.dims[0])]
    title = _title(study, values, varied)
    values = values.squeeze([name for name in values.dims if name not in varied])
    for name in varied:
        values = values.dropna(name, how="all")
    band = _band(study, values)
    first, *others = varied
    others.sort(key=lambda name: -values.sizes[name])
    colors, styled = Colors(values[others[0]]) if others else None, others[1:]
    if (combinations := math.prod(values.sizes[name] for name in styled)) > len(_LINE_STYLES):
        message = f"study must have at most {len(_LINE_STYLES)} combinations of {', '.join(styled)}, got {combinations}"
        raise ValueError(f"{message}; select some of them")
    abscissa, scale = Abscissa(values[first]), scale_of(values)
    handles, colors_in_use = [], set()
    ends = zip(*(_parts(end, styled) for end in band), strict=True) if band else iter(())
    for style, (label, part) in zip(_LINE_STYLES, _parts(values, styled), strict=False):
        curves = _curves(part, first)
        intervals = [_curves(end, first) / scale.factor for _, end in next(ends, ())]
        plotted = {i for i, curve in enumerate(curves) if np.isfinite(curve).any()}
        for i in plotted:
            color = "tab:blue" if colors is None else colors[i]
            abscissa.draw(axes, curves[i] / scale.factor, style=style, color=color)
            if intervals:
                abscissa.draw_band(axes, intervals[0][i], intervals[1][i], color=color)
        colors_in_use |= plotted
        if plotted and label:
            handles.append(Line2D([], [], color="0.3", linestyle=style, label=label))
    if _mark_unconverged(axes, study, values, abscissa, scale.factor):
        handles.append(Line2D([], [], linestyle="", marker="o", color="w", markeredgecolor="k", label="not converged"))
    if colors is not None and colors.has_bar:
        colors.draw_bar(axes)
    elif colors is not None:
        handles = colors.handles(colors_in_use) + handles
    abscissa.finish(axes)
    axes.set_ylabel(scale.text(quantity_name(values)))
    choose_scale(axes, "y", values.to_numpy().ravel() / scale.factor)
    axes.set_title(title, fontsize="medium")
    axes.grid(alpha=0.3)
    if handles:
        axes.legend(handles=handles, fontsize="small")


def _checked_variable(study: xarray.Dataset, variable: str) -> xarray.DataArray:
    known = [name for name, values in study.data_vars.items() if values.dtype.kind == "f" and "phi" not in values.dims]
    if variable not in known:
        raise InvalidInput("variable", f"must be one of {', '.join(map(str, known))}", f"{variable!r}")
    values = study[variable]
    if not values.dims:
        raise InvalidInput("variable", "must have a dimension to be drawn against", f"{variable} at a single point")
    if not np.isfinite(values).any():
        raise InvalidInput("variable", "must have finite values to be drawn", f"{variable}, which has none")
    return values


def _band(study: xarray.Dataset, values: xarray.DataArray) -> list[xarray.DataArray]:
    """Return the lower and upper ends of the intervals of a variable, or an empty list if it has none."""
    names = [f"{values.name}_{end}" for end in ("lower", "upper")]
    if not all(name in study for name in names):
        return []
    ends = [study[name].squeeze([d for d in study[name].dims if d not in values.dims]) for name in names]
    return [end.sel({name: values[name] for name in values.dims}) for end in ends]


def _curves(values: xarray.DataArray, first: str) -> Floats:
    """Return an array whose rows are the curves along the dimension `first`."""
    return np.asarray(values.transpose(..., first).to_numpy().reshape(-1, values.sizes[first]))


def _parts(values: xarray.DataArray, names: list[str]) -> Iterator[tuple[str, xarray.DataArray]]:
    """Split values along some dimensions; yield each part with its label."""
    if not names:
        yield "", values
        return
    for i in range(values.sizes[names[0]]):
        part = values.isel({names[0]: i})
        for label, rest in _parts(part, names[1:]):
            yield ", ".join(filter(None, [value_text(part[names[0]]), label])), rest


def _mark_unconverged(
    axes: Axes, study: xarray.Dataset, values: xarray.DataArray, abscissa: Abscissa, factor: float
) -> bool:
    """Draw hollow markers at points that have not converged; return whether there are such points."""
    if "status" not in study or not set(values.dims) <= set(study.status.dims):
        return False
    first = values.dims[0]
    status = study.status.squeeze([name for name in study.status.dims if name not in values.dims])
    status = status.sel({name: values[name] for name in values.dims})
    unconverged = ((status != "CONVERGED") & np.isfinite(values)).transpose(first, ...).to_numpy()
    numbers = values.transpose(first, ...).to_numpy() / factor
    column, *_ = np.nonzero(unconverged)
    axes.plot(abscissa.positions[column], numbers[unconverged], "wo", markeredgecolor="k", markersize=4, zorder=3)
    return bool(unconverged.any())


def _title(study: xarray.Dataset, values: xarray.DataArray, varied: list[str]) -> str:
    fixed = [
        value_text(coordinate)
        for name, coordinate in study.coords.items()
        if name not in varied and coordinate.size == 1
    ]
    lines = [f"{quantity_name(values)} against {quantity_name(study[varied[0]])}", ",  ".join(fixed)]
    if _band(study, values):
        lines.append(f"bands contain the true value with a probability of {float(study.attrs['confidence']):.4g}")
    if missing := int((~np.isfinite(values)).sum()):
        lines.append(f"{missing} of {values.size} points have no value")
    return "\n".join(filter(None, lines))
