"""Pictures of the interior: section through the contact, loss density, temperature, and folds of self-heating."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

import numpy as np

from .._core import ConvergenceError
from .._support.cautions import kept_in_results
from .._support.pictures import Picture, drawn
from ..solution.inside import Inside, Of, boundaries_of, inside_of
from ..solution.loss import contact_size

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..rolling import Result
    from .self_heating import SelfHeating
    from .temperature import Temperature

__all__ = ["plot_folds", "plot_loss", "plot_section", "plot_temperature"]

_MM = 1e3
_MPA = 1e-6
_DEPTHS = 41


def plot_section(result: Result, *, of: Of | None = None) -> Picture:
    """Draw the section θ = π/2 through the contact: von Mises stress, and the pressure above it.

    The layers are unrolled, with forward to the right, and stretched in depth. Those of the counterbody are also drawn
    below their surface.

    Parameters
    ----------
    result : Result
        Solution of a contact; curvature EXACT is not allowed.
    of : "ball" or "counterpart", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.

    Returns
    -------
    matplotlib.figure.Figure
        New figure without a window.
    """
    body = inside_of(result, of)
    spacing = result.ball.outer_radius * result.mesh.spacing
    # The section begins below the surface, at which the steps of the pressure from patch to patch would show.
    shallowest = min(0.25 * spacing, 0.1 * body.thickness)
    deepest = min(body.thickness, 4.0 * max(result.semi_axis_x, spacing))
    depths = np.linspace(shallowest, deepest, _DEPTHS)
    phi = body.node_angles()[0]
    with kept_in_results():
        inside = result.interior(depth=depths, phi=phi, theta=[0.5 * np.pi], of=body.of)
    inside = inside.isel(theta=0).drop_duplicates("depth")

    figure = Picture(figsize=(10.0, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[1.0, 2.0])
    along = inside.x * _MM
    middle = result.pressure.shape[1] // 2
    above.fill_between(along, result.pressure[:, middle] * _MPA, color="tab:red", alpha=0.3)
    above.plot(along, result.pressure[:, middle] * _MPA, color="tab:red")
    above.set(ylabel="pressure [MPa]")
    above.set_title(
        f"$P$ = {result.load:g} {result.unit('load')},  $Ω$ = {result.angular_speed:g} rad/s,  "
        f"{result.compliance.name} compliance",
        fontsize="medium",
    )
    image = below.contourf(along, inside.depth * _MM, inside.von_mises * _MPA, levels=24, cmap="viridis")
    _draw_layers(below, body)
    below.set(xlabel="along the surface, rolling to the right [mm]", ylabel="depth [mm]")
    below.set_ylim(deepest * _MM, 0.0)
    figure.colorbar(image, ax=below, label="von Mises stress [MPa]")
    return figure


@overload
def plot_loss(result: Result, *, of: Of | None = None) -> Figure: ...


@overload
def plot_loss(result: Result, *, ax: Axes, of: Of | None = None) -> Axes: ...


def plot_loss(result: Result, *, ax: Axes | None = None, of: Of | None = None) -> Figure | Axes:
    """Draw the energy dissipated per volume and passage over the cross-section, or over the depth in line contact.

    Parameters
    ----------
    result : Result
        Solution of a contact; curvature EXACT is not allowed.
    of : "ball" or "counterpart", optional
        Rolling body or counterbody. By default the deformable body; if both deform, the rolling body.
    ax : matplotlib.axes.Axes, optional
        Axes to draw into; by default those of a new figure.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        A new figure, or `ax`.
    """
    inside = inside_of(result, of)
    reach = min(inside.thickness, 6.0 * contact_size(result))
    loss = result.loss(depth=np.linspace(0.0, reach, _DEPTHS), of=inside.of).drop_duplicates("depth")
    return drawn(lambda axes: _draw_loss(axes, inside, loss), ax, figsize=(10.0, 4.0))


def _draw_loss(axes: Axes, inside: Inside, loss: xarray.Dataset) -> None:
    result = inside.result
    deepest = float(loss.depth.max())
    label = "energy dissipated per passage [kJ/m³]"
    if inside.line_contact:
        axes.plot(loss.loss_density.isel(theta=0) * 1e-3, loss.depth * _MM, color="tab:red")
        axes.set(xlabel=label)
    else:
        image = axes.contourf(loss.z * _MM, loss.depth * _MM, loss.loss_density * 1e-3, levels=24, cmap="inferno")
        reach = (2.0 * (result.semi_axis_z or 0.0) + 2.0 * deepest) * _MM
        axes.set(xlim=(-reach, reach), xlabel="across the track [mm]")
        axes.figure.colorbar(image, ax=axes, label=label)
    _draw_layers(axes, inside)
    axes.set(ylabel="depth [mm]")
    axes.set_ylim(deepest * _MM, 0.0)
    axes.set_title(f"{inside.bulk_power:.3g} {result.unit('bulk_power')} dissipated in the layers", fontsize="medium")


@overload
def plot_temperature(temperature: Temperature) -> Figure: ...


@overload
def plot_temperature(temperature: Temperature, *, ax: Axes) -> Axes: ...


def plot_temperature(temperature: Temperature, *, ax: Axes | None = None) -> Figure | Axes:
    """Draw the temperature rise over the cross-section of the coating.

    Parameters
    ----------
    temperature : Temperature
        Result of `temperature`.
    ax : matplotlib.axes.Axes, optional
        Axes to draw into; by default those of a new figure.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        A new figure, or `ax`.
    """
    return drawn(lambda axes: _draw_temperature(axes, temperature), ax, figsize=(7.0, 6.0))


def _draw_temperature(axes: Axes, temperature: Temperature) -> None:
    normal, across = temperature.rise.dims
    rise = temperature.rise.drop_duplicates(normal)
    below = "from the axis [mm]" if normal == "radius" else "depth [mm]"
    if normal == "depth":
        axes.invert_yaxis()
    if rise.sizes[across] == 1:
        axes.plot(rise[:, 0], rise[normal] * _MM, color="tab:red")
        axes.set(xlabel="temperature rise [K]", ylabel=below)
        axes.set_title(f"largest rise {temperature.maximum:.3g} K above {temperature.ambient:g} K", fontsize="medium")
        return
    place, along = np.meshgrid(rise[normal], rise[across], indexing="ij")
    if across == "theta":
        place, along = place * np.sin(along), place * np.cos(along)
    image = axes.contourf(along * _MM, place * _MM, rise.to_numpy(), levels=24, cmap="inferno")
    axes.set(xlabel="along the axis [mm]", ylabel=below)
    if normal == "radius":
        axes.set(aspect="equal")
    axes.set_title(f"largest rise {temperature.maximum:.3g} K above {temperature.ambient:g} K", fontsize="medium")
    axes.figure.colorbar(image, ax=axes, label="temperature rise [K]")


def plot_folds(hot: SelfHeating, *, points: int = 10) -> Picture:
    """Draw the mean temperatures of the steady states over load and over speed, with the states of the given case.

    The cold state ends at the first maximum of load or speed.

    Parameters
    ----------
    hot : SelfHeating
        Result of `self_heating`.
    points : int, default 10
        Number of points of each curve; each point takes several contact solutions.

    Returns
    -------
    matplotlib.figure.Figure
        New figure without a window.
    """
    first = hot.states[0].temperature.ambient
    result = hot.states[0].result
    rises = (hot.limit - first) * np.geomspace(0.02, 0.98, points)
    figure = Picture(figsize=(10.0, 4.0), layout="constrained")
    panels = (
        ("load", result.load, result.unit("load"), hot.loads),
        ("angular speed", result.angular_speed, "rad/s", hot.speeds),
    )
    for axes, (name, here, unit, found_at) in zip(figure.subplots(1, 2, sharey=True), panels, strict=True):
        curve = []
        for rise in rises.tolist():
            try:
                curve.append((float(found_at([first + rise])[0]), first + rise))
            except (ValueError, ConvergenceError):  # more than the layers support, or no speed gives this temperature
                break
        axes.plot([value for value, _ in curve], [mean for _, mean in curve], color="tab:red")
        for state in hot.states:
            axes.plot(here, state.mean_temperature, "o", color="k", markerfacecolor="k" if state.stable else "none")
        axes.set(xlabel=f"{name} [{unit}]", xlim=(0.0, 2.5 * here))
    figure.axes[0].set(ylabel="mean temperature [K]")
    return figure


def _draw_layers(axes: Axes, inside: Inside) -> None:
    """Draw the boundaries of the layers."""
    depths = inside.depth(boundaries_of(inside.body))
    for depth in depths[np.isfinite(depths)]:
        axes.axhline(depth * _MM, color="k", linewidth=2.0 if depth == depths[0] else 1.0)
