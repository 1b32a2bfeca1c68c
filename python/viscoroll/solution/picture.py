"""Pictures of a solution, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.extras import extra
from .._support.pictures import Picture, draw_picture
from .._support.quantities import quantity_text
from .._support.scales import Scale
from .scalars import label_of
from .solution import Solution
from .text import scalar_text

with extra("plot"):
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

__all__ = ["plot_contact"]

#: Ratio of width to length of a map above which its axes are scaled independently.
_SLENDER = 5.0


def plot_contact(result: Solution, ax: Axes | None = None) -> Picture | Axes:
    """Draw the contact pressure: its map, and its profile along the rolling direction.

    With friction, also draw the map of stick and slip with arrows for the traction, and its profile with that of the
    pressure. For a roller, whose contact is a strip, draw only the profile.

    Parameters
    ----------
    result : Result
        Solution of a contact.
    ax : matplotlib.axes.Axes, optional
        Axes for the map of the pressure only, or for the profile of a roller.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        Two axes side by side, three with friction, one for a roller, in a figure without a window; or `ax`.
    """
    of_roller, frictional = result.semi_axis_z is None, result.friction > 0.0
    draw = _draw_profile if of_roller else _draw_map

    def compose(picture: Picture) -> None:
        picture.suptitle(_headline(result), fontsize="medium")
        if of_roller:
            _draw_profile(picture.subplots(), result)
            return
        pressure_map, *stick_slip_map, profile = picture.subplots(
            1, 3 if frictional else 2, width_ratios=[1.0, 0.85, 1.15] if frictional else [1.0, 1.15]
        )
        _draw_map(pressure_map, result)
        for axes in stick_slip_map:
            _draw_stick_and_slip(axes, result)
        _draw_profile(profile, result)

    width = 7.0 if of_roller else 16.0 if frictional else 11.0
    return draw_picture(lambda axes: draw(axes, result), ax, figsize=(width, 4.6), compose=compose)


def _headline(result: Solution) -> str:
    """Return the input on one line and the main results on the next one, for a roller on the next two."""
    given = [f"$P$ = {scalar_text(result, 'load')}", f"$Ω$ = {result.angular_speed:g} rad/s"]
    names = ["rolling_resistance_force", "rolling_resistance_torque"]
    if result.friction > 0.0:
        given.append(f"$μ$ = {result.friction:g}")
        names = ["driving_torque", "driving_force", "creepage"]
    names += ["rolling_resistance_coefficient", *(["penetration"] if result.penetration is not None else [])]
    if result.prescribed == "penetration":
        given.append(f"penetration {scalar_text(result, names.pop())}")
    found = [f"{label_of(name, result.body)} {scalar_text(result, name)}" for name in names]
    half = 2 if result.semi_axis_z is None else len(found)  # the picture of a roller is narrow
    return "\n".join(",   ".join(part) for part in (given, found[:half], found[half:]) if part)


def _lengths(result: Solution) -> Scale:
    """Return the scale of lengths in the contact."""
    return Scale.of([result.x[result.contact], result.z[result.contact]], "m")


def _pressures(result: Solution) -> Scale:
    return Scale.of(result.max_pressure, "Pa")


def _offset(result: Solution) -> float:
    """Return the distance of the normal resultant from the lowest point [m], positive forward."""
    return result.resisting_torque / result.load


def _limits(result: Solution) -> tuple[float, float]:
    """Return half of the drawn range along x and z [m]: the contact with a margin; across a wheel, its width."""
    along, across = (float(np.abs(part[result.contact]).max()) for part in (result.x, result.z))
    margin, ends = 2.0 * _spacing(result), float(max(result.x.max(), result.z.max()))
    if result.body.width is not None:
        return min(1.35 * along + margin, float(result.x.max())), 0.54 * result.body.width
    limit = min(1.35 * max(along, across) + margin, ends)
    return limit, limit


def _frame(axes: Axes, result: Solution) -> None:
    """Set the range of a map, and draw the faces of a wheel."""
    length = _lengths(result)
    along, across = (limit / length.factor for limit in _limits(result))
    axes.set(xlim=(-along, along), ylim=(-across, across), xlabel=_along(length), ylabel=length.text("z"))
    # At equal scales, the contact of a wide wheel would be a thin line.
    axes.set_aspect("equal" if across < _SLENDER * along else "auto")
    if result.body.width is not None:
        for side in (-0.5, 0.5):
            axes.axhline(side * result.body.width / length.factor, color="0.3", linewidth=1.5)


def _along(length: Scale) -> str:
    return f"{length.text('x')}, rolling to the right"


def _spacing(result: Solution) -> float:
    return result.body.outer_radius * result.mesh.spacing


def _draw_map(axes: Axes, result: Solution) -> None:
    # In the picture, x increases from left to right; in the fields it decreases from row to row.
    length, stress = _lengths(result), _pressures(result)
    x, z = result.x.T / length.factor, result.z.T / length.factor
    contact = result.contact.T
    pressure = np.ma.masked_where(~contact, result.pressure.T / stress.factor)
    image = axes.pcolormesh(x, z, pressure, shading="nearest", cmap="magma_r", vmin=0.0, rasterized=True)
    axes.contour(x, z, contact.astype(float), levels=[0.5], colors="k", linewidths=1.0)
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle=":")
    offset = _offset(result)
    label = f"resultant at x = {quantity_text(offset, 'm')}"
    axes.plot(offset / length.factor, 0.0, "o", color="tab:cyan", markeredgecolor="w", label=label)
    _frame(axes, result)
    axes.legend(loc="upper left", fontsize="small")
    axes.figure.colorbar(image, ax=axes, label=stress.text("contact pressure"))


def _draw_stick_and_slip(axes: Axes, result: Solution) -> None:
    length, stress = _lengths(result), _pressures(result)
    x, z = result.x.T / length.factor, result.z.T / length.factor
    state = np.ma.masked_where(~result.contact.T, result.slip.T.astype(float))
    colors = ListedColormap(["tab:green", "tab:orange"])
    axes.pcolormesh(x, z, state, shading="nearest", cmap=colors, vmin=0.0, vmax=1.0, alpha=0.45, rasterized=True)
    rows, columns = _arrow_nodes(result)
    traction_x, traction_z = (part[rows, columns] / stress.factor for part in result.shear_traction)
    where = (x.T[rows, columns], z.T[rows, columns])
    axes.quiver(*where, traction_x, traction_z, angles="xy", pivot="middle", width=0.004)
    _frame(axes, result)
    handles = [Patch(color=colors(i), alpha=0.45, label=name) for i, name in enumerate(("stick", "slip"))]
    axes.legend(
        handles=handles, loc="upper left", fontsize="small", title="traction on the body", title_fontsize="small"
    )


def _arrow_nodes(result: Solution) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the nodes in contact at which an arrow is drawn: about twenty across."""
    stride = max(1, round(np.sqrt(result.contact.sum()) / 18.0))
    half = np.array(result.contact.shape) // 2
    rows, columns = np.nonzero(result.contact)
    kept = ((rows - half[0]) % stride == 0) & ((columns - half[1]) % stride == 0)
    return rows[kept], columns[kept]


def _draw_profile(axes: Axes, result: Solution) -> None:
    middle, length, stress = result.x.shape[1] // 2, _lengths(result), _pressures(result)
    x = result.x[:, middle] / length.factor
    pressure = result.pressure[:, middle] / stress.factor
    axes.fill_between(x, pressure, color="tab:red", alpha=0.15)
    axes.plot(x, pressure, ".-", color="tab:red", label="pressure")
    axes.axvline(_offset(result) / length.factor, color="tab:cyan", label="resultant")
    if result.friction > 0.0:
        traction = result.shear_traction[0][:, middle] / stress.factor
        axes.plot(x, traction, ".-", color="tab:green", label="traction along x")
        if np.isfinite(result.friction):
            bound = result.friction * pressure
            axes.fill_between(x, -bound, bound, color="0.5", alpha=0.15, label="bound ±$μp$")
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle=":")
    limit = _limits(result)[0] / length.factor
    axes.set(xlim=(-limit, limit), xlabel=_along(length))
    axes.set(ylabel=stress.text("tractions in the middle plane"))
    axes.set_ylim(min(0.0, 1.15 * result.shear_traction[0][:, middle].min() / stress.factor), 1.15 * pressure.max())
    axes.legend(loc="upper left", fontsize="small")

    gap = axes.twinx()
    shown = np.abs(x) <= limit
    height = np.maximum(result.gap[:, middle], 0.0)
    depth = Scale.of(height[shown], "m")
    height = height / depth.factor
    gap.plot(x, height, color="tab:blue", linewidth=1.0)
    bottom, top = axes.get_ylim()
    gap.set_ylim(bottom / top * 1.15 * height[shown].max(), 1.15 * height[shown].max())
    gap.set_ylabel(depth.text("gap"), color="tab:blue")
