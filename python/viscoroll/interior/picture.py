"""Pictures of the inside: the section through the contact, loss density and temperature."""

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

    Layers are unrolled, forward to the right, and stretched in depth to be seen; those of the counterpart, too, lie
    below their surface.

    Parameters
    ----------
    result : Result
        A solution, not with curvature EXACT.
    of : "ball" or "counterpart", optional
        What rolls, or what it rolls on; by default the one that deforms, of two what rolls.

    Returns
    -------
    matplotlib.figure.Figure
        Of no window.
    """
    body = inside_of(result, of)
    spacing = result.ball.outer_radius * result.mesh.spacing
    # The surface itself is left to the pressure above: there the patches show.
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
    """Draw the energy lost per volume and passage over the cross-section of the track, under a line over the depth.

    Parameters
    ----------
    result : Result
        A solution, not with curvature EXACT.
    of : "ball" or "counterpart", optional
        What rolls, or what it rolls on; by default the one that deforms, of two what rolls.
    ax : matplotlib.axes.Axes, optional
        Where to draw; in a figure of its own without.

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
    label = "energy lost per passage [kJ/m³]"
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
    axes.set_title(f"{inside.bulk_power:.3g} {result.unit('bulk_power')} are lost in the layers", fontsize="medium")


@overload
def plot_temperature(temperature: Temperature) -> Figure: ...


@overload
def plot_temperature(temperature: Temperature, *, ax: Axes) -> Axes: ...


def plot_temperature(temperature: Temperature, *, ax: Axes | None = None) -> Figure | Axes:
    """Draw the temperature rise over the cross-section of the coating.

    Parameters
    ----------
    temperature : Temperature
        What `temperature` found.
    ax : matplotlib.axes.Axes, optional
        Where to draw; in a figure of its own without.

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
        axes.set_title(f"at most {temperature.maximum:.3g} K over {temperature.ambient:g} K", fontsize="medium")
        return
    place, along = np.meshgrid(rise[normal], rise[across], indexing="ij")
    if across == "theta":
        place, along = place * np.sin(along), place * np.cos(along)
    image = axes.contourf(along * _MM, place * _MM, rise.to_numpy(), levels=24, cmap="inferno")
    axes.set(xlabel="along the axis [mm]", ylabel=below)
    if normal == "radius":
        axes.set(aspect="equal")
    axes.set_title(f"at most {temperature.maximum:.3g} K over {temperature.ambient:g} K", fontsize="medium")
    axes.figure.colorbar(image, ax=axes, label="temperature rise [K]")


def plot_folds(hot: SelfHeating, *, points: int = 10) -> Picture:
    """Draw the mean temperatures of steady states over the load and over the speed, with the states of a case.

    Where a curve turns back, the cold state ends.

    Parameters
    ----------
    hot : SelfHeating
        What `self_heating` found.
    points : int, default 10
        Of each curve; at every one contacts are solved.

    Returns
    -------
    matplotlib.figure.Figure
        Of no window.
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
            except (ValueError, ConvergenceError):  # beyond what the layers bear, or what any speed makes
                break
        axes.plot([value for value, _ in curve], [mean for _, mean in curve], color="tab:red")
        for state in hot.states:
            axes.plot(here, state.mean_temperature, "o", color="k", markerfacecolor="k" if state.stable else "none")
        axes.set(xlabel=f"{name} [{unit}]", xlim=(0.0, 2.5 * here))
    figure.axes[0].set(ylabel="mean temperature [K]")
    return figure


def _draw_layers(axes: Axes, inside: Inside) -> None:
    """Outline of the layers."""
    depths = inside.depth(boundaries_of(inside.body))
    for depth in depths[np.isfinite(depths)]:
        axes.axhline(depth * _MM, color="k", linewidth=2.0 if depth == depths[0] else 1.0)
