"""Pictures of the inside: the section through the contact, loss density and temperature."""

from __future__ import annotations

from typing import TYPE_CHECKING, overload

import numpy as np

from .._support.cautions import kept_in_results
from .._support.pictures import Picture, drawn
from ..solution.interior_fields import coated_ball
from ..solution.solution import node_angles

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ..bodies import CoatedSphere
    from ..rolling import Result
    from .temperature import Temperature

__all__ = ["plot_loss", "plot_section", "plot_temperature"]

_MM = 1e3
_MPA = 1e-6
_DEPTHS = 41


def plot_section(result: Result) -> Picture:
    """Draw the section θ = π/2 through the contact: von Mises stress, and the pressure above it.

    The coating is unrolled, forward to the right, and stretched in depth to be seen.

    Parameters
    ----------
    result : Result
        A solution, not with curvature EXACT.

    Returns
    -------
    matplotlib.figure.Figure
        Of no window.
    """
    ball = coated_ball(result)
    spacing = ball.outer_radius * result.mesh.spacing
    # The surface itself is left to the pressure above: there the patches show.
    shallowest = min(0.25 * spacing, 0.1 * ball.thickness)
    deepest = min(ball.thickness, 4.0 * max(result.semi_axis_x, spacing))
    depths = np.linspace(shallowest, deepest, _DEPTHS)
    phi = node_angles(result)[0]
    with kept_in_results():
        inside = result.interior(depth=depths, phi=phi, theta=[0.5 * np.pi])
    inside = inside.isel(theta=0).drop_duplicates("depth")

    figure = Picture(figsize=(10.0, 6.0), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[1.0, 2.0])
    along = ball.outer_radius * (0.5 * np.pi - phi) * _MM
    middle = result.pressure.shape[1] // 2
    above.fill_between(along, result.pressure[:, middle] * _MPA, color="tab:red", alpha=0.3)
    above.plot(along, result.pressure[:, middle] * _MPA, color="tab:red")
    above.set(ylabel="pressure [MPa]")
    above.set_title(
        f"$P$ = {result.load:g} N,  $Ω$ = {result.angular_speed:g} rad/s,  {result.compliance.name} compliance",
        fontsize="medium",
    )
    image = below.contourf(along, inside.depth * _MM, inside.von_mises * _MPA, levels=24, cmap="viridis")
    _draw_layers(below, ball)
    below.set(xlabel="along the surface, rolling to the right [mm]", ylabel="depth [mm]")
    below.set_ylim(deepest * _MM, 0.0)
    figure.colorbar(image, ax=below, label="von Mises stress [MPa]")
    return figure


@overload
def plot_loss(result: Result) -> Figure: ...


@overload
def plot_loss(result: Result, *, ax: Axes) -> Axes: ...


def plot_loss(result: Result, *, ax: Axes | None = None) -> Figure | Axes:
    """Draw the mean power density over the cross-section of the track.

    Parameters
    ----------
    result : Result
        A solution, not with curvature EXACT.
    ax : matplotlib.axes.Axes, optional
        Where to draw; in a figure of its own without.

    Returns
    -------
    matplotlib.figure.Figure or matplotlib.axes.Axes
        A new figure, or `ax`.
    """
    ball = coated_ball(result)
    loss = result.loss(depth=np.linspace(0.0, ball.thickness, _DEPTHS)).drop_duplicates("radius")
    return drawn(lambda axes: _draw_loss(axes, result, ball, loss), ax, figsize=(10.0, 4.0))


def _draw_loss(axes: Axes, result: Result, ball: CoatedSphere, loss: xarray.Dataset) -> None:
    across = ball.outer_radius * (loss.theta - 0.5 * np.pi) * _MM
    image = axes.contourf(across, loss.depth * _MM, loss.power_density * 1e-3, levels=24, cmap="inferno")
    _draw_layers(axes, ball)
    reach = (2.0 * (result.semi_axis_z or 0.0) + 2.0 * ball.thickness) * _MM
    axes.set(xlim=(-reach, reach), xlabel="across the track [mm]", ylabel="depth [mm]")
    axes.set_ylim(ball.thickness * _MM, 0.0)
    axes.set_title(f"{result.rolling_bulk_power:.3g} W are lost in the coating", fontsize="medium")
    axes.figure.colorbar(image, ax=axes, label="mean power density [kW/m³]")


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
    rise = temperature.rise.drop_duplicates("radius")
    radius, theta = np.meshgrid(rise.radius, rise.theta, indexing="ij")
    image = axes.contourf(
        radius * np.cos(theta) * _MM, radius * np.sin(theta) * _MM, rise.to_numpy(), levels=24, cmap="inferno"
    )
    axes.set(aspect="equal", xlabel="along the axis [mm]", ylabel="from the axis [mm]")
    axes.set_title(f"at most {temperature.maximum:.3g} K over {temperature.ambient:g} K", fontsize="medium")
    axes.figure.colorbar(image, ax=axes, label="temperature rise [K]")


def _draw_layers(axes: Axes, ball: CoatedSphere) -> None:
    """Outline of the layers."""
    depth = 0.0
    for layer in reversed(ball.layers):
        axes.axhline(depth * _MM, color="k", linewidth=1.0)
        depth += layer.thickness
    axes.axhline(depth * _MM, color="k", linewidth=2.0)
