"""Pictures of studies, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np

from .._support.arguments import Floats
from .._support.extras import extra
from .._support.pictures import drawn
from .._support.units import UNITS

with extra("plot"):
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import ListedColormap, LogNorm, Normalize
    from matplotlib.lines import Line2D
    from matplotlib.ticker import LogLocator, StrMethodFormatter

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

__all__ = ["plot_study"]

#: Symbols of parameters.
_SYMBOLS = {
    "load": "P",
    "angular_speed": r"\Omega",
    "friction": r"\mu",
    "thickness": "h",
    "core_radius": "r_i",
    "poisson_ratio": r"\nu",
    "density": r"\rho",
    "relaxation_time": r"\tau",
}

#: Units that take a prefix, and the prefixes.
_PREFIXED = {"m", "N", "N m", "Pa", "Pa s", "W", "s"}
_PREFIXES = {1e-9: "n", 1e-6: "μ", 1e-3: "m", 1.0: "", 1e3: "k", 1e6: "M", 1e9: "G"}

#: Numbers up to so many have a legend, more a color bar; texts must be told apart by color.
_MOST_IN_LEGEND, _MOST_TEXTS = 8, 10
_LINES: tuple[Literal["-", "--", ":", "-."], ...] = ("-", "--", ":", "-.")
_SHADES = ListedColormap(colormaps["viridis"](np.linspace(0.0, 0.92, 256)))

#: Characters of texts below an axis that stand side by side, and texts that stand slanted.
_CHARACTERS, _MOST_SLANTED = 70, 12

#: Ratio of the largest to the smallest number from which on an axis is logarithmic.
_WIDE = 20.0

#: Ratio up to which numbers stand at 2 and 5 as well, not as powers of ten.
_FEW_DECADES = 200.0


@overload
def plot_study(study: xarray.Dataset, *, variable: str = ...) -> Figure: ...


@overload
def plot_study(study: xarray.Dataset, *, variable: str = ..., ax: Axes) -> Axes: ...


def plot_study(study: xarray.Dataset, *, variable: str = "resisting_torque", ax: Axes | None = None) -> Figure | Axes:
    """Draw a scalar result of a study against its first dimension, one curve for each value of the others.

    Of the other dimensions, the one with most values gives the curves their color, the rest the kind of line. Axes are
    logarithmic where numbers span decades.

    Parameters
    ----------
    study : xarray.Dataset
        What `viscoroll.sweep` returns, or a selection of it.
    variable : str, default "resisting_torque"
        Name of a result over the dimensions of the study.
    ax : matplotlib.axes.Axes, optional
        Where to draw; in a figure of its own without.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        A new figure, which shows itself in a notebook, or `ax`. Failed points are left out and counted; those that have
        not converged are hollow.

    Raises
    ------
    ValueError
        For an unknown variable, one without dimensions or numbers, and more curves than can be told apart.
    """
    values = _checked(study, variable)
    return drawn(lambda axes: _draw_study(axes, study, values), ax, figsize=(7.6, 5.0))


def _draw_study(axes: Axes, study: xarray.Dataset, values: xarray.DataArray) -> None:
    varied = [str(name) for name in values.dims if values.sizes[name] > 1] or [str(values.dims[0])]
    title = _title(study, values, varied)
    values = values.squeeze([name for name in values.dims if name not in varied])
    for name in varied:
        values = values.dropna(name, how="all")
    first, *others = varied
    others.sort(key=lambda name: -values.sizes[name])
    colors, lines = _Colors(values[others[0]]) if others else None, others[1:]
    if (kinds := math.prod(values.sizes[name] for name in lines)) > len(_LINES):
        message = f"study must have at most {len(_LINES)} combinations of {', '.join(lines)}, got {kinds}"
        raise ValueError(f"{message}; select a part of it")
    across, scale = _Abscissa(values[first]), _Scale.of(values)
    handles, colored = [], set()
    for style, (label, part) in zip(_LINES, _parts(values, lines), strict=False):
        curves = part.transpose(..., first).to_numpy().reshape(-1, values.sizes[first])
        drawn = {i for i, curve in enumerate(curves) if np.isfinite(curve).any()}
        for i in drawn:
            across.draw(axes, curves[i] / scale.factor, style=style, color="tab:blue" if colors is None else colors[i])
        colored |= drawn
        if drawn and label:
            handles.append(Line2D([], [], color="0.3", linestyle=style, label=label))
    if _mark_unsettled(axes, study, values, across, scale.factor):
        handles.append(Line2D([], [], linestyle="", marker="o", color="w", markeredgecolor="k", label="not converged"))
    if colors is not None and colors.has_bar:
        colors.draw_bar(axes)
    elif colors is not None:
        handles = colors.handles(colored) + handles
    across.finish(axes)
    axes.set_ylabel(scale.text(_named(values)))
    _choose_scale(axes, "y", values.to_numpy().ravel() / scale.factor)
    axes.set_title(title, fontsize="medium")
    axes.grid(alpha=0.3)
    if handles:
        axes.legend(handles=handles, fontsize="small")


def _checked(study: xarray.Dataset, variable: str) -> xarray.DataArray:
    known = [name for name, values in study.data_vars.items() if values.dtype.kind == "f" and "phi" not in values.dims]
    if variable not in known:
        raise ValueError(f"variable must be one of {', '.join(map(str, known))}, got {variable!r}")
    values = study[variable]
    if not values.dims:
        raise ValueError(f"variable must have a dimension to be drawn against, got {variable} of a single point")
    if not np.isfinite(values).any():
        raise ValueError(f"variable must have numbers to be drawn, got {variable}, of which no point has one")
    return values


@dataclass(frozen=True, slots=True)
class _Scale:
    """Unit with its prefix, and what a number is divided by."""

    factor: float
    unit: str

    @classmethod
    def of(cls, values: xarray.DataArray) -> _Scale:
        unit = str(values.attrs.get("units", "1"))
        numbers = np.abs(values.to_numpy())
        largest = float(np.nanmax(numbers, initial=0.0, where=np.isfinite(numbers)))
        if unit not in _PREFIXED or largest == 0.0:
            return cls(1.0, "" if unit == "1" else unit)
        factor = max((f for f in _PREFIXES if f <= 1.001 * largest), default=min(_PREFIXES))
        return cls(factor, _PREFIXES[factor] + unit)

    def text(self, name: str) -> str:
        """Name with the unit, for an axis."""
        return f"{name} [{self.unit}]" if self.unit else name


class _Abscissa:
    """The first dimension: numbers along an axis, or texts side by side."""

    def __init__(self, coordinate: xarray.DataArray) -> None:
        self._name = _named(coordinate)
        self._texts = _texts_of(coordinate)
        self._scale = _Scale(1.0, "") if self._texts else _Scale.of(coordinate)
        self.places = np.arange(float(coordinate.size)) if self._texts else coordinate.to_numpy() / self._scale.factor

    def draw(self, axes: Axes, values: Floats, *, style: str, color: Any) -> None:
        """Draw a curve, or points where nothing lies between them."""
        axes.plot(self.places, values, "o" if self._texts else f".{style}", color=color)

    def finish(self, axes: Axes) -> None:
        """Write name and numbers, or texts, slanted where they would overlap."""
        axes.set_xlabel(self._scale.text(self._name))
        if not self._texts:
            _choose_scale(axes, "x", self.places)
            return
        axes.set_xlim(-0.5, self.places.size - 0.5)
        longest = max(len(line) for text in self._texts for line in text.split("\n"))
        if longest * self.places.size <= _CHARACTERS:
            axes.set_xticks(self.places, self._texts)
            return
        if len(self._texts) > _MOST_SLANTED:
            texts = [text.replace("\n", ", ") for text in self._texts]
            axes.set_xticks(self.places, texts, fontsize="small", rotation=90)
        else:
            axes.set_xticks(self.places, self._texts, fontsize="small", rotation=30, rotation_mode="anchor", ha="right")


class _Colors:
    """The dimension that the colors of curves stand for."""

    def __init__(self, coordinate: xarray.DataArray) -> None:
        self._name = _named(coordinate)
        self._texts = [text.replace("\n", ", ") for text in _texts_of(coordinate)]
        self.has_bar = not self._texts and coordinate.size > _MOST_IN_LEGEND
        if len(self._texts) > _MOST_TEXTS:
            message = f"study must have at most {_MOST_TEXTS} values of {coordinate.name}, got {coordinate.size}"
            raise ValueError(f"{message}; select a part of it")
        self._shades: list[Any] = [f"C{i}" for i in range(len(self._texts))]
        if not self._texts:
            self._scale = _Scale.of(coordinate)
            numbers = coordinate.to_numpy() / self._scale.factor
            self._norm = (LogNorm if _spans_decades(numbers) else Normalize)(numbers.min(), numbers.max())
            self._shades = list(_SHADES(self._norm(numbers)))
            self._texts = [f"{_symbol(self._name)} = {number:.4g} {self._scale.unit}".rstrip() for number in numbers]

    def __getitem__(self, i: int) -> Any:
        """Return the color of a value."""
        return self._shades[i]

    def draw_bar(self, axes: Axes) -> None:
        """Draw the scale of the colors."""
        figure = axes.figure
        figure.colorbar(ScalarMappable(self._norm, _SHADES), ax=axes, label=self._scale.text(self._name))

    def handles(self, drawn: set[int]) -> list[Line2D]:
        """Return entries of a legend for the values that have a curve."""
        return [Line2D([], [], color=self[i], marker=".", label=self._texts[i]) for i in sorted(drawn)]


def _parts(values: xarray.DataArray, names: list[str]) -> Iterator[tuple[str, xarray.DataArray]]:
    """Take the values of some dimensions apart, with a label for each part."""
    if not names:
        yield "", values
        return
    for i in range(values.sizes[names[0]]):
        part = values.isel({names[0]: i})
        for label, rest in _parts(part, names[1:]):
            yield ", ".join(filter(None, [_value_text(part[names[0]]), label])), rest


def _mark_unsettled(
    axes: Axes, study: xarray.Dataset, values: xarray.DataArray, across: _Abscissa, factor: float
) -> bool:
    """Make points hollow that a solve ended with before it had converged."""
    if "status" not in study or not set(values.dims) <= set(study.status.dims):
        return False
    first = values.dims[0]
    status = study.status.squeeze([name for name in study.status.dims if name not in values.dims])
    status = status.sel({name: values[name] for name in values.dims})
    unsettled = ((status != "CONVERGED") & np.isfinite(values)).transpose(first, ...).to_numpy()
    numbers = values.transpose(first, ...).to_numpy() / factor
    place, *_ = np.nonzero(unsettled)
    axes.plot(across.places[place], numbers[unsettled], "wo", markeredgecolor="k", markersize=4, zorder=3)
    return bool(unsettled.any())


def _title(study: xarray.Dataset, values: xarray.DataArray, varied: list[str]) -> str:
    fixed = [
        _value_text(coordinate)
        for name, coordinate in study.coords.items()
        if name not in varied and coordinate.size == 1
    ]
    lines = [f"{_named(values)} against {_named(study[varied[0]])}", ",  ".join(fixed)]
    if missing := int((~np.isfinite(values)).sum()):
        lines.append(f"{missing} of {values.size} points have no value")
    return "\n".join(filter(None, lines))


def _choose_scale(axes: Axes, axis: str, numbers: Floats) -> None:
    """Make an axis logarithmic where numbers span decades, but for a stretch around 0 if that is one of them."""
    finite = np.unique(numbers[np.isfinite(numbers)])
    if _spans_decades(finite):
        axes.set(**{f"{axis}scale": "log"})
        line: Axis = getattr(axes, f"{axis}axis")
        if finite[-1] < _FEW_DECADES * finite[0]:
            line.set_minor_locator(LogLocator(subs=(2.0, 5.0)))
            line.set_minor_formatter(StrMethodFormatter("{x:g}"))
            line.set_major_formatter(StrMethodFormatter("{x:g}"))
    elif finite.size > 2 and finite[0] == 0.0 and _spans_decades(finite[1:]):
        (axes.set_xscale if axis == "x" else axes.set_yscale)("symlog", linthresh=float(finite[1]))
        axes.set(**{f"{axis}lim": (0.0, None)})


def _spans_decades(numbers: Floats) -> bool:
    """Whether positive numbers are spaced by a factor, or differ by a large one."""
    if numbers.size < 2 or not numbers.min() > 0.0:
        return False
    steps = np.diff(np.log(numbers))
    is_geometric = numbers.size > 2 and bool(np.allclose(steps, steps[0], rtol=1e-6))
    return is_geometric or bool(numbers.max() > _WIDE * numbers.min())


def _texts_of(coordinate: xarray.DataArray) -> list[str]:
    """Return the texts of a coordinate, one line for each quantity; none for numbers."""
    if coordinate.dtype.kind in "fiu":
        return []
    return ["\n".join(map(_spelled, str(text).split(", "))) for text in coordinate.to_numpy().tolist()]


def _spelled(text: str) -> str:
    """Return "name=value" in words with the unit, and any other text as it is."""
    name, found, value = text.partition("=")
    unit = UNITS.get(name, "1")
    return f"{name.replace('_', ' ')} = {value}{'' if unit == '1' else f' {unit}'}" if found else text


def _value_text(coordinate: xarray.DataArray) -> str:
    """Return name and value of a single point of a coordinate."""
    if coordinate.dtype.kind not in "fiu":
        return f"{_named(coordinate)}: {_texts_of(coordinate.expand_dims('one'))[0]}".replace("\n", ", ")
    scale = _Scale.of(coordinate)
    return f"{_symbol(_named(coordinate))} = {coordinate.item() / scale.factor:.4g} {scale.unit}".rstrip()


def _named(values: xarray.DataArray) -> str:
    """Return what an array holds in words, with symbols as such."""
    name = str(values.attrs.get("long_name", values.name)).replace("_", " ") if values.name in _SYMBOLS else ""
    if name:
        return f"{name} ${_SYMBOLS[str(values.name)]}$"
    return re.sub(r"\b([A-Za-z]_\w)\b", r"$\1$", str(values.attrs.get("long_name", values.name)))


def _symbol(name: str) -> str:
    """Return the symbol of a name that ends in one, else the name."""
    return name.rsplit(" ", 1)[-1] if name.endswith("$") else name
