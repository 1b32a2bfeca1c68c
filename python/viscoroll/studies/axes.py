"""Axes, colors and labels for pictures of studies, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from .._support.arguments import Floats
from .._support.extras import extra
from .._support.scales import Scale
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

__all__ = ["Abscissa", "Colors", "choose_scale", "quantity_name", "scale_of", "value_text"]

#: Symbols of parameters.
_SYMBOLS = {
    "load": "P",
    "penetration": "d",
    "angular_speed": r"\Omega",
    "speed": "V",
    "temperature": "T",
    "friction": r"\mu",
    "thickness": "h",
    "core_radius": "r_i",
    "poisson_ratio": r"\nu",
    "density": r"\rho",
    "relaxation_time": r"\tau",
}

#: Largest number of numeric values in a legend (more values get a color bar), and largest number of texts, each of
#: which needs a distinct color.
_MAX_IN_LEGEND, _MAX_TEXTS = 8, 10
_COLORMAP = ListedColormap(colormaps["viridis"](np.linspace(0.0, 0.92, 256)))

#: Largest total number of characters of horizontal texts below an axis, and largest number of slanted texts. More
#: texts are vertical.
_MAX_CHARACTERS, _MAX_SLANTED = 70, 12

#: Ratio of the largest to the smallest number above which an axis is logarithmic.
_MIN_LOGARITHMIC_RATIO = 20.0

#: Ratio below which a logarithmic axis also has numbers at 2 and 5 of each decade, all in decimal notation (20, not
#: 2×10¹).
_FEW_DECADES = 200.0


def scale_of(values: xarray.DataArray) -> Scale:
    """Return the scale that suits the largest absolute value."""
    return Scale.of(values.to_numpy(), str(values.attrs.get("units", "1")))


class Abscissa:
    """Horizontal axis for the first dimension: numeric, or categorical with a text for each value."""

    def __init__(self, coordinate: xarray.DataArray) -> None:
        self._name = quantity_name(coordinate)
        self._texts = _texts_of(coordinate)
        self._scale = Scale(1.0, "") if self._texts else scale_of(coordinate)
        self.positions = (
            np.arange(float(coordinate.size)) if self._texts else coordinate.to_numpy() / self._scale.factor
        )

    def draw(self, axes: Axes, values: Floats, *, style: str, color: Any) -> None:
        """Draw a curve on a numeric axis, or points on a categorical one."""
        axes.plot(self.positions, values, "o" if self._texts else f".{style}", color=color)

    def draw_band(self, axes: Axes, lower: Floats, upper: Floats, *, color: Any) -> None:
        """Draw intervals: a band around a curve, or a vertical line at each point."""
        if self._texts:
            axes.vlines(self.positions, lower, upper, color=color, alpha=0.6)
        else:
            axes.fill_between(self.positions, lower, upper, color=color, alpha=0.2, linewidth=0.0)

    def finish(self, axes: Axes) -> None:
        """Write the name and the numbers or texts below the axis; rotate texts that would overlap."""
        axes.set_xlabel(self._scale.text(self._name))
        if not self._texts:
            choose_scale(axes, "x", self.positions)
            return
        axes.set_xlim(-0.5, self.positions.size - 0.5)
        longest = max(len(line) for text in self._texts for line in text.split("\n"))
        if longest * self.positions.size <= _MAX_CHARACTERS:
            axes.set_xticks(self.positions, self._texts)
            return
        if len(self._texts) > _MAX_SLANTED:
            texts = [text.replace("\n", ", ") for text in self._texts]
            axes.set_xticks(self.positions, texts, fontsize="small", rotation=90)
        else:
            axes.set_xticks(
                self.positions, self._texts, fontsize="small", rotation=30, rotation_mode="anchor", ha="right"
            )


class Colors:
    """Colors of the curves for the values of one dimension."""

    def __init__(self, coordinate: xarray.DataArray) -> None:
        self._name = quantity_name(coordinate)
        self._texts = [text.replace("\n", ", ") for text in _texts_of(coordinate)]
        self.has_bar = not self._texts and coordinate.size > _MAX_IN_LEGEND
        if len(self._texts) > _MAX_TEXTS:
            message = f"study must have at most {_MAX_TEXTS} values of {coordinate.name}, got {coordinate.size}"
            raise ValueError(f"{message}; select some of them")
        self._colors: list[Any] = [f"C{i}" for i in range(len(self._texts))]
        if not self._texts:
            self._scale = scale_of(coordinate)
            numbers = coordinate.to_numpy() / self._scale.factor
            self._norm = (LogNorm if _spans_decades(numbers) else Normalize)(numbers.min(), numbers.max())
            self._colors = list(_COLORMAP(self._norm(numbers)))
            self._texts = [f"{_symbol(self._name)} = {number:.4g} {self._scale.unit}".rstrip() for number in numbers]

    def __getitem__(self, i: int) -> Any:
        """Return the color of a value."""
        return self._colors[i]

    def draw_bar(self, axes: Axes) -> None:
        """Draw the color bar."""
        figure = axes.figure
        figure.colorbar(ScalarMappable(self._norm, _COLORMAP), ax=axes, label=self._scale.text(self._name))

    def handles(self, drawn: set[int]) -> list[Line2D]:
        """Return legend entries for the values that have a curve."""
        return [Line2D([], [], color=self[i], marker=".", label=self._texts[i]) for i in sorted(drawn)]


def choose_scale(axes: Axes, axis: str, numbers: Floats) -> None:
    """Make an axis logarithmic if its numbers span decades, with a linear part near 0 if 0 is one of them."""
    finite = np.unique(numbers[np.isfinite(numbers)])
    if _spans_decades(finite):
        axes.set(**{f"{axis}scale": "log"})
        axis_object: Axis = getattr(axes, f"{axis}axis")
        if finite[-1] < _FEW_DECADES * finite[0]:
            axis_object.set_minor_locator(LogLocator(subs=(2.0, 5.0)))
            axis_object.set_minor_formatter(StrMethodFormatter("{x:g}"))
            axis_object.set_major_formatter(StrMethodFormatter("{x:g}"))
    elif finite.size > 2 and finite[0] == 0.0 and _spans_decades(finite[1:]):
        (axes.set_xscale if axis == "x" else axes.set_yscale)("symlog", linthresh=float(finite[1]))
        axes.set(**{f"{axis}lim": (0.0, None)})


def _spans_decades(numbers: Floats) -> bool:
    """Whether numbers are positive, and either geometrically spaced or spread over a large ratio."""
    if numbers.size < 2 or not numbers.min() > 0.0:
        return False
    steps = np.diff(np.log(numbers))
    is_geometric = numbers.size > 2 and bool(np.allclose(steps, steps[0], rtol=1e-6))
    return is_geometric or bool(numbers.max() > _MIN_LOGARITHMIC_RATIO * numbers.min())


def _texts_of(coordinate: xarray.DataArray) -> list[str]:
    """Return the texts of a coordinate, with one line for each quantity; an empty list for numbers."""
    if coordinate.dtype.kind in "fiu":
        return []
    return ["\n".join(map(_with_unit, str(text).split(", "))) for text in coordinate.to_numpy().tolist()]


def _with_unit(text: str) -> str:
    """Return "name=value" with spaces and the unit, and any other text unchanged."""
    name, separator, value = text.partition("=")
    unit = UNITS.get(name, "1")
    return f"{name.replace('_', ' ')} = {value}{'' if unit == '1' else f' {unit}'}" if separator else text


def value_text(coordinate: xarray.DataArray) -> str:
    """Return name and value of a coordinate with a single value."""
    if coordinate.dtype.kind not in "fiu":
        return f"{quantity_name(coordinate)}: {_texts_of(coordinate.expand_dims('one'))[0]}".replace("\n", ", ")
    scale = scale_of(coordinate)
    return f"{_symbol(quantity_name(coordinate))} = {coordinate.item() / scale.factor:.4g} {scale.unit}".rstrip()


def quantity_name(values: xarray.DataArray) -> str:
    """Return the name of a quantity in words, with its symbol."""
    name = str(values.attrs.get("long_name", values.name)).replace("_", " ") if values.name in _SYMBOLS else ""
    if name:
        return f"{name} ${_SYMBOLS[str(values.name)]}$"
    return re.sub(r"\b([A-Za-z]_\w)\b", r"$\1$", str(values.attrs.get("long_name", values.name)))


def _symbol(name: str) -> str:
    """Return the symbol at the end of a name, or the name if it has none."""
    return name.rsplit(" ", 1)[-1] if name.endswith("$") else name
