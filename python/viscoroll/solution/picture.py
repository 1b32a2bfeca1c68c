"""Pictures of a solution, with matplotlib (the extra `viscoroll[plot]`)."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._support.extras import extra
from .._support.pictures import Picture, draw_picture
from .solution import Solution

with extra("plot"):
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

__all__ = ["plot_contact"]

_MM = 1e3
_MPA = 1e-6

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
    """Return the input on one line and the main results on the next."""
    milli = f"m{result.unit('resisting_torque')}"
    given = [f"$P$ = {result.load:g} {result.unit('load')}", f"$Ω$ = {result.angular_speed:g} rad/s"]
    found = [f"power dissipated / $PV$ = {result.rolling_resistance_coefficient:.4g}"]
    if result.friction == 0.0:
        found.append(f"$T_r$ = {result.resisting_torque * 1e3:.4g} {milli}")
    else:
        given.append(f"$μ$ = {result.friction:g}")
        found += [
            f"$T$ = {result.driving_torque * 1e3:.4g} {milli}",
            f"$Q$ = {result.driving_force:.4g} {result.unit('driving_force')}",
            f"creepage {result.creepage:.4g}",
        ]
    if result.penetration is not None:
        found.append(f"penetration {result.penetration * _MM:.3g} mm")
    return ",   ".join(given) + "\n" + ",   ".join(found)


def _offset(result: Solution) -> float:
    """Return the distance of the normal resultant from the lowest point [m], positive forward."""
    return result.resisting_torque / result.load


def _limits(result: Solution) -> tuple[float, float]:
    """Return half of the drawn range along x and z [mm]: the contact with a margin; across a wheel, its width."""
    along, across = (float(np.abs(part[result.contact]).max()) for part in (result.x, result.z))
    margin, ends = 2.0 * _spacing(result), float(result.x.max())
    if result.body.width is not None:
        return min(1.35 * along + margin, ends) * _MM, 0.54 * result.body.width * _MM
    limit = min(1.35 * max(along, across) + margin, ends) * _MM
    return limit, limit


def _frame(axes: Axes, result: Solution) -> None:
    """Set the range of a map, and draw the faces of a wheel."""
    along, across = _limits(result)
    axes.set(xlim=(-along, along), ylim=(-across, across), xlabel="x [mm], rolling to the right", ylabel="z [mm]")
    # At equal scales, the contact of a wide wheel would be a thin line.
    axes.set_aspect("equal" if across < _SLENDER * along else "auto")
    if result.body.width is not None:
        for side in (-0.5, 0.5):
            axes.axhline(side * result.body.width * _MM, color="0.3", linewidth=1.5)


def _spacing(result: Solution) -> float:
    return result.body.outer_radius * result.mesh.spacing


def _draw_map(axes: Axes, result: Solution) -> None:
    # In the picture, x increases from left to right; in the fields it decreases from row to row.
    x, z = result.x.T * _MM, result.z.T * _MM
    contact = result.contact.T
    pressure = np.ma.masked_where(~contact, result.pressure.T * _MPA)
    image = axes.pcolormesh(x, z, pressure, shading="nearest", cmap="magma_r", vmin=0.0, rasterized=True)
    axes.contour(x, z, contact.astype(float), levels=[0.5], colors="k", linewidths=1.0)
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle=":")
    offset = _offset(result) * _MM
    axes.plot(offset, 0.0, "o", color="tab:cyan", markeredgecolor="w", label=f"resultant at x = {offset:.3g} mm")
    _frame(axes, result)
    axes.legend(loc="upper left", fontsize="small")
    axes.figure.colorbar(image, ax=axes, label="contact pressure [MPa]")


def _draw_stick_and_slip(axes: Axes, result: Solution) -> None:
    x, z = result.x.T * _MM, result.z.T * _MM
    state = np.ma.masked_where(~result.contact.T, result.slip.T.astype(float))
    colors = ListedColormap(["tab:green", "tab:orange"])
    axes.pcolormesh(x, z, state, shading="nearest", cmap=colors, vmin=0.0, vmax=1.0, alpha=0.45, rasterized=True)
    rows, columns = _arrow_nodes(result)
    traction_x, traction_z = (part[rows, columns] * _MPA for part in result.shear_traction)
    where = (result.x[rows, columns] * _MM, result.z[rows, columns] * _MM)
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
    middle = result.x.shape[1] // 2
    x = result.x[:, middle] * _MM
    pressure = result.pressure[:, middle] * _MPA
    axes.fill_between(x, pressure, color="tab:red", alpha=0.15)
    axes.plot(x, pressure, ".-", color="tab:red", label="pressure")
    axes.axvline(_offset(result) * _MM, color="tab:cyan", label="resultant")
    if result.friction > 0.0:
        traction = result.shear_traction[0][:, middle] * _MPA
        axes.plot(x, traction, ".-", color="tab:green", label="traction along x")
        if np.isfinite(result.friction):
            bound = result.friction * pressure
            axes.fill_between(x, -bound, bound, color="0.5", alpha=0.15, label="bound ±$μp$")
    axes.axvline(0.0, color="0.5", linewidth=0.8, linestyle=":")
    limit, _ = _limits(result)
    axes.set(xlim=(-limit, limit), xlabel="x [mm], rolling to the right")
    axes.set(ylabel="tractions in the middle plane [MPa]")
    axes.set_ylim(min(0.0, 1.15 * result.shear_traction[0][:, middle].min() * _MPA), 1.15 * pressure.max())
    axes.legend(loc="upper left", fontsize="small")

    gap = axes.twinx()
    shown = np.abs(x) <= limit
    height = np.maximum(result.gap[:, middle], 0.0) * _MM
    gap.plot(x, height, color="tab:blue", linewidth=1.0)
    bottom, top = axes.get_ylim()
    gap.set_ylim(bottom / top * 1.15 * height[shown].max(), 1.15 * height[shown].max())
    gap.set_ylabel("gap [mm]", color="tab:blue")
